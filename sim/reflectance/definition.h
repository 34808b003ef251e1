/* How the files of this folder describe their models to reflectance.c. */
#ifndef GLINT_SIM_REFLECTANCE_DEFINITION_H
#define GLINT_SIM_REFLECTANCE_DEFINITION_H

#include "reflectance/reflectance.h"

typedef struct glint_reflectance_definition {
    glint_reflectance_info info;
    /* Fills prepared->of_cosine and the union; the rest is already set. */
    void (*prepare)(const glint_reflectance_parameters *parameters, glint_reflectance *prepared);
    /* NULL: of_cosine() one by one. */
    void (*batch)(const glint_reflectance *prepared, const float *restrict cosine, size_t count,
                  float *restrict value);
    /* The BRDF where N·L > 0 and N·V > 0; NULL: the lobe. */
    double (*brdf)(const glint_reflectance *prepared, const glint_geometry *geometry);
} glint_reflectance_definition;

#define GLINT_REFLECTANCE_DEFINITION(id, definition, name)                                         \
    extern const glint_reflectance_definition glint_reflectance_##definition;
GLINT_REFLECTANCE_MODELS(GLINT_REFLECTANCE_DEFINITION)
#undef GLINT_REFLECTANCE_DEFINITION

/* A cosine held in 0…1, for the single-precision loops. */
static inline float glint_held_cosine(float cosine)
{
    const float above = cosine < 0.0f ? 0.0f : cosine;
    return above > 1.0f ? 1.0f : above;
}

#endif
