/* Gouraud's shading of a band: which triangles are seen, their edges' runs to the divider, then the
 * runs of their rows. Only the segments that visible pixels need are divided and walked. */
#include "render/gouraud.h"

#include <stdlib.h>
#include <string.h>

/* Segments that go to the divider together. */
#define JOBS 4096

/* A triangle seen in the band. */
typedef struct seen_triangle {
    const glint_triangle *t;
    int32_t first_y, last_y;           /* rows in which it is seen */
    size_t place;                      /* in the table */
    uint8_t left[GLINT_BAND_ROWS][3];  /* intensities on its sides at the band's rows, */
    uint8_t right[GLINT_BAND_ROWS][3]; /* set from first_y to last_y */
} seen_triangle;

/* Pixels of a row in which one triangle is seen. */
typedef struct piece {
    uint32_t triangle;
    int32_t y;
    glint_pixels pixels;
} piece;

/* A segment that waits for its quotients. */
typedef struct job {
    glint_run segment;
    int32_t first, last; /* places whose values are asked for */
    uint8_t *values;
} job;

struct glint_gouraud {
    size_t pixels; /* of a band */
    seen_triangle *triangle;
    size_t triangle_count;
    piece *piece;
    size_t piece_count;
    uint32_t *table; /* hash table: a triangle's number in `triangle` + 1, or 0 */
    size_t table_mask;
    job job[JOBS];
    glint_division division[JOBS];
    glint_quotients quotients[JOBS];
    size_t job_count;
};

/* What is interpolated at the moment: edges or rows of one band. */
typedef struct pass {
    glint_gouraud *gouraud;
    glint_divider_backend *divider; /* NULL: exact */
    int shifts;
    glint_operations *increments, *points;
    glint_error *err;
} pass;

glint_gouraud *glint_gouraud_create(int32_t width)
{
    glint_gouraud *g = calloc(1, sizeof *g);
    if (g == NULL) {
        return NULL;
    }
    g->pixels = (size_t)width * GLINT_BAND_ROWS;
    size_t places = 64;
    while (places < 2 * g->pixels) {
        places *= 2;
    }
    g->table_mask = places - 1;
    g->triangle = malloc(g->pixels * sizeof *g->triangle);
    g->piece = malloc(g->pixels * sizeof *g->piece);
    g->table = calloc(places, sizeof *g->table);
    if (g->triangle == NULL || g->piece == NULL || g->table == NULL) {
        glint_gouraud_destroy(g);
        return NULL;
    }
    return g;
}

void glint_gouraud_destroy(glint_gouraud *gouraud)
{
    if (gouraud == NULL) {
        return;
    }
    free(gouraud->triangle);
    free(gouraud->piece);
    free(gouraud->table);
    free(gouraud);
}

/* The number of a triangle seen in row y, the next free one when it is new. Numbers are in the
 * order in which triangles are first seen, wherever in memory they are. */
static uint32_t number_of(glint_gouraud *g, const glint_triangle *t, int32_t y)
{
    const uint64_t key = (uint64_t)((uintptr_t)t / sizeof *t);
    size_t place = (size_t)((key * 0x9E3779B97F4A7C15u) >> 32) & g->table_mask;
    while (g->table[place] != 0 && g->triangle[g->table[place] - 1].t != t) {
        place = (place + 1) & g->table_mask;
    }
    if (g->table[place] == 0) {
        seen_triangle *created = &g->triangle[g->triangle_count++];
        created->t = t;
        created->first_y = y;
        created->place = place;
        g->table[place] = (uint32_t)g->triangle_count;
    }
    const uint32_t number = g->table[place] - 1;
    g->triangle[number].last_y = y;
    return number;
}

static void begin_row(glint_image *image, int32_t y)
{
    const size_t row = (size_t)y * (size_t)image->width;
    memset(&image->rgb[3 * row], 0, 3 * (size_t)image->width);
    memset(&image->object[row], 0, (size_t)image->width);
}

/* Marks pixels of row y as the object's; returns how many. */
static uint64_t mark(glint_image *image, int32_t y, glint_pixels pixels)
{
    const size_t count = (size_t)(pixels.last - pixels.first + 1);
    memset(&image->object[(size_t)y * (size_t)image->width + (size_t)pixels.first], 1, count);
    return count;
}

static uint8_t *pixel_at(const glint_image *image, int32_t x, int32_t y)
{
    return &image->rgb[3 * ((size_t)y * (size_t)image->width + (size_t)x)];
}

/* Finds what is seen in the band. Returns the number of fragments. */
static uint64_t gather(glint_gouraud *g, const glint_visibility *band, glint_image *image)
{
    uint64_t fragments = 0;
    for (size_t i = 0; i < g->triangle_count; i++) {
        g->table[g->triangle[i].place] = 0;
    }
    g->triangle_count = 0;
    g->piece_count = 0;
    for (int32_t y = band->first_y; y <= band->last_y; y++) {
        begin_row(image, y);
        int32_t x = 0;
        glint_pixels pixels;
        const glint_triangle *t;
        while ((t = glint_visible_next(band, image->width, y, &x, &pixels)) != NULL) {
            g->piece[g->piece_count++] = (piece){number_of(g, t, y), y, pixels};
            fragments += mark(image, y, pixels);
        }
    }
    return fragments;
}

/* Divides for all jobs that wait, and walks them. */
static glint_status finish_jobs(const pass *p)
{
    glint_gouraud *g = p->gouraud;
    if (g->job_count == 0) {
        return GLINT_OK;
    }
    const glint_status status =
        glint_divider_backend_divide(p->divider, g->division, g->job_count, g->quotients, p->err);
    for (size_t i = 0; status == GLINT_OK && i < g->job_count; i++) {
        const job *j = &g->job[i];
        glint_run_walk(&j->segment, p->shifts, &g->quotients[i], j->first, j->last, j->values,
                       p->points);
    }
    g->job_count = 0;
    return status;
}

/* The values of one segment at places first … last, at once or with the jobs. */
static glint_status add_segment(const pass *p, const glint_run *segment, int32_t first,
                                int32_t last, uint8_t *values)
{
    glint_gouraud *g = p->gouraud;
    if (!glint_run_set_up(segment, &g->division[g->job_count], p->increments)) {
        memcpy(values, segment->from, 3);
        return GLINT_OK;
    }
    g->job[g->job_count++] = (job){*segment, first, last, values};
    return g->job_count < JOBS ? GLINT_OK : finish_jobs(p);
}

/* The values of a run at places first … last, three bytes each; they are there after
 * finish_jobs(). */
static glint_status add_run(const pass *p, const glint_run *run, int32_t first, int32_t last,
                            uint8_t *values)
{
    if (p->divider == NULL) {
        glint_run_exact(run, first, last, values);
        return GLINT_OK;
    }
    glint_status status = GLINT_OK;
    int32_t index = glint_run_segment_at(run, first);
    for (int32_t place = first; status == GLINT_OK && place <= last; index++) {
        const glint_run segment = glint_run_segment(run, index);
        const bool ends_here = index == glint_run_segment_at(run, last);
        const int32_t until = ends_here ? last : segment.end - 1;
        status = add_segment(p, &segment, place, until, values + 3 * (size_t)(place - first));
        place = until + 1;
    }
    return status;
}

/* One edge from its upper corner to its lower one, at rows first … last, if there are any. values
 * begin with row band_y. */
static glint_status add_edge(const pass *p, const glint_triangle *t, int upper, int lower,
                             int32_t first, int32_t last, uint8_t (*values)[3], int32_t band_y)
{
    if (first > last) {
        return GLINT_OK;
    }
    glint_run run = {.start = glint_first_sample(t->y[upper]),
                     .end = glint_last_sample(t->y[lower])};
    memcpy(run.from, t->color[upper], 3);
    memcpy(run.to, t->color[lower], 3);
    return add_run(p, &run, first, last, values[first - band_y]);
}

/* A triangle's sides: the long one from the top to the bottom corner, and the two edges by way of
 * the middle one. A row through the middle corner itself belongs to the lower of the two. */
static glint_status add_sides(const pass *p, seen_triangle *s, int32_t band_y)
{
    const glint_triangle *t = s->t;
    int top = 0;
    int bottom = 0;
    for (int i = 1; i < 3; i++) {
        top = t->y[i] < t->y[top] ? i : top;
        bottom = t->y[i] >= t->y[bottom] ? i : bottom;
    }
    const int middle = 3 - top - bottom;
    const bool middle_right = (top + 1) % 3 == middle; /* corners run clockwise */
    uint8_t(*bent)[3] = middle_right ? s->right : s->left;
    uint8_t(*straight)[3] = middle_right ? s->left : s->right;
    const int32_t at_middle = glint_first_sample(t->y[middle]);
    const int32_t upper_last = s->last_y < at_middle - 1 ? s->last_y : at_middle - 1;
    const int32_t lower_first = s->first_y > at_middle ? s->first_y : at_middle;
    glint_status status = add_edge(p, t, top, bottom, s->first_y, s->last_y, straight, band_y);
    if (status == GLINT_OK) {
        status = add_edge(p, t, top, middle, s->first_y, upper_last, bent, band_y);
    }
    if (status == GLINT_OK) {
        status = add_edge(p, t, middle, bottom, lower_first, s->last_y, bent, band_y);
    }
    return status;
}

static glint_status add_row(const pass *p, const piece *seen, int32_t band_y, glint_image *image)
{
    const seen_triangle *s = &p->gouraud->triangle[seen->triangle];
    const glint_pixels covered = glint_triangle_pixels(s->t, seen->y);
    glint_run run = {.start = covered.first, .end = covered.last};
    memcpy(run.from, s->left[seen->y - band_y], 3);
    memcpy(run.to, s->right[seen->y - band_y], 3);
    return add_run(p, &run, seen->pixels.first, seen->pixels.last,
                   pixel_at(image, seen->pixels.first, seen->y));
}

glint_status glint_gouraud_band(glint_gouraud *gouraud, const glint_visibility *band,
                                glint_divider_backend *divider, int shifts, glint_image *image,
                                uint64_t *fragments, glint_span_operations *operations,
                                glint_error *err)
{
    *fragments += gather(gouraud, band, image);
    pass p = {
        .gouraud = gouraud,
        .divider = divider,
        .shifts = shifts,
        .increments = &operations->stage[GLINT_SPAN_EDGE_INCREMENTS],
        .points = &operations->stage[GLINT_SPAN_EDGE_POINTS],
        .err = err,
    };
    gouraud->job_count = 0;
    glint_status status = GLINT_OK;
    for (size_t i = 0; status == GLINT_OK && i < gouraud->triangle_count; i++) {
        status = add_sides(&p, &gouraud->triangle[i], band->first_y);
    }
    if (status == GLINT_OK) {
        status = finish_jobs(&p);
    }
    p.increments = &operations->stage[GLINT_SPAN_ROW_INCREMENTS];
    p.points = &operations->stage[GLINT_SPAN_ROW_POINTS];
    for (size_t i = 0; status == GLINT_OK && i < gouraud->piece_count; i++) {
        status = add_row(&p, &gouraud->piece[i], band->first_y, image);
    }
    return status == GLINT_OK ? finish_jobs(&p) : status;
}

void glint_flat_band(const glint_visibility *band, glint_image *image, uint64_t *fragments)
{
    for (int32_t y = band->first_y; y <= band->last_y; y++) {
        begin_row(image, y);
        int32_t x = 0;
        glint_pixels pixels;
        const glint_triangle *t;
        while ((t = glint_visible_next(band, image->width, y, &x, &pixels)) != NULL) {
            *fragments += mark(image, y, pixels);
            for (int32_t at = pixels.first; at < x; at++) {
                memcpy(pixel_at(image, at, y), t->color[0], 3);
            }
        }
    }
}

/* I = (Σ weight·I/w) / (Σ weight/w), where numerator and denominator are linear on the screen. */
static void perspective_pixels(const glint_triangle *t, int32_t y, glint_pixels pixels,
                               uint8_t *values)
{
    const glint_weights w = glint_triangle_weights(t, pixels.first, y);
    for (int32_t k = 0; k <= pixels.last - pixels.first; k++) {
        const double b1 = (w.at1 + k * w.step1) * (double)t->inv_w[1];
        const double b2 = (w.at2 + k * w.step2) * (double)t->inv_w[2];
        const double b0 =
            (1.0 - (w.at1 + k * w.step1) - (w.at2 + k * w.step2)) * (double)t->inv_w[0];
        const double inv_sum = 1.0 / (b0 + b1 + b2);
        for (int c = 0; c < 3; c++) {
            const double value =
                (b0 * t->color[0][c] + b1 * t->color[1][c] + b2 * t->color[2][c]) * inv_sum;
            *values++ = (uint8_t)(value + 0.5);
        }
    }
}

void glint_perspective_band(const glint_visibility *band, glint_image *image, uint64_t *fragments)
{
    for (int32_t y = band->first_y; y <= band->last_y; y++) {
        begin_row(image, y);
        int32_t x = 0;
        glint_pixels pixels;
        const glint_triangle *t;
        while ((t = glint_visible_next(band, image->width, y, &x, &pixels)) != NULL) {
            *fragments += mark(image, y, pixels);
            perspective_pixels(t, y, pixels, pixel_at(image, pixels.first, y));
        }
    }
}
