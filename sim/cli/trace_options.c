/* The options that trace rays; see trace_options.h. */
#include "cli/trace_options.h"

#include <math.h>
#include <string.h>

#include "cli/output.h"
#include "cli/parse.h"

static const char *const method_names[] = {"raster", "trace", NULL};
#define METHOD_TRACE 1

#define LIMIT_NONE "none"
#define LIMIT_MAX  1000.0

void glint_trace_options_begin(glint_trace_options *chosen)
{
    *chosen = (glint_trace_options){
        .centre = -1,
        .fill = GLINT_FILL_LINEAR,
        .measure = GLINT_MEASURE_DELTA_E,
    };
}

void glint_trace_options_add(glint_trace_options *chosen, glint_option rows[GLINT_TRACE_OPTIONS])
{
    const glint_option options[] = {
        {.name = "method",
         .help = "how what is seen is found: triangle by triangle, or by rays",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->method, method_names}},
        {.name = "segment",
         .given = &chosen->segment_given,
         .placeholder = "L",
         .help = "trace two ends of L pixels and interpolate between; 0: trace every pixel",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->segment, 0, GLINT_SEGMENT_MAX}},
        {.name = "segment-centre",
         .given = &chosen->centre_given,
         .placeholder = "L",
         .usually = "the same",
         .help = "the same in the middle half of rows and columns",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->centre, 0, GLINT_SEGMENT_MAX}},
        {.name = "fill",
         .given = &chosen->fill_given,
         .help = "how pixels between are interpolated",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->fill, glint_fill_names}},
        {.name = "limit",
         .placeholder = "X|" LIMIT_NONE,
         .usually = "2.3",
         .help = "the largest difference of two ends that is interpolated",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->limit},
        {.name = "measure",
         .given = &chosen->measure_given,
         .help = "of that difference: CIELAB's, levels of a component, or RMS in per cent",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->measure, glint_measure_names}},
        {.name = "shadows",
         .help = "with --method trace: hard shadows",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->shadows},
        {.name = "reflect",
         .given = &chosen->reflect_given,
         .help = "with --method trace: add this much of what a mirror would show",
         .kind = GLINT_OPTION_REAL,
         .real = {&chosen->reflect, 0, 1}},
    };
    _Static_assert(sizeof options == GLINT_TRACE_OPTIONS * sizeof options[0], "as many rows");
    memcpy(rows, options, sizeof options);
}

/* The first option given of those that say how segments are interpolated; NULL: none. */
static const char *join_option(const glint_trace_options *chosen)
{
    return chosen->fill_given      ? "fill"
           : chosen->limit != NULL ? "limit"
           : chosen->measure_given ? "measure"
           : chosen->centre_given  ? "segment-centre"
                                   : NULL;
}

static const char *trace_option(const glint_trace_options *chosen)
{
    return chosen->segment_given   ? "segment"
           : chosen->shadows       ? "shadows"
           : chosen->reflect_given ? "reflect"
                                   : join_option(chosen);
}

static int settle_limit(const char *command, glint_trace_options *chosen)
{
    glint_quoted quoted;
    chosen->join.limit = GLINT_LIMIT_DEFAULT;
    if (chosen->limit == NULL)
        return GLINT_OPTIONS_RUN;
    if (strcmp(chosen->limit, LIMIT_NONE) != 0) {
        return glint_parse_real(chosen->limit, 0.0, LIMIT_MAX, &chosen->join.limit)
                   ? GLINT_OPTIONS_RUN
                   : glint_complain(command, GLINT_EXIT_TROUBLE,
                                    "--limit: %s is not " LIMIT_NONE " or a number from 0 to %g",
                                    glint_quote(chosen->limit, &quoted), LIMIT_MAX);
    }
    chosen->join.limit = (double)INFINITY;
    if (!chosen->measure_given)
        return GLINT_OPTIONS_RUN;
    return glint_complain(command, GLINT_EXIT_TROUBLE,
                          "--measure says nothing with --limit " LIMIT_NONE
                          ": no difference is measured");
}

static int settle_join(const char *command, glint_trace_options *chosen)
{
    const char *needless = join_option(chosen);
    if (chosen->segment == 0 && needless != NULL) {
        return glint_complain(command, GLINT_EXIT_TROUBLE,
                              "--%s needs --segment L: without it every pixel is traced", needless);
    }
    if (chosen->centre_given && glint_fill_is_of_blocks((glint_fill)chosen->fill)) {
        return glint_complain(command, GLINT_EXIT_TROUBLE,
                              "--segment-centre needs --fill mean, linear or cubic: blocks are "
                              "all of one size");
    }
    chosen->join.segment = (int)chosen->segment;
    chosen->join.centre = (int)chosen->centre;
    chosen->join.fill = (glint_fill)chosen->fill;
    chosen->join.measure = (glint_measure)chosen->measure;
    return settle_limit(command, chosen);
}

int glint_trace_options_settle(const char *command, const glint_scene *scene, bool gl,
                               glint_trace_options *chosen)
{
    const char *given = trace_option(chosen);
    chosen->traced = chosen->method == METHOD_TRACE;
    if (!chosen->traced && given != NULL)
        return glint_complain(command, GLINT_EXIT_TROUBLE, "--%s needs --method trace", given);
    if (!chosen->traced)
        return GLINT_OPTIONS_RUN;
    if (gl) {
        return glint_complain(command, GLINT_EXIT_TROUBLE,
                              "--method trace and --backend gl both say what draws: give one of "
                              "them");
    }
    if (scene->shading != GLINT_SHADING_PHONG) {
        return glint_complain(command, GLINT_EXIT_TROUBLE,
                              "--method trace computes the light wherever a ray ends: it needs "
                              "--shading phong");
    }
    return settle_join(command, chosen);
}
