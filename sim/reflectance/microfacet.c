/* Torrance–Sparrow's and Cook–Torrance's: FDG (1.4), alike but for the distribution D.
 *
 * D counts facets per steradian with ∫ D cos α dω = 1 over the hemisphere, so that the BRDF is
 * FDG / (4 (N·L)(N·V)). The D of (1.4), which has no 4 and no π, is π/4 of this one. */
#include <math.h>

#include "reflectance/definition.h"

#define PI 3.14159265358979323846

/* Unpolarised light on a plane boundary, as a function of the cosine of incidence. */
static double fresnel(double refraction, double c)
{
    if (isinf(refraction))
        return 1.0;
    const double g = sqrt(refraction * refraction - 1.0 + c * c);
    const double s = (g - c) / (g + c);
    const double p = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
    return 0.5 * s * s * (1.0 + p * p);
}

static double refraction_of(double f0)
{
    const double root = sqrt(f0);
    return (1.0 + root) / (1.0 - root);
}

/* The share of a facet that its V-shaped neighbours neither shadow nor mask, divided by
 * (N·L)(N·V): a quotient that stays finite when one of the two goes to 0. */
static double shown_facets(const glint_geometry *g)
{
    const double larger = fmax(g->nl, g->nv), smaller = fmin(g->nl, g->nv);
    const double limit = 2.0 * g->nh * smaller;
    return limit < g->vh ? 2.0 * g->nh / (g->vh * larger) : 1.0 / (larger * smaller);
}

static double brdf_of(const glint_reflectance *prepared, const glint_geometry *g, double facets)
{
    const double cosine = fmin(fmax(g->vh, 0.0), 1.0);
    return 0.25 * fresnel(prepared->microfacet.refraction, cosine) * facets * shown_facets(g);
}

static void prepare_common(const glint_reflectance_parameters *parameters,
                           glint_reflectance *prepared)
{
    const double m = glint_roughness_of_exponent(parameters->n);
    prepared->microfacet.m2 = m * m;
    prepared->microfacet.refraction = refraction_of(parameters->f0);
}

/* ---- Torrance–Sparrow: a Gaussian of the angle ------------------------------------------------
 */

/* Beyond this many m the Gaussian is below 1e-27 of its centre. */
#define GAUSS_WIDTH 8.0
#define INTERVALS   4096

/* By Simpson's rule. */
double glint_gaussian_facets(double m)
{
    const double end = fmin(0.5 * PI, GAUSS_WIDTH * m);
    const double step = end / INTERVALS;
    double sum = 0.0;
    for (int i = 0; i <= INTERVALS; i++) {
        const double angle = i * step;
        const double weight = i == 0 || i == INTERVALS ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        sum += weight * exp(-angle * angle / (m * m)) * sin(2.0 * angle); /* 2 cos α sin α */
    }
    return 1.0 / (PI * sum * step / 3.0);
}

static void prepare_torrance_sparrow(const glint_reflectance_parameters *parameters,
                                     glint_reflectance *prepared)
{
    prepare_common(parameters, prepared);
    prepared->microfacet.facets = glint_gaussian_facets(sqrt(prepared->microfacet.m2));
}

static double torrance_sparrow_brdf(const glint_reflectance *prepared, const glint_geometry *g)
{
    const double angle = acos(fmin(fmax(g->nh, 0.0), 1.0));
    return brdf_of(prepared, g,
                   prepared->microfacet.facets * exp(-angle * angle / prepared->microfacet.m2));
}

/* ---- Cook–Torrance: Beckmann's distribution ---------------------------------------------------
 */

static void prepare_cook_torrance(const glint_reflectance_parameters *parameters,
                                  glint_reflectance *prepared)
{
    prepare_common(parameters, prepared);
    prepared->microfacet.facets = 1.0 / (PI * prepared->microfacet.m2);
}

static double cook_torrance_brdf(const glint_reflectance *prepared, const glint_geometry *g)
{
    const double cos2 = fmin(g->nh * g->nh, 1.0);
    const double tan2 = (1.0 - cos2) / cos2;
    return brdf_of(prepared, g,
                   prepared->microfacet.facets * exp(-tan2 / prepared->microfacet.m2) /
                       (cos2 * cos2));
}

static const char edges[] =
    "m = √(2/(n+2)); F0 = 1 is a mirror, F = 1; grows without limit only where N·L and N·V both "
    "go to 0";

const glint_reflectance_definition glint_reflectance_torrance_sparrow = {
    .info = {.title = "Torrance–Sparrow's, Gaussian facets",
             .equation = "(1.4)",
             .formula = "FDG/(4(N·L)(N·V)), D ~ e^(−α²/m²)",
             .edges = edges,
             .cosine = GLINT_REFLECTANCE_OF_GEOMETRY,
             .n_max = GLINT_EXPONENT_MAX},
    .prepare = prepare_torrance_sparrow,
    .brdf = torrance_sparrow_brdf,
};

const glint_reflectance_definition glint_reflectance_cook_torrance = {
    .info = {.title = "Cook–Torrance's, Beckmann's facets",
             .equation = "(1.3), (1.4)",
             .formula = "FDG/(4(N·L)(N·V)), D = e^(−tan²α/m²)/(πm² cos⁴α)",
             .edges = edges,
             .cosine = GLINT_REFLECTANCE_OF_GEOMETRY,
             .n_max = GLINT_EXPONENT_MAX},
    .prepare = prepare_cook_torrance,
    .brdf = cook_torrance_brdf,
};
