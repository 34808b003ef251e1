/* Figures 2.2 to 2.7 and 2.10. The thesis does not give its n; each figure states ours. */
#include <math.h>

#include "report/chart.h"
#include "report/lobes.h"

#define POINTS  601
#define DEGREES (acos(-1.0) / 180.0)
#define N_SHOWN 50.0

static glint_status prepare(glint_reflectance_model model, glint_reflectance *prepared,
                            glint_error *err)
{
    const glint_reflectance_parameters parameters = {.n = N_SHOWN, .f0 = GLINT_F0_DEFAULT};
    return glint_reflectance_prepare(model, &parameters, prepared, err);
}

/* ---- Lobes against the angle γ from 0 to `to` degrees ---------------------------------------- */

typedef struct lobe_figure {
    const char *name, *title; /* without the n */
    double to;
    int curves;
    const char *curve[GLINT_CHART_CURVES_MAX];
    glint_reflectance_model model[GLINT_CHART_CURVES_MAX];
} lobe_figure;

static const lobe_figure lobe_figures[] = {
    {"figure-2.2",
     "cos^n γ and Schlick's function",
     60,
     2,
     {"cos^n γ (Blinn)", "Schlick (2.1)"},
     {GLINT_REFLECTANCE_BLINN, GLINT_REFLECTANCE_SCHLICK}},
    {"figure-2.4",
     "Schlick's function, cos^n γ and the modified function",
     60,
     4,
     {"1: Schlick (2.1)", "2: cos^n γ", "3: modified (2.2) as printed", "Table 3.2's, best a"},
     {GLINT_REFLECTANCE_SCHLICK, GLINT_REFLECTANCE_BLINN, GLINT_REFLECTANCE_SCHLICK_MODIFIED,
      GLINT_REFLECTANCE_SCHLICK_MODIFIED_POWER}},
    {"figure-2.5",
     "The quadratic (2.3) and the cosine-quadratic (2.15)",
     30,
     3,
     {"cos^n γ", "quadratic, clamped at 0", "cosine-quadratic"},
     {GLINT_REFLECTANCE_BLINN, GLINT_REFLECTANCE_QUADRATIC, GLINT_REFLECTANCE_COSINE_QUADRATIC}},
    {"figure-family",
     "The family (1 − x/k)^k of equal integral",
     30,
     5,
     {"cos^n γ", "k = 2: cosine-quadratic", "k = 4", "k = 8", "k = 16"},
     {GLINT_REFLECTANCE_BLINN, GLINT_REFLECTANCE_COSINE_QUADRATIC, GLINT_REFLECTANCE_LYON_4,
      GLINT_REFLECTANCE_LYON_8, GLINT_REFLECTANCE_LYON_16}},
};

static glint_status draw_lobes(glint_report *report, const lobe_figure *figure, glint_error *err)
{
    double values[POINTS * (1 + GLINT_CHART_CURVES_MAX)];
    char title[128];
    const int width = 1 + figure->curves;
    glint_chart chart = {.name = figure->name,
                         .title = title,
                         .x_label = "γ, degrees",
                         .y_label = "value of the lobe",
                         .curves = figure->curves};
    snprintf(title, sizeof title, "%s, n = %g", figure->title, N_SHOWN);
    for (int curve = 0; curve < figure->curves; curve++) {
        glint_reflectance prepared;
        const glint_status status = prepare(figure->model[curve], &prepared, err);
        if (status != GLINT_OK)
            return status;
        chart.curve[curve] = figure->curve[curve];
        for (int i = 0; i < POINTS; i++) {
            const double angle = figure->to * i / (POINTS - 1);
            values[i * width] = angle;
            values[i * width + 1 + curve] =
                glint_reflectance_of_cosine(&prepared, cos(angle * DEGREES));
        }
    }
    return glint_chart_draw(report, &chart, values, POINTS, err);
}

/* Figure 2.6: relative error against the level, down to the end of the decay. */
static glint_status draw_relative_error(glint_report *report, glint_error *err)
{
    const double lowest = GLINT_DECAY_LEVEL;
    char title[128], settings[64];
    snprintf(title, sizeof title,
             "Relative error of the quadratic and the cosine-quadratic, n = %g", N_SHOWN);
    snprintf(settings, sizeof settings, "set xrange [1:%g]\nset key bottom left\n", lowest);
    const glint_chart chart = {.name = "figure-2.6",
                               .title = title,
                               .x_label = "cos^n γ",
                               .y_label = "relative error, %",
                               .settings = settings,
                               .curves = 2,
                               .curve = {"quadratic", "cosine-quadratic"}};
    double values[POINTS * 3];
    glint_reflectance quadratic, cosine_quadratic;
    glint_status status = prepare(GLINT_REFLECTANCE_QUADRATIC, &quadratic, err);
    if (status == GLINT_OK)
        status = prepare(GLINT_REFLECTANCE_COSINE_QUADRATIC, &cosine_quadratic, err);
    if (status != GLINT_OK)
        return status;
    for (int i = 0; i < POINTS; i++) {
        const double level = 1.0 - (1.0 - lowest) * i / (POINTS - 1);
        const double cosine = pow(level, 1.0 / N_SHOWN);
        values[3 * i] = level;
        values[3 * i + 1] = 100.0 * (glint_reflectance_of_cosine(&quadratic, cosine) / level - 1.0);
        values[3 * i + 2] =
            100.0 * (glint_reflectance_of_cosine(&cosine_quadratic, cosine) / level - 1.0);
    }
    return glint_chart_draw(report, &chart, values, POINTS, err);
}

/* ---- Largest relative errors against n, in per cent ------------------------------------------ */

typedef struct error_figure {
    const char *name, *of;
    double level;
    int curves;
    const char *curve[GLINT_CHART_CURVES_MAX];
    const glint_accuracy *by_n[GLINT_CHART_CURVES_MAX];
} error_figure;

static glint_status draw_errors(glint_report *report, const error_figure *figure,
                                const glint_exponents *exponents, glint_error *err)
{
    double values[1000 * (1 + GLINT_CHART_CURVES_MAX)];
    char title[128];
    const int width = 1 + figure->curves;
    glint_chart chart = {.name = figure->name,
                         .title = title,
                         .x_label = "n",
                         .y_label = "%",
                         .settings = "set logscale x\nset yrange [0:*]\n" GLINT_CHART_KEY_BELOW,
                         .curves = figure->curves};
    snprintf(title, sizeof title, "Largest relative error%s where cos^n γ ≥ %g", figure->of,
             figure->level);
    for (int curve = 0; curve < figure->curves; curve++) {
        chart.curve[curve] = figure->curve[curve];
        for (int i = 0; i < exponents->count; i++) {
            values[i * width] = exponents->n[i];
            values[i * width + 1 + curve] = 100.0 * figure->by_n[curve][i].epicentre_relative.error;
        }
    }
    return glint_chart_draw(report, &chart, values, exponents->count, err);
}

glint_status glint_lobes_draw(glint_report *report, const glint_lobes *lobes, glint_error *err)
{
    const error_figure figures[] = {
        {"figure-2.3",
         "",
         GLINT_EPICENTRE_LEVEL,
         6,
         {"Schlick (2.1)", "modified (2.2) as printed", "read as cos(γ^2)", "read as 0.5n(1 − c)^2",
          "read as 0.5(n(1 − c))^2", "Table 3.2's, best a"},
         {lobes->by_n[GLINT_REFLECTANCE_SCHLICK], lobes->by_n[GLINT_REFLECTANCE_SCHLICK_MODIFIED],
          lobes->by_n[GLINT_REFLECTANCE_SCHLICK_MODIFIED_ANGLE],
          lobes->by_n[GLINT_REFLECTANCE_SCHLICK_MODIFIED_LINEAR],
          lobes->by_n[GLINT_REFLECTANCE_SCHLICK_MODIFIED_SQUARED],
          lobes->by_n[GLINT_REFLECTANCE_SCHLICK_MODIFIED_POWER]}},
        {"figure-2.7",
         " of the quadratic",
         GLINT_QUADRATIC_LEVEL,
         1,
         {"quadratic (2.3), a by (2.8)"},
         {lobes->quadratic}},
        {"figure-2.10",
         "",
         GLINT_EPICENTRE_LEVEL,
         4,
         {"cosine-quadratic (2.15)", "k = 4", "k = 8", "k = 16"},
         {lobes->by_n[GLINT_REFLECTANCE_COSINE_QUADRATIC], lobes->by_n[GLINT_REFLECTANCE_LYON_4],
          lobes->by_n[GLINT_REFLECTANCE_LYON_8], lobes->by_n[GLINT_REFLECTANCE_LYON_16]}},
    };
    glint_status status = draw_relative_error(report, err);
    for (size_t i = 0; i < sizeof lobe_figures / sizeof *lobe_figures && status == GLINT_OK; i++)
        status = draw_lobes(report, &lobe_figures[i], err);
    for (size_t i = 0; i < sizeof figures / sizeof *figures && status == GLINT_OK; i++)
        status = draw_errors(report, &figures[i], &lobes->exponents, err);
    return status;
}
