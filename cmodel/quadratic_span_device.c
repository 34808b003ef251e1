/* The span unit of quadratic interpolation clock by clock: every register and named value of
 * rtl/quadratic_span.v. */
#include "glint_quadratic_span.h"

#include <string.h>

/* The low 10 + fraction bits as a signed number. */
static int64_t wrapped(int64_t number, int fraction)
{
    const int unused = 64 - (GLINT_QUADRATIC_SPAN_INT_BITS + fraction);
    return (int64_t)((uint64_t)number << unused) >> unused;
}

static void clock_component(glint_quadratic_component *r, const glint_quadratic_span_pins *pins,
                            int c, int fraction)
{
    if (pins->load) {
        r->value = wrapped(pins->walk.start[c], fraction);
        r->slope = wrapped(pins->walk.first[c], fraction);
        r->curve = wrapped(pins->walk.second[c], fraction);
    } else if (pins->step) {
        r->value = r->next_value;
        r->slope = r->next_slope;
    }
}

/* The logic behind the registers. */
static void settle(glint_quadratic_component *r, int fraction)
{
    r->next_value = wrapped(r->value + r->slope, fraction);
    r->next_slope = wrapped(r->slope + r->curve, fraction);
    r->level = (r->value >> fraction) + (r->value >> (fraction - 1) & 1);
    r->clamped = r->level < 0 ? 0 : r->level > 255 ? 255 : r->level;
}

void glint_quadratic_span_clock(int fraction, glint_quadratic_span_signals *s,
                                const glint_quadratic_span_pins *pins)
{
    if (pins->reset) {
        memset(s, 0, sizeof *s);
    } else if (pins->en) {
        for (int c = 0; s->s1_valid && c < GLINT_QUADRATIC_SPAN_COMPONENTS; c++)
            s->component[c].out = s->component[c].clamped;
        s->out_valid = s->s1_valid;
        s->s1_valid = pins->load || pins->step;
        for (int c = 0; c < GLINT_QUADRATIC_SPAN_COMPONENTS; c++)
            clock_component(&s->component[c], pins, c, fraction);
    }
    for (int c = 0; c < GLINT_QUADRATIC_SPAN_COMPONENTS; c++)
        settle(&s->component[c], fraction);
}
