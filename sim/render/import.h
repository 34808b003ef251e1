/* Mesh files through assimp, in this process. On damaged files assimp may crash, hang or exhaust
 * memory: use glint_mesh_load() (mesh.h) for untrusted files. */
#ifndef GLINT_SIM_RENDER_IMPORT_H
#define GLINT_SIM_RENDER_IMPORT_H

#include "render/mesh.h"

/* As glint_mesh_load(), for a regular file that can be read. */
glint_status glint_mesh_import(const char *path, glint_mesh **mesh, glint_error *err);

#endif
