#include "sweep.h"

enum {
    AROUND = 8, /* codes below the limit */
    BELOW = 16, /* codes between 0 and the limit */
    BEYOND = 2,
    COLORS_STEP = 251, /* a prime: neighbours in W meet different colours */
    K_CODES = 1 << GLINT_DIVIDER_K_BITS,
    DIFFERENCES = 1 << GLINT_DIVIDER_DIFFERENCE_BITS,
};

/* Cosines of one n in white: some outside the highlight, all from just below its limit to 1.0, and
 * codes beyond. */
static uint32_t outside_count(uint32_t n)
{
    const uint32_t limit = glint_rom9(GLINT_GATE_COSINE, n);
    return BELOW + (limit < AROUND ? limit : AROUND);
}

static uint32_t cosine_count(uint32_t n)
{
    return outside_count(n) + GLINT_COS_ONE + 1 - glint_rom9(GLINT_GATE_COSINE, n) + BEYOND;
}

static uint32_t cosine_of(uint32_t n, uint32_t place)
{
    static const uint32_t beyond[BEYOND] = {GLINT_COS_ONE + 1, GLINT_COS_CODE_MAX};
    const uint32_t limit = glint_rom9(GLINT_GATE_COSINE, n);
    if (place < BELOW)
        return (uint32_t)((uint64_t)limit * place / BELOW);
    const uint32_t cosine = limit + place - outside_count(n);
    return cosine <= GLINT_COS_ONE ? cosine : beyond[cosine - GLINT_COS_ONE - 1];
}

void mutation_sweep_specular(mutation_sweep *at, glint_specular_inputs *in)
{
    in->en = in->n_we = in->rgb_we = 1;
    in->in_valid = 1;
    if (at->n < GLINT_N_COUNT) {
        in->n = (uint16_t)(GLINT_N_MAX - at->n);
        in->r = in->g = in->b = GLINT_COLOR_MAX;
        in->cos[0] = cosine_of(in->n, at->place++);
        if (at->place == cosine_count(in->n)) {
            at->n++;
            at->place = 0;
        }
        return;
    }
    in->n = 2;
    in->cos[0] = at->place++;
    in->r = (uint8_t)(in->cos[0] % COLORS_STEP);
    in->g = (uint8_t)(in->r + 85);
    in->b = (uint8_t)(in->r + 170);
}

uint64_t mutation_sweep_specular_clocks(void)
{
    uint64_t clocks = GLINT_COS_ONE + 1;
    for (uint32_t n = 0; n < GLINT_N_COUNT; n++)
        clocks += cosine_count(n);
    return clocks;
}

static int16_t difference_of(uint32_t place)
{
    return (int16_t)((int)(place % DIFFERENCES) - DIFFERENCES / 2);
}

void mutation_sweep_sequential(int shifts, uint64_t clock, glint_divider_inputs *in)
{
    const uint32_t latency = (uint32_t)glint_divider_latency(shifts);
    const uint32_t place = (uint32_t)((clock - 1) / latency);
    in->en = 1;
    in->start = (clock - 1) % latency == 0;
    in->k = (uint8_t)(place / DIFFERENCES);
    in->difference[0] = difference_of(place);
}

uint64_t mutation_sweep_sequential_clocks(int shifts)
{
    return (uint64_t)K_CODES * DIFFERENCES * (uint64_t)glint_divider_latency(shifts);
}

void mutation_sweep_pipelined(uint64_t clock, glint_divider_inputs *in)
{
    const uint32_t place = (uint32_t)(clock - 1);
    in->en = in->start = 1;
    in->k = (uint8_t)(place / DIFFERENCES);
    in->difference[0] = difference_of(place);
    in->difference[1] = difference_of(place + DIFFERENCES / 3);
    in->difference[2] = difference_of(place + 2 * DIFFERENCES / 3);
}

uint64_t mutation_sweep_pipelined_clocks(int shifts)
{
    return (uint64_t)K_CODES * DIFFERENCES + (uint64_t)glint_divider_latency(shifts);
}
