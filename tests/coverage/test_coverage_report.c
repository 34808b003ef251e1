/* tests/coverage/report.awk, and functions.awk below, on counts made up here: what is covered, what
 * has a reason, and each way to fail. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"

#define TOGGLE(signal, path, count)                                                                \
    "C '\001f\002rtl/m.v\001l\0027\001n\0021\001page\002v_toggle/m__P1\001o\002" signal            \
    "\001h\002TOP." path "' " count "\n"
#define LINE(number, count)                                                                        \
    "C '\001f\002rtl/m.v\001l\002" number                                                          \
    "\001n\0021\001page\002v_branch/m\001o\002else\001h\002TOP.top' " count "\n"

static char *printed;

static void write_text(const char *name, const char *text)
{
    scratch_write(scratch_path(name), text, strlen(text));
}

/* The exit status; what it printed is in printed. */
static int report(const char *reasons, const char *counts)
{
    write_text("reasons", reasons);
    write_text("ring-12-1.dat", counts);
    const char *const argv[] = {"awk",
                                "-f",
                                "tests/coverage/report.awk",
                                scratch_path("reasons"),
                                scratch_path("ring-12-1.dat"),
                                NULL};
    const int status = child_run(argv, 20);
    free(printed);
    printed = scratch_read(scratch_path("child.out"), NULL);
    return status;
}

static void assert_printed(const char *text)
{
    if (strstr(printed, text) == NULL)
        fail_msg("no \"%s\" in:\n%s", text, printed);
}

#define COVERED LINE("9", "1") TOGGLE("a[0]", "top", "2")

static void what_is_covered_passes(void **state)
{
    (void)state;
    assert_int_equal(report("# nothing\n", COVERED), 0);
    assert_printed("lines: 1 items, 0 failed\ntoggles: 1 items, 0 failed\n");
    assert_printed("m                           1         0        1         1         0        1");
}

/* A bit that changed once rose and never fell. */
static void what_is_not_covered_fails(void **state)
{
    (void)state;
    assert_int_equal(report("# nothing\n", COVERED TOGGLE("b[1]", "top", "1")), 1);
    assert_printed("m.v:7: b[1], toggle of TOP.top, circuit ring-12\n");
    assert_printed("toggles: 2 items, 1 failed\n");
    assert_int_equal(report("# nothing\n", COVERED LINE("11", "0")), 1);
    assert_printed("m.v:11: else, line of TOP.top, circuit ring-12\n");
    assert_printed("lines: 2 items, 1 failed\n");
}

static void a_reason_explains_what_is_not_covered(void **state)
{
    (void)state;
    const char *counts =
        COVERED LINE("11", "0") TOGGLE("b[1]", "top", "1") TOGGLE("b[2]", "top", "0");
    assert_int_equal(report("ring-* m b[2:1] because it\n* m line:11 no way there\n", counts), 0);
    assert_printed("     2  ring-* m b[2:1]: because it\n");
    assert_printed("     1  * m line:11: no way there\n");
    /* Of another circuit, another module, another signal, or too few bits: none. */
    assert_int_equal(report("ring-1 m b[2:1] because\n* m line:11 no\n", counts), 1);
    assert_int_equal(report("* mm b[2:1] because\n* m line:11 no\n", counts), 1);
    assert_int_equal(report("* m bb[2:1] because\n* m line:11 no\n", counts), 1);
    assert_int_equal(report("* m b[2] because\n* m line:11 no\n", counts), 1);
    assert_int_equal(report("* m b[2:1] because\n* m line:12 no\n", counts), 1);
}

static void bounds_follow_the_circuit_and_the_stage(void **state)
{
    (void)state;
    const char *counts =
        COVERED TOGGLE("sum_r[8]", "top.stage[3].u", "0") TOGGLE("sum_r[9]", "top.stage[3].u", "7")
            TOGGLE("at[10][1]", "top", "0") TOGGLE("at[10][2]", "top", "3");
    assert_int_equal(
        report("* m sum_*[n-j-1:8] n and j\n* m at[j][n-j-1:0] by its index\n", counts), 0);
    assert_int_equal(report("* m sum_*[n-j:8] n and j\n* m at[j][n-j-1:0] by its index\n", counts),
                     1);
    assert_printed("sum_r[9] is covered, so the reason does not hold\n");
}

static void an_instance_can_be_named(void **state)
{
    (void)state;
    const char *counts = COVERED TOGGLE("b", "top.x.u", "0") TOGGLE("b", "top.y.u", "9");
    assert_int_equal(report("* m@x.u b constant there\n", counts), 0);
    assert_int_equal(report("* m b constant\n", counts), 1);
}

static void a_reason_for_what_is_covered_fails(void **state)
{
    (void)state;
    assert_int_equal(report("* m a[0] never\n", COVERED), 1);
    assert_printed("ring-12: TOP.top.a[0] is covered, so the reason does not hold\n");
}

static void a_reason_for_nothing_and_half_a_reason_fail(void **state)
{
    (void)state;
    assert_int_equal(report("* m z never\n", COVERED), 1);
    assert_printed("reasons:1: there is nothing uncovered that this is the reason of\n");
    assert_int_equal(report("* m a[0]\n", COVERED), 1);
    assert_printed("reasons:1: circuits, module, item and reason are needed\n");
}

static void no_lines_and_no_toggles_fail(void **state)
{
    (void)state;
    assert_int_equal(report("# nothing\n", LINE("9", "1")), 1);
    assert_int_equal(report("# nothing\n", TOGGLE("a[0]", "top", "2")), 1);
    assert_int_equal(report("# nothing\n", "# SystemC::Coverage-3\n"), 1);
}

/* An observed circuit is inside a probe, as "dut": the same circuit, and the probe does not
 * count. */
static void a_probe_is_looked_through(void **state)
{
    (void)state;
    const char *const probe =
        "C '\001f\002probe.v\001l\0027\001n\0021\001page\002v_toggle/glint_probe\001o\002p"
        "\001h\002TOP.glint_probe' 0\n";
    char counts[2048];
    snprintf(counts, sizeof counts, "%s%s%s%s", COVERED, TOGGLE("b", "glint_probe.dut.x", "2"),
             TOGGLE("b", "top.x", "0"), probe);
    assert_int_equal(report("# nothing\n", counts), 0);
    assert_printed("toggles: 2 items, 0 failed\n");
}

/* Two runs of one circuit give the larger count, not the sum: a constant 1 that rises once in each
 * is not a toggle. */
static void runs_are_not_added_up(void **state)
{
    (void)state;
    write_text("ring-12-2.dat", COVERED TOGGLE("b", "top", "1"));
    write_text("reasons", "# nothing\n");
    write_text("ring-12-1.dat", COVERED TOGGLE("b", "top", "1"));
    const char *const argv[] = {"awk",
                                "-f",
                                "tests/coverage/report.awk",
                                scratch_path("reasons"),
                                scratch_path("ring-12-1.dat"),
                                scratch_path("ring-12-2.dat"),
                                NULL};
    assert_int_equal(child_run(argv, 20), 1);
}

/* ---- tests/coverage/functions.awk -------------------------------------------------------------
 */

#define GCOVR                                                                                      \
    "{\"files\": [{\"file\": \"sim/a.c\", \"functions\": [{\"execution_count\": 7, \"lineno\": "   \
    "1, "                                                                                          \
    "\"name\": \"used\"}, {\"execution_count\": 0, \"lineno\": 9, \"name\": \"idle\"}], "          \
    "\"lines\": []}, "                                                                             \
    "{\"file\": \"sim/b.c\", \"functions\": [{\"execution_count\": 1, \"lineno\": 3, \"name\": "   \
    "\"idle\"}]}]}\n"

static int functions(const char *reasons, const char *json)
{
    write_text("reasons", reasons);
    write_text("gcovr.json", json);
    const char *const argv[] = {"awk",
                                "-f",
                                "tests/coverage/functions.awk",
                                scratch_path("reasons"),
                                scratch_path("gcovr.json"),
                                NULL};
    const int status = child_run(argv, 20);
    free(printed);
    printed = scratch_read(scratch_path("child.out"), NULL);
    return status;
}

static void a_function_that_is_not_entered_needs_a_reason(void **state)
{
    (void)state;
    assert_int_equal(functions("# none\n", GCOVR), 1);
    assert_printed("sim/a.c idle: no test enters it\nfunctions: 3 items, 1 failed\n");
    assert_int_equal(functions("sim/a.c idle it cannot be\n", GCOVR), 0);
    assert_printed("sim/a.c idle: it cannot be\nfunctions: 3 items, 0 failed\n");
}

static void a_reason_of_an_entered_or_no_function_fails(void **state)
{
    (void)state;
    assert_int_equal(functions("sim/a.c idle so\nsim/b.c idle so\n", GCOVR), 1);
    assert_printed("sim/b.c idle: entered, so that the reason does not hold\n");
    assert_int_equal(functions("sim/a.c idle so\nsim/c.c idle so\n", GCOVR), 1);
    assert_printed("sim/c.c idle: no such function\n");
    assert_int_equal(functions("# none\n", "{\"files\": []}\n"), 1);
}

static int clean_up(void **state)
{
    free(printed);
    return scratch_remove(state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_covered_passes),
        cmocka_unit_test(what_is_not_covered_fails),
        cmocka_unit_test(a_reason_explains_what_is_not_covered),
        cmocka_unit_test(bounds_follow_the_circuit_and_the_stage),
        cmocka_unit_test(an_instance_can_be_named),
        cmocka_unit_test(a_reason_for_what_is_covered_fails),
        cmocka_unit_test(a_reason_for_nothing_and_half_a_reason_fail),
        cmocka_unit_test(no_lines_and_no_toggles_fail),
        cmocka_unit_test(a_probe_is_looked_through),
        cmocka_unit_test(runs_are_not_added_up),
        cmocka_unit_test(a_function_that_is_not_entered_needs_a_reason),
        cmocka_unit_test(a_reason_of_an_entered_or_no_function_fails),
    };
    return cmocka_run_group_tests(tests, scratch_make, clean_up);
}
