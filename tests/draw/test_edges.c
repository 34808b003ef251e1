/* The wires of a drawing are those of the Verilog: for every named block, the inputs that the
 * description states are those that Yosys finds, no more and no fewer. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "circuit/circuits.h"
#include "circuit/own.h"
#include "draw/graph.h"
#include "lockstep/signals.h"
#include "netlist.h"

/* The names that matter: those of nodes and of pins. */
typedef struct edges {
    const glint_setting *setting;
    netlist *circuit;
    glint_draw_graph graph;
    int count;
    char name[NETLIST_NAMES_MAX][NETLIST_NAME];
    int of_node[GLINT_DRAW_NODES_MAX]; /* −1: the Verilog has no name for it */
    int wrong;
    bool is_quiet; /* the differences are intended */
} edges;

static edges e;

static int name_index(const char *name)
{
    for (int i = 0; i < e.count; i++)
        if (strcmp(e.name[i], name) == 0)
            return i;
    assert_true(e.count < NETLIST_NAMES_MAX);
    assert_true(strlen(name) < NETLIST_NAME);
    strcpy(e.name[e.count], name);
    return e.count++;
}

/* "reg1" is lane[0].u.reg1, "acc_r[1]" stage[1].u.acc_r; a port or a pin is itself. */
static bool find_name(const char *called, char name[NETLIST_NAME])
{
    const glint_circuit *circuit = e.setting->circuit;
    for (int i = 0; i < glint_setting_signal_count(e.setting); i++) {
        const glint_signal_info signal = glint_setting_signal(e.setting, i);
        const char *const own = signal.path != NULL ? signal.path : signal.name;
        char with_lane[NETLIST_NAME], scope[NETLIST_NAME] = "";
        (void)snprintf(with_lane, sizeof with_lane, "%s[%d]", signal.name, signal.lane);
        if (strcmp(signal.name, called) != 0 && strcmp(with_lane, called) != 0)
            continue;
        if (signal.lane >= 0 && signal.kind != GLINT_SIGNAL_OUTPUT) {
            const char *number = strchr(circuit->lane_scope, '%');
            (void)snprintf(scope, sizeof scope, "%.*s%d%s.", (int)(number - circuit->lane_scope),
                           circuit->lane_scope, signal.lane, number + 2);
        }
        (void)snprintf(name, NETLIST_NAME, "%.40s%.50s", scope, own);
        return true;
    }
    (void)snprintf(name, NETLIST_NAME, "%s", called);
    for (int i = 0; i < glint_setting_pin_count(e.setting); i++)
        if (strcmp(glint_setting_pin(e.setting, i).name, called) == 0)
            return true;
    return false;
}

static void name_nodes(void)
{
    char name[NETLIST_NAME];
    for (int i = 0; i < e.graph.count; i++) {
        e.of_node[i] = find_name(e.graph.node[i].name, name) ? name_index(name) : -1;
        if (e.of_node[i] >= 0 && !netlist_has(e.circuit, name))
            fail_msg("%s: the Verilog has no %s", e.setting->circuit->name, name);
    }
}

/* Blocks that are not drawn because they feed nothing count as well. */
static void name_rows(void)
{
    char name[NETLIST_NAME];
    const glint_circuit *circuit = e.setting->circuit;
    for (int i = 0; i < circuit->block_count(e.setting->values); i++) {
        const glint_block_info row = circuit->block(e.setting->values, i);
        if (row.symbol != GLINT_SYMBOL_WIRE && find_name(row.name, name))
            (void)name_index(name);
    }
}

static void expect_controls(const glint_draw_node *node, bool *expected)
{
    char controls[256] = "", name[NETLIST_NAME];
    if (node->control != NULL)
        (void)snprintf(controls, sizeof controls, "%s", node->control);
    for (char *word = strtok(controls, ", "); word != NULL; word = strtok(NULL, ", ")) {
        assert_true(find_name(word, name));
        expected[name_index(name)] = true;
    }
}

/* What feeds a node without a name feeds those that it feeds. */
static void expect_inputs(int index, bool *expected)
{
    const glint_draw_node *node = &e.graph.node[index];
    expect_controls(node, expected);
    for (int i = 0; i < node->input_count; i++) {
        const int from = node->input[i];
        if (e.of_node[from] >= 0)
            expected[e.of_node[from]] = true;
        else
            expect_inputs(from, expected);
    }
}

static bool is_undrawn(const char *name)
{
    if (e.setting->circuit->clock_port != NULL && strcmp(e.setting->circuit->clock_port, name) == 0)
        return true;
    for (int i = 0; i < glint_setting_pin_count(e.setting); i++) {
        const glint_pin_info pin = glint_setting_pin(e.setting, i);
        if (strcmp(pin.name, name) == 0)
            return pin.role == GLINT_PIN_RESET || pin.role == GLINT_PIN_RESET_LOW ||
                   pin.role == GLINT_PIN_ENABLE || pin.role == GLINT_PIN_ENABLE_LOW;
    }
    return false;
}

static void tell(int fed, int by, bool is_expected)
{
    char text[GLINT_SETTING_TEXT];
    glint_setting_describe(e.setting, text);
    print_error("%s: %s is %sfed by %s in the drawing, and %s in the Verilog\n", text, e.name[fed],
                is_expected ? "" : "not ", e.name[by], is_expected ? "is not" : "is");
}

static void check_node(int index)
{
    bool expected[NETLIST_NAMES_MAX] = {false}, reached[NETLIST_NAMES_MAX];
    const int own = e.of_node[index];
    expect_inputs(index, expected);
    netlist_sources(e.circuit, e.name[own], e.graph.node[index].symbol == GLINT_SYMBOL_REGISTER,
                    e.name, e.count, expected, reached);
    for (int i = 0; i < e.count; i++) {
        if (i == own || is_undrawn(e.name[i]) || netlist_is_constant(e.circuit, e.name[i]))
            continue;
        if (expected[i] == reached[i])
            continue;
        e.wrong++;
        if (!e.is_quiet)
            tell(own, i, expected[i]);
    }
}

/* How many differ, of a setting and its netlist. */
static int differences(const glint_setting *setting, netlist *circuit, bool is_quiet)
{
    glint_error err;
    e = (edges){.setting = setting, .circuit = circuit, .is_quiet = is_quiet};
    if (glint_draw_graph_make(setting, &e.graph, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    name_nodes();
    name_rows();
    for (int i = 0; i < glint_setting_pin_count(setting); i++)
        (void)name_index(glint_setting_pin(setting, i).name);
    int checked = 0;
    for (int i = 0; i < e.graph.count; i++)
        if (e.of_node[i] >= 0 && e.graph.node[i].kind != GLINT_DRAW_PIN) {
            check_node(i);
            checked++;
        }
    assert_true(checked > 5);
    return e.wrong;
}

/* The Verilog is in that directory. */
static void assert_wired_as_drawn(const glint_setting *setting, const char *verilog)
{
    netlist *circuit = netlist_make(setting, verilog, scratch_directory);
    assert_non_null(circuit);
    assert_int_equal(differences(setting, circuit, false), 0);
    netlist_destroy(circuit);
}

static void the_device_is_wired_as_drawn(void **state)
{
    (void)state;
    for (int gate = 0; gate < GLINT_GATE_COUNT; gate++)
        for (int pipeline = 0; pipeline < GLINT_PIPELINE_COUNT; pipeline++) {
            const glint_specular_config config = {
                .gate = (glint_gate)gate, .pipeline = (glint_pipeline)pipeline, .lanes = 1};
            const glint_setting setting = glint_setting_specular(&config);
            assert_wired_as_drawn(&setting, "rtl");
        }
}

static void the_dividers_are_wired_as_drawn(void **state)
{
    (void)state;
    for (int form = 0; form < GLINT_DIVIDER_FORM_COUNT; form++) {
        const glint_setting setting = glint_setting_divider((glint_divider_form)form, 12);
        assert_wired_as_drawn(&setting, "rtl");
    }
}

#define MAC "docs/examples/saturating_mac"

static void the_example_is_wired_as_drawn(void **state)
{
    (void)state;
    const glint_circuit *circuit;
    glint_error err;
    if (glint_circuit_load(MAC, &circuit, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    const glint_setting setting = glint_setting_standard(circuit);
    assert_wired_as_drawn(&setting, MAC);
}

/* The same description, but for one row. */
static glint_block_info changed;

static glint_block_info with_change(const int *values, int index)
{
    const glint_block_info row = glint_circuit_specular.block(values, index);
    return strcmp(row.name, changed.name) == 0 ? changed : row;
}

static void a_wire_too_many_or_too_few_is_seen(void **state)
{
    (void)state;
    static const glint_block_info changes[] = {
        {"mul7", GLINT_SYMBOL_MULTIPLIER, NULL, "rom33 adder6 rom9", NULL, 0},
        {"mul7", GLINT_SYMBOL_MULTIPLIER, NULL, "rom33 reg1", NULL, 0},
        {"keys12", GLINT_SYMBOL_KEYS, NULL, "sat10", NULL, 0},
        {"reg3", GLINT_SYMBOL_REGISTER, NULL, "r", NULL, 0},
        {"reg3", GLINT_SYMBOL_REGISTER, NULL, "g", "rgb_we", 0},
        {"s3_reg4", GLINT_SYMBOL_REGISTER, NULL, "reg4", NULL, 0},
        {"out_w", GLINT_SYMBOL_REGISTER, NULL, "keys12", NULL, 0},
    };
    glint_circuit circuit = glint_circuit_specular;
    circuit.block = with_change;
    glint_setting setting = glint_setting_standard(&glint_circuit_specular);
    netlist *netlist = netlist_make(&setting, "rtl", scratch_directory);
    assert_non_null(netlist);
    setting.circuit = &circuit;
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        changed = changes[i];
        if (differences(&setting, netlist, true) == 0)
            fail_msg("%s fed by %s: not seen", changed.name, changed.inputs);
    }
    netlist_destroy(netlist);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_device_is_wired_as_drawn),
        cmocka_unit_test(the_dividers_are_wired_as_drawn),
        cmocka_unit_test(the_example_is_wired_as_drawn),
        cmocka_unit_test(a_wire_too_many_or_too_few_is_seen),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
