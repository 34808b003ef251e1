/* Which vertices of a mesh lie at one place, and which corners of triangles meet there. */
#ifndef GLINT_SIM_RENDER_PLACES_H
#define GLINT_SIM_RENDER_PLACES_H

#include <stdbool.h>

#include "render/mesh.h"

typedef struct glint_places {
    size_t count;
    uint32_t *of_vertex; /* numbered in the order of their first vertices */
    uint32_t *start;     /* of each place, and one more: where its corners begin in */
    uint32_t *corner;    /* all corners, indices into the mesh's index, place after place */
    size_t most;         /* corners of one place */
} glint_places;

/* Vertices at exactly the same position share a place; −0 is 0. false: no memory (clear is still
 * due). */
bool glint_places_find(const glint_mesh *mesh, glint_places *places);
void glint_places_clear(glint_places *places);

/* Whether three coordinates are the same. */
static inline bool glint_same_place(const float *p, const float *q)
{
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

#endif
