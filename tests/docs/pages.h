/* The pages of the documentation, for a test of each. Include it after cmocka.h and ../scratch.h.
 */
#ifndef GLINT_TESTS_DOCS_PAGES_H
#define GLINT_TESTS_DOCS_PAGES_H

#include <glob.h>

/* Runs a check on each page, and returns how many faults it reported. */
static inline int on_every_page(int (*check)(const char *page, char *text))
{
    glob_t pages;
    int faults = 0;
    assert_int_equal(glob("README.md", 0, NULL, &pages), 0);
    assert_int_equal(glob("docs/*.md", GLOB_APPEND, NULL, &pages), 0);
    assert_int_equal(glob("docs/examples/*/*.md", GLOB_APPEND, NULL, &pages), 0);
    for (size_t i = 0; i < pages.gl_pathc; i++) {
        char *text = scratch_read(pages.gl_pathv[i], NULL);
        faults += check(pages.gl_pathv[i], text);
        free(text);
    }
    globfree(&pages);
    return faults;
}

#endif
