/* Largest errors by search; see accuracy.h. Places are given by u = 1 − c: all of a highlight lies
 * within some tens of 1/n of u = 0. */
#include "reflectance/accuracy.h"

#include <math.h>

#include "reflectance/search.h"

/* Beyond u = FAR/n cosⁿ is below e^-FAR. */
#define FAR          40.0
#define SAMPLES_NEAR 4096
#define SAMPLES_FAR  1024

static double exact(const glint_reflectance *prepared, double u)
{
    return exp(prepared->n * log1p(-u));
}

static double absolute_error(const void *context, double u)
{
    const glint_reflectance *prepared = context;
    return fabs(glint_reflectance_of_cosine(prepared, 1.0 - u) - exact(prepared, u));
}

static double relative_error(const void *context, double u)
{
    return absolute_error(context, u) / exact(context, u);
}

static glint_largest_error largest(glint_search_function error, const glint_reflectance *prepared,
                                   double from, double to, int samples)
{
    double at;
    const double found = glint_search_maximum(error, prepared, from, to, samples, &at);
    return (glint_largest_error){found, 1.0 - at};
}

glint_status glint_accuracy_measure(const glint_reflectance *prepared, double level,
                                    glint_accuracy *accuracy, glint_error *err)
{
    const glint_reflectance_info *info = glint_reflectance_describe(prepared->model);
    if (info->cosine == GLINT_REFLECTANCE_OF_NL || info->cosine == GLINT_REFLECTANCE_OF_GEOMETRY) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "model %s does not approximate a power of the cosine",
                          glint_reflectance_names[prepared->model]);
    }
    if (!(prepared->n > 0.0) || !(level > 0.0 && level < 1.0)) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "n = %g must be above 0, and the level %g between 0 and 1", prepared->n,
                          level);
    }
    const double edge = -expm1(log(level) / prepared->n);
    const double near = fmin(1.0, FAR / prepared->n);
    accuracy->absolute = largest(absolute_error, prepared, 0.0, near, SAMPLES_NEAR);
    if (near < 1.0) {
        const glint_largest_error far = largest(absolute_error, prepared, near, 1.0, SAMPLES_FAR);
        accuracy->absolute = far.error > accuracy->absolute.error ? far : accuracy->absolute;
    }
    accuracy->epicentre_absolute = largest(absolute_error, prepared, 0.0, edge, SAMPLES_NEAR);
    accuracy->epicentre_relative = largest(relative_error, prepared, 0.0, edge, SAMPLES_NEAR);
    return GLINT_OK;
}
