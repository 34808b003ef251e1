/* Table 3.2 in the report: what the errors of frame_errors.h come to. */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "report/chart.h"
#include "report/frame_errors.h"

#define SAY(text, ...) snprintf(text, sizeof text, __VA_ARGS__)

/* ---- The table ------------------------------------------------------------------------------- */

static void write_head(FILE *out, const glint_frame_errors *errors)
{
    char exponents[64], scene_text[256], light_text[64];
    glint_scene scene = {0};
    glint_frame_scene(GLINT_LIGHT_WHITE, &scene);
    glint_frame_scene_say(&scene, scene_text, sizeof scene_text);
    glint_frame_exponents_say(errors->n, errors->count, 0, INT_MAX, exponents, sizeof exponents);
    fprintf(out,
            "### Pictures against pictures by cos^n (Table 3.2)\n\n"
            "The largest NMSE (3.1) over %s, and the n that has it. %dx%d, over the object's "
            "pixels; %s.\nThe thesis does not say of which scene its table is, so the highlight is "
            "taken white and of the object's\ncolour, and each once more with all of the ambient "
            "light: what Ka adds is in the denominator of (3.1).\nIt reads up to 0.0001 as no "
            "visible difference, to 0.00025 as slight, to 0.001 as visible, above as "
            "substantial.\n*c* and *rtl* are the device, by C and by Verilog.\n\n| method | "
            "against |",
            exponents, errors->width, errors->height, scene_text);
    for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++)
        for (int light = 0; light < GLINT_LIGHT_COUNT; light++) {
            glint_frame_light_say((glint_frame_light)light, light_text, sizeof light_text);
            fprintf(out, " %s, %s | n |", glint_test_figure_names[figure], light_text);
        }
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
                errors, (glint_test_figure)figure, (glint_frame_light)light, method, 0, INT_MAX);
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
    char caption[1024], title[128], light_text[64];
    glint_frame_light_say(GLINT_LIGHT_WHITE, light_text, sizeof light_text);
    SAY(title, "NMSE of frames against cos^n, %s, %s", glint_test_figure_names[GLINT_FIGURE_SPHERE],
        light_text);
    const glint_chart chart = {.name = "figure-nmse",
                               .title = title,
                               .x_label = "n",
                               .y_label = "NMSE",
                               .settings =
                                   "set logscale xy\nset format y '%g'\n" GLINT_CHART_KEY_BELOW,
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
    glint_rule rule;
    double stated;
    int decimals;
    glint_frame_method method;
    int n_from, n_to;
} frame_claim;

#define TABLE  "Table 3.2"
#define UNSEEN "no visible difference, NMSE"

static const frame_claim claims[] = {
    {TABLE, "Modified Schlick, (2.2) as printed: NMSE", GLINT_AT_MOST, 0.00011, 5,
     GLINT_FRAME_SCHLICK_MODIFIED, 1, INT_MAX},
    {TABLE, "Modified Schlick, (2.2) read as 0.5(n(1 − c))²: NMSE", GLINT_AT_MOST, 0.00011, 5,
     GLINT_FRAME_SCHLICK_SQUARED, 1, INT_MAX},
    {TABLE, "Modified Schlick, as Table 3.2 prints it, with the best a: NMSE", GLINT_AT_MOST,
     0.00011, 5, GLINT_FRAME_SCHLICK_POWER, 1, INT_MAX},
    {TABLE, "Quadratic, n < 170: NMSE", GLINT_AT_MOST, 0.00026, 5, GLINT_FRAME_QUADRATIC, 1, 169},
    {TABLE, "Quadratic, the other n: NMSE", GLINT_BELOW, 0.0002, 4, GLINT_FRAME_QUADRATIC, 170,
     INT_MAX},
    {TABLE, "Cosine-quadratic: NMSE", GLINT_AT_MOST, 0.00008, 5, GLINT_FRAME_COSINE_QUADRATIC, 1,
     INT_MAX},
    {"3.1, 3.4", "Cosine-quadratic: " UNSEEN, GLINT_BELOW, 0.0001, 4, GLINT_FRAME_COSINE_QUADRATIC,
     1, INT_MAX},
    {"3.1", "The device: " UNSEEN, GLINT_BELOW, 0.0001, 4, GLINT_FRAME_VERILOG, 1, INT_MAX},
};

static glint_worst_frame worst_in(const glint_frame_errors *errors, const frame_claim *claim,
                                  int figure, glint_frame_light light)
{
    return glint_worst_frame_of(errors, (glint_test_figure)figure, light, claim->method,
                                claim->n_from, claim->n_to);
}

/* The figure with the larger one. */
static int worst_figure(const glint_frame_errors *errors, const frame_claim *claim,
                        glint_frame_light light)
{
    int worst = 0;
    for (int figure = 1; figure < GLINT_FIGURE_COUNT; figure++)
        if (worst_in(errors, claim, figure, light).nmse >
            worst_in(errors, claim, worst, light).nmse)
            worst = figure;
    return worst;
}

static void say_conditions(glint_finding *finding, const glint_frame_errors *errors,
                           const frame_claim *claim, glint_frame_light light)
{
    char scene_text[256], exponents[64], figures[64] = "";
    glint_scene scene = {0};
    glint_frame_scene(light, &scene);
    glint_frame_scene_say(&scene, scene_text, sizeof scene_text);
    glint_frame_exponents_say(errors->n, errors->count, claim->n_from, claim->n_to, exponents,
                              sizeof exponents);
    for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++) {
        const size_t length = strlen(figures);
        snprintf(figures + length, sizeof figures - length, "%s%s", figure > 0 ? " and " : "",
                 glint_test_figure_names[figure]);
    }
    SAY(finding->conditions,
        "%s, %dx%d; %s; %s; method %s against %s. The thesis does not say of which scene its "
        "number is",
        figures, errors->width, errors->height, scene_text, exponents,
        glint_frame_names[claim->method][0], glint_frame_names[claim->method][1]);
}

/* One scene, one verdict. */
static void find(glint_findings *findings, const glint_frame_errors *errors,
                 const frame_claim *claim, glint_frame_light light)
{
    char light_text[64];
    const int figure = worst_figure(errors, claim, light);
    const glint_worst_frame worst = worst_in(errors, claim, figure, light);
    const glint_judged judged =
        glint_judged_number(claim->rule, claim->stated, claim->decimals, worst.nmse);
    glint_finding *finding = glint_findings_add(findings, claim->where, &judged);
    glint_frame_light_say(light, light_text, sizeof light_text);
    SAY(finding->claim, "%s %s %.*f; %s", claim->claim,
        claim->rule == GLINT_BELOW ? "below" : "at most", claim->decimals, claim->stated,
        light_text);
    SAY(finding->measured, "%.2g at n = %d, %s", worst.nmse, worst.n,
        glint_test_figure_names[figure]);
    say_conditions(finding, errors, claim, light);
}

void glint_frame_errors_find(const glint_frame_errors *errors, glint_findings *findings)
{
    for (size_t i = 0; i < sizeof claims / sizeof claims[0]; i++)
        for (int light = 0; light < GLINT_LIGHT_COUNT; light++)
            find(findings, errors, &claims[i], (glint_frame_light)light);
}

/* ---- All of it ------------------------------------------------------------------------------- */

static bool add_entry(cJSON *list, const glint_frame_errors *errors, int figure, int light,
                      int method)
{
    const glint_worst_frame worst =
        glint_worst_frame_of(errors, (glint_test_figure)figure, (glint_frame_light)light,
                             (glint_frame_method)method, 0, INT_MAX);
    char light_text[64];
    cJSON *entry = cJSON_CreateObject();
    glint_frame_light_say((glint_frame_light)light, light_text, sizeof light_text);
    return cJSON_AddItemToArray(list, entry) &&
           cJSON_AddStringToObject(entry, "figure", glint_test_figure_names[figure]) &&
           cJSON_AddStringToObject(entry, "light", light_text) &&
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
    glint_frame_errors_find(errors, report->findings);
    if (!add_numbers(report->numbers, errors))
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the frames' numbers");
    return draw(report, errors, err);
}
