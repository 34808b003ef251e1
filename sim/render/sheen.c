/* Triangles without a highlight; see sheen.h. */
#include "render/sheen.h"

#define CHUNK 4096

/* A pixel's cosine is computed in single precision, whose error is some thirtieth of a code; the
 * bound, too. */
#define MARGIN_CODES 8
#define MARGIN_CHORD 1e-5
#define MARGIN_LIT   1e-5

typedef struct chunk {
    uint32_t code[CHUNK];
    float cosine[CHUNK], value[CHUNK];
    uint8_t rgb[3][CHUNK];
} chunk;

static glint_status ask(chunk *c, size_t count, const glint_lighting *lighting,
                        glint_backend *backend, glint_error *err)
{
    const glint_material *m = &lighting->material;
    const uint8_t color[3] = {m->r, m->g, m->b};
    if (lighting->specular == NULL) {
        const glint_points run = {
            .cos = c->code, .count = count, .r = c->rgb[0], .g = c->rgb[1], .b = c->rgb[2]};
        return glint_backend_shade(backend, m, &run, err);
    }
    for (size_t i = 0; i < count; i++)
        c->cosine[i] = (float)c->code[i] / (float)GLINT_COS_ONE;
    glint_reflectance_batch(lighting->specular, c->cosine, count, c->value);
    for (int i = 0; i < 3; i++)
        glint_specular_color(count, c->value, color[i], c->rgb[i]);
    return GLINT_OK;
}

/* The number of codes from 0 on whose highlight is at most level. */
static glint_status count_dull(const glint_lighting *lighting, glint_backend *backend, int level,
                               uint32_t *dull, glint_error *err)
{
    static _Thread_local chunk c;
    *dull = 0;
    while (*dull <= GLINT_COS_ONE) {
        const uint32_t left = (uint32_t)GLINT_COS_ONE + 1 - *dull;
        const size_t count = left < CHUNK ? left : CHUNK;
        for (size_t i = 0; i < count; i++)
            c.code[i] = *dull + (uint32_t)i;
        const glint_status status = ask(&c, count, lighting, backend, err);
        if (status != GLINT_OK)
            return status;
        for (size_t i = 0; i < count; i++) {
            if (c.rgb[0][i] > level || c.rgb[1][i] > level || c.rgb[2][i] > level)
                return GLINT_OK;
            ++*dull;
        }
    }
    return GLINT_OK;
}

glint_status glint_sheen_find(const glint_lighting *lighting, glint_backend *backend, int level,
                              glint_sheen *sheen, glint_error *err)
{
    uint32_t dull;
    *sheen = (glint_sheen){0};
    if (lighting->specular != NULL) {
        const glint_reflectance_cosine cosine =
            glint_reflectance_describe(lighting->specular->model)->cosine;
        if (cosine == GLINT_REFLECTANCE_OF_NL)
            *sheen = (glint_sheen){.none = true};
        if (cosine != GLINT_REFLECTANCE_OF_NH)
            return GLINT_OK;
    }
    const glint_status status = count_dull(lighting, backend, level, &dull, err);
    if (status != GLINT_OK || dull <= 1 + MARGIN_CODES)
        return status;
    const double cosine = (double)(dull - 1 - MARGIN_CODES) / GLINT_COS_ONE;
    sheen->known = true;
    sheen->none = dull > GLINT_COS_ONE;
    sheen->chord = sqrt(2.0 - 2.0 * cosine);
    return GLINT_OK;
}

/* The interpolated normals' corners at unit length. false: one has none. */
static bool unit_normals(const glint_triangle *t, glint_vec3 n[3])
{
    for (int i = 0; i < 3; i++) {
        n[i] = glint_vec3_scale(glint_vec3_of(t->n[i]), 1.0 / (double)t->inv_w[i]);
        const double square = glint_vec3_dot(n[i], n[i]);
        if (fabs(square - 1.0) > 1e-6) { /* where an edge is cut */
            if (!(square > 1e-6))
                return false;
            n[i] = glint_vec3_scale(n[i], 1.0 / sqrt(square));
        }
    }
    return true;
}

/* Along the ray through a corner back to the eye, 1 towards the viewer. */
static glint_vec3 towards_eye(const glint_lighting *lighting, const glint_triangle *t, int corner)
{
    const double unit = (double)lighting->inv_focal / GLINT_SUBPIXEL_ONE;
    return (glint_vec3){((double)lighting->half_width * GLINT_SUBPIXEL_ONE - t->x[corner]) * unit,
                        (t->y[corner] - (double)lighting->half_height * GLINT_SUBPIXEL_ONE) * unit,
                        1.0};
}

/* The longer of the chords from v[0]. */
static double spread(const glint_vec3 v[3])
{
    const glint_vec3 to1 = glint_vec3_sub(v[1], v[0]), to2 = glint_vec3_sub(v[2], v[0]);
    return sqrt(fmax(glint_vec3_dot(to1, to1), glint_vec3_dot(to2, to2)));
}

static bool turned_away(const glint_vec3 n[3], glint_vec3 light)
{
    return glint_vec3_dot(n[0], light) < -MARGIN_LIT && glint_vec3_dot(n[1], light) < -MARGIN_LIT &&
           glint_vec3_dot(n[2], light) < -MARGIN_LIT;
}

/* The rays' spread is taken before they are of unit length, when it is larger: none is shorter
 * than 1. */
static bool is_dull(const glint_sheen *sheen, const glint_lighting *lighting,
                    const glint_triangle *t)
{
    const glint_vec3 light = glint_vec3_of(lighting->light);
    glint_vec3 n[3], v[3];
    if (sheen->none)
        return true;
    if (!unit_normals(t, n))
        return false;
    if (turned_away(n, light))
        return true;
    for (int i = 0; i < 3; i++)
        v[i] = towards_eye(lighting, t, i);
    const double n_spread = spread(n), v_spread = spread(v);
    const glint_vec3 h =
        glint_vec3_add(light, glint_vec3_scale(v[0], 1.0 / glint_vec3_length(v[0])));
    const double h_length = glint_vec3_length(h);
    if (!sheen->known || n_spread > 1.4 || v_spread > 1.0 || v_spread >= h_length)
        return false;
    const double h_spread = 2.0 * v_spread / (2.0 * h_length - v_spread);
    const glint_vec3 apart = glint_vec3_sub(n[0], glint_vec3_scale(h, 1.0 / h_length));
    return glint_vec3_length(apart) - n_spread - h_spread > sheen->chord + MARGIN_CHORD;
}

uint64_t glint_sheen_mark(const glint_sheen *sheen, const glint_lighting *lighting,
                          glint_triangle_list *list)
{
    uint64_t shiny = 0;
    bool counted = false; /* another part of this triangle */
    for (size_t i = 0; i < list->count; i++) {
        glint_triangle *t = &list->triangle[i];
        if (i > 0 && t->source != list->triangle[i - 1].source)
            counted = false;
        t->dull = is_dull(sheen, lighting, t);
        shiny += !t->dull && !counted;
        counted = counted || !t->dull;
    }
    return shiny;
}

void glint_sheen_part(const glint_visibility *band, int32_t width, bool dull, glint_visibility *to)
{
    const size_t pixels = (size_t)width * (size_t)(band->last_y - band->first_y + 1);
    to->first_y = band->first_y;
    to->last_y = band->last_y;
    const glint_triangle *last = NULL;
    bool in = false;
    for (size_t i = 0; i < pixels; i++) {
        const glint_triangle *t = band->triangle[i];
        if (t != last)
            in = t != NULL && t->dull == dull;
        last = t;
        to->triangle[i] = in ? t : NULL;
    }
}
