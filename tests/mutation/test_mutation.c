/* The mutation bench itself, on a small circuit: it kills, it lets live only what is proven to
 * change nothing, it does not pass when it is blind, and the prover does not prove what is wrong.
 * `make mutation` does the same with thousands of faults. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"

#define CIRCUIT "mutation/divider_sequential_6"

enum { FAULTS = 60, KILLED_TRIED = 6, PROOF_SECONDS = 60, LONG_ENOUGH = 300, ANSWER_SIZE = 64 };

static char bench[512], list[512], directory[512];

/* A line of the table of verdicts. */
typedef struct verdict {
    int mutant;
    bool killed;
} verdict;

static int prepare(void **state)
{
    const char *build = getenv("GLINT_BUILD");
    build = build != NULL ? build : "build";
    snprintf(directory, sizeof directory, "%s/" CIRCUIT, build);
    snprintf(bench, sizeof bench, "%s/" CIRCUIT "/bench", build);
    snprintf(list, sizeof list, "%s/" CIRCUIT "/mutants.list", build);
    return scratch_make(state);
}

static char *said(const char *name)
{
    return scratch_read(scratch_path(name), NULL);
}

static int run_bench(const char *option, const char *value, const char *option2, const char *value2)
{
    const char *const argv[] = {bench, "--list", list, option, value, option2, value2, NULL};
    return child_run(argv, LONG_ENOUGH);
}

static int read_verdicts(verdict *verdicts)
{
    int count = 0, used;
    char *table = said("verdicts.tsv"), word[16];
    for (const char *line = table;
         sscanf(line, "%d %15s%n", &verdicts[count < FAULTS ? count : 0].mutant, word, &used) == 2;
         line = strchr(line, '\n') + 1) {
        assert_true(count < FAULTS);
        verdicts[count++].killed = strcmp(word, "killed") == 0;
    }
    free(table);
    return count;
}

/* What prove.sh says of fault `mutant` of the list in a directory. */
static void ask(const char *where, int mutant, char answer[ANSWER_SIZE])
{
    char number[16], seconds[16];
    snprintf(number, sizeof number, "%d", mutant);
    snprintf(seconds, sizeof seconds, "%d", PROOF_SECONDS);
    const char *const argv[] = {"tests/mutation/prove.sh", where, number, seconds, NULL};
    const int status = child_run(argv, LONG_ENOUGH);
    char *text = said(status == 0 ? "child.out" : "child.err");
    if (status != 0)
        fail_msg("prove.sh: %s", text);
    assert_true(strlen(text) < ANSWER_SIZE);
    strcpy(answer, text);
    free(text);
}

/* Its first word, for the circuit of the bench. */
static void prove(int mutant, char answer[ANSWER_SIZE])
{
    ask(directory, mutant, answer);
    answer[strcspn(answer, "\t")] = '\0';
}

static void every_fault_is_killed_or_proven_to_change_nothing(void **state)
{
    (void)state;
    verdict verdicts[FAULTS];
    char answer[ANSWER_SIZE];
    int killed = 0, tried = 0;
    assert_int_equal(run_bench("--out", scratch_path("verdicts.tsv"), "--lockstep", "50000"), 0);
    assert_int_equal(read_verdicts(verdicts), FAULTS);
    for (int i = 0; i < FAULTS; i++) {
        assert_int_equal(verdicts[i].mutant, i + 1);
        killed += verdicts[i].killed;
        if (!verdicts[i].killed) {
            prove(i + 1, answer);
            assert_string_equal(answer, "equivalent");
        } else if (tried < KILLED_TRIED) { /* the prover, too, must be able to say no */
            tried++;
            prove(i + 1, answer);
            assert_string_equal(answer, "different");
        }
    }
    print_message("%d of %d killed, the rest equivalent\n", killed, FAULTS);
    assert_true(killed > FAULTS / 2);
    assert_int_equal(tried, KILLED_TRIED);
}

static void a_blind_bench_fails(void **state)
{
    (void)state;
    assert_int_equal(run_bench("--lockstep", "0", "--sweep", "0"), 2);
    char *text = said("child.err");
    assert_non_null(strstr(text, "0 clocks"));
    free(text);
}

/* ---- Points, on a small circuit with the specular device's pins ----------------------------- */

static int run_yosys(const char *script)
{
    const char *const argv[] = {"yosys", "-q", "-p", script, NULL};
    return child_run(argv, LONG_ENOUGH);
}

/* Writes healthy.il to the scratch directory; its registers live, never, first_n and rgb are cells
 * of that name and a number. */
static void synthesise_small(int flaw)
{
    static const char *const named[] = {"live", "never", "first_n", "rgb"};
    char script[2048];
    int used = snprintf(script, sizeof script,
                        "read_verilog tests/mutation/small_device.v; "
                        "chparam -set FLAW %d specular_device; "
                        "synth -flatten -nordff -top specular_device; "
                        "rename -top specular_device; select -module specular_device; ",
                        flaw);
    for (size_t i = 0; i < sizeof named / sizeof *named; i++) {
        used += snprintf(script + used, sizeof script - (size_t)used,
                         "select -set named w:%s %%ci1:+[Q] c:* %%i; "
                         "rename -enumerate -pattern %s%% @named; ",
                         named[i], named[i]);
    }
    snprintf(script + used, sizeof script - (size_t)used, "select -clear; write_rtlil %s",
             scratch_path("healthy.il"));
    assert_int_equal(run_yosys(script), 0);
}

static bool premises_hold(const char *fault)
{
    char script[1024];
    snprintf(script, sizeof script,
             "read_rtlil %s; select -module specular_device; select -set fault %s; "
             "script tests/mutation/points.ys",
             scratch_path("healthy.il"), fault);
    const int status = run_yosys(script);
    if (status != 0) {
        char *text = said("child.err");
        assert_non_null(strstr(text, "Assertion failed"));
        free(text);
    }
    return status == 0;
}

static void points_need_their_premises(void **state)
{
    (void)state;
    enum { FLAWS = 7 };
    for (int flaw = 0; flaw <= FLAWS; flaw++) {
        synthesise_small(flaw);
        assert_int_equal(premises_hold("c:rgb0"), flaw == 0);
    }
}

static void no_fault_of_control_is_judged_by_points(void **state)
{
    (void)state;
    synthesise_small(0);
    assert_true(premises_hold("c:first_n0"));
    /* A valid bit; the gate of a register's clock enable. */
    assert_false(premises_hold("o:out_valid %ci1:+[Q] c:* %i"));
    assert_false(premises_hold("c:first_n0 %ci1:+[E] w:* %i %ci1 c:* %i"));
}

static void write_small_faults(const char *const *faults)
{
    FILE *list = fopen(scratch_path("mutants.list"), "w");
    assert_non_null(list);
    for (int i = 0; faults[i] != NULL; i++)
        fprintf(list, "mutate -ctrl mutsel 16 %d %s -portbit 0\n", i + 1, faults[i]);
    assert_int_equal(fclose(list), 0);
}

static void points_prove_and_refute(void **state)
{
    (void)state;
    static const char *const faults[] = {
        "-mode const0 -module specular_device -cell \\never0 -port Q",
        "-mode const0 -module specular_device -cell \\first_n3 -port D",
        /* The same at every point, but not so after a reset. */
        "-mode const1 -module specular_device -cell \\live0 -port Q",
        /* The same in a steady flow, but not so otherwise. */
        "-mode const1 -module specular_device -cell \\first_n3 -port E",
        "-mode const1 -module specular_device -cell \\rgb5 -port E",
        "-mode const0 -module specular_device -cell \\rgb5 -port R",
        "-mode inv -module specular_device -cell \\rgb5 -port C",
        NULL,
    };
    char answer[ANSWER_SIZE];
    synthesise_small(0);
    write_small_faults(faults);
    ask(scratch_directory, 1, answer);
    assert_string_equal(answer, "equivalent\tpoints\n");
    ask(scratch_directory, 2, answer);
    unsigned n, cosine;
    assert_int_equal(sscanf(answer, "different\tn=%u,cos=%u,rgb=", &n, &cosine), 2);
    assert_int_equal(n & cosine & 8, 8);
    for (int i = 3; faults[i - 1] != NULL; i++) {
        ask(scratch_directory, i, answer);
        assert_string_equal(answer, "different\t-\n");
    }
}

/* A bench that sees almost nothing must report surviving faults. */
static void a_short_bench_lets_faults_live(void **state)
{
    (void)state;
    verdict verdicts[FAULTS];
    int survived = 0;
    const char *const argv[] = {
        bench,        "--list", list,      "--out", scratch_path("verdicts.tsv"),
        "--lockstep", "1",      "--sweep", "0",     NULL};
    assert_int_equal(child_run(argv, LONG_ENOUGH), 0);
    const int count = read_verdicts(verdicts);
    assert_int_equal(count, FAULTS);
    for (int i = 0; i < count; i++)
        survived += !verdicts[i].killed;
    assert_true(survived > FAULTS / 2);
}

static void one_fault_is_replayed(void **state)
{
    (void)state;
    assert_int_equal(run_bench("--mutant", "1", "--lockstep", "50000"), 0);
    char *text = said("child.out");
    assert_non_null(strstr(text, "without a fault: 0 mismatches in "));
    assert_non_null(strstr(text, "\n1\t"));
    assert_non_null(strstr(text, "mutate -ctrl mutsel 16 1 -mode "));
    free(text);
}

static void bad_command_lines_are_refused(void **state)
{
    (void)state;
    assert_int_equal(run_bench("--mutant", "x", NULL, NULL), 2);
    assert_int_equal(run_bench("--mutant", "61", NULL, NULL), 2);
    assert_int_equal(run_bench("--lockstep", "-1", NULL, NULL), 2);
    assert_int_equal(run_bench("--point", "n=1,cos=2", NULL, NULL), 2);
    assert_int_equal(run_bench("--point", "n=1024,cos=2,rgb=3,4,5", NULL, NULL), 2);
    assert_int_equal(run_bench("--point", "n=1,cos=2,rgb=3,4,5", NULL, NULL), 2); /* a divider */
    const char *const no_list[] = {bench, NULL};
    assert_int_equal(child_run(no_list, LONG_ENOUGH), 2);
    const char *const missing[] = {bench, "--list", scratch_path("none"), NULL};
    assert_int_equal(child_run(missing, LONG_ENOUGH), 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_fault_is_killed_or_proven_to_change_nothing),
        cmocka_unit_test(points_need_their_premises),
        cmocka_unit_test(no_fault_of_control_is_judged_by_points),
        cmocka_unit_test(points_prove_and_refute),
        cmocka_unit_test(a_blind_bench_fails),
        cmocka_unit_test(a_short_bench_lets_faults_live),
        cmocka_unit_test(one_fault_is_replayed),
        cmocka_unit_test(bad_command_lines_are_refused),
    };
    return cmocka_run_group_tests(tests, prepare, scratch_remove);
}
