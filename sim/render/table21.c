/* The operations of Table 2.1, counted while they are done on the thesis's triangle. */
#include <stdlib.h>
#include <string.h>

#include "render/gouraud.h"

/* A, B and C in pixels, A on top. Clockwise as seen they are A, C, B. */
typedef struct corner {
    int32_t x, y;
    uint8_t color[3];
} corner;

static const corner corners[3] = {
    {8, 1, {250, 40, 10}},  /* A */
    {1, 9, {20, 90, 200}},  /* B: 7 to the left, 8 down */
    {17, 13, {130, 5, 75}}, /* C: 9 to the right, 12 down */
};

#define SIDE 24

static int32_t lesser(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static int32_t greater(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

static double triangle_area(void)
{
    const corner *a = &corners[0], *b = &corners[1], *c = &corners[2];
    return 0.5 * abs((b->x - a->x) * (c->y - a->y) - (b->y - a->y) * (c->x - a->x));
}

/* The triangle as the set-up of a frame would have it, on pixel centres. */
static glint_triangle screen_triangle(void)
{
    static const int order[3] = {0, 2, 1};
    glint_triangle t = {.first_x = SIDE, .first_y = SIDE, .inv_area = 1.0};
    for (int i = 0; i < 3; i++) {
        const corner *from = &corners[order[i]];
        t.x[i] = from->x * GLINT_SUBPIXEL_ONE + GLINT_SUBPIXEL_HALF;
        t.y[i] = from->y * GLINT_SUBPIXEL_ONE + GLINT_SUBPIXEL_HALF;
        t.first_x = lesser(t.first_x, from->x);
        t.last_x = greater(t.last_x, from->x);
        t.first_y = lesser(t.first_y, from->y);
        t.last_y = greater(t.last_y, from->y);
        t.inv_w[i] = 1.0f;
        for (int c = 0; c < 3; c++)
            t.color[i][c] = from->color[c];
    }
    return t;
}

static void count_rows(const glint_image *image, glint_table_21 *table)
{
    for (int y = 0; y < image->height; y++) {
        int in_row = 0;
        for (int x = 0; x < image->width; x++)
            in_row += image->object[y * image->width + x];
        table->drawn_rows += in_row > 0;
    }
}

/* One band of a frame with nothing but the triangle. */
static glint_status draw(glint_gouraud *gouraud, const glint_visibility *band,
                         glint_divider_backend *divider, int shifts, glint_table_21 *table,
                         glint_error *err)
{
    glint_image *image = NULL;
    glint_status status = glint_image_create(SIDE, GLINT_BAND_ROWS, &image, err);
    if (status == GLINT_OK) {
        status = glint_gouraud_band(gouraud, band, divider, shifts, image, &table->drawn_pixels,
                                    &table->drawn, err);
    }
    if (status == GLINT_OK)
        count_rows(image, table);
    glint_image_destroy(image);
    return status;
}

static glint_status count_drawn(glint_divider_backend *divider, int shifts, glint_table_21 *table,
                                glint_error *err)
{
    const glint_extent extent = {SIDE, GLINT_BAND_ROWS};
    glint_triangle t = screen_triangle();
    const glint_triangle_list list = {&t, 1, 1, t.first_y, t.last_y};
    glint_visibility band;
    glint_visibility_create(&band, SIDE);
    glint_gouraud *gouraud = glint_gouraud_create(SIDE);
    glint_status status;
    if (gouraud == NULL || band.depth == NULL || band.triangle == NULL) {
        status = glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a triangle");
    } else {
        glint_visibility_begin(&band, extent, 0, GLINT_BAND_ROWS - 1);
        glint_visibility_draw(&band, extent, &list);
        status = draw(gouraud, &band, divider, shifts, table, err);
    }
    glint_gouraud_destroy(gouraud);
    glint_visibility_destroy(&band);
    return status;
}

/* The thesis's walk. */
typedef struct walk {
    glint_divider_backend *divider;
    int shifts;
    glint_table_21 *table;
    uint8_t row_end[2][SIDE][3]; /* intensities where the row's left and right end meet the edges */
    glint_error *err;
} walk;

/* Twice the area of p, q and the point (x, y): positive to the right of the way from p to q, y
 * down. */
static int32_t side_of(const corner *p, const corner *q, int32_t x, int32_t y)
{
    return (q->x - p->x) * (y - p->y) - (q->y - p->y) * (x - p->x);
}

static bool strictly_inside(int32_t x, int32_t y)
{
    return side_of(&corners[0], &corners[2], x, y) > 0 &&
           side_of(&corners[2], &corners[1], x, y) > 0 &&
           side_of(&corners[1], &corners[0], x, y) > 0;
}

/* The columns of a row's ends: those next to the points inside. */
static glint_pixels row_ends(int32_t y)
{
    glint_pixels ends = {SIDE, 0};
    for (int32_t x = 0; x < SIDE; x++) {
        if (strictly_inside(x, y)) {
            ends.first = lesser(ends.first, x - 1);
            ends.last = greater(ends.last, x + 1);
        }
    }
    return ends;
}

/* The values between the ends of a run: one division, and an addition for each point. */
static glint_status walk_run(const walk *w, const glint_run *run, glint_span_stage increments,
                             glint_span_stage points, uint8_t *values)
{
    glint_division division;
    glint_quotients quotients = {{0}, false};
    glint_status status = GLINT_OK;
    if (glint_run_set_up(run, &division, &w->table->described.stage[increments]))
        status = glint_divider_backend_divide(w->divider, &division, 1, &quotients, w->err);
    if (status == GLINT_OK && run->end - run->start > 1) {
        glint_run_walk(run, w->shifts, &quotients, run->start + 1, run->end - 1, values,
                       &w->table->described.stage[points]);
    }
    return status;
}

/* Walks the edge from p down to q by the longer of its two extents, and notes its values at the
 * ends of rows p.y+1 … last_y on that side (0 left, 1 right). */
static glint_status walk_edge(walk *w, const corner *p, const corner *q, int side, int32_t last_y)
{
    const int32_t across = abs(q->x - p->x);
    const int32_t down = q->y - p->y;
    glint_run run = {.end = greater(across, down)};
    uint8_t values[GLINT_DIVIDER_K_MAX + 1][3];
    memcpy(run.from, p->color, 3);
    memcpy(run.to, q->color, 3);
    memcpy(values[0], p->color, 3);
    memcpy(values[run.end], q->color, 3);
    const glint_status status =
        walk_run(w, &run, GLINT_SPAN_EDGE_INCREMENTS, GLINT_SPAN_EDGE_POINTS, values[1]);
    w->table->described_edge_points += (uint64_t)(run.end - 1);
    for (int32_t y = p->y + 1; status == GLINT_OK && y <= last_y; y++) {
        const glint_pixels ends = row_ends(y);
        const int32_t column = side == 0 ? ends.first : ends.last;
        const int32_t step = across > down ? abs(column - p->x) : y - p->y;
        memcpy(w->row_end[side][y], values[step], 3);
    }
    return status;
}

static glint_status walk_row(const walk *w, int32_t y)
{
    const glint_pixels ends = row_ends(y);
    glint_run run = {.start = ends.first, .end = ends.last};
    uint8_t values[SIDE][3];
    memcpy(run.from, w->row_end[0][y], 3);
    memcpy(run.to, w->row_end[1][y], 3);
    w->table->described_rows++;
    w->table->described_pixels += (uint64_t)(ends.last - ends.first - 1);
    return walk_run(w, &run, GLINT_SPAN_ROW_INCREMENTS, GLINT_SPAN_ROW_POINTS, values[0]);
}

static glint_status count_described(glint_divider_backend *divider, int shifts,
                                    glint_table_21 *table, glint_error *err)
{
    const corner *a = &corners[0];
    const corner *b = &corners[1];
    const corner *c = &corners[2];
    walk w = {.divider = divider, .shifts = shifts, .table = table, .err = err};
    glint_status status = walk_edge(&w, a, b, 0, b->y);
    if (status == GLINT_OK)
        status = walk_edge(&w, b, c, 0, c->y - 1);
    if (status == GLINT_OK)
        status = walk_edge(&w, a, c, 1, c->y - 1);
    for (int32_t y = a->y + 1; status == GLINT_OK && y < c->y; y++)
        status = walk_row(&w, y);
    return status;
}

glint_status glint_count_table_21(int shifts, glint_table_21 *table, glint_error *err)
{
    const glint_divider_config config = {
        .kind = GLINT_BACKEND_C, .form = GLINT_DIVIDER_PIPELINED, .shifts = shifts};
    glint_divider_backend *divider = NULL;
    *table = (glint_table_21){.area = triangle_area()};
    glint_status status = glint_divider_backend_create(&config, &divider, err);
    if (status == GLINT_OK)
        status = count_drawn(divider, shifts, table, err);
    if (status == GLINT_OK)
        status = count_described(divider, shifts, table, err);
    glint_divider_backend_destroy(divider);
    return status;
}
