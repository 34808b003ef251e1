/* Where pictures and other files go: one rule for every command. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "run.h"

#include "../child.h"
#include "../terminal.h"

#define PNG_BEGINS "\x89PNG\r\n\x1a\n"

static char in[512]; /* the scratch directory, for command lines */

/* Every command that writes a picture under a name of the user's; %s: the name. */
static const char *const writers[] = {
    "render --model quad --size 16x12 --out %s%s%s",
    "compare tests/fuzz/corpus/png/rgba.png tests/fuzz/corpus/png/rgba.png --diff %s%s%s",
};
static const char *const options[] = {"--out", "--diff"};
static const char *const names[] = {"render", "compare"};
#define WRITERS 2

static outcome write_to(size_t writer, const char *directory, const char *name, const char *more)
{
    char line[2048];
    /* The format is one of those above. */
    const char *at = strstr(writers[writer], "%s%s%s");
    (void)snprintf(line, sizeof line, "%.*s%s%s%s", (int)(at - writers[writer]), writers[writer],
                   directory, name, more);
    return run(line, "");
}

static bool is_png(const char *path)
{
    size_t count;
    char *bytes = scratch_read(path, &count);
    const bool is = count > 8 && memcmp(bytes, PNG_BEGINS, 8) == 0;
    free(bytes);
    return is;
}

static void assert_text(const char *path, const char *text)
{
    char *found = scratch_read(path, NULL);
    assert_string_equal(found, text);
    free(found);
}

static void another_kind_of_file_is_not_overwritten(void **state)
{
    (void)state;
    for (size_t i = 0; i < WRITERS; i++) {
        char expected[1200];
        scratch_write(scratch_path("notes.png"), "notes", 5);
        (void)snprintf(expected, sizeof expected,
                       "glint %s: %s: %s/notes.png exists and is not a PNG picture: use another "
                       "name or --force\n",
                       names[i], options[i], scratch_directory);
        outcome done = write_to(i, in, "notes.png", "");
        assert_outcome(&done, 2, expected);
        assert_string_equal(done.out, "");
        assert_text(scratch_path("notes.png"), "notes");
        forget(&done);
        done = write_to(i, in, "notes.png", " --force");
        assert_outcome(&done, 0, "");
        assert_true(is_png(scratch_path("notes.png")));
        forget(&done);
        done = write_to(i, in, "notes.png", ""); /* a PNG may be */
        assert_outcome(&done, 0, "");
        forget(&done);
    }
}

/* Also the pictures that --backend both may have to write: all are checked in time. */
static void what_a_difference_would_overwrite_is_refused_before(void **state)
{
    (void)state;
    static const char *const others[] = {"both-c.png", "both-diff.png"};
    for (size_t i = 0; i < 2; i++) {
        char line[1200];
        scratch_write(scratch_path(others[i]), "notes", 5);
        (void)snprintf(line, sizeof line, "render --model quad --backend both --out %sboth.png",
                       in);
        outcome done = run(line, "");
        assert_outcome(&done, 2, NULL);
        assert_says(done.err, others[i]);
        assert_int_equal(access(scratch_path("both.png"), F_OK), -1);
        assert_int_equal(unlink(scratch_path(others[i])), 0);
        forget(&done);
    }
}

static void a_picture_is_named_png(void **state)
{
    (void)state;
    static const char *const wrong[] = {"a", "a.jpg", "a.pn", "README.md", "png", "a.png.txt"};
    for (size_t i = 0; i < WRITERS; i++) {
        for (size_t k = 0; k < sizeof wrong / sizeof wrong[0]; k++) {
            outcome done = write_to(i, in, wrong[k], " --force");
            assert_outcome(&done, 2, NULL);
            assert_says(done.err, ": pictures are written as PNG: use a name ending in .png\n");
            assert_int_equal(access(scratch_path(wrong[k]), F_OK), -1);
            forget(&done);
        }
        outcome done = write_to(i, in, "capital.PNG", "");
        assert_outcome(&done, 0, "");
        assert_true(is_png(scratch_path("capital.PNG")));
        forget(&done);
        done = write_to(i, "/dev/", "null", ""); /* no file: nothing to be named */
        assert_outcome(&done, 0, "");
        forget(&done);
    }
}

static void a_dash_is_standard_output(void **state)
{
    (void)state;
    for (size_t i = 0; i < WRITERS; i++) {
        outcome done = write_to(i, "-", "", "");
        assert_int_equal(done.status, 0);
        assert_true(is_png(scratch_path("stdout")));
        assert_true(strstr(done.err, "pixels") != NULL || strstr(done.err, "fragments") != NULL);
        assert_int_equal(access("-", F_OK), -1);
        forget(&done);
        done = write_to(i, "-", "", " --json");
        assert_outcome(&done, 2, NULL);
        assert_says(done.err, "both write to standard output\n");
        forget(&done);
    }
    outcome done = run("render --backend both --out -", "");
    assert_outcome(&done, 2, NULL);
    assert_string_equal(done.out, "");
    forget(&done);
}

static void a_terminal_is_shown_no_picture(void **state)
{
    (void)state;
    for (size_t i = 0; i < WRITERS; i++) {
        terminal screen = terminal_open();
        const plumbing shown = {.out = screen.name};
        char line[1024];
        const char *at = strstr(writers[i], "%s%s%s");
        (void)snprintf(line, sizeof line, "%.*s-", (int)(at - writers[i]), writers[i]);
        outcome done = run_plumbed(line, "", &shown);
        assert_outcome(&done, 2, NULL);
        assert_says(done.err, "is a terminal, which cannot show a picture: redirect it\n");
        forget(&done);
        terminal_close(&screen);
    }
}

static void links_are_followed(void **state)
{
    (void)state;
    struct stat info;
    assert_int_equal(symlink("made.png", scratch_path("link.png")), 0);
    assert_int_equal(symlink("missing/made.png", scratch_path("broken.png")), 0);
    for (size_t i = 0; i < WRITERS; i++) {
        (void)unlink(scratch_path("made.png"));
        for (int k = 0; k < 2; k++) { /* to nothing, then to a picture */
            outcome done = write_to(i, in, "link.png", "");
            assert_outcome(&done, 0, "");
            assert_true(is_png(scratch_path("made.png")));
            assert_int_equal(lstat(scratch_path("link.png"), &info), 0);
            assert_true(S_ISLNK(info.st_mode));
            forget(&done);
        }
        outcome done = write_to(i, in, "broken.png", "");
        assert_outcome(&done, 2, NULL);
        assert_says(done.err, "broken.png: No such file or directory\n");
        forget(&done);
        scratch_write(scratch_path("made.png"), "notes", 5); /* what it leads to counts */
        done = write_to(i, in, "link.png", "");
        assert_outcome(&done, 2, NULL);
        assert_text(scratch_path("made.png"), "notes");
        forget(&done);
    }
}

/* Into a directory: names are the command's, what lies there under them may not be. */
static void directories_lose_nothing_of_another_kind(void **state)
{
    (void)state;
    static const struct {
        const char *line, *file;
    } commands[] = {
        {"study --model quad --size 20x20 --n 10 --frames 0", "sheet.png"},
        {"study --model quad --size 20x20 --n 10 --frames 0", "n-0010.png"},
        {"study --model quad --size 20x20 --n 10 --frames 0", "study.csv"},
        {"study --model quad --size 20x20 --n 10 --frames 0", "study.json"},
        {"wave --circuit specular --pipeline combinational", "specular_cosine_combinational.fst"},
        {"wave --circuit specular --pipeline combinational", "specular_cosine_combinational.gtkw"},
        {"wave --circuit specular --pipeline combinational --format vcd",
         "specular_cosine_combinational.vcd"},
        {"energy --model blinn --n 1 --angle 0", "albedo-blinn.csv"},
        {"energy --model blinn --n 1 --angle 0 --furnace --width 8", "furnace.png"},
        {"report --quick", "index.html"},
        {"report --quick", "index.md"},
        {"report --quick", "index.json"},
    };
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        char line[2048], path[1024];
        const bool long_work = strncmp(commands[i].line, "report", 6) == 0;
        (void)snprintf(path, sizeof path, "%s/kept", scratch_directory);
        assert_true(mkdir(path, 0777) == 0 || errno == EEXIST);
        (void)snprintf(path, sizeof path, "%s/kept/%s", scratch_directory, commands[i].file);
        (void)snprintf(line, sizeof line, "%s --out %s/kept", commands[i].line, scratch_directory);
        scratch_write(path, "x notes", 7);
        outcome done = run(line, "");
        assert_outcome(&done, 2, NULL);
        assert_says(done.err, path);
        assert_says(done.err, "or --force\n");
        assert_text(path, "x notes");
        forget(&done);
        if (!long_work) {
            strcat(line, " --force");
            done = run(line, "");
            assert_outcome(&done, 0, "");
            forget(&done);
        }
        assert_int_equal(unlink(path), 0);
    }
}

/* Other pages start like a report; a report has its numbers next to it. */
static void a_page_of_no_report_is_kept(void **state)
{
    (void)state;
    char line[1024];
    assert_int_equal(mkdir(scratch_path("site"), 0777), 0);
    scratch_write(scratch_path("site/index.html"), "<!DOCTYPE html>", 15);
    (void)snprintf(line, sizeof line, "report --quick --out %ssite", in);
    outcome done = run(line, "");
    assert_outcome(&done, 2, NULL);
    assert_says(done.err, "index.html exists but is not from a report");
    assert_text(scratch_path("site/index.html"), "<!DOCTYPE html>");
    forget(&done);
}

static int set_up(void **state)
{
    const int failed = scratch_make(state);
    (void)snprintf(in, sizeof in, "%.500s/", scratch_directory);
    return failed;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(another_kind_of_file_is_not_overwritten),
        cmocka_unit_test(what_a_difference_would_overwrite_is_refused_before),
        cmocka_unit_test(a_picture_is_named_png),
        cmocka_unit_test(a_dash_is_standard_output),
        cmocka_unit_test(a_terminal_is_shown_no_picture),
        cmocka_unit_test(links_are_followed),
        cmocka_unit_test(directories_lose_nothing_of_another_kind),
        cmocka_unit_test(a_page_of_no_report_is_kept),
    };
    return cmocka_run_group_tests(tests, set_up, scratch_remove);
}
