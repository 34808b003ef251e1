/* Whether what is at a path may be written over. */
#ifndef GLINT_SIM_FILE_KIND_H
#define GLINT_SIM_FILE_KIND_H

#include "glint_status.h"

/* GLINT_OK when nothing of value would be lost: nothing is there, an empty file, something that is
 * no file (a device, a pipe), or a file that begins as those with the ending of its name do: .png,
 * .fst, .vcd, .gtkw, .csv (a table of Glint's), .json, .md, .html, .svg, .dot. GLINT_BAD_ARGUMENT,
 * naming the path, for any other file, and for a name without such an ending. A file that cannot be
 * read is left to whoever writes to it to refuse. */
glint_status glint_file_replaceable(const char *path, glint_error *err);

#endif
