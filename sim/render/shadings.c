/* The shadings' names and needs; see shadings.h. */
#include "render/shadings.h"

const char *const glint_shading_names[] = {
    [GLINT_SHADING_FLAT] = "flat",
    [GLINT_SHADING_GOURAUD] = "gouraud",
    [GLINT_SHADING_GOURAUD_PERSPECTIVE] = "gouraud-perspective",
    [GLINT_SHADING_QUADRATIC] = "quadratic",
    [GLINT_SHADING_QUADRATIC_LISTING] = "quadratic-listing",
    [GLINT_SHADING_PHONG] = "phong",
    [GLINT_SHADING_MIXED] = "mixed",
    [GLINT_SHADING_GOURAUD_4] = "gouraud-4",
    [GLINT_SHADING_COSINE_LINEAR] = "cosine-linear",
    [GLINT_SHADING_PHONG_UNNORMALISED] = "phong-unnormalised",
    [GLINT_SHADING_PHONG_NEWTON] = "phong-newton",
    [GLINT_SHADING_REFLECTION_MAP] = "reflection-map",
    [GLINT_SHADING_WIRES] = "wires",
    [GLINT_SHADING_NORMALS] = "normals",
    [GLINT_SHADING_COUNT] = NULL,
};

bool glint_shading_divides(glint_shading shading)
{
    return shading == GLINT_SHADING_GOURAUD || shading == GLINT_SHADING_GOURAUD_4 ||
           shading == GLINT_SHADING_MIXED;
}

bool glint_shading_lights_vertices(glint_shading shading)
{
    return glint_shading_divides(shading) || shading == GLINT_SHADING_GOURAUD_PERSPECTIVE;
}

glint_cosines glint_shading_cosines(glint_shading shading)
{
    switch (shading) {
    case GLINT_SHADING_COSINE_LINEAR:
        return GLINT_COSINES_LINEAR;
    case GLINT_SHADING_PHONG_UNNORMALISED:
        return GLINT_COSINES_UNNORMALISED;
    case GLINT_SHADING_PHONG_NEWTON:
        return GLINT_COSINES_NEWTON;
    default:
        return GLINT_COSINES_EXACT;
    }
}

bool glint_shading_uses_circuit(glint_shading shading)
{
    return shading != GLINT_SHADING_WIRES && shading != GLINT_SHADING_NORMALS;
}

/* Cheaper cosines are N·L and N·H. */
static bool takes_model(glint_shading shading, glint_reflectance_model model)
{
    const glint_reflectance_cosine cosine = glint_reflectance_describe(model)->cosine;
    return glint_shading_cosines(shading) == GLINT_COSINES_EXACT ||
           cosine == GLINT_REFLECTANCE_OF_NH || cosine == GLINT_REFLECTANCE_OF_NL;
}

glint_status glint_shading_check(const glint_scene *scene, glint_backend_kind kind,
                                 glint_error *err)
{
    const char *name = glint_shading_names[scene->shading];
    if (!glint_shading_uses_circuit(scene->shading) && kind != GLINT_BACKEND_REAL) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "shading %s needs backend real: nothing in it comes from a circuit",
                          name);
    }
    if (scene->by_model && !takes_model(scene->shading, scene->specular)) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "shading %s has N·L and N·H only, and model %s needs other cosines", name,
                          glint_reflectance_names[scene->specular]);
    }
    if (scene->isc && scene->shading != GLINT_SHADING_PHONG) {
        return glint_fail(
            err, GLINT_BAD_ARGUMENT,
            "ISC is for shading phong: %s does not compute a highlight for each pixel", name);
    }
    return GLINT_OK;
}
