/* A short form of make formal: one proof of each kind; a broken circuit must fail its property,
 * both in the search for a fault and as a proof; and the scripts' messages when there is nothing to
 * prove. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"

static const char *const prove_sh = "tests/formal/prove.sh";

/* Runs the script with its arguments, NULL for none; returns its exit status. */
static int prove(const char *proof, const char *fault, const char *property)
{
    const char *const argv[] = {prove_sh, scratch_path("proof"), proof, fault, property, NULL};
    return child_run(argv, 300);
}

static void assert_result(const char *part)
{
    char *line = scratch_read(scratch_path("proof/result"), NULL);
    if (strstr(line, part) == NULL)
        fail_msg("\"%s\" does not say \"%s\"", line, part);
    free(line);
}

static void assert_says(const char *part)
{
    char *text = scratch_read(scratch_path("child.err"), NULL);
    if (strstr(text, part) == NULL)
        fail_msg("\"%s\" does not say \"%s\"", text, part);
    free(text);
}

static void proves_the_device(void **state)
{
    (void)state;
    static const char *const proofs[] = {"device-cosine-combinational-2-1",
                                         "device-cosine-pipelined-16-7",
                                         "power-half-pipelined-4-2"};
    for (size_t i = 0; i < sizeof proofs / sizeof *proofs; i++) {
        assert_int_equal(prove(proofs[i], NULL, NULL), 0);
        assert_result("\tuninvited in_order once frozen value\tinduction, 1 clock\t");
        assert_result("\tPROVED\n");
    }
}

/* What make would run; a lane that it leaves out may do anything. */
static void every_lane_of_every_device_is_to_be_proved(void **state)
{
    (void)state;
    static const char *const kinds[] = {"device-cosine-combinational", "device-cosine-pipelined",
                                        "device-sign-combinational",   "device-sign-pipelined",
                                        "device-drawn-combinational",  "device-drawn-pipelined",
                                        "gates-combinational",         "gates-pipelined",
                                        "power-half-combinational",    "power-half-pipelined",
                                        "power-quarter-combinational", "power-quarter-pipelined"};
    const char *given = getenv("GLINT_BUILD");
    char table[1100], line[128];
    snprintf(table, sizeof table, "%s/settings", given != NULL ? given : "build");
    const char *const argv[] = {"tests/formal/proofs.sh", table, NULL};
    assert_int_equal(child_run(argv, 60), 0);
    char *proofs = scratch_read(scratch_path("child.out"), NULL);
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        for (int lanes = 1; lanes <= 16; lanes *= 2) {
            for (int lane = 0; lane < lanes; lane++) {
                snprintf(line, sizeof line, "\n%s-%d-%d\n", kinds[k], lanes, lane);
                if (strstr(proofs, line) == NULL &&
                    strncmp(proofs, line + 1, strlen(line) - 1) != 0)
                    fail_msg("make formal does not prove%s", line);
            }
        }
    }
    free(proofs);
}

/* And make runs what is on that list: one that is not proved yet, of a table of one setting. */
static void make_runs_the_proofs_of_the_list(void **state)
{
    (void)state;
    const char *const table = "divider divider_pipelined_9 pipelined_divider 93 SHIFTS=9\n";
    char build[1100];
    snprintf(build, sizeof build, "BUILD=%s", scratch_path("other"));
    assert_int_equal(mkdir(scratch_path("other"), 0777), 0);
    scratch_write(scratch_path("other/settings"), table, strlen(table));
    const char *const argv[] = {"make",          "-n", build, "-o", scratch_path("other/settings"),
                                "formal-proofs", NULL};
    assert_int_equal(child_run(argv, 60), 0);
    char *commands = scratch_read(scratch_path("child.out"), NULL);
    assert_non_null(strstr(commands, "/formal/pipelined-9 pipelined-9\n"));
    assert_non_null(strstr(commands, "/formal/table-9 table-9\n"));
    free(commands);
}

static void proves_gates_equal_and_writes_a_trace_for_each_cover(void **state)
{
    (void)state;
    assert_int_equal(prove("gates-pipelined-1-0", NULL, NULL), 0);
    assert_result("\t2/2\tPROVED\n");
    size_t count;
    free(scratch_read(scratch_path("proof/c_gates_equal_rim.vcd"), &count));
    assert_true(count > 1000);
}

static void proves_both_forms_of_the_divider_and_its_table(void **state)
{
    (void)state;
    static const char *const proofs[] = {"sequential-7", "pipelined-7", "table-7"};
    for (size_t i = 0; i < sizeof proofs / sizeof *proofs; i++) {
        assert_int_equal(prove(proofs[i], NULL, NULL), 0);
        assert_result("\tPROVED\n");
    }
}

static void finds_a_fault_and_shows_it(void **state)
{
    (void)state;
    assert_int_equal(
        prove("sequential-6", "tests/divider/wrong/sequential/late_done/shift_divider.sed", "done"),
        0);
    assert_result("sequential-6 late_done\tdone\tsearch, 12 clocks\t");
    assert_result("\tFAULT FOUND\n");
    size_t count;
    free(scratch_read(scratch_path("proof/counterexample.vcd"), &count));
    assert_true(count > 1000);
}

/* This fault leaves alone what is said of k. */
static void a_property_that_holds_is_no_fault_found(void **state)
{
    (void)state;
    assert_int_equal(prove("sequential-6",
                           "tests/divider/wrong/sequential/late_done/shift_divider.sed",
                           "out_of_table"),
                     1);
    assert_result("\tFAILED: fault not found\n");
    assert_says("FAILED: fault not found");
}

static void a_fault_that_edits_nothing_is_an_error(void **state)
{
    (void)state;
    scratch_write(scratch_path("shift_divider.sed"), "s/no such line//", 16);
    assert_int_equal(prove("sequential-6", scratch_path("shift_divider.sed"), "done"), 1);
    assert_says("changes nothing in rtl/shift_divider.v");
}

/* Edits a file of the copy of rtl/ and tests/formal/. */
static void edit_copy(const char *edit, const char *file)
{
    char command[4096];
    const char *path = scratch_path("tree");
    snprintf(command, sizeof command, "sed \"%s\" %s >'%s/%s' && ! cmp -s %s '%s/%s'", edit, file,
             path, file, file, path, file);
    assert_int_equal(system(command), 0);
}

static void copy_tree(const char *edit, const char *module)
{
    char command[4096], file[64];
    const char *path = scratch_path("tree");
    snprintf(
        command, sizeof command,
        "rm -rf '%s' && mkdir -p '%s/tests' && cp -r rtl '%s' && cp -r tests/formal '%s/tests'",
        path, path, path, path);
    assert_int_equal(system(command), 0);
    snprintf(file, sizeof file, "rtl/%s.v", module);
    edit_copy(edit, file);
}

/* The whole proof, of the copy: it fails, and says why. */
static void assert_proof_fails(const char *proof, const char *reason)
{
    char script[1200];
    snprintf(script, sizeof script, "%s/%s", scratch_path("tree"), prove_sh);
    const char *const argv[] = {script, scratch_path("proof"), proof, NULL};
    assert_int_equal(child_run(argv, 300), 1);
    assert_says(reason);
}

static void a_wrong_circuit_is_not_proved(void **state)
{
    (void)state;
    copy_tree("s/d({r, g, b})/d({GATE == 1 ? g : r, g, b})/", "specular_device");
    assert_proof_fails("gates-pipelined-1-0", "FAILED: step: ");
    copy_tree("s/\\.out_b(out_b\\[i\\*/.out_b(out_b[(i == 7 ? 8 : i == 8 ? 7 : i)*/",
              "specular_device");
    assert_proof_fails("device-cosine-combinational-16-7", "FAILED: step: value_b");
    copy_tree("s/7'd16;/7'd17;/", "reciprocal_rom");
    assert_proof_fails("table-6", "FAILED: inputs: rounded");
}

/* A proof with unreachable covers does not count: here k always counts as beyond the table, and the
 * assertions about that were removed. */
static void a_vacuous_proof_is_not_proved(void **state)
{
    (void)state;
    copy_tree("s/assign miss = .*/assign miss = 1;/", "reciprocal_rom");
    edit_copy(
        "s/miss_: *assert (.*/miss_: assert (1);/; s/in_table \\&\\& product/!miss \\&\\& product/",
        "tests/formal/table.v");
    assert_proof_fails("table-6", "FAILED: no cover of rounded reached");
}

static void says_what_it_cannot_prove(void **state)
{
    (void)state;
    assert_int_equal(prove("device-cosine-sideways-1-0", NULL, NULL), 2);
    assert_says("no proof \"device-cosine-sideways-1-0\"");
    assert_int_equal(prove("sequential-", NULL, NULL), 2);
    const char *const none[] = {"tests/formal/report.sh", NULL};
    assert_int_equal(child_run(none, 10), 2);
    assert_says("no proofs");
}

/* A PATH with all that the script calls before it looks for the solver, and no solver. */
static void says_what_is_not_installed(void **state)
{
    (void)state;
    char command[2048], path[1024];
    snprintf(path, sizeof path, "PATH=%s", scratch_path("bin"));
    snprintf(command, sizeof command,
             "mkdir '%s' && for tool in sh dirname cut yosys yosys-smtbmc; do"
             " ln -s \"$(command -v $tool)\" '%s' || exit 1; done",
             scratch_path("bin"), scratch_path("bin"));
    assert_int_equal(system(command), 0);
    const char *const argv[] = {"env", path, prove_sh, scratch_path("proof"), "table-6", NULL};
    assert_int_equal(child_run(argv, 10), 2);
    assert_says("prove.sh: z3 not found: install yosys and z3");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(proves_the_device),
        cmocka_unit_test(every_lane_of_every_device_is_to_be_proved),
        cmocka_unit_test(make_runs_the_proofs_of_the_list),
        cmocka_unit_test(proves_gates_equal_and_writes_a_trace_for_each_cover),
        cmocka_unit_test(proves_both_forms_of_the_divider_and_its_table),
        cmocka_unit_test(finds_a_fault_and_shows_it),
        cmocka_unit_test(a_property_that_holds_is_no_fault_found),
        cmocka_unit_test(a_fault_that_edits_nothing_is_an_error),
        cmocka_unit_test(a_wrong_circuit_is_not_proved),
        cmocka_unit_test(a_vacuous_proof_is_not_proved),
        cmocka_unit_test(says_what_it_cannot_prove),
        cmocka_unit_test(says_what_is_not_installed),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
