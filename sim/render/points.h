/* Light at single points of the mesh: at its vertices, for Gouraud's shading, once for each
 * triangle, for flat shading, or wherever a ray ends (trace/). The same formula as for fragments,
 * and the same backend or model. */
#ifndef GLINT_SIM_RENDER_POINTS_H
#define GLINT_SIM_RENDER_POINTS_H

#include "render/setup.h"
#include "render/shade.h"

/* Points sent to the backend together. */
#define GLINT_POINTS_RUN 1024

/* One thread's room. */
typedef struct glint_lit_points {
    size_t count;
    uint32_t cos_code[GLINT_POINTS_RUN];    /* for a backend */
    float value[GLINT_POINTS_RUN];          /* by a model, instead */
    uint8_t base[3][GLINT_POINTS_RUN];      /* ambient and Lambert light, then the sum */
    uint8_t highlight[3][GLINT_POINTS_RUN]; /* from the backend or the model */
    uint8_t lit[GLINT_POINTS_RUN];          /* 255 where the surface faces the light, else 0 */
} glint_lit_points;

/* Appends a point with a normal n of any length, both in camera axes; back: from there towards the
 * viewer, any length. There must be room; count = 0 empties it. */
void glint_lit_points_add(glint_lit_points *points, const glint_lighting *lighting, glint_vec3 back,
                          glint_vec3 n);

/* Puts the point added last into shadow: ambient light only. */
void glint_lit_points_shadow(glint_lit_points *points, const glint_lighting *lighting);

/* Lights all that were added: base becomes the colours. */
glint_status glint_lit_points_light(glint_lit_points *points, const glint_lighting *lighting,
                                    glint_backend *backend, glint_error *err);

/* What a frame's points are lit with. */
typedef struct glint_point_light {
    const glint_mesh *mesh;
    const glint_camera *camera;
    const glint_lighting *lighting;
} glint_point_light;

/* Gives screen[first] … screen[last−1] the colours of the mesh's vertices, including those out of
 * sight, which clipped triangles need. At most GLINT_POINTS_RUN. */
glint_status glint_light_vertices(glint_lit_points *points, const glint_point_light *light,
                                  size_t first, size_t last, glint_backend *backend,
                                  glint_screen_vertex *screen, glint_error *err);

/* Gives each triangle of the list the one colour of the mesh's triangle: light on its centroid,
 * with the normal of its plane. *count is how many of the mesh's there were, at most
 * GLINT_POINTS_RUN. */
glint_status glint_light_triangles(glint_lit_points *points, const glint_point_light *light,
                                   glint_backend *backend, glint_triangle_list *list,
                                   uint64_t *count, glint_error *err);

/* Lights each triangle of the list, parts of clipped ones too, at its corners and at the middles of
 * its edges on the screen, with the normals interpolated there: as Phong's shading would light
 * these six points. Adds their number to *count. */
glint_status glint_light_six_points(glint_lit_points *points, const glint_point_light *light,
                                    glint_backend *backend, glint_triangle_list *list,
                                    uint64_t *count, glint_error *err);

#endif
