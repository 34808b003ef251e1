/* The directional albedo of many models, exponents and incidences, by quadrature, by Monte Carlo,
 * or by both, on several threads. */
#ifndef GLINT_SIM_ENERGY_TABLE_H
#define GLINT_SIM_ENERGY_TABLE_H

#include "energy/albedo.h"
#include "energy/monte_carlo.h"

typedef struct glint_energy_plan {
    const glint_reflectance_model *model;
    int model_count;
    const double *n;
    int n_count;
    const double *angle; /* of incidence, degrees, 0 ≤ angle < 90 */
    int angle_count;
    double f0; /* of the microfacet models */
    /* Replaces glint_reflectance_prepare() in a plan with one model; may be NULL. Its result must
     * stay valid until the same worker, 0 … threads − 1, calls again. */
    glint_status (*prepare)(void *prepare_context, int worker,
                            const glint_reflectance_parameters *parameters,
                            const glint_reflectance **reflectance, glint_error *err);
    void *prepare_context;
    bool quadrature;
    int samples; /* of each cell's Monte Carlo; 0: none */
    uint64_t seed;
    int threads;
    const volatile bool *stop; /* may be NULL */
    /* Called by one thread from time to time; may be NULL. A row is one model and n. */
    void (*progress)(void *context, uint64_t rows_done, uint64_t rows);
    void *context;
} glint_energy_plan;

typedef struct glint_energy_cell {
    double quadrature;          /* NaN if not requested */
    glint_estimate monte_carlo; /* the same */
} glint_energy_cell;

typedef struct glint_energy_table {
    glint_energy_plan plan;
    glint_energy_cell *cell; /* model by model, n by n, angle by angle */
} glint_energy_table;

/* A cell's random numbers depend on the seed, the model, n and the angle alone. GLINT_BAD_ARGUMENT
 * if a model does not accept an n. The caller destroys it; the plan's arrays must outlive it. */
glint_status glint_energy_table_make(const glint_energy_plan *plan, glint_energy_table **table,
                                     glint_error *err);
void glint_energy_table_destroy(glint_energy_table *table); /* NULL is allowed */

static inline const glint_energy_cell *glint_energy_at(const glint_energy_table *table, int model,
                                                       int n, int angle)
{
    const glint_energy_plan *plan = &table->plan;
    return &table->cell[((size_t)model * (size_t)plan->n_count + (size_t)n) *
                            (size_t)plan->angle_count +
                        (size_t)angle];
}

/* An albedo above this counts as more than 1: the quadrature error is smaller. */
#define GLINT_ENERGY_ONE 1.00003

/* One model of a table. Where there is no quadrature, R is Monte Carlo's. */
typedef struct glint_energy_summary {
    double largest; /* R */
    double largest_n, largest_angle;
    int n_above;                    /* exponents with R above 1 at some incidence */
    double first_above, last_above; /* the least and the greatest of them */
    /* Where both methods were used: how far apart, in standard errors. */
    uint64_t cells, within_1, within_2, within_3;
    double farthest;
} glint_energy_summary;

void glint_energy_summarize(const glint_energy_table *table, int model,
                            glint_energy_summary *summary);

#endif
