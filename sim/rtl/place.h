/* Where a running glint finds the sources of circuits, and where it keeps the built ones.
 *
 * Built: the Makefile leaves a link `tree` to the source tree in the build directory, which lies
 * above the executable. Installed, <prefix>/bin/glint: <prefix>/share/glint. */
#ifndef GLINT_SIM_RTL_PLACE_H
#define GLINT_SIM_RTL_PLACE_H

#include "glint_status.h"

/* Glint's own Verilog: $GLINT_RTL, else rtl/ of the source tree or of share/glint. To be freed. */
glint_status glint_place_rtl(char **directory, glint_error *err);

/* shim.cpp and what is compiled with it; the headers that a user's circuit includes. To be
 * freed. */
glint_status glint_place_shim(char **directory, glint_error *err);
glint_status glint_place_headers(char **directory, glint_error *err);

/* Where circuits are kept: $GLINT_CACHE, else circuits/ of the build directory, else
 * $XDG_CACHE_HOME/glint, else ~/.cache/glint. Made if missing; absolute; to be freed. */
glint_status glint_place_cache(char **directory, glint_error *err);

#endif
