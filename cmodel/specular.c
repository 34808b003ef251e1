/* One point through the specular device, block after block: the model read as a specification. */
#include "glint_specular.h"

#include <math.h>

#include "blocks.h"

glint_status glint_specular_eval(glint_gate gate, const glint_material *material, uint32_t cos_code,
                                 glint_specular_values *values)
{
    if ((unsigned)gate >= GLINT_GATE_COUNT || material->n > GLINT_N_MAX ||
        cos_code > GLINT_COS_CODE_MAX)
        return GLINT_BAD_ARGUMENT;

    glint_specular_values v;
    v.reg1 = glint_block_saturate1(cos_code);
    v.rom33 = glint_rom33(material->n);
    v.rom9 = glint_rom9(gate, material->n);
    v.adder6 = glint_block_adder6(v.reg1);
    v.mul7 = glint_block_mul7(v.rom33, v.adder6);
    v.adder8 = glint_block_adder8(v.mul7);
    v.mul10 = glint_block_mul10_gated(gate, v.adder8);
    v.sat10 = glint_block_sat10(gate, v.mul10);
    v.cmp11 = glint_block_cmp11(gate, v.rom9, v.reg1, v.adder8, v.mul10);
    v.keys12 = glint_block_keys12(v.cmp11, v.sat10);
    v.mul13 = glint_block_mul_color(v.keys12, material->r);
    v.mul14 = glint_block_mul_color(v.keys12, material->g);
    v.mul15 = glint_block_mul_color(v.keys12, material->b);
    *values = v;
    return GLINT_OK;
}

double glint_specular_real(glint_gate gate, uint32_t n, uint32_t cos_code)
{
    double cos_gamma = (double)glint_block_saturate1(cos_code) / GLINT_COS_ONE;
    double sigma = (n + 1.0) / 3.0;
    double t = sigma * (cos_gamma - 1.0) + 1.0;
    double w = t * t;
    if (gate == GLINT_GATE_DRAWN)
        return w < 0.5 / GLINT_COLOR_MAX ? 0.0 : fmin(w, 1.0);
    return t >= 0.0 ? w : 0.0;
}

uint32_t glint_cos_code(double cos_gamma)
{
    if (!(cos_gamma > 0.0))
        return 0;
    if (cos_gamma >= 1.0)
        return GLINT_COS_ONE;
    /* Adding 0.5 first would round the largest number below 0.5 up to 1. */
    double code = cos_gamma * GLINT_COS_ONE;
    double whole = floor(code);
    return (uint32_t)whole + (code - whole >= 0.5);
}
