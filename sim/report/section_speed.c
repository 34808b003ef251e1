/* How fast the formulas are in software: sections 3.1 and 3.4. */
#include "bench/bench.h"
#include "report/sections.h"

/* Rounded as the thesis prints it, 1.7 is reached from here on. */
#define STATED      1.7
#define STATED_FROM 1.65

static void write_table(FILE *out, const glint_bench_formula_rates *rates)
{
    fprintf(out,
            "Million points a second on one thread, n = %d, cosines %.1f to 1; %s. Every loop is "
            "run in turn, seven\nrounds; a rate is the median round, a ratio the median of the "
            "ratios within a round. *Scalar*: one\npoint after the other. *Vectorised*: as the "
            "compiler does it, cos^n by the C library's vector powf.\n\n"
            "| formula | scalar | to Schlick's | vectorised | to Schlick's |\n"
            "|---|--:|--:|--:|--:|\n",
            GLINT_BENCH_N, GLINT_BENCH_LOWEST, glint_formula_flags());
    for (int i = 0; i < GLINT_FORMULA_COUNT; i++)
        fprintf(out, "| %s | %.0f | %.2f | %.0f | %.2f |\n", glint_formula_names[i],
                rates->scalar[i] * 1e-6, rates->scalar_to_schlick[i], rates->vectorised[i] * 1e-6,
                rates->vectorised_to_schlick[i]);
}

static void write_device(FILE *out, const glint_bench_rates *rates)
{
    fprintf(out,
            "| *device*, C model | | | %.0f | |\n"
            "| *device*, Verilog, one lane | %.1f | | | |\n"
            "| *device*, Verilog, 16 lanes | | | %.1f | |\n\n"
            "The *device* gives W and three colours for each of the same points; it is measured in "
            "rounds of its own, so its\nrows have no ratio. The Verilog is simulated, by "
            "Verilator: one point after the other, or 16 a clock.\n",
            rates->points[GLINT_BENCH_C_BATCH] * 1e-6, rates->points[GLINT_BENCH_RTL_1] * 1e-6,
            rates->points[GLINT_BENCH_RTL_16] * 1e-6);
}

static void find_ratio(glint_findings *findings, const char *kind, double ratio)
{
    glint_finding *finding = glint_findings_add(
        findings, ratio >= STATED_FROM ? GLINT_HOLDS : GLINT_DOES_NOT_HOLD, "3.1, 3.4");
    snprintf(finding->claim, sizeof finding->claim,
             "Cosine-quadratic computed %.1f times as fast as Schlick's function in software: %s",
             STATED, kind);
    snprintf(finding->measured, sizeof finding->measured, "%.2f times", ratio);
    snprintf(finding->conditions, sizeof finding->conditions,
             "single precision, n = %d, 8192 cosines in a row, one thread; %s", GLINT_BENCH_N,
             glint_formula_flags());
}

static bool add_numbers(cJSON *numbers, const glint_bench_formula_rates *rates)
{
    bool whole = cJSON_AddStringToObject(numbers, "compiled", glint_formula_flags()) != NULL;
    for (int i = 0; i < GLINT_FORMULA_COUNT; i++) {
        cJSON *object = cJSON_AddObjectToObject(numbers, glint_formula_names[i]);
        whole = whole && object != NULL &&
                cJSON_AddNumberToObject(object, "scalar", rates->scalar[i]) != NULL &&
                cJSON_AddNumberToObject(object, "vectorised", rates->vectorised[i]) != NULL;
    }
    return whole;
}

glint_status glint_section_speed(glint_report *report, glint_error *err)
{
    const double seconds = report->quick ? 0.02 : 0.3;
    glint_bench_formula_rates formulas;
    glint_bench_rates device;
    glint_status status = glint_bench_formulas(seconds, report->stop, &formulas, err);
    if (status == GLINT_OK)
        status = glint_bench_kernels(seconds, report->stop, &device, err);
    if (status != GLINT_OK)
        return status;
    write_table(report->markdown, &formulas);
    write_device(report->markdown, &device);
    find_ratio(report->findings, "one point after the other",
               formulas.scalar_to_schlick[GLINT_FORMULA_COSINE_QUADRATIC]);
    find_ratio(report->findings, "vectorised",
               formulas.vectorised_to_schlick[GLINT_FORMULA_COSINE_QUADRATIC]);
    return add_numbers(report->numbers, &formulas)
               ? GLINT_OK
               : glint_fail(err, GLINT_NO_MEMORY, "no memory for the speeds");
}
