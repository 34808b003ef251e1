/* A mesh written to a file, in the format that the file's name asks for.
 *
 * .3ds is written here: assimp's exporter loses the normals, writes no smoothing groups, and merges
 * no vertices. The other formats are assimp's. */
#ifndef GLINT_SIM_CONVERT_CONVERT_H
#define GLINT_SIM_CONVERT_CONVERT_H

#include "glint_status.h"
#include "render/mesh.h"

/* What was written. */
typedef struct glint_converted {
    const char *format;         /* ".3ds" */
    size_t vertices, triangles; /* of all objects */
    size_t objects;
    int groups;      /* smoothing groups in use, of .3ds */
    size_t unmarked; /* smooth edges that have become sharp because no group was left */
} glint_converted;

/* GLINT_BAD_ARGUMENT for a name with no ending that there is a format for; it lists those. */
glint_status glint_convert_check(const char *path, glint_error *err);

/* Writes the whole file or nothing (new_file.h). GLINT_INTERRUPTED soon after *stop becomes true;
 * stop may be NULL. */
glint_status glint_convert(const glint_mesh *mesh, const char *path, const volatile bool *stop,
                           glint_converted *converted, glint_error *err);

#endif
