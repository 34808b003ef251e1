/* The notes of what was verified, and the table made of them. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include <sys/wait.h>

#define BEGIN "<!-- verification table: begin -->\n"
#define END   "<!-- verification table: end -->\n"

/* A line for the shell, with $D the test's directory; its exit status. Errors go to "err". */
static int shell(const char *line)
{
    char command[2048];
    snprintf(command, sizeof command, "D='%s'; { %s; } 2>'%s'", scratch_directory, line,
             scratch_path("err"));
    const int status = system(command);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static int record(const char *fields)
{
    char line[1024];
    snprintf(line, sizeof line, "GLINT_RECORDS=\"$D/records\" tests/verification/record.sh %s",
             fields);
    return shell(line);
}

static void assert_error_has(const char *expected)
{
    char *text = scratch_read(scratch_path("err"), NULL);
    if (strstr(text, expected) == NULL)
        fail_msg("\"%s\" is not in \"%s\"", expected, text);
    free(text);
}

static void write_document(const char *text)
{
    scratch_write(scratch_path("document"), text, strlen(text));
}

static void notes_become_the_table(void **state)
{
    (void)state;
    assert_int_equal(record("rtl-b_1 'first row' exhaustion 268436480 points 0 4.25 'make b'"), 0);
    assert_int_equal(record("model-a 'second row' SAT 7 proofs 1 130.9 'make old'"), 0);
    assert_int_equal(record("model-a 'second row, |D|' SAT 7 proofs 0 130.9 'make a'"), 0);
    write_document("before\n" BEGIN "what was there\n" END "after\n");
    assert_int_equal(shell("tests/verification/table.sh \"$D/records\" \"$D/document\""), 0);
    char *text = scratch_read(scratch_path("document"), NULL);
    assert_ptr_equal(strstr(text, "before\n" BEGIN "From the last run of each check; written on "),
                     text);
    const char *first =
        strstr(text, "| first row | exhaustion | 268 436 480 points | 0 | 4.2 s | `make b` |\n");
    assert_non_null(first);
    const char *rest = strchr(first, '\n') + 1;
    assert_string_equal(rest,
                        "| second row, \\|D\\| | SAT | 7 proofs | 0 | 2 min 10 s | `make a` |\n" END
                        "after\n");
    assert_null(strstr(text, "what was there"));
    free(text);
}

static void a_check_over_nothing_is_no_check(void **state)
{
    (void)state;
    assert_int_equal(record("rtl-c what how 0 points 0 1 again"), 2);
    assert_error_has("CASES \"0\"");
    assert_int_equal(record("rtl-c what how '' points 0 1 again"), 2);
    assert_int_equal(record("rtl-c what how 5 points -1 1 again"), 2);
    assert_int_equal(record("rtl-c what how 5 points 0 1"), 2);
    assert_int_equal(record("'rtl c' what how 5 points 0 1 again"), 2);
    assert_int_equal(record("other what how 5 points 0 1 again"), 2);
    assert_error_has("no kind of check");
    assert_int_equal(shell("[ ! -e \"$D/records/rtl-c.tsv\" ]"), 0);
}

static void nothing_is_noted_unless_asked_for(void **state)
{
    (void)state;
    assert_int_equal(
        shell("unset GLINT_RECORDS; HERE=$PWD; cd \"$D\" && "
              "\"$HERE\"/tests/verification/record.sh rtl-d what how 5 points 0 1 again"),
        0);
    assert_int_equal(shell("[ ! -e \"$D\"/rtl-d.tsv ]"), 0);
}

static void a_document_without_its_place_stays_as_it_is(void **state)
{
    (void)state;
    assert_int_equal(record("rtl-e what how 5 points 0 1 again"), 0);
    write_document("text\n" BEGIN "text\n");
    assert_int_equal(shell("tests/verification/table.sh \"$D/records\" \"$D/document\""), 2);
    assert_error_has("verification table: end");
    write_document(BEGIN "old\n" END);
    assert_int_equal(shell("tests/verification/table.sh \"$D/nowhere\" \"$D/document\""), 2);
    assert_error_has("no notes in");
    char *text = scratch_read(scratch_path("document"), NULL);
    assert_string_equal(text, BEGIN "old\n" END);
    free(text);
}

/* What `make verification` takes from a command is the outermost object's, not a part's. */
static void a_command_is_noted_by_its_json(void **state)
{
    (void)state;
    static const char json[] = "#!/bin/sh\nprintf '{\\n\\t\"mismatches\":\\t%s,\\n"
                               "\\t\"comparisons\":\\t90,\\n\\t\"seconds\":\\t1.5,\\n\\t\"parts\":"
                               "\\t[{\\n\\t\\t\\t\"mismatches\":\\t8\\n\\t\\t}]\\n}\\n' \"$1\"\n"
                               "[ \"$1\" = 0 ]\n";
    scratch_write(scratch_path("command"), json, sizeof json - 1);
    assert_int_equal(shell("chmod +x \"$D/command\""), 0);
    const char *run = "GLINT_RECORDS=\"$D/records\" tests/verification/command.sh rtl-f what how "
                      "\"$D/command\" %d >\"$D/out\"";
    char line[512];
    for (int mismatches = 0; mismatches <= 3; mismatches += 3) {
        snprintf(line, sizeof line, run, mismatches);
        assert_int_equal(shell(line), mismatches != 0);
        char expected[1024];
        snprintf(expected, sizeof expected, "what\thow\t90\tcomparisons\t%d\t1.5\t%s/command %d\n",
                 mismatches, scratch_directory, mismatches);
        char *note = scratch_read(scratch_path("records/rtl-f.tsv"), NULL);
        assert_string_equal(note, expected);
        free(note);
    }
}

static int forget(void **state)
{
    (void)state;
    return shell("rm -rf \"$D/records\"");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(notes_become_the_table, forget),
        cmocka_unit_test_teardown(a_check_over_nothing_is_no_check, forget),
        cmocka_unit_test_teardown(nothing_is_noted_unless_asked_for, forget),
        cmocka_unit_test_teardown(a_document_without_its_place_stays_as_it_is, forget),
        cmocka_unit_test_teardown(a_command_is_noted_by_its_json, forget),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
