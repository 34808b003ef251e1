/* What is shown to people only: on a terminal, hints, progress and colours; else none of them. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "run.h"

#include "../child.h"
#include "../terminal.h"

#define PNG       "tests/fuzz/corpus/png/rgba.png"
#define RED       "\033[1;31m"
#define GREEN     "\033[1;32m"
#define PLAIN     "\033[0m"
#define SECONDS   60.0
#define SHOWN_MAX 65536

static char shown[SHOWN_MAX];

static int make_pictures(void)
{
    char line[1200];
    (void)snprintf(line, sizeof line, "render --model quad --size 8x8 --out %s/a.png",
                   scratch_directory);
    outcome done = run(line, "");
    int failed = done.status;
    forget(&done);
    (void)snprintf(line, sizeof line, "render --model quad --n 1 --size 8x8 --out %s/b.png",
                   scratch_directory);
    done = run(line, "");
    failed |= done.status;
    forget(&done);
    return failed;
}

/* compare of two pictures on a terminal, up to where its last line begins. */
static void compare_shown(const char *other)
{
    char a[1024], b[1024];
    terminal screen = terminal_open();
    (void)snprintf(a, sizeof a, "%s/a.png", scratch_directory);
    (void)snprintf(b, sizeof b, "%s/%s", scratch_directory, other);
    const char *const argv[] = {glint_under_test(), "compare", a, b, NULL};
    const pid_t child = child_start(argv, screen.name, screen.name);
    terminal_wait_for(&screen, child, "NMSE", shown, sizeof shown);
    assert_int_equal(child_wait(child, SECONDS), strcmp(other, "a.png") == 0 ? 0 : 1);
    terminal_close(&screen);
}

static void a_verdict_is_coloured_on_a_terminal(void **state)
{
    (void)state;
    assert_int_equal(unsetenv("NO_COLOR"), 0);
    assert_int_equal(setenv("TERM", "xterm", 1), 0);
    compare_shown("a.png");
    assert_says(shown, GREEN "0 differing pixels" PLAIN " of 64");
    compare_shown("b.png");
    assert_says(shown, RED);
    assert_says(shown, " differing pixels" PLAIN " of 64");
}

static void not_where_colours_are_unwanted(void **state)
{
    (void)state;
    assert_int_equal(setenv("TERM", "xterm", 1), 0);
    assert_int_equal(setenv("NO_COLOR", "1", 1), 0);
    compare_shown("b.png");
    assert_null(strchr(shown, '\033'));
    assert_int_equal(setenv("NO_COLOR", "", 1), 0); /* as if it were not there */
    compare_shown("b.png");
    assert_says(shown, RED);
    assert_int_equal(unsetenv("NO_COLOR"), 0);
    assert_int_equal(setenv("TERM", "dumb", 1), 0);
    compare_shown("b.png");
    assert_null(strchr(shown, '\033'));
    assert_int_equal(setenv("TERM", "xterm", 1), 0);
}

static void nothing_is_coloured_in_a_file(void **state)
{
    (void)state;
    static const char *const lines[] = {"compare %s/a.png %s/b.png", "compare %s/a.png %s/none.png",
                                        "verify --clocks 50 --circuit divider --shifts 8"};
    assert_int_equal(setenv("TERM", "xterm", 1), 0);
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        char line[2048];
        const char *end = strstr(lines[i], "%s/a.png");
        (void)snprintf(line, sizeof line, "%.*s%s%s%s%s",
                       end != NULL ? (int)(end - lines[i]) : (int)strlen(lines[i]), lines[i],
                       end != NULL ? scratch_directory : "", end != NULL ? "/a.png " : "",
                       end != NULL ? scratch_directory : "",
                       end != NULL ? strrchr(lines[i], '/') : "");
        outcome done = run(line, "");
        assert_true(done.out[0] != '\0' || done.err[0] != '\0');
        assert_null(strchr(done.out, '\033'));
        assert_null(strchr(done.err, '\033'));
        assert_null(strchr(done.err, '\r'));
        forget(&done);
    }
}

static void a_message_has_its_name_in_colour(void **state)
{
    (void)state;
    terminal screen = terminal_open();
    const char *const argv[] = {glint_under_test(), "compare", PNG, NULL};
    const pid_t child = child_start(argv, scratch_path("child.out"), screen.name);
    terminal_wait_for(&screen, child, "--help)", shown, sizeof shown);
    assert_says(shown, RED "glint compare:" PLAIN " B.png is missing");
    assert_int_equal(child_wait(child, SECONDS), 2);
    terminal_close(&screen);
}

/* Starts a subcommand whose standard input and error are the terminal. */
static pid_t start_typed(const char *subcommand, const terminal *screen)
{
    pid_t child;
    posix_spawn_file_actions_t actions;
    char *argv[] = {(char *)(uintptr_t)glint_under_test(), (char *)(uintptr_t)subcommand, NULL};
    assert_int_equal(posix_spawn_file_actions_init(&actions), 0);
    assert_int_equal(posix_spawn_file_actions_addopen(&actions, 0, screen->name, O_RDONLY, 0), 0);
    assert_int_equal(posix_spawn_file_actions_addopen(&actions, 1, screen->name, O_WRONLY, 0), 0);
    assert_int_equal(posix_spawn_file_actions_addopen(&actions, 2, screen->name, O_WRONLY, 0), 0);
    assert_int_equal(posix_spawn(&child, argv[0], &actions, NULL, argv, environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    return child;
}

static void who_waits_says_for_what(void **state)
{
    (void)state;
    static const struct {
        const char *subcommand, *hint, *typed, *answer;
    } typing[] = {
        {"eval", "glint eval: waiting for points, one per line: n cos r g b", "80 1 9 8 7\n",
         "80,262144,262144,9,8,7"},
        {"divide", "glint divide: waiting for divisions, one per line: difference k", "16 2\n",
         "16,2,12,32768,8,8,0"},
    };
    for (size_t i = 0; i < 2; i++) {
        terminal screen = terminal_open();
        const pid_t child = start_typed(typing[i].subcommand, &screen);
        terminal_wait_for(&screen, child, "end with Ctrl-D", shown, sizeof shown);
        assert_says(shown, typing[i].hint);
        const size_t length = strlen(typing[i].typed);
        assert_int_equal(write(screen.master, typing[i].typed, length), length);
        terminal_wait_for(&screen, child, typing[i].answer, shown, sizeof shown);
        assert_int_equal(write(screen.master, "\004", 1), 1);
        assert_int_equal(child_wait(child, SECONDS), 0);
        terminal_close(&screen);
    }
    outcome done = run("eval", "80 1 9 8 7\n");
    assert_outcome(&done, 0, ""); /* no hint without a terminal */
    forget(&done);
}

static void a_large_frame_shows_how_far_it_is(void **state)
{
    (void)state;
    char picture[1024];
    (void)snprintf(picture, sizeof picture, "%s/large.png", scratch_directory);
    const char *const argv[] = {glint_under_test(),
                                "render",
                                "--size",
                                "4000x3000",
                                "--threads",
                                "2",
                                "--out",
                                picture,
                                NULL};
    terminal screen = terminal_open();
    const pid_t child = child_start(argv, scratch_path("child.out"), screen.name);
    terminal_wait_for(&screen, child, "rows of the picture, ", shown, sizeof shown);
    assert_says(shown, "glint render: ");
    assert_says(shown, " bands of the frame, ");
    assert_int_equal(child_wait(child, SECONDS), 0);
    terminal_close(&screen);
    assert_int_equal(child_run(argv, SECONDS), 0);
    char *said = scratch_read(scratch_path("child.err"), NULL);
    assert_string_equal(said, "");
    free(said);
}

static int set_up(void **state)
{
    return scratch_make(state) != 0 || make_pictures() != 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_verdict_is_coloured_on_a_terminal),
        cmocka_unit_test(not_where_colours_are_unwanted),
        cmocka_unit_test(nothing_is_coloured_in_a_file),
        cmocka_unit_test(a_message_has_its_name_in_colour),
        cmocka_unit_test(who_waits_says_for_what),
        cmocka_unit_test(a_large_frame_shows_how_far_it_is),
    };
    return cmocka_run_group_tests(tests, set_up, scratch_remove);
}
