/* The Verilog under a second simulator, Icarus: test benches in plain Verilog-2005 read vectors
 * that the C models made, and compare every output at every clock. An error of one simulator would
 * be seen here, and so would a value that stays unknown, which Verilator does not have. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"
#include "../seed.h"
#include "vectors.h"

enum { SECONDS = 120, RANDOM_CLOCKS = 3000, SOURCES_MAX = 128 };

static uint64_t seed;

static int prepare(void **state)
{
    seed = seed_of_this_run();
    return scratch_make(state);
}

/* ---- Running Icarus ----------------------------------------------------------------------------
 */

/* The circuits' sources, all of rtl/ that ends in .v. */
static int find_sources(char sources[SOURCES_MAX][300])
{
    int count = 0;
    DIR *directory = opendir("rtl");
    assert_non_null(directory);
    for (const struct dirent *entry; (entry = readdir(directory)) != NULL;) {
        const char *ending = strrchr(entry->d_name, '.');
        if (ending != NULL && strcmp(ending, ".v") == 0) {
            assert_true(count < SOURCES_MAX);
            (void)snprintf(sources[count++], 300, "rtl/%s", entry->d_name);
        }
    }
    closedir(directory);
    assert_true(count > 0);
    return count;
}

static void assert_nothing_said(const char *who)
{
    char *out = scratch_read(scratch_path("child.out"), NULL);
    char *err = scratch_read(scratch_path("child.err"), NULL);
    if (out[0] != '\0' || err[0] != '\0')
        fail_msg("%s says: %s%s", who, out, err);
    free(out);
    free(err);
}

typedef struct parameters {
    char text[4][64]; /* "-Pbench.NAME=value" */
} parameters;

/* Compiles tests/verilog/BENCH.v with the circuits, as Verilog-2005; a warning is an error. */
static void compile(const char *bench, const parameters *p)
{
    static char sources[SOURCES_MAX][300];
    char file[64];
    char output[1024];
    const char *argv[SOURCES_MAX + 16] = {"iverilog", "-g2005", "-Wall", "-Irtl",
                                          "-s",       bench,    "-o"};
    int count = 7;
    const int source_count = find_sources(sources);
    (void)snprintf(output, sizeof output, "%s", scratch_path("bench.vvp"));
    (void)snprintf(file, sizeof file, "tests/verilog/%s.v", bench);
    argv[count++] = output;
    for (int i = 0; i < 4 && p->text[i][0] != '\0'; i++)
        argv[count++] = p->text[i];
    argv[count++] = file;
    for (int i = 0; i < source_count; i++)
        argv[count++] = sources[i];
    argv[count] = NULL;
    const int status = child_run(argv, SECONDS);
    assert_nothing_said("iverilog");
    assert_int_equal(status, 0);
}

/* Runs the bench on the two files of vectors; how many clocks of how many differ. */
static void simulate(int *mismatches, int *comparisons)
{
    char program[1024];
    char stimulus[1100];
    char expected[1100];
    (void)snprintf(program, sizeof program, "%s", scratch_path("bench.vvp"));
    (void)snprintf(stimulus, sizeof stimulus, "+stimulus=%s", scratch_path("stimulus"));
    (void)snprintf(expected, sizeof expected, "+expected=%s", scratch_path("expected"));
    const char *const argv[] = {"vvp", "-n", program, stimulus, expected, NULL};
    assert_int_equal(child_run(argv, SECONDS), 0);
    char *out = scratch_read(scratch_path("child.out"), NULL);
    const char *last = strstr(out, " mismatches of ");
    while (last != NULL && last > out && last[-1] != '\n')
        last--;
    if (last == NULL || sscanf(last, "%d mismatches of %d", mismatches, comparisons) != 2)
        fail_msg("the bench says: %s", out);
    if (*mismatches > 0)
        print_message("%s", out);
    free(out);
}

static vector_files open_vectors(void)
{
    const vector_files files = {fopen(scratch_path("stimulus"), "w"),
                                fopen(scratch_path("expected"), "w")};
    assert_non_null(files.stimulus);
    assert_non_null(files.expected);
    return files;
}

static void close_vectors(const vector_files *files)
{
    assert_int_equal(fclose(files->stimulus), 0);
    assert_int_equal(fclose(files->expected), 0);
}

/* ---- The circuits ------------------------------------------------------------------------------
 */

static int make_specular(const glint_specular_config *config, int random)
{
    parameters p;
    const vector_files files = open_vectors();
    const int clocks = vectors_of_specular(&files, config, random, seed);
    close_vectors(&files);
    (void)snprintf(p.text[0], 64, "-Pspecular_bench.GATE=%d", (int)config->gate);
    (void)snprintf(p.text[1], 64, "-Pspecular_bench.PIPELINED=%d",
                   config->pipeline == GLINT_PIPELINE_PIPELINED);
    (void)snprintf(p.text[2], 64, "-Pspecular_bench.LANES=%d", config->lanes);
    (void)snprintf(p.text[3], 64, "-Pspecular_bench.CLOCKS=%d", clocks);
    compile("specular_bench", &p);
    return clocks;
}

static int make_divider(glint_divider_form form, int shifts, int random)
{
    parameters p = {{""}};
    const vector_files files = open_vectors();
    const int clocks = vectors_of_divider(&files, form, shifts, random, seed);
    close_vectors(&files);
    (void)snprintf(p.text[0], 64, "-Pdivider_bench.PIPELINED=%d", form == GLINT_DIVIDER_PIPELINED);
    (void)snprintf(p.text[1], 64, "-Pdivider_bench.SHIFTS=%d", shifts);
    (void)snprintf(p.text[2], 64, "-Pdivider_bench.CLOCKS=%d", clocks);
    compile("divider_bench", &p);
    return clocks;
}

static void assert_equal_at_all(int clocks, const char *what, const char *setting, int number)
{
    int mismatches = -1;
    int comparisons = -1;
    simulate(&mismatches, &comparisons);
    print_message("%s, %s, %d: %d mismatches of %d\n", what, setting, number, mismatches,
                  comparisons);
    assert_int_equal(mismatches, 0);
    assert_int_equal(comparisons, clocks);
    assert_true(comparisons > RANDOM_CLOCKS);
}

static void the_specular_device_equals_the_model(void **state)
{
    (void)state;
    for (int gate = 0; gate < GLINT_GATE_COUNT; gate++) {
        for (int pipeline = 0; pipeline < GLINT_PIPELINE_COUNT; pipeline++) {
            const glint_specular_config config = {(glint_gate)gate, (glint_pipeline)pipeline, 2};
            const int clocks = make_specular(&config, RANDOM_CLOCKS);
            assert_equal_at_all(clocks, glint_gate_name(config.gate),
                                glint_pipeline_name(config.pipeline), config.lanes);
        }
    }
}

static void the_dividers_equal_the_model(void **state)
{
    (void)state;
    static const int shifts[] = {6, 8, 12};
    for (size_t i = 0; i < sizeof shifts / sizeof shifts[0]; i++) {
        for (int form = 0; form < GLINT_DIVIDER_FORM_COUNT; form++) {
            const int clocks = make_divider((glint_divider_form)form, shifts[i], RANDOM_CLOCKS);
            assert_equal_at_all(clocks, "divider",
                                glint_divider_form_name((glint_divider_form)form), shifts[i]);
        }
    }
}

/* ---- The benches themselves ---------------------------------------------------------------------
 */

/* Another digit in the last line of what is expected. */
static void alter_the_last_expectation(void)
{
    size_t size;
    char *text = scratch_read(scratch_path("expected"), &size);
    text[size - 2] = text[size - 2] == '0' ? '1' : '0';
    scratch_write(scratch_path("expected"), text, size);
    free(text);
}

/* Half of the vectors: what is missing is unknown, and nothing equals that. */
static void cut_the_expectations(void)
{
    size_t size;
    char *text = scratch_read(scratch_path("expected"), &size);
    char *half = strchr(text + size / 2, '\n');
    scratch_write(scratch_path("expected"), text, (size_t)(half + 1 - text));
    free(text);
}

static void the_benches_see_a_difference(void **state)
{
    (void)state;
    const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 2};
    for (int bench = 0; bench < 2; bench++) {
        int mismatches = -1;
        int comparisons = -1;
        const int clocks = bench == 0 ? make_specular(&config, 100)
                                      : make_divider(GLINT_DIVIDER_PIPELINED, 8, 100);
        alter_the_last_expectation();
        simulate(&mismatches, &comparisons);
        assert_int_equal(mismatches, 1);
        assert_int_equal(comparisons, clocks);
        cut_the_expectations();
        simulate(&mismatches, &comparisons);
        assert_true(mismatches >= clocks / 2 - 2 && mismatches <= clocks / 2 + 2);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_specular_device_equals_the_model),
        cmocka_unit_test(the_dividers_equal_the_model),
        cmocka_unit_test(the_benches_see_a_difference),
    };
    return cmocka_run_group_tests(tests, prepare, scratch_remove);
}
