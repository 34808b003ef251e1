/* Points per second of every highlight unit, in C and through its Verilog, beside the specular
 * device's in the same rounds. */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "bench/bench.h"
#include "bench/rounds.h"
#include "circuit/circuits.h"
#include "circuit/random.h"
#include "circuit/units.h"
#include "rtl/batch.h"

_Static_assert(GLINT_BENCH_UNITS *GLINT_BENCH_UNIT_WAYS <= GLINT_CANDIDATES_MAX,
               "all take turns in one run");

typedef struct workload {
    int count, unit[GLINT_BENCH_UNITS]; /* those that are measured */
    uint32_t cos_code[GLINT_BENCH_POINTS];
    uint8_t r[GLINT_BENCH_POINTS], g[GLINT_BENCH_POINTS], b[GLINT_BENCH_POINTS];
    glint_material material;
    glint_setting setting[GLINT_BENCH_UNITS]; /* of each measured one, as the circuits are */
    glint_rtl *rtl[GLINT_BENCH_UNITS][GLINT_BENCH_UNIT_WAYS]; /* none of GLINT_BENCH_UNIT_C */
} workload;

static const int lanes_of[GLINT_BENCH_UNIT_WAYS] = {
    [GLINT_BENCH_UNIT_C] = 0, [GLINT_BENCH_UNIT_RTL_1] = 1, [GLINT_BENCH_UNIT_RTL_4] = 4};

static const glint_circuit *unit_number(int unit)
{
    const glint_circuit *circuit;
    for (int i = 0; (circuit = glint_circuit_number(i)) != NULL; i++)
        if (glint_is_highlight(circuit) && unit-- == 0)
            return circuit;
    return NULL;
}

glint_setting glint_bench_unit_setting(int unit, int lanes)
{
    glint_setting setting = glint_setting_standard(unit_number(unit));
    if (lanes != 0)
        glint_highlight_set_lanes(&setting, lanes);
    return setting;
}

bool glint_bench_unit_is_in(int unit, const char *verilog)
{
    static const char *const endings[] = {".v", ".sv"};
    const glint_setting setting = glint_bench_unit_setting(unit, 0);
    bool is_in = unit == 0 || verilog == NULL;
    for (size_t i = 0; i < sizeof endings / sizeof endings[0] && !is_in; i++) {
        char path[4096];
        const int length = snprintf(path, sizeof path, "%s/%s%s", verilog,
                                    glint_setting_top(&setting), endings[i]);
        is_in = length < (int)sizeof path && access(path, F_OK) == 0;
    }
    return is_in;
}

static glint_status create_circuits(workload *w, const char *verilog, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int unit = 0; unit < GLINT_BENCH_UNITS; unit++) {
        const int i = w->count;
        if (!glint_bench_unit_is_in(unit, verilog))
            continue;
        w->unit[w->count++] = unit;
        for (int way = 0; way < GLINT_BENCH_UNIT_WAYS && status == GLINT_OK; way++) {
            w->setting[i] = glint_bench_unit_setting(unit, lanes_of[way]);
            w->setting[i].verilog = verilog;
            if (lanes_of[way] != 0)
                status = glint_rtl_open(&w->setting[i], GLINT_RTL_FAST, &w->rtl[i][way], err);
        }
    }
    return status;
}

static void destroy_workload(workload *w)
{
    for (int unit = 0; unit < GLINT_BENCH_UNITS; unit++)
        for (int way = 0; way < GLINT_BENCH_UNIT_WAYS; way++)
            glint_rtl_destroy(w->rtl[unit][way]);
    free(w);
}

static void fill_workload(workload *w)
{
    glint_random random = {1};
    w->material = (glint_material){GLINT_BENCH_N, 255, 200, 120};
    for (int i = 0; i < GLINT_BENCH_POINTS; i++) {
        const double unit = (double)(glint_random_bits(&random) >> 11) * 0x1p-53;
        w->cos_code[i] = glint_cos_code(GLINT_BENCH_LOWEST + (1.0 - GLINT_BENCH_LOWEST) * unit);
    }
}

/* One pass of a measured unit's way over all points. */
static glint_status run_pass(void *work, int candidate, glint_error *err)
{
    workload *w = work;
    const int unit = candidate / GLINT_BENCH_UNIT_WAYS, way = candidate % GLINT_BENCH_UNIT_WAYS;
    if (way == GLINT_BENCH_UNIT_C)
        return glint_highlight_batch(&w->setting[unit], &w->material, w->cos_code,
                                     GLINT_BENCH_POINTS, NULL, w->r, w->g, w->b);
    const glint_points points = {w->cos_code, GLINT_BENCH_POINTS, NULL, w->r, w->g, w->b};
    return glint_rtl_shade(w->rtl[unit][way], &w->material, &points, err);
}

static void summarise(const workload *w, const glint_rounds *rounds, glint_bench_unit_rates *rates)
{
    rates->count = w->count;
    for (int unit = 0; unit < w->count; unit++) {
        rates->name[unit] = unit_number(w->unit[unit])->name;
        for (int way = 0; way < GLINT_BENCH_UNIT_WAYS; way++) {
            const int candidate = unit * GLINT_BENCH_UNIT_WAYS + way;
            rates->points[unit][way] = glint_rounds_rate(rounds, candidate);
            rates->to_specular[unit][way] = glint_rounds_ratio(rounds, candidate, way);
        }
    }
}

glint_status glint_bench_units(const char *verilog, double seconds, const volatile bool *stop,
                               glint_bench_unit_rates *rates, glint_error *err)
{
    glint_rounds rounds;
    workload *w = calloc(1, sizeof *w);
    if (w == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the bench");
    fill_workload(w);
    glint_status status = create_circuits(w, verilog, err);
    if (status == GLINT_OK)
        status = glint_rounds_measure(run_pass, w, w->count * GLINT_BENCH_UNIT_WAYS,
                                      GLINT_BENCH_POINTS, seconds, stop, &rounds, err);
    if (status == GLINT_OK)
        summarise(w, &rounds, rates);
    destroy_workload(w);
    return status;
}
