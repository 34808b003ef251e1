/* Long runs of points through a highlight unit: its own W, and multipliers 13 to 15. */
#include "blocks.h"
#include "glint_unit.h"
#include "multiversion.h"
#include "unit_range.h"

/* Points whose W is computed before their colours: few enough to stay in the first cache. */
enum { PART = 512 };

GLINT_MULTIVERSION
static void multiply(int w_frac_bits, const uint32_t *restrict w, size_t count, uint8_t color,
                     uint8_t *restrict out)
{
    for (size_t i = 0; i < count; i++)
        out[i] = glint_block_mul_by(w_frac_bits, w[i], color);
}

GLINT_MULTIVERSION
static void round_off(int w_drop, uint32_t *w, size_t count)
{
    for (size_t i = 0; i < count; i++)
        w[i] = glint_block_round_w(w_drop, w[i]);
}

glint_status glint_unit_batch(const glint_unit_config *config, const glint_material *material,
                              const uint32_t *cos_code, size_t count, uint32_t *w_code, uint8_t *r,
                              uint8_t *g, uint8_t *b)
{
    if (!glint_unit_is_in_range(config) || material->n > GLINT_N_MAX)
        return GLINT_BAD_ARGUMENT;
    const int w_frac_bits = glint_unit_w_frac_bits(config);
    uint32_t own[PART];
    for (size_t at = 0; at < count; at += PART) {
        const size_t part = count - at < PART ? count - at : PART;
        uint32_t *w = w_code != NULL ? w_code + at : own;
        config->unit->ws(config->variant, material->n, cos_code + at, part, w);
        if (config->w_drop > 0)
            round_off(config->w_drop, w, part);
        multiply(w_frac_bits, w, part, material->r, r + at);
        multiply(w_frac_bits, w, part, material->g, g + at);
        multiply(w_frac_bits, w, part, material->b, b + at);
    }
    return GLINT_OK;
}
