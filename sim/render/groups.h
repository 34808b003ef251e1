/* The smoothing groups of .3ds and .ase files. assimp reads them, but treats a triangle in no group
 * as one in every group, and its normals depend on triangle order where groups overlap; so they are
 * read here separately. */
#ifndef GLINT_SIM_RENDER_GROUPS_H
#define GLINT_SIM_RENDER_GROUPS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "glint_status.h"

typedef struct glint_groups_object {
    size_t faces;
    uint32_t *group; /* of each face: bits, 0 where the file gives none */
} glint_groups_object;

typedef struct glint_groups {
    const char *format; /* in assimp's spelling: "3ds", "ase" */
    uint8_t *bytes;     /* the file plus a 0; keywords that assign materials to faces are disguised,
                         * because assimp would sort faces by them */
    size_t count;
    size_t objects;              /* those that have faces */
    glint_groups_object *object; /* in the file's order */
} glint_groups;

/* *file is NULL if the file at path does not start like one of these. */
glint_status glint_groups_read(const char *path, glint_groups **file, glint_error *err);

void glint_groups_destroy(glint_groups *file); /* NULL is allowed */

/* One more object without faces, at its end; NULL for want of memory. */
glint_groups_object *glint_groups_add_object(glint_groups *file);

/* More faces of no group for the object; false for want of memory. */
bool glint_groups_add_faces(glint_groups_object *object, size_t faces);

/* Of the two formats: the bytes begin as such a file does; its groups, false for want of memory. */
bool glint_groups_are_3ds(const glint_groups *file);
bool glint_groups_read_3ds(glint_groups *file);
bool glint_groups_are_ase(const glint_groups *file);
bool glint_groups_read_ase(glint_groups *file);

#endif
