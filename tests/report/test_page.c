/* A Markdown file as one page that needs nothing else. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "report/page.h"

static void write_text(const char *name, const char *text)
{
    scratch_write(scratch_path(name), text, strlen(text));
}

/* The page made of the text, to be freed. */
static char *page_of(const char *markdown)
{
    glint_error err;
    write_text("page.md", markdown);
    if (glint_page_make(scratch_directory, "page", &err) != GLINT_OK)
        fail_msg("%s", err.text);
    return scratch_read(scratch_path("page.html"), NULL);
}

static void assert_has(const char *page, const char *expected)
{
    if (strstr(page, expected) == NULL)
        fail_msg("no \"%s\" in %s", expected, page);
}

static void headings_become_title_and_contents(void **state)
{
    (void)state;
    char *page = page_of("# The *whole* 1 < 2\n\n## First & `second`\n\ntext\n\n### no line\n\n"
                         "## Last\n");
    assert_has(page, "<title>The whole 1 &lt; 2</title>");
    assert_has(page, "</h1>\n<nav><ol>\n<li><a href=\"#section-1\">First &amp; second</a></li>\n"
                     "<li><a href=\"#section-2\">Last</a></li>\n</ol></nav>");
    assert_has(page, "<a id=\"section-1\"></a>\n<h2>First &amp; <code>second</code></h2>");
    assert_has(page, "<a id=\"section-2\"></a>\n<h2>Last</h2>");
    assert_null(strstr(page, "section-3"));
    free(page);
}

static void tables_and_verdicts_are_drawn(void **state)
{
    (void)state;
    char *page = page_of("| a | b |\n|---|--:|\n| **holds** | 1 |\n| **does not hold** | 2 |\n"
                         "| **cannot be decided** | 3 |\n| **another** | 4 |\n");
    assert_has(page, "<th align=\"right\">b</th>");
    assert_has(page, "<span class=\"holds\"><strong>holds</strong></span>");
    assert_has(page, "<span class=\"not\"><strong>does not hold</strong></span>");
    assert_has(page, "<span class=\"open\"><strong>cannot be decided</strong></span>");
    assert_has(page, "<td><strong>another</strong></td>");
    free(page);
}

static void pictures_are_inside(void **state)
{
    (void)state;
    write_text("plot.svg", "<svg/>\n");
    write_text("frame.png", "PNG!");
    char *page = page_of("![a plot](plot.svg) and ![](frame.png)\n");
    assert_has(page, "<img src=\"data:image/svg+xml;base64,PHN2Zy8+Cg==\" alt=\"a plot\" />");
    assert_has(page, "<img src=\"data:image/png;base64,UE5HIQ==\" alt=\"\" />");
    assert_null(strstr(page, "plot.svg"));
    free(page);
}

/* No page, and no half of one: the error says which file. */
static void assert_refused(const char *markdown, glint_status expected, const char *reason)
{
    glint_error err;
    write_text("refused.md", markdown);
    assert_int_equal(glint_page_make(scratch_directory, "refused", &err), expected);
    assert_has(err.text, reason);
    assert_int_equal(access(scratch_path("refused.html"), F_OK), -1);
}

static void what_is_missing_is_named(void **state)
{
    (void)state;
    glint_error err;
    assert_refused("![x](nowhere.png)\n", GLINT_IO_ERROR, "nowhere.png: No such file");
    assert_refused("![x](movie.avi)\n", GLINT_BAD_INPUT, "movie.avi is neither .png nor .svg");
    assert_int_equal(glint_page_make(scratch_directory, "absent", &err), GLINT_IO_ERROR);
    assert_has(err.text, "absent.md: No such file");
}

static void long_texts_fit(void **state)
{
    (void)state;
    static char text[300000];
    memset(text, 'w', sizeof text - 1);
    memcpy(text, "# ", 2);
    memcpy(text + 200, "\n\n## ", 5);
    char *page = page_of(text);
    assert_true(strlen(page) > sizeof text);
    free(page);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(headings_become_title_and_contents),
        cmocka_unit_test(tables_and_verdicts_are_drawn),
        cmocka_unit_test(pictures_are_inside),
        cmocka_unit_test(what_is_missing_is_named),
        cmocka_unit_test(long_texts_fit),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
