/* Table 3.2 in the report: what the errors of frame_errors.h come to. */
#include <limits.h>
#include <math.h>

#include "report/chart.h"
#include "report/frame_errors.h"

#define SAY(text, ...) snprintf(text, sizeof text, __VA_ARGS__)

/* ---- The table ------------------------------------------------------------------------------- */

static void write_head(FILE *out, const glint_frame_errors *errors)
{
    fprintf(out,
            "### Pictures against pictures by cos^n (Table 3.2)\n\n"
            "The largest NMSE (3.1) over %d exponents from 1 to 1000, and the n that has it. "
            "%dx%d, the object fills the\nframe, its colour 238,138,32, Ka = 0.2, Kd = Ks = 0.5, "
            "over the object's pixels. The thesis does not give its\nscene, so the highlight is "
            "taken white and of the object's colour, and the latter once more with Ka = 1: the\n"
            "brighter the whole picture, the smaller the NMSE. It reads up to 0.0001 as no visible "
            "difference, to 0.00025\nas slight, to 0.001 as visible, above as substantial. *c* "
            "and *rtl* are the device, by C and by Verilog.\n\n| method | against |",
            errors->count, errors->width, errors->height);
    for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++)
        for (int light = 0; light < GLINT_LIGHT_COUNT; light++)
            fprintf(out, " %s, %s | n |", glint_test_figure_names[figure],
                    glint_frame_light_names[light]);
    fputs("\n|---|---|", out);
    for (int i = 0; i < GLINT_FIGURE_COUNT * GLINT_LIGHT_COUNT; i++)
        fputs("--:|--:|", out);
    fputc('\n', out);
}

static void write_row(FILE *out, const glint_frame_errors *errors, glint_frame_method method)
{
    fprintf(out, "| %s | %s |", glint_frame_names[method][0], glint_frame_names[method][1]);
    for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++)
        for (int light = 0; light < GLINT_LIGHT_COUNT; light++) {
            const glint_worst_frame worst = glint_worst_frame_of(
                errors, (glint_test_figure)figure, (glint_frame_light)light, method, 1, 1000);
            fprintf(out, " %.2g | %d |", worst.nmse, worst.n);
        }
    fputc('\n', out);
}

/* A logarithmic axis has no place for zero: the caption names what is missing. */
static void caption_of(const glint_chart *chart, const glint_frame_errors *errors, char *caption,
                       size_t room)
{
    size_t length = (size_t)snprintf(caption, room,
                                     "The frames' NMSE against n. Up to 0.0001 the thesis sees no "
                                     "difference.");
    const char *separator = " Not in the figure, as NMSE is 0: ";
    for (int curve = 0; curve < chart->curves; curve++)
        for (int i = 0; i < errors->count && length < room; i++)
            if (errors->nmse[GLINT_FIGURE_SPHERE][GLINT_LIGHT_WHITE][curve][i] == 0.0) {
                length += (size_t)snprintf(caption + length, room - length, "%s%s at n = %d",
                                           separator, chart->curve[curve], errors->n[i]);
                separator = "; ";
            }
    if (separator[0] == ';' && length < room)
        snprintf(caption + length, room - length, ".");
}

static glint_status draw(glint_report *report, const glint_frame_errors *errors, glint_error *err)
{
    char caption[1024];
    glint_chart chart = {.name = "figure-nmse",
                         .title = "NMSE of frames against cos^n, sphere, white highlight",
                         .x_label = "n",
                         .y_label = "NMSE",
                         .settings = "set logscale xy\nset format y '%g'\n" GLINT_CHART_KEY_BELOW,
                         .curves = 8,
                         .curve = {"Schlick (2.1)", "modified (2.2) as printed",
                                   "Table 3.2's, best a", "(2.2) read as 0.5(n(1 − c))^2",
                                   "quadratic", "cosine-quadratic", "k = 4", "device"},
                         .caption = caption};
    double values[GLINT_FRAME_EXPONENTS_MAX * (1 + GLINT_CHART_CURVES_MAX)];
    const int width = 1 + chart.curves;
    caption_of(&chart, errors, caption, sizeof caption);
    for (int i = 0; i < errors->count; i++) {
        values[i * width] = errors->n[i];
        for (int curve = 0; curve < chart.curves; curve++) {
            const double nmse = errors->nmse[GLINT_FIGURE_SPHERE][GLINT_LIGHT_WHITE][curve][i];
            values[i * width + 1 + curve] = nmse > 0.0 ? nmse : NAN; /* log scale */
        }
    }
    return glint_chart_draw(report, &chart, values, errors->count, err);
}

/* ---- The claims ------------------------------------------------------------------------------ */

typedef struct frame_claim {
    const char *where, *claim;
    double at_most;
    glint_frame_method method;
    int n_from, n_to;
} frame_claim;

static const frame_claim claims[] = {
    {"Table 3.2", "Modified Schlick, (2.2) as printed: NMSE at most 0.00011", 0.00011,
     GLINT_FRAME_SCHLICK_MODIFIED, 1, INT_MAX},
    {"Table 3.2", "Modified Schlick, (2.2) read as 0.5(n(1 − c))²: NMSE at most 0.00011", 0.00011,
     GLINT_FRAME_SCHLICK_SQUARED, 1, INT_MAX},
    {"Table 3.2", "Modified Schlick, as Table 3.2 prints it, with the best a: NMSE at most 0.00011",
     0.00011, GLINT_FRAME_SCHLICK_POWER, 1, INT_MAX},
    {"Table 3.2", "Quadratic: NMSE at most 0.00026 for n < 170", 0.00026, GLINT_FRAME_QUADRATIC, 1,
     169},
    {"Table 3.2", "Quadratic: NMSE < 0.0002 for the other n", 0.0002, GLINT_FRAME_QUADRATIC, 170,
     INT_MAX},
    {"Table 3.2", "Cosine-quadratic: NMSE at most 0.00008", 0.00008, GLINT_FRAME_COSINE_QUADRATIC,
     1, INT_MAX},
    {"3.1, 3.4", "Cosine-quadratic: no visible difference, NMSE below 0.0001", 0.0001,
     GLINT_FRAME_COSINE_QUADRATIC, 1, INT_MAX},
    {"3.1", "The device: no visible difference, NMSE below 0.0001", 0.0001, GLINT_FRAME_VERILOG, 1,
     INT_MAX},
};

typedef struct worst_of_all {
    glint_worst_frame worst;
    int figure, light;
} worst_of_all;

/* The largest over both figures and the lights from first to last. */
static worst_of_all worst_of(const glint_frame_errors *errors, const frame_claim *claim,
                             glint_frame_light first, glint_frame_light last)
{
    worst_of_all all = {.worst.nmse = -1.0};
    for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++)
        for (int light = (int)first; light <= (int)last; light++) {
            const glint_worst_frame found =
                glint_worst_frame_of(errors, (glint_test_figure)figure, (glint_frame_light)light,
                                     claim->method, claim->n_from, claim->n_to);
            if (found.nmse > all.worst.nmse)
                all = (worst_of_all){found, figure, light};
        }
    return all;
}

static void find(glint_findings *findings, const glint_frame_errors *errors,
                 const frame_claim *claim)
{
    const worst_of_all all = worst_of(errors, claim, GLINT_LIGHT_WHITE, GLINT_LIGHT_COLORED);
    const worst_of_all ambient = worst_of(errors, claim, GLINT_LIGHT_AMBIENT, GLINT_LIGHT_AMBIENT);
    glint_finding *finding = glint_findings_add(
        findings, all.worst.nmse <= claim->at_most ? GLINT_HOLDS : GLINT_DOES_NOT_HOLD,
        claim->where);
    SAY(finding->claim, "%s", claim->claim);
    SAY(finding->measured, "%.2g at n = %d, %s, %s; with Ka = 1 %.2g", all.worst.nmse, all.worst.n,
        glint_test_figure_names[all.figure], glint_frame_light_names[all.light],
        ambient.worst.nmse);
    SAY(finding->conditions,
        "sphere and teapot, %dx%d, filling the frame, Ka = 0.2, Kd = Ks = 0.5, highlight white or "
        "of the object's colour 238,138,32; %d exponents; against cos^n. The thesis does not give "
        "its scene; with Ka = 1 the whole picture is brighter",
        errors->width, errors->height, errors->count);
}

/* ---- All of it ------------------------------------------------------------------------------- */

static bool add_entry(cJSON *list, const glint_frame_errors *errors, int figure, int light,
                      int method)
{
    const glint_worst_frame worst =
        glint_worst_frame_of(errors, (glint_test_figure)figure, (glint_frame_light)light,
                             (glint_frame_method)method, 1, 1000);
    cJSON *entry = cJSON_CreateObject();
    return cJSON_AddItemToArray(list, entry) &&
           cJSON_AddStringToObject(entry, "figure", glint_test_figure_names[figure]) &&
           cJSON_AddStringToObject(entry, "light", glint_frame_light_names[light]) &&
           cJSON_AddStringToObject(entry, "method", glint_frame_names[method][0]) &&
           cJSON_AddStringToObject(entry, "reference", glint_frame_names[method][1]) &&
           cJSON_AddNumberToObject(entry, "largest", worst.nmse) &&
           cJSON_AddNumberToObject(entry, "n", worst.n);
}

static bool add_numbers(cJSON *numbers, const glint_frame_errors *errors)
{
    bool whole = true;
    cJSON *list = cJSON_AddArrayToObject(numbers, "nmse");
    for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++)
        for (int light = 0; light < GLINT_LIGHT_COUNT; light++)
            for (int method = 0; method < GLINT_FRAME_COUNT; method++)
                whole = whole && add_entry(list, errors, figure, light, method);
    return whole;
}

glint_status glint_frame_errors_write(glint_report *report, const glint_frame_errors *errors,
                                      glint_error *err)
{
    write_head(report->markdown, errors);
    for (int method = 0; method < GLINT_FRAME_COUNT; method++)
        write_row(report->markdown, errors, (glint_frame_method)method);
    for (size_t i = 0; i < sizeof claims / sizeof claims[0]; i++)
        find(report->findings, errors, &claims[i]);
    if (!add_numbers(report->numbers, errors))
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the frames' numbers");
    return draw(report, errors, err);
}
