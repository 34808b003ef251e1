#include "planted.h"

#include <stdlib.h>

static uint64_t nothing(uint64_t clock)
{
    (void)clock;
    return 0;
}

planted plant = {
    .signal = PLANTED_NOWHERE, .inverted = nothing, .answer = PLANTED_NOWHERE, .asked = 0};

/* ld's names for the functions that are called, and for those that would have been. */
uint64_t __real_glint_rtl_signal_bits(const glint_rtl *rtl, int index);
uint64_t __wrap_glint_rtl_signal_bits(const glint_rtl *rtl, int index);
uint64_t __real_glint_divider_rtl_signal_bits(const glint_divider_rtl *rtl, int index);
uint64_t __wrap_glint_divider_rtl_signal_bits(const glint_divider_rtl *rtl, int index);
glint_status __real_glint_rtl_batch(glint_rtl *rtl, const glint_material *material,
                                    const uint32_t *cos_code, size_t count, uint32_t *w_code,
                                    uint8_t *r, uint8_t *g, uint8_t *b, glint_error *err);
glint_status __wrap_glint_rtl_batch(glint_rtl *rtl, const glint_material *material,
                                    const uint32_t *cos_code, size_t count, uint32_t *w_code,
                                    uint8_t *r, uint8_t *g, uint8_t *b, glint_error *err);
glint_status __real_glint_divider_rtl_batch(glint_divider_rtl *rtl, const glint_division *divisions,
                                            size_t count, glint_quotients *quotients,
                                            glint_error *err);
glint_status __wrap_glint_divider_rtl_batch(glint_divider_rtl *rtl, const glint_division *divisions,
                                            size_t count, glint_quotients *quotients,
                                            glint_error *err);

/* ---- Clock by clock -----------------------------------------------------------------------------
 */

/* `edges` counts the reset of creation as well. */
static uint64_t planted_bits(int index, uint64_t edges)
{
    const bool is_it = index == plant.signal || plant.signal == PLANTED_EVERYWHERE;
    return is_it ? plant.inverted(edges - 1) : 0;
}

uint64_t __wrap_glint_rtl_signal_bits(const glint_rtl *rtl, int index)
{
    return __real_glint_rtl_signal_bits(rtl, index) ^ planted_bits(index, glint_rtl_clocks(rtl));
}

uint64_t __wrap_glint_divider_rtl_signal_bits(const glint_divider_rtl *rtl, int index)
{
    return __real_glint_divider_rtl_signal_bits(rtl, index) ^
           planted_bits(index, glint_divider_rtl_clocks(rtl));
}

/* ---- By runs ------------------------------------------------------------------------------------
 */

/* Where in a run of `count` the planted one is; −1: not in it. */
static long place_in(size_t count)
{
    const long first = plant.asked;
    plant.asked += (long)count;
    return plant.answer >= first && plant.answer < plant.asked ? plant.answer - first : -1;
}

glint_status __wrap_glint_rtl_batch(glint_rtl *rtl, const glint_material *material,
                                    const uint32_t *cos_code, size_t count, uint32_t *w_code,
                                    uint8_t *r, uint8_t *g, uint8_t *b, glint_error *err)
{
    uint8_t *const colors[] = {[GLINT_ANSWER_R] = r, [GLINT_ANSWER_G] = g, [GLINT_ANSWER_B] = b};
    const glint_status status =
        __real_glint_rtl_batch(rtl, material, cos_code, count, w_code, r, g, b, err);
    const long at = place_in(count);
    if (at >= 0 && plant.value != GLINT_ANSWER_W)
        colors[plant.value][at] ^= 1;
    else if (at >= 0 && w_code != NULL)
        w_code[at] ^= 1;
    return status;
}

glint_status __wrap_glint_divider_rtl_batch(glint_divider_rtl *rtl, const glint_division *divisions,
                                            size_t count, glint_quotients *quotients,
                                            glint_error *err)
{
    const glint_status status =
        __real_glint_divider_rtl_batch(rtl, divisions, count, quotients, err);
    const long at = place_in(count);
    if (at >= 0)
        quotients[at].code[plant.value - GLINT_ANSWER_R] ^= 1;
    return status;
}

/* ---- In the command -----------------------------------------------------------------------------
 */

static uint64_t clock_named;

static uint64_t lowest_bit_once(uint64_t clock)
{
    return clock == clock_named;
}

static long named(const char *name)
{
    const char *given = getenv(name);
    return given != NULL ? strtol(given, NULL, 10) : PLANTED_NOWHERE;
}

__attribute__((constructor)) static void plant_what_is_named(void)
{
    clock_named = (uint64_t)named("GLINT_PLANTED_CLOCK");
    if (getenv("GLINT_PLANTED_SIGNAL") != NULL) {
        plant.signal = (int)named("GLINT_PLANTED_SIGNAL");
        plant.inverted = lowest_bit_once;
    }
    if (getenv("GLINT_PLANTED_ANSWER") != NULL) {
        plant.answer = named("GLINT_PLANTED_ANSWER");
        plant.value = (glint_answer_value)named("GLINT_PLANTED_VALUE");
    }
}
