/* Section 2.6, ray tracing with pixel segments: the counts (2.28) and (2.31), and rays, error and
 * time of traced frames by length, limit and fill. */
#include <math.h>
#include <stdlib.h>

#include "report/chart.h"
#include "report/trace_runs.h"
#include "trace/count.h"

#define ROW         640 /* the thesis's */
#define SEGMENT     7
#define LENGTHS_MAX 64

static const int lengths[] = {1, 3, 7, 15, 31};
#define LENGTHS ((int)(sizeof lengths / sizeof lengths[0]))

static const double limits[] = {0.0, 0.5, 1.0, 2.3, 5.0, 10.0, 20.0};
#define LIMITS ((int)(sizeof limits / sizeof limits[0]))

/* ---- The formulas ---------------------------------------------------------------------------- */

static void count(glint_numbers *numbers)
{
    int differing = 0, largest = 0;
    for (int segment = 1; segment <= LENGTHS_MAX; segment++) {
        const int difference =
            (int)(glint_count_by_2_28(ROW, segment) - glint_count_row(ROW, segment));
        differing += difference != 0;
        largest = difference > largest ? difference : largest;
    }
    const uint64_t traced = glint_count_row(ROW, SEGMENT);
    glint_number_put(numbers, ROW, "trace.row");
    glint_number_put(numbers, SEGMENT, "trace.segment");
    glint_number_put(numbers, LENGTHS_MAX, "trace.lengths-checked");
    glint_number_put(numbers, (double)traced, "trace.traced");
    glint_number_put(numbers, (double)glint_count_by_2_28(ROW, SEGMENT), "trace.by-2-28");
    glint_number_put(numbers, (double)glint_count_by_2_31(ROW, (traced - 1) * SEGMENT),
                     "trace.by-2-31");
    glint_number_put(numbers, differing, "trace.differing");
    glint_number_put(numbers, largest, "trace.differing.by");
}

/* ---- What is kept for the claims and the charts ---------------------------------------------- */

typedef struct measured {
    double rays[LENGTHS][1 + GLINT_TRACE_OBJECTS];
    double gain[LENGTHS][1 + GLINT_TRACE_OBJECTS];
    double nmse[LENGTHS][1 + 2 * GLINT_TRACE_OBJECTS];    /* with the limit, and without */
    double by_limit[LIMITS][1 + 2 * GLINT_TRACE_OBJECTS]; /* rays, NMSE */
    double smooth[2]; /* NMSE of sphere and teapot, by mean and linear */
    double thin[2];   /* of the grid */
    double gains[2], beyond[2];
    double sharper[2], seams[2]; /* bicubic against bilinear; bicubic */
} measured;

static const measured nothing = {.smooth = {NAN, NAN},
                                 .thin = {NAN, NAN},
                                 .gains = {NAN, NAN},
                                 .beyond = {NAN, NAN},
                                 .sharper = {NAN, NAN},
                                 .seams = {NAN, NAN}};

static void put_run(glint_numbers *numbers, const char *object, const char *key,
                    const glint_trace_run *run)
{
    glint_number_put(numbers, run->rays, "trace.%s.%s.rays", object, key);
    glint_number_put(numbers, run->nmse, "trace.%s.%s.nmse", object, key);
    if (run->gain > 0.0)
        glint_number_put(numbers, run->gain, "trace.%s.%s.gain", object, key);
    glint_number_put(numbers, run->beyond, "trace.%s.%s.beyond", object, key);
    glint_number_put(numbers, run->largest, "trace.%s.%s.largest", object, key);
}

static glint_join join_of(int segment, glint_fill fill, double limit)
{
    return (glint_join){.segment = segment, .centre = -1, .fill = fill, .limit = limit};
}

/* ---- One object ------------------------------------------------------------------------------ */

/* With the limit by linear interpolation and the thesis's mean, and without by linear. */
static glint_status measure_length(glint_report *report, glint_trace_object object,
                                   glint_trace_subject *subject, int at, measured *m,
                                   glint_error *err)
{
    const char *name = glint_trace_object_names[object];
    char key[32];
    glint_trace_run linear, mean, unlimited;
    const int length = lengths[at];
    const glint_join ways[3] = {join_of(length, GLINT_FILL_LINEAR, GLINT_LIMIT_DEFAULT),
                                join_of(length, GLINT_FILL_MEAN, GLINT_LIMIT_DEFAULT),
                                join_of(length, GLINT_FILL_LINEAR, (double)INFINITY)};
    glint_status status = glint_trace_subject_run(subject, &ways[0], true, &linear, err);
    if (status == GLINT_OK)
        status = glint_trace_subject_run(subject, &ways[1], false, &mean, err);
    if (status == GLINT_OK)
        status = glint_trace_subject_run(subject, &ways[2], false, &unlimited, err);
    if (status != GLINT_OK)
        return status;
    snprintf(key, sizeof key, "%d", length);
    put_run(&report->numbers, name, key, &linear);
    snprintf(key, sizeof key, "%d.mean", length);
    put_run(&report->numbers, name, key, &mean);
    snprintf(key, sizeof key, "%d.unlimited", length);
    put_run(&report->numbers, name, key, &unlimited);
    m->rays[at][1 + object] = 100.0 * linear.rays;
    m->gain[at][1 + object] = linear.gain;
    m->nmse[at][1 + object] = linear.nmse;
    m->nmse[at][1 + GLINT_TRACE_OBJECTS + object] = unlimited.nmse;
    glint_number_widen(m->gains, linear.gain);
    if (length != SEGMENT)
        return GLINT_OK;
    glint_number_widen(m->beyond, linear.beyond);
    glint_number_widen(m->beyond, mean.beyond);
    glint_number_widen(object == GLINT_TRACE_GRID ? m->thin : m->smooth, linear.nmse);
    glint_number_widen(object == GLINT_TRACE_GRID ? m->thin : m->smooth, mean.nmse);
    return GLINT_OK;
}

static glint_status measure_limits(glint_report *report, glint_trace_object object,
                                   glint_trace_subject *subject, measured *m, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int i = 0; i < LIMITS && status == GLINT_OK; i++) {
        const glint_join how = join_of(SEGMENT, GLINT_FILL_LINEAR, limits[i]);
        glint_trace_run run = {0};
        char key[32];
        status = glint_trace_subject_run(subject, &how, false, &run, err);
        snprintf(key, sizeof key, "limit-%g", limits[i]);
        put_run(&report->numbers, glint_trace_object_names[object], key, &run);
        m->by_limit[i][1 + object] = 100.0 * run.rays;
        m->by_limit[i][1 + GLINT_TRACE_OBJECTS + object] = run.nmse;
    }
    return status;
}

/* Every fill with the limit and without. Sharpness and seams are those of a plain grid. */
static glint_status measure_fills(glint_report *report, glint_trace_object object,
                                  glint_trace_subject *subject, measured *m, glint_error *err)
{
    glint_status status = GLINT_OK;
    const char *name = glint_trace_object_names[object];
    double sharpness[GLINT_FILL_COUNT] = {0.0};
    for (int fill = 0; fill < GLINT_FILL_COUNT && status == GLINT_OK; fill++)
        for (int limited = 1; limited >= 0 && status == GLINT_OK; limited--) {
            const glint_join how = join_of(SEGMENT, (glint_fill)fill,
                                           limited ? GLINT_LIMIT_DEFAULT : (double)INFINITY);
            glint_trace_run run = {0};
            char key[64];
            status = glint_trace_subject_run(subject, &how, false, &run, err);
            snprintf(key, sizeof key, "%s%s", glint_fill_names[fill], limited ? "" : ".unlimited");
            put_run(&report->numbers, name, key, &run);
            sharpness[fill] = glint_trace_sharpness(subject->image);
            if (limited || fill < GLINT_FILL_BILINEAR) /* nearest: no steps elsewhere */
                continue;
            const double seams = glint_trace_seams(subject->image, SEGMENT);
            glint_number_put(&report->numbers, seams, "trace.%s.%s.seams", name,
                             glint_fill_names[fill]);
            if (fill == GLINT_FILL_BICUBIC && object != GLINT_TRACE_GRID)
                glint_number_widen(m->seams, seams);
        }
    const double sharper = sharpness[GLINT_FILL_BICUBIC] / sharpness[GLINT_FILL_BILINEAR];
    glint_number_put(&report->numbers, sharper, "trace.%s.sharper", name);
    glint_number_put(&report->numbers, glint_trace_seams(subject->full, SEGMENT),
                     "trace.%s.full.seams", name);
    if (object != GLINT_TRACE_GRID)
        glint_number_widen(m->sharper, sharper);
    return status;
}

/* Longer segments at the border, shorter ones in the centre: against one length. */
static glint_status measure_centre(glint_report *report, glint_trace_object object,
                                   glint_trace_subject *subject, glint_error *err)
{
    glint_trace_run run = {0};
    glint_join how = join_of(15, GLINT_FILL_LINEAR, GLINT_LIMIT_DEFAULT);
    how.centre = SEGMENT;
    const glint_status status = glint_trace_subject_run(subject, &how, false, &run, err);
    put_run(&report->numbers, glint_trace_object_names[object], "centre", &run);
    return status;
}

static glint_status measure_object(glint_report *report, glint_trace_object object, measured *m,
                                   glint_error *err)
{
    glint_trace_subject subject;
    glint_status status = glint_trace_subject_make(report, object, &subject, err);
    for (int i = 0; i < LENGTHS && status == GLINT_OK; i++)
        status = measure_length(report, object, &subject, i, m, err);
    if (status == GLINT_OK)
        status = measure_limits(report, object, &subject, m, err);
    if (status == GLINT_OK)
        status = measure_fills(report, object, &subject, m, err);
    if (status == GLINT_OK)
        status = measure_centre(report, object, &subject, err);
    if (status == GLINT_OK)
        status = glint_trace_pictures(report, object, &subject, err);
    if (status == GLINT_OK) {
        glint_number_put(&report->numbers, subject.image->width, "trace.%s.width",
                         glint_trace_object_names[object]);
        glint_number_put(&report->numbers, subject.image->height, "trace.%s.height",
                         glint_trace_object_names[object]);
    }
    glint_trace_subject_destroy(&subject);
    return status;
}

/* ---- The charts ------------------------------------------------------------------------------ */

#define OF_OBJECTS                                                                                 \
    {                                                                                              \
        "sphere", "teapot", "grid"                                                                 \
    }
#define OF_BOTH                                                                                    \
    {                                                                                              \
        "sphere", "teapot", "grid", "sphere, no limit", "teapot, no limit", "grid, no limit"       \
    }
#define BY_LENGTH "set logscale x 2\nset xtics (1,3,7,15,31)\n"

static glint_status draw(glint_report *report, const measured *m, glint_error *err)
{
    static const glint_chart charts[] = {
        {.name = "trace-rays",
         .title = "Traced pixels by length of segments, limit 2.3",
         .x_label = "L",
         .y_label = "% of the pixels",
         .settings = BY_LENGTH,
         .style = "linespoints",
         .curves = 3,
         .curve = OF_OBJECTS},
        {.name = "trace-gain",
         .title = "Full time / time, limit 2.3",
         .x_label = "L",
         .y_label = "times faster",
         .settings = BY_LENGTH "set key top left\n",
         .style = "linespoints",
         .curves = 3,
         .curve = OF_OBJECTS},
        {.name = "trace-nmse",
         .title = "Error by length of segments, limit 2.3 and none",
         .x_label = "L",
         .y_label = "NMSE",
         .settings = BY_LENGTH "set logscale y\nset format y '%g'\n" GLINT_CHART_KEY_BELOW,
         .style = "linespoints",
         .curves = 6,
         .curve = OF_BOTH},
    };
    const double *values[] = {m->rays[0], m->gain[0], m->nmse[0]};
    glint_status status = GLINT_OK;
    for (int i = 0; i < 3 && status == GLINT_OK; i++)
        status = glint_chart_draw(report, &charts[i], values[i], LENGTHS, err);
    return status;
}

static glint_status draw_limits(glint_report *report, const measured *m, glint_error *err)
{
    static const glint_chart chart = {
        .name = "trace-limits",
        .title = "Error by limit, segments of 7",
        .x_label = "limit, ΔE",
        .y_label = "NMSE",
        .settings = "set logscale y\nset format y '%g'\n",
        .style = "linespoints",
        .curves = 3,
        .curve = OF_OBJECTS,
    };
    double values[LIMITS * (1 + GLINT_TRACE_OBJECTS)], *value = values;
    for (int i = 0; i < LIMITS; i++) {
        *value++ = limits[i];
        for (int object = 0; object < GLINT_TRACE_OBJECTS; object++)
            *value++ = m->by_limit[i][1 + GLINT_TRACE_OBJECTS + object];
    }
    return glint_chart_draw(report, &chart, values, LIMITS, err);
}

static void put_lists(glint_numbers *numbers, measured *m)
{
    char word[16];
    for (int i = 0; i < LENGTHS; i++) {
        snprintf(word, sizeof word, "%d", lengths[i]);
        glint_number_add_word(numbers, "trace.lengths", word);
        m->rays[i][0] = m->gain[i][0] = m->nmse[i][0] = lengths[i];
    }
    for (int i = 0; i < LIMITS; i++) {
        snprintf(word, sizeof word, "%g", limits[i]);
        glint_number_add_word(numbers, "trace.limits", word);
    }
    for (int fill = 0; fill < GLINT_FILL_COUNT; fill++)
        glint_number_add_word(numbers, "trace.fills", glint_fill_names[fill]);
}

static void put_ranges(glint_numbers *numbers, const measured *m)
{
    glint_number_put_range(numbers, m->smooth[0], m->smooth[1], "trace.smooth.nmse");
    glint_number_put_range(numbers, m->thin[0], m->thin[1], "trace.thin.nmse");
    glint_number_put_range(numbers, m->gains[0], m->gains[1], "trace.gain");
    glint_number_put_range(numbers, m->beyond[0], m->beyond[1], "trace.beyond");
    glint_number_put(numbers, m->beyond[1], "trace.beyond.most");
    glint_number_put_range(numbers, m->sharper[0], m->sharper[1], "trace.sharper");
    glint_number_put_range(numbers, m->seams[0], m->seams[1], "trace.seams");
}

glint_status glint_chapter_trace(glint_report *report, glint_error *err)
{
    measured *m = malloc(sizeof *m);
    if (m == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the traced frames");
    *m = nothing;
    count(&report->numbers);
    put_lists(&report->numbers, m);
    glint_status status = glint_trace_figures(report, err);
    for (int object = 0; object < GLINT_TRACE_OBJECTS && status == GLINT_OK; object++)
        status = measure_object(report, (glint_trace_object)object, m, err);
    if (status == GLINT_OK) {
        put_ranges(&report->numbers, m);
        status = draw(report, m, err);
    }
    if (status == GLINT_OK)
        status = draw_limits(report, m, err);
    free(m);
    return status;
}
