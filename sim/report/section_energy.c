/* The models' energy: section 2.5. */
#include "report/sections.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#include "energy/reciprocity.h"
#include "report/energy_parts.h"
#include "report/place.h"

#define SEED 1

/* White microfacets, Fresnel's F = 1: what is lost is lost between the facets. */
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

/* ---- Measuring ---------------------------------------------------------------------------------
 */

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

/* ---- Text --------------------------------------------------------------------------------------
 */

static void write_method(FILE *out, const glint_energy_results *results)
{
    fprintf(
        out,
        "The directional albedo R(L) = ∫ f_r(L,V) (N·V) dω (2.21), of every model at %d "
        "exponents and %d incidences\nfrom %g° to %g°, by Gauss's quadrature around the half "
        "vector; its error is below %g (lobes), %g (microfacets),\n%g (the device). Lobes are "
        "taken as BRDFs themselves, as (2.23) does; microfacets are white (F = 1),\nwith "
        "roughness m = √(2/(n+2)). A second, independent method, Monte Carlo with %d samples "
        "a cell\n(seed %" PRIu64 ") at %d exponents and %d incidences, is compared with it: the "
        "share of cells within 1, 2 and 3\nstandard errors should be 68, 95 and 99.7 %%. "
        "`glint energy` does both for any n and incidence.\n\n",
        results->grid->plan.n_count, results->grid->plan.angle_count, results->grid->plan.angle[0],
        results->grid->plan.angle[results->grid->plan.angle_count - 1], GLINT_ALBEDO_ERROR_LOBE,
        GLINT_ALBEDO_ERROR_MICROFACET, GLINT_ALBEDO_ERROR_DEVICE, results->check->plan.samples,
        results->check->plan.seed, results->check->plan.n_count, results->check->plan.angle_count);
}

static void write_range(FILE *out, const glint_energy_summary *summary)
{
    if (summary->n_above == 0)
        fputs("| none ", out);
    else
        fprintf(out, "| %d: %g…%g ", summary->n_above, summary->first_above, summary->last_above);
}

static void write_row(FILE *out, const char *name, const glint_energy_summary *grid,
                      const glint_energy_summary *check, double asymmetry)
{
    fprintf(out, "| %s | %.6f | %g | %g° ", name, grid->largest, grid->largest_n,
            grid->largest_angle);
    write_range(out, grid);
    fprintf(out, "| %.0f, %.0f, %.1f | %.3g |\n",
            100.0 * (double)check->within_1 / (double)check->cells,
            100.0 * (double)check->within_2 / (double)check->cells,
            100.0 * (double)check->within_3 / (double)check->cells, asymmetry);
}

static const char *name_of(int model)
{
    return model == GLINT_REFLECTANCE_DEVICE ? "*device*, C model" : glint_reflectance_names[model];
}

static void write_model(FILE *out, const glint_energy_results *results, int model)
{
    glint_energy_summary grid, check;
    glint_energy_summarize(results->grid, model, &grid);
    glint_energy_summarize(results->check, model, &check);
    write_row(out, name_of(model), &grid, &check, results->asymmetry[model]);
}

static void write_verilog(FILE *out, const glint_energy_results *results)
{
    glint_energy_summary grid, check;
    glint_energy_summarize(results->verilog_grid, 0, &grid);
    glint_energy_summarize(results->verilog_check, 0, &check);
    write_row(out, "*device*, Verilog", &grid, &check, results->verilog_asymmetry);
}

static void write_models(FILE *out, const glint_energy_results *results)
{
    fputs(
        "| model | largest R | at n | at | exponents with R above 1 | Monte Carlo, % within 1, 2, "
        "3 | asymmetry |\n|---|--:|--:|--:|---|---|--:|\n",
        out);
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++)
        write_model(out, results, i);
    write_verilog(out, results);
    fprintf(
        out,
        "\n*Asymmetry* is the largest difference of f_r(L,V) from f_r(V,L) (2.20), relative, "
        "over %" PRIu64 " pairs\nof directions, random ones and a grid with the normal and "
        "grazing incidence. The models are functions of cosines\nin which L and V have the same "
        "part.\n\n",
        results->pairs);
}

/* The circuit's own error, apart from the formula's. */
static void write_device(FILE *out, const glint_energy_normal *normal)
{
    double largest = 0.0;
    int largest_n = 0;
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++) {
        const double difference = fabs(normal->device[i] / normal->w[i] - 1.0);
        if (difference > largest) {
            largest = difference;
            largest_n = i + 1;
        }
    }
    fprintf(out,
            "At normal incidence the albedo of the fixed-point *device* differs from the "
            "cosine-quadratic's by at most %.2g %%\n(n = %d) over every n from 1 to %d.\n",
            100.0 * largest, largest_n, GLINT_ENERGY_N_MAX);
}

static void write_factor(FILE *out, const char *what, const glint_normalization *factor)
{
    fprintf(out, "| %s | %.9g | %.9g | %d | %.4f %% | %.2f %% | %d |\n", what, factor->a, factor->b,
            factor->tight_n, 100.0 * factor->mean_loss, 100.0 * factor->largest_loss,
            factor->largest_n);
}

static void write_factors(FILE *out, const glint_energy_results *results)
{
    fprintf(out,
            "\n### The factor (n + A)/B\n\n"
            "The smallest B that keeps R at most 1 at normal incidence for every n from 1 to %d; "
            "*loss* is 1 − R there. %d cells\nof the cosine-quadratic's grid have a larger R at "
            "another incidence.\n\n"
            "| | A | B | R = 1 at n | mean loss | largest loss | at n |\n"
            "|---|--:|--:|--:|--:|--:|--:|\n",
            GLINT_ENERGY_N_MAX,
            glint_energy_above_normal(results->grid, GLINT_REFLECTANCE_COSINE_QUADRATIC));
    write_factor(out, "A of (2.26)", &results->claimed);
    write_factor(out, "the same, *device*, C model", &results->device);
    write_factor(out, "the same, *device*, Verilog", &results->verilog);
    write_factor(out, "least mean loss", &results->least_mean);
    write_factor(out, "least largest loss", &results->least_largest);
}

/* A row of the table: what it says and what its file is called. */
static glint_status write_strip(glint_report *report, const glint_energy_table *table, int model,
                                const char *title, const char *file, glint_error *err)
{
    char name[64];
    glint_place place;
    glint_image *image;
    (void)snprintf(name, sizeof name, "furnace-%s.png", file);
    glint_status status = glint_place_in(report->directory, name, &place, err);
    if (status == GLINT_OK)
        status = glint_furnace_picture(table, model, 1, report->quick ? 24 : 72, &image, err);
    if (status != GLINT_OK)
        return status;
    status = glint_image_write_png(image, place.path, err);
    glint_image_destroy(image);
    fprintf(report->markdown, "| %s | ![%s in the white furnace](%s) |\n", title, file, name);
    return status;
}

static glint_status write_strips(glint_report *report, const glint_energy_table *table,
                                 const glint_energy_table *verilog, glint_error *err)
{
    fputs(
        "\n### In a white furnace\n\n"
        "A sphere in light of 1 from everywhere: each pixel is the albedo at the angle it is seen "
        "at. What loses\nnothing cannot be told from the white around it; grey loses; yellow "
        "(just above 1) over red (1.5) to black\n(3 and more, inside red) gives more than it "
        "gets. From left to right n =",
        report->markdown);
    for (int i = 0; i < table->plan.n_count; i++)
        fprintf(report->markdown, "%s %g", i > 0 ? "," : "", table->plan.n[i]);
    fputs(".\n\n| model | |\n|---|---|\n", report->markdown);
    glint_status status = GLINT_OK;
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT && status == GLINT_OK; i++)
        status = write_strip(report, table, i, name_of(i), glint_reflectance_names[i], err);
    return status == GLINT_OK
               ? write_strip(report, verilog, 0, "*device*, Verilog", "device-verilog", err)
               : status;
}

static glint_status write_furnace(glint_report *report, const glint_energy_plan *plan,
                                  glint_error *err)
{
    glint_energy_plan spheres = *plan;
    glint_energy_table *table = NULL, *verilog = NULL;
    spheres.n = sphere_n;
    spheres.n_count = COUNT(sphere_n);
    const glint_status status = make_both(&spheres, &table, &verilog, err);
    const glint_status written =
        status == GLINT_OK ? write_strips(report, table, verilog, err) : status;
    glint_energy_table_destroy(table);
    glint_energy_table_destroy(verilog);
    return written;
}

static bool add_factor(cJSON *numbers, const char *name, const glint_normalization *factor)
{
    cJSON *object = cJSON_AddObjectToObject(numbers, name);
    return object != NULL && cJSON_AddNumberToObject(object, "a", factor->a) != NULL &&
           cJSON_AddNumberToObject(object, "b", factor->b) != NULL &&
           cJSON_AddNumberToObject(object, "mean_loss", factor->mean_loss) != NULL &&
           cJSON_AddNumberToObject(object, "largest_loss", factor->largest_loss) != NULL;
}

static bool add_model(cJSON *models, const char *name, const glint_energy_table *grid, int model,
                      double asymmetry)
{
    glint_energy_summary summary;
    glint_energy_summarize(grid, model, &summary);
    cJSON *object = cJSON_AddObjectToObject(models, name);
    return object != NULL && cJSON_AddNumberToObject(object, "largest", summary.largest) != NULL &&
           cJSON_AddNumberToObject(object, "largest_n", summary.largest_n) != NULL &&
           cJSON_AddNumberToObject(object, "largest_angle", summary.largest_angle) != NULL &&
           cJSON_AddNumberToObject(object, "exponents_above_1", summary.n_above) != NULL &&
           cJSON_AddNumberToObject(object, "asymmetry", asymmetry) != NULL;
}

static glint_status add_numbers(cJSON *numbers, const glint_energy_results *results,
                                glint_error *err)
{
    cJSON *models = cJSON_AddObjectToObject(numbers, "models");
    bool whole = models != NULL && add_factor(numbers, "smallest_b", &results->claimed) &&
                 add_factor(numbers, "smallest_b_device", &results->device) &&
                 add_factor(numbers, "smallest_b_device_verilog", &results->verilog) &&
                 add_factor(numbers, "least_mean_loss", &results->least_mean) &&
                 add_factor(numbers, "least_largest_loss", &results->least_largest);
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT && whole; i++)
        whole =
            add_model(models, glint_reflectance_names[i], results->grid, i, results->asymmetry[i]);
    whole = whole && add_model(models, "device-verilog", results->verilog_grid, 0,
                               results->verilog_asymmetry);
    return whole ? GLINT_OK
                 : glint_fail(err, GLINT_NO_MEMORY, "no memory for the energy's numbers");
}

/* ---- The whole ---------------------------------------------------------------------------------
 */

static glint_status write_text(glint_report *report, const glint_energy_results *results,
                               glint_error *err)
{
    write_method(report->markdown, results);
    write_models(report->markdown, results);
    write_device(report->markdown, &results->normal);
    glint_status status = glint_energy_draw(report, results, err);
    if (status != GLINT_OK)
        return status;
    write_factors(report->markdown, results);
    status = write_furnace(report, &results->grid->plan, err);
    if (status != GLINT_OK)
        return status;
    glint_energy_find(results, report->findings);
    return add_numbers(report->numbers, results, err);
}

static glint_status measure_rest(glint_report *report, glint_energy_results *results,
                                 glint_error *err)
{
    glint_status status = measure_normal(report, &results->normal, err);
    if (status == GLINT_OK)
        status = measure_reciprocity(report, results, err);
    if (status != GLINT_OK)
        return status;
    search_factors(results);
    return write_text(report, results, err);
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

static glint_status write_section(glint_report *report, grid *axes, glint_energy_results *results,
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

glint_status glint_section_energy(glint_report *report, glint_error *err)
{
    grid *axes = calloc(1, sizeof *axes);
    glint_energy_results *results = calloc(1, sizeof *results);
    const glint_status status =
        axes != NULL && results != NULL
            ? write_section(report, axes, results, err)
            : glint_fail(err, GLINT_NO_MEMORY, "no memory for the section on energy");
    free(results);
    free(axes);
    return status;
}
