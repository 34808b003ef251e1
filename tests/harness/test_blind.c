/* A test of the command must fail if the command does nothing. All are run with /bin/true and
 * /bin/false in place of the command and of the one with planted differences; none may pass except
 * those listed here with a reason. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"

typedef struct exception {
    const char *program, *test, *reason;
} exception;

#define OF_THE_LIBRARY "calls the library and runs no command"

static const exception exceptions[] = {
    {"draw/test_drawings", "a_stale_drawing_would_be_seen", OF_THE_LIBRARY},
    {"draw/test_drawings", "nothing_lies_on_anything_else", OF_THE_LIBRARY},
    {"draw/test_drawings", "the_figure_is_complete", OF_THE_LIBRARY},
    {"draw/test_drawings", "an_enable_is_named_whichever_level_it_has", OF_THE_LIBRARY},
    {"draw/test_drawings", "a_circuit_may_have_the_name_of_a_keyword", OF_THE_LIBRARY},
    {"draw/test_drawings", "a_long_title_fits", OF_THE_LIBRARY},
    {"draw/test_drawings", "descriptions_that_make_no_drawing_are_refused", OF_THE_LIBRARY},
    {"failure/test_answer", "the_points_about_it_stay_on_their_lanes", OF_THE_LIBRARY},
    {"failure/test_answer", "a_circuit_that_keeps_a_lone_answer_back_has_a_packet", OF_THE_LIBRARY},
    {"failure/test_answer", "what_went_before_is_played", OF_THE_LIBRARY},
    {"failure/test_answer", "where_the_answer_is_right_the_first_difference_is_marked",
     OF_THE_LIBRARY},
    {"failure/test_answer", "a_circuit_that_keeps_an_answer_back_is_found_out", OF_THE_LIBRARY},
    {"failure/test_answer", "what_does_not_matter_is_left_out", OF_THE_LIBRARY},
    {"failure/test_answer", "a_history_keeps_the_last_clocks", OF_THE_LIBRARY},
    {"failure/test_answer", "a_frame_without_an_answer_still_says_where", OF_THE_LIBRARY},
    {"failure/test_answer", "one_thread_alone_can_be_watched", OF_THE_LIBRARY},
    {"failure/test_answer", "a_right_circuit_is_never_noted", OF_THE_LIBRARY},
    {"shader/test_gl", "every_model_is_within_a_level_of_real", OF_THE_LIBRARY},
    {"shader/test_gl", "another_model_is_noticed", OF_THE_LIBRARY},
    {"shader/test_gl", "the_device_in_a_shader_is_the_device", OF_THE_LIBRARY},
    {"shader/test_gl", "every_shading_and_view_is_real_s", OF_THE_LIBRARY},
    {"shader/test_gl", "gouraud_is_real_s_but_for_its_runs", OF_THE_LIBRARY},
    {"shader/test_gl", "frames_repeat", OF_THE_LIBRARY},
    {"shader/test_gl", "what_is_out_of_range_is_refused", OF_THE_LIBRARY},
    {"shader/test_gl", "gold_is_the_listing_s", OF_THE_LIBRARY},
    {"convert/test_convert", "a_flat_file_is_noticed", OF_THE_LIBRARY},
    {"convert/test_convert", "a_fold_that_ends_stays_a_fold", OF_THE_LIBRARY},
    {"convert/test_convert", "cube_and_cylinder_keep_every_normal", OF_THE_LIBRARY},
    {"convert/test_convert", "lib3ds_reads_the_same", OF_THE_LIBRARY},
    {"convert/test_convert", "parts_keep_to_the_limit", OF_THE_LIBRARY},
    {"convert/test_convert", "pictures_are_the_same", OF_THE_LIBRARY},
};
#define EXCEPTIONS (sizeof exceptions / sizeof exceptions[0])

static bool used[EXCEPTIONS];

static bool is_excepted(const char *program, const char *test)
{
    for (size_t i = 0; i < EXCEPTIONS; i++) {
        if (strcmp(program, exceptions[i].program) == 0 && strcmp(test, exceptions[i].test) == 0) {
            used[i] = true;
            return true;
        }
    }
    return false;
}

/* The commands of a build directory that has nothing but `idle` to run. */
static void make_commands(const char *idle)
{
    static const char command[] = "planted/glint";
    (void)mkdir(scratch_path("planted"), 0777);
    (void)unlink(scratch_path(command));
    assert_int_equal(symlink(idle, scratch_path(command)), 0);
}

/* tests/cli/test_x.c to cli/test_x. */
static void name_of(const char *source, char name[256])
{
    const size_t length = strlen(source) - strlen("tests/") - strlen(".c");
    assert_true(length < 256);
    memcpy(name, source + strlen("tests/"), length);
    name[length] = '\0';
}

/* The number of tests that a program ran; each one that passed but must not is reported and counted
 * in *passed. */
static int judge(const char *program, char *log, int *passed)
{
    static const char ran[] = "[ RUN      ] ", good[] = "[       OK ] ";
    int count = 0;
    for (char *line = strtok(log, "\n"); line != NULL; line = strtok(NULL, "\n")) {
        count += strncmp(line, ran, sizeof ran - 1) == 0;
        if (strncmp(line, good, sizeof good - 1) == 0 &&
            !is_excepted(program, line + sizeof good - 1)) {
            print_error("%s: %s passes with a command that does nothing\n", program,
                        line + sizeof good - 1);
            (*passed)++;
        }
    }
    return count;
}

/* How many tests the program said that it would run. */
static int announced_in(const char *log)
{
    const char *said = strstr(log, "] Running ");
    return said != NULL ? (int)strtol(said + strlen("] Running "), NULL, 10) : 0;
}

/* How many tests the source declares; a list made by a macro has more. */
static int declared_in(const char *source)
{
    static const char word[] = "cmocka_unit_test";
    int count = 0;
    char *text = scratch_read(source, NULL);
    for (const char *c = text; (c = strstr(c, word)) != NULL; c += sizeof word)
        count++;
    free(text);
    return count;
}

/* A group whose setup fails, as it may here, runs no test; else it runs all, none of them crashing
 * the program before the next. */
static int run_program(const char *build, const char *source, const char *idle)
{
    char name[256], path[1024];
    int passed = 0;
    name_of(source, name);
    (void)snprintf(path, sizeof path, "%s/tests/%s", build, name);
    assert_int_equal(setenv("GLINT", idle, 1), 0);
    assert_int_equal(setenv("GLINT_BUILD", scratch_directory, 1), 0);
    const char *const argv[] = {path, NULL};
    const int status =
        child_wait(child_start(argv, scratch_path("tests.log"), scratch_path("tests.err")), 120.0);
    char *log = scratch_read(scratch_path("tests.log"), NULL);
    const int announced = announced_in(log);
    const int ran = judge(name, log, &passed);
    if (status == CHILD_TIMED_OUT ||
        (ran != 0 && (ran != announced || ran < declared_in(source)))) {
        print_error("%s: exit status %d after %d of %d tests\n", name, status, ran, announced);
        passed++;
    }
    free(log);
    return passed;
}

static void run_all(const char *idle)
{
    static const char find[] =
        "grep -l -e '\"run.h\"' -e 'cli/run.h\"' -e '\"abuse.h\"' -e 'getenv(\"GLINT\")'"
        " tests/*/test_*.c | grep -v harness";
    const char *given = getenv("GLINT_BUILD");
    char *const build = strdup(given != NULL ? given : "build");
    const char *const argv[] = {"sh", "-c", find, NULL};
    int programs = 0, passed = 0;
    assert_non_null(build);
    make_commands(idle);
    assert_int_equal(child_run(argv, 60.0), 0);
    char *list = scratch_read(scratch_path("child.out"), NULL);
    char *rest = list;
    for (char *source; (source = strtok_r(rest, "\n", &rest)) != NULL;) {
        passed += run_program(build, source, idle);
        programs++;
    }
    assert_int_equal(setenv("GLINT_BUILD", build, 1), 0);
    free(list);
    free(build);
    assert_true(programs >= 25);
    assert_int_equal(passed, 0);
}

static void no_test_passes_with_a_command_that_does_nothing(void **state)
{
    (void)state;
    run_all("/bin/true");
}

static void no_test_passes_with_a_command_that_fails_in_silence(void **state)
{
    (void)state;
    run_all("/bin/false");
}

static void no_exception_is_out_of_date(void **state)
{
    (void)state;
    for (size_t i = 0; i < EXCEPTIONS; i++) {
        if (!used[i]) {
            fail_msg("%s: %s does not pass, or is no more", exceptions[i].program,
                     exceptions[i].test);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_test_passes_with_a_command_that_does_nothing),
        cmocka_unit_test(no_test_passes_with_a_command_that_fails_in_silence),
        cmocka_unit_test(no_exception_is_out_of_date),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
