/* JSON as text: UTF-8, whatever the strings were. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "file/json_text.h"

#define U "\xef\xbf\xbd" /* U+FFFD */

static void assert_text(const char *string, const char *expected)
{
    char quoted[256] = "\"";
    cJSON *json = cJSON_CreateString(string);
    char *text = glint_json_text(json);
    strcat(strcat(quoted, expected), "\"");
    assert_non_null(text);
    assert_string_equal(text, quoted);
    free(text);
    cJSON_Delete(json);
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
        cmocka_unit_test(nothing_is_no_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
