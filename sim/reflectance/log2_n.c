/* cosⁿ by squaring alone: the power of two nearest to n, log2_n of the listing of the thesis's
 * appendix A. */
#include <math.h>

#include "reflectance/definition.h"

static double squared(const glint_reflectance *prepared, double cosine)
{
    double value = cosine;
    for (int i = 0; i < prepared->log2_n.squarings; i++)
        value *= value;
    return value;
}

static void prepare(const glint_reflectance_parameters *parameters, glint_reflectance *prepared)
{
    prepared->of_cosine = squared;
    prepared->log2_n.squarings = (int)floor(log2(parameters->n) + 0.5);
}

#define CHUNK 64

/* A squaring at a time over a chunk, so that compilers vectorise it; in double precision, as each
 * squaring doubles the relative error. */
static void batch(const glint_reflectance *prepared, const float *restrict cosine, size_t count,
                  float *restrict value)
{
    for (size_t first = 0; first < count; first += CHUNK) {
        const size_t left = count - first, size = left < CHUNK ? left : CHUNK;
        double held[CHUNK] = {0};
        for (size_t i = 0; i < size; i++)
            held[i] = (double)glint_held_cosine(cosine[first + i]);
        for (int k = 0; k < prepared->log2_n.squarings; k++)
            for (size_t i = 0; i < CHUNK; i++)
                held[i] *= held[i];
        for (size_t i = 0; i < size; i++)
            value[first + i] = (float)held[i];
    }
}

const glint_reflectance_definition glint_reflectance_log2_n = {
    .info = {.title = "by squaring",
             .equation = "",
             .formula = "c^(2^k), k = log2 n rounded",
             .edges = "n = 1: c itself; equal to Blinn's where n is a power of two",
             .cosine = GLINT_REFLECTANCE_OF_NH,
             .n_min = 1.0,
             .n_max = GLINT_EXPONENT_MAX},
    .prepare = prepare,
    .batch = batch,
};
