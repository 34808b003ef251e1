/* The table over the normal; see reflection_map.h. */
#include "render/reflection_map.h"

#include <string.h>

#include "multiversion.h"
#include "render/paint.h"
#include "render/pixel.h"

static glint_vec3 normal_of(int size, int column, int row)
{
    const double x = 2.0 * column / (size - 1) - 1.0;
    const double y = 2.0 * row / (size - 1) - 1.0;
    const double rest = 1.0 - x * x - y * y;
    return (glint_vec3){x, y, rest > 0.0 ? sqrt(rest) : 0.0};
}

glint_status glint_reflection_map_fill(glint_reflection_map *map, int row, glint_lit_points *points,
                                       const glint_lighting *lighting, glint_backend *backend,
                                       glint_error *err)
{
    const glint_vec3 viewer = {0.0, 0.0, 1.0};
    points->count = 0;
    for (int column = 0; column < map->size; column++)
        glint_lit_points_add(points, lighting, viewer, normal_of(map->size, column, row));
    const glint_status status = glint_lit_points_light(points, lighting, backend, err);
    uint8_t *rgb = &map->rgb[3 * (size_t)row * (size_t)map->size];
    for (size_t i = 0; status == GLINT_OK && i < points->count; i++)
        for (size_t c = 0; c < 3; c++)
            rgb[3 * i + c] = points->base[c][i];
    return status;
}

/* The entries' numbers. */
GLINT_MULTIVERSION
static void find_row(int size, size_t count, const float *restrict nx, const float *restrict ny,
                     const float *restrict nz, uint32_t *restrict entry)
{
    const float half = 0.5f * (float)(size - 1);
    for (size_t i = 0; i < count; i++) {
        const float scale =
            half / sqrtf(nx[i] * nx[i] + ny[i] * ny[i] + nz[i] * nz[i] + GLINT_TINY);
        const int32_t column = (int32_t)(nx[i] * scale + half + 0.5f);
        const int32_t row = (int32_t)(ny[i] * scale + half + 0.5f);
        entry[i] = (uint32_t)(row * size + column);
    }
}

void glint_reflection_map_band(const glint_reflection_map *map, glint_shader *shader,
                               const glint_visibility *band, uint16_t *columns, glint_image *image,
                               uint64_t *fragments)
{
    uint32_t *entry = shader->entry;
    for (int32_t y = band->first_y; y <= band->last_y; y++) {
        const size_t found = glint_shader_gather(shader, band, y, image->width, columns);
        find_row(map->size, found, shader->n[0], shader->n[1], shader->n[2], entry);
        for (size_t i = 0; i < found; i++) {
            const size_t pixel = (size_t)y * (size_t)image->width + columns[i];
            memcpy(&image->rgb[3 * pixel], &map->rgb[3 * (size_t)entry[i]], 3);
            image->object[pixel] = 1;
        }
        *fragments += found;
    }
}
