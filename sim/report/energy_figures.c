/* Figures 2.15 and 2.16, and the albedo against the incidence. */
#include <math.h>

#include "report/chart.h"
#include "report/energy.h"

static glint_status draw_by_exponent(glint_report *report, const glint_chart *chart,
                                     const double *const *curve, glint_error *err)
{
    double values[GLINT_ENERGY_N_MAX * (1 + GLINT_CHART_CURVES_MAX)];
    const int width = 1 + chart->curves;
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++) {
        values[i * width] = i + 1;
        for (int j = 0; j < chart->curves; j++)
            values[i * width + 1 + j] = curve[j][i];
    }
    return glint_chart_draw(report, chart, values, GLINT_ENERGY_N_MAX, err);
}

static glint_status draw_limits(glint_report *report, const glint_energy_normal *normal,
                                glint_error *err)
{
    const glint_chart figure_15 = {
        .name = "figure-2.15",
        .title = "Albedo of the cosine-quadratic at normal incidence",
        .x_label = "n",
        .y_label = "R",
        .settings =
            "set logscale x\nset yrange [0:3]\nset arrow from 1,1 to 1000,1 nohead dashtype 2\n",
        .curves = 3,
        .curve = {"(2.25) with dθ_0, to 5.8/√n", "(2.25) with dθ_0, to 5.8/√n, at most π/2",
                  "W itself: to its zero, at most π/2"}};
    const double *const curve[] = {normal->with_limit, normal->held, normal->w};
    return draw_by_exponent(report, &figure_15, curve, err);
}

static glint_status draw_normalized(glint_report *report, const glint_energy_results *results,
                                    glint_error *err)
{
    double smallest[GLINT_ENERGY_N_MAX], best[GLINT_ENERGY_N_MAX];
    const glint_chart figure_16 = {
        .name = "figure-2.16",
        .title = "Albedo at normal incidence with the normalising factor",
        .x_label = "n",
        .y_label = "R",
        .settings =
            "set logscale x\nset yrange [0.6:1.1]\nset arrow from 1,1 to 1000,1 nohead dashtype "
            "2\nset key bottom right\n",
        .curves = 4,
        .curve = {"(2.26): A = 6, B = 24.55", "Blinn, (n+6)/(8π)", "A = 6, smallest B",
                  "A and B of least mean loss"}};
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++) {
        const double w = results->normal.w[i];
        smallest[i] = (i + 1 + results->claimed.a) / results->claimed.b * w;
        best[i] = (i + 1 + results->least_mean.a) / results->least_mean.b * w;
    }
    const double *const curve[] = {results->normal.claimed, results->normal.blinn, smallest, best};
    glint_energy_put_curve(&report->numbers, "smallest", smallest);
    glint_energy_put_curve(&report->numbers, "best", best);
    return draw_by_exponent(report, &figure_16, curve, err);
}

static const glint_reflectance_model by_angle_model[] = {
    GLINT_REFLECTANCE_ENERGY_CONSERVING, GLINT_REFLECTANCE_BLINN_NORMALIZED,
    GLINT_REFLECTANCE_COOK_TORRANCE, GLINT_REFLECTANCE_TORRANCE_SPARROW};

/* Of the grid's last n. */
static glint_status draw_by_angle(glint_report *report, const glint_energy_table *grid,
                                  glint_error *err)
{
    enum { CURVES = 4 };
    char title[128];
    double values[90 * (1 + CURVES)], left[CURVES] = {0};
    const glint_energy_plan *plan = &grid->plan;
    const int last = plan->angle_count - 1;
    const glint_chart chart = {.name = "figure-energy-angle",
                               .title = title,
                               .x_label = "angle of incidence, degrees",
                               .y_label = "R",
                               .settings =
                                   "set xrange [0:90]\nset yrange [0:1.1]\nset key bottom left\n",
                               .curves = CURVES,
                               .curve = {"(2.26)", "Blinn, (n+6)/(8π)", "Cook–Torrance, F = 1",
                                         "Torrance–Sparrow, F = 1"}};
    for (int i = 0; i <= last; i++) {
        values[i * (1 + CURVES)] = plan->angle[i];
        for (int j = 0; j < CURVES; j++) {
            const double r =
                glint_energy_at(grid, (int)by_angle_model[j], plan->n_count - 1, i)->quadrature;
            values[i * (1 + CURVES) + 1 + j] = r;
            left[j] = r / values[1 + j];
        }
    }
    snprintf(title, sizeof title, "Albedo against the incidence, n = %g",
             plan->n[plan->n_count - 1]);
    for (int j = 0; j < CURVES; j++)
        glint_number_put(&report->numbers, left[j], "energy.angle.%s",
                         glint_reflectance_names[by_angle_model[j]]);
    return glint_chart_draw(report, &chart, values, last + 1, err);
}

glint_status glint_energy_draw(glint_report *report, const glint_energy_results *results,
                               glint_error *err)
{
    glint_status status = draw_limits(report, &results->normal, err);
    if (status == GLINT_OK)
        status = draw_normalized(report, results, err);
    return status == GLINT_OK ? draw_by_angle(report, results->grid, err) : status;
}
