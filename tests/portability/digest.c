/* The digests of the C model: see digest.h. */
#include "digest.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "glint_divider.h"
#include "glint_specular_device.h"

static glint_material material_of(uint32_t n)
{
    return (glint_material){.n = (uint16_t)n,
                            .r = portability_color(n, 0),
                            .g = portability_color(n, 1),
                            .b = portability_color(n, 2)};
}

/* A model that does not answer has a digest like no other. */
static uint64_t failed(void)
{
    return 0;
}

static uint64_t of_eval(glint_gate gate, uint32_t n, uint64_t digest)
{
    const glint_material material = material_of(n);
    for (int i = 0; i < PORTABILITY_CODES; i++) {
        glint_specular_values v;
        if (glint_specular_eval(gate, &material, portability_code(i), &v) != GLINT_OK)
            return failed();
        digest = portability_take_point(digest, (uint32_t)v.keys12, (uint8_t)v.mul13,
                                        (uint8_t)v.mul14, (uint8_t)v.mul15);
    }
    return digest;
}

static uint64_t of_batch(glint_gate gate, uint32_t n, uint64_t digest)
{
    static uint32_t codes[PORTABILITY_CODES], w[PORTABILITY_CODES];
    static uint8_t r[PORTABILITY_CODES], g[PORTABILITY_CODES], b[PORTABILITY_CODES];
    const glint_material material = material_of(n);
    for (int i = 0; i < PORTABILITY_CODES; i++)
        codes[i] = portability_code(i);
    if (glint_specular_batch(gate, &material, codes, PORTABILITY_CODES, w, r, g, b) != GLINT_OK)
        return failed();
    for (int i = 0; i < PORTABILITY_CODES; i++)
        digest = portability_take_point(digest, w[i], r[i], g[i], b[i]);
    return digest;
}

static uint64_t take_outputs(const glint_specular_signals *signals, int *left, uint64_t digest)
{
    for (int i = 0; i < GLINT_LANES_MAX && (signals->out_valid >> i & 1) != 0; i++) {
        const glint_specular_lane *lane = &signals->lane[i];
        digest = portability_take_point(digest, (uint32_t)lane->out_w, (uint8_t)lane->out_r,
                                        (uint8_t)lane->out_g, (uint8_t)lane->out_b);
        (*left)--;
    }
    return digest;
}

/* A point a lane each clock, until all are out. */
static uint64_t of_device(glint_gate gate, uint32_t n, uint64_t digest)
{
    const glint_specular_config config = {gate, GLINT_PIPELINE_PIPELINED, GLINT_LANES_MAX};
    const glint_material material = material_of(n);
    glint_specular_device *device;
    int given = 0, left = PORTABILITY_CODES;
    if (glint_specular_device_create(&config, &device) != GLINT_OK)
        return failed();
    while (left > 0) {
        glint_specular_inputs inputs = {.en = 1,
                                        .n_we = given == 0,
                                        .n = material.n,
                                        .rgb_we = given == 0,
                                        .r = material.r,
                                        .g = material.g,
                                        .b = material.b};
        for (int i = 0; i < GLINT_LANES_MAX && given < PORTABILITY_CODES; i++) {
            inputs.in_valid |= UINT32_C(1) << i;
            inputs.cos[i] = portability_code(given++);
        }
        glint_specular_device_clock(device, &inputs);
        digest = take_outputs(glint_specular_device_signals(device), &left, digest);
    }
    glint_specular_device_destroy(device);
    return digest;
}

/* The bits of the doubles: no machine may round them in its own way. */
static uint64_t of_real(glint_gate gate, uint32_t n, uint64_t digest)
{
    for (int i = 0; i < PORTABILITY_CODES; i++) {
        const double w = glint_specular_real(gate, n, portability_code(i));
        uint64_t bits;
        memcpy(&bits, &w, sizeof bits);
        digest = portability_take(digest, bits, 8);
        digest = portability_take(digest, glint_cos_code(w), 4);
    }
    return digest;
}

static uint64_t over_points(uint64_t (*of)(glint_gate gate, uint32_t n, uint64_t digest))
{
    static const glint_gate gates[] = {GLINT_GATE_COSINE, GLINT_GATE_SIGN, GLINT_GATE_DRAWN};
    uint64_t digest = PORTABILITY_DIGEST_START;
    for (int g = 0; g < 3; g++)
        for (int i = 0; i < PORTABILITY_EXPONENTS; i++)
            digest = of(gates[g], portability_exponent(i), digest);
    return digest;
}

static uint64_t of_divide(int shifts, uint32_t k, uint64_t digest)
{
    for (int i = 0; i < PORTABILITY_DIFFERENCES; i++) {
        int32_t quotient;
        bool out_of_table;
        if (glint_divide(shifts, i - GLINT_DIVIDER_DIFFERENCE_MAX, k, &quotient, &out_of_table) !=
            GLINT_OK)
            return failed();
        digest = portability_take(digest, (uint32_t)quotient, 4);
    }
    return digest;
}

static uint64_t of_divide_batch(int shifts, uint32_t k, uint64_t digest)
{
    static glint_division divisions[PORTABILITY_DIFFERENCES];
    static glint_quotients quotients[PORTABILITY_DIFFERENCES];
    for (int i = 0; i < PORTABILITY_DIFFERENCES; i++) {
        const int16_t difference = (int16_t)(i - GLINT_DIVIDER_DIFFERENCE_MAX);
        divisions[i] = (glint_division){{difference, (int16_t)-difference, 0}, (uint8_t)k};
    }
    if (glint_divide_batch(shifts, divisions, PORTABILITY_DIFFERENCES, quotients) != GLINT_OK)
        return failed();
    for (int i = 0; i < PORTABILITY_DIFFERENCES; i++)
        digest = portability_take(digest, (uint32_t)quotients[i].code[0], 4);
    return digest;
}

static uint64_t over_divisions(uint64_t (*of)(int shifts, uint32_t k, uint64_t digest))
{
    uint64_t digest = PORTABILITY_DIGEST_START;
    for (int shifts = GLINT_DIVIDER_SHIFTS_MIN; shifts <= GLINT_DIVIDER_SHIFTS_MAX; shifts++)
        for (uint32_t k = 1; k <= GLINT_DIVIDER_K_MAX; k++)
            digest = of(shifts, k, digest);
    return digest;
}

void portability_print(FILE *out)
{
    (void)fprintf(out, "specular %016" PRIx64 "\n", over_points(of_eval));
    (void)fprintf(out, "specular-batch %016" PRIx64 "\n", over_points(of_batch));
    (void)fprintf(out, "specular-device %016" PRIx64 "\n", over_points(of_device));
    (void)fprintf(out, "divider %016" PRIx64 "\n", over_divisions(of_divide));
    (void)fprintf(out, "divider-batch %016" PRIx64 "\n", over_divisions(of_divide_batch));
    (void)fprintf(out, "real %016" PRIx64 "\n", over_points(of_real));
}
