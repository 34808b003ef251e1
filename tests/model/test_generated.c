/* The generated files that are committed are what the generator writes today. Which they are is
 * read from the Makefile, so one that is added there is looked at here. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../golden.h"
#include "../scratch.h"

#include "../child.h"

enum { FILES_MAX = 32 };

/* "rtl/sigma_rom.v:sigma-rom" in the Makefile. */
typedef struct generated {
    char *path, *kind;
} generated;

static char *makefile;
static generated files[FILES_MAX];
static int file_count;

/* The words of "GENERATED := …", over lines that end with a backslash. */
static int read_makefile(void **state)
{
    if (scratch_make(state) != 0)
        return -1;
    makefile = scratch_read("Makefile", NULL);
    char *list = strstr(makefile, "\nGENERATED := ");
    if (list == NULL)
        return -1;
    list += strlen("\nGENERATED := ");
    char *end = list;
    for (; *end != '\0' && *end != '\n'; end++)
        if (end[0] == '\\' && end[1] == '\n')
            end[0] = end[1] = ' ';
    *end = '\0';
    for (char *word = strtok(list, " "); word != NULL; word = strtok(NULL, " ")) {
        char *colon = strchr(word, ':');
        if (colon == NULL || file_count == FILES_MAX)
            return -1;
        *colon = '\0';
        files[file_count++] = (generated){word, colon + 1};
    }
    return 0;
}

static int forget_makefile(void **state)
{
    free(makefile);
    return scratch_remove(state);
}

static const char *generator(void)
{
    static char path[1024];
    const char *build = getenv("GLINT_BUILD");
    snprintf(path, sizeof path, "%s/glint-gen", build != NULL ? build : "build");
    return path;
}

static int generate(const char *path, const char *kind)
{
    const char *const argv[] = {generator(), path, kind, NULL};
    return child_run(argv, 60);
}

/* The line in which two texts first differ; 0: nowhere. */
static int first_different_line(const char *a, const char *b)
{
    int line = 1;
    for (; *a == *b; a++, b++) {
        if (*a == '\0')
            return 0;
        line += *a == '\n';
    }
    return line;
}

static void committed_files_are_what_the_generator_writes(void **state)
{
    (void)state;
    print_message("%d files\n", file_count);
    assert_true(file_count >= 4);
    for (int i = 0; i < file_count; i++) {
        assert_int_equal(generate(scratch_path("fresh"), files[i].kind), 0);
        char *fresh = scratch_read(scratch_path("fresh"), NULL);
        char *committed = scratch_read(files[i].path, NULL);
        const int line = first_different_line(committed, fresh);
        assert_true(strlen(fresh) > 100);
        assert_non_null(strstr(fresh, "Made by glint-gen"));
        if (line != 0) {
            fail_msg("%s, line %d: not what cmodel/ says; run `make generate` and commit it",
                     files[i].path, line);
        }
        free(fresh);
        free(committed);
    }
}

/* Whatever else the Makefile lists: these are among them. */
static void every_generated_file_is_looked_at(void **state)
{
    (void)state;
    static const char *const paths[] = {"rtl/glint_formats.vh", "rtl/sigma_rom.v",
                                        "rtl/limit_rom.v", "rtl/reciprocal_rom.v"};
    for (size_t p = 0; p < sizeof paths / sizeof paths[0]; p++) {
        bool listed = false;
        for (int i = 0; i < file_count; i++)
            listed |= strcmp(files[i].path, paths[p]) == 0;
        if (!listed)
            fail_msg("%s is not listed", paths[p]);
    }
}

static void a_stale_file_would_be_seen(void **state)
{
    (void)state;
    assert_int_equal(first_different_line("a\nb\n", "a\nb\n"), 0);
    assert_int_equal(first_different_line("a\nb\n", "a\nc\n"), 2);
    assert_int_equal(first_different_line("a\nb\n", "a\nb\nc"), 3);
    assert_int_equal(first_different_line("", "a"), 1);
}

/* Every width and limit the Verilog works with, as a number, in the header. */
static void the_header_holds_the_formats(void **state)
{
    (void)state;
    golden();
    static const char *const lines[] = {
        "`define GLINT_COS_BITS 19\n",      "`define GLINT_N_BITS 10\n",
        "`define GLINT_SIGMA_BITS 22\n",    "`define GLINT_T_BITS 28\n",
        "`define GLINT_W_BITS 19\n",        "`define GLINT_DRAWN_LIMIT 19'd514\n",
        "`define GLINT_DIVIDER_K_MAX 16\n", "`define GLINT_DIVIDER_DIFFERENCE_BITS 9\n",
    };
    assert_int_equal(generate(scratch_path("formats"), "formats"), 0);
    char *text = scratch_read(scratch_path("formats"), NULL);
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++)
        if (strstr(text, lines[i]) == NULL)
            fail_msg("missing: %s", lines[i]);
    free(text);
}

static void the_generator_refuses_what_it_does_not_know(void **state)
{
    (void)state;
    const char *const too_few[] = {generator(), scratch_path("none"), NULL};
    assert_int_equal(generate(scratch_path("none"), "sigma"), 2);
    assert_int_equal(child_run(too_few, 60), 2);
    char *said = scratch_read(scratch_path("child.err"), NULL);
    assert_non_null(strstr(said, "usage: glint-gen FILE"));
    free(said);
    assert_int_equal(access(scratch_path("none"), F_OK), -1);
}

static void the_generator_says_when_it_cannot_write(void **state)
{
    (void)state;
    assert_int_equal(generate(scratch_path("missing/file"), "formats"), 2);
    char *said = scratch_read(scratch_path("child.err"), NULL);
    assert_non_null(strstr(said, "missing/file: No such file or directory"));
    free(said);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(committed_files_are_what_the_generator_writes),
        cmocka_unit_test(every_generated_file_is_looked_at),
        cmocka_unit_test(a_stale_file_would_be_seen),
        cmocka_unit_test(the_header_holds_the_formats),
        cmocka_unit_test(the_generator_refuses_what_it_does_not_know),
        cmocka_unit_test(the_generator_says_when_it_cannot_write),
    };
    return cmocka_run_group_tests(tests, read_makefile, forget_makefile);
}
