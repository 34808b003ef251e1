/* Gouraud's shading with four sub-triangles (GouraudRasterizer4 of the thesis's appendix A): each
 * triangle of the mesh is cut through the middles of its edges, whose normals, the mean of the
 * ends', are lit like vertices; each quarter is linear. A middle is computed from the two ends
 * alone, so triangles that share an edge agree on it. */
#ifndef GLINT_SIM_RENDER_SPLIT_H
#define GLINT_SIM_RENDER_SPLIT_H

#include "render/points.h"

/* Triangles cut together, at most. */
#define GLINT_SPLIT_RUN 256

/* One thread's room. */
typedef struct glint_split glint_split;

glint_split *glint_split_create(void);        /* NULL: no memory */
void glint_split_destroy(glint_split *split); /* NULL is allowed */

/* The quarters of the mesh's triangles first … last−1 into list, each with its triangle's number as
 * the source. screen: the mesh's vertices, lit. Adds the points lit to *lights. */
glint_status glint_split_triangles(glint_split *split, const glint_point_light *light,
                                   glint_extent extent, const glint_screen_vertex *screen,
                                   size_t first, size_t last, glint_lit_points *points,
                                   glint_backend *backend, glint_triangle_list *list,
                                   uint64_t *lights, glint_error *err);

#endif
