/* The examples at the end of each --help work, as they stand. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "run.h"

/* In an order in which each finds what it reads. */
static const char *const helps[] = {"",
                                    "info",
                                    "models",
                                    "eval",
                                    "divide",
                                    "render",
                                    "compare",
                                    "convert",
                                    "study",
                                    "verify",
                                    "verify --exhaustive",
                                    "replay",
                                    "wave",
                                    "draw",
                                    "energy",
                                    "report",
                                    "bench"};

/* These take minutes: their command lines are read, and then only --help is shown. */
static const char *const lengthy[] = {"glint verify --clocks 1M", "glint verify --exhaustive",
                                      "glint report", "glint energy --model all"};

static char program[1024], wrong[1024];

static bool is_lengthy(const char *line)
{
    for (size_t i = 0; i < sizeof lengthy / sizeof lengthy[0]; i++)
        if (strncmp(line, lengthy[i], strlen(lengthy[i])) == 0)
            return true;
    return false;
}

static int run_in_scratch(const char *line)
{
    char command[4096];
    (void)snprintf(command, sizeof command,
                   "cd '%s' && PATH=\"$PWD/bin:$PATH\" && { %s%s; } >out 2>err", scratch_directory,
                   line, is_lengthy(line) ? " --help" : "");
    const int status = system(command);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static void try_example(const char *line)
{
    const int status = run_in_scratch(line);
    /* The pictures of the examples differ, and the packet is of a circuit that is wrong. */
    const bool compares =
        strncmp(line, "glint compare", 13) == 0 || strncmp(line, "glint replay", 12) == 0;
    if (status != 0 && !(compares && status == 1)) {
        char *said = scratch_read(scratch_path("err"), NULL);
        fail_msg("%s: exit status %d, %s", line, status, said);
    }
}

static void every_example_works(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof helps / sizeof helps[0]; i++) {
        char line[256];
        int count = 0;
        (void)snprintf(line, sizeof line, "%s%s--help", helps[i], *helps[i] != '\0' ? " " : "");
        outcome done = run(line, "");
        assert_outcome(&done, 0, "");
        char *at = strstr(done.out, "\nExamples:\n");
        assert_non_null(at);
        for (char *next = strtok(at + strlen("\nExamples:\n"), "\n"); next != NULL;
             next = strtok(NULL, "\n")) {
            assert_memory_equal(next, "  ", 2);
            if (next[2] != '#') {
                try_example(next + 2);
                count++;
            }
        }
        assert_true(count > 0);
        forget(&done);
    }
}

/* What the examples read: the command by its name, a mesh, a packet, a copy of the Verilog. */
static int set_up(void **state)
{
    static const char mesh[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const char *build = getenv("GLINT_BUILD");
    char here[512], path[2048], line[2048];
    if (scratch_make(state) != 0 || getcwd(here, sizeof here) == NULL)
        return -1;
    const char *glint = glint_under_test();
    (void)snprintf(program, sizeof program, "%s%s%s", glint[0] == '/' ? "" : here,
                   glint[0] == '/' ? "" : "/", glint);
    build = build != NULL ? build : "build";
    (void)snprintf(wrong, sizeof wrong, "%s%s%s/wrong/truncating", build[0] == '/' ? "" : here,
                   build[0] == '/' ? "" : "/", build);
    (void)snprintf(path, sizeof path, "%s/bin", scratch_directory);
    scratch_write(scratch_path("mesh.obj"), mesh, sizeof mesh - 1);
    if (mkdir(path, 0777) != 0 || symlink(program, strcat(path, "/glint")) != 0)
        return -1;
    (void)snprintf(line, sizeof line, "ln -s '%s/rtl' '%s/my-rtl'", here, scratch_directory);
    if (system(line) != 0)
        return -1;
    (void)snprintf(line, sizeof line,
                   "glint verify --gate cosine --pipeline pipelined --lanes 1 --clocks 2000 "
                   "--seed 1 --rtl '%s'",
                   wrong);
    return run_in_scratch(line) == 1 ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_example_works),
    };
    return cmocka_run_group_tests(tests, set_up, scratch_remove);
}
