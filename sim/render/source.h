/* The file that assimp reads, and the files it asks for beside that, as assimp gets to see them.
 *
 * The file itself is looked through first, by its format, and put into a plainer form where assimp
 * would misread it (plain.h, gltf.h). Beside it, only regular files can be opened: opening a pipe
 * or a device might wait for ever. */
#ifndef GLINT_SIM_RENDER_SOURCE_H
#define GLINT_SIM_RENDER_SOURCE_H

#include <assimp/cfileio.h>

#include "render/remarks.h"

typedef struct glint_source glint_source;

/* GLINT_BAD_INPUT where the content already tells that there is no mesh to be had, or not the whole
 * one. Otherwise what will be missing is in remarks. */
glint_status glint_source_open(const char *path, glint_source **source, glint_remarks *remarks,
                               glint_error *err);

/* For assimp: opens files for reading. */
struct aiFileIO *glint_source_io(glint_source *source);

/* The first file beside it that assimp asked for and that is there, but is no regular file; ""
 * when there was none. */
const char *glint_source_refused(const glint_source *source);

void glint_source_close(glint_source *source); /* NULL is allowed */

#endif
