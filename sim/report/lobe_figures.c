/* Figures 2.2 to 2.7 and 2.10. The thesis does not say its n: each figure says ours. Captions that
 * say what a figure shows have it from the values drawn. */
#include <math.h>

#include "report/chart.h"
#include "report/lobe_parts.h"

#define POINTS  601
#define DEGREES (acos(-1.0) / 180.0)

static glint_status prepare(glint_reflectance_model model, double n, glint_reflectance *prepared,
                            glint_error *err)
{
    const glint_reflectance_parameters parameters = {.n = n, .f0 = GLINT_F0_DEFAULT};
    return glint_reflectance_prepare(model, &parameters, prepared, err);
}

/* Lobes of one n against the angle γ from 0 to `to` degrees. The title is without the n. */
typedef struct lobe_figure {
    glint_chart chart;
    glint_reflectance_model model[GLINT_CHART_CURVES_MAX];
    double n, to;
} lobe_figure;

static glint_status draw_lobes(glint_report *report, const lobe_figure *figure, glint_error *err)
{
    double values[POINTS * (1 + GLINT_CHART_CURVES_MAX)];
    char title[128];
    glint_chart chart = figure->chart;
    const int curves = chart.curves;
    snprintf(title, sizeof title, "%s, n = %g", chart.title, figure->n);
    chart.title = title;
    for (int curve = 0; curve < curves; curve++) {
        glint_reflectance prepared;
        const glint_status status = prepare(figure->model[curve], figure->n, &prepared, err);
        if (status != GLINT_OK)
            return status;
        for (int i = 0; i < POINTS; i++) {
            const double angle = figure->to * i / (POINTS - 1);
            values[i * (1 + curves)] = angle;
            values[i * (1 + curves) + 1 + curve] =
                glint_reflectance_of_cosine(&prepared, cos(angle * DEGREES));
        }
    }
    return glint_chart_draw(report, &chart, values, POINTS, err);
}

static const lobe_figure lobe_figures[] = {
    {.chart = {.name = "figure-2.2",
               .title = "cos^n γ and Schlick's function",
               .x_label = "γ, degrees",
               .y_label = "value of the lobe",
               .curves = 2,
               .curve = {"cos^n γ (Blinn)", "Schlick (2.1)"},
               .caption = "Figure 2.2: Schlick's function beside cos^n."},
     .model = {GLINT_REFLECTANCE_BLINN, GLINT_REFLECTANCE_SCHLICK},
     .n = 50,
     .to = 60},
    {.chart = {.name = "figure-2.4",
               .title = "Schlick's function, cos^n γ and the modified function",
               .x_label = "γ, degrees",
               .y_label = "value of the lobe",
               .curves = 4,
               .curve = {"1: Schlick (2.1)", "2: cos^n γ", "3: modified (2.2) as printed",
                         "Table 3.2's, best a"},
               .caption =
                   "Figure 2.4: Schlick's function and its modification in two forms, beside "
                   "cos^n."},
     .model = {GLINT_REFLECTANCE_SCHLICK, GLINT_REFLECTANCE_BLINN,
               GLINT_REFLECTANCE_SCHLICK_MODIFIED, GLINT_REFLECTANCE_SCHLICK_MODIFIED_POWER},
     .n = 50,
     .to = 60},
    {.chart = {.name = "figure-2.5",
               .title = "The quadratic (2.3) and the cosine-quadratic (2.15)",
               .x_label = "γ, degrees",
               .y_label = "value of the lobe",
               .curves = 3,
               .curve = {"cos^n γ", "quadratic, clamped at 0", "cosine-quadratic"},
               .caption =
                   "Figure 2.5: the quadratic, which meets cos^n at its point of inflection, "
                   "and the cosine-quadratic."},
     .model = {GLINT_REFLECTANCE_BLINN, GLINT_REFLECTANCE_QUADRATIC,
               GLINT_REFLECTANCE_COSINE_QUADRATIC},
     .n = 50,
     .to = 30},
    {.chart = {.name = "figure-family",
               .title = "The family (1 − x/k)^k of equal integral",
               .x_label = "γ, degrees",
               .y_label = "value of the lobe",
               .curves = 5,
               .curve = {"cos^n γ", "k = 2: cosine-quadratic", "k = 4", "k = 8", "k = 16"},
               .caption = "The cosine-quadratic is the family's k = 2."},
     .model = {GLINT_REFLECTANCE_BLINN, GLINT_REFLECTANCE_COSINE_QUADRATIC,
               GLINT_REFLECTANCE_LYON_4, GLINT_REFLECTANCE_LYON_8, GLINT_REFLECTANCE_LYON_16},
     .n = 50,
     .to = 30},
};

/* Figure 2.6: relative error against the angle, down to the end of the decay. */
static glint_status draw_relative_error(glint_report *report, glint_error *err)
{
    const double n = 50.0, lowest = GLINT_DECAY_LEVEL;
    char title[128], settings[64];
    snprintf(title, sizeof title,
             "Relative error of the quadratic and the cosine-quadratic, n = %g", n);
    snprintf(settings, sizeof settings, "set xrange [1:%g]\nset key bottom left\n", lowest);
    const glint_chart chart = {
        .name = "figure-2.6",
        .title = title,
        .x_label = "cos^n γ",
        .y_label = "relative error, %",
        .settings = settings,
        .curves = 2,
        .curve = {"quadratic", "cosine-quadratic"},
        .caption = "Figure 2.6: relative error against the level of the highlight, from its centre "
                   "outwards."};
    double values[POINTS * 3];
    glint_reflectance quadratic, cosine_quadratic;
    glint_status status = prepare(GLINT_REFLECTANCE_QUADRATIC, n, &quadratic, err);
    if (status == GLINT_OK)
        status = prepare(GLINT_REFLECTANCE_COSINE_QUADRATIC, n, &cosine_quadratic, err);
    if (status != GLINT_OK)
        return status;
    for (int i = 0; i < POINTS; i++) {
        const double level = 1.0 - (1.0 - lowest) * i / (POINTS - 1);
        const double cosine = pow(level, 1.0 / n);
        values[3 * i] = level;
        values[3 * i + 1] = 100.0 * (glint_reflectance_of_cosine(&quadratic, cosine) / level - 1.0);
        values[3 * i + 2] =
            100.0 * (glint_reflectance_of_cosine(&cosine_quadratic, cosine) / level - 1.0);
    }
    return glint_chart_draw(report, &chart, values, POINTS, err);
}

/* Largest relative errors in the epicentre against n, in per cent. */
static glint_status draw_by_exponent(glint_report *report, const glint_chart *chart,
                                     const glint_exponents *exponents,
                                     const glint_accuracy *const *by_n, glint_error *err)
{
    double values[1000 * (1 + GLINT_CHART_CURVES_MAX)];
    const int width = 1 + chart->curves;
    for (int i = 0; i < exponents->count; i++) {
        values[i * width] = exponents->n[i];
        for (int curve = 0; curve < chart->curves; curve++)
            values[i * width + 1 + curve] = 100.0 * by_n[curve][i].epicentre_relative.error;
    }
    return glint_chart_draw(report, chart, values, exponents->count, err);
}

static const char by_exponent[] = "set logscale x\nset yrange [0:*]\n" GLINT_CHART_KEY_BELOW;

static const char *title_of(double level, const char *what, char *title, size_t room)
{
    snprintf(title, room, "Largest relative error%s where cos^n γ ≥ %g", what, level);
    return title;
}

static glint_status draw_schlick(glint_report *report, const glint_lobes *lobes, glint_error *err)
{
    char title[128];
    const glint_chart chart = {
        .name = "figure-2.3",
        .title = title_of(GLINT_EPICENTRE_LEVEL, "", title, sizeof title),
        .x_label = "n",
        .y_label = "%",
        .settings = by_exponent,
        .curves = 6,
        .curve = {"Schlick (2.1)", "modified (2.2) as printed", "read as cos(γ^2)",
                  "read as 0.5n(1 − c)^2", "read as 0.5(n(1 − c))^2", "Table 3.2's, best a"},
        .caption = "Figure 2.3: the largest relative error in the epicentre of Schlick's function "
                   "and of each reading of its modification."};
    const glint_accuracy *const by_n[] = {lobes->by_n[GLINT_REFLECTANCE_SCHLICK],
                                          lobes->by_n[GLINT_REFLECTANCE_SCHLICK_MODIFIED],
                                          lobes->by_n[GLINT_REFLECTANCE_SCHLICK_MODIFIED_ANGLE],
                                          lobes->by_n[GLINT_REFLECTANCE_SCHLICK_MODIFIED_LINEAR],
                                          lobes->by_n[GLINT_REFLECTANCE_SCHLICK_MODIFIED_SQUARED],
                                          lobes->by_n[GLINT_REFLECTANCE_SCHLICK_MODIFIED_POWER]};
    return draw_by_exponent(report, &chart, &lobes->exponents, by_n, err);
}

static glint_status draw_quadratic(glint_report *report, const glint_lobes *lobes, glint_error *err)
{
    char title[128], caption[256];
    const glint_chart chart = {
        .name = "figure-2.7",
        .title = title_of(GLINT_QUADRATIC_LEVEL, " of the quadratic", title, sizeof title),
        .x_label = "n",
        .y_label = "%",
        .settings = by_exponent,
        .curves = 1,
        .curve = {"quadratic (2.3), a by (2.8)"},
        .caption = caption};
    const glint_accuracy *const by_n[] = {lobes->quadratic};
    snprintf(caption, sizeof caption,
             "Figure 2.7: the quadratic's largest relative error where cos^n is at least %g, up to "
             "%.2f %%; the thesis has at most 3 %%.",
             GLINT_QUADRATIC_LEVEL,
             100.0 * glint_lobe_worst_of(&lobes->exponents, lobes->quadratic, glint_n_all)
                         .epicentre_relative.error);
    return draw_by_exponent(report, &chart, &lobes->exponents, by_n, err);
}

static glint_status draw_family(glint_report *report, const glint_lobes *lobes, glint_error *err)
{
    char title[128], caption[256];
    const glint_chart chart = {.name = "figure-2.10",
                               .title = title_of(GLINT_EPICENTRE_LEVEL, "", title, sizeof title),
                               .x_label = "n",
                               .y_label = "%",
                               .settings = by_exponent,
                               .curves = 4,
                               .curve = {"cosine-quadratic (2.15)", "k = 4", "k = 8", "k = 16"},
                               .caption = caption};
    const glint_accuracy *const by_n[] = {
        lobes->by_n[GLINT_REFLECTANCE_COSINE_QUADRATIC], lobes->by_n[GLINT_REFLECTANCE_LYON_4],
        lobes->by_n[GLINT_REFLECTANCE_LYON_8], lobes->by_n[GLINT_REFLECTANCE_LYON_16]};
    snprintf(
        caption, sizeof caption,
        "Figure 2.10, in the epicentre, and its family. Where W is zero and cos^n is not, from "
        "n = %g on, the relative error is %.0f %%.",
        GLINT_LOBE_ENDS_FROM, 100.0 * lobes->derived.relative_at_end.least);
    return draw_by_exponent(report, &chart, &lobes->exponents, by_n, err);
}

/* In the order of the thesis. */
glint_status glint_lobes_draw(glint_report *report, const glint_lobes *lobes, glint_error *err)
{
    glint_status status = draw_lobes(report, &lobe_figures[0], err);
    if (status == GLINT_OK)
        status = draw_schlick(report, lobes, err);
    if (status == GLINT_OK)
        status = draw_lobes(report, &lobe_figures[1], err);
    if (status == GLINT_OK)
        status = draw_lobes(report, &lobe_figures[2], err);
    if (status == GLINT_OK)
        status = draw_relative_error(report, err);
    if (status == GLINT_OK)
        status = draw_quadratic(report, lobes, err);
    if (status == GLINT_OK)
        status = draw_family(report, lobes, err);
    return status == GLINT_OK ? draw_lobes(report, &lobe_figures[3], err) : status;
}
