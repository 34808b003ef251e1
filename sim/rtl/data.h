/* The files that a circuit's Verilog reads while it runs, as by $readmemh("rom.hex", …): part of
 * its sources and of their hash, and kept in its shared object. */
#ifndef GLINT_SIM_RTL_DATA_H
#define GLINT_SIM_RTL_DATA_H

#include <stdio.h>

#include "rtl/sources.h"

/* Adds the files that the sources name in a string and that are there, relative to the directory,
 * but those of a $fopen() that only writes.
 * Names that are put together are not found: the circuit opens such a file where the command runs.
 */
glint_status glint_data_read(glint_sources *sources, const char *directory, glint_error *err);

int glint_data_count(const glint_sources *sources);

/* Writes them into a directory, as glint_data_0, …; and the table of their names, GLINT_DATA of
 * shim.cpp, if there are any. */
glint_status glint_data_write(const glint_sources *sources, const char *directory,
                              glint_error *err);
void glint_data_print(const glint_sources *sources, FILE *out);

#endif
