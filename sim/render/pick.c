/* What is seen at a pixel of the last frame: its fragment from the record, its triangle by drawing
 * the frame's triangles once more. */
#include "render/pick.h"

#include "render/renderer.h"

bool glint_renderer_fragment(const glint_renderer *renderer, int x, int y, uint32_t *cos_code,
                             glint_material *material)
{
    if (!renderer->recorded || x < 0 || x >= renderer->extent.width || y < 0 ||
        y >= renderer->extent.height)
        return false;
    const int band_y = y - y % GLINT_BAND_ROWS;
    size_t at = (size_t)band_y * (size_t)renderer->extent.width;
    for (int row = band_y; row < y; row++)
        at += renderer->record.in_row[row];
    const size_t end = at + renderer->record.in_row[y];
    while (at < end && renderer->record.x[at] < x)
        at++;
    if (at == end || renderer->record.x[at] != x)
        return false;
    *cos_code = renderer->record.cos_code[at];
    *material = renderer->material;
    return true;
}

bool glint_renderer_triangle(glint_renderer *renderer, int x, int y, uint32_t *triangle)
{
    const glint_extent extent = renderer->extent;
    if (x < 0 || x >= extent.width || y < 0 || y >= extent.height)
        return false;
    glint_visibility *band = &renderer->workers[0].band;
    glint_visibility_begin(band, extent, y, y);
    for (size_t i = 0; i < renderer->list_count; i++)
        glint_visibility_draw(band, extent, &renderer->lists[i]);
    const glint_triangle *seen = band->triangle[x];
    if (seen == NULL)
        return false;
    *triangle = seen->source;
    return true;
}

void glint_renderer_triangles(glint_renderer *renderer, uint32_t *seen)
{
    const glint_extent extent = renderer->extent;
    glint_visibility *band = &renderer->workers[0].band;
    for (int32_t y = 0; y < extent.height; y += GLINT_BAND_ROWS) {
        const int32_t after = y + GLINT_BAND_ROWS;
        glint_visibility_begin(band, extent, y,
                               (after < extent.height ? after : extent.height) - 1);
        for (size_t i = 0; i < renderer->list_count; i++)
            glint_visibility_draw(band, extent, &renderer->lists[i]);
        const size_t pixels = (size_t)extent.width * (size_t)(band->last_y - y + 1);
        for (size_t i = 0; i < pixels; i++)
            *seen++ = band->triangle[i] != NULL ? band->triangle[i]->source : GLINT_NO_TRIANGLE;
    }
}
