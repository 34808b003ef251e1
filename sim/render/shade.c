/* The loops over fragments. Their arithmetic is single precision: the error of a cosine near 1 is
 * some 2⁻²³, a thirtieth of the device's step of 2⁻¹⁸. */
#include "render/shade.h"

#include <stdlib.h>
#include <string.h>

#include "multiversion.h"
#include "render/approximate.h"
#include "render/paint.h"
#include "render/pixel.h"

glint_lighting glint_lighting_of(const glint_scene *scene, const glint_camera *camera,
                                 const glint_reflectance *specular)
{
    const glint_vec3 light = glint_vec3_of(scene->light);
    glint_lighting lighting = {
        .inv_focal = (float)(1.0 / camera->focal),
        .half_width = (float)camera->half_width,
        .half_height = (float)camera->half_height,
        .material = glint_scene_material(scene),
        .specular = specular,
    };
    glint_vec3_store(glint_vec3_scale(light, 1.0 / glint_vec3_length(light)), lighting.light);
    for (int i = 0; i < 3; i++) {
        lighting.ambient[i] =
            (float)((double)scene->color[i] * (double)scene->ka * (double)scene->ia[i]);
        lighting.lambert[i] =
            (float)((double)scene->color[i] * (double)scene->kd * (double)scene->ie[i]);
    }
    return lighting;
}

bool glint_shader_create(glint_shader *shader, int32_t width)
{
    const size_t pixels = (size_t)width * GLINT_BAND_ROWS;
    shader->lit = malloc(pixels);
    shader->value = malloc((size_t)width * sizeof *shader->value);
    shader->entry = malloc((size_t)width * sizeof *shader->entry);
    bool complete = shader->lit != NULL && shader->value != NULL && shader->entry != NULL;
    for (int i = 0; i < GLINT_SHADER_COSINES; i++) {
        shader->cosine[i] = malloc((size_t)width * sizeof *shader->cosine[i]);
        complete = complete && shader->cosine[i] != NULL;
    }
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
    for (int i = 0; i < GLINT_SHADER_COSINES; i++)
        free(shader->cosine[i]);
    free(shader->value);
    free(shader->entry);
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

size_t glint_shader_gather(glint_shader *shader, const glint_visibility *band, int32_t y,
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
        for (int32_t column = pixels.first; column < x; column++)
            columns[count++] = (uint16_t)column;
    }
    return count;
}

/* cos γ = N·H/(|N||H|), and the light that needs no device. */
GLINT_MULTIVERSION
static void light_row(const glint_lighting *lighting, int32_t y, size_t count,
                      const uint16_t *restrict columns, const float *restrict nx,
                      const float *restrict ny, const float *restrict nz,
                      uint32_t *restrict cos_code, uint8_t *restrict red, uint8_t *restrict green,
                      uint8_t *restrict blue, uint8_t *restrict lit)
{
    const glint_lighting c = *lighting;
    const float vy = glint_row_vy(lighting, y);
    for (size_t i = 0; i < count; i++) {
        const glint_pixel p = glint_pixel_of(&c, vy, columns[i], nx[i], ny[i], nz[i]);
        const float cos_l = p.nl / sqrtf(p.nn + GLINT_TINY);
        const float diffuse = 0.5f * (cos_l + fabsf(cos_l)); /* cos_l, or 0 where it is below */
        cos_code[i] = glint_cos_code_of(p.nh / sqrtf(p.nn * p.hh + GLINT_TINY));
        red[i] = glint_intensity_of(c.ambient[0] + c.lambert[0] * diffuse);
        green[i] = glint_intensity_of(c.ambient[1] + c.lambert[1] * diffuse);
        blue[i] = glint_intensity_of(c.ambient[2] + c.lambert[2] * diffuse);
        lit[i] = p.nl > 0.0f ? 255 : 0;
    }
}

GLINT_MULTIVERSION
static void row_nh(const glint_lighting *lighting, int32_t y, size_t count,
                   const uint16_t *restrict columns, const float *restrict nx,
                   const float *restrict ny, const float *restrict nz, float *restrict cosine)
{
    const glint_lighting c = *lighting;
    const float vy = glint_row_vy(lighting, y);
    for (size_t i = 0; i < count; i++) {
        const glint_pixel p = glint_pixel_of(&c, vy, columns[i], nx[i], ny[i], nz[i]);
        cosine[i] = p.nh / sqrtf(p.nn * p.hh + GLINT_TINY);
    }
}

/* R = 2(N·L)N − L (2.10). */
GLINT_MULTIVERSION
static void row_rv(const glint_lighting *lighting, int32_t y, size_t count,
                   const uint16_t *restrict columns, const float *restrict nx,
                   const float *restrict ny, const float *restrict nz, float *restrict cosine)
{
    const glint_lighting c = *lighting;
    const float vy = glint_row_vy(lighting, y);
    for (size_t i = 0; i < count; i++) {
        const glint_pixel p = glint_pixel_of(&c, vy, columns[i], nx[i], ny[i], nz[i]);
        cosine[i] = 2.0f * p.nl * p.nv / (p.nn + GLINT_TINY) - p.lv;
    }
}

/* |H| = 2 V·H, as |L + V|² = 2(1 + L·V). */
GLINT_MULTIVERSION
static void row_geometry(const glint_lighting *lighting, int32_t y, size_t count,
                         const uint16_t *restrict columns, const float *restrict nx,
                         const float *restrict ny, const float *restrict nz, float *restrict nl,
                         float *restrict nv, float *restrict nh, float *restrict vh)
{
    const glint_lighting c = *lighting;
    const float vy = glint_row_vy(lighting, y);
    for (size_t i = 0; i < count; i++) {
        const glint_pixel p = glint_pixel_of(&c, vy, columns[i], nx[i], ny[i], nz[i]);
        const float inv_n = 1.0f / sqrtf(p.nn + GLINT_TINY);
        nl[i] = p.nl * inv_n;
        nv[i] = p.nv * inv_n;
        nh[i] = p.nh / sqrtf(p.nn * p.hh + GLINT_TINY);
        vh[i] = 0.5f * sqrtf(p.hh);
    }
}

double glint_specular_value(const glint_reflectance *specular, const glint_geometry *geometry)
{
    switch (glint_reflectance_describe(specular->model)->cosine) {
    case GLINT_REFLECTANCE_OF_NL:
        return 0.0;
    case GLINT_REFLECTANCE_OF_RV:
        return glint_reflectance_of_cosine(specular, geometry->rv);
    case GLINT_REFLECTANCE_OF_NH:
        return glint_reflectance_of_cosine(specular, geometry->nh);
    default:
        return glint_reflectance_intensity(specular, geometry);
    }
}

/* Beyond white with any material, and far from what an integer holds. */
#define VALUE_MAX 1e6f

GLINT_MULTIVERSION
void glint_specular_color(size_t count, const float *restrict value, uint8_t component,
                          uint8_t *restrict highlight)
{
    for (size_t i = 0; i < count; i++) {
        const float held = value[i] < VALUE_MAX ? value[i] : VALUE_MAX;
        highlight[i] = glint_intensity_of(held * (float)component);
    }
}

static void microfacet_values(const glint_shader *shader, const glint_reflectance *specular,
                              size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const glint_geometry geometry = {
            .nl = (double)shader->cosine[0][i],
            .nv = (double)shader->cosine[1][i],
            .nh = (double)shader->cosine[2][i],
            .vh = (double)shader->cosine[3][i],
        };
        shader->value[i] = (float)glint_reflectance_intensity(specular, &geometry);
    }
}

/* The highlights of one row by the model; first is the row's place in the band. */
static void model_row(const glint_shader *s, const glint_lighting *lighting, int32_t y,
                      size_t count, const uint16_t *columns, size_t first)
{
    const glint_reflectance *specular = lighting->specular;
    switch (glint_reflectance_describe(specular->model)->cosine) {
    case GLINT_REFLECTANCE_OF_NL:
        memset(s->value, 0, count * sizeof *s->value);
        break;
    case GLINT_REFLECTANCE_OF_RV:
        row_rv(lighting, y, count, columns, s->n[0], s->n[1], s->n[2], s->cosine[0]);
        glint_reflectance_batch(specular, s->cosine[0], count, s->value);
        break;
    case GLINT_REFLECTANCE_OF_NH:
        row_nh(lighting, y, count, columns, s->n[0], s->n[1], s->n[2], s->cosine[0]);
        glint_reflectance_batch(specular, s->cosine[0], count, s->value);
        break;
    default:
        row_geometry(lighting, y, count, columns, s->n[0], s->n[1], s->n[2], s->cosine[0],
                     s->cosine[1], s->cosine[2], s->cosine[3]);
        microfacet_values(s, specular, count);
    }
    const uint8_t color[3] = {lighting->material.r, lighting->material.g, lighting->material.b};
    for (int i = 0; i < 3; i++)
        glint_specular_color(count, s->value, color[i], &s->highlight[i][first]);
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

void glint_shader_write(const glint_shader *shader, const uint16_t *columns, size_t first,
                        size_t count, glint_image *image, int32_t y)
{
    uint8_t *rgb = glint_paint_pixel(image, 0, y);
    uint8_t *object = &image->object[(size_t)y * (size_t)image->width];
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
        const size_t found = glint_shader_gather(shader, band, y, image->width, &columns[count]);
        if (lighting->cosines != GLINT_COSINES_EXACT) {
            glint_approximate_row(shader, lighting, y, found, &columns[count], count,
                                  &cos_code[count]);
        } else {
            light_row(lighting, y, found, &columns[count], shader->n[0], shader->n[1], shader->n[2],
                      &cos_code[count], &shader->base[0][count], &shader->base[1][count],
                      &shader->base[2][count], &shader->lit[count]);
            if (lighting->specular != NULL)
                model_row(shader, lighting, y, found, &columns[count], count);
        }
        record->in_row[y] = (uint32_t)found;
        count += found;
    }
    if (count > 0 && lighting->specular == NULL) {
        const glint_points run = {.cos = cos_code,
                                  .count = count,
                                  .r = shader->highlight[0],
                                  .g = shader->highlight[1],
                                  .b = shader->highlight[2]};
        const glint_status status = glint_backend_shade(backend, &lighting->material, &run, err);
        if (status != GLINT_OK)
            return status;
    }
    for (int i = 0; i < 3; i++)
        glint_add_highlight(count, shader->highlight[i], shader->lit, shader->base[i]);
    size_t first = 0;
    for (int32_t y = band->first_y; y <= band->last_y; y++) {
        glint_shader_write(shader, columns, first, record->in_row[y], image, y);
        first += record->in_row[y];
    }
    *fragments = count;
    return GLINT_OK;
}
