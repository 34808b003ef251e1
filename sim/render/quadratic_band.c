/* Quadratic shading of a band: spans are set up and gathered, then walked together. */
#include "render/quadratic_band.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "render/paint.h"

/* Spans that go to the unit together. */
#define JOBS 4096

struct glint_quadratic_shader {
    int32_t width;
    glint_quadratic_config config;
    glint_quadratic_backend *backend; /* NULL: values are exact */
    uint32_t longest;                 /* pixels of a span */
    uint64_t spans, clocks_before;    /* of this frame */
    size_t count;                     /* gathered */
    glint_quadratic_walk walk[JOBS];
    uint32_t length[JOBS];
    uint8_t *place[JOBS]; /* in the picture */
    uint8_t *rgb;         /* of all spans gathered */
};

static bool is_exact(const glint_quadratic_config *config)
{
    return config->kind == GLINT_BACKEND_REAL || config->fraction == GLINT_FRACTION_EXACT;
}

static bool make_room(glint_quadratic_shader *s, int32_t width)
{
    if (s->rgb != NULL && s->width == width)
        return true;
    free(s->rgb);
    s->width = width;
    s->rgb = malloc((size_t)width * GLINT_BAND_ROWS * GLINT_QUADRATIC_SPAN_COMPONENTS);
    return s->rgb != NULL;
}

static glint_status make_backend(glint_quadratic_shader *s, const glint_quadratic_config *config,
                                 glint_backend_watch *watch, glint_error *err)
{
    const bool is_same = s->backend != NULL && s->config.kind == config->kind &&
                         s->config.fraction == config->fraction;
    if (is_same)
        return GLINT_OK;
    glint_quadratic_backend_destroy(s->backend);
    s->backend = NULL;
    s->config = *config;
    if (is_exact(config))
        return GLINT_OK;
    const glint_status status = glint_quadratic_backend_create(config, &s->backend, err);
    if (status == GLINT_OK)
        glint_quadratic_backend_set_watch(s->backend, watch);
    s->longest = (uint32_t)glint_quadratic_span_longest(config->fraction);
    return status;
}

glint_status glint_quadratic_shader_prepare(glint_quadratic_shader **shader, int32_t width,
                                            const glint_quadratic_config *config,
                                            glint_backend_watch *watch, glint_error *err)
{
    if (*shader == NULL)
        *shader = calloc(1, sizeof **shader);
    glint_quadratic_shader *s = *shader;
    if (s == NULL || !make_room(s, width))
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a band %d pixels wide",
                          width);
    const glint_status status = make_backend(s, config, watch, err);
    s->spans = 0;
    s->clocks_before = s->backend != NULL ? glint_quadratic_backend_clocks(s->backend) : 0;
    return status;
}

void glint_quadratic_shader_destroy(glint_quadratic_shader *shader)
{
    if (shader == NULL)
        return;
    glint_quadratic_backend_destroy(shader->backend);
    free(shader->rgb);
    free(shader);
}

void glint_quadratic_shader_watch(glint_quadratic_shader *shader, glint_backend_watch *watch)
{
    if (shader != NULL && shader->backend != NULL)
        glint_quadratic_backend_set_watch(shader->backend, watch);
}

uint64_t glint_quadratic_shader_spans(const glint_quadratic_shader *shader)
{
    return shader != NULL ? shader->spans : 0;
}

uint64_t glint_quadratic_shader_clocks(const glint_quadratic_shader *shader)
{
    if (shader == NULL || shader->backend == NULL)
        return 0;
    return glint_quadratic_backend_clocks(shader->backend) - shader->clocks_before;
}

/* ---- Set-up ---------------------------------------------------------------------------------- */

static int64_t code_of(double number, int fraction)
{
    return (int64_t)floor(number * (double)(INT64_C(1) << fraction) + 0.5);
}

/* I(u + du, v + dv) − I(u, v), and what that grows by. */
static double first_difference(const glint_quadratic *q, const glint_weights *w)
{
    const double u = w->at1, v = w->at2, du = w->step1, dv = w->step2;
    return du * (q->c2 + q->c23 * v + 2.0 * q->c12 * (2.0 * u + du)) +
           dv * (q->c3 + q->c23 * (u + du) + 2.0 * q->c13 * (2.0 * v + dv));
}

static double second_difference(const glint_quadratic *q, const glint_weights *w)
{
    const double du = w->step1, dv = w->step2;
    return 4.0 * (q->c12 * du * du + q->c13 * dv * dv) + 2.0 * q->c23 * du * dv;
}

glint_quadratic_walk glint_quadratic_walk_of(const glint_quadratic q[3], const glint_weights *w,
                                             uint32_t length, int fraction)
{
    glint_quadratic_walk walk = {{0}, {0}, {0}};
    for (int c = 0; c < GLINT_QUADRATIC_SPAN_COMPONENTS; c++) {
        walk.start[c] = code_of(glint_quadratic_at(&q[c], w->at1, w->at2), fraction);
        if (length > 1)
            walk.first[c] = code_of(first_difference(&q[c], w), fraction);
        if (length > 2)
            walk.second[c] = code_of(second_difference(&q[c], w), fraction);
    }
    return walk;
}

/* ---- Pieces: the pixels of a row in which one triangle is seen ------------------------------- */

typedef struct piece {
    const glint_triangle *t;
    int32_t y;
    glint_pixels pixels;
} piece;

static void paint_exact(const piece *p, const glint_quadratic q[3], glint_image *image)
{
    const glint_weights w = glint_triangle_weights(p->t, p->pixels.first, p->y);
    uint8_t *values = glint_paint_pixel(image, p->pixels.first, p->y);
    for (int32_t k = 0; k <= p->pixels.last - p->pixels.first; k++) {
        const double u = w.at1 + k * w.step1;
        const double v = w.at2 + k * w.step2;
        for (int c = 0; c < 3; c++)
            *values++ = glint_quadratic_level(glint_quadratic_at(&q[c], u, v));
    }
}

/* Walks what was gathered, and copies it into the picture. */
static glint_status finish(glint_quadratic_shader *s, glint_error *err)
{
    const glint_spans spans = {s->walk, s->length, s->count, s->rgb};
    const glint_status status =
        s->count != 0 ? glint_quadratic_backend_walk(s->backend, &spans, err) : GLINT_OK;
    const uint8_t *from = s->rgb;
    for (size_t i = 0; status == GLINT_OK && i < s->count; i++) {
        const size_t bytes = GLINT_QUADRATIC_SPAN_COMPONENTS * (size_t)s->length[i];
        memcpy(s->place[i], from, bytes);
        from += bytes;
    }
    s->spans += s->count;
    s->count = 0;
    return status;
}

static glint_status add_piece(glint_quadratic_shader *s, const piece *p, const glint_quadratic q[3],
                              glint_image *image, glint_error *err)
{
    int32_t x = p->pixels.first;
    glint_status status = GLINT_OK;
    while (status == GLINT_OK && x <= p->pixels.last) {
        const uint32_t left = (uint32_t)(p->pixels.last - x + 1);
        const uint32_t length = left < s->longest ? left : s->longest;
        const glint_weights w = glint_triangle_weights(p->t, x, p->y);
        s->walk[s->count] = glint_quadratic_walk_of(q, &w, length, s->config.fraction);
        s->length[s->count] = length;
        s->place[s->count++] = glint_paint_pixel(image, x, p->y);
        x += (int32_t)length;
        if (s->count == JOBS)
            status = finish(s, err);
    }
    return status;
}

static glint_status shade_piece(glint_quadratic_shader *s, const piece *p, glint_image *image,
                                glint_error *err)
{
    glint_quadratic q[3];
    for (int c = 0; c < 3; c++)
        q[c] = glint_quadratic_of_triangle(p->t, c);
    if (s->backend != NULL)
        return add_piece(s, p, q, image, err);
    paint_exact(p, q, image);
    return GLINT_OK;
}

glint_status glint_quadratic_band(glint_quadratic_shader *shader, const glint_visibility *band,
                                  glint_image *image, uint64_t *fragments, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int32_t y = band->first_y; status == GLINT_OK && y <= band->last_y; y++) {
        glint_paint_begin_row(image, y);
        int32_t x = 0;
        piece p = {.y = y};
        while (status == GLINT_OK &&
               (p.t = glint_visible_next(band, image->width, y, &x, &p.pixels)) != NULL) {
            *fragments += glint_paint_mark(image, y, p.pixels);
            status = shade_piece(shader, &p, image, err);
        }
    }
    return status == GLINT_OK ? finish(shader, err) : status;
}
