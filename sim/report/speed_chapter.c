/* How fast the formulas are in software: sections 3.1 and 3.4. */
#include <stddef.h>

#include "bench/bench.h"
#include "circuit/circuits.h"
#include "report/chapter.h"
#include "report/quantile.h"

/* Runs of the bench, one after the other: how far they lie apart is what its numbers are good for.
 */
#define RUNS 5

#define SECONDS       0.3
#define SECONDS_QUICK 0.02

/* The least, median or largest (share 0, 0.5, 1) of one number of the runs,
 * given where it lies in the struct. */
static double over_runs(const glint_bench_formula_rates run[RUNS], size_t offset, double share)
{
    double values[RUNS];
    for (int i = 0; i < RUNS; i++)
        values[i] = *(const double *)(const void *)((const char *)&run[i] + offset);
    return glint_quantile(values, RUNS, share);
}

#define OFFSET(array, formula)                                                                     \
    (offsetof(glint_bench_formula_rates, array) + (size_t)(formula) * sizeof(double))

static void put_formulas(glint_numbers *numbers, const glint_bench_formula_rates run[RUNS])
{
    for (int i = 0; i < GLINT_FORMULA_COUNT; i++) {
        const struct {
            const char *kind;
            size_t rate, ratio;
        } kinds[] = {{"scalar", OFFSET(scalar, i), OFFSET(scalar_to_schlick, i)},
                     {"vectorised", OFFSET(vectorised, i), OFFSET(vectorised_to_schlick, i)}};
        const char *name = glint_formula_names[i];
        for (int j = 0; j < 2; j++) {
            const double rate = over_runs(run, kinds[j].rate, 0.5);
            glint_number_put(numbers, rate * 1e-6, "speed.%s.%s", name, kinds[j].kind);
            glint_number_put(numbers, over_runs(run, kinds[j].ratio, 0.5), "speed.%s.%s.ratio",
                             name, kinds[j].kind);
            glint_number_put_range(numbers, over_runs(run, kinds[j].ratio, 0.0),
                                   over_runs(run, kinds[j].ratio, 1.0), "speed.%s.%s.ratios", name,
                                   kinds[j].kind);
        }
        glint_number_add_word(numbers, "speed.formulas", name);
    }
}

/* Against the rate of Schlick's function by the same kind of loop, in the same rounds. */
static void put_device(glint_numbers *numbers, const glint_bench_rates *rates)
{
    static const struct {
        const char *name;
        glint_bench_candidate candidate, schlick;
    } rows[] = {{"device", GLINT_BENCH_C_BATCH, GLINT_BENCH_SCHLICK},
                {"device-verilog-1", GLINT_BENCH_RTL_1, GLINT_BENCH_SCHLICK_SCALAR},
                {"device-verilog-16", GLINT_BENCH_RTL_16, GLINT_BENCH_SCHLICK}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const double rate = rates->points[rows[i].candidate];
        glint_number_put(numbers, rate * 1e-6, "speed.%s", rows[i].name);
        glint_number_put(numbers, rate / rates->points[rows[i].schlick], "speed.%s.ratio",
                         rows[i].name);
    }
}

glint_status glint_chapter_speed(glint_report *report, glint_error *err)
{
    glint_bench_formula_rates run[RUNS];
    glint_bench_rates device;
    const glint_setting specular = glint_setting_standard(&glint_circuit_specular);
    const double seconds = report->quick ? SECONDS_QUICK : SECONDS;
    glint_status status = GLINT_OK;
    for (int i = 0; i < RUNS && status == GLINT_OK; i++)
        status =
            glint_bench_formulas(report->quick ? 0.01 : seconds / RUNS, report->stop, &run[i], err);
    if (status == GLINT_OK)
        status = glint_bench_kernels(&specular, seconds, report->stop, &device, err);
    if (status != GLINT_OK)
        return status;
    put_formulas(&report->numbers, run);
    put_device(&report->numbers, &device);
    glint_number_put_text(&report->numbers, glint_formula_flags(), "speed.compiled");
    glint_number_put(&report->numbers, GLINT_BENCH_N, "speed.n");
    glint_number_put(&report->numbers, GLINT_BENCH_POINTS, "speed.points");
    glint_number_put(&report->numbers, GLINT_BENCH_LOWEST, "speed.lowest");
    glint_number_put(&report->numbers, RUNS, "speed.runs");
    return GLINT_OK;
}
