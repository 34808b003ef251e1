/* The file that assimp reads, and any others it asks for, as assimp sees them.
 *
 * The main file is scanned first, by format, and converted to a plainer form where assimp would
 * misread it (plain.h, gltf.h). Of the others, only regular files can be opened: opening a pipe or
 * a device might block forever. */
#ifndef GLINT_SIM_RENDER_SOURCE_H
#define GLINT_SIM_RENDER_SOURCE_H

#include <assimp/cfileio.h>

#include "render/remarks.h"

typedef struct glint_source glint_source;

/* GLINT_BAD_INPUT if the content shows that no mesh, or only part of it, can be obtained. Otherwise
 * remarks list what will be missing. */
glint_status glint_source_open(const char *path, glint_source **source, glint_remarks *remarks,
                               glint_error *err);

/* For assimp: opens files for reading. */
struct aiFileIO *glint_source_io(glint_source *source);

/* The first other file that assimp asked for and that exists but is not a regular file; "" if
 * none. */
const char *glint_source_refused(const glint_source *source);

void glint_source_close(glint_source *source); /* NULL is allowed */

#endif
