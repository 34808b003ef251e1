/* The divider's errors. With b the bits for k as a number, an increment is d·b/2ⁿ instead of d/k:
 * wrong by d·(b·k − 2ⁿ)/(k·2ⁿ), and after k increments by d·(b·k − 2ⁿ)/2ⁿ. */
#include "report/divider_error.h"

#include <stdlib.h>

#include "render/span.h"

uint32_t glint_bits_by_rule(int shifts, glint_bits_rule rule, int k)
{
    return rule == GLINT_BITS_ROUNDED ? glint_divider_bits(shifts, (uint32_t)k)
                                      : (UINT32_C(1) << shifts) / (uint32_t)k;
}

/* |b·k − 2ⁿ| */
static int32_t residue(int shifts, glint_bits_rule rule, int k)
{
    return abs((int32_t)glint_bits_by_rule(shifts, rule, k) * k - (INT32_C(1) << shifts));
}

double glint_divider_relative_error(int shifts, glint_bits_rule rule, int k)
{
    return (double)residue(shifts, rule, k) / (double)(INT32_C(1) << shifts);
}

static void keep_largest(double value, int k, double *largest, int *largest_k)
{
    if (value > *largest) {
        *largest = value;
        *largest_k = k;
    }
}

/* The last pixel of a span of k steps, as the span unit has it. */
static int last_pixel(int shifts, int32_t bits, int difference, int k)
{
    const uint8_t from = difference >= 0 ? 0 : 255;
    const uint8_t to = (uint8_t)(from + difference);
    const int32_t code = difference * bits;
    const glint_run span = {.end = k, .from = {from, from, from}, .to = {to, to, to}};
    const glint_quotients quotients = {.code = {code, code, code}};
    uint8_t value[3];
    glint_operations unused = {0};
    glint_run_walk(&span, shifts, &quotients, k, k, value, &unused);
    return value[0] - to;
}

static void find_displayed(int shifts, glint_bits_rule rule, int k, glint_divider_error *error)
{
    const int32_t bits = (int32_t)glint_bits_by_rule(shifts, rule, k);
    for (int d = -GLINT_DIVIDER_DIFFERENCE_MAX; d <= GLINT_DIVIDER_DIFFERENCE_MAX; d++) {
        const int wrong = abs(last_pixel(shifts, bits, d, k));
        if (wrong > error->displayed) {
            error->displayed = wrong;
            error->displayed_k = k;
            error->displayed_difference = d;
        }
    }
}

glint_divider_error glint_divider_error_of(int shifts, glint_bits_rule rule)
{
    glint_divider_error error = {.absolute_k = GLINT_ERROR_K_MIN,
                                 .relative_k = GLINT_ERROR_K_MIN,
                                 .last_pixel_k = GLINT_ERROR_K_MIN,
                                 .displayed_k = GLINT_ERROR_K_MIN};
    int32_t sum = 0;
    for (int k = GLINT_ERROR_K_MIN; k <= GLINT_DIVIDER_K_MAX; k++) {
        const int32_t wrong = residue(shifts, rule, k);
        const double one = (double)(INT32_C(1) << shifts);
        const double of_255 = (double)(GLINT_DIVIDER_DIFFERENCE_MAX * wrong);
        sum += wrong;
        keep_largest(of_255 / (k * one), k, &error.absolute, &error.absolute_k);
        keep_largest(wrong / one, k, &error.relative, &error.relative_k);
        keep_largest(of_255 / one, k, &error.last_pixel, &error.last_pixel_k);
        find_displayed(shifts, rule, k, &error);
    }
    const int lengths = GLINT_DIVIDER_K_MAX - GLINT_ERROR_K_MIN + 1;
    error.relative_mean = sum / (double)(lengths * (INT32_C(1) << shifts));
    return error;
}

glint_divider_example glint_divider_example_of(int difference, int k, int shifts)
{
    const uint32_t bits = glint_bits_by_rule(shifts, GLINT_BITS_ROUNDED, k);
    return (glint_divider_example){
        .difference = difference,
        .k = k,
        .shifts = shifts,
        .bits = bits,
        .exact = (double)difference / k,
        .sum = (double)difference * bits / (double)(UINT32_C(1) << shifts),
        .relative = glint_divider_relative_error(shifts, GLINT_BITS_ROUNDED, k)};
}

int glint_divider_first_within_half(glint_bits_rule rule)
{
    int first = GLINT_DIVIDER_SHIFTS_MAX + 1;
    while (first > GLINT_DIVIDER_SHIFTS_MIN &&
           glint_divider_error_of(first - 1, rule).last_pixel <= 0.5)
        first--;
    return first <= GLINT_DIVIDER_SHIFTS_MAX ? first : 0;
}
