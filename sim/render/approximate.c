/* Rows of fragments by cheaper cosines; see approximate.h. */
#include "render/approximate.h"

#include <string.h>

#include "multiversion.h"
#include "render/pixel.h"

/* Towards the eye from a corner of a triangle, which lies on the frame at 1/4096 of a pixel. */
static glint_vec3 towards_eye(const glint_lighting *lighting, const glint_triangle *t, int corner)
{
    const double x = (double)t->x[corner] / GLINT_SUBPIXEL_ONE;
    const double y = (double)t->y[corner] / GLINT_SUBPIXEL_ONE;
    const glint_vec3 v = {((double)lighting->half_width - x) * (double)lighting->inv_focal,
                          (y - (double)lighting->half_height) * (double)lighting->inv_focal, 1.0};
    return glint_vec3_scale(v, 1.0 / glint_vec3_length(v));
}

static double cosine_of(glint_vec3 a, glint_vec3 b)
{
    const double lengths = glint_vec3_length(a) * glint_vec3_length(b);
    return lengths > 0.0 ? glint_vec3_dot(a, b) / lengths : 0.0;
}

static void corner_to_cosines(const glint_lighting *lighting, glint_triangle *t, int corner)
{
    const glint_vec3 n = glint_vec3_of(t->n[corner]);
    const glint_vec3 l = glint_vec3_of(lighting->light);
    t->n[corner][0] = (float)cosine_of(n, l);
    t->n[corner][1] = (float)cosine_of(n, glint_vec3_add(l, towards_eye(lighting, t, corner)));
    t->n[corner][2] = 0.0f;
}

/* normal/w to the normal: of unit length, but where clipping has cut an edge. */
static void corner_to_normal(glint_triangle *t, int corner)
{
    for (int axis = 0; axis < 3; axis++)
        t->n[corner][axis] /= t->inv_w[corner];
}

void glint_approximate_corners(const glint_lighting *lighting, glint_triangle_list *list)
{
    for (size_t i = 0; i < list->count; i++) {
        for (int corner = 0; corner < 3; corner++)
            if (lighting->cosines == GLINT_COSINES_LINEAR)
                corner_to_cosines(lighting, &list->triangle[i], corner);
            else
                corner_to_normal(&list->triangle[i], corner);
    }
}

/* One step of Newton's iteration for 1/√(N·N) from 1: N·(3 − N·N)/2. */
GLINT_MULTIVERSION
static void newton_row(size_t count, float *restrict nx, float *restrict ny, float *restrict nz)
{
    for (size_t i = 0; i < count; i++) {
        const float step = 0.5f * (3.0f - (nx[i] * nx[i] + ny[i] * ny[i] + nz[i] * nz[i]));
        nx[i] *= step;
        ny[i] *= step;
        nz[i] *= step;
    }
}

/* N·L and N·H, H of unit length, N as it is. */
GLINT_MULTIVERSION
static void cosine_row(const glint_lighting *lighting, int32_t y, size_t count,
                       const uint16_t *restrict columns, const float *restrict nx,
                       const float *restrict ny, const float *restrict nz, float *restrict nl,
                       float *restrict nh)
{
    const glint_lighting c = *lighting;
    const float vy = glint_row_vy(lighting, y);
    for (size_t i = 0; i < count; i++) {
        const glint_pixel p = glint_pixel_of(&c, vy, columns[i], nx[i], ny[i], nz[i]);
        nl[i] = p.nl;
        nh[i] = p.nh / sqrtf(p.hh + GLINT_TINY);
    }
}

/* What shade.c's light_row() makes of the two cosines. */
GLINT_MULTIVERSION
static void light_row(const glint_lighting *lighting, size_t count, const float *restrict nl,
                      const float *restrict nh, uint32_t *restrict cos_code, uint8_t *restrict red,
                      uint8_t *restrict green, uint8_t *restrict blue, uint8_t *restrict lit)
{
    const glint_lighting c = *lighting;
    for (size_t i = 0; i < count; i++) {
        const float diffuse = 0.5f * (nl[i] + fabsf(nl[i]));
        cos_code[i] = glint_cos_code_of(nh[i]);
        red[i] = glint_intensity_of(c.ambient[0] + c.lambert[0] * diffuse);
        green[i] = glint_intensity_of(c.ambient[1] + c.lambert[1] * diffuse);
        blue[i] = glint_intensity_of(c.ambient[2] + c.lambert[2] * diffuse);
        lit[i] = nl[i] > 0.0f ? 255 : 0;
    }
}

static void model_row(const glint_shader *s, const glint_lighting *lighting, size_t count,
                      const float *nh, size_t first)
{
    const glint_reflectance *specular = lighting->specular;
    const uint8_t color[3] = {lighting->material.r, lighting->material.g, lighting->material.b};
    if (glint_reflectance_describe(specular->model)->cosine == GLINT_REFLECTANCE_OF_NH)
        glint_reflectance_batch(specular, nh, count, s->value);
    else /* Lambert's: no highlight */
        memset(s->value, 0, count * sizeof *s->value);
    for (int i = 0; i < 3; i++)
        glint_specular_color(count, s->value, color[i], &s->highlight[i][first]);
}

void glint_approximate_row(glint_shader *shader, const glint_lighting *lighting, int32_t y,
                           size_t count, const uint16_t *columns, size_t first, uint32_t *cos_code)
{
    float *const *n = shader->n;
    const float *nl = n[0], *nh = n[1];
    if (lighting->cosines == GLINT_COSINES_NEWTON)
        newton_row(count, n[0], n[1], n[2]);
    if (lighting->cosines != GLINT_COSINES_LINEAR) {
        nl = shader->cosine[0];
        nh = shader->cosine[1];
        cosine_row(lighting, y, count, columns, n[0], n[1], n[2], shader->cosine[0],
                   shader->cosine[1]);
    }
    light_row(lighting, count, nl, nh, cos_code, &shader->base[0][first], &shader->base[1][first],
              &shader->base[2][first], &shader->lit[first]);
    if (lighting->specular != NULL)
        model_row(shader, lighting, count, nh, first);
}

/* Of shade.c's light_row() what needs no H. */
GLINT_MULTIVERSION
static void dull_row(const glint_lighting *lighting, size_t count, const float *restrict nx,
                     const float *restrict ny, const float *restrict nz, uint8_t *restrict red,
                     uint8_t *restrict green, uint8_t *restrict blue)
{
    const glint_lighting c = *lighting;
    for (size_t i = 0; i < count; i++) {
        const float nn = nx[i] * nx[i] + ny[i] * ny[i] + nz[i] * nz[i];
        const float nl = nx[i] * c.light[0] + ny[i] * c.light[1] + nz[i] * c.light[2];
        const float cos_l = nl / sqrtf(nn + GLINT_TINY);
        const float diffuse = 0.5f * (cos_l + fabsf(cos_l));
        red[i] = glint_intensity_of(c.ambient[0] + c.lambert[0] * diffuse);
        green[i] = glint_intensity_of(c.ambient[1] + c.lambert[1] * diffuse);
        blue[i] = glint_intensity_of(c.ambient[2] + c.lambert[2] * diffuse);
    }
}

void glint_dull_band(glint_shader *shader, const glint_lighting *lighting,
                     const glint_visibility *band, uint16_t *columns, glint_image *image,
                     uint64_t *fragments)
{
    for (int32_t y = band->first_y; y <= band->last_y; y++) {
        const size_t found = glint_shader_gather(shader, band, y, image->width, columns);
        dull_row(lighting, found, shader->n[0], shader->n[1], shader->n[2], shader->base[0],
                 shader->base[1], shader->base[2]);
        glint_shader_write(shader, columns, 0, found, image, y);
        *fragments += found;
    }
}
