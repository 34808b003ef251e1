/* The smoothing groups of a .3ds file. assimp reads them, but takes a triangle of no group for one
 * of every group; here they are read beside it. */
#ifndef GLINT_SIM_GROUPS3DS_H
#define GLINT_SIM_GROUPS3DS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "glint_status.h"

typedef struct glint_groups3ds_object {
    size_t faces;
    uint32_t *group; /* of each face: bits, 0 where the file gives none */
} glint_groups3ds_object;

/* A file of 3ds chunks. */
typedef struct glint_groups3ds {
    uint8_t *bytes; /* of the file, with its lists of materials made unknown: assimp would sort the
                       faces by them */
    size_t count;
    size_t objects;                 /* those that have faces */
    glint_groups3ds_object *object; /* in the file's order */
} glint_groups3ds;

/* *file is NULL when the file at path does not begin as a .3ds file does. */
glint_status glint_groups3ds_read(const char *path, glint_groups3ds **file, glint_error *err);

void glint_groups3ds_destroy(glint_groups3ds *file); /* NULL is allowed */

#endif
