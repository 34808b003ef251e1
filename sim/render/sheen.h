/* Which triangles may show a highlight. The thesis's program shows their number ("x/y pol") and has
 * a button, ISC, read here as an inner specular check: triangles without one are spared its
 * computation.
 *
 * The answer "none" is safe: in no pixel of such a triangle is the highlight above the level. It
 * follows from chords between unit vectors, which are a metric. With N₀ and H₀ at one corner, r the
 * longest chord from N₀ to another corner's normal and b that from V₀ to another corner's V,
 *
 *     |N − H| ≥ |N₀ − H₀| − r − 2b/(2|L + V₀| − b)
 *
 * in the whole triangle: a cap of less than a hemisphere about N₀ holds every mean of its normals
 * (so for V), and |a/|a| − c/|c|| ≤ 2|a − c|/(|a| + |c|). The cosine is 1 − |N − H|²/2. */
#ifndef GLINT_SIM_RENDER_SHEEN_H
#define GLINT_SIM_RENDER_SHEEN_H

#include "render/shade.h"

typedef struct glint_sheen {
    bool none;    /* there is no highlight at any cosine */
    bool known;   /* there are cosines from 0 on without one */
    double chord; /* from |N − H| on there is none */
} glint_sheen;

/* The sheen of a material, by asking for every code of the cosine from 0 on until a component is
 * above `level`. With a model, for those lobes that are of N·H; others are not known. backend: not
 * that of Verilog, for which the C model stands. */
glint_status glint_sheen_find(const glint_lighting *lighting, glint_backend *backend, int level,
                              glint_sheen *sheen, glint_error *err);

/* Marks each triangle of the list as dull or not; returns how many of the mesh's have a part that
 * is not. */
uint64_t glint_sheen_mark(const glint_sheen *sheen, const glint_lighting *lighting,
                          glint_triangle_list *list);

/* Of the band, only what is seen of dull triangles, or of the others. to: a band as large. */
void glint_sheen_part(const glint_visibility *band, int32_t width, bool dull, glint_visibility *to);

#endif
