/* Names in the report's text, and what is put for them. */
#define _XOPEN_SOURCE 700

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "report/template.h"

static glint_numbers numbers;

static int put_numbers(void **state)
{
    (void)state;
    glint_number_put(&numbers, 0.10309, "lobes.%s.relative", "schlick");
    glint_number_put(&numbers, 268436480.0, "count");
    glint_number_put_range(&numbers, 0.125, 0.5, "range");
    glint_number_put_range(&numbers, 0.501, 0.502, "narrow");
    glint_number_put(&numbers, NAN, "nothing");
    glint_number_put_text(&numbers, "one two", "list");
    glint_number_put(&numbers, 1.0, "of.one");
    glint_number_put(&numbers, 2.0, "of.two");
    return numbers.incomplete ? -1 : 0;
}

static int clear_numbers(void **state)
{
    (void)state;
    glint_numbers_clear(&numbers);
    return 0;
}

static void expect(const char *line, const char *expected)
{
    const glint_template how = {.numbers = &numbers};
    char text[256];
    glint_error err;
    if (glint_template_line(&how, line, text, sizeof text, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    assert_string_equal(text, expected);
}

static void numbers_are_printed_as_asked(void **state)
{
    (void)state;
    expect("no name", "no name");
    expect("{lobes.schlick.relative:.2f}, {lobes.schlick.relative:.2%}.", "0.10, 10.31 %.");
    expect("{count} {count:.3g} {count:.1e}", "268436480 2.68e+08 2.7e+08");
    expect("{nothing} {nothing:.1%} {list}", "– – one two");
    expect("{list:,}", "one, two");
    expect("an open { brace", "an open { brace");
}

static void a_range_has_both_ends(void **state)
{
    (void)state;
    expect("{range}", "0.125 to 0.5");
    expect("{range:.1%}", "12.5 to 50.0 %");
    expect("{narrow:.2f}", "0.50"); /* alike as printed */
}

static void a_line_is_repeated_for_a_list(void **state)
{
    (void)state;
    expect("{each list}| $ | {of.$:.1f} |", "| one | 1.0 |\n| two | 2.0 |");
}

static void refuse(const char *line, const char *expected)
{
    const glint_template how = {.numbers = &numbers};
    char text[256];
    glint_error err;
    assert_int_equal(glint_template_line(&how, line, text, sizeof text, &err), GLINT_BAD_ARGUMENT);
    assert_string_equal(err.text, expected);
}

static void what_nothing_measured_is_refused(void **state)
{
    (void)state;
    refuse("{absent}", "the report's text has {absent}: nothing measured that");
    refuse("{count:.3q}", "the report's text has {count:.3q}: nothing measured that");
    refuse("{each list}{of.$.more}", "the report's text has {of.one.more}: nothing measured that");
    refuse("{each absent}$", "the report's text repeats {absent}: no such list");
}

static glint_status word(void *context, const char *name, const char *rest, FILE *out,
                         glint_error *err)
{
    (void)err;
    fprintf(out, "<%s|%s|%s>", (const char *)context, name, rest);
    return GLINT_OK;
}

static void another_word_takes_the_rest_of_its_line(void **state)
{
    (void)state;
    static const char *const lines[] = {"{figure a}its caption {count}", "{count}", NULL};
    char context[] = "here", *text = NULL;
    size_t size;
    glint_error err;
    const glint_template how = {&numbers, word, context};
    FILE *out = open_memstream(&text, &size);
    assert_non_null(out);
    assert_int_equal(glint_template_write(&how, lines, out, &err), GLINT_OK);
    fclose(out);
    assert_string_equal(text, "<here|figure a|its caption {count}>\n268436480\n");
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_printed_as_asked),
        cmocka_unit_test(a_range_has_both_ends),
        cmocka_unit_test(a_line_is_repeated_for_a_list),
        cmocka_unit_test(what_nothing_measured_is_refused),
        cmocka_unit_test(another_word_takes_the_rest_of_its_line),
    };
    return cmocka_run_group_tests(tests, put_numbers, clear_numbers);
}
