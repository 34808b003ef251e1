/* The exit status of every subcommand, as cmp's: 0 done or equal, 1 different, 2 trouble. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "run.h"

#define PNG   "tests/fuzz/corpus/png/rgba.png"
#define FRAME "render --model quad --size 24x18 "

enum { RIGHT, WRONG }; /* the Verilog as it is, or one that is wrong on purpose: --rtl */

/* %s: the scratch directory. A packet is left there by the first that differs. */
static const struct {
    const char *line, *input;
    int verilog, status;
} cases[] = {
    {"--help", "", RIGHT, 0},
    {"-V", "", RIGHT, 0},
    {"help", "", RIGHT, 0},
    {"", "", RIGHT, 2},
    {"--no-such", "", RIGHT, 2},
    {"no-such", "", RIGHT, 2},
    {"help no-such", "", RIGHT, 2},
    {"info", "", RIGHT, 0},
    {"info stray", "", RIGHT, 2},
    {"models --json", "", RIGHT, 0},
    {"models --n 0", "", RIGHT, 2},
    {"models --coefficients --json", "", RIGHT, 2},
    {"eval", "80 1 1 1 1\n", RIGHT, 0},
    {"eval --backend rtl", "80 1 1 1 1\n", RIGHT, 0},
    {"eval", "80 1 1 1\n", RIGHT, 2},
    {"eval --json", "80 2 1 1 1\n", RIGHT, 2},
    {"eval --backend rtl --rtl %s", "80 1 1 1 1\n", RIGHT, 2}, /* which has no Verilog */
    {"eval --rtl rtl", "80 1 1 1 1\n", RIGHT, 2},
    {"eval --circuit divider", "255 7\n", RIGHT, 0},
    {"divide", "255 7\n", RIGHT, 0},
    {"divide", "255 0\n", RIGHT, 2},
    {"divide", "256 1\n", RIGHT, 2},
    {FRAME "--out %s/a.png", "", RIGHT, 0},
    {FRAME "--backend both --out %s/b.png", "", RIGHT, 0},
    {"render --model sphere --size 64x48 --lanes 1 --backend both --out %s/c.png", "", WRONG, 1},
    {"render --model sphere --size 64x48 --lanes 1 --backend both --json --out %s/c.png", "", WRONG,
     1},
    {"render --model sphere --size 9x9 --distance 0.1 --backend both --out %s/d.png", "", RIGHT,
     2}, /* nothing compared */
    {"render --model %s/none.obj --out %s/d.png", "", RIGHT, 2},
    {"render --model README.md --out %s/d.png", "", RIGHT, 2},
    {FRAME "--out %s/none/a.png", "", RIGHT, 2},
    {FRAME "--out %s/a.txt", "", RIGHT, 2},
    {FRAME "--light 0,0,0 --out %s/d.png", "", RIGHT, 2},
    {"compare " PNG " " PNG, "", RIGHT, 0},
    {"compare %s/c.png %s/c-c.png", "", RIGHT, 1},
    {"compare --json %s/c.png %s/c-c.png", "", RIGHT, 1},
    {"compare " PNG " %s/none.png", "", RIGHT, 2},
    {"compare " PNG " README.md", "", RIGHT, 2},
    {"compare " PNG " %s/a.png", "", RIGHT, 2}, /* of another size */
    {"compare " PNG, "", RIGHT, 2},
    {"compare " PNG " " PNG " --diff " PNG, "", RIGHT, 2},
    {"convert sphere %s/a.3ds", "", RIGHT, 0},
    {"convert sphere %s/a.txt", "", RIGHT, 2},
    {"convert %s/none.obj %s/b.3ds", "", RIGHT, 2},
    {"draw --out %s/a.svg", "", RIGHT, 0},
    {"draw --circuit divider --out %s/a.dot", "", RIGHT, 0},
    {"draw --out %s/a.txt", "", RIGHT, 2},
    {"draw", "", RIGHT, 2},
    {"verify --clocks 200 --seed 1 --out %s/p", "", RIGHT, 0},
    {"verify --clocks 2000 --seed 1 --gate cosine --lanes 1 --out %s/p", "", WRONG, 1},
    {"verify --clocks 2000 --seed 1 --gate cosine --lanes 1 --json --out %s/q", "", WRONG, 1},
    /* A mismatch is exit status 1, with or without its packet. */
    {"verify --clocks 2000 --seed 1 --gate cosine --lanes 1 --out /dev/null/p", "", WRONG, 1},
    {"verify --clocks 0", "", RIGHT, 2},
    {"verify --lanes 33", "", RIGHT, 2},
    {"verify --exhaustive --stride 8192 --shard 1/512 --out %s/p", "", RIGHT, 0},
    {"verify --exhaustive --lanes 1 --from 50 --stride 4096 --shard 51/1000 --out %s/p", "", WRONG,
     1},
    {"verify --exhaustive --from 9 --shard 1/1024", "", RIGHT, 2}, /* nothing compared */
    {"verify --exhaustive --shard 2/1", "", RIGHT, 2},
    {"replay %s/p/specular_cosine_pipelined_1 --rtl rtl", "", RIGHT, 0},
    {"replay %s/p/specular_cosine_pipelined_1", "", RIGHT, 0}, /* not by what it names */
    {"replay %s/p/specular_cosine_pipelined_1", "", WRONG, 1},
    {"replay %s/p/specular_cosine_pipelined_1 --out /dev/null/r", "", WRONG, 1},
    {"replay %s/none", "", RIGHT, 2},
    {"replay", "", RIGHT, 2},
    {"wave --circuit divider --out %s/w", "", RIGHT, 0},
    {"wave --from 9 --to 8 --out %s/w", "", RIGHT, 2},
    {"wave --out /dev/null/w", "", RIGHT, 2},
    {"energy --model blinn --n 1 --angle 0", "", RIGHT, 0},
    {"energy --model none", "", RIGHT, 2},
    {"energy --model blinn --n 1 --angle 0 --out /dev/null/e", "", RIGHT, 2},
    {"study --model quad --size 20x20 --n 10 --frames 0 --out %s/s", "", RIGHT, 0},
    {"study --a none --out %s/s", "", RIGHT, 2},
    {"study --model quad --size 20x20 --n 10 --frames 0 --out /dev/null/s", "", RIGHT, 2},
    {"report --chapter thesis", "", RIGHT, 2},
    {"report --chapter divider --out /dev/null/r", "", RIGHT, 2},
    {"bench --seconds 0.01 --threads 1", "", RIGHT, 0},
    {"bench --seconds 0", "", RIGHT, 2},
};
#define CASES (sizeof cases / sizeof cases[0])

/* Replaces each %s with the scratch directory. */
static void fill(const char *line, char *text, size_t size)
{
    size_t length = 0;
    for (; *line != '\0'; line += strncmp(line, "%s", 2) == 0 ? 2 : 1) {
        length += (size_t)snprintf(text + length, size - length, "%.*s",
                                   strncmp(line, "%s", 2) == 0 ? 500 : 1,
                                   strncmp(line, "%s", 2) == 0 ? scratch_directory : line);
        assert_true(length < size);
    }
    text[length] = '\0';
}

static outcome run_case(size_t i, const plumbing *pipes)
{
    char line[2048];
    const char *build = getenv("GLINT_BUILD");
    fill(cases[i].line, line, sizeof line);
    const size_t length = strlen(line);
    if (cases[i].verilog == WRONG) {
        (void)snprintf(line + length, sizeof line - length, " --rtl %s/wrong/truncating",
                       build != NULL ? build : "build");
    }
    return run_plumbed(line, cases[i].input, pipes);
}

static void every_status_has_its_meaning(void **state)
{
    (void)state;
    const plumbing none = {0};
    for (size_t i = 0; i < CASES; i++) {
        outcome done = run_case(i, &none);
        if (done.status != cases[i].status ||
            (done.status == 2 && strncmp(done.err, "glint", 5) != 0)) {
            fail_msg("%s: exit status %d, not %d; standard error \"%s\"", cases[i].line,
                     done.status, cases[i].status, done.err);
        }
        forget(&done);
    }
}

/* Its output was lost, so there is no verdict. */
static void output_that_is_not_taken_is_trouble(void **state)
{
    (void)state;
    const plumbing full = {.out = "/dev/full"};
    for (size_t i = 0; i < CASES; i++) {
        const bool to_the_other_stream = strstr(cases[i].line, "/dev/null/") != NULL;
        if (cases[i].status == 2 || to_the_other_stream)
            continue;
        outcome done = run_case(i, &full);
        if (done.status != 2) {
            fail_msg("%s: exit status %d; standard error \"%s\"", cases[i].line, done.status,
                     done.err);
        }
        forget(&done);
    }
}

/* The word after `glint` in each case: none of the subcommands that --help lists is left out. */
static bool is_tried(const char *name, int status)
{
    for (size_t i = 0; i < CASES; i++) {
        const size_t length = strcspn(cases[i].line, " ");
        if (length == strlen(name) && strncmp(cases[i].line, name, length) == 0 &&
            cases[i].status == status)
            return true;
    }
    return false;
}

static void no_subcommand_is_left_out(void **state)
{
    (void)state;
    outcome done = run("--help", "");
    int count = 0;
    char *at = strstr(done.out, "\nSubcommands:\n");
    assert_non_null(at);
    for (char *line = strtok(at + 14, "\n"); line != NULL && strncmp(line, "  ", 2) == 0;
         line = strtok(NULL, "\n")) {
        char name[32];
        assert_int_equal(sscanf(line, " %31s", name), 1);
        count++;
        /* The whole report takes long: tests/cli/test_cmd_report.c has its 0. */
        if ((!is_tried(name, 0) && strcmp(name, "report") != 0) || !is_tried(name, 2))
            fail_msg("%s: not tried", name);
    }
    assert_true(count >= 13);
    forget(&done);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_status_has_its_meaning),
        cmocka_unit_test(output_that_is_not_taken_is_trouble),
        cmocka_unit_test(no_subcommand_is_left_out),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
