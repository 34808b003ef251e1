/* The models by number and by name, and the code they share; see reflectance.h. */
#include "reflectance/reflectance.h"

#include <math.h>
#include <string.h>

#include "reflectance/definition.h"

#define PI 3.14159265358979323846

#define UNIT_TOLERANCE 1e-6

static const glint_reflectance_definition *const definitions[] = {
#define DEFINITION(id, definition, name) [GLINT_REFLECTANCE_##id] = &glint_reflectance_##definition,
    GLINT_REFLECTANCE_MODELS(DEFINITION)
#undef DEFINITION
};

const char *const glint_reflectance_names[] = {
#define NAME(id, definition, name) [GLINT_REFLECTANCE_##id] = name,
    GLINT_REFLECTANCE_MODELS(NAME)
#undef NAME
        [GLINT_REFLECTANCE_COUNT] = NULL,
};

const glint_reflectance_info *glint_reflectance_describe(glint_reflectance_model model)
{
    return (unsigned)model < GLINT_REFLECTANCE_COUNT ? &definitions[model]->info : NULL;
}

bool glint_reflectance_find(const char *name, glint_reflectance_model *model)
{
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++) {
        if (strcmp(name, glint_reflectance_names[i]) == 0) {
            *model = (glint_reflectance_model)i;
            return true;
        }
    }
    return false;
}

double glint_roughness_of_exponent(double n)
{
    return sqrt(2.0 / (n + 2.0));
}

double glint_exponent_of_roughness(double m)
{
    return 2.0 / (m * m) - 2.0;
}

/* of_cosine() for a model that is not a function of one cosine. */
static double no_lobe(const glint_reflectance *prepared, double cosine)
{
    (void)prepared;
    (void)cosine;
    return NAN;
}

static glint_status check_parameters(glint_reflectance_model model,
                                     const glint_reflectance_parameters *parameters,
                                     glint_error *err)
{
    const glint_reflectance_info *info = glint_reflectance_describe(model);
    if (info == NULL) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "unknown reflectance model number %d",
                          (int)model);
    }
    const char *name = glint_reflectance_names[model];
    if (!(parameters->n >= info->n_min && parameters->n <= info->n_max)) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "model %s: n = %g is outside %g…%g", name,
                          parameters->n, info->n_min, info->n_max);
    }
    if (info->whole_n && floor(parameters->n) != parameters->n) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "model %s: n = %g is not an integer", name,
                          parameters->n);
    }
    if (info->cosine == GLINT_REFLECTANCE_OF_GEOMETRY &&
        !(parameters->f0 >= 0.0 && parameters->f0 <= 1.0)) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "model %s: F0 = %g is outside 0…1", name,
                          parameters->f0);
    }
    return GLINT_OK;
}

glint_status glint_reflectance_prepare(glint_reflectance_model model,
                                       const glint_reflectance_parameters *parameters,
                                       glint_reflectance *prepared, glint_error *err)
{
    const glint_status status = check_parameters(model, parameters, err);
    if (status != GLINT_OK)
        return status;
    *prepared = (glint_reflectance){.model = model, .n = parameters->n, .of_cosine = no_lobe};
    definitions[model]->prepare(parameters, prepared);
    return GLINT_OK;
}

void glint_reflectance_batch(const glint_reflectance *prepared, const float *restrict cosine,
                             size_t count, float *restrict value)
{
    const glint_reflectance_definition *definition = definitions[prepared->model];
    if (definition->batch != NULL) {
        definition->batch(prepared, cosine, count, value);
        return;
    }
    for (size_t i = 0; i < count; i++)
        value[i] = (float)glint_reflectance_of_cosine(prepared, (double)cosine[i]);
}

glint_status glint_reflectance_eval(glint_reflectance_model model, double n, double cosine,
                                    double *value, glint_error *err)
{
    glint_reflectance prepared;
    const glint_reflectance_parameters parameters = {.n = n, .f0 = GLINT_F0_DEFAULT};
    const glint_status status = glint_reflectance_prepare(model, &parameters, &prepared, err);
    if (status != GLINT_OK)
        return status;
    if (definitions[model]->info.cosine == GLINT_REFLECTANCE_OF_GEOMETRY) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "model %s is not a function of one cosine: it needs directions",
                          glint_reflectance_names[model]);
    }
    if (!(cosine >= 0.0 && cosine <= 1.0)) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "model %s: the cosine %g is outside 0…1",
                          glint_reflectance_names[model], cosine);
    }
    *value = glint_reflectance_of_cosine(&prepared, cosine);
    return GLINT_OK;
}

static bool is_unit(glint_vec3 v)
{
    return fabs(glint_vec3_length(v) - 1.0) <= UNIT_TOLERANCE;
}

glint_status glint_geometry_of(glint_vec3 normal, glint_vec3 light, glint_vec3 viewer,
                               glint_geometry *geometry, glint_error *err)
{
    if (!is_unit(normal) || !is_unit(light) || !is_unit(viewer))
        return glint_fail(err, GLINT_BAD_ARGUMENT, "N, L or V does not have unit length");
    const glint_vec3 sum = glint_vec3_add(light, viewer);
    const double length = glint_vec3_length(sum);
    if (length <= UNIT_TOLERANCE)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "L is opposite to V, so H is undefined");
    const double nl = glint_vec3_dot(normal, light);
    const double nv = glint_vec3_dot(normal, viewer);
    *geometry = (glint_geometry){
        .nl = nl,
        .nv = nv,
        .nh = (nl + nv) / length,
        .rv = 2.0 * nl * nv - glint_vec3_dot(light, viewer),
        .vh = 0.5 * length, /* V·(L+V)/|L+V|, as |L+V|² = 2(1 + L·V) */
    };
    return GLINT_OK;
}

static double lobe(const glint_reflectance *prepared, const glint_geometry *geometry)
{
    const bool of_rv = definitions[prepared->model]->info.cosine == GLINT_REFLECTANCE_OF_RV;
    return glint_reflectance_of_cosine(prepared, of_rv ? geometry->rv : geometry->nh);
}

double glint_reflectance_brdf(const glint_reflectance *prepared, const glint_geometry *geometry)
{
    if (!(geometry->nl > 0.0 && geometry->nv > 0.0))
        return 0.0;
    const glint_reflectance_definition *definition = definitions[prepared->model];
    return definition->brdf != NULL ? definition->brdf(prepared, geometry)
                                    : lobe(prepared, geometry);
}

double glint_reflectance_intensity(const glint_reflectance *prepared,
                                   const glint_geometry *geometry)
{
    const double brdf = glint_reflectance_brdf(prepared, geometry);
    return definitions[prepared->model]->brdf != NULL ? PI * brdf * geometry->nl : brdf;
}
