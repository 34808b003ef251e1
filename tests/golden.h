/* For tests whose expected numbers assume the committed formats: if a format is changed
 * (docs/formats.md), they are skipped with a message. Include it after cmocka.h. */
#ifndef GLINT_TESTS_GOLDEN_H
#define GLINT_TESTS_GOLDEN_H

#include <stdbool.h>

#include "glint_formats.h"

static inline bool golden_formats(void)
{
    return GLINT_COS_FRAC_BITS == 18 && GLINT_N_BITS == 10 && GLINT_SIGMA_FRAC_BITS == 13;
}

/* The first line of such a test. */
static inline void golden(void)
{
    if (!golden_formats()) {
        print_message("its numbers are for other formats than those of cmodel/glint_formats.h\n");
        skip();
    }
}

static inline void other_formats(void **state)
{
    (void)state;
    golden();
}

/* For a group of such tests, instead of cmocka_run_group_tests(). */
static const struct CMUnitTest golden_skipped[] = {cmocka_unit_test(other_formats)};
#define golden_run_group_tests(tests, setup, teardown)                                             \
    (golden_formats() ? cmocka_run_group_tests(tests, setup, teardown)                             \
                      : cmocka_run_group_tests(golden_skipped, NULL, NULL))

#endif
