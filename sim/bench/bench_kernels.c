/* Points per second of the C model, the circuits, and the baseline formulas. */
#include <stdlib.h>

#include "bench/bench.h"
#include "bench/kernels.h"
#include "bench/rounds.h"
#include "circuit/circuits.h"
#include "circuit/random.h"
#include "circuit/units.h"
#include "rtl/batch.h"

typedef struct workload {
    float cosine[GLINT_BENCH_POINTS], result[GLINT_BENCH_POINTS];
    uint32_t cos_code[GLINT_BENCH_POINTS];
    uint8_t r[GLINT_BENCH_POINTS], g[GLINT_BENCH_POINTS], b[GLINT_BENCH_POINTS];
    glint_material material;
    glint_setting device;
    glint_rtl *rtl[GLINT_BENCH_CANDIDATES]; /* of the RTL candidates, else NULL */
} workload;

static const struct {
    const char *name;
    int lanes;
} candidates[GLINT_BENCH_CANDIDATES] = {
    [GLINT_BENCH_POWF] = {"powf", 0},
    [GLINT_BENCH_POW] = {"pow", 0},
    [GLINT_BENCH_SCHLICK_SCALAR] = {"schlick-scalar", 0},
    [GLINT_BENCH_SCHLICK] = {"schlick", 0},
    [GLINT_BENCH_C_BATCH] = {"c-batch", 0},
    [GLINT_BENCH_RTL_1] = {"rtl-1", 1},
    [GLINT_BENCH_RTL_2] = {"rtl-2", 2},
    [GLINT_BENCH_RTL_4] = {"rtl-4", 4},
    [GLINT_BENCH_RTL_8] = {"rtl-8", 8},
    [GLINT_BENCH_RTL_16] = {"rtl-16", 16},
};

const char *glint_bench_name(glint_bench_candidate candidate)
{
    return candidates[candidate].name;
}

static glint_status create_circuits(workload *w, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int i = 0; status == GLINT_OK && i < GLINT_BENCH_CANDIDATES; i++) {
        glint_setting setting = w->device;
        if (candidates[i].lanes == 0)
            continue;
        glint_highlight_set_lanes(&setting, candidates[i].lanes);
        status = glint_rtl_open(&setting, GLINT_RTL_FAST, &w->rtl[i], err);
    }
    return status;
}

static void destroy_workload(workload *w)
{
    for (int i = 0; i < GLINT_BENCH_CANDIDATES; i++)
        glint_rtl_destroy(w->rtl[i]);
    free(w);
}

static glint_status create_workload(const glint_setting *device, workload **created,
                                    glint_error *err)
{
    workload *w = calloc(1, sizeof *w);
    if (w == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the bench");
    *created = w;
    w->device = *device;
    glint_random random = {1};
    w->material = (glint_material){GLINT_BENCH_N, 255, 200, 120};
    for (int i = 0; i < GLINT_BENCH_POINTS; i++) {
        double unit = (double)(glint_random_bits(&random) >> 11) * 0x1p-53;
        double cosine = GLINT_BENCH_LOWEST + (1.0 - GLINT_BENCH_LOWEST) * unit;
        w->cos_code[i] = glint_cos_code(cosine);
        w->cosine[i] = (float)cosine;
    }
    return create_circuits(w, err);
}

/* One pass of a candidate over all points. */
static glint_status run_pass(void *work, int candidate, glint_error *err)
{
    workload *w = work;
    const size_t count = GLINT_BENCH_POINTS;
    switch (candidate) {
    case GLINT_BENCH_POWF:
        glint_kernel_powf(w->cosine, count, GLINT_BENCH_N, w->result);
        return GLINT_OK;
    case GLINT_BENCH_POW:
        glint_kernel_pow(w->cosine, count, GLINT_BENCH_N, w->result);
        return GLINT_OK;
    case GLINT_BENCH_SCHLICK_SCALAR:
        glint_kernel_schlick_scalar(w->cosine, count, GLINT_BENCH_N, w->result);
        return GLINT_OK;
    case GLINT_BENCH_SCHLICK:
        glint_kernel_schlick(w->cosine, count, GLINT_BENCH_N, w->result);
        return GLINT_OK;
    case GLINT_BENCH_C_BATCH:
        return glint_highlight_batch(&w->device, &w->material, w->cos_code, count, NULL, w->r, w->g,
                                     w->b);
    default:
        return glint_rtl_shade(w->rtl[candidate], &w->material,
                               &(glint_points){w->cos_code, count, NULL, w->r, w->g, w->b}, err);
    }
}

static void summarise(const glint_rounds *rounds, glint_bench_rates *rates)
{
    for (int i = 0; i < GLINT_BENCH_CANDIDATES; i++) {
        rates->points[i] = glint_rounds_rate(rounds, i);
        rates->to_powf[i] = glint_rounds_ratio(rounds, i, GLINT_BENCH_POWF);
        rates->lanes[i] = candidates[i].lanes;
    }
}

glint_status glint_bench_kernels(const glint_setting *device, double seconds,
                                 const volatile bool *stop, glint_bench_rates *rates,
                                 glint_error *err)
{
    glint_rounds rounds;
    workload *w = NULL;
    glint_status status = create_workload(device, &w, err);
    if (status == GLINT_OK)
        status = glint_rounds_measure(run_pass, w, GLINT_BENCH_CANDIDATES, GLINT_BENCH_POINTS,
                                      seconds, stop, &rounds, err);
    if (status == GLINT_OK)
        summarise(&rounds, rates);
    if (w != NULL)
        destroy_workload(w);
    return status;
}
