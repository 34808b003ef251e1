/* glint_mesh_load() with explicit limits. */
#ifndef GLINT_SIM_RENDER_LOAD_H
#define GLINT_SIM_RENDER_LOAD_H

#include "render/mesh.h"

/* The resources that reading one file may use. */
typedef struct glint_load_limits {
    unsigned seconds; /* at least 1 */
    size_t bytes;     /* of address space, beyond this process's own */
} glint_load_limits;

/* 5 s and 2 s for each megabyte of the file; 1 GB and 256 times the file. Of assimp's own test
 * models the slowest takes 0.12 s a megabyte. */
glint_load_limits glint_load_limits_for(size_t file_bytes);

/* As glint_mesh_load(), within the limits given. */
glint_status glint_mesh_load_within(const char *path, const glint_load_limits *limits,
                                    const volatile bool *stop, glint_mesh **mesh, glint_error *err);

#endif
