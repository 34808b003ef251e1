/* Points a second: the C model, the circuits, and the formulas they stand against. */
#define _POSIX_C_SOURCE 200809L

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench/bench.h"
#include "bench/kernels.h"
#include "lockstep/random.h"
#include "rtl/rtl.h"

#define ROUNDS 7

typedef struct workload {
    float cosine[GLINT_BENCH_POINTS], result[GLINT_BENCH_POINTS];
    uint32_t cos_code[GLINT_BENCH_POINTS];
    uint8_t r[GLINT_BENCH_POINTS], g[GLINT_BENCH_POINTS], b[GLINT_BENCH_POINTS];
    glint_material material;
    glint_rtl *rtl[GLINT_BENCH_CANDIDATES]; /* of the RTL candidates, else NULL */
    const volatile bool *stop;
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

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static glint_status create_circuits(workload *w, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int i = 0; status == GLINT_OK && i < GLINT_BENCH_CANDIDATES; i++) {
        const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED,
                                              candidates[i].lanes};
        if (config.lanes != 0)
            status = glint_rtl_create_fast(&config, &w->rtl[i], err);
    }
    return status;
}

static void destroy_workload(workload *w)
{
    for (int i = 0; i < GLINT_BENCH_CANDIDATES; i++)
        glint_rtl_destroy(w->rtl[i]);
    free(w);
}

static glint_status create_workload(workload **created, glint_error *err)
{
    workload *w = calloc(1, sizeof *w);
    if (w == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the bench");
    *created = w;
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
static glint_status run_pass(workload *w, int candidate, glint_error *err)
{
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
        return glint_specular_batch(GLINT_GATE_COSINE, &w->material, w->cos_code, count, NULL, w->r,
                                    w->g, w->b);
    default:
        return glint_rtl_batch(w->rtl[candidate], &w->material, w->cos_code, count, NULL, w->r,
                               w->g, w->b, err);
    }
}

/* Points a second over at least `seconds`, and at least one pass. */
static glint_status measure(workload *w, int candidate, double seconds, double *rate,
                            glint_error *err)
{
    uint64_t passes = 0;
    double start = now(), end;
    do {
        glint_status status = run_pass(w, candidate, err);
        if (status != GLINT_OK)
            return status;
        if (w->stop != NULL && *w->stop)
            return glint_fail(err, GLINT_INTERRUPTED, "interrupted");
        passes++;
        end = now();
    } while (end - start < seconds);
    *rate = (double)(passes * GLINT_BENCH_POINTS) / (end - start);
    return GLINT_OK;
}

static int compare_doubles(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(const double *values, int count)
{
    double sorted[ROUNDS];
    memcpy(sorted, values, (size_t)count * sizeof *values);
    qsort(sorted, (size_t)count, sizeof *sorted, compare_doubles);
    return sorted[count / 2];
}

static void summarise(double rate[GLINT_BENCH_CANDIDATES][ROUNDS], glint_bench_rates *rates)
{
    for (int i = 0; i < GLINT_BENCH_CANDIDATES; i++) {
        double ratio[ROUNDS];
        for (int round = 0; round < ROUNDS; round++)
            ratio[round] = rate[i][round] / rate[GLINT_BENCH_POWF][round];
        rates->points[i] = median(rate[i], ROUNDS);
        rates->to_powf[i] = median(ratio, ROUNDS);
        rates->lanes[i] = candidates[i].lanes;
    }
}

glint_status glint_bench_kernels(double seconds, const volatile bool *stop,
                                 glint_bench_rates *rates, glint_error *err)
{
    double rate[GLINT_BENCH_CANDIDATES][ROUNDS];
    workload *w = NULL;
    glint_status status = create_workload(&w, err);
    if (status == GLINT_OK)
        w->stop = stop;
    for (int round = 0; round < ROUNDS; round++)
        for (int i = 0; status == GLINT_OK && i < GLINT_BENCH_CANDIDATES; i++)
            status = measure(w, i, seconds / ROUNDS, &rate[i][round], err);
    if (status == GLINT_OK)
        summarise(rate, rates);
    if (w != NULL)
        destroy_workload(w);
    return status;
}
