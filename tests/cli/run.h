/* Runs the command under test as a user's shell would, and captures its output.
 *
 * Include it after cmocka.h and ../scratch.h: its files lie in the scratch directory. The command
 * is build/glint, or what the environment variable GLINT names. */
#ifndef GLINT_TESTS_CLI_RUN_H
#define GLINT_TESTS_CLI_RUN_H

#include <fcntl.h>
#include <spawn.h>
#include <stdbool.h>
#include <sys/wait.h>

extern char **environ;

#define RUN_ARGUMENTS_MAX 40

typedef struct outcome {
    int status; /* exit status; 128 + the signal's number when one ended it */
    char *out;  /* to be freed, with err: forget() */
    char *err;
} outcome;

/* Where standard input and output go, when not to files of the scratch directory. */
typedef struct plumbing {
    const char *in;  /* a path; NULL: the text given */
    const char *out; /* a path; NULL: kept in outcome.out */
    bool close_in, close_out;
} plumbing;

static inline const char *glint_under_test(void)
{
    const char *path = getenv("GLINT");
    return path != NULL ? path : "build/glint";
}

static inline void forget(outcome *done)
{
    free(done->out);
    free(done->err);
}

/* Splits a command line at spaces into arguments; words of it are altered. Returns their count. */
static inline size_t split_words(char *words, char **argv)
{
    size_t count = 0;
    for (char *word = strtok(words, " "); word != NULL; word = strtok(NULL, " ")) {
        assert_true(count < RUN_ARGUMENTS_MAX);
        argv[count++] = word;
    }
    return count;
}

static inline void connect_streams(posix_spawn_file_actions_t *actions, const plumbing *pipes)
{
    const char *in = pipes->in != NULL ? pipes->in : scratch_path("stdin");
    const char *out = pipes->out != NULL ? pipes->out : scratch_path("stdout");
    assert_int_equal(posix_spawn_file_actions_init(actions), 0);
    assert_int_equal(posix_spawn_file_actions_addopen(actions, 0, in, O_RDONLY, 0), 0);
    assert_int_equal(
        posix_spawn_file_actions_addopen(actions, 1, out, O_WRONLY | O_CREAT | O_TRUNC, 0666), 0);
    assert_int_equal(posix_spawn_file_actions_addopen(actions, 2, scratch_path("stderr"),
                                                      O_WRONLY | O_CREAT | O_TRUNC, 0666),
                     0);
    if (pipes->close_in)
        assert_int_equal(posix_spawn_file_actions_addclose(actions, 0), 0);
    if (pipes->close_out)
        assert_int_equal(posix_spawn_file_actions_addclose(actions, 1), 0);
}

static inline int wait_for(pid_t child)
{
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/* Runs argv (argv[0] is ignored, NULL ends it) with count bytes of input. */
static inline outcome run_arguments(char **argv, const void *input, size_t count,
                                    const plumbing *pipes)
{
    pid_t child;
    posix_spawn_file_actions_t actions;
    scratch_write(scratch_path("stdin"), input, count);
    scratch_write(scratch_path("stdout"), "", 0);
    connect_streams(&actions, pipes);
    argv[0] = (char *)(uintptr_t)glint_under_test();
    assert_int_equal(posix_spawn(&child, argv[0], &actions, NULL, argv, environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    outcome done;
    done.status = wait_for(child);
    done.out = scratch_read(scratch_path("stdout"), NULL);
    done.err = scratch_read(scratch_path("stderr"), NULL);
    return done;
}

/* Runs "render --n 5": words apart by single spaces, none of them empty. */
static inline outcome run_plumbed(const char *command_line, const char *input,
                                  const plumbing *pipes)
{
    char words[2048];
    char *argv[RUN_ARGUMENTS_MAX + 2] = {NULL};
    assert_true(strlen(command_line) < sizeof words);
    strcpy(words, command_line);
    split_words(words, argv + 1);
    return run_arguments(argv, input, strlen(input), pipes);
}

static inline outcome run(const char *command_line, const char *input)
{
    const plumbing none = {0};
    return run_plumbed(command_line, input, &none);
}

/* Asserts how a run ended and every byte of standard error; NULL: not looked at. */
static inline void assert_outcome(const outcome *done, int status, const char *err)
{
    if (done->status != status || (err != NULL && strcmp(done->err, err) != 0)) {
        fail_msg("exit status %d, standard error \"%s\"; expected %d, \"%s\"", done->status,
                 done->err, status, err != NULL ? err : "(any)");
    }
}

static inline void assert_says(const char *text, const char *part)
{
    if (strstr(text, part) == NULL)
        fail_msg("\"%s\" does not say \"%s\"", text, part);
}

#endif
