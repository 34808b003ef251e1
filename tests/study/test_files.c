/* The files of a study take their names together, or not at all. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/wait.h>

#include <cmocka.h>

#include "../scratch.h"
#include "study/files.h"

#define NOBODY 65534

static void write_before(const char *name)
{
    scratch_write(scratch_path(name), "of before", 9);
}

static void assert_holds(const char *name, const char *text)
{
    char *found = scratch_read(scratch_path(name), NULL);
    assert_string_equal(found, text);
    free(found);
}

/* Writes study.csv and the picture of n = 1. */
static glint_status write_study(const char *directory, glint_error *err)
{
    static const char *const names[] = {"study.csv", "n-0001.png"};
    glint_study_files *files = NULL;
    FILE *stream;
    glint_status status = glint_study_files_create(directory, &files, err);
    for (int i = 0; i < 2 && status == GLINT_OK; i++) {
        status = glint_study_files_add(files, names[i], &stream, err);
        if (status == GLINT_OK) {
            fputs("of now", stream);
            status = glint_study_files_end(files, err);
        }
    }
    if (status == GLINT_OK)
        status = glint_study_files_commit(files, err);
    glint_study_files_destroy(files);
    return status;
}

static void a_study_replaces_the_one_before(void **state)
{
    (void)state;
    glint_error err;
    write_before("study.csv");
    scratch_write(scratch_path("times.csv"), "n,frames", 8);
    scratch_write(scratch_path("n-0002.png"), "\x89PNG\r\n\x1a\n", 8);
    write_before("n-0003.png"); /* no picture of a study */
    write_before("notes.txt");
    write_before("n-2.png");
    assert_int_equal(write_study(scratch_directory, &err), GLINT_OK);
    assert_holds("study.csv", "of now");
    assert_holds("n-0001.png", "of now");
    assert_int_equal(access(scratch_path("times.csv"), F_OK), -1);
    assert_int_equal(access(scratch_path("n-0002.png"), F_OK), -1);
    assert_holds("notes.txt", "of before");
    assert_holds("n-2.png", "of before");
    assert_holds("n-0003.png", "of before");
}

/* As nobody, since root may read everything: 0 when the study fails as it must. */
static int write_as_nobody(const char *directory)
{
    glint_error err;
    if (geteuid() == 0 && (setgid(NOBODY) != 0 || setuid(NOBODY) != 0))
        return 2;
    return write_study(directory, &err) == GLINT_IO_ERROR &&
                   strncmp(err.text, "cannot read ", 12) == 0
               ? 0
               : 1;
}

/* What an earlier study left there could not be found. */
static void a_directory_that_cannot_be_read_is_left_as_it_is(void **state)
{
    (void)state;
    char directory[1024];
    int status = -1;
    (void)snprintf(directory, sizeof directory, "%s", scratch_path("closed"));
    assert_int_equal(mkdir(directory, 0777), 0);
    write_before("closed/study.csv");
    assert_int_equal(chmod(scratch_directory, 0755), 0);
    if (geteuid() == 0) {
        assert_int_equal(chown(directory, NOBODY, NOBODY), 0);
        assert_int_equal(chown(scratch_path("closed/study.csv"), NOBODY, NOBODY), 0);
    }
    assert_int_equal(chmod(directory, 0333), 0);
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0)
        _exit(write_as_nobody(directory));
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(chmod(directory, 0755), 0);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    assert_holds("closed/study.csv", "of before");
    assert_int_equal(access(scratch_path("closed/n-0001.png"), F_OK), -1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_study_replaces_the_one_before),
        cmocka_unit_test(a_directory_that_cannot_be_read_is_left_as_it_is),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
