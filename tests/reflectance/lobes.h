/* What several tests of the models share. Include it after cmocka.h. */
#ifndef GLINT_TESTS_REFLECTANCE_LOBES_H
#define GLINT_TESTS_REFLECTANCE_LOBES_H

#include "reflectance/reflectance.h"

static inline glint_reflectance prepared(glint_reflectance_model model, double n)
{
    glint_reflectance r;
    glint_error err;
    const glint_reflectance_parameters parameters = {.n = n, .f0 = GLINT_F0_DEFAULT};
    if (glint_reflectance_prepare(model, &parameters, &r, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    return r;
}

static inline bool is_lobe(int model)
{
    const glint_reflectance_info *info = glint_reflectance_describe((glint_reflectance_model)model);
    return info->cosine != GLINT_REFLECTANCE_OF_GEOMETRY;
}

/* A lobe that approximates cosⁿ: 1 at its centre. */
static inline bool is_plain_lobe(int model)
{
    return is_lobe(model) && model != GLINT_REFLECTANCE_LAMBERT &&
           model != GLINT_REFLECTANCE_BLINN_NORMALIZED &&
           model != GLINT_REFLECTANCE_ENERGY_CONSERVING;
}

static inline bool takes(int model, double n)
{
    const glint_reflectance_info *info = glint_reflectance_describe((glint_reflectance_model)model);
    return n >= info->n_min && n <= info->n_max && (!info->whole_n || n == (double)(int)n);
}

#endif
