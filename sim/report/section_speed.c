/* How fast the formulas are in software: sections 3.1 and 3.4. */
#include <stddef.h>

#include "report/quantile.h"
#include "report/sections.h"
#include "report/speeds.h"

#define SAY(text, ...) snprintf(text, sizeof text, __VA_ARGS__)

#define STATED          1.7
#define STATED_DECIMALS 1

/* Of one number of a run, given where it lies in the struct; share as in glint_quantile(). */
static double over_runs(const glint_speeds *s, size_t offset, double share)
{
    double values[GLINT_SPEED_RUNS];
    for (int i = 0; i < GLINT_SPEED_RUNS; i++)
        values[i] = *(const double *)(const void *)((const char *)&s->run[i] + offset);
    return glint_quantile(values, GLINT_SPEED_RUNS, share);
}

#define OFFSET(array, formula)                                                                     \
    (offsetof(glint_bench_formula_rates, array) + (size_t)(formula) * sizeof(double))

static void take_medians(glint_speeds *s)
{
    for (int i = 0; i < GLINT_FORMULA_COUNT; i++) {
        s->median.scalar[i] = over_runs(s, OFFSET(scalar, i), 0.5);
        s->median.vectorised[i] = over_runs(s, OFFSET(vectorised, i), 0.5);
        s->median.scalar_to_schlick[i] = over_runs(s, OFFSET(scalar_to_schlick, i), 0.5);
        s->median.vectorised_to_schlick[i] = over_runs(s, OFFSET(vectorised_to_schlick, i), 0.5);
    }
    const double *points = s->device.points;
    for (int i = 0; i < GLINT_BENCH_CANDIDATES; i++)
        s->device_to_schlick[i] =
            points[i] /
            points[i == GLINT_BENCH_RTL_1 ? GLINT_BENCH_SCHLICK_SCALAR : GLINT_BENCH_SCHLICK];
}

static glint_status measure(const glint_report *report, glint_speeds *s, glint_error *err)
{
    const double seconds = report->quick ? 0.02 : 0.3;
    glint_status status = GLINT_OK;
    for (int i = 0; i < GLINT_SPEED_RUNS && status == GLINT_OK; i++)
        status = glint_bench_formulas(report->quick ? 0.01 : seconds / GLINT_SPEED_RUNS,
                                      report->stop, &s->run[i], err);
    if (status == GLINT_OK)
        status = glint_bench_kernels(NULL, seconds, report->stop, &s->device, err);
    if (status == GLINT_OK)
        take_medians(s);
    return status;
}

static void write_table(FILE *out, const glint_bench_formula_rates *rates)
{
    fprintf(out,
            "Million points a second on one thread, n = %d, cosines %.1f to 1; %s. Every loop is "
            "run in turn, seven\nrounds, the whole %d times; a rate is the median round, a ratio "
            "the median of the ratios within a round,\nof each the median of the %d runs. "
            "*Scalar*: one point after the other. *Vectorised*: as the compiler does it,\ncos^n by "
            "the C library's vector powf.\n\n"
            "| formula | scalar | to Schlick's | vectorised | to Schlick's |\n"
            "|---|--:|--:|--:|--:|\n",
            GLINT_BENCH_N, GLINT_BENCH_LOWEST, glint_formula_flags(), GLINT_SPEED_RUNS,
            GLINT_SPEED_RUNS);
    for (int i = 0; i < GLINT_FORMULA_COUNT; i++)
        fprintf(out, "| %s | %.0f | %.2f | %.0f | %.2f |\n", glint_formula_names[i],
                rates->scalar[i] * 1e-6, rates->scalar_to_schlick[i], rates->vectorised[i] * 1e-6,
                rates->vectorised_to_schlick[i]);
}

static void write_device(FILE *out, const glint_speeds *s)
{
    const double *points = s->device.points, *ratio = s->device_to_schlick;
    fprintf(out,
            "| *device*, C model | | | %.0f | %.3f |\n"
            "| *device*, Verilog, one lane | %.1f | %.4f | | |\n"
            "| *device*, Verilog, 16 lanes | | | %.1f | %.4f |\n\n"
            "The *device* gives W and three colours for each of the same points; it is measured in "
            "rounds of its own, its ratios\nare to the rate that Schlick's function has in them. "
            "The Verilog is simulated, by Verilator: one point after the other, or\n16 a clock.\n",
            points[GLINT_BENCH_C_BATCH] * 1e-6, ratio[GLINT_BENCH_C_BATCH],
            points[GLINT_BENCH_RTL_1] * 1e-6, ratio[GLINT_BENCH_RTL_1],
            points[GLINT_BENCH_RTL_16] * 1e-6, ratio[GLINT_BENCH_RTL_16]);
}

/* offset: of the ratio that is claimed. */
static void find_ratio(glint_findings *findings, const glint_speeds *s, const char *kind,
                       size_t offset)
{
    const glint_judged judged = {.rule = GLINT_REACHES,
                                 .stated = STATED,
                                 .decimals = STATED_DECIMALS,
                                 .lowest = over_runs(s, offset, 0.0),
                                 .highest = over_runs(s, offset, 1.0)};
    glint_finding *finding = glint_findings_add(findings, "3.1, 3.4", &judged);
    SAY(finding->claim,
        "Cosine-quadratic computed %.1f times as fast as Schlick's function in software: %s",
        STATED, kind);
    SAY(finding->measured, "%.2f times, the median of %.2f to %.2f", over_runs(s, offset, 0.5),
        judged.lowest, judged.highest);
    SAY(finding->conditions,
        "single precision, n = %d, %d cosines in a row, %.1f to 1, one thread, this machine, %d "
        "runs; %s; it holds where all runs are at %.2f or above, which rounds to %.1f or more, "
        "does "
        "not hold where all are below, else it cannot be decided",
        GLINT_BENCH_N, GLINT_BENCH_POINTS, GLINT_BENCH_LOWEST, GLINT_SPEED_RUNS,
        glint_formula_flags(), STATED - 0.05, STATED);
}

void glint_speeds_find(const glint_speeds *s, glint_findings *findings)
{
    find_ratio(findings, s, "one point after the other",
               OFFSET(scalar_to_schlick, GLINT_FORMULA_COSINE_QUADRATIC));
    find_ratio(findings, s, "vectorised",
               OFFSET(vectorised_to_schlick, GLINT_FORMULA_COSINE_QUADRATIC));
}

static bool add_rate(cJSON *object, const char *kind, double rate, double to_schlick)
{
    char name[64];
    snprintf(name, sizeof name, "%s_to_schlick", kind);
    return cJSON_AddNumberToObject(object, kind, rate) != NULL &&
           cJSON_AddNumberToObject(object, name, to_schlick) != NULL;
}

static bool add_device(cJSON *numbers, const glint_speeds *s)
{
    static const struct {
        const char *name, *kind;
        glint_bench_candidate candidate;
    } rows[] = {{"device", "vectorised", GLINT_BENCH_C_BATCH},
                {"device-verilog-1", "scalar", GLINT_BENCH_RTL_1},
                {"device-verilog-16", "vectorised", GLINT_BENCH_RTL_16}};
    bool whole = true;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0] && whole; i++) {
        cJSON *object = cJSON_AddObjectToObject(numbers, rows[i].name);
        whole =
            object != NULL && add_rate(object, rows[i].kind, s->device.points[rows[i].candidate],
                                       s->device_to_schlick[rows[i].candidate]);
    }
    return whole;
}

static bool add_numbers(cJSON *numbers, const glint_speeds *s)
{
    const glint_bench_formula_rates *rates = &s->median;
    bool whole = cJSON_AddStringToObject(numbers, "compiled", glint_formula_flags()) != NULL;
    for (int i = 0; i < GLINT_FORMULA_COUNT; i++) {
        cJSON *object = cJSON_AddObjectToObject(numbers, glint_formula_names[i]);
        whole =
            whole && object != NULL &&
            add_rate(object, "scalar", rates->scalar[i], rates->scalar_to_schlick[i]) &&
            add_rate(object, "vectorised", rates->vectorised[i], rates->vectorised_to_schlick[i]);
    }
    return whole && add_device(numbers, s);
}

glint_status glint_section_speed(glint_report *report, glint_error *err)
{
    glint_speeds s;
    const glint_status status = measure(report, &s, err);
    if (status != GLINT_OK)
        return status;
    write_table(report->markdown, &s.median);
    write_device(report->markdown, &s);
    glint_speeds_find(&s, report->findings);
    return add_numbers(report->numbers, &s)
               ? GLINT_OK
               : glint_fail(err, GLINT_NO_MEMORY, "no memory for the speeds");
}
