#include "bench.h"

#include <string.h>

#include "circuit/random_pins.h"
#include "sweep.h"

typedef enum kind { SPECULAR, SEQUENTIAL, PIPELINED } kind;

static kind kind_of(const glint_setting *setting)
{
    if (!setting->is_divider)
        return SPECULAR;
    return setting->form == GLINT_DIVIDER_SEQUENTIAL ? SEQUENTIAL : PIPELINED;
}

int mutation_pin_count(const glint_setting *setting)
{
    return kind_of(setting) == SEQUENTIAL ? 4 : 5;
}

const char *mutation_pin_name(const glint_setting *setting, int pin)
{
    static const char *const names[][MUTATION_PINS_MAX] = {
        [SPECULAR] = {"out_valid", "out_w", "out_r", "out_g", "out_b"},
        [SEQUENTIAL] = {"busy", "done", "out_of_table", "quotient"},
        [PIPELINED] = {"out_valid", "out_of_table", "quotient_r", "quotient_g", "quotient_b"},
    };
    return names[kind_of(setting)][pin];
}

uint64_t mutation_sweep_clocks(const mutation_netlist_table *netlist)
{
    switch (kind_of(&netlist->setting)) {
    case SPECULAR:
        return mutation_sweep_specular_clocks();
    case SEQUENTIAL:
        return mutation_sweep_sequential_clocks(netlist->setting.shifts);
    default:
        return mutation_sweep_pipelined_clocks(netlist->setting.shifts);
    }
}

/* The C model, the netlist, and where the pins come from. */
typedef struct pair {
    const mutation_netlist_table *netlist;
    void *instance;
    glint_specular_device *specular; /* or */
    glint_divider_device *divider;
    glint_random_pins random;
    mutation_sweep sweep;
    const glint_specular_inputs *point;
} pair;

/* One test: where the pins come from, for how long, and what registers held before the reset. */
typedef struct test {
    const char *name;
    void (*next)(pair *pair, uint64_t clock, glint_pins *inputs);
    uint64_t clocks;
    bool ones;
} test;

enum { POINT_CLOCKS = 8 }; /* the latency, and some more */

static glint_status create_pair(const mutation_netlist_table *netlist, uint32_t mutant,
                                const mutation_effort *effort, bool ones, pair *pair,
                                glint_error *err)
{
    const glint_setting *setting = &netlist->setting;
    memset(pair, 0, sizeof *pair);
    pair->netlist = netlist;
    pair->point = effort->point;
    pair->instance = netlist->create(mutant, ones);
    if (pair->instance == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the netlist of %s",
                          netlist->circuit);
    glint_random_pins_begin(&pair->random, setting, effort->seed);
    const glint_status status =
        setting->is_divider
            ? glint_divider_device_create(setting->form, setting->shifts, &pair->divider)
            : glint_specular_device_create(&setting->specular, &pair->specular);
    return status == GLINT_OK ? status
                              : glint_fail(err, status, "no C model of %s", netlist->circuit);
}

static void destroy_pair(pair *pair)
{
    if (pair->instance != NULL)
        pair->netlist->destroy(pair->instance);
    glint_specular_device_destroy(pair->specular);
    glint_divider_device_destroy(pair->divider);
}

static void random_inputs(pair *pair, uint64_t clock, glint_pins *inputs)
{
    (void)clock;
    glint_random_pins_next(&pair->random, inputs);
}

static void sweep_inputs(pair *pair, uint64_t clock, glint_pins *inputs)
{
    const glint_setting *setting = &pair->netlist->setting;
    memset(inputs, 0, sizeof *inputs);
    switch (kind_of(setting)) {
    case SPECULAR:
        mutation_sweep_specular(&pair->sweep, &inputs->specular);
        break;
    case SEQUENTIAL:
        mutation_sweep_sequential(setting->shifts, clock, &inputs->divider);
        break;
    default:
        mutation_sweep_pipelined(clock, &inputs->divider);
    }
}

static void point_inputs(pair *pair, uint64_t clock, glint_pins *inputs)
{
    (void)clock;
    inputs->specular = *pair->point;
}

static void clock_specular(glint_specular_device *model, const glint_specular_inputs *inputs,
                           uint32_t *pins)
{
    glint_specular_device_clock(model, inputs);
    const glint_specular_signals *s = glint_specular_device_signals(model);
    pins[0] = (uint32_t)s->out_valid;
    pins[1] = (uint32_t)s->lane[0].out_w;
    pins[2] = (uint32_t)s->lane[0].out_r;
    pins[3] = (uint32_t)s->lane[0].out_g;
    pins[4] = (uint32_t)s->lane[0].out_b;
}

static void clock_divider(const glint_setting *setting, glint_divider_device *model,
                          const glint_divider_inputs *inputs, uint32_t *pins)
{
    const uint32_t mask = (1u << (GLINT_DIVIDER_DIFFERENCE_BITS + setting->shifts)) - 1u;
    glint_divider_device_clock(model, inputs);
    if (kind_of(setting) == SEQUENTIAL) {
        const glint_divider_sequential_signals *s = glint_divider_device_sequential(model);
        pins[0] = (uint32_t)s->busy;
        pins[1] = (uint32_t)s->done;
        pins[2] = (uint32_t)s->out_of_table;
        pins[3] = (uint32_t)s->quotient & mask;
    } else {
        const glint_divider_pipelined_signals *s = glint_divider_device_pipelined(model);
        pins[0] = (uint32_t)s->out_valid;
        pins[1] = (uint32_t)s->out_of_table;
        pins[2] = (uint32_t)s->quotient_r & mask;
        pins[3] = (uint32_t)s->quotient_g & mask;
        pins[4] = (uint32_t)s->quotient_b & mask;
    }
}

/* Clocks both sides; false, with the verdict, when a pin differs. */
static bool clock_pair(pair *pair, const glint_pins *inputs, mutation_verdict *verdict)
{
    const glint_setting *setting = &pair->netlist->setting;
    uint32_t model[MUTATION_PINS_MAX], netlist[MUTATION_PINS_MAX];
    if (pair->specular != NULL)
        clock_specular(pair->specular, &inputs->specular, model);
    else
        clock_divider(setting, pair->divider, &inputs->divider, model);
    pair->netlist->clock(pair->instance, inputs, netlist);
    verdict->clocks++;
    for (int i = 0; i < mutation_pin_count(setting); i++) {
        if (model[i] != netlist[i]) {
            verdict->killed = true;
            verdict->pin = mutation_pin_name(setting, i);
            verdict->model = model[i];
            verdict->netlist = netlist[i];
            return false;
        }
    }
    return true;
}

static bool stopped(const mutation_effort *effort, uint64_t clock)
{
    return clock % 1024 == 0 && effort->stop != NULL && *effort->stop;
}

static glint_status run_test(const mutation_netlist_table *netlist, uint32_t mutant,
                             const mutation_effort *effort, const test *test,
                             mutation_verdict *verdict, glint_error *err)
{
    pair pair;
    glint_pins inputs;
    glint_status status = create_pair(netlist, mutant, effort, test->ones, &pair, err);
    for (uint64_t clock = 1; status == GLINT_OK && clock <= test->clocks && !verdict->killed;
         clock++) {
        test->next(&pair, clock, &inputs);
        if (!clock_pair(&pair, &inputs, verdict)) {
            verdict->test = test->name;
            verdict->clock = clock;
        }
        if (stopped(effort, clock))
            status = glint_fail(err, GLINT_INTERRUPTED, "interrupted");
    }
    destroy_pair(&pair);
    return status;
}

static glint_status run_point(const mutation_netlist_table *netlist, uint32_t mutant,
                              const mutation_effort *effort, mutation_verdict *verdict,
                              glint_error *err)
{
    const test point = {"point", point_inputs, POINT_CLOCKS, false};
    if (netlist->setting.is_divider)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "a point is for the specular device only");
    return run_test(netlist, mutant, effort, &point, verdict, err);
}

glint_status mutation_run(const mutation_netlist_table *netlist, uint32_t mutant,
                          const mutation_effort *effort, mutation_verdict *verdict,
                          glint_error *err)
{
    const uint64_t whole = mutation_sweep_clocks(netlist);
    const test lockstep = {"lockstep", random_inputs, effort->lockstep_clocks, true};
    const test sweep = {"sweep", sweep_inputs,
                        effort->sweep_clocks < whole ? effort->sweep_clocks : whole, false};
    memset(verdict, 0, sizeof *verdict);
    if (effort->point != NULL)
        return run_point(netlist, mutant, effort, verdict, err);
    if (lockstep.clocks == 0 && sweep.clocks == 0)
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "a bench of 0 clocks would let every fault live");
    glint_status status = run_test(netlist, mutant, effort, &lockstep, verdict, err);
    if (status == GLINT_OK && !verdict->killed)
        status = run_test(netlist, mutant, effort, &sweep, verdict, err);
    return status;
}
