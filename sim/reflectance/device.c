/* The fixed-point specular device as one more model: its W, rounding and all. */
#include "glint_specular.h"
#include "reflectance/definition.h"

static const uint8_t white = GLINT_COLOR_MAX;

static glint_material material_of(const glint_reflectance *prepared)
{
    return (glint_material){.n = (uint16_t)prepared->n, .r = white, .g = white, .b = white};
}

static double device(const glint_reflectance *prepared, double cosine)
{
    const glint_material material = material_of(prepared);
    glint_specular_values values = {0};
    glint_specular_eval(GLINT_GATE_COSINE, &material, glint_cos_code(cosine), &values);
    return (double)values.keys12 / GLINT_W_ONE;
}

static void prepare_device(const glint_reflectance_parameters *parameters,
                           glint_reflectance *prepared)
{
    (void)parameters;
    prepared->of_cosine = device;
}

#define CHUNK 512

static void batch_device(const glint_reflectance *prepared, const float *restrict cosine,
                         size_t count, float *restrict value)
{
    const glint_material material = material_of(prepared);
    uint32_t code[CHUNK], w[CHUNK];
    uint8_t r[CHUNK], g[CHUNK], b[CHUNK];
    for (size_t first = 0; first < count; first += CHUNK) {
        const size_t length = count - first < CHUNK ? count - first : CHUNK;
        for (size_t i = 0; i < length; i++)
            code[i] = glint_cos_code((double)cosine[first + i]);
        glint_specular_batch(GLINT_GATE_COSINE, &material, code, length, w, r, g, b);
        for (size_t i = 0; i < length; i++)
            value[first + i] = (float)w[i] / (float)GLINT_W_ONE;
    }
}

const glint_reflectance_definition glint_reflectance_device = {
    .info = {.title = "the fixed-point device, gate cosine",
             .equation = "(2.15), figure 3.1",
             .formula = "((n+1)/3 (c−1) + 1)², c and every step rounded",
             .edges = "as cosine-quadratic, for the whole n that register 2 holds",
             .cosine = GLINT_REFLECTANCE_OF_NH,
             .n_max = GLINT_N_MAX,
             .whole_n = true},
    .prepare = prepare_device,
    .batch = batch_device,
};
