/* Unwritable output: a full disk, directories that are not directories or are inaccessible,
 * standard streams that are closed, full or broken. Every file under its final name must be
 * complete afterwards. */
#define _GNU_SOURCE

#include <errno.h>
#include <sched.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/mount.h>

#include <cmocka.h>

#include "../scratch.h"
#include "abuse.h"

#define PNG "tests/fuzz/corpus/png/rgba.png"

/* Every command that writes files; %s: the directory they go to. */
typedef struct writer {
    const char *line;
    bool wrong; /* with the wrong circuit, which leaves packets */
    int status; /* when everything can be written */
    int failed; /* if nothing can be written: 1 if a mismatch is found, with or without its
                 * packet */
} writer;

static const writer writers[] = {
    {"render --size 200x150 --out %s/a.png", false, 0, 2},
    {"render --size 200x150 --backend both --out %s/a.png", false, 0, 2},
    {"render --size 200x150 --backend both --lanes 1 --out %s/a.png", true, 1, 2},
    {"compare " PNG " " PNG " --diff %s/d.png", false, 0, 2},
    {"wave --out %s", false, 0, 2},
    {"wave --format vcd --out %s", false, 0, 2},
    {"verify --clocks 1000 --seed 1 --circuit specular --lanes 1 --gate cosine --out %s/p", true, 1,
     1},
    {"verify --exhaustive --lanes 1 --from 50 --stride 4096 --shard 51/1000 --out %s/p", true, 1,
     1},
    {"study --size 60x40 --n 10 --frames 0 --out %s", false, 0, 2},
    {"report --chapter divider --out %s", false, 0, 2},
};
#define WRITERS (sizeof writers / sizeof writers[0])
#define REPORT  (WRITERS - 1)

static void line_of(const writer *w, const char *directory, char line[2048])
{
    /* The only %s is the directory. */
    const char *place = strstr(w->line, "%s");
    assert_non_null(place);
    (void)snprintf(line, 2048, "%.*s%s%s%s", (int)(place - w->line), w->line, directory, place + 2,
                   w->wrong ? abuse_wrong_circuit("truncating") : "");
}

static void keep(char copy[1024], const char *path)
{
    assert_true(strlen(path) < 1024);
    strcpy(copy, path);
}

static void empty(const char *directory)
{
    assert_int_equal(nftw(directory, scratch_remove_entry, 8, FTW_DEPTH | FTW_PHYS), 0);
    assert_int_equal(mkdir(directory, 0777), 0);
}

/* A run into a directory where not everything may fit. Whether something did not, and it said why.
 */
static bool write_fails(const char *reason, const char *heading, const writer *w,
                        const char *directory, abuse how)
{
    char line[2048];
    line_of(w, directory, line);
    outcome done = abuse_run(heading, line, &how);
    const bool failed = strstr(done.err, reason) != NULL;
    if (!w->wrong) /* that one has a report and a packet to tell of as well */
        abuse_expect_sane(&done, line);
    /* A mismatch counts where only its packet could not be written. */
    const bool fitting = failed ? done.status == w->failed || (w->wrong && done.status == w->status)
                                : done.status == w->status;
    if (!fitting || (failed && strstr(done.err, directory) == NULL))
        fail_msg("%s: exit status %d, \"%s\"", line, done.status, done.err);
    (void)abuse_expect_whole(directory, false);
    abuse_forget(&done);
    return failed;
}

/* A file size limit, which every system has, stands in for a full disk. */
static void files_may_not_grow(void **state)
{
    (void)state;
    static const long limits[] = {1, 200, 1000, 2500, 5000, 20000, 100000};
    char out[1024];
    keep(out, scratch_path("limited"));
    assert_int_equal(mkdir(out, 0777), 0);
    for (size_t i = 0; i < WRITERS; i++) {
        int failures = 0;
        for (size_t k = 0; k < sizeof limits / sizeof limits[0]; k += i == REPORT ? 7 : 1) {
            failures += write_fails("File too large", "a file size limit", &writers[i], out,
                                    (abuse){.file_limit = limits[k], .seconds = 60.0});
            empty(out);
        }
        assert_true(failures > 0); /* the smallest is too small for everyone */
    }
    abuse_all_tried();
}

/* A file system of this process's own that is really full, where that is allowed. */
static void a_full_file_system(void **state)
{
    (void)state;
    static const char *const sizes[] = {"nr_inodes=1", "size=4k", "size=40k"};
    char out[1024];
    keep(out, scratch_path("small"));
    assert_int_equal(mkdir(out, 0777), 0);
    if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", NULL, MS_REC | MS_PRIVATE, NULL) != 0) {
        print_message("no file system may be mounted here: %s\n", strerror(errno));
        abuse_all_tried();
        skip();
    }
    for (size_t i = 0; i < WRITERS; i++) {
        int failures = 0;
        for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; k += i == REPORT ? 3 : 1) {
            assert_int_equal(mount("tmpfs", out, "tmpfs", 0, sizes[k]), 0);
            failures += write_fails("No space left on device", "a full file system", &writers[i],
                                    out, (abuse){.seconds = 60.0});
            assert_int_equal(umount(out), 0);
        }
        assert_true(failures > 0); /* the first has no room for a file, the rest for some */
    }
    abuse_all_tried();
}

static void a_directory_that_is_none(void **state)
{
    (void)state;
    char below_file[1024], file[1024];
    keep(file, scratch_path("plain"));
    keep(below_file, scratch_path("plain/below"));
    scratch_write(file, "plain", 5);
    const char *const places[] = {below_file, "/proc/glint", "/dev/null/x", "/proc/sys/kernel"};
    for (size_t i = 0; i < WRITERS; i++) {
        for (size_t k = 0; k < sizeof places / sizeof places[0]; k++) {
            char line[2048];
            line_of(&writers[i], places[k], line);
            outcome done = abuse_run("a directory that cannot be written", line, &(abuse){0});
            if (done.status != writers[i].failed || strstr(done.err, places[k]) == NULL)
                fail_msg("%s: exit status %d, \"%s\"", line, done.status, done.err);
            abuse_forget(&done);
        }
    }
    abuse_all_tried();
}

/* Root can write anywhere, so run as nobody. */
static void a_directory_of_someone_else(void **state)
{
    (void)state;
    char closed[1024];
    keep(closed, scratch_path("closed"));
    assert_int_equal(mkdir(closed, 0555), 0);
    assert_int_equal(chmod(scratch_directory, 0755), 0);
    for (size_t i = 0; i < WRITERS; i++) {
        char line[2048];
        line_of(&writers[i], closed, line);
        outcome done =
            abuse_run("a directory that cannot be written", line, &(abuse){.as_nobody = true});
        if (done.status != writers[i].failed || strstr(done.err, "Permission denied") == NULL)
            fail_msg("%s: exit status %d, \"%s\"", line, done.status, done.err);
        assert_int_equal(abuse_expect_whole(closed, false), 0);
        abuse_forget(&done);
    }
    abuse_all_tried();
}

/* Every command that prints; all of them do. */
static const char *const printers[] = {
    "--help",
    "--version",
    "info",
    "info --json",
    "eval",
    "eval --json",
    "divide",
    "divide --json",
    "render --size 20x20 --out %s/a.png",
    "render --size 20x20 --json --out %s/a.png",
    "compare " PNG " " PNG,
    "compare --json " PNG " " PNG,
    "wave --out %s",
    "wave --json --out %s",
    "draw --out %s/a.svg",
    "verify --clocks 10 --out %s/p",
    "verify --clocks 10 --json --out %s/p",
    "verify --exhaustive --shard 1/1000 --stride 4096 --out %s/p",
    "energy --model blinn --n 10 --angle 0..3",
    "energy --json --model blinn --n 10 --angle 0..3",
    "models",
    "models --json",
    "models --coefficients",
    "study --size 60x40 --n 10 --frames 0 --out %s",
    "study --size 60x40 --n 10 --frames 0 --json --out %s",
    "bench --seconds 0.01",
    "report --chapter divider --out %s",
};

static void try_printer(const char *printer, const char *directory, const abuse *how, int status,
                        const char *part)
{
    char line[2048];
    const char *place = strstr(printer, "%s");
    (void)snprintf(line, sizeof line, "%.*s%s%s",
                   place != NULL ? (int)(place - printer) : (int)strlen(printer), printer,
                   place != NULL ? directory : "", place != NULL ? place + 2 : "");
    outcome done = abuse_run("standard streams", line, how);
    if (part != NULL)
        abuse_expect_failure(&done, line, status, part);
    else
        abuse_expect_sane(&done, line);
    assert_int_equal(done.status, status);
    (void)abuse_expect_whole(directory, false);
    abuse_forget(&done);
}

static void standard_output_that_is_not_taken(void **state)
{
    (void)state;
    static const abuse ways[] = {{.close_out = true}, {.out = "/dev/full"}, {.broken_out = true}};
    char out[1024];
    keep(out, scratch_path("printed"));
    assert_int_equal(mkdir(out, 0777), 0);
    for (size_t i = 0; i < sizeof printers / sizeof printers[0]; i++) {
        const bool slow = strncmp(printers[i], "bench", 5) == 0 ||
                          strncmp(printers[i], "report", 6) == 0 ||
                          strcmp(printers[i], "models --coefficients") == 0;
        for (size_t k = 0; k < (slow ? 1 : 3); k++)
            try_printer(printers[i], out, &ways[k], 2, "cannot write to standard output: ");
    }
    abuse_all_tried();
}

/* Nothing of what is said may end in a file that was opened next. */
static void other_streams_closed(void **state)
{
    (void)state;
    static const abuse ways[] = {{.close_in = true},
                                 {.close_err = true},
                                 {.close_in = true, .close_out = true, .close_err = true}};
    static const char *const commands[] = {"render --size 20x20 --out %s/b.png",
                                           "compare " PNG " " PNG " --diff %s/d.png",
                                           "wave --out %s/w", "verify --clocks 10 --out %s/p"};
    char out[1024];
    keep(out, scratch_path("streams"));
    assert_int_equal(mkdir(out, 0777), 0);
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++)
        for (size_t k = 0; k < 3; k++)
            try_printer(commands[i], out, &ways[k], k == 2 ? 2 : 0, NULL);
    abuse_all_tried();
}

/* Every command that writes to a path as it is. */
static void pipes_that_nobody_reads(void **state)
{
    (void)state;
    static const char *const commands[] = {"render --size 20x20 --out %s/unread.png",
                                           "compare " PNG " " PNG " --diff %s/unread.png"};
    char out[1024];
    keep(out, scratch_path("pipes"));
    assert_int_equal(mkdir(out, 0777), 0);
    assert_int_equal(mkfifo(scratch_path("pipes/unread.png"), 0666), 0);
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        char line[2048];
        line_of(&(writer){.line = commands[i]}, out, line);
        outcome done = abuse_run("a pipe without a reader", line, &(abuse){0});
        abuse_expect_failure(&done, line, 2,
                             "unread.png: it is a pipe, and no reader opened it within 5 s");
        abuse_forget(&done);
    }
    abuse_all_tried();
}

enum { TESTS = 7 };

/* The last: all others have been counted. */
static void the_counts_are_documented(void **state)
{
    (void)state;
    abuse_expect_documented(
        "outputs", "output that cannot be written is reported; no partial file under a final name",
        TESTS);
}

static int set_up(void **state)
{
    return scratch_make(state) != 0 ? -1 : abuse_build_circuits(scratch_directory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_may_not_grow),
        cmocka_unit_test(a_full_file_system),
        cmocka_unit_test(a_directory_that_is_none),
        cmocka_unit_test(a_directory_of_someone_else),
        cmocka_unit_test(standard_output_that_is_not_taken),
        cmocka_unit_test(other_streams_closed),
        cmocka_unit_test(pipes_that_nobody_reads),
        cmocka_unit_test(the_counts_are_documented),
    };
    _Static_assert(sizeof tests / sizeof tests[0] == TESTS + 1, "the tests before the last");
    return cmocka_run_group_tests(tests, set_up, scratch_remove);
}
