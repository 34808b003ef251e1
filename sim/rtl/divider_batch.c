/* Divisions through the ports of a divider. */
#include <string.h>

#include "circuit/circuits.h"
#include "rtl/batch.h"
#include "rtl/bits.h"

_Static_assert(GLINT_DIVIDER_DIFFERENCE_BITS > 8 && GLINT_DIVIDER_DIFFERENCE_BITS <= 16,
               "a difference is a port of two bytes");
_Static_assert(GLINT_DIVIDER_K_BITS <= 8, "k is a port of one byte");

/* A quotient's port has 2 or 4 bytes. */
typedef struct quotient_port {
    const unsigned char *data;
    size_t size;
} quotient_port;

/* Where Verilator has the ports; the sequential form has one component. */
typedef struct divider {
    uint8_t *reset, *en, *start, *k;
    const uint8_t *done, *out_of_table;
    uint16_t *difference[GLINT_DIVIDER_COMPONENTS];
    quotient_port quotient[GLINT_DIVIDER_COMPONENTS];
    int shifts; /* 0: not looked at yet */
} divider;

_Static_assert(sizeof(divider) <= GLINT_RTL_NOTES_SIZE, "a divider fits into a circuit's notes");

static bool is_pipelined(const glint_rtl *rtl)
{
    return glint_rtl_setting(rtl)->values[GLINT_DIVIDER_FORM] == GLINT_DIVIDER_PIPELINED;
}

static void find_component(glint_rtl *rtl, divider *d, int component, const char *difference,
                           const char *quotient, bool *good)
{
    quotient_port *q = &d->quotient[component];
    d->difference[component] = glint_batch_port(rtl, difference, 2, good);
    q->data = glint_rtl_port(rtl, quotient, &q->size);
    *good = *good && q->data != NULL && (q->size == 2 || q->size == 4);
}

static bool find_ports(glint_rtl *rtl, divider *d)
{
    bool good = true;
    d->reset = glint_batch_port(rtl, "reset", 1, &good);
    d->en = glint_batch_port(rtl, "en", 1, &good);
    d->k = glint_batch_port(rtl, "k", 1, &good);
    d->out_of_table = glint_batch_port(rtl, "out_of_table", 1, &good);
    d->start = glint_batch_port(rtl, is_pipelined(rtl) ? "in_valid" : "start", 1, &good);
    d->done = glint_batch_port(rtl, is_pipelined(rtl) ? "out_valid" : "done", 1, &good);
    if (is_pipelined(rtl)) {
        find_component(rtl, d, 0, "difference_r", "quotient_r", &good);
        find_component(rtl, d, 1, "difference_g", "quotient_g", &good);
        find_component(rtl, d, 2, "difference_b", "quotient_b", &good);
    } else {
        find_component(rtl, d, 0, "difference", "quotient", &good);
    }
    return good;
}

/* The circuit as a divider, looked up once; NULL if it is not one. */
static const divider *divider_of(glint_rtl *rtl)
{
    divider *d = glint_rtl_notes(rtl);
    const glint_setting *setting = glint_rtl_setting(rtl);
    if (d->shifts == 0) {
        if (setting->circuit != &glint_circuit_divider || !find_ports(rtl, d))
            return NULL;
        d->shifts = setting->values[GLINT_DIVIDER_SHIFTS];
    }
    return d;
}

static void set_difference(uint16_t *to, int difference)
{
    *to = (uint16_t)((unsigned)difference & glint_bits_mask(GLINT_DIVIDER_DIFFERENCE_BITS));
}

static int32_t get_quotient(const divider *d, int component)
{
    const quotient_port *q = &d->quotient[component];
    const int unused = 32 - (GLINT_DIVIDER_DIFFERENCE_BITS + d->shifts);
    uint32_t bits;
    if (q->size == 2) {
        uint16_t narrow;
        memcpy(&narrow, q->data, sizeof narrow);
        bits = narrow;
    } else {
        memcpy(&bits, q->data, sizeof bits);
    }
    return (int32_t)(bits << unused) >> unused;
}

/* ---- The pipelined form ---------------------------------------------------------------------- */

static void feed(const divider *d, bool valid, const glint_division *division)
{
    *d->start = valid;
    *d->k = division->k;
    for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
        set_difference(d->difference[c], division->difference[c]);
}

static void take(const divider *d, glint_quotients *quotients)
{
    for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
        quotients->code[c] = get_quotient(d, c);
    quotients->out_of_table = *d->out_of_table;
}

static size_t run_pipelined(glint_rtl *rtl, const divider *d, const glint_division *divisions,
                            size_t count, glint_quotients *quotients)
{
    static const glint_division nothing;
    size_t done = 0;
    for (size_t i = 0; i < count + (size_t)d->shifts; i++) {
        feed(d, i < count, i < count ? &divisions[i] : &nothing);
        glint_rtl_edge(rtl);
        if (*d->done && done < count)
            take(d, &quotients[done++]);
    }
    return done;
}

/* ---- The sequential form --------------------------------------------------------------------- */

/* One division from start to done; false if done does not rise within the latency. */
static bool divide_one(glint_rtl *rtl, const divider *d, uint8_t k, int16_t difference,
                       int32_t *code, bool *out_of_table)
{
    *d->start = 1;
    *d->k = k;
    set_difference(d->difference[0], difference);
    glint_rtl_edge(rtl);
    *d->start = 0;
    for (int i = 0; i < d->shifts && !*d->done; i++)
        glint_rtl_edge(rtl);
    *code = get_quotient(d, 0);
    *out_of_table = *d->out_of_table;
    return *d->done;
}

static size_t run_sequential(glint_rtl *rtl, const divider *d, const glint_division *divisions,
                             size_t count, glint_quotients *quotients)
{
    for (size_t i = 0; i < count; i++)
        for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
            if (!divide_one(rtl, d, divisions[i].k, divisions[i].difference[c],
                            &quotients[i].code[c], &quotients[i].out_of_table))
                return i;
    return count;
}

glint_status glint_rtl_divide(glint_rtl *rtl, const glint_division *divisions, size_t count,
                              glint_quotients *quotients, glint_error *err)
{
    const divider *d = divider_of(rtl);
    if (d == NULL)
        return glint_fail(err, GLINT_DEVICE_FAULT, "the circuit does not have a divider's pins");
    *d->reset = 0;
    *d->en = 1;
    const size_t done = is_pipelined(rtl) ? run_pipelined(rtl, d, divisions, count, quotients)
                                          : run_sequential(rtl, d, divisions, count, quotients);
    if (done != count)
        return glint_fail(err, GLINT_DEVICE_FAULT, "the divider returned %zu of %zu quotients",
                          done, count);
    return GLINT_OK;
}
