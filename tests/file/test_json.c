/* JSON as text: UTF-8, whatever the strings were. */
#define _XOPEN_SOURCE 700

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "file/json.h"

#define U "\xef\xbf\xbd" /* U+FFFD */

static void assert_text(const char *string, const char *expected)
{
    char quoted[256] = "\"";
    json_t *json = glint_json_text_of(string);
    char *text = glint_json_text(json);
    strcat(strcat(quoted, expected), "\"");
    assert_non_null(text);
    assert_string_equal(text, quoted);
    free(text);
    json_decref(json);
}

static void utf_8_stays(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "",
        "plain ~ text",
        "\xd1\x87\xd0\xb0\xd0\xb9\xd0\xbd\xd0\xb8\xd0\xba",    /* two bytes each */
        "\xe0\xa0\x80 \xed\x9f\xbf \xee\x80\x80 \xef\xbf\xbd", /* U+0800, U+D7FF, U+E000, U+FFFD */
        "\xf0\x90\x80\x80 \xf4\x8f\xbf\xbf",                   /* U+10000, U+10FFFF */
    };
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++)
        assert_text(texts[i], texts[i]);
}

static void other_bytes_are_replaced(void **state)
{
    (void)state;
    assert_text("a\xff"
                "b",
                "a" U "b");
    assert_text("\x80\xbf", U U);                  /* nothing that they go on */
    assert_text("\xc0\xaf \xc1\x81", U U " " U U); /* overlong */
    assert_text("\xe0\x9f\xbf", U U U);
    assert_text("\xf0\x8f\xbf\xbf", U U U U);
    assert_text("\xed\xa0\x80", U U U);       /* a surrogate */
    assert_text("\xf4\x90\x80\x80", U U U U); /* beyond U+10FFFF */
    assert_text("\xf5\xfe", U U);
    assert_text("\xd1", U); /* cut short */
    assert_text("\xe2\x82", U U);
    assert_text("\xe2\x82x", U U "x");
    assert_text("\xf0\x9f\x98", U U U);
}

static void what_json_quotes_is_quoted(void **state)
{
    (void)state;
    assert_text("a\"b\\\n", "a\\\"b\\\\\\n");
}

static void assert_number(double number, const char *expected)
{
    json_t *json = glint_json_number_of(number);
    char *text = glint_json_text(json);
    assert_non_null(text);
    assert_string_equal(text, expected);
    free(text);
    json_decref(json);
}

/* The fewest digits that read back as the same double; a whole number without a point. */
static void numbers_are_exact_and_short(void **state)
{
    (void)state;
    assert_number(0.0, "0");
    assert_number(-5.0, "-5");
    assert_number(26976780288.0, "26976780288");
    assert_number(9007199254740992.0, "9007199254740992");
    assert_number(0.1, "0.1");
    assert_number(0.1 + 0.2, "0.30000000000000004");
    assert_number(1e300, "1e+300");
    assert_number(1.0 / 3.0, "0.3333333333333333");
    assert_number((double)INFINITY, "null");
    assert_number((double)NAN, "null");
}

static void members_stand_on_lines_and_lists_on_one(void **state)
{
    (void)state;
    const double numbers[] = {1, 2.5};
    json_t *json = json_object();
    glint_json_add_text(json, "name", "a");
    json_object_set_new(json, "list", glint_json_numbers_of(numbers, 2));
    glint_json_add_number(glint_json_add(json, "below", json_object()), "x", 1);
    json_object_set_new(json, "yes", json_true());
    json_object_set_new(json, "none", json_array());
    char *text = glint_json_text(json);
    assert_string_equal(text, "{\n\t\"name\":\t\"a\",\n\t\"list\":\t[1, 2.5],\n\t\"below\":\t{\n"
                              "\t\t\"x\":\t1\n\t},\n\t\"yes\":\ttrue,\n\t\"none\":\t[]\n}");
    free(text);
    json_decref(json);
}

static void nothing_is_no_text(void **state)
{
    (void)state;
    assert_null(glint_json_text(NULL));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(utf_8_stays),
        cmocka_unit_test(other_bytes_are_replaced),
        cmocka_unit_test(what_json_quotes_is_quoted),
        cmocka_unit_test(numbers_are_exact_and_short),
        cmocka_unit_test(members_stand_on_lines_and_lists_on_one),
        cmocka_unit_test(nothing_is_no_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
