/* sim/deps.sh against a system made up for the test: programs of the same names, first in PATH,
 * with scripted answers and a log of their calls. Nothing is installed. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include <sys/wait.h>

static void make_program(const char *name, const char *body)
{
    char text[1024];
    const int length = snprintf(text, sizeof text, "#!/bin/sh\n%s\n", body);
    scratch_write(scratch_path(name), text, (size_t)length);
    assert_int_equal(chmod(scratch_path(name), 0755), 0);
}

/* A system that lacks two packages of `make demo`, one of them removed but configured. */
static int make_system(void **state)
{
    (void)state;
    make_program("dpkg-query",
                 "while [ $# -gt 0 ]; do case $1 in -*) [ \"$1\" != -f ] || shift ;;\n"
                 "verilator) ;; libpng-dev) echo \"config-files $1\" ;;\n"
                 "*) echo \"installed $1\" ;; esac; shift; done\nexit 1");
    make_program("apt-get", "echo \"$DEBIAN_FRONTEND apt-get $*\" >>\"$SCRATCH/calls\"\n"
                            "echo \"E: output of $*\"; exit \"${APT_STATUS:-0}\"");
    make_program("id", "echo \"${USER_ID:-0}\"");
    make_program("sudo", "echo \"sudo $1\" >>\"$SCRATCH/calls\"; exec \"$@\"");
    scratch_write(scratch_path("calls"), "", 0);
    return 0;
}

/* Runs the script with the settings before it; returns its exit status. Standard output is kept in
 * "out", standard error in "err". */
static int run_deps(const char *settings, const char *goals)
{
    char command[4096];
    snprintf(command, sizeof command,
             "NO_INSTALL= SCRATCH='%s' PATH='%s':\"$PATH\" %s sim/deps.sh %s >'%s' 2>'%s'",
             scratch_directory, scratch_directory, settings, goals, scratch_path("out"),
             scratch_path("err"));
    const int status = system(command);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static void assert_file(const char *name, const char *expected)
{
    char *text = scratch_read(scratch_path(name), NULL);
    assert_string_equal(text, expected);
    free(text);
}

static void silent_when_nothing_is_missing(void **state)
{
    (void)state;
    make_program("dpkg-query", "for p; do echo \"installed $p\"; done");
    assert_int_equal(run_deps("", "demo test lint wave bench report gtkwave"), 0);
    assert_file("out", "");
    assert_file("err", "");
    assert_file("calls", "");
}

static void installs_what_is_missing_and_no_more(void **state)
{
    (void)state;
    assert_int_equal(run_deps("", "demo"), 0);
    assert_file("calls", "noninteractive apt-get -q update\n"
                         "noninteractive apt-get -q install -y --no-install-recommends "
                         "libpng-dev verilator\n");
    assert_file("out", "");
    assert_file("err", "sim/deps.sh: installing libpng-dev verilator\n");
}

static void plots_are_for_the_report_and_the_tests(void **state)
{
    (void)state;
    static const char *const goals[] = {"report", "test"};
    for (size_t i = 0; i < 2; i++) {
        make_program("dpkg-query",
                     "for p; do [ \"$p\" = gnuplot-nox ] || echo \"installed $p\"; done");
        assert_int_equal(run_deps("", goals[i]), 0);
        assert_file("err", "sim/deps.sh: installing gnuplot-nox\n");
    }
    assert_int_equal(run_deps("", "demo bench lint"), 0);
    assert_file("err", "");
}

static void goals_are_joined(void **state)
{
    (void)state;
    assert_int_equal(run_deps("", "demo test demo"), 0);
    assert_file("err", "sim/deps.sh: installing libpng-dev verilator\n");
}

static void uses_sudo_when_not_root(void **state)
{
    (void)state;
    assert_int_equal(run_deps("USER_ID=1000", "demo"), 0);
    assert_file("calls", "sudo env\nnoninteractive apt-get -q update\n"
                         "sudo env\nnoninteractive apt-get -q install -y "
                         "--no-install-recommends libpng-dev verilator\n");
}

static void no_install_only_says_the_command(void **state)
{
    (void)state;
    assert_int_equal(run_deps("NO_INSTALL=1", "demo"), 1);
    assert_file("calls", "");
    assert_file("err", "sim/deps.sh: missing packages; run: apt-get update && apt-get install "
                       "--no-install-recommends libpng-dev verilator\n");
    assert_int_equal(run_deps("NO_INSTALL=1 USER_ID=1000", "demo"), 1);
    assert_file("err",
                "sim/deps.sh: missing packages; run: sudo apt-get update && sudo apt-get install "
                "--no-install-recommends libpng-dev verilator\n");
}

static void a_failing_apt_is_shown(void **state)
{
    (void)state;
    assert_int_equal(run_deps("APT_STATUS=100", "demo"), 2);
    assert_file("err", "sim/deps.sh: installing libpng-dev verilator\n"
                       "E: output of -q update\n"
                       "E: output of -q install -y --no-install-recommends libpng-dev verilator\n"
                       "sim/deps.sh: apt-get could not install: libpng-dev verilator (its output "
                       "is above)\n");
}

/* A PATH with the few tools of the script and nothing else. */
static void link_tools(const char *name)
{
    char command[2048];
    snprintf(command, sizeof command,
             "mkdir '%s' && for t in sh env sort tr mktemp rm cat id; do "
             "ln -s \"$(command -v $t)\" '%s'/$t || exit 1; done",
             scratch_path(name), scratch_path(name));
    assert_int_equal(system(command), 0);
}

static void no_debian_is_said(void **state)
{
    (void)state;
    char settings[1100];
    link_tools("bare");
    snprintf(settings, sizeof settings, "PATH='%s'", scratch_path("bare"));
    assert_int_equal(run_deps(settings, "demo"), 2);
    assert_file("err", "sim/deps.sh: this is no Debian system (no dpkg-query); install the "
                       "equivalents of: gcc g++ make pkg-config verilator zlib1g-dev libpng-dev "
                       "libfreetype-dev fonts-dejavu-core libassimp-dev libjansson-dev "
                       "libcmark-gfm-dev libcmark-gfm-extensions-dev "
                       "nettle-dev libegl-dev libgl-dev libembree-dev\n");
}

/* The advice never uses a missing program, and always gives the complete command. */
static void no_sudo_is_said(void **state)
{
    (void)state;
    static const char *const settings[] = {"", "NO_INSTALL=1"};
    link_tools("plain");
    assert_int_equal(unlink(scratch_path("plain/id")), 0);
    make_program("plain/id", "echo 1000");
    make_program("plain/dpkg-query", "shift 2; for p; do case $p in verilator | libpng-dev) ;; *) "
                                     "echo \"installed $p\" ;; esac; done; exit 1");
    for (size_t i = 0; i < 2; i++) {
        char all[1200];
        snprintf(all, sizeof all, "PATH='%s' %s", scratch_path("plain"), settings[i]);
        assert_int_equal(run_deps(all, "demo"), i == 0 ? 2 : 1);
        assert_file("err", "sim/deps.sh: missing packages and no sudo; as root run: apt-get update "
                           "&& apt-get install --no-install-recommends libpng-dev verilator\n");
    }
}

static void an_unknown_goal_is_refused(void **state)
{
    (void)state;
    assert_int_equal(run_deps("", "demo fly"), 2);
    assert_file("err", "sim/deps.sh: unknown goal \"fly\"\n");
    assert_int_equal(run_deps("", ""), 2);
    assert_file("calls", "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(silent_when_nothing_is_missing, make_system),
        cmocka_unit_test_setup(installs_what_is_missing_and_no_more, make_system),
        cmocka_unit_test_setup(plots_are_for_the_report_and_the_tests, make_system),
        cmocka_unit_test_setup(goals_are_joined, make_system),
        cmocka_unit_test_setup(uses_sudo_when_not_root, make_system),
        cmocka_unit_test_setup(no_install_only_says_the_command, make_system),
        cmocka_unit_test_setup(a_failing_apt_is_shown, make_system),
        cmocka_unit_test_setup(no_debian_is_said, make_system),
        cmocka_unit_test_setup(no_sudo_is_said, make_system),
        cmocka_unit_test_setup(an_unknown_goal_is_refused, make_system),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
