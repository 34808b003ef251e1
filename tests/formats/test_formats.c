/* "The cosine with 20 fraction bits" is one edit: copies of the tree with one number changed in
 * cmodel/glint_formats.h build and are correct (tests/formats/try.sh). An impossible number is
 * rejected with a line that says what to do. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"

#define WORKED                                                                                     \
    600.0 /* seconds: what the script starts does not count, only the clock on the wall */

static const char *build(void)
{
    const char *given = getenv("GLINT_BUILD");
    return given != NULL ? given : "build";
}

/* Runs the script with a number for a name, below the build's directory; returns its exit status.
 * What it said is in *said, to be freed. A port of more than 64 bits; the integer digits of a W
 * above 1. */
static int try(const char *name, const char *value, char **said)
{
    char directory[1024], keep[1024];
    (void)snprintf(directory, sizeof directory, "%s/formats/test-%s-%s", build(), name, value);
    char *base = realpath(build(), NULL);
    assert_non_null(base);
    (void)snprintf(keep, sizeof keep, "GLINT_CACHE=%s/circuits", base);
    free(base);
    const char *const argv[] = {"env", keep,  "tests/formats/try.sh", directory,
                                name,  value, "cosine-pipelined-4",   "drawn-pipelined-1",
                                NULL};
    const int status = child_run(argv, WORKED);
    *said = scratch_read(scratch_path("child.out"), NULL);
    return status;
}

/* The lines of the counts, each with more than nothing compared and nothing different. */
static void assert_compared(const char *said)
{
    static const char *const compared[] = {
        "batch = blocks: ", "blocks = formula: ",
        "C = Verilog, gate cosine, pipeline pipelined, lanes 4: ",
        "C = Verilog, gate drawn, pipeline pipelined, lanes 1: "};
    for (size_t i = 0; i < sizeof compared / sizeof compared[0]; i++) {
        const char *line = strstr(said, compared[i]);
        assert_non_null(line);
        assert_true(strtoull(line + strlen(compared[i]), NULL, 10) >= 20000);
    }
}

static void assert_right(const char *name, const char *value)
{
    char *said;
    const int status = try(name, value, &said);
    print_message("%s %s\n%s", name, value, said);
    assert_int_equal(status, 0);
    assert_compared(said);
    free(said);
}

static void sixteen_bits(void **state)
{
    (void)state;
    assert_right("GLINT_COS_FRAC_BITS", "16");
}

static void seventeen_bits(void **state)
{
    (void)state;
    assert_right("GLINT_COS_FRAC_BITS", "17");
}

static void nineteen_bits(void **state)
{
    (void)state;
    assert_right("GLINT_COS_FRAC_BITS", "19");
}

static void twenty_bits(void **state)
{
    (void)state;
    assert_right("GLINT_COS_FRAC_BITS", "20");
}

static void what_cannot_be_is_said(void **state)
{
    (void)state;
    char *said;
    assert_int_equal(try("GLINT_COS_FRAC_BITS", "21", &said), 1);
    assert_non_null(strstr(said, "GLINT_COS_FRAC_BITS must be 10 to 20"));
    free(said);
    assert_int_equal(try("GLINT_COS_BITS", "20", &said), 2);
    free(said);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sixteen_bits),           cmocka_unit_test(seventeen_bits),
        cmocka_unit_test(nineteen_bits),          cmocka_unit_test(twenty_bits),
        cmocka_unit_test(what_cannot_be_is_said),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
