/* Both forms of the divider clock by clock. */
#include "glint_divider_device.h"

#include <stdlib.h>
#include <string.h>

struct glint_divider_device {
    glint_divider_form form;
    int shifts;
    glint_divider_inputs pins; /* of the last edge: the sequential form looks k up as it stands */
    glint_divider_sequential_signals sequential;
    glint_divider_pipelined_signals pipelined;
};

/* ---- The sequential form: shift register, accumulating register, adder ---- */

static void load_division(glint_divider_device *d, const glint_divider_inputs *in)
{
    glint_divider_sequential_signals *s = &d->sequential;
    uint32_t bits = glint_divider_bits(d->shifts, in->k);
    int64_t loaded = in->difference[0] * (INT64_C(1) << d->shifts);
    s->shift_rg = loaded;
    s->acc_rg = bits >> d->shifts & 1u ? loaded : 0;
    s->bits_rg = bits & ((1u << d->shifts) - 1u);
    s->left = d->shifts;
    s->busy = 1;
    s->out_of_table = !glint_divider_in_table(in->k);
}

static void clock_sequential(glint_divider_device *d, const glint_divider_inputs *in)
{
    glint_divider_sequential_signals *s = &d->sequential;
    if (s->busy) {
        s->shift_rg = s->shifted;
        s->acc_rg = s->sum;
        s->bits_rg = s->bits_rg << 1 & ((1 << d->shifts) - 1);
        s->done = s->left == 1;
        s->busy = s->left != 1;
        s->left--;
    } else {
        s->done = 0;
        if (in->start)
            load_division(d, in);
    }
}

static void settle_sequential(glint_divider_device *d)
{
    glint_divider_sequential_signals *s = &d->sequential;
    s->rom_bits = glint_divider_bits(d->shifts, d->pins.k);
    s->rom_miss = !glint_divider_in_table(d->pins.k);
    s->shifted = s->shift_rg >> 1; /* arithmetic: gcc and clang keep the sign */
    s->term = s->bits_rg >> (d->shifts - 1) & 1 ? s->shifted : 0;
    s->sum = s->acc_rg + s->term;
    s->quotient = s->acc_rg;
}

/* ---- The pipelined form: a stage for each bit ---- */

/* The input of stage 1: element 0 of the arrays between the stages. */
static glint_divider_stage_signals before_first_stage(const glint_divider_device *d)
{
    const glint_divider_pipelined_signals *s = &d->pipelined;
    const int64_t i0 = s->rom_bits >> d->shifts & 1;
    const int64_t one = INT64_C(1) << d->shifts;
    return (glint_divider_stage_signals){.valid = s->s0_valid,
                                         .miss = s->rom_miss,
                                         .bits = s->rom_bits,
                                         .d_r = s->s0_d_r,
                                         .d_g = s->s0_d_g,
                                         .d_b = s->s0_d_b,
                                         .acc_r = i0 * s->s0_d_r * one,
                                         .acc_g = i0 * s->s0_d_g * one,
                                         .acc_b = i0 * s->s0_d_b * one};
}

static void clock_pipelined(glint_divider_device *d, const glint_divider_inputs *in)
{
    glint_divider_pipelined_signals *s = &d->pipelined;
    s->stage[0] = before_first_stage(d);
    for (int j = d->shifts; j >= 1; j--) {
        const int64_t weight = INT64_C(1) << (d->shifts - j);
        const int64_t bit = s->stage[j - 1].bits >> (d->shifts - j) & 1;
        s->stage[j] = s->stage[j - 1];
        s->stage[j].acc_r += bit * s->stage[j].d_r * weight;
        s->stage[j].acc_g += bit * s->stage[j].d_g * weight;
        s->stage[j].acc_b += bit * s->stage[j].d_b * weight;
    }
    s->s0_valid = in->start != 0;
    if (in->start) {
        s->s0_k = in->k;
        s->s0_d_r = in->difference[0];
        s->s0_d_g = in->difference[1];
        s->s0_d_b = in->difference[2];
    }
}

static void settle_pipelined(glint_divider_device *d)
{
    glint_divider_pipelined_signals *s = &d->pipelined;
    const glint_divider_stage_signals *last = &s->stage[d->shifts];
    s->rom_bits = glint_divider_bits(d->shifts, (uint32_t)s->s0_k);
    s->rom_miss = !glint_divider_in_table((uint32_t)s->s0_k);
    s->out_valid = last->valid;
    s->out_of_table = last->miss;
    s->quotient_r = last->acc_r;
    s->quotient_g = last->acc_g;
    s->quotient_b = last->acc_b;
}

/* ---- Either form ---- */

static void settle(glint_divider_device *d)
{
    if (d->form == GLINT_DIVIDER_SEQUENTIAL)
        settle_sequential(d);
    else
        settle_pipelined(d);
}

void glint_divider_device_clock(glint_divider_device *d, const glint_divider_inputs *in)
{
    d->pins = *in;
    if (in->reset) {
        memset(&d->sequential, 0, sizeof d->sequential);
        memset(&d->pipelined, 0, sizeof d->pipelined);
    } else if (in->en) {
        if (d->form == GLINT_DIVIDER_SEQUENTIAL)
            clock_sequential(d, in);
        else
            clock_pipelined(d, in);
    }
    settle(d);
}

glint_status glint_divider_device_create(glint_divider_form form, int shifts,
                                         glint_divider_device **device)
{
    *device = NULL;
    if ((unsigned)form >= GLINT_DIVIDER_FORM_COUNT || shifts < GLINT_DIVIDER_SHIFTS_MIN ||
        shifts > GLINT_DIVIDER_SHIFTS_MAX)
        return GLINT_BAD_ARGUMENT;
    glint_divider_device *d = calloc(1, sizeof *d);
    if (d == NULL)
        return GLINT_NO_MEMORY;
    d->form = form;
    d->shifts = shifts;
    settle(d);
    *device = d;
    return GLINT_OK;
}

void glint_divider_device_destroy(glint_divider_device *device)
{
    free(device);
}

const glint_divider_sequential_signals *
glint_divider_device_sequential(const glint_divider_device *device)
{
    return device->form == GLINT_DIVIDER_SEQUENTIAL ? &device->sequential : NULL;
}

const glint_divider_pipelined_signals *
glint_divider_device_pipelined(const glint_divider_device *device)
{
    return device->form == GLINT_DIVIDER_PIPELINED ? &device->pipelined : NULL;
}

int glint_divider_latency(int shifts)
{
    return shifts + 1;
}

int glint_divider_device_shifts(const glint_divider_device *device)
{
    return device->shifts;
}
