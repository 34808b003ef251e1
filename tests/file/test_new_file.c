/* A new file appears complete or not at all, and leaves nothing else behind. */
#define _GNU_SOURCE /* O_TMPFILE */

#include <fcntl.h>
#include <sched.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/mount.h>
#include <sys/wait.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"
#include "file/new_file.h"
#include "file/temporary.h"

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
    assert_true(scratch_count() <= before + 1); /* it may have another name until then */
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

/* Also through several links, relative and absolute, each relative to where it lies. */
static void a_link_that_leads_nowhere_makes_what_it_names(void **state)
{
    (void)state;
    struct stat info;
    assert_int_equal(mkdir(scratch_path("below"), 0777), 0);
    assert_int_equal(symlink("below/second", scratch_path("first")), 0);
    assert_int_equal(symlink(scratch_path("third"), scratch_path("below/second")), 0);
    assert_int_equal(symlink("made", scratch_path("third")), 0);
    write_text(scratch_path("first"), "through");
    assert_holds(scratch_path("made"), "through");
    static const char *const links[] = {"first", "below/second", "third"};
    for (size_t i = 0; i < 3; i++) {
        assert_int_equal(lstat(scratch_path(links[i]), &info), 0);
        assert_true(S_ISLNK(info.st_mode));
    }
}

static void a_link_that_cannot_be_followed_is_refused(void **state)
{
    (void)state;
    glint_error err;
    glint_new_file *file;
    assert_int_equal(symlink("circle", scratch_path("circle")), 0);
    assert_int_equal(symlink("missing/made", scratch_path("nowhere")), 0);
    assert_int_equal(glint_new_file_open(scratch_path("circle"), &file, &err), GLINT_IO_ERROR);
    assert_non_null(strstr(err.text, "circle: Too many levels of symbolic links"));
    assert_int_equal(glint_new_file_open(scratch_path("nowhere"), &file, &err), GLINT_IO_ERROR);
    assert_non_null(strstr(err.text, "nowhere: No such file or directory"));
}

/* Where it has come to when it is killed. */
typedef enum moment { OPENED, WRITTEN, CLOSED } moment;

static void be_killed(const char *path, moment when)
{
    glint_error err;
    glint_new_file *file;
    if (glint_new_file_open(path, &file, &err) == GLINT_OK) {
        for (int i = 0; i < 100000 && when >= WRITTEN; i++)
            fputs("half of", glint_new_file_stream(file));
        if (when == CLOSED)
            (void)glint_new_file_close(file, &err);
        kill(getpid(), SIGKILL);
    }
    _exit(1);
}

static void end_in_the_middle(const char *path, moment when)
{
    int status;
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0)
        be_killed(path, when);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

/* Whether this directory's file system has files without a name. */
static bool has_unnamed_files(void)
{
    const int fd = open(scratch_directory, O_TMPFILE | O_WRONLY, 0666);
    return fd >= 0 && close(fd) == 0;
}

static void a_killed_process_leaves_nothing(void **state)
{
    (void)state;
    if (!has_unnamed_files()) {
        print_message("this file system has no files without a name\n");
        skip();
    }
    write_text(scratch_path("whole"), "old");
    const int before = scratch_count();
    for (moment when = OPENED; when <= CLOSED; when++) {
        end_in_the_middle(scratch_path("never"), when);
        end_in_the_middle(scratch_path("whole"), when);
        assert_int_equal(scratch_count(), before);
    }
    assert_holds(scratch_path("whole"), "old");
}

/* The name that a process of that number would use here for its attempt-th file. */
static const char *name_of(long process, int attempt, bool elsewhere)
{
    static char path[1024];
    unsigned host;
    long own;
    char *name = glint_temporary_name(scratch_path("x"), 0);
    assert_int_equal(sscanf(strrchr(name, '/'), "/.glint-%8x-%ld-0.tmp", &host, &own), 2);
    assert_int_equal(own, getpid());
    free(name);
    (void)snprintf(path, sizeof path, "%s/.glint-%08x-%ld-%d.tmp", scratch_directory,
                   elsewhere ? host ^ 1U : host, process, attempt);
    return path;
}

/* A number that no process has: that of a child which has been waited for. */
static long dead_process(void)
{
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0)
        _exit(0);
    assert_int_equal(waitpid(child, NULL, 0), child);
    return child;
}

/* Where there are no unnamed files, or killed between the two steps of replacing one. */
static void what_the_dead_have_left_is_cleared(void **state)
{
    (void)state;
    const long dead = dead_process();
    char waveform[1100];
    const int before = scratch_count();
    scratch_write(name_of(dead, 0, false), "half", 4);
    scratch_write(name_of(dead, 17, false), "", 0);
    (void)snprintf(waveform, sizeof waveform, "%s.hier", name_of(dead, 1001, false));
    scratch_write(waveform, "half", 4);
    assert_int_equal(mkdir(name_of(dead, 1002, false), 0777), 0);
    (void)snprintf(waveform, sizeof waveform, "%s/wave.fst", name_of(dead, 1002, false));
    scratch_write(waveform, "half", 4);
    assert_int_equal(scratch_count(), before + 4);
    write_text(scratch_path("cleared"), "x");
    assert_int_equal(scratch_count(), before + 1);
}

/* In a process without /proc, where no unnamed file could get a name: 0 when a killed writer leaves
 * one file, with a name, and the next writer clears it; 2 when /proc cannot be hidden here. */
static int leave_a_name(void)
{
    if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", NULL, MS_REC | MS_PRIVATE, NULL) != 0 ||
        mount("tmpfs", "/proc", "tmpfs", 0, NULL) != 0)
        return 2;
    const int before = scratch_count();
    end_in_the_middle(scratch_path("late"), WRITTEN);
    const int after = scratch_count();
    write_text(scratch_path("late"), "whole");
    return after == before + 1 && scratch_count() == before + 1 ? 0 : 1;
}

static void without_unnamed_files_a_name_is_left_and_cleared(void **state)
{
    (void)state;
    int status;
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0)
        _exit(leave_a_name());
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    if (WEXITSTATUS(status) == 2) {
        print_message("/proc cannot be hidden here\n");
        skip();
    }
    assert_int_equal(WEXITSTATUS(status), 0);
    assert_holds(scratch_path("late"), "whole");
}

static void what_may_be_someone_elses_stays(void **state)
{
    (void)state;
    const long dead = dead_process();
    char keep[8][1100];
    int count = 0;
    (void)snprintf(keep[count++], sizeof keep[0], "%s", name_of(getppid(), 0, false)); /* alive */
    (void)snprintf(keep[count++], sizeof keep[0], "%s", name_of(getpid(), 7, false));
    (void)snprintf(keep[count++], sizeof keep[0], "%s", name_of(dead, 0, true)); /* elsewhere */
    (void)snprintf(keep[count++], sizeof keep[0], "%s", name_of(-1, 0, false));
    (void)snprintf(keep[count++], sizeof keep[0], "%s/.glint-notes.tmp", scratch_directory);
    (void)snprintf(keep[count++], sizeof keep[0], "%s/glint-%ld-0.tmp", scratch_directory, dead);
    for (int i = 0; i < count; i++)
        scratch_write(keep[i], "keep", 4);
    if (geteuid() == 0) { /* only root can give a file away */
        (void)snprintf(keep[count++], sizeof keep[0], "%s", name_of(dead, 3, false));
        scratch_write(keep[count - 1], "keep", 4);
        assert_int_equal(chown(keep[count - 1], 12345, 12345), 0);
    }
    write_text(scratch_path("swept"), "x");
    for (int i = 0; i < count; i++) {
        assert_holds(keep[i], "keep");
        assert_int_equal(unlink(keep[i]), 0);
    }
}

static void a_device_stays_a_device(void **state)
{
    (void)state;
    struct stat before, after;
    assert_int_equal(stat("/dev/null", &before), 0);
    write_text("/dev/null", "swallowed");
    assert_int_equal(stat("/dev/null", &after), 0);
    assert_true(S_ISCHR(after.st_mode));
    assert_int_equal(after.st_mode, before.st_mode);
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
    assert_non_null(strstr(err.text, "in 5 s"));
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
    for (int i = 0; i < 200000; i++)
        fputc('a' + i % 26, glint_new_file_stream(file));
    assert_int_equal(glint_new_file_commit(file, &err), GLINT_OK);
    assert_int_equal(child_wait(child, 20.0), 0);
    size_t count;
    char *got = scratch_read(copy, &count);
    assert_int_equal(count, 200000);
    for (int i = 0; i < 200000; i++)
        assert_int_equal(got[i], 'a' + i % 26);
    free(got);
}

/* Abandoned while the pipe is full and data is still in the stream: it must not wait for a
 * reader. */
static void be_given_up(const char *path)
{
    static const char filler[4096];
    glint_error err;
    glint_new_file *file;
    const int reader = open(path, O_RDONLY | O_NONBLOCK);
    const int writer = open(path, O_WRONLY | O_NONBLOCK);
    while (write(writer, filler, sizeof filler) > 0) {
    }
    if (reader >= 0 && glint_new_file_open(path, &file, &err) == GLINT_OK) {
        fputs("what is left", glint_new_file_stream(file));
        glint_new_file_discard(file);
        _exit(0);
    }
    _exit(1);
}

static void a_full_pipe_keeps_nobody_who_gives_up(void **state)
{
    (void)state;
    int status;
    assert_int_equal(mkfifo(scratch_path("full"), 0666), 0);
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        alarm((unsigned)child_patience); /* which ends it */
        be_given_up(scratch_path("full"));
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
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
        cmocka_unit_test(a_link_that_leads_nowhere_makes_what_it_names),
        cmocka_unit_test(a_link_that_cannot_be_followed_is_refused),
        cmocka_unit_test(a_killed_process_leaves_nothing),
        cmocka_unit_test(what_the_dead_have_left_is_cleared),
        cmocka_unit_test(without_unnamed_files_a_name_is_left_and_cleared),
        cmocka_unit_test(what_may_be_someone_elses_stays),
        cmocka_unit_test(a_device_stays_a_device),
        cmocka_unit_test(a_full_disk_is_reported),
        cmocka_unit_test(a_pipe_that_nobody_reads_is_refused),
        cmocka_unit_test(waiting_for_a_reader_can_be_stopped),
        cmocka_unit_test(a_pipe_is_written_to),
        cmocka_unit_test(a_full_pipe_keeps_nobody_who_gives_up),
        cmocka_unit_test(what_cannot_be_written_is_refused),
        cmocka_unit_test(check_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
