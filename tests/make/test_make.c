/* What the Makefile promises beyond making things: what is missing is made again, and no tool is
 * given a device to write. */
#define _XOPEN_SOURCE 700

#include <regex.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"

/* Makes a file below a build directory of the test's own. */
static void make(const char *target)
{
    static const char own_build[] = "own";
    char build[1100], circuits[1100], goal[1200];
    (void)snprintf(build, sizeof build, "BUILD=%s", scratch_path(own_build));
    (void)snprintf(circuits, sizeof circuits, "VERILATED=%s", scratch_path("circuits"));
    (void)snprintf(goal, sizeof goal, "%s/%s", scratch_path(own_build), target);
    const char *const argv[] = {"make", "-s", build, circuits, "CFLAGS=-O0", goal, NULL};
    if (child_run(argv, 600.0) != 0) {
        char *err = scratch_read(scratch_path("child.err"), NULL);
        print_message("%s", err);
        free(err);
        fail_msg("make %s failed", target);
    }
}

static bool is_made(const char *name)
{
    char path[64];
    (void)snprintf(path, sizeof path, "own/%s", name);
    return access(scratch_path(path), F_OK) == 0;
}

static void expect_made_again(const char *missing, const char *target)
{
    char path[64];
    make(target);
    assert_true(is_made(missing));
    (void)snprintf(path, sizeof path, "own/%s", missing);
    assert_int_equal(unlink(scratch_path(path)), 0);
    make(target);
    if (!is_made(missing))
        fail_msg("make %s does not make the missing %s again", target, missing);
}

static void what_is_missing_is_made_again(void **state)
{
    (void)state;
    expect_made_again("list-settings", "settings");
    expect_made_again("wrong/silent/specular_device.v", "wrong/silent/specular_device.v");
    expect_made_again("cmodel/roms.o", "glint-gen");
    expect_made_again("libglint.a", "glint-gen");
}

/* Caches of circuits hold such directories, and may lie anywhere; the build has a link to its tree.
 */
static void directories_are_no_dependencies(void **state)
{
    (void)state;
    static const char *const directories[] = {"own/cache", "own/cache/runtime-1.d", "link",
                                              "link/cache", "link/cache/runtime-2.d"};
    (void)mkdir(scratch_path("own"), 0777);
    for (size_t i = 0; i < sizeof directories / sizeof directories[0]; i++)
        assert_int_equal(mkdir(scratch_path(directories[i]), 0777), 0);
    (void)unlink(scratch_path("own/tree"));
    assert_int_equal(symlink("../link", scratch_path("own/tree")), 0);
    make("cmodel/roms.o");
    assert_true(is_made("cmodel/roms.o"));
}

/* ---- Devices ------------------------------------------------------------------------------------
 */

/* A tool may change the mode of its output file or replace it, so devices are only for shell
 * redirections, which do neither, and for reading. */
static regex_t misuse;

static int line_of(const char *text, const char *place)
{
    int line = 1;
    for (const char *c = text; c < place; c++)
        line += *c == '\n';
    return line;
}

static int misuses_in(const char *path)
{
    regmatch_t found;
    int count = 0;
    char *text = scratch_read(path, NULL);
    for (const char *rest = text; regexec(&misuse, rest, 1, &found, 0) == 0; rest += found.rm_eo) {
        print_error("%s:%d: %.*s\n", path, line_of(text, rest + found.rm_so),
                    (int)(found.rm_eo - found.rm_so), rest + found.rm_so);
        count++;
    }
    free(text);
    return count;
}

static void compile_misuse(void)
{
    assert_int_equal(regcomp(&misuse,
                             "(-o|--output|--Mdir|-of|\"-o\",)[ =]*\"?/dev/[a-z]+"
                             "|(write_[a-z]+|install|cp|mv)( [^\n<>|;&]*)? /dev/[a-z]+",
                             REG_EXTENDED | REG_NEWLINE),
                     0);
}

static void the_search_for_devices_finds_them(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int count;
    } cases[] = {
        {"iverilog -g2005 -o /dev/null -s top\n", 1},
        {"gcc -o/dev/null x.c\nyosys -p 'write_verilog -noattr /dev/stdout'\n", 2},
        {"{\"iverilog\", \"-o\", \"/dev/null\"}\n", 1},
        {"render --out /dev/full\n", 0}, /* glint's own: it promises to leave the mode alone */
        {"cmp a b >/dev/null 2>/dev/null </dev/zero\nhead -c 9 /dev/zero\n", 0},
        {"cp a b >/dev/null\n", 0},
    };
    compile_misuse();
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        scratch_write(scratch_path("searched"), cases[i].text, strlen(cases[i].text));
        assert_int_equal(misuses_in(scratch_path("searched")), cases[i].count);
    }
    regfree(&misuse);
}

static void no_tool_is_given_a_device_to_write(void **state)
{
    (void)state;
    static const char *const argv[] = {
        "find",    "Makefile", ".ci", "sim",   "tests",       "-type",    "f",     "(",
        "-name",   "*.mk",     "-o",  "-name", "*.sh",        "-o",       "-name", "*.y?",
        "-o",      "-name",    "*.c", "-o",    "-name",       "Makefile", "-o",    "-path",
        ".ci/run", ")",        "!",   "-name", "test_make.c", NULL};
    assert_int_equal(child_run(argv, 60.0), 0);
    char *list = scratch_read(scratch_path("child.out"), NULL);
    int files = 0, misuses = 0;
    compile_misuse();
    for (char *path = strtok(list, "\n"); path != NULL; path = strtok(NULL, "\n")) {
        misuses += misuses_in(path);
        files++;
    }
    regfree(&misuse);
    free(list);
    assert_true(files > 200);
    assert_int_equal(misuses, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_missing_is_made_again),
        cmocka_unit_test(directories_are_no_dependencies),
        cmocka_unit_test(the_search_for_devices_finds_them),
        cmocka_unit_test(no_tool_is_given_a_device_to_write),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
