/* The parts of the chapter on energy. */
#ifndef GLINT_SIM_REPORT_ENERGY_H
#define GLINT_SIM_REPORT_ENERGY_H

#include "energy/furnace.h"
#include "energy/normalization.h"
#include "report/chapter.h"

#define GLINT_ENERGY_N_MAX 1000

/* A of (2.26). */
#define GLINT_ENERGY_A 6.0

/* Albedos at normal incidence for n = 1…1000, number n − 1. */
typedef struct glint_energy_normal {
    double w[GLINT_ENERGY_N_MAX];          /* the cosine-quadratic */
    double with_limit[GLINT_ENERGY_N_MAX]; /* (2.25) with dθ₀ for dω₀, to its limit 5.8/√n */
    double held[GLINT_ENERGY_N_MAX];       /* the same with a limit of at most π/2 */
    double claimed[GLINT_ENERGY_N_MAX];    /* (2.26) */
    double blinn[GLINT_ENERGY_N_MAX];      /* with (n+6)/(8π) */
    double device[GLINT_ENERGY_N_MAX], verilog[GLINT_ENERGY_N_MAX];
    double half_angle[GLINT_ENERGY_N_MAX];  /* (2.24) as printed, with (cos θ₀)/2 */
    double solid_angle[GLINT_ENERGY_N_MAX]; /* held, but with dω₀ = sin θ₀ dθ₀ */
    double zero[GLINT_ENERGY_N_MAX];        /* the angle θ₀ at which W is zero, times √n */
    double centre[GLINT_ENERGY_N_MAX];      /* of (2.24)'s highlight */
} glint_energy_normal;

typedef struct glint_energy_results {
    glint_energy_normal normal;
    const glint_energy_table *grid;  /* every model, by quadrature */
    const glint_energy_table *check; /* every model, by both methods, at fewer n and angles */
    const glint_energy_table *verilog_grid, *verilog_check; /* the same, of the Verilog alone */
    double asymmetry[GLINT_REFLECTANCE_COUNT];              /* the largest of (2.20), relative */
    double verilog_asymmetry;
    uint64_t pairs;    /* compared for it, for each model */
    int pairs_n_count; /* at so many exponents */
    double pairs_n_first, pairs_n_last;
    glint_normalization claimed;         /* A = 6 with the smallest B */
    glint_normalization device, verilog; /* the same for the circuit's W */
    glint_normalization least_mean;      /* the best A and B by the one loss and by the other */
    glint_normalization least_largest;
} glint_energy_results;

/* The plan's exponents and incidences, for the one model `device` with the W of the Verilog. To be
 * destroyed; the plan's arrays must outlive it. */
glint_status glint_energy_verilog_table(const glint_energy_plan *plan, glint_energy_table **table,
                                        glint_error *err);
/* At normal incidence, by quadrature, n = 1…1000. */
glint_status glint_energy_verilog_normal(const glint_report *report,
                                         double albedo[GLINT_ENERGY_N_MAX], glint_error *err);
/* The largest asymmetry of (2.20) over `count` exponents, each as glint_reciprocity_measure(). */
glint_status glint_energy_verilog_asymmetry(const double *n, int count, uint64_t pairs,
                                            uint64_t seed, double *largest, glint_error *err);

/* Figures 2.15 and 2.16, and the albedo against the incidence, with the numbers energy.smallest.…,
 * energy.best.… and energy.angle.…. */
glint_status glint_energy_draw(glint_report *report, const glint_energy_results *results,
                               glint_error *err);

/* The numbers energy.NAME.…: at how many of the exponents 1…1000 the albedo is above 1, the first
 * and the last of them, and the largest albedo. */
void glint_energy_put_curve(glint_numbers *numbers, const char *name,
                            const double albedo[GLINT_ENERGY_N_MAX]);

/* The numbers behind the claims of section 2.5. */
void glint_energy_put(glint_numbers *numbers, const glint_energy_results *results);

#endif
