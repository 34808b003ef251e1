/* A crash in the C model is told whichever thread it is in, however many threads came before; and
 * a model that could not be created is not destroyed. */
#define _POSIX_C_SOURCE 200809L

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "circuit/guard.h"
#include "circuit/model.h"

/* An address sanitizer has a handler of its own, which the guard leaves alone. */
#if defined __SANITIZE_ADDRESS__
#define IS_SANITIZED 1
#elif defined __has_feature
#if __has_feature(address_sanitizer)
#define IS_SANITIZED 1
#endif
#endif

static void *visit(void *unused)
{
    glint_guard_enter();
    glint_guard_leave();
    return unused;
}

/* Until the stack is full: the handler then needs one of its own. */
static int overflow(const volatile int *depth)
{
    volatile int frame[1000];
    frame[0] = *depth + 1;
    return *depth < 0 ? 0 : overflow(frame) + frame[0];
}

static void *fall(void *unused)
{
    volatile int depth = 0;
    glint_guard_enter();
    (void)overflow(&depth);
    return unused;
}

static void in_thread(void *(*body)(void *))
{
    pthread_t thread;
    if (pthread_create(&thread, NULL, body, NULL) != 0)
        _exit(99);
    (void)pthread_join(thread, NULL);
}

/* The exit status of a process of its own, and what it says. */
static int run(void (*body)(void), char *said, size_t size)
{
    int out[2], state;
    size_t length = 0;
    ssize_t got;
    assert_int_equal(pipe(out), 0);
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        (void)dup2(out[1], STDERR_FILENO);
        body();
        _exit(98);
    }
    (void)close(out[1]);
    while ((got = read(out[0], said + length, size - 1 - length)) > 0)
        length += (size_t)got;
    said[length] = '\0';
    (void)close(out[0]);
    assert_int_equal(waitpid(child, &state, 0), child);
    return WIFEXITED(state) ? WEXITSTATUS(state) : -WTERMSIG(state);
}

static void many_threads(void)
{
    (void)signal(SIGSEGV, SIG_DFL); /* cmocka's own */
    glint_guard_begin("here");
    for (int i = 0; i < 200; i++)
        in_thread(visit);
    glint_guard_end();
    _exit(97);
}

static void many_threads_and_one_that_falls(void)
{
    (void)signal(SIGSEGV, SIG_DFL);
    glint_guard_begin("here");
    for (int i = 0; i < 200; i++)
        in_thread(visit);
    in_thread(fall);
}

/* A sanitizer, too, has a stack for the handlers of each, which it takes down in the end. */
static void threads_come_and_go(void **state)
{
    (void)state;
    char said[2000];
    assert_int_equal(run(many_threads, said, sizeof said), 97);
    assert_string_equal(said, "");
}

static void the_last_of_many_threads_is_watched(void **state)
{
    (void)state;
    char said[2000];
#ifdef IS_SANITIZED
    print_message("a sanitizer reports crashes in its own way\n");
    skip();
#endif
    assert_int_equal(run(many_threads_and_one_that_falls, said, sizeof said),
                     GLINT_GUARD_EXIT_STATUS);
    assert_non_null(strstr(said, "here: the C model crashed: segmentation fault"));
}

static glint_status free_and_fail(const int *values, void **model)
{
    (void)values;
    *model = malloc(1);
    free(*model);
    return GLINT_NO_MEMORY;
}

static void a_model_that_was_not_created_is_none(void **state)
{
    (void)state;
    const glint_circuit circuit = {.create = free_and_fail, .destroy = free};
    const glint_setting setting = {.circuit = &circuit};
    void *model = &model;
    glint_error err;
    assert_int_equal(glint_model_create(&setting, &model, &err), GLINT_NO_MEMORY);
    assert_null(model);
    glint_model_destroy(&setting, model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(threads_come_and_go),
        cmocka_unit_test(the_last_of_many_threads_is_watched),
        cmocka_unit_test(a_model_that_was_not_created_is_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
