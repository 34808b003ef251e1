/* Figures 2.15 and 2.16, and the albedo against the incidence. */

#include "report/chart.h"
#include "report/energy_parts.h"

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

static const glint_chart figure_15 = {
    .name = "figure-2.15",
    .title = "Albedo of the cosine-quadratic at normal incidence",
    .x_label = "n",
    .y_label = "R",
    .settings =
        "set logscale x\nset yrange [0:3]\nset arrow from 1,1 to 1000,1 nohead dashtype 2\n",
    .curves = 3,
    .curve = {"(2.25) with dθ_0, to 5.8/√n", "(2.25) with dθ_0, to 5.8/√n, at most π/2",
              "W itself: to its zero, at most π/2"},
    .caption = "Figure 2.15: (2.25) read with dθ₀ for its dω₀. The limit 5.8/√n lies beyond the "
               "zero of W, near 4.9/√n, and takes in "
               "some of the parabola's second branch; below n = 14 it is beyond the horizon, where "
               "cos θ counts as negative."};

static const glint_chart figure_16 = {
    .name = "figure-2.16",
    .title = "Albedo at normal incidence with the normalising factor",
    .x_label = "n",
    .y_label = "R",
    .settings =
        "set logscale x\nset yrange [0.6:1.1]\nset arrow from 1,1 to 1000,1 nohead dashtype "
        "2\nset key bottom right\n",
    .curves = 4,
    .curve = {"(2.26): A = 6, B = 24.55", "Blinn, (n+6)/(8π)", "A = 6, smallest B",
              "A and B of least mean loss"},
    .caption = "Figure 2.16: (2.26) is above 1 for all but the smallest n; Blinn's with its factor "
               "is not; nor is W with the smallest B for A = 6, or with the best A and B."};

static glint_status draw_normalized(glint_report *report, const glint_energy_results *results,
                                    glint_error *err)
{
    double smallest[GLINT_ENERGY_N_MAX], best[GLINT_ENERGY_N_MAX];
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++) {
        const double w = results->normal.w[i];
        smallest[i] = (i + 1 + results->claimed.a) / results->claimed.b * w;
        best[i] = (i + 1 + results->least_mean.a) / results->least_mean.b * w;
    }
    const double *const curve[] = {results->normal.claimed, results->normal.blinn, smallest, best};
    return draw_by_exponent(report, &figure_16, curve, err);
}

static const glint_chart by_angle = {
    .name = "figure-energy-angle",
    .title = "Albedo against the incidence, n = 1000",
    .x_label = "angle of incidence, degrees",
    .y_label = "R",
    .settings = "set xrange [0:90]\nset yrange [0:1.1]\nset key bottom left\n",
    .curves = 4,
    .curve = {"(2.26)", "Blinn, (n+6)/(8π)", "Cook–Torrance, F = 1", "Torrance–Sparrow, F = 1"},
    .caption =
        "A lobe without a denominator (N·L)(N·V) loses the more the flatter the light comes, "
        "as cos²; microfacets lose only what they shadow."};
static const glint_reflectance_model by_angle_model[] = {
    GLINT_REFLECTANCE_ENERGY_CONSERVING, GLINT_REFLECTANCE_BLINN_NORMALIZED,
    GLINT_REFLECTANCE_COOK_TORRANCE, GLINT_REFLECTANCE_TORRANCE_SPARROW};

/* Of the grid's last n. */
static glint_status draw_by_angle(glint_report *report, const glint_energy_table *grid,
                                  glint_error *err)
{
    double values[90 * (1 + GLINT_CHART_CURVES_MAX)];
    const int width = 1 + by_angle.curves;
    for (int i = 0; i < grid->plan.angle_count; i++) {
        values[i * width] = grid->plan.angle[i];
        for (int j = 0; j < by_angle.curves; j++)
            values[i * width + 1 + j] =
                glint_energy_at(grid, (int)by_angle_model[j], grid->plan.n_count - 1, i)
                    ->quadrature;
    }
    return glint_chart_draw(report, &by_angle, values, grid->plan.angle_count, err);
}

glint_status glint_energy_draw(glint_report *report, const glint_energy_results *results,
                               glint_error *err)
{
    const glint_energy_normal *normal = &results->normal;
    const double *const curve[] = {normal->with_limit, normal->held, normal->w};
    glint_status status = draw_by_exponent(report, &figure_15, curve, err);
    if (status == GLINT_OK)
        status = draw_normalized(report, results, err);
    return status == GLINT_OK ? draw_by_angle(report, results->grid, err) : status;
}
