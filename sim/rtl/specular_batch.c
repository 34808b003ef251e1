/* Points through a highlight unit: checks them and calls the loop that is compiled into a fast
 * circuit (specular_batch.cpp).
 */
#include "glint_specular_device.h"
#include "rtl/batch.h"

#define NAME_OF(symbol) #symbol
#define TEXT_OF(symbol) NAME_OF(symbol)

/* Looked up once; NULL if the circuit has none. */
static glint_shade_function *shade_function(glint_rtl *rtl)
{
    glint_shade_function *const **noted = glint_rtl_notes(rtl);
    if (*noted == NULL)
        *noted = glint_rtl_symbol(rtl, TEXT_OF(GLINT_SHADE_SYMBOL));
    return *noted != NULL ? **noted : NULL;
}

glint_status glint_rtl_shade(glint_rtl *rtl, const glint_material *material,
                             const glint_points *points, glint_error *err)
{
    glint_shade_function *const shade = shade_function(rtl);
    if (shade == NULL)
        return glint_fail(err, GLINT_DEVICE_FAULT,
                          "the circuit is not the fast build of a highlight unit");
    if (material->n > GLINT_N_MAX)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "n = %u is outside 0…%u", material->n,
                          GLINT_N_MAX);
    const size_t done =
        shade(glint_rtl_instance(rtl), material->n, material->r, material->g, material->b, points);
    if (done != points->count)
        return glint_fail(err, GLINT_DEVICE_FAULT, "the circuit returned %zu of %zu results", done,
                          points->count);
    return GLINT_OK;
}
