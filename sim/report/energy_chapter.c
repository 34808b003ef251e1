/* The models' energy: section 2.5. */
#include "report/energy.h"

#include <math.h>
#include <stdlib.h>

#include "energy/reciprocity.h"

#define SEED 1

/* White microfacets, Fresnel's F = 1: any loss occurs between the facets. */
#define F0 1.0

static const double sphere_n[] = {1, 3, 10, 30, 100, 300, 1000};
static const double check_n[] = {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1000};
static const double check_angle[] = {0, 10, 20, 30, 40, 50, 60, 70, 80, 89};

#define COUNT(array) ((int)(sizeof(array) / sizeof(array)[0]))
#define ANGLES       90

/* Arrays that a plan points to. */
typedef struct grid {
    glint_reflectance_model model[GLINT_REFLECTANCE_COUNT];
    double n[GLINT_ENERGY_N_MAX], angle[ANGLES];
} grid;

/* Samples of a cell of the check, and pairs for reciprocity. */
static int samples_of(const glint_report *report)
{
    return report->quick ? 1000 : 10000;
}

/* ---- Measuring ------------------------------------------------------------------------------- */

/* Every model's table and the Verilog's, both to be destroyed, whatever comes back. */
static glint_status make_both(const glint_energy_plan *plan, glint_energy_table **table,
                              glint_energy_table **verilog, glint_error *err)
{
    *table = *verilog = NULL;
    const glint_status status = glint_energy_table_make(plan, table, err);
    return status == GLINT_OK ? glint_energy_verilog_table(plan, verilog, err) : status;
}

static glint_status normal_of(glint_reflectance_model model, const glint_albedo_rules *rules,
                              double *albedo, glint_error *err)
{
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++) {
        const glint_reflectance_parameters parameters = {.n = i + 1, .f0 = F0};
        glint_reflectance reflectance;
        glint_albedo prepared;
        const glint_status status =
            glint_reflectance_prepare(model, &parameters, &reflectance, err);
        if (status != GLINT_OK)
            return status;
        glint_albedo_prepare(&reflectance, rules, &prepared);
        albedo[i] = glint_albedo_at(&prepared, 0.0);
    }
    return GLINT_OK;
}

static glint_status measure_normal(const glint_report *report, glint_energy_normal *normal,
                                   glint_error *err)
{
    const struct {
        glint_reflectance_model model;
        double *albedo;
    } curves[] = {{GLINT_REFLECTANCE_COSINE_QUADRATIC, normal->w},
                  {GLINT_REFLECTANCE_ENERGY_CONSERVING, normal->claimed},
                  {GLINT_REFLECTANCE_BLINN_NORMALIZED, normal->blinn},
                  {GLINT_REFLECTANCE_DEVICE, normal->device}};
    glint_albedo_rules rules;
    glint_albedo_rules_make(1, &rules);
    glint_status status = GLINT_OK;
    for (int i = 0; i < COUNT(curves) && status == GLINT_OK; i++)
        status = normal_of(curves[i].model, &rules, curves[i].albedo, err);
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++) {
        const double limit = glint_printed_limit(i + 1);
        normal->with_limit[i] = glint_printed_albedo(i + 1, limit);
        normal->held[i] = glint_printed_albedo(i + 1, fmin(limit, acos(0.0)));
        normal->half_angle[i] = glint_misprinted_albedo(i + 1);
        normal->solid_angle[i] = glint_printed_albedo_by_solid_angle(i + 1, fmin(limit, acos(0.0)));
        normal->zero[i] = 2.0 * acos((i - 1.0) / (i + 2.0)) * sqrt(i + 1.0);
        normal->centre[i] = pow((i + 2.0) / 3.0 * (0.5 - 1.0) + 1.0, 2.0);
    }
    return status == GLINT_OK ? glint_energy_verilog_normal(report, normal->verilog, err) : status;
}

static glint_status measure_reciprocity(const glint_report *report, glint_energy_results *results,
                                        glint_error *err)
{
    results->pairs_n_count = COUNT(sphere_n);
    results->pairs_n_first = sphere_n[0];
    results->pairs_n_last = sphere_n[COUNT(sphere_n) - 1];
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT * COUNT(sphere_n); i++) {
        const glint_reflectance_parameters parameters = {.n = sphere_n[i % COUNT(sphere_n)],
                                                         .f0 = GLINT_F0_DEFAULT};
        const int model = i / COUNT(sphere_n);
        glint_reflectance reflectance;
        glint_reciprocity found;
        glint_status status = glint_report_go_on(report, err);
        if (status == GLINT_OK)
            status = glint_reflectance_prepare((glint_reflectance_model)model, &parameters,
                                               &reflectance, err);
        if (status != GLINT_OK)
            return status;
        glint_reciprocity_measure(glint_reciprocity_of_model, &reflectance,
                                  (uint64_t)samples_of(report), SEED, &found);
        results->asymmetry[model] = fmax(results->asymmetry[model], found.largest);
        if (model == 0)
            results->pairs += found.pairs;
    }
    return glint_energy_verilog_asymmetry(sphere_n, COUNT(sphere_n), (uint64_t)samples_of(report),
                                          SEED, &results->verilog_asymmetry, err);
}

static void search_factors(glint_energy_results *results)
{
    const double *w = results->normal.w;
    glint_normalization_for(GLINT_ENERGY_A, w, GLINT_ENERGY_N_MAX, &results->claimed);
    glint_normalization_for(GLINT_ENERGY_A, results->normal.device, GLINT_ENERGY_N_MAX,
                            &results->device);
    glint_normalization_for(GLINT_ENERGY_A, results->normal.verilog, GLINT_ENERGY_N_MAX,
                            &results->verilog);
    glint_normalization_best(GLINT_LOSS_MEAN, w, GLINT_ENERGY_N_MAX, &results->least_mean);
    glint_normalization_best(GLINT_LOSS_LARGEST, w, GLINT_ENERGY_N_MAX, &results->least_largest);
}

/* ---- Numbers and pictures -------------------------------------------------------------------- */

static void put_plan(glint_numbers *numbers, const glint_energy_results *results)
{
    const glint_energy_plan *grid = &results->grid->plan, *check = &results->check->plan;
    const struct {
        const char *name;
        double value;
    } of[] = {{"n-count", grid->n_count},
              {"angle-count", grid->angle_count},
              {"last-angle", grid->angle[grid->angle_count - 1]},
              {"error.lobe", GLINT_ALBEDO_ERROR_LOBE},
              {"error.microfacet", GLINT_ALBEDO_ERROR_MICROFACET},
              {"error.device", GLINT_ALBEDO_ERROR_DEVICE},
              {"one", GLINT_ENERGY_ONE},
              {"check.samples", check->samples},
              {"check.seed", (double)check->seed},
              {"check.n-count", check->n_count},
              {"check.angle-count", check->angle_count},
              {"pairs", (double)results->pairs},
              {"pairs.n-count", results->pairs_n_count}};
    for (int i = 0; i < COUNT(of); i++)
        glint_number_put(numbers, of[i].value, "energy.%s", of[i].name);
}

/* model: in the tables. */
static void put_model(glint_numbers *numbers, const char *name, const glint_energy_table *grid,
                      const glint_energy_table *check, int model, double asymmetry)
{
    glint_energy_summary all, few;
    char above[64] = "none";
    glint_energy_summarize(grid, model, &all);
    glint_energy_summarize(check, model, &few);
    const double cells = (double)few.cells;
    if (all.n_above > 0)
        snprintf(above, sizeof above, "%d: %g…%g", all.n_above, all.first_above, all.last_above);
    glint_number_add_word(numbers, "energy.models", name);
    glint_number_put(numbers, all.largest, "energy.%s.grid-largest", name);
    glint_number_put(numbers, all.largest_n, "energy.%s.grid-largest.n", name);
    glint_number_put(numbers, all.largest_angle, "energy.%s.grid-largest.angle", name);
    glint_number_put(numbers, all.n_above, "energy.%s.grid-above", name);
    glint_number_put_text(numbers, above, "energy.%s.grid-above.which", name);
    glint_number_put(numbers, (double)few.within_1 / cells, "energy.%s.within-1", name);
    glint_number_put(numbers, (double)few.within_2 / cells, "energy.%s.within-2", name);
    glint_number_put(numbers, (double)few.within_3 / cells, "energy.%s.within-3", name);
    glint_number_put(numbers, asymmetry, "energy.%s.asymmetry", name);
}

static void put_models(glint_numbers *numbers, const glint_energy_results *results)
{
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++)
        put_model(numbers, glint_reflectance_names[i], results->grid, results->check, i,
                  results->asymmetry[i]);
    put_model(numbers, "device-verilog", results->verilog_grid, results->verilog_check, 0,
              results->verilog_asymmetry);
}

static void put_factors(glint_numbers *numbers, const glint_energy_results *results)
{
    const struct {
        const char *name;
        const glint_normalization *factor;
    } of[] = {{"smallest-b", &results->claimed},
              {"smallest-b-device", &results->device},
              {"smallest-b-device-verilog", &results->verilog},
              {"least-mean-loss", &results->least_mean},
              {"least-largest-loss", &results->least_largest}};
    for (int i = 0; i < COUNT(of); i++) {
        const glint_normalization *factor = of[i].factor;
        glint_number_add_word(numbers, "energy.factors", of[i].name);
        glint_number_put(numbers, factor->a, "energy.%s.a", of[i].name);
        glint_number_put(numbers, factor->b, "energy.%s.b", of[i].name);
        glint_number_put(numbers, factor->tight_n, "energy.%s.tight-n", of[i].name);
        glint_number_put(numbers, factor->mean_loss, "energy.%s.mean-loss", of[i].name);
        glint_number_put(numbers, factor->largest_loss, "energy.%s.largest-loss", of[i].name);
        glint_number_put(numbers, factor->largest_n, "energy.%s.largest-loss.n", of[i].name);
    }
}

/* A row of spheres in a white furnace. */
static glint_status write_strip(glint_report *report, const glint_energy_table *table, int model,
                                const char *file, glint_error *err)
{
    char name[64];
    glint_image *image;
    snprintf(name, sizeof name, "furnace-%s.png", file);
    glint_status status =
        glint_furnace_picture(table, model, 1, report->quick ? 24 : 48, &image, err);
    if (status != GLINT_OK)
        return status;
    status = glint_report_write_png(report, image, name, err);
    glint_image_destroy(image);
    return status;
}

static glint_status write_furnace(glint_report *report, const glint_energy_plan *plan,
                                  glint_error *err)
{
    glint_energy_plan spheres = *plan;
    glint_energy_table *table = NULL, *verilog = NULL;
    spheres.n = sphere_n;
    spheres.n_count = COUNT(sphere_n);
    for (int i = 0; i < COUNT(sphere_n); i++) {
        char n[16];
        snprintf(n, sizeof n, "%g", sphere_n[i]);
        glint_number_add_word(&report->numbers, "energy.furnace.n", n);
    }
    glint_status status = make_both(&spheres, &table, &verilog, err);
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT && status == GLINT_OK; i++)
        status = write_strip(report, table, i, glint_reflectance_names[i], err);
    if (status == GLINT_OK)
        status = write_strip(report, verilog, 0, "device-verilog", err);
    glint_energy_table_destroy(table);
    glint_energy_table_destroy(verilog);
    return status;
}

/* ---- The whole ------------------------------------------------------------------------------- */

static glint_status measure_rest(glint_report *report, glint_energy_results *results,
                                 glint_error *err)
{
    glint_status status = measure_normal(report, &results->normal, err);
    if (status == GLINT_OK)
        status = measure_reciprocity(report, results, err);
    if (status != GLINT_OK)
        return status;
    search_factors(results);
    put_plan(&report->numbers, results);
    put_models(&report->numbers, results);
    put_factors(&report->numbers, results);
    glint_energy_put(&report->numbers, results);
    status = glint_energy_draw(report, results, err);
    return status == GLINT_OK ? write_furnace(report, &results->grid->plan, err) : status;
}

static void fill_grid(const glint_report *report, grid *axes, glint_energy_plan *plan)
{
    *plan = (glint_energy_plan){.model = axes->model,
                                .model_count = GLINT_REFLECTANCE_COUNT,
                                .n = axes->n,
                                .angle = axes->angle,
                                .f0 = F0,
                                .quadrature = true,
                                .seed = SEED,
                                .threads = report->threads,
                                .stop = report->stop};
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++)
        axes->model[i] = (glint_reflectance_model)i;
    /* In quick mode: every n up to 20, then steps of a quarter; incidences 0, 10 … 80 and 89. */
    for (int n = 1; n <= GLINT_ENERGY_N_MAX; n += report->quick && n >= 20 ? n / 4 : 1)
        axes->n[plan->n_count++] = n;
    if (axes->n[plan->n_count - 1] < GLINT_ENERGY_N_MAX)
        axes->n[plan->n_count++] = GLINT_ENERGY_N_MAX;
    for (int i = 0; i < (report->quick ? COUNT(check_angle) : ANGLES); i++)
        axes->angle[plan->angle_count++] = report->quick ? check_angle[i] : i;
}

static glint_status measure_check(glint_report *report, const glint_energy_plan *plan,
                                  glint_energy_results *results, glint_error *err)
{
    glint_energy_plan fewer = *plan;
    glint_energy_table *table, *verilog;
    fewer.n = check_n;
    fewer.n_count = COUNT(check_n);
    fewer.angle = check_angle;
    fewer.angle_count = COUNT(check_angle);
    fewer.samples = samples_of(report);
    glint_status status = make_both(&fewer, &table, &verilog, err);
    results->check = table;
    results->verilog_check = verilog;
    if (status == GLINT_OK)
        status = measure_rest(report, results, err);
    glint_energy_table_destroy(table);
    glint_energy_table_destroy(verilog);
    return status;
}

static glint_status measure_all(glint_report *report, grid *axes, glint_energy_results *results,
                                glint_error *err)
{
    glint_energy_plan plan;
    glint_energy_table *table, *verilog;
    fill_grid(report, axes, &plan);
    glint_status status = make_both(&plan, &table, &verilog, err);
    results->grid = table;
    results->verilog_grid = verilog;
    if (status == GLINT_OK)
        status = measure_check(report, &plan, results, err);
    glint_energy_table_destroy(table);
    glint_energy_table_destroy(verilog);
    return status;
}

glint_status glint_chapter_energy(glint_report *report, glint_error *err)
{
    grid *axes = calloc(1, sizeof *axes);
    glint_energy_results *results = calloc(1, sizeof *results);
    const glint_status status =
        axes != NULL && results != NULL
            ? measure_all(report, axes, results, err)
            : glint_fail(err, GLINT_NO_MEMORY, "no memory for the chapter on energy");
    free(results);
    free(axes);
    return status;
}
