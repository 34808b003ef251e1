/* A bit-serial multiplier, for the tests of user circuits: the C model, clock by clock. */
#include <stdlib.h>

#include "serial_mul.h"

typedef struct serial {
    int width;
    serial_signals s;
} serial;

static void edge(serial *m, const serial_pins *pins)
{
    serial_signals *s = &m->s;
    const int64_t mask = (INT64_C(1) << 2 * m->width) - 1;
    s->done = s->busy && s->left == 1;
    if (s->busy) {
        s->product = s->sum;
        s->addend = s->addend << 1 & mask;
        s->bits >>= 1;
        s->busy = s->left != 1;
        s->left--;
    } else if (pins->start) {
        s->product = 0;
        s->addend = pins->a;
        s->bits = pins->b;
        s->left = m->width;
        s->busy = 1;
    }
}

void serial_clock(void *model, const void *pins_now)
{
    serial *m = model;
    const serial_pins *pins = pins_now;
    if (pins->arst)
        m->s = (serial_signals){0};
    else if (pins->en)
        edge(m, pins);
    m->s.sum = m->s.product + (m->s.bits & 1 ? m->s.addend : 0);
}

glint_status serial_create(const int *values, void **model)
{
    serial *m = calloc(1, sizeof *m);
    *model = m;
    if (m == NULL)
        return GLINT_NO_MEMORY;
    m->width = values[0];
    return GLINT_OK;
}

void serial_destroy(void *model)
{
    free(model);
}

const void *serial_state(const void *model)
{
    return &((const serial *)model)->s;
}
