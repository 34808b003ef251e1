/* Which pixels are traced: a grid first, then, level by level, what halving asks for. A segment is
 * a box of one row, so that segments and blocks go the same way. */
#include "trace/join.h"

#include <math.h>
#include <stdlib.h>

#include "trace/fill.h"

/* Pixels that are traced together at most: enough for every thread, little beside the frame. */
#define TOGETHER ((size_t)1 << 18)

typedef struct box_list {
    glint_box *box;
    size_t count, capacity;
} box_list;

/* An image in the making. */
typedef struct joining {
    const glint_join *how;
    glint_join_trace *trace;
    void *context;
    glint_image *image;
    uint8_t *traced;                 /* of each pixel: it is, or is asked for */
    uint32_t *pixel;                 /* asked for */
    size_t asked;                    /* how many */
    box_list judged, halves, filled; /* of this level, of the next, and those to interpolate */
    glint_join_stats stats;
    glint_status status;
    glint_error *err;
} joining;

glint_status glint_join_check(const glint_join *how, glint_error *err)
{
    if ((unsigned)how->fill >= GLINT_FILL_COUNT || (unsigned)how->measure >= GLINT_MEASURE_COUNT)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "segments: unknown fill or measure");
    if (how->segment < 0 || how->segment > GLINT_SEGMENT_MAX || how->centre < -1 ||
        how->centre > GLINT_SEGMENT_MAX) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "segments: a length is not from 0 to %d",
                          GLINT_SEGMENT_MAX);
    }
    if (!(how->limit >= 0.0))
        return glint_fail(err, GLINT_BAD_ARGUMENT, "segments: the limit %g is below 0", how->limit);
    if (how->centre >= 0 && glint_fill_is_of_blocks(how->fill)) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "segments: a length of its own for the centre needs a fill along rows");
    }
    return GLINT_OK;
}

static void flush(joining *j)
{
    if (j->status == GLINT_OK && j->asked > 0)
        j->status = j->trace(j->context, j->pixel, j->asked, j->image, j->err);
    j->asked = 0;
}

static void ask(joining *j, int x, int y)
{
    const size_t at = (size_t)y * (size_t)j->image->width + (size_t)x;
    if (j->traced[at])
        return;
    j->traced[at] = 1;
    j->stats.traced++;
    j->pixel[j->asked++] = (uint32_t)at;
    if (j->asked == TOGETHER)
        flush(j);
}

/* Appends a box, if it has inner pixels. */
static void append(joining *j, box_list *list, glint_box box)
{
    if ((box.right - box.left < 2 && box.bottom - box.top < 2) || j->status != GLINT_OK)
        return;
    if (list->count == list->capacity) {
        const size_t capacity = list->capacity > 0 ? 2 * list->capacity : 1024;
        glint_box *more = realloc(list->box, capacity * sizeof *more);
        if (more == NULL) {
            j->status =
                glint_fail(j->err, GLINT_NO_MEMORY, "not enough memory for %zu segments", capacity);
            return;
        }
        list->box = more;
        list->capacity = capacity;
    }
    list->box[list->count++] = box;
}

/* ---- The grid -------------------------------------------------------------------------------- */

static bool in_middle(int at, int size)
{
    return 4 * at >= size && 4 * at < 3 * size;
}

/* The traced pixel after x in row y: as far as a segment reaches, at most the last of the row. */
static int next_of_row(const joining *j, int x, int y)
{
    const bool centre =
        j->how->centre >= 0 && in_middle(x, j->image->width) && in_middle(y, j->image->height);
    const int next = x + (centre ? j->how->centre : j->how->segment) + 1;
    return next < j->image->width ? next : j->image->width - 1;
}

static void begin_rows(joining *j)
{
    for (int y = 0; y < j->image->height; y++) {
        const uint16_t row = (uint16_t)y;
        int next = 0;
        ask(j, 0, y);
        for (int x = 0; x < j->image->width - 1; x = next) {
            next = next_of_row(j, x, y);
            ask(j, next, y);
            append(j, &j->judged, (glint_box){(uint16_t)x, (uint16_t)next, row, row});
        }
    }
}

static int step(int at, int segment, int size)
{
    return at + segment + 1 < size ? at + segment + 1 : size - 1;
}

/* The blocks of the rows top … bottom; where a frame is one pixel wide or high, so are they. */
static void begin_strip(joining *j, int top, int bottom)
{
    const int width = j->image->width;
    int x = 0;
    do {
        const int next = step(x, j->how->segment, width);
        ask(j, x, top);
        ask(j, next, top);
        ask(j, x, bottom);
        ask(j, next, bottom);
        append(j, &j->judged,
               (glint_box){(uint16_t)x, (uint16_t)next, (uint16_t)top, (uint16_t)bottom});
        x = next;
    } while (x < width - 1);
}

static void begin_blocks(joining *j)
{
    const int height = j->image->height;
    int y = 0;
    do {
        const int next = step(y, j->how->segment, height);
        begin_strip(j, y, next);
        y = next;
    } while (y < height - 1);
}

/* ---- Judging and halving --------------------------------------------------------------------- */

static const uint8_t *color_at(const joining *j, int x, int y)
{
    return &j->image->rgb[3 * ((size_t)y * (size_t)j->image->width + (size_t)x)];
}

/* InterpolOK: no two of the corners are further apart than the limit. */
static bool interpol_ok(const joining *j, const glint_box *box)
{
    const uint8_t *corner[4] = {color_at(j, box->left, box->top), color_at(j, box->right, box->top),
                                color_at(j, box->left, box->bottom),
                                color_at(j, box->right, box->bottom)};
    const int corners = box->top == box->bottom ? 2 : 4;
    if (isinf(j->how->limit))
        return true;
    for (int a = 0; a < corners; a++)
        for (int b = a + 1; b < corners; b++)
            if (glint_measure_of(j->how->measure, corner[a], corner[b]) > j->how->limit)
                return false;
    return true;
}

/* Both ends and what is between, if anything is. Returns how many. */
static int cut(uint16_t first, uint16_t last, uint16_t at[3])
{
    int count = 0;
    at[count++] = first;
    if (last - first >= 2)
        at[count++] = (uint16_t)((first + last) / 2);
    if (last > first)
        at[count++] = last;
    return count;
}

/* Asks for the pixels half way, and has the parts judged on the next level. */
static void halve(joining *j, const glint_box *box)
{
    uint16_t x[3], y[3];
    const int columns = cut(box->left, box->right, x);
    const int rows = cut(box->top, box->bottom, y);
    for (int row = 0; row < rows; row++)
        for (int column = 0; column < columns; column++)
            ask(j, x[column], y[row]);
    for (int row = 0; row == 0 || row < rows - 1; row++)
        for (int column = 0; column == 0 || column < columns - 1; column++)
            append(j, &j->halves,
                   (glint_box){x[column], columns > 1 ? x[column + 1] : x[column], y[row],
                               rows > 1 ? y[row + 1] : y[row]});
}

static void judge_all(joining *j)
{
    flush(j);
    while (j->judged.count > 0 && j->status == GLINT_OK) {
        const uint64_t before = j->stats.traced;
        j->halves.count = 0;
        for (size_t i = 0; i < j->judged.count; i++)
            if (interpol_ok(j, &j->judged.box[i]))
                append(j, &j->filled, j->judged.box[i]);
            else
                halve(j, &j->judged.box[i]);
        j->stats.levels += j->stats.traced > before;
        flush(j);
        const box_list done = j->judged;
        j->judged = j->halves;
        j->halves = done;
    }
}

static void join(joining *j)
{
    const size_t pixels = (size_t)j->image->width * (size_t)j->image->height;
    if (glint_fill_is_of_blocks(j->how->fill))
        begin_blocks(j);
    else
        begin_rows(j);
    judge_all(j);
    if (j->status != GLINT_OK)
        return;
    j->stats.segments = j->filled.count;
    j->stats.filled = pixels - j->stats.traced;
    j->status =
        glint_fill_boxes(j->how->fill, j->filled.box, j->filled.count, j->traced, j->image, j->err);
}

glint_status glint_join_image(const glint_join *how, glint_join_trace *trace, void *context,
                              glint_image *image, glint_join_stats *stats, glint_error *err)
{
    const size_t pixels = (size_t)image->width * (size_t)image->height;
    joining j = {.how = how, .trace = trace, .context = context, .image = image, .err = err};
    j.status = glint_join_check(how, err);
    if (j.status != GLINT_OK)
        return j.status;
    j.traced = calloc(pixels, sizeof *j.traced);
    j.pixel = malloc((pixels < TOGETHER ? pixels : TOGETHER) * sizeof *j.pixel);
    if (j.traced != NULL && j.pixel != NULL)
        join(&j);
    else
        j.status = glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a frame of %dx%d",
                              image->width, image->height);
    if (stats != NULL)
        *stats = j.stats;
    free(j.traced);
    free(j.pixel);
    free(j.judged.box);
    free(j.halves.box);
    free(j.filled.box);
    return j.status;
}
