/* Long runs of points through the power device: its blocks in loops that a compiler vectorises, one
 * for each accuracy. */
#include "glint_power.h"
#include "multiversion.h"
#include "power_blocks.h"
#include "power_tables.h"

/* W of one point; inlined with a constant accuracy. */
static inline __attribute__((always_inline)) uint32_t shade_w(glint_power_accuracy accuracy,
                                                              uint32_t n, uint32_t cos_code)
{
    const int table = GLINT_POWER_TABLE_BITS(accuracy);
    const uint32_t x = glint_power_block_x(cos_code);
    const uint32_t p = glint_power_block_mul7(n, x);
    const uint32_t g = glint_power_table9[accuracy][glint_power_block_address9(table, x)];
    const uint32_t v = glint_power_block_mul10(glint_power_block_q(p), g);
    const uint32_t pass = glint_power_block_cmp11(table, glint_power_block_over7(p), v);
    const uint32_t power = glint_power_table33[accuracy][glint_power_block_address33(table, v)];
    return glint_power_block_keys12(table, pass, power, v);
}

#define WS(name, accuracy)                                                                         \
    GLINT_MULTIVERSION                                                                             \
    static void ws_##name(uint32_t n, const uint32_t *restrict cos_code, size_t count,             \
                          uint32_t *restrict w_code)                                               \
    {                                                                                              \
        for (size_t i = 0; i < count; i++)                                                         \
            w_code[i] = shade_w(accuracy, n, cos_code[i]);                                         \
    }

WS(half, GLINT_POWER_HALF)
WS(quarter, GLINT_POWER_QUARTER)

void glint_power_ws(int variant, uint32_t n, const uint32_t *cos_code, size_t count,
                    uint32_t *w_code)
{
    if (variant == GLINT_POWER_HALF)
        ws_half(n, cos_code, count, w_code);
    else
        ws_quarter(n, cos_code, count, w_code);
}

glint_status glint_power_batch(glint_power_accuracy accuracy, const glint_material *material,
                               const uint32_t *restrict cos_code, size_t count,
                               uint32_t *restrict w_code, uint8_t *restrict r, uint8_t *restrict g,
                               uint8_t *restrict b)
{
    const glint_unit_config config = {.unit = &glint_unit_power, .variant = (int)accuracy};
    return glint_unit_batch(&config, material, cos_code, count, w_code, r, g, b);
}
