/* The thesis's statements about the curves' shapes, apart from their largest errors: in the zone of
 * decay, and above and below cosⁿ in the epicentre. Sampled evenly in the level of cosⁿ. */
#include <math.h>

#include "report/lobes.h"

#define LEVELS 512

/* How far a lobe is above and below cosⁿ between two levels of it; both not negative. */
typedef struct apart {
    double above, below;
} apart;

static void take(apart *apart, double difference)
{
    apart->above = fmax(apart->above, difference);
    apart->below = fmax(apart->below, -difference);
}

/* Over the exponents; relative: of cosⁿ. */
static glint_status measure(glint_reflectance_model model, const glint_exponents *exponents,
                            double from, double to, bool relative, apart *found, glint_error *err)
{
    *found = (apart){0};
    for (int i = 0; i < exponents->count; i++) {
        const glint_reflectance_parameters parameters = {.n = exponents->n[i],
                                                         .f0 = GLINT_F0_DEFAULT};
        glint_reflectance prepared;
        const glint_status status = glint_reflectance_prepare(model, &parameters, &prepared, err);
        if (status != GLINT_OK)
            return status;
        for (int j = 0; j <= LEVELS; j++) {
            const double level = from + (to - from) * j / LEVELS;
            const double cosine = pow(level, 1.0 / parameters.n);
            const double difference = glint_reflectance_of_cosine(&prepared, cosine) - level;
            take(found, relative ? difference / level : difference);
        }
    }
    return GLINT_OK;
}

/* The readings of the modification, against Schlick's function itself. */
static glint_status put_decay(const glint_exponents *exponents, glint_numbers *numbers,
                              glint_error *err)
{
    static const glint_reflectance_model models[] = {GLINT_REFLECTANCE_SCHLICK,
                                                     GLINT_REFLECTANCE_SCHLICK_MODIFIED,
                                                     GLINT_REFLECTANCE_SCHLICK_MODIFIED_ANGLE,
                                                     GLINT_REFLECTANCE_SCHLICK_MODIFIED_LINEAR,
                                                     GLINT_REFLECTANCE_SCHLICK_MODIFIED_SQUARED,
                                                     GLINT_REFLECTANCE_SCHLICK_MODIFIED_POWER};
    double schlick = 0.0, gain[2] = {NAN, NAN};
    for (size_t i = 0; i < sizeof models / sizeof models[0]; i++) {
        apart found;
        const glint_status status = measure(models[i], exponents, GLINT_DECAY_LEVEL,
                                            GLINT_EPICENTRE_LEVEL, false, &found, err);
        if (status != GLINT_OK)
            return status;
        const double error = fmax(found.above, found.below);
        glint_number_put(numbers, error, "lobes.%s.decay-absolute",
                         glint_reflectance_names[models[i]]);
        if (i == 0)
            schlick = error;
        else
            glint_number_widen(gain, schlick / error);
    }
    glint_number_put_range(numbers, gain[0], gain[1], "lobes.decay.gain");
    return GLINT_OK;
}

/* The quadratic is zero at c = (a−1)/a; for n = 1 and 2 it is cosⁿ itself. */
static void put_end_of_quadratic(const glint_exponents *exponents, glint_numbers *numbers)
{
    double level[2] = {NAN, NAN};
    for (int i = 0; i < exponents->count; i++) {
        const double n = exponents->n[i], a = glint_quadratic_a(n);
        if (n > 2.0)
            glint_number_widen(level, pow((a - 1.0) / a, n));
    }
    glint_number_put_range(numbers, level[0], level[1], "lobes.quadratic.end-level");
}

glint_status glint_shapes_put(const glint_lobes *lobes, glint_numbers *numbers, glint_error *err)
{
    apart schlick, quadratic;
    glint_status status = put_decay(&lobes->exponents, numbers, err);
    if (status == GLINT_OK)
        status = measure(GLINT_REFLECTANCE_SCHLICK, &lobes->exponents, GLINT_DECAY_LEVEL,
                         GLINT_DECAY_LEVEL, false, &schlick, err);
    if (status == GLINT_OK)
        status = measure(GLINT_REFLECTANCE_QUADRATIC, &lobes->exponents, GLINT_EPICENTRE_LEVEL, 1.0,
                         true, &quadratic, err);
    if (status != GLINT_OK)
        return status;
    glint_number_put(numbers, GLINT_DECAY_LEVEL + schlick.above, "lobes.schlick.at-end-of-decay");
    glint_number_put(numbers, quadratic.above, "lobes.quadratic.above");
    glint_number_put(numbers, quadratic.below, "lobes.quadratic.below");
    put_end_of_quadratic(&lobes->exponents, numbers);
    return GLINT_OK;
}
