/* The errors of the divider's sum (2.18), in exact integers: of the increment, and of the last
 * pixel of the span along which it is added. */
#ifndef GLINT_SIM_REPORT_DIVIDER_ERROR_H
#define GLINT_SIM_REPORT_DIVIDER_ERROR_H

#include "glint_divider.h"

/* How the table's bits are derived from 2ⁿ/k. The circuit rounds. */
typedef enum glint_bits_rule {
    GLINT_BITS_ROUNDED,
    GLINT_BITS_TRUNCATED,
    GLINT_BITS_RULE_COUNT
} glint_bits_rule;

/* k = 1 is exact and is left out here. */
#define GLINT_ERROR_K_MIN 2

/* Largest magnitudes over k = 2…GLINT_DIVIDER_K_MAX, each with the smallest k that has it. */
typedef struct glint_divider_error {
    double absolute; /* levels, of the increment for a difference of 255 */
    int absolute_k;
    double relative; /* of the increment, not in per cent */
    int relative_k;
    double relative_mean; /* of the magnitudes over k */
    double last_pixel;    /* levels, after k increments for a difference of 255, not rounded */
    int last_pixel_k;
    int displayed; /* levels, of the last pixel as the span unit gives it: rounded half up to 8
                      bits; over every difference −255…255, rising from 0 or falling from 255 */
    int displayed_k;
    int displayed_difference; /* one of those that have it */
} glint_divider_error;

glint_divider_error glint_divider_error_of(int shifts, glint_bits_rule rule);

/* The table's number of 2ⁿ-ths for k. */
uint32_t glint_bits_by_rule(int shifts, glint_bits_rule rule, int k);

/* |increment − exact increment| / exact increment for one k: the same for every difference. */
double glint_divider_relative_error(int shifts, glint_bits_rule rule, int k);

/* One increment by the sum: the example of section 2.4. */
typedef struct glint_divider_example {
    int difference, k, shifts;
    uint32_t bits;     /* 2ⁿ-ths of the sum for 1/k */
    double exact, sum; /* the increment in levels, by division and by the sum */
    double relative;   /* error of the latter */
} glint_divider_example;

glint_divider_example glint_divider_example_of(int difference, int k, int shifts);

/* The least number of shifts with which, and with all above it, the last pixel, not rounded, is
 * within half a level for every k; 0: there is none. */
int glint_divider_first_within_half(glint_bits_rule rule);

#endif
