/* make compare without its slow tools: which settings it takes, the modules around them, results
 * that the tools have written (samples/), and one unit by Debian's Yosys. */
#define _XOPEN_SOURCE 700

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "../golden.h"
#include "../scratch.h"
#include "compare/errors.h"
#include "compare/module.h"
#include "compare/result.h"
#include "compare/tables.h"
#include "compare/units.h"

#define POWER "power_half_pipelined_1"

static void assert_near(double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%.9g is not %.9g", value, expected);
}

/* ---- Settings ----------------------------------------------------------------------------------
 */

static void every_unit_has_one_and_four_lanes(void **state)
{
    (void)state;
    glint_setting setting;
    int lanes[5] = {0}, count = 0;
    for (; glint_compare_setting(count, &setting); count++) {
        assert_in_range(glint_compare_lanes(&setting), 1, 4);
        lanes[glint_compare_lanes(&setting)]++;
        assert_int_equal(glint_setting_check(&setting, NULL), GLINT_OK);
    }
    assert_int_equal(lanes[1], lanes[4]);
    assert_int_equal(lanes[1] + lanes[4], count);
    assert_true(lanes[1] >= 2);
}

static void a_setting_is_found_by_its_name(void **state)
{
    (void)state;
    glint_setting setting;
    char label[GLINT_SETTING_TEXT];
    assert_true(glint_compare_setting_named(POWER, &setting));
    glint_compare_label(&setting, label);
    assert_string_equal(label, "power, accuracy half");
    assert_false(glint_compare_setting_named("divider_sequential_12", &setting));
    assert_false(glint_compare_setting_named("specular_sign_pipelined_1", &setting));
}

/* ---- Errors
 * -------------------------------------------------------------------------------------- */

static void errors_are_those_known(void **state)
{
    (void)state;
    enum { STRIDE = 1024, CODES = (1 << 18) / STRIDE + 1 };
    glint_setting setting;
    glint_compare_errors errors;
    golden();
    assert_true(glint_compare_setting_named(POWER, &setting));
    assert_int_equal(glint_compare_measure(&setting, STRIDE, &errors, NULL), GLINT_OK);
    assert_int_equal(errors.points, CODES * GLINT_COMPARE_N_MAX);
    assert_true(errors.power.steps > 0.3 && errors.power.steps < 0.5);
    assert_true(errors.nmse > 0 && errors.nmse < 1e-5);
    assert_true(glint_compare_setting_named("specular_cosine_pipelined_1", &setting));
    assert_int_equal(glint_compare_measure(&setting, STRIDE, &errors, NULL), GLINT_OK);
    assert_true(errors.power.steps > 27 && errors.power.steps < 29);
    assert_true(errors.own.steps < 0.52 / 2);
}

/* ---- Results
 * ------------------------------------------------------------------------------------- */

static json_t *sample(const char *name)
{
    char path[256];
    json_error_t fault;
    snprintf(path, sizeof path, "tests/compare/samples/%s.json", name);
    json_t *json = json_load_file(path, 0, &fault);
    if (json == NULL)
        fail_msg("%s: %s", path, fault.text);
    return json;
}

static glint_compare_result result_of(const char *name)
{
    glint_compare_result result;
    glint_error err;
    json_t *json = sample(name);
    if (glint_compare_result_read(json, &result, &err) != GLINT_OK)
        fail_msg("%s: %s", name, err.text);
    json_decref(json);
    return result;
}

static void check_cells(const char *name, double lut, double ff, double dsp, double bram)
{
    const glint_compare_result result = result_of(name);
    assert_string_equal(result.unit, POWER);
    assert_string_equal(result.tools, "Yosys 0.70");
    assert_near(result.cells.lut, lut, 0);
    assert_near(result.cells.ff, ff, 0);
    assert_near(result.cells.dsp, dsp, 1e-9);
    assert_near(result.cells.bram, bram, 0);
}

/* Counted by hand from the samples. */
static void cells_become_resources(void **state)
{
    (void)state;
    check_cells("size_xilinx", 236, 150, 5, 0);
    check_cells("size_ecp5", 185, 209, 5, 2);
    check_cells("size_ice40", 1714, 210, 0, 2);
    check_cells("size_ice40dsp", 136, 210, 6, 2);
    check_cells("size_gowin", 233, 209, 5, 2);
    check_cells("size_cyclonev", 191, 210, 2.5, 2);
}

static void a_library_has_gates_and_a_clock(void **state)
{
    (void)state;
    const glint_compare_result result = result_of("size_cells");
    assert_near(result.mm2, 0.185426, 1e-6);
    assert_near(result.gates, 185426.0 / 24, 1e-3);
    assert_near(result.mhz, 1000 / (100 - 95.45), 0.3);
}

static void a_report_has_a_clock_rate(void **state)
{
    (void)state;
    const glint_compare_result result = result_of("clock_ecp5");
    assert_int_equal(result.seed, 1);
    assert_false(result.unplaced);
    assert_true(result.mhz > 55 && result.mhz < 65);
}

static void errors_are_read(void **state)
{
    (void)state;
    const glint_compare_result result = result_of("errors");
    assert_true(result.power_steps > 0.49 && result.power_steps < 0.5);
    assert_int_equal((int)result.nmse_n, 908);
}

static glint_status read_text(const char *text, glint_compare_result *result, glint_error *err)
{
    json_error_t fault;
    json_t *json = json_loads(text, 0, &fault);
    assert_non_null(json);
    const glint_status status = glint_compare_result_read(json, result, err);
    json_decref(json);
    return status;
}

#define HEAD(kind, flow)                                                                           \
    "{\"unit\": \"u\", \"kind\": \"" kind "\", \"flow\": \"" flow                                  \
    "\", \"seed\": 2, \"tools\": \"t\", \"raw\": "

static void what_is_no_result_is_refused(void **state)
{
    (void)state;
    glint_compare_result result;
    glint_error err;
    assert_int_equal(read_text("{}", &result, &err), GLINT_BAD_INPUT);
    assert_int_equal(read_text(HEAD("clock", "ecp5") "{\"fmax\": {}}}", &result, &err),
                     GLINT_BAD_INPUT);
    assert_int_equal(read_text(HEAD("size", "ecp5") "{\"stat\": {}}}", &result, &err),
                     GLINT_BAD_INPUT);
    assert_int_equal(
        read_text(HEAD("size", "ecp5") "{\"stat\": {\"design\": {\"num_cells_by_type\":"
                                       " {\"LUT4\": 3, \"EHXPLLL\": 1}}}}}",
                  &result, &err),
        GLINT_BAD_INPUT);
    assert_string_equal(err.text, "ecp5: unknown cell EHXPLLL");
    assert_int_equal(read_text(HEAD("clock", "up5k") "{\"unplaced\": \"no BELs\"}}", &result, &err),
                     GLINT_OK);
    assert_true(result.unplaced);
}

/* ---- Tables
 * ---------------------------------------------------------------------------------------- */

static json_t *tree_of(const char *manifest)
{
    json_t *tree;
    glint_error err;
    scratch_write(scratch_path("manifest"), manifest, strlen(manifest));
    if (glint_compare_tree(scratch_path("manifest"), &tree, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    return tree;
}

static char *printed(void (*write)(FILE *, const json_t *), const json_t *tree)
{
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    write(out, tree);
    fclose(out);
    return text;
}

#define SAMPLES "tests/compare/samples/"

static void tables_have_what_was_measured(void **state)
{
    (void)state;
    json_t *tree = tree_of(SAMPLES "errors.json\n" SAMPLES "size_ecp5.json\n" SAMPLES
                                   "size_cells.json\n" SAMPLES "clock_ecp5.json\nnot/there.json\n");
    char *markdown = printed(glint_compare_write_markdown, tree);
    char *csv = printed(glint_compare_write_csv, tree);
    assert_non_null(strstr(markdown, "| power, accuracy half | – | 185, 209, 5, 2 | – |"));
    assert_non_null(strstr(markdown, "| 0.498 | 0.5 | 2.2e-06 | 7726 | 0.185 |"));
    assert_non_null(strstr(markdown, "By not measured; Yosys 0.70;"));
    assert_non_null(strstr(csv, "\n" POWER ",1,12,5,size,ecp5,\"Yosys 0.70\",dsp,5\n"));
    assert_null(strstr(csv, "nan"));
    assert_null(strstr(markdown, "four lanes")); /* of which nothing was measured */
    free(markdown);
    free(csv);
    json_decref(tree);
}

static void a_result_that_is_broken_is_named(void **state)
{
    (void)state;
    json_t *tree;
    glint_error err;
    scratch_write(scratch_path("broken.json"), "{", 1);
    const char *path = scratch_path("broken.json");
    scratch_write(scratch_path("manifest"), path, strlen(path));
    assert_int_equal(glint_compare_tree(scratch_path("manifest"), &tree, &err), GLINT_BAD_INPUT);
    assert_non_null(strstr(err.text, "broken.json"));
    assert_null(tree);
    assert_int_equal(glint_compare_tree(scratch_path("nothing"), &tree, &err), GLINT_IO_ERROR);
}

static json_t *unit_with(double error, double gates)
{
    return json_pack("{s:s, s:i, s:{s:f}, s:{s:{s:f}}}", "label", "u", "lanes", 1, "errors",
                     "power_steps", error, "size", "cells", "gates", gates);
}

static void the_front_is_what_nothing_beats(void **state)
{
    (void)state;
    json_t *tree = json_pack("[o, o, o, o]", unit_with(1, 10), unit_with(2, 5), unit_with(2, 6),
                             unit_with(3, 5));
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    glint_compare_write_points(out, tree, "ecp5");
    fclose(out);
    assert_string_equal(text, "1 10 nan 1 0 \"u\"\n2 5 nan 1 0 \"u\"\n2 6 nan 0 0 \"u\"\n"
                              "3 5 nan 0 0 \"u\"\n");
    free(text);
    json_decref(tree);
}

/* ---- By Debian's Yosys
 * ----------------------------------------------------------------------------- */

static json_t *synthesised(void (*write)(FILE *, const glint_setting *))
{
    glint_setting setting;
    char command[4096];
    json_error_t fault;
    assert_true(glint_compare_setting_named(POWER, &setting));
    FILE *module = fopen(scratch_path("unit.v"), "w");
    assert_non_null(module);
    write(module, &setting);
    assert_int_equal(fclose(module), 0);
    snprintf(command, sizeof command,
             "yosys -q -p 'read_verilog -Irtl rtl/*.v %s; hierarchy -check -top compare_unit; "
             "synth_ecp5 -top compare_unit; tee -q -o %s stat -json'",
             scratch_path("unit.v"), scratch_path("stat.json"));
    assert_int_equal(system(command), 0);
    json_t *json = json_load_file(scratch_path("stat.json"), 0, &fault);
    assert_non_null(json);
    return json;
}

static glint_compare_cells counted(void (*write)(FILE *, const glint_setting *))
{
    glint_compare_cells cells;
    json_t *json = synthesised(write);
    assert_int_equal(
        glint_compare_count("ecp5",
                            json_object_get(json_object_get(json, "design"), "num_cells_by_type"),
                            &cells, NULL),
        GLINT_OK);
    json_decref(json);
    return cells;
}

/* Between registers nothing of it goes away: 58 inputs, 38 outputs twice, and the unit itself. */
static void a_unit_is_synthesised(void **state)
{
    (void)state;
    golden();
    const glint_compare_cells bare = counted(glint_compare_write_bare);
    const glint_compare_cells timed = counted(glint_compare_write_timed);
    assert_near(bare.dsp, 5, 0);
    assert_near(bare.bram, 2, 0);
    assert_near(timed.dsp, bare.dsp, 0);
    assert_near(timed.bram, bare.bram, 0);
    assert_near(timed.ff, bare.ff + 58 + 2 * 38, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_unit_has_one_and_four_lanes),
        cmocka_unit_test(a_setting_is_found_by_its_name),
        cmocka_unit_test(errors_are_those_known),
        cmocka_unit_test(cells_become_resources),
        cmocka_unit_test(a_library_has_gates_and_a_clock),
        cmocka_unit_test(a_report_has_a_clock_rate),
        cmocka_unit_test(errors_are_read),
        cmocka_unit_test(what_is_no_result_is_refused),
        cmocka_unit_test(tables_have_what_was_measured),
        cmocka_unit_test(a_result_that_is_broken_is_named),
        cmocka_unit_test(the_front_is_what_nothing_beats),
        cmocka_unit_test(a_unit_is_synthesised),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
