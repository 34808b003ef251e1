/* What the tests lean on: time limits that a busy machine does not break, terminals that may be
 * missing, and the count of what ran. */
#define _GNU_SOURCE

#include <sched.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/mount.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"

static int run_shell(const char *script, double seconds)
{
    const char *const argv[] = {"sh", "-c", script, NULL};
    return child_run(argv, seconds);
}

static void assert_said(const char *file, const char *part)
{
    char *text = scratch_read(scratch_path(file), NULL);
    if (strstr(text, part) == NULL)
        fail_msg("\"%s\" does not say \"%s\"", text, part);
    free(text);
}

/* ---- Time ---------------------------------------------------------------------------------------
 */

static void who_works_too_long_is_ended(void **state)
{
    (void)state;
    assert_int_equal(run_shell("while :; do :; done", 0.2), CHILD_TIMED_OUT);
}

/* Like a program starved of the processor: long by the wall clock, without having worked. */
static void who_only_waits_is_waited_for(void **state)
{
    (void)state;
    assert_int_equal(run_shell("sleep 1; exit 3", 0.2), 3);
}

static void patience_has_an_end(void **state)
{
    (void)state;
    const double before = child_patience;
    child_patience = 0.2;
    const int status = run_shell("sleep 100", 60.0);
    child_patience = before;
    assert_int_equal(status, CHILD_TIMED_OUT);
}

/* ---- Terminals ----------------------------------------------------------------------------------
 */

/* Every program that opens one, where there are none: it passes, and what it skips it gives a
 * reason for. */
static void without_terminals_tests_are_skipped(void **state)
{
    (void)state;
    static const char *const programs[] = {"cli/test_terminal", "cli/test_picture"};
    const char *build = getenv("GLINT_BUILD");
    build = build != NULL ? build : "build";
    if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", NULL, MS_REC | MS_PRIVATE, NULL) != 0 ||
        mount("tmpfs", "/dev/pts", "tmpfs", 0, NULL) != 0) {
        print_message("the terminals cannot be taken away here: %s\n", strerror(errno));
        skip();
    }
    for (size_t i = 0; i < sizeof programs / sizeof programs[0]; i++) {
        char program[1024];
        (void)snprintf(program, sizeof program, "%s/tests/%s", build, programs[i]);
        const char *const argv[] = {"tests/run.sh", scratch_path("logs"), program, NULL};
        assert_int_equal(child_run(argv, 300.0), 0);
        assert_said("child.out", ": no terminal can be made here: ");
        assert_said("child.out", " passed, 0 failed, ");
    }
    assert_int_equal(umount("/dev/pts"), 0);
}

/* ---- The count ----------------------------------------------------------------------------------
 */

static void write_program(const char *name, const char *lines, int status)
{
    char text[1024];
    const int length =
        snprintf(text, sizeof text, "#!/bin/sh\nprintf '%s'\nexit %d\n", lines, status);
    scratch_write(scratch_path(name), text, (size_t)length);
    assert_int_equal(chmod(scratch_path(name), 0755), 0);
}

static void what_ran_is_counted(void **state)
{
    (void)state;
    static const struct {
        const char *lines;
        int status, expected;
        const char *said;
    } cases[] = {
        {"[  PASSED  ] 3 test(s).\\n", 0, 0, "3 passed, 0 failed, 0 skipped\n"},
        {"[ RUN      ] a\\nwhy not\\n[  SKIPPED ] a\\n[  PASSED  ] 2 test(s).\\n"
         "[  SKIPPED ] 1 test(s), listed below:\\n[  SKIPPED ] a\\n",
         0, 0, "        skipped a: why not\n2 passed, 0 failed, 1 skipped\n"},
        {"[  PASSED  ] 2 test(s).\\n[  FAILED  ] 1 test(s), listed below:\\n", 1, 1,
         "2 passed, 1 failed, 0 skipped\n"},
        {"[  PASSED  ] 2 test(s).\\n", 139, 1, "2 passed, 1 failed, 0 skipped\n"},
        {"", 0, 1, "0 passed, 1 failed, 0 skipped\n"},
        {"[  PASSED  ] 0 test(s).\\n[  SKIPPED ] 1 test(s), listed below:\\n", 0, 1,
         "0 passed, 0 failed, 1 skipped\n"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        write_program("program", cases[i].lines, cases[i].status);
        const char *const argv[] = {"tests/run.sh", scratch_path("logs"), scratch_path("program"),
                                    NULL};
        assert_int_equal(child_run(argv, 60.0), cases[i].expected);
        assert_said("child.out", cases[i].said);
    }
}

/* Several run at once, and each counts; one that takes its runner with it counts as failed. */
static void programs_at_once_are_all_counted(void **state)
{
    (void)state;
    enum { PROGRAMS = 12 };
    static char path[PROGRAMS][1024], logs[1024];
    const char *argv[PROGRAMS + 3] = {"tests/run.sh", logs};
    (void)snprintf(logs, sizeof logs, "%s", scratch_path("logs"));
    for (int i = 0; i < PROGRAMS; i++) {
        char name[32];
        (void)snprintf(name, sizeof name, "program-%d", i);
        write_program(name, "[  PASSED  ] 2 test(s).\\n", 0);
        (void)snprintf(path[i], sizeof path[i], "%s", scratch_path(name));
        argv[i + 2] = path[i];
    }
    assert_int_equal(child_run(argv, 60.0), 0);
    assert_said("child.out", "the longest:\n");
    assert_said("child.out", "24 passed, 0 failed, 0 skipped\n");

    static const char *const ends_its_runner = "#!/bin/sh\nkill -9 $PPID\n";
    scratch_write(scratch_path("program-3"), ends_its_runner, strlen(ends_its_runner));
    assert_int_equal(child_run(argv, 60.0), 1);
    assert_said("child.out", " failed, 0 skipped\n");
}

/* As tests/model and tests/render may each have a test_specular. */
static void programs_of_the_same_name_are_told_apart(void **state)
{
    (void)state;
    assert_int_equal(mkdir(scratch_path("one"), 0777), 0);
    assert_int_equal(mkdir(scratch_path("two"), 0777), 0);
    write_program("one/program", "[  PASSED  ] 1 test(s).\\n", 0);
    write_program("two/program", "[  PASSED  ] 2 test(s).\\n", 0);
    char logs[1024];
    (void)snprintf(logs, sizeof logs, "%s", scratch_path("logs"));
    const char *argv[] = {"tests/run.sh", logs, scratch_path("one/program"),
                          scratch_path("two/program"), NULL};
    assert_int_equal(child_run(argv, 60.0), 0);
    assert_said("child.out", "3 passed, 0 failed, 0 skipped\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(who_works_too_long_is_ended),
        cmocka_unit_test(who_only_waits_is_waited_for),
        cmocka_unit_test(patience_has_an_end),
        cmocka_unit_test(without_terminals_tests_are_skipped),
        cmocka_unit_test(what_ran_is_counted),
        cmocka_unit_test(programs_at_once_are_all_counted),
        cmocka_unit_test(programs_of_the_same_name_are_told_apart),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
