/* Which files of a directory a circuit is made of: those that its top can reach. An edit of another
 * one builds nothing anew. */
#ifndef GLINT_SIM_RTL_NEEDED_H
#define GLINT_SIM_RTL_NEEDED_H

#include "rtl/sources.h"

/* Lets go of the files that none of the others, from the top's on, can reach: by a word that is
 * their name (of a module or of an included file) or that of a module in them. Verilator gets what
 * is left and nothing else, so that a file which were missed would be missing, never stale. All are
 * kept where words do not tell, because names are pasted together or escaped.
 * Files that Verilator has to be told are marked: libraries, and packages, those first that others
 * import.
 * The name of the top's file in *file. GLINT_IO_ERROR when there is none; GLINT_BAD_INPUT when a
 * library or a file with packages has a module or package that another file has, too. */
glint_status glint_sources_need(glint_sources *sources, const char *top, const char *directory,
                                const char **file, glint_error *err);

#endif
