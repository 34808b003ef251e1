/* Mesh files through assimp, in this process. assimp crashes on damaged files, or never ends, or
 * takes all memory: glint_mesh_load() (mesh.h) is the call for files from elsewhere. */
#ifndef GLINT_SIM_RENDER_IMPORT_H
#define GLINT_SIM_RENDER_IMPORT_H

#include "render/mesh.h"

/* As glint_mesh_load(), for a regular file that can be read. */
glint_status glint_mesh_import(const char *path, glint_mesh **mesh, glint_error *err);

#endif
