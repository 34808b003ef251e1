/* The divider as a pure function: the sum (2.18), term by term. */
#include "glint_divider.h"

bool glint_divider_in_table(uint32_t k)
{
    return k >= 1 && k <= GLINT_DIVIDER_K_MAX;
}

static bool shifts_are_valid(int shifts)
{
    return shifts >= GLINT_DIVIDER_SHIFTS_MIN && shifts <= GLINT_DIVIDER_SHIFTS_MAX;
}

uint32_t glint_divider_bits(int shifts, uint32_t k)
{
    if (!glint_divider_in_table(k))
        return 0;
    return ((2u << shifts) + k) / (2u * k); /* 2ⁿ/k + 1/2, cut off */
}

/* Every term iⱼ·difference/2ʲ as a code with n fraction bits, where none of them loses a bit. */
static int32_t sum_of_terms(int shifts, uint32_t bits, int32_t difference)
{
    int32_t sum = 0;
    for (int j = 0; j <= shifts; j++)
        if (bits >> (shifts - j) & 1u)
            sum += difference * (1 << (shifts - j));
    return sum;
}

glint_status glint_divide(int shifts, int32_t difference, uint32_t k, int32_t *quotient,
                          bool *out_of_table)
{
    if (!shifts_are_valid(shifts) || difference < -GLINT_DIVIDER_DIFFERENCE_MAX ||
        difference > GLINT_DIVIDER_DIFFERENCE_MAX || k >> GLINT_DIVIDER_K_BITS != 0)
        return GLINT_BAD_ARGUMENT;
    *quotient = sum_of_terms(shifts, glint_divider_bits(shifts, k), difference);
    *out_of_table = !glint_divider_in_table(k);
    return GLINT_OK;
}

glint_status glint_divide_batch(int shifts, const glint_division *divisions, size_t count,
                                glint_quotients *quotients)
{
    int32_t bits[1 << GLINT_DIVIDER_K_BITS];
    if (!shifts_are_valid(shifts))
        return GLINT_BAD_ARGUMENT;
    for (uint32_t k = 0; k < sizeof bits / sizeof bits[0]; k++)
        bits[k] = (int32_t)glint_divider_bits(shifts, k);
    for (size_t i = 0; i < count; i++) {
        /* A product is the sum of the terms that its factor's bits select. */
        for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
            quotients[i].code[c] = divisions[i].difference[c] * bits[divisions[i].k];
        quotients[i].out_of_table = !glint_divider_in_table(divisions[i].k);
    }
    return GLINT_OK;
}
