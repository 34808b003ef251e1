/* The specular-colour device (thesis section 3.1, figure 3.1), bit-exact, as a pure function.
 *
 *     σ = (n+1)/3     t = σ·(cos γ − 1) + 1     W = t²     (R,G,B)out = W · (R,G,B)     (2.15)
 *
 * Here one point goes in and every block's value comes out; glint_specular_batch() is the same
 * function for long runs of points with one material, and glint_specular_device.h is the same
 * circuit clock by clock. All of them must agree bit for bit with rtl/specular_device.v;
 * docs/verified.md lists what has been compared. */
#ifndef GLINT_CMODEL_SPECULAR_H
#define GLINT_CMODEL_SPECULAR_H

#include <stddef.h>
#include <stdint.h>

#include "glint_formats.h"
#include "glint_status.h"

#ifdef __cplusplus
#define GLINT_RESTRICT __restrict__
extern "C" {
#else
#define GLINT_RESTRICT restrict
#endif

/* How a point outside the highlight is detected (docs/device.md, "The three gates"). */
typedef enum glint_gate {
    GLINT_GATE_COSINE, /* comparator 11: register 1 against the cosine limit in ROM 9 */
    GLINT_GATE_SIGN,   /* the sign of adder 8; ROM 9 is not needed */
    GLINT_GATE_DRAWN,  /* as in the figure: comparator 11 compares W, which also passes the back
                        * lobe */
    GLINT_GATE_COUNT
} glint_gate;

/* Where the registers go. */
typedef enum glint_pipeline {
    GLINT_PIPELINE_COMBINATIONAL, /* registers 1–5, then combinational: 1 clock */
    GLINT_PIPELINE_PIPELINED,     /* one point per clock, latency GLINT_LATENCY_PIPELINED */
    GLINT_PIPELINE_COUNT
} glint_pipeline;

/* The contents of registers 2 to 5. */
typedef struct glint_material {
    uint16_t n;      /* exponent, 0…1023 */
    uint8_t r, g, b; /* the highlight's colour, already multiplied by Ks */
} glint_material;

/* Every block's value for one point. Formats: glint_formats.h. */
typedef struct glint_specular_values {
    uint32_t reg1;  /* cos γ after saturation, U1.18 */
    uint32_t rom33; /* σ, U9.13 */
    uint32_t rom9;  /* gate cosine: limit of the cosine, U1.18; drawn: limit of W, U1.18; sign: 0 */
    int32_t adder6; /* cos γ − 1, S1.18 */
    int32_t mul7;   /* σ(cos γ − 1), S10.18 */
    int32_t adder8; /* t, S10.18 */
    uint64_t mul10; /* t², U1.18 (from t's low bits), or U17.18 with gate drawn */
    uint32_t sat10; /* gate drawn: the square, at most 1.0, U1.18; else the same as mul10 */
    uint32_t cmp11; /* 1: the key block passes the square */
    uint32_t keys12;             /* W, U1.18 */
    uint8_t mul13, mul14, mul15; /* W·R, W·G, W·B */
} glint_specular_values;

/* ROM 33: σ = (n+1)/3 as U9.13, rounded half up. n: 0…1023; only the ten low bits are used. */
uint32_t glint_rom33(uint32_t n);

/* ROM 9. Gate cosine: the smallest cosine code for which t, computed from the quantised σ with the
 * device's own rounding, is not negative; the true formula's limit is cos γ₀ = (n−2)/(n+1), and 0
 * for n ≤ 2. Gate drawn: GLINT_DRAWN_LIMIT for every n. Gate sign has no ROM 9 and gets 0. */
uint32_t glint_rom9(glint_gate gate, uint32_t n);

/* Computes one point: cos_code U1.18, 0…GLINT_COS_CODE_MAX (codes above 1.0 saturate).
 * GLINT_BAD_ARGUMENT when cos_code, material->n or gate is out of range. */
glint_status glint_specular_eval(glint_gate gate, const glint_material *material, uint32_t cos_code,
                                 glint_specular_values *values);

/* Computes count points with one material, bit-equal to glint_specular_eval().
 * cos_code: count codes U1.18, each 0…GLINT_COS_CODE_MAX. w_code (may be NULL), r, g, b: count
 * results each, W as U1.18 and the colours U8.0. The arrays may not overlap.
 * GLINT_BAD_ARGUMENT when material->n or gate is out of range (codes are not checked). */
glint_status glint_specular_batch(glint_gate gate, const glint_material *material,
                                  const uint32_t *GLINT_RESTRICT cos_code, size_t count,
                                  uint32_t *GLINT_RESTRICT w_code, uint8_t *GLINT_RESTRICT r,
                                  uint8_t *GLINT_RESTRICT g, uint8_t *GLINT_RESTRICT b);

/* The formula (2.15) in real numbers for the quantised cosine, without any rounding: returns W
 * within 0…1. Gates cosine and sign: t² where t ≥ 0, else 0. Gate drawn: t² where it is at least
 * half an 8-bit step, at most 1. The reference for measuring implementation errors. */
double glint_specular_real(glint_gate gate, uint32_t n, uint32_t cos_code);

/* The nearest U1.18 code of a real cosine, half up; values outside [0, 1] are clamped. */
uint32_t glint_cos_code(double cos_gamma);

#ifdef __cplusplus
}
#endif

#endif
