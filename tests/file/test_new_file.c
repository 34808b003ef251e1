/* A new file appears whole or not at all, and leaves nothing else behind. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"
#include "file/new_file.h"

static void write_text(const char *path, const char *text)
{
    glint_error err;
    glint_new_file *file;
    assert_int_equal(glint_new_file_open(path, &file, &err), GLINT_OK);
    fputs(text, glint_new_file_stream(file));
    assert_int_equal(glint_new_file_commit(file, &err), GLINT_OK);
}

static void assert_holds(const char *path, const char *text)
{
    char *found = scratch_read(path, NULL);
    assert_string_equal(found, text);
    free(found);
}

static void commit_gives_the_name(void **state)
{
    (void)state;
    const int before = scratch_count();
    write_text(scratch_path("new"), "content");
    assert_holds(scratch_path("new"), "content");
    assert_int_equal(scratch_count(), before + 1);
}

static void until_commit_the_old_content_stands(void **state)
{
    (void)state;
    glint_error err;
    glint_new_file *file;
    write_text(scratch_path("old"), "old");
    const int before = scratch_count();
    assert_int_equal(glint_new_file_open(scratch_path("old"), &file, &err), GLINT_OK);
    fputs("new", glint_new_file_stream(file));
    fflush(glint_new_file_stream(file));
    assert_holds(scratch_path("old"), "old");
    assert_int_equal(scratch_count(), before + 1);
    assert_int_equal(glint_new_file_commit(file, &err), GLINT_OK);
    assert_holds(scratch_path("old"), "new");
    assert_int_equal(scratch_count(), before);
}

static void discard_leaves_nothing(void **state)
{
    (void)state;
    glint_error err;
    glint_new_file *file;
    const int before = scratch_count();
    assert_int_equal(glint_new_file_open(scratch_path("discarded"), &file, &err), GLINT_OK);
    fputs("half of", glint_new_file_stream(file));
    glint_new_file_discard(file);
    assert_int_equal(scratch_count(), before);
}

static void permissions_are_kept(void **state)
{
    (void)state;
    struct stat info;
    write_text(scratch_path("mode"), "1");
    assert_int_equal(chmod(scratch_path("mode"), 0640), 0);
    write_text(scratch_path("mode"), "2");
    assert_int_equal(stat(scratch_path("mode"), &info), 0);
    assert_int_equal(info.st_mode & 07777, 0640);
}

static void a_new_file_has_the_usual_permissions(void **state)
{
    (void)state;
    struct stat info;
    const mode_t mask = umask(027);
    write_text(scratch_path("usual"), "1");
    umask(mask);
    assert_int_equal(stat(scratch_path("usual"), &info), 0);
    assert_int_equal(info.st_mode & 07777, 0640);
}

static void a_link_stays_a_link(void **state)
{
    (void)state;
    struct stat info;
    write_text(scratch_path("linked"), "old");
    assert_int_equal(symlink("linked", scratch_path("link")), 0);
    write_text(scratch_path("link"), "new");
    assert_holds(scratch_path("linked"), "new");
    assert_int_equal(lstat(scratch_path("link"), &info), 0);
    assert_true(S_ISLNK(info.st_mode));
}

static void a_device_stays_a_device(void **state)
{
    (void)state;
    struct stat info;
    write_text("/dev/null", "swallowed");
    assert_int_equal(stat("/dev/null", &info), 0);
    assert_true(S_ISCHR(info.st_mode));
}

static void a_full_disk_is_reported(void **state)
{
    (void)state;
    glint_error err;
    glint_new_file *file;
    assert_int_equal(glint_new_file_open("/dev/full", &file, &err), GLINT_OK);
    fputs("too much", glint_new_file_stream(file));
    assert_int_equal(glint_new_file_commit(file, &err), GLINT_IO_ERROR);
    assert_string_equal(err.text, "cannot write /dev/full: No space left on device");
}

static void a_pipe_that_nobody_reads_is_refused(void **state)
{
    (void)state;
    glint_error err;
    glint_new_file *file;
    const char *path = scratch_path("unread");
    assert_int_equal(mkfifo(path, 0666), 0);
    assert_int_equal(glint_new_file_check(path, &err), GLINT_OK); /* a reader may come yet */
    const double start = child_seconds();
    assert_int_equal(glint_new_file_open(path, &file, &err), GLINT_IO_ERROR);
    assert_true(child_seconds() - start >= GLINT_NEW_FILE_PATIENCE);
    assert_null(file);
    assert_non_null(strstr(err.text, path));
    assert_non_null(strstr(err.text, "in 5 s nobody came to read it"));
}

static void waiting_for_a_reader_can_be_stopped(void **state)
{
    (void)state;
    static const volatile bool stop = true;
    glint_error err;
    glint_new_file *file;
    const char *path = scratch_path("stopped");
    assert_int_equal(mkfifo(path, 0666), 0);
    assert_int_equal(glint_new_file_open_until(path, &stop, &file, &err), GLINT_INTERRUPTED);
    assert_null(file);
    assert_string_equal(err.text, "interrupted");
}

/* Its reader comes late and gets everything, more than the pipe holds. */
static void a_pipe_is_written_to(void **state)
{
    (void)state;
    glint_error err;
    glint_new_file *file;
    char path[1024], copy[1024];
    strcpy(path, scratch_path("pipe"));
    strcpy(copy, scratch_path("copy"));
    assert_int_equal(mkfifo(path, 0666), 0);
    const char *const reader[] = {"sh", "-c", "sleep 0.3; exec cat \"$0\"", path, NULL};
    const pid_t child = child_start(reader, copy, "/dev/null");
    assert_int_equal(glint_new_file_check(path, &err), GLINT_OK);
    assert_int_equal(glint_new_file_open(path, &file, &err), GLINT_OK);
    for (int i = 0; i < 200000; i++) {
        fputc('a' + i % 26, glint_new_file_stream(file));
    }
    assert_int_equal(glint_new_file_commit(file, &err), GLINT_OK);
    assert_int_equal(child_wait(child, 20.0), 0);
    size_t count;
    char *got = scratch_read(copy, &count);
    assert_int_equal(count, 200000);
    for (int i = 0; i < 200000; i++) {
        assert_int_equal(got[i], 'a' + i % 26);
    }
    free(got);
}

static void what_cannot_be_written_is_refused(void **state)
{
    (void)state;
    glint_error err;
    glint_new_file *file;
    write_text(scratch_path("plain"), "");
    const char *const paths[] = {
        scratch_path("."),
        scratch_path("missing/file"),
        scratch_path("plain/file"),
    };
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++) {
        assert_int_equal(glint_new_file_open(paths[i], &file, &err), GLINT_IO_ERROR);
        assert_null(file);
        assert_non_null(strstr(err.text, paths[i]));
        assert_int_equal(glint_new_file_check(paths[i], &err), GLINT_IO_ERROR);
        assert_non_null(strstr(err.text, paths[i]));
    }
}

static void check_leaves_nothing(void **state)
{
    (void)state;
    glint_error err;
    const int before = scratch_count();
    assert_int_equal(glint_new_file_check(scratch_path("probe"), &err), GLINT_OK);
    assert_int_equal(glint_new_file_check("/dev/null", &err), GLINT_OK);
    assert_int_equal(scratch_count(), before);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(commit_gives_the_name),
        cmocka_unit_test(until_commit_the_old_content_stands),
        cmocka_unit_test(discard_leaves_nothing),
        cmocka_unit_test(permissions_are_kept),
        cmocka_unit_test(a_new_file_has_the_usual_permissions),
        cmocka_unit_test(a_link_stays_a_link),
        cmocka_unit_test(a_device_stays_a_device),
        cmocka_unit_test(a_full_disk_is_reported),
        cmocka_unit_test(a_pipe_that_nobody_reads_is_refused),
        cmocka_unit_test(waiting_for_a_reader_can_be_stopped),
        cmocka_unit_test(a_pipe_is_written_to),
        cmocka_unit_test(what_cannot_be_written_is_refused),
        cmocka_unit_test(check_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
