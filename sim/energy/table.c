/* Fills the table of albedos row by row on several threads; see table.h. */
#include "energy/table.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "circuit/random.h"
#include "thread/crew.h"

#define DEGREE (3.14159265358979323846 / 180.0)

/* Two results closer than this are equal, where the samples do not differ among themselves. */
#define ROUNDING 1e-6

typedef struct work {
    glint_energy_table *table;
    glint_albedo_rules rules;
    atomic_int next; /* the row to take */
    int rows;
    atomic_bool failed;
    glint_error err; /* of the row that failed first */
} work;

static uint64_t bits_of(double value)
{
    union {
        double value;
        uint64_t bits;
    } both = {value};
    return both.bits;
}

static uint64_t seed_of(const glint_energy_plan *plan, const glint_reflectance *reflectance,
                        double angle)
{
    glint_random mixed = {plan->seed};
    mixed.state = glint_random_bits(&mixed) ^ (uint64_t)reflectance->model;
    mixed.state = glint_random_bits(&mixed) ^ bits_of(reflectance->n);
    mixed.state = glint_random_bits(&mixed) ^ bits_of(angle);
    return glint_random_bits(&mixed);
}

static void fill_cell(const work *all, const glint_albedo *albedo, double degrees,
                      glint_energy_cell *cell)
{
    const glint_energy_plan *plan = &all->table->plan;
    const double angle = degrees * DEGREE;
    *cell = (glint_energy_cell){NAN, {NAN, NAN}};
    if (plan->quadrature)
        cell->quadrature = glint_albedo_at(albedo, angle);
    if (plan->samples > 0)
        cell->monte_carlo = glint_monte_carlo_albedo(albedo->reflectance, angle, plan->samples,
                                                     seed_of(plan, albedo->reflectance, degrees));
}

/* The model of a row: the plan's, or made in *own. */
static glint_status prepare_row(const glint_energy_plan *plan, int worker, int row,
                                glint_reflectance *own, const glint_reflectance **reflectance,
                                glint_error *err)
{
    const int model = row / plan->n_count;
    const glint_reflectance_parameters parameters = {.n = plan->n[row % plan->n_count],
                                                     .f0 = plan->f0};
    if (plan->prepare != NULL)
        return plan->prepare(plan->prepare_context, worker, &parameters, reflectance, err);
    *reflectance = own;
    return glint_reflectance_prepare(plan->model[model], &parameters, own, err);
}

static void fill_row(work *all, int worker, int row)
{
    const glint_energy_plan *plan = &all->table->plan;
    glint_reflectance own;
    const glint_reflectance *reflectance;
    glint_albedo albedo;
    glint_error err;
    if (prepare_row(plan, worker, row, &own, &reflectance, &err) != GLINT_OK) {
        if (!atomic_exchange(&all->failed, true))
            all->err = err;
        return;
    }
    glint_albedo_prepare(reflectance, &all->rules, &albedo);
    for (int i = 0; i < plan->angle_count; i++)
        fill_cell(all, &albedo, plan->angle[i],
                  &all->table->cell[(size_t)row * (size_t)plan->angle_count + (size_t)i]);
}

static bool stopped(const glint_energy_plan *plan)
{
    return plan->stop != NULL && *plan->stop;
}

static void fill(void *context, int worker)
{
    work *all = context;
    const glint_energy_plan *plan = &all->table->plan;
    int row;
    while (!stopped(plan) && !all->failed && (row = atomic_fetch_add(&all->next, 1)) < all->rows) {
        fill_row(all, worker, row);
        if (worker == 0 && plan->progress != NULL)
            plan->progress(plan->context, (uint64_t)row, (uint64_t)all->rows);
    }
}

static glint_status check(const glint_energy_plan *plan, glint_error *err)
{
    if (plan->samples != 0 && plan->samples < GLINT_SAMPLES_MIN)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "a standard error needs at least %d samples",
                          GLINT_SAMPLES_MIN);
    for (int i = 0; i < plan->angle_count; i++)
        if (!(plan->angle[i] >= 0.0 && plan->angle[i] < 90.0))
            return glint_fail(err, GLINT_BAD_ARGUMENT,
                              "the angle of incidence, %g°, is outside 0…90°", plan->angle[i]);
    return GLINT_OK;
}

static glint_status run(work *all, glint_error *err)
{
    const glint_energy_plan *plan = &all->table->plan;
    const glint_status status = glint_crew_once(plan->threads, fill, all, err);
    if (status != GLINT_OK)
        return status;
    if (all->failed)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "%s", all->err.text);
    return stopped(plan) ? glint_fail(err, GLINT_INTERRUPTED, "interrupted") : GLINT_OK;
}

glint_status glint_energy_table_make(const glint_energy_plan *plan, glint_energy_table **table,
                                     glint_error *err)
{
    glint_status status = check(plan, err);
    if (status != GLINT_OK)
        return status;
    glint_energy_table *made = malloc(sizeof *made);
    work *all = calloc(1, sizeof *all);
    const size_t rows = (size_t)plan->model_count * (size_t)plan->n_count;
    if (made != NULL)
        *made = (glint_energy_table){*plan,
                                     calloc(rows * (size_t)plan->angle_count, sizeof *made->cell)};
    if (made == NULL || all == NULL || made->cell == NULL) {
        status = glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the table of albedos");
    } else {
        all->table = made;
        all->rows = (int)rows;
        glint_albedo_rules_make(1, &all->rules);
        status = run(all, err);
    }
    free(all);
    if (status == GLINT_OK)
        *table = made;
    else
        glint_energy_table_destroy(made);
    return status;
}

void glint_energy_table_destroy(glint_energy_table *table)
{
    if (table != NULL)
        free(table->cell);
    free(table);
}

static void count_apart(const glint_energy_cell *cell, glint_energy_summary *summary)
{
    const double apart = fabs(cell->monte_carlo.mean - cell->quadrature);
    const double errors = apart <= ROUNDING ? 0.0 : apart / cell->monte_carlo.error;
    summary->cells++;
    summary->within_1 += errors <= 1.0;
    summary->within_2 += errors <= 2.0;
    summary->within_3 += errors <= 3.0;
    summary->farthest = fmax(summary->farthest, errors);
}

/* One n; returns whether an albedo is above 1. */
static bool summarize_row(const glint_energy_table *table, int model, int n,
                          glint_energy_summary *summary)
{
    const glint_energy_plan *plan = &table->plan;
    bool above = false;
    for (int i = 0; i < plan->angle_count; i++) {
        const glint_energy_cell *cell = glint_energy_at(table, model, n, i);
        const double r = plan->quadrature ? cell->quadrature : cell->monte_carlo.mean;
        above = above || r > GLINT_ENERGY_ONE;
        if (!(r <= summary->largest)) {
            summary->largest = r;
            summary->largest_n = plan->n[n];
            summary->largest_angle = plan->angle[i];
        }
        if (plan->quadrature && plan->samples > 0)
            count_apart(cell, summary);
    }
    return above;
}

void glint_energy_summarize(const glint_energy_table *table, int model,
                            glint_energy_summary *summary)
{
    *summary = (glint_energy_summary){.largest = -1.0, .first_above = NAN, .last_above = NAN};
    for (int i = 0; i < table->plan.n_count; i++) {
        if (!summarize_row(table, model, i, summary))
            continue;
        summary->n_above++;
        summary->first_above = fmin(summary->first_above, table->plan.n[i]);
        summary->last_above = fmax(summary->last_above, table->plan.n[i]);
    }
}
