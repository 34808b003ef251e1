/* Spans through the ports of the span unit of quadratic interpolation. */
#include <string.h>

#include "circuit/circuits.h"
#include "rtl/batch.h"
#include "rtl/bits.h"

#define COMPONENTS GLINT_QUADRATIC_SPAN_COMPONENTS
#define NUMBERS    3 /* start, first, second */

/* Where Verilator has the ports. Those of numbers have 4 or 8 bytes. */
typedef struct unit {
    uint8_t *reset, *en, *load, *step;
    const uint8_t *out_valid;
    const uint8_t *out[COMPONENTS];
    void *number[NUMBERS][COMPONENTS];
    size_t size;   /* of a number's port */
    uint64_t mask; /* 0: not looked at yet */
} unit;

_Static_assert(sizeof(unit) <= GLINT_RTL_NOTES_SIZE, "a span unit fits into a circuit's notes");

static bool find_ports(glint_rtl *rtl, unit *u)
{
    static const char *const numbers[NUMBERS][COMPONENTS] = {
        {"start_r", "start_g", "start_b"},
        {"first_r", "first_g", "first_b"},
        {"second_r", "second_g", "second_b"},
    };
    static const char *const outputs[COMPONENTS] = {"r", "g", "b"};
    bool good = glint_rtl_port(rtl, numbers[0][0], &u->size) != NULL;
    good = good && (u->size == sizeof(uint32_t) || u->size == sizeof(uint64_t));
    u->reset = glint_batch_port(rtl, "reset", 1, &good);
    u->en = glint_batch_port(rtl, "en", 1, &good);
    u->load = glint_batch_port(rtl, "load", 1, &good);
    u->step = glint_batch_port(rtl, "step", 1, &good);
    u->out_valid = glint_batch_port(rtl, "out_valid", 1, &good);
    for (int c = 0; c < COMPONENTS; c++) {
        u->out[c] = glint_batch_port(rtl, outputs[c], 1, &good);
        for (int i = 0; i < NUMBERS; i++)
            u->number[i][c] = glint_batch_port(rtl, numbers[i][c], u->size, &good);
    }
    return good;
}

/* The circuit as a span unit, looked up once; NULL if it is not one. */
static const unit *unit_of(glint_rtl *rtl)
{
    unit *u = glint_rtl_notes(rtl);
    const glint_setting *setting = glint_rtl_setting(rtl);
    if (u->mask == 0) {
        if (setting->circuit != &glint_circuit_span || !find_ports(rtl, u))
            return NULL;
        u->mask = glint_bits_mask(GLINT_QUADRATIC_SPAN_INT_BITS + setting->values[0]);
    }
    return u;
}

static void set_number(const unit *u, void *port, int64_t number)
{
    const uint64_t bits = (uint64_t)number & u->mask;
    if (u->size == sizeof bits) {
        memcpy(port, &bits, sizeof bits);
    } else {
        const uint32_t narrow = (uint32_t)bits;
        memcpy(port, &narrow, sizeof narrow);
    }
}

static void set_walk(const unit *u, const glint_quadratic_walk *walk)
{
    for (int c = 0; c < COMPONENTS; c++) {
        set_number(u, u->number[0][c], walk->start[c]);
        set_number(u, u->number[1][c], walk->first[c]);
        set_number(u, u->number[2][c], walk->second[c]);
    }
}

/* What has come out so far goes to rgb. */
typedef struct taken {
    size_t pixels, wanted;
    uint8_t *rgb;
} taken;

static void clock_once(glint_rtl *rtl, const unit *u, bool load, bool step, taken *t)
{
    *u->load = load;
    *u->step = step;
    glint_rtl_edge(rtl);
    if (!*u->out_valid || t->pixels == t->wanted)
        return;
    for (int c = 0; c < COMPONENTS; c++)
        t->rgb[COMPONENTS * t->pixels + (size_t)c] = *u->out[c];
    t->pixels++;
}

glint_status glint_rtl_walk(glint_rtl *rtl, const glint_spans *spans, glint_error *err)
{
    const unit *u = unit_of(rtl);
    taken t = {.rgb = spans->rgb};
    if (u == NULL)
        return glint_fail(err, GLINT_DEVICE_FAULT, "the circuit does not have a span unit's pins");
    *u->reset = 0;
    *u->en = 1;
    for (size_t i = 0; i < spans->count; i++) {
        t.wanted += spans->length[i];
        set_walk(u, &spans->walk[i]);
        for (uint32_t k = 0; k < spans->length[i]; k++)
            clock_once(rtl, u, k == 0, true, &t);
    }
    for (int i = 1; i < GLINT_QUADRATIC_SPAN_LATENCY && spans->count != 0; i++)
        clock_once(rtl, u, false, false, &t);
    if (t.pixels != t.wanted)
        return glint_fail(err, GLINT_DEVICE_FAULT, "the span unit returned %zu of %zu pixels",
                          t.pixels, t.wanted);
    return GLINT_OK;
}
