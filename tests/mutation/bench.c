/* Runs model and netlist side by side, outputs only; see bench.h. */
#include "bench.h"

#include <string.h>

#include "../circuits/find.h"
#include "../netlist/pins.h"
#include "circuit/model.h"
#include "circuit/random_pins.h"
#include "lockstep/signals.h"
#include "sweep.h"

/* The circuit of a netlist: its pins and its output signals, asked for once. */
typedef struct circuit {
    glint_setting setting; /* with the signals that are pins alone */
    glint_setting whole;
    int inputs, outputs;
    glint_pin_info input[MUTATION_PINS_MAX];
    glint_signals output;
} circuit;

static glint_status find_circuit(const mutation_netlist_table *netlist, circuit *found,
                                 glint_error *err)
{
    if (!settings_find(netlist->circuit, &found->whole))
        return glint_fail(err, GLINT_BAD_ARGUMENT, "there is no setting %s", netlist->circuit);
    found->setting = pins_setting(&found->whole);
    found->inputs = glint_setting_pin_count(&found->setting);
    const glint_status status = glint_signals_find(&found->setting, &found->output, err);
    found->outputs = found->output.count;
    if (status == GLINT_OK &&
        (found->inputs > MUTATION_PINS_MAX || found->outputs > MUTATION_PINS_MAX ||
         found->outputs != found->output.words))
        return glint_fail(err, GLINT_BAD_ARGUMENT, "%s has too many pins, or too wide ones",
                          netlist->circuit);
    for (int i = 0; status == GLINT_OK && i < found->inputs; i++)
        found->input[i] = glint_setting_pin(&found->setting, i);
    return status;
}

/* The C model, the netlist, and where the pins come from. */
typedef struct pair {
    const mutation_netlist_table *netlist;
    const circuit *circuit;
    void *instance;
    void *model;
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

static glint_status create_pair(const mutation_netlist_table *netlist, const circuit *circuit,
                                uint32_t mutant, const mutation_effort *effort, bool ones,
                                pair *pair, glint_error *err)
{
    const glint_setting *whole = &circuit->whole;
    memset(pair, 0, sizeof *pair);
    pair->netlist = netlist;
    pair->circuit = circuit;
    pair->point = effort->point;
    pair->instance = netlist->create(mutant, ones);
    if (pair->instance == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the netlist of %s",
                          netlist->circuit);
    glint_random_pins_begin(&pair->random, whole, effort->seed);
    return glint_model_create(whole, &pair->model, err);
}

static void destroy_pair(pair *pair)
{
    if (pair->instance != NULL)
        pair->netlist->destroy(pair->instance);
    glint_model_destroy(&pair->circuit->whole, pair->model);
}

static void random_inputs(pair *pair, uint64_t clock, glint_pins *inputs)
{
    (void)clock;
    glint_random_pins_next(&pair->random, inputs);
}

static void sweep_inputs(pair *pair, uint64_t clock, glint_pins *inputs)
{
    mutation_sweep_next(&pair->sweep, &pair->circuit->whole, clock, inputs);
}

static void point_inputs(pair *pair, uint64_t clock, glint_pins *inputs)
{
    (void)clock;
    memcpy(inputs, pair->point, sizeof *pair->point);
}

/* Clocks both sides; false, with the verdict, when a pin differs. */
static bool clock_pair(pair *pair, const glint_pins *inputs, mutation_verdict *verdict)
{
    const circuit *circuit = pair->circuit;
    uint64_t in[MUTATION_PINS_MAX], model[MUTATION_PINS_MAX], netlist[MUTATION_PINS_MAX];
    for (int i = 0; i < circuit->inputs; i++)
        glint_pin_get(&circuit->input[i], inputs, &in[i]);
    glint_model_clock(&circuit->whole, pair->model, inputs);
    glint_signals_read(&circuit->output, glint_model_signals(&circuit->whole, pair->model), model);
    pair->netlist->clock(pair->instance, in, netlist);
    verdict->clocks++;
    for (int i = 0; i < circuit->outputs; i++) {
        if (model[i] != netlist[i]) {
            verdict->killed = true;
            verdict->pin = circuit->output.info[i].name;
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

static glint_status run_test(const mutation_netlist_table *netlist, const circuit *circuit,
                             uint32_t mutant, const mutation_effort *effort, const test *test,
                             mutation_verdict *verdict, glint_error *err)
{
    pair pair;
    glint_pins inputs;
    glint_status status = create_pair(netlist, circuit, mutant, effort, test->ones, &pair, err);
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

static glint_status run_point(const mutation_netlist_table *netlist, const circuit *circuit,
                              uint32_t mutant, const mutation_effort *effort,
                              mutation_verdict *verdict, glint_error *err)
{
    const test point = {"point", point_inputs, POINT_CLOCKS, false};
    if (circuit->whole.circuit != &glint_circuit_specular)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "a point is for the specular device only");
    return run_test(netlist, circuit, mutant, effort, &point, verdict, err);
}

/* Looked up once: a program has one netlist. */
static glint_status circuit_of(const mutation_netlist_table *netlist, const circuit **found,
                               glint_error *err)
{
    static circuit known;
    static bool is_known;
    const glint_status status = is_known ? GLINT_OK : find_circuit(netlist, &known, err);
    is_known = status == GLINT_OK;
    *found = &known;
    return status;
}

glint_status mutation_run(const mutation_netlist_table *netlist, uint32_t mutant,
                          const mutation_effort *effort, mutation_verdict *verdict,
                          glint_error *err)
{
    const circuit *circuit;
    memset(verdict, 0, sizeof *verdict);
    glint_status status = circuit_of(netlist, &circuit, err);
    if (status != GLINT_OK)
        return status;
    if (effort->point != NULL)
        return run_point(netlist, circuit, mutant, effort, verdict, err);
    const uint64_t whole = mutation_sweep_clocks(&circuit->whole);
    const test lockstep = {"lockstep", random_inputs, effort->lockstep_clocks, true};
    const test sweep = {"sweep", sweep_inputs,
                        effort->sweep_clocks < whole ? effort->sweep_clocks : whole, false};
    if (lockstep.clocks == 0 && sweep.clocks == 0)
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "a bench of 0 clocks would let every fault live");
    status = run_test(netlist, circuit, mutant, effort, &lockstep, verdict, err);
    if (status == GLINT_OK && !verdict->killed)
        status = run_test(netlist, circuit, mutant, effort, &sweep, verdict, err);
    return status;
}
