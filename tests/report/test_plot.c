/* What becomes of a gnuplot that does not do what it should. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"
#include "report/plot.h"

static volatile bool stop;
static char *path_before;

static void raise_stop(int number)
{
    (void)number;
    stop = true;
}

static int make_places(void **state)
{
    if (scratch_make(state) != 0 || mkdir(scratch_path("bin"), 0777) != 0)
        return -1;
    path_before = strdup(getenv("PATH"));
    struct sigaction action = {.sa_handler = raise_stop, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    return sigaction(SIGALRM, &action, NULL) == 0 && path_before != NULL &&
                   setenv("PATH", scratch_path("bin"), 1) == 0
               ? 0
               : -1;
}

static int remove_places(void **state)
{
    setenv("PATH", path_before, 1);
    free(path_before);
    return scratch_remove(state);
}

/* A gnuplot that notes its process and then runs the lines. */
static void write_gnuplot(const char *lines)
{
    char script[2048];
    const int length =
        snprintf(script, sizeof script, "#!/bin/sh\necho $$ >%s\n%s", scratch_path("pid"), lines);
    scratch_write(scratch_path("bin/gnuplot"), script, (size_t)length);
    assert_int_equal(chmod(scratch_path("bin/gnuplot"), 0755), 0);
    scratch_write(scratch_path("figure.svg"), "of before", 9);
}

/* Runs, or is a zombie that nobody has asked about yet? */
static bool runs(long process)
{
    char path[64], text[512] = "";
    snprintf(path, sizeof path, "/proc/%ld/stat", process);
    FILE *stat = fopen(path, "r");
    if (stat == NULL)
        return false;
    const bool is_read = fgets(text, sizeof text, stat) != NULL;
    fclose(stat);
    const char *state = strrchr(text, ')');
    return is_read && state != NULL && state[2] != 'Z';
}

static long process_noted(const char *name)
{
    char *text = scratch_read(scratch_path(name), NULL);
    const long process = strtol(text, NULL, 10);
    free(text);
    assert_true(process > 1);
    return process;
}

static void assert_ends(const char *name)
{
    const long process = process_noted(name);
    const double limit = child_seconds() + child_patience;
    while (runs(process) && child_seconds() < limit)
        child_pause();
    assert_false(runs(process));
}

/* All that gnuplot was is gone, and the picture is what it was. */
static void assert_nothing_is_left(void)
{
    assert_ends("pid");
    char *picture = scratch_read(scratch_path("figure.svg"), NULL);
    assert_string_equal(picture, "of before");
    free(picture);
    assert_int_equal(access(scratch_path("figure.png"), F_OK), -1);
}

static glint_status plot(double seconds, glint_error *err)
{
    const glint_plot_limits limits = {&stop, seconds};
    bool plotted;
    stop = false;
    return glint_plot(scratch_directory, "figure", &limits, &plotted, err);
}

static void assert_is_stopped(const char *lines)
{
    glint_error err;
    write_gnuplot(lines);
    alarm(1);
    const double begin = child_seconds();
    assert_int_equal(plot(2.0 * child_patience, &err), GLINT_INTERRUPTED);
    assert_string_equal(err.text, "interrupted");
    assert_true(child_seconds() - begin < child_patience);
    assert_nothing_is_left();
}

static void a_gnuplot_that_says_nothing_is_stopped(void **state)
{
    (void)state;
    assert_is_stopped("exec /bin/sleep 10000\n");
}

static void a_gnuplot_that_ends_its_picture_but_not_itself_is_stopped(void **state)
{
    (void)state;
    assert_is_stopped("echo a picture\nexec >&-\nexec /bin/sleep 10000\n");
}

static void a_gnuplot_that_never_ends_its_picture_is_stopped(void **state)
{
    (void)state;
    assert_is_stopped("while :; do echo more; done\n");
}

static void what_gnuplot_started_ends_with_it(void **state)
{
    (void)state;
    char lines[1200];
    snprintf(lines, sizeof lines, "/bin/sleep 10000 &\necho $! >%s\nwait\n",
             scratch_path("started"));
    assert_is_stopped(lines);
    assert_ends("started");
}

static void a_gnuplot_that_takes_too_long_is_a_failure(void **state)
{
    (void)state;
    glint_error err;
    write_gnuplot("exec /bin/sleep 10000\n");
    assert_int_equal(plot(1.0, &err), GLINT_IO_ERROR);
    assert_memory_equal(err.text, "gnuplot did not finish within 1 s; run it in ", 45);
    assert_nothing_is_left();
}

static void a_slow_gnuplot_is_waited_for(void **state)
{
    (void)state;
    glint_error err;
    write_gnuplot("echo half\n/bin/sleep 0.3\necho whole\nexec >&-\n/bin/sleep 0.3\n");
    assert_int_equal(plot(child_patience, &err), GLINT_OK);
    char *picture = scratch_read(scratch_path("figure.svg"), NULL);
    assert_string_equal(picture, "half\nwhole\n");
    free(picture);
    assert_int_equal(remove(scratch_path("figure.png")), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_gnuplot_that_says_nothing_is_stopped),
        cmocka_unit_test(a_gnuplot_that_ends_its_picture_but_not_itself_is_stopped),
        cmocka_unit_test(a_gnuplot_that_never_ends_its_picture_is_stopped),
        cmocka_unit_test(what_gnuplot_started_ends_with_it),
        cmocka_unit_test(a_gnuplot_that_takes_too_long_is_a_failure),
        cmocka_unit_test(a_slow_gnuplot_is_waited_for),
    };
    return cmocka_run_group_tests(tests, make_places, remove_places);
}
