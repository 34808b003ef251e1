/* The span unit of quadratic interpolation as a pure function. */
#include "glint_quadratic_span.h"

#define COMPONENTS GLINT_QUADRATIC_SPAN_COMPONENTS

static int bits_of(int fraction)
{
    return GLINT_QUADRATIC_SPAN_INT_BITS + fraction;
}

int glint_quadratic_span_longest(int fraction)
{
    const int64_t one = INT64_C(1) << fraction;
    int64_t length = 1;
    while (1 + (length + 1) * length / 2 <= one)
        length++;
    return (int)length;
}

/* The registers of one component, shifted to the top of 64 bits: there, sums wrap as the circuit's
 * do. */
typedef struct registers {
    uint64_t value, slope, curve;
} registers;

static registers load(const glint_quadratic_walk *walk, int c, int unused)
{
    return (registers){(uint64_t)walk->start[c] << unused, (uint64_t)walk->first[c] << unused,
                       (uint64_t)walk->second[c] << unused};
}

static void step(registers *r)
{
    r->value += r->slope;
    r->slope += r->curve;
}

/* Rounded half up: the whole levels, and one more from half a level on. */
static uint8_t intensity(uint64_t value, int unused, int fraction)
{
    const int64_t whole = (int64_t)value >> (unused + fraction); /* arithmetic */
    const int64_t level = whole + (int64_t)(value >> (unused + fraction - 1) & 1u);
    const int64_t above = level > 0 ? level : 0;
    return (uint8_t)(above < 255 ? above : 255);
}

glint_status glint_quadratic_span(int fraction, const glint_quadratic_walk *walk, size_t count,
                                  uint8_t *rgb)
{
    if (fraction < GLINT_QUADRATIC_SPAN_FRACTION_MIN ||
        fraction > GLINT_QUADRATIC_SPAN_FRACTION_MAX)
        return GLINT_BAD_ARGUMENT;
    const int unused = 64 - bits_of(fraction);
    for (int c = 0; c < COMPONENTS; c++) {
        registers r = load(walk, c, unused);
        for (size_t i = 0; i < count; i++) {
            rgb[COMPONENTS * i + (size_t)c] = intensity(r.value, unused, fraction);
            step(&r);
        }
    }
    return GLINT_OK;
}

glint_quadratic_walk glint_quadratic_span_after(int fraction, const glint_quadratic_walk *walk,
                                                size_t steps)
{
    const int unused = 64 - bits_of(fraction);
    glint_quadratic_walk after;
    for (int c = 0; c < COMPONENTS; c++) {
        registers r = load(walk, c, unused);
        for (size_t i = 0; i < steps; i++)
            step(&r);
        after.start[c] = (int64_t)r.value >> unused;
        after.first[c] = (int64_t)r.slope >> unused;
        after.second[c] = (int64_t)r.curve >> unused;
    }
    return after;
}
