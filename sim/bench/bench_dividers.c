/* Divisions a second: the C model, both forms of the circuit, and the machine's own division. */
#include <stdlib.h>

#include "bench/bench.h"
#include "bench/kernels.h"
#include "bench/rounds.h"
#include "circuit/circuits.h"
#include "circuit/random.h"
#include "rtl/batch.h"

#define TRIPLES (GLINT_BENCH_DIVISIONS / GLINT_DIVIDER_COMPONENTS)

typedef struct workload {
    glint_division divisions[TRIPLES];
    glint_quotients quotients[TRIPLES];
    float difference[GLINT_BENCH_DIVISIONS], k[GLINT_BENCH_DIVISIONS];
    float result[GLINT_BENCH_DIVISIONS];
    glint_rtl *rtl[GLINT_BENCH_DIVIDERS]; /* of the circuits, else NULL */
    uint64_t passes[GLINT_BENCH_DIVIDERS];
} workload;

static const char *const names[GLINT_BENCH_DIVIDERS] = {
    [GLINT_BENCH_INTEGER_DIVISION] = "integer",
    [GLINT_BENCH_FLOAT_DIVISION_SCALAR] = "float-scalar",
    [GLINT_BENCH_FLOAT_DIVISION] = "float",
    [GLINT_BENCH_DIVIDER_C_BATCH] = "c-batch",
    [GLINT_BENCH_DIVIDER_SEQUENTIAL] = "rtl-sequential",
    [GLINT_BENCH_DIVIDER_PIPELINED] = "rtl-pipelined",
};

const char *glint_bench_divider_name(glint_bench_divider candidate)
{
    return names[candidate];
}

static void destroy_workload(workload *w)
{
    for (int i = 0; i < GLINT_BENCH_DIVIDERS; i++)
        glint_rtl_destroy(w->rtl[i]);
    free(w);
}

static void fill(workload *w)
{
    glint_random random = {1};
    for (int i = 0; i < TRIPLES; i++) {
        const uint64_t bits = glint_random_bits(&random);
        w->divisions[i].k = (uint8_t)(1 + bits % GLINT_DIVIDER_K_MAX);
        for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++) {
            const int range = 2 * GLINT_DIVIDER_DIFFERENCE_MAX + 1;
            const int difference =
                (int)(bits >> (16 + 16 * c) & 0xffff) % range - GLINT_DIVIDER_DIFFERENCE_MAX;
            const int at = GLINT_DIVIDER_COMPONENTS * i + c;
            w->divisions[i].difference[c] = (int16_t)difference;
            w->difference[at] = (float)difference;
            w->k[at] = (float)w->divisions[i].k;
        }
    }
}

static glint_status create_circuit(workload *w, const char *verilog, glint_divider_form form,
                                   glint_bench_divider candidate, glint_error *err)
{
    glint_setting setting = glint_setting_divider(form, GLINT_BENCH_SHIFTS);
    setting.verilog = verilog;
    return glint_rtl_open(&setting, GLINT_RTL_FAST, &w->rtl[candidate], err);
}

static glint_status create_workload(const char *verilog, workload **created, glint_error *err)
{
    workload *w = calloc(1, sizeof *w);
    if (w == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the bench");
    *created = w;
    fill(w);
    glint_status status =
        create_circuit(w, verilog, GLINT_DIVIDER_SEQUENTIAL, GLINT_BENCH_DIVIDER_SEQUENTIAL, err);
    if (status == GLINT_OK)
        status =
            create_circuit(w, verilog, GLINT_DIVIDER_PIPELINED, GLINT_BENCH_DIVIDER_PIPELINED, err);
    return status;
}

/* One pass of a candidate over all divisions. */
static glint_status run_pass(void *work, int candidate, glint_error *err)
{
    workload *w = work;
    w->passes[candidate]++;
    switch (candidate) {
    case GLINT_BENCH_INTEGER_DIVISION:
        glint_kernel_integer_division(GLINT_BENCH_SHIFTS, w->divisions, TRIPLES, w->quotients);
        return GLINT_OK;
    case GLINT_BENCH_FLOAT_DIVISION_SCALAR:
        glint_kernel_float_division_scalar(w->difference, w->k, GLINT_BENCH_DIVISIONS, w->result);
        return GLINT_OK;
    case GLINT_BENCH_FLOAT_DIVISION:
        glint_kernel_float_division(w->difference, w->k, GLINT_BENCH_DIVISIONS, w->result);
        return GLINT_OK;
    case GLINT_BENCH_DIVIDER_C_BATCH:
        return glint_divide_batch(GLINT_BENCH_SHIFTS, w->divisions, TRIPLES, w->quotients);
    default:
        return glint_rtl_divide(w->rtl[candidate], w->divisions, TRIPLES, w->quotients, err);
    }
}

static void summarise(const workload *w, const glint_rounds *rounds,
                      glint_bench_divider_rates *rates)
{
    for (int i = 0; i < GLINT_BENCH_DIVIDERS; i++) {
        rates->divisions[i] = glint_rounds_rate(rounds, i);
        rates->to_integer[i] = glint_rounds_ratio(rounds, i, GLINT_BENCH_INTEGER_DIVISION);
        rates->to_float[i] = glint_rounds_ratio(rounds, i, GLINT_BENCH_FLOAT_DIVISION);
        rates->clocks[i] = 0.0;
        if (w->rtl[i] != NULL)
            rates->clocks[i] = rates->divisions[i] * (double)glint_rtl_clocks(w->rtl[i]) /
                               ((double)w->passes[i] * GLINT_BENCH_DIVISIONS);
    }
}

glint_status glint_bench_dividers(const char *verilog, double seconds, const volatile bool *stop,
                                  glint_bench_divider_rates *rates, glint_error *err)
{
    glint_rounds rounds;
    workload *w = NULL;
    glint_status status = create_workload(verilog, &w, err);
    if (status == GLINT_OK)
        status = glint_rounds_measure(run_pass, w, GLINT_BENCH_DIVIDERS, GLINT_BENCH_DIVISIONS,
                                      seconds, stop, &rounds, err);
    if (status == GLINT_OK)
        summarise(w, &rounds, rates);
    if (w != NULL)
        destroy_workload(w);
    return status;
}
