/* Whether an existing file may be overwritten. */
#ifndef GLINT_SIM_FILE_KIND_H
#define GLINT_SIM_FILE_KIND_H

#include "glint_status.h"

/* GLINT_OK if nothing of value would be lost: there is nothing, an empty file, something other than
 * a file (a device, a pipe), or a file that starts like those with its extension do: .png, .fst,
 * .vcd, .gtkw, .csv (a table of Glint's), .json, .md, .html, .svg, .dot, .3ds, .glb, .ply, .obj,
 * .stl (the last two as assimp writes them). GLINT_BAD_ARGUMENT, naming the path, for any other
 * file and for any other extension. An unreadable file is left for the writer to reject. */
glint_status glint_file_replaceable(const char *path, glint_error *err);

#endif
