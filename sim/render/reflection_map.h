/* The reflection map of the thesis's section 1.3: intensities precomputed for a grid of normals, of
 * which a pixel only looks one up. The grid is over x and y of the unit normal, −1…1 each, in
 * camera axes; the viewer is at infinity, since an entry is of a direction and has no place.
 * Ambient, Lambert's light and the highlight of an entry come from the backend or the model. */
#ifndef GLINT_SIM_RENDER_REFLECTION_MAP_H
#define GLINT_SIM_RENDER_REFLECTION_MAP_H

#include "render/points.h"

#define GLINT_MAP_SIZE_MIN     2
#define GLINT_MAP_SIZE_MAX     GLINT_POINTS_RUN
#define GLINT_MAP_SIZE_DEFAULT 256

typedef struct glint_reflection_map {
    int size;     /* entries along each axis */
    uint8_t *rgb; /* size × size × 3, y upwards */
} glint_reflection_map;

/* Lights row `row` of the map. Beyond the unit circle the normal lies in the frame's plane. */
glint_status glint_reflection_map_fill(glint_reflection_map *map, int row, glint_lit_points *points,
                                       const glint_lighting *lighting, glint_backend *backend,
                                       glint_error *err);

/* Each pixel gets the entry nearest to its interpolated normal, into empty rows. Adds to
 * *fragments. columns: room for a row. */
void glint_reflection_map_band(const glint_reflection_map *map, glint_shader *shader,
                               const glint_visibility *band, uint16_t *columns, glint_image *image,
                               uint64_t *fragments);

#endif
