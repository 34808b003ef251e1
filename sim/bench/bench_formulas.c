/* Points per second of the formulas that approximate cosⁿ. */
#include <stdlib.h>

#include "bench/bench.h"
#include "bench/rounds.h"
#include "circuit/random.h"

typedef struct workload {
    float cosine[GLINT_BENCH_POINTS], result[GLINT_BENCH_POINTS];
    glint_formula_constants constants[GLINT_FORMULA_COUNT];
} workload;

/* Candidates: the scalar loops, then the vectorised ones. */
static glint_status run_pass(void *work, int candidate, glint_error *err)
{
    (void)err;
    workload *w = work;
    const glint_formula formula = (glint_formula)(candidate % GLINT_FORMULA_COUNT);
    glint_formula_loop *loop = candidate < GLINT_FORMULA_COUNT ? glint_formula_scalar(formula)
                                                               : glint_formula_vectorised(formula);
    loop(&w->constants[formula], w->cosine, GLINT_BENCH_POINTS, w->result);
    return GLINT_OK;
}

static void fill(workload *w)
{
    glint_random random = {1};
    for (int i = 0; i < GLINT_BENCH_POINTS; i++) {
        const double unit = (double)(glint_random_bits(&random) >> 11) * 0x1p-53;
        w->cosine[i] = (float)(GLINT_BENCH_LOWEST + (1.0 - GLINT_BENCH_LOWEST) * unit);
    }
    for (int i = 0; i < GLINT_FORMULA_COUNT; i++)
        w->constants[i] = glint_formula_prepare((glint_formula)i, GLINT_BENCH_N);
}

glint_status glint_bench_formulas(double seconds, const volatile bool *stop,
                                  glint_bench_formula_rates *rates, glint_error *err)
{
    glint_rounds rounds;
    workload *w = calloc(1, sizeof *w);
    if (w == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the bench");
    fill(w);
    const glint_status status = glint_rounds_measure(
        run_pass, w, 2 * GLINT_FORMULA_COUNT, GLINT_BENCH_POINTS, seconds, stop, &rounds, err);
    free(w);
    for (int i = 0; status == GLINT_OK && i < GLINT_FORMULA_COUNT; i++) {
        const int vectorised = GLINT_FORMULA_COUNT + i;
        rates->scalar[i] = glint_rounds_rate(&rounds, i);
        rates->vectorised[i] = glint_rounds_rate(&rounds, vectorised);
        rates->scalar_to_schlick[i] = glint_rounds_ratio(&rounds, i, GLINT_FORMULA_SCHLICK);
        rates->vectorised_to_schlick[i] =
            glint_rounds_ratio(&rounds, vectorised, GLINT_FORMULA_COUNT + GLINT_FORMULA_SCHLICK);
    }
    return status;
}
