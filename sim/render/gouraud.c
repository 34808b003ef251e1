/* Gouraud's shading of a band: which triangles are seen, their edges' runs to the divider, then the
 * runs of their rows. Only the segments that visible pixels need are divided and walked. */
#include "render/gouraud.h"

#include <stdlib.h>
#include <string.h>

#include "render/paint.h"

/* Segments that go to the divider together. */
#define JOBS 4096

/* A triangle seen in the band. Rows of arrays are the band's. */
typedef struct seen_triangle {
    const glint_triangle *t;
    int32_t first_row, last_row; /* in which it is seen; the arrays hold these and those between */
    size_t place;                /* in the table */
    glint_pixels covered[GLINT_BAND_ROWS];
    uint8_t end[2][GLINT_BAND_ROWS][3]; /* intensities at the left and the right end of each row */
} seen_triangle;

/* Pixels of a row in which one triangle is seen. */
typedef struct piece {
    uint32_t triangle;
    int32_t y;
    glint_pixels pixels;
} piece;

/* The part of an edge's run that lies in one segment. */
typedef struct edge_job {
    glint_run segment;
    seen_triangle *triangle;
    int side;                    /* 0 left, 1 right */
    bool by_rows;                /* the run's places are the frame's rows, else columns */
    int32_t first_row, last_row; /* of the band: those whose ends lie on the segment */
} edge_job;

/* The part of a row's run that lies in one segment. */
typedef struct row_job {
    glint_run segment;
    int32_t first, last; /* columns whose values are needed */
    uint8_t *values;
} row_job;

struct glint_gouraud {
    size_t pixels; /* of a band */
    seen_triangle *triangle;
    size_t triangle_count;
    piece *piece;
    size_t piece_count;
    uint32_t *table; /* hash table: a triangle's number in `triangle` + 1, or 0 */
    size_t table_mask;
    edge_job edge[JOBS];
    row_job row[JOBS];
    glint_division division[JOBS];
    glint_quotients quotients[JOBS];
    size_t job_count; /* of `edge` or of `row`: one after the other is done */
};

/* What is interpolated at the moment: edges or rows of one band. */
typedef struct pass {
    glint_gouraud *gouraud;
    int32_t band_y;
    glint_divider_backend *divider; /* NULL: exact */
    int shifts;
    glint_operations *increments, *points;
    glint_error *err;
} pass;

glint_gouraud *glint_gouraud_create(int32_t width)
{
    glint_gouraud *g = calloc(1, sizeof *g);
    if (g == NULL)
        return NULL;
    g->pixels = (size_t)width * GLINT_BAND_ROWS;
    size_t places = 64;
    while (places < 2 * g->pixels)
        places *= 2;
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
    if (gouraud == NULL)
        return;
    free(gouraud->triangle);
    free(gouraud->piece);
    free(gouraud->table);
    free(gouraud);
}

/* The number of a triangle seen in a row of the band, or the next free number if it is new. Numbers
 * follow the order in which triangles are first seen, not their place in memory. */
static uint32_t number_of(glint_gouraud *g, const glint_triangle *t, int32_t row)
{
    const uint64_t key = (uint64_t)((uintptr_t)t / sizeof *t);
    size_t place = (size_t)((key * 0x9E3779B97F4A7C15u) >> 32) & g->table_mask;
    while (g->table[place] != 0 && g->triangle[g->table[place] - 1].t != t)
        place = (place + 1) & g->table_mask;
    if (g->table[place] == 0) {
        seen_triangle *created = &g->triangle[g->triangle_count++];
        created->t = t;
        created->first_row = row;
        created->place = place;
        g->table[place] = (uint32_t)g->triangle_count;
    }
    const uint32_t number = g->table[place] - 1;
    g->triangle[number].last_row = row;
    return number;
}

/* Finds what is seen in the band. Returns the number of fragments. */
static uint64_t gather(glint_gouraud *g, const glint_visibility *band, glint_image *image)
{
    uint64_t fragments = 0;
    for (size_t i = 0; i < g->triangle_count; i++)
        g->table[g->triangle[i].place] = 0;
    g->triangle_count = 0;
    g->piece_count = 0;
    for (int32_t y = band->first_y; y <= band->last_y; y++) {
        int32_t x = 0;
        glint_pixels pixels;
        const glint_triangle *t;
        while ((t = glint_visible_next(band, image->width, y, &x, &pixels)) != NULL) {
            g->piece[g->piece_count++] = (piece){number_of(g, t, y - band->first_y), y, pixels};
            fragments += glint_paint_mark(image, y, pixels);
        }
    }
    return fragments;
}

static glint_status divide(const pass *p)
{
    glint_gouraud *g = p->gouraud;
    return g->job_count == 0 ? GLINT_OK
                             : glint_divider_backend_divide(p->divider, g->division, g->job_count,
                                                            g->quotients, p->err);
}

/* Where on an edge's run the end of a row lies. An end is a pixel: it may be one beyond the last
 * column that the edge reaches. */
static int32_t place_of(const pass *p, const seen_triangle *s, int side, bool by_rows, int32_t row,
                        const glint_run *run)
{
    if (by_rows)
        return p->band_y + row;
    const int32_t column = side == 0 ? s->covered[row].first : s->covered[row].last;
    const int32_t above = column > run->start ? column : run->start;
    return above < run->end ? above : run->end;
}

static int32_t job_place(const pass *p, const edge_job *j, int32_t row)
{
    return place_of(p, j->triangle, j->side, j->by_rows, row, &j->segment);
}

static void walk_edge(const pass *p, const edge_job *j, const glint_quotients *quotients)
{
    const int32_t one = job_place(p, j, j->first_row); /* columns may run either way */
    const int32_t other = job_place(p, j, j->last_row);
    const int32_t first = one < other ? one : other;
    const int32_t last = one < other ? other : one;
    uint8_t values[GLINT_DIVIDER_K_MAX + 1][3];
    glint_run_walk(&j->segment, p->shifts, quotients, first, last, values[0], p->points);
    for (int32_t row = j->first_row; row <= j->last_row; row++)
        memcpy(j->triangle->end[j->side][row], values[job_place(p, j, row) - first], 3);
}

/* Divides for all edges that wait, and walks them. */
static glint_status finish_edges(const pass *p)
{
    glint_gouraud *g = p->gouraud;
    const glint_status status = divide(p);
    for (size_t i = 0; status == GLINT_OK && i < g->job_count; i++)
        walk_edge(p, &g->edge[i], &g->quotients[i]);
    g->job_count = 0;
    return status;
}

static glint_status add_edge_job(const pass *p, const edge_job *j)
{
    glint_gouraud *g = p->gouraud;
    if (!glint_run_set_up(&j->segment, &g->division[g->job_count], p->increments)) {
        for (int32_t row = j->first_row; row <= j->last_row; row++)
            memcpy(j->triangle->end[j->side][row], j->segment.from, 3);
        return GLINT_OK;
    }
    g->edge[g->job_count++] = *j;
    return g->job_count < JOBS ? GLINT_OK : finish_edges(p);
}

/* An edge as a run along the longer of its two extents (the thesis's greater increment), so that no
 * step jumps over many pixels. */
static glint_run edge_run(const glint_triangle *t, int upper, int lower, bool by_rows)
{
    const int32_t *along = by_rows ? t->y : t->x;
    const int from = along[upper] <= along[lower] ? upper : lower;
    const int to = upper + lower - from;
    glint_run run = {.start = glint_first_sample(along[from]), .end = glint_last_sample(along[to])};
    if (run.end < run.start) /* between two columns */
        run.end = run.start;
    memcpy(run.from, t->color[from], 3);
    memcpy(run.to, t->color[to], 3);
    return run;
}

/* The intensities of one edge where it is the end of rows first … last, if there are any. */
static glint_status add_edge(const pass *p, seen_triangle *s, int side, int upper, int lower,
                             int32_t first, int32_t last)
{
    const glint_triangle *t = s->t;
    const bool by_rows = t->y[lower] - t->y[upper] >= abs(t->x[lower] - t->x[upper]);
    const glint_run run = edge_run(t, upper, lower, by_rows);
    glint_status status = GLINT_OK;
    int32_t row = first;
    while (status == GLINT_OK && row <= last) {
        const int32_t place = place_of(p, s, side, by_rows, row, &run);
        edge_job j = {.triangle = s, .side = side, .by_rows = by_rows, .first_row = row};
        if (p->divider == NULL) {
            glint_run_exact(&run, place, place, s->end[side][row++]);
            continue;
        }
        const int32_t index = glint_run_segment_at(&run, place);
        do {
            j.last_row = row++;
        } while (row <= last &&
                 index == glint_run_segment_at(&run, place_of(p, s, side, by_rows, row, &run)));
        j.segment = glint_run_segment(&run, index);
        status = add_edge_job(p, &j);
    }
    return status;
}

/* What the triangle covers of each of its rows. One that passes between two pixels of a row counts
 * as in the row above: nothing is seen of it there, and its edges still run one way. */
static void find_covered(seen_triangle *s, int32_t band_y)
{
    for (int32_t row = s->first_row; row <= s->last_row; row++) {
        const glint_pixels covered = glint_triangle_pixels(s->t, band_y + row);
        s->covered[row] = covered.first <= covered.last ? covered : s->covered[row - 1];
    }
}

/* A triangle's sides: the long one from the top to the bottom corner, and the two edges by way of
 * the middle one. A row through the middle corner itself belongs to the lower of the two. */
static glint_status add_sides(const pass *p, seen_triangle *s)
{
    const glint_triangle *t = s->t;
    int top = 0;
    int bottom = 0;
    for (int i = 1; i < 3; i++) {
        top = t->y[i] < t->y[top] ? i : top;
        bottom = t->y[i] >= t->y[bottom] ? i : bottom;
    }
    const int middle = 3 - top - bottom;
    const int bent = (top + 1) % 3 == middle ? 1 : 0; /* corners run clockwise */
    const int32_t at_middle = glint_first_sample(t->y[middle]) - p->band_y;
    const int32_t upper_last = s->last_row < at_middle - 1 ? s->last_row : at_middle - 1;
    const int32_t lower_first = s->first_row > at_middle ? s->first_row : at_middle;
    find_covered(s, p->band_y);
    glint_status status = add_edge(p, s, 1 - bent, top, bottom, s->first_row, s->last_row);
    if (status == GLINT_OK)
        status = add_edge(p, s, bent, top, middle, s->first_row, upper_last);
    if (status == GLINT_OK)
        status = add_edge(p, s, bent, middle, bottom, lower_first, s->last_row);
    return status;
}

/* Divides for all parts of rows that wait, and walks them. */
static glint_status finish_rows(const pass *p)
{
    glint_gouraud *g = p->gouraud;
    const glint_status status = divide(p);
    for (size_t i = 0; status == GLINT_OK && i < g->job_count; i++) {
        const row_job *j = &g->row[i];
        glint_run_walk(&j->segment, p->shifts, &g->quotients[i], j->first, j->last, j->values,
                       p->points);
    }
    g->job_count = 0;
    return status;
}

static glint_status add_row_job(const pass *p, const row_job *j)
{
    glint_gouraud *g = p->gouraud;
    if (!glint_run_set_up(&j->segment, &g->division[g->job_count], p->increments)) {
        memcpy(j->values, j->segment.from, 3);
        return GLINT_OK;
    }
    g->row[g->job_count++] = *j;
    return g->job_count < JOBS ? GLINT_OK : finish_rows(p);
}

/* The pixels of a piece: the whole of the triangle's row is the run, its visible part is asked for.
 */
static glint_status add_row(const pass *p, const piece *seen, glint_image *image)
{
    const int32_t row = seen->y - p->band_y;
    const seen_triangle *s = &p->gouraud->triangle[seen->triangle];
    const int32_t last = seen->pixels.last;
    glint_run run = {.start = s->covered[row].first, .end = s->covered[row].last};
    memcpy(run.from, s->end[0][row], 3);
    memcpy(run.to, s->end[1][row], 3);
    int32_t place = seen->pixels.first;
    uint8_t *values = glint_paint_pixel(image, place, seen->y);
    if (p->divider == NULL) {
        glint_run_exact(&run, place, last, values);
        return GLINT_OK;
    }
    const int32_t last_index = glint_run_segment_at(&run, last);
    glint_status status = GLINT_OK;
    for (int32_t i = glint_run_segment_at(&run, place); status == GLINT_OK && i <= last_index;
         i++) {
        row_job j = {.segment = glint_run_segment(&run, i), .first = place, .values = values};
        j.last = i == last_index ? last : j.segment.end - 1;
        values += 3 * (size_t)(j.last - j.first + 1);
        place = j.last + 1;
        status = add_row_job(p, &j);
    }
    return status;
}

glint_status glint_gouraud_band(glint_gouraud *gouraud, const glint_visibility *band,
                                glint_divider_backend *divider, int shifts, glint_image *image,
                                uint64_t *fragments, glint_span_operations *operations,
                                glint_error *err)
{
    *fragments += gather(gouraud, band, image);
    pass p = {
        .gouraud = gouraud,
        .band_y = band->first_y,
        .divider = divider,
        .shifts = shifts,
        .increments = &operations->stage[GLINT_SPAN_EDGE_INCREMENTS],
        .points = &operations->stage[GLINT_SPAN_EDGE_POINTS],
        .err = err,
    };
    gouraud->job_count = 0;
    glint_status status = GLINT_OK;
    for (size_t i = 0; status == GLINT_OK && i < gouraud->triangle_count; i++)
        status = add_sides(&p, &gouraud->triangle[i]);
    if (status == GLINT_OK)
        status = finish_edges(&p);
    p.increments = &operations->stage[GLINT_SPAN_ROW_INCREMENTS];
    p.points = &operations->stage[GLINT_SPAN_ROW_POINTS];
    for (size_t i = 0; status == GLINT_OK && i < gouraud->piece_count; i++)
        status = add_row(&p, &gouraud->piece[i], image);
    return status == GLINT_OK ? finish_rows(&p) : status;
}
