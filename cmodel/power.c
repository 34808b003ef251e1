/* One point through the power device, block after block. */
#include "glint_power.h"

#include <math.h>

#include "power_blocks.h"
#include "power_tables.h"

uint32_t glint_power_rom9(glint_power_accuracy accuracy, uint32_t address)
{
    const int bits = GLINT_POWER_TABLE_BITS(accuracy);
    return glint_power_table9[accuracy][address & ((1u << bits) - 1u)];
}

uint32_t glint_power_rom33(glint_power_accuracy accuracy, uint32_t address)
{
    const int bits = GLINT_POWER_TABLE_BITS(accuracy);
    return glint_power_table33[accuracy][address & ((1u << bits) - 1u)];
}

glint_status glint_power_eval(glint_power_accuracy accuracy, const glint_material *material,
                              uint32_t cos_code, glint_power_values *values)
{
    if ((unsigned)accuracy >= GLINT_POWER_ACCURACY_COUNT || material->n > GLINT_N_MAX ||
        cos_code > GLINT_COS_CODE_MAX)
        return GLINT_BAD_ARGUMENT;

    const int table = GLINT_POWER_TABLE_BITS(accuracy);
    const int w_frac = GLINT_POWER_W_FRAC_BITS(accuracy);
    glint_power_values v;
    v.reg1 = glint_power_block_x(cos_code);
    v.mul7 = glint_power_block_mul7(material->n, v.reg1);
    v.rom9 = glint_power_rom9(accuracy, glint_power_block_address9(table, v.reg1));
    v.mul10 = glint_power_block_mul10(glint_power_block_q(v.mul7), v.rom9);
    v.cmp11 = glint_power_block_cmp11(table, glint_power_block_over7(v.mul7), v.mul10);
    v.rom33 = glint_power_rom33(accuracy, glint_power_block_address33(table, v.mul10));
    v.keys12 = glint_power_block_keys12(table, v.cmp11, v.rom33, v.mul10);
    v.mul13 = glint_block_mul_by(w_frac, v.keys12, material->r);
    v.mul14 = glint_block_mul_by(w_frac, v.keys12, material->g);
    v.mul15 = glint_block_mul_by(w_frac, v.keys12, material->b);
    *values = v;
    return GLINT_OK;
}

double glint_power_real(uint32_t n, uint32_t cos_code)
{
    return pow((double)glint_block_saturate1(cos_code) / GLINT_COS_ONE, n);
}

const char *glint_power_accuracy_name(glint_power_accuracy accuracy)
{
    static const char *const names[GLINT_POWER_ACCURACY_COUNT] = {"half", "quarter"};
    return (unsigned)accuracy < GLINT_POWER_ACCURACY_COUNT ? names[accuracy] : NULL;
}
