/* The loops over fragments. Their arithmetic is single precision: the error of a cosine near 1 is
 * some 2⁻²³, a thirtieth of the device's step of 2⁻¹⁸. */
#include "render/shade.h"

#include <stdlib.h>
#include <string.h>

#include "multiversion.h"

glint_lighting glint_lighting_of(const glint_scene *scene, const glint_camera *camera)
{
    const glint_vec3 light = glint_vec3_of(scene->light);
    glint_lighting lighting = {
        .inv_focal = (float)(1.0 / camera->focal),
        .half_width = (float)camera->half_width,
        .half_height = (float)camera->half_height,
        .material = glint_scene_material(scene),
    };
    glint_vec3_store(glint_vec3_scale(light, 1.0 / glint_vec3_length(light)), lighting.light);
    for (int i = 0; i < 3; i++) {
        lighting.ambient[i] =
            (float)((double)scene->color[i] * (double)scene->ka * (double)scene->ia);
        lighting.lambert[i] =
            (float)((double)scene->color[i] * (double)scene->kd * (double)scene->ie);
    }
    return lighting;
}

bool glint_shader_create(glint_shader *shader, int32_t width)
{
    const size_t pixels = (size_t)width * GLINT_BAND_ROWS;
    bool complete = (shader->lit = malloc(pixels)) != NULL;
    for (int i = 0; i < 3; i++) {
        shader->n[i] = malloc((size_t)width * sizeof *shader->n[i]);
        shader->base[i] = malloc(pixels);
        shader->highlight[i] = malloc(pixels);
        complete = complete && shader->n[i] != NULL && shader->base[i] != NULL &&
                   shader->highlight[i] != NULL;
    }
    return complete;
}

void glint_shader_destroy(glint_shader *shader)
{
    for (int i = 0; i < 3; i++) {
        free(shader->n[i]);
        free(shader->base[i]);
        free(shader->highlight[i]);
    }
    free(shader->lit);
}

/* The normals of a run of pixels. In double precision until the sum is done: a triangle that is
 * cut at the near plane has values a thousand times apart at its corners. N/w is linear on the
 * screen and has the direction of N, so no division is needed. */
static void interpolate(const glint_triangle *t, const glint_weights *w, int32_t count,
                        float *restrict nx, float *restrict ny, float *restrict nz)
{
    double from[3], step[3];
    for (int axis = 0; axis < 3; axis++) {
        const double at0 = (double)t->n[0][axis];
        const double to1 = (double)t->n[1][axis] - at0;
        const double to2 = (double)t->n[2][axis] - at0;
        from[axis] = at0 + w->at1 * to1 + w->at2 * to2;
        step[axis] = w->step1 * to1 + w->step2 * to2;
    }
    for (int32_t k = 0; k < count; k++) {
        nx[k] = (float)(from[0] + k * step[0]);
        ny[k] = (float)(from[1] + k * step[1]);
        nz[k] = (float)(from[2] + k * step[2]);
    }
}

/* Collects the fragments of one row: columns and normals. Returns how many there are. */
static size_t gather_row(glint_shader *shader, const glint_visibility *band, int32_t y,
                         int32_t width, uint16_t *columns)
{
    size_t count = 0;
    int32_t x = 0;
    glint_pixels pixels;
    const glint_triangle *t;
    while ((t = glint_visible_next(band, width, y, &x, &pixels)) != NULL) {
        const glint_weights w = glint_triangle_weights(t, pixels.first, y);
        interpolate(t, &w, x - pixels.first, &shader->n[0][count], &shader->n[1][count],
                    &shader->n[2][count]);
        for (int32_t column = pixels.first; column < x; column++) {
            columns[count++] = (uint16_t)column;
        }
    }
    return count;
}

/* cos γ = N·H/(|N||H|) with H = L + V, both of unit length, and the light that needs no device. V
 * depends on the pixel alone: it is the way back along the ray through it. TINY is lost in any sum
 * but that of a normal or an H without length, whose cosine it makes 0 instead of 0/0. No branches
 * and no selections of floating-point values, so that compilers vectorise all of it. */
#define TINY 1e-37f

GLINT_MULTIVERSION
static void light_row(const glint_lighting *lighting, int32_t y, size_t count,
                      const uint16_t *restrict columns, const float *restrict nx,
                      const float *restrict ny, const float *restrict nz,
                      uint32_t *restrict cos_code, uint8_t *restrict red, uint8_t *restrict green,
                      uint8_t *restrict blue, uint8_t *restrict lit)
{
    const glint_lighting c = *lighting;
    const float vy = ((float)y + 0.5f - c.half_height) * c.inv_focal;
    const float vyz = vy * vy + 1.0f;
    for (size_t i = 0; i < count; i++) {
        const float vx = (c.half_width - ((float)columns[i] + 0.5f)) * c.inv_focal;
        const float inv_v = 1.0f / sqrtf(vx * vx + vyz);
        const float hx = c.light[0] + vx * inv_v;
        const float hy = c.light[1] + vy * inv_v;
        const float hz = c.light[2] + inv_v;
        const float hh = hx * hx + hy * hy + hz * hz;
        const float nn = nx[i] * nx[i] + ny[i] * ny[i] + nz[i] * nz[i];
        const float nh = nx[i] * hx + ny[i] * hy + nz[i] * hz;
        const float nl = nx[i] * c.light[0] + ny[i] * c.light[1] + nz[i] * c.light[2];
        const float cos_l = nl / sqrtf(nn + TINY);
        const float diffuse = 0.5f * (cos_l + fabsf(cos_l)); /* cos_l, or 0 where it is below */
        cos_code[i] = glint_cos_code_of(nh / sqrtf(nn * hh + TINY));
        red[i] = glint_intensity_of(c.ambient[0] + c.lambert[0] * diffuse);
        green[i] = glint_intensity_of(c.ambient[1] + c.lambert[1] * diffuse);
        blue[i] = glint_intensity_of(c.ambient[2] + c.lambert[2] * diffuse);
        lit[i] = nl > 0.0f ? 255 : 0;
    }
}

GLINT_MULTIVERSION
void glint_add_highlight(size_t count, const uint8_t *restrict highlight,
                         const uint8_t *restrict lit, uint8_t *restrict base)
{
    for (size_t i = 0; i < count; i++) {
        const unsigned sum = (unsigned)base[i] + (highlight[i] & lit[i]);
        base[i] = (uint8_t)(sum < 255 ? sum : 255);
    }
}

static void write_row(const glint_shader *shader, const uint16_t *columns, size_t first,
                      size_t count, glint_image *image, int32_t y)
{
    const size_t row = (size_t)y * (size_t)image->width;
    uint8_t *rgb = &image->rgb[3 * row];
    uint8_t *object = &image->object[row];
    memset(rgb, 0, 3 * (size_t)image->width);
    memset(object, 0, (size_t)image->width);
    for (size_t i = first; i < first + count; i++) {
        const size_t x = columns[i];
        rgb[3 * x] = shader->base[0][i];
        rgb[3 * x + 1] = shader->base[1][i];
        rgb[3 * x + 2] = shader->base[2][i];
        object[x] = 1;
    }
}

glint_status glint_shade_band(glint_shader *shader, const glint_lighting *lighting,
                              const glint_visibility *band, glint_backend *backend,
                              glint_record *record, glint_image *image, uint64_t *fragments,
                              glint_error *err)
{
    const size_t start = (size_t)band->first_y * (size_t)image->width;
    uint32_t *cos_code = &record->cos_code[start];
    uint16_t *columns = &record->x[start];
    size_t count = 0;
    for (int32_t y = band->first_y; y <= band->last_y; y++) {
        const size_t found = gather_row(shader, band, y, image->width, &columns[count]);
        light_row(lighting, y, found, &columns[count], shader->n[0], shader->n[1], shader->n[2],
                  &cos_code[count], &shader->base[0][count], &shader->base[1][count],
                  &shader->base[2][count], &shader->lit[count]);
        record->in_row[y] = (uint32_t)found;
        count += found;
    }
    if (count > 0) {
        const glint_status status = glint_backend_shade(
            backend, &lighting->material, cos_code, count, NULL, shader->highlight[0],
            shader->highlight[1], shader->highlight[2], err);
        if (status != GLINT_OK) {
            return status;
        }
    }
    for (int i = 0; i < 3; i++) {
        glint_add_highlight(count, shader->highlight[i], shader->lit, shader->base[i]);
    }
    size_t first = 0;
    for (int32_t y = band->first_y; y <= band->last_y; y++) {
        write_row(shader, columns, first, record->in_row[y], image, y);
        first += record->in_row[y];
    }
    *fragments = count;
    return GLINT_OK;
}
