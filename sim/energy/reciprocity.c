/* Swaps viewer and light at random and on a grid that includes grazing angles, and keeps the
 * largest difference. */
#include "energy/reciprocity.h"

#include <math.h>

#include "circuit/random.h"

#define PI 3.14159265358979323846

static const glint_vec3 normal = {0.0, 0.0, 1.0};

/* The grid: polar angles in degrees, and as many azimuths. */
static const double polar[] = {0.0, 1e-3, 1.0, 15.0, 30.0, 45.0, 60.0, 75.0, 89.0, 89.999};

#define POLAR    ((int)(sizeof polar / sizeof polar[0]))
#define AZIMUTHS 12

/* How far V is drawn from the mirrored L, at most, along each axis. */
#define NEAR 0.1

static glint_vec3 direction(double angle, double turn)
{
    return (glint_vec3){sin(angle) * cos(turn), sin(angle) * sin(turn), cos(angle)};
}

typedef struct measure {
    glint_brdf *f;
    const void *context;
    glint_reciprocity *result;
} measure;

static void compare(const measure *of, glint_vec3 light, glint_vec3 viewer)
{
    glint_geometry there, back;
    if (glint_geometry_of(normal, light, viewer, &there, NULL) != GLINT_OK ||
        glint_geometry_of(normal, viewer, light, &back, NULL) != GLINT_OK)
        return;
    glint_reciprocity *result = of->result;
    const double f = of->f(of->context, &there);
    const double g = of->f(of->context, &back);
    const double larger = fmax(f, g);
    const double difference = larger > 0.0 ? fabs(f - g) / larger : 0.0;
    result->pairs++;
    result->dark += larger == 0.0;
    if (difference > result->largest) {
        result->largest = difference;
        result->light = light;
        result->viewer = viewer;
    }
}

static double uniform(glint_random *random)
{
    return (double)(glint_random_bits(random) >> 11) * 0x1p-53;
}

static glint_vec3 draw(glint_random *random)
{
    const double c = 1.0 - uniform(random);
    return direction(acos(c), 2.0 * PI * uniform(random));
}

/* Near the mirrored direction, above the surface. */
static glint_vec3 draw_near(glint_random *random, glint_vec3 light)
{
    glint_vec3 v = {-light.x + NEAR * (2.0 * uniform(random) - 1.0),
                    -light.y + NEAR * (2.0 * uniform(random) - 1.0),
                    fabs(light.z + NEAR * (2.0 * uniform(random) - 1.0))};
    return glint_vec3_scale(v, 1.0 / glint_vec3_length(v));
}

static void compare_grid(const measure *of)
{
    for (int i = 0; i < POLAR; i++)
        for (int j = 0; j < POLAR; j++)
            for (int k = 0; k < AZIMUTHS; k++)
                compare(of, direction(polar[i] * PI / 180.0, 0.0),
                        direction(polar[j] * PI / 180.0, 2.0 * PI * k / AZIMUTHS));
}

double glint_reciprocity_of_model(const void *reflectance, const glint_geometry *geometry)
{
    return glint_reflectance_brdf(reflectance, geometry);
}

void glint_reciprocity_measure(glint_brdf *f, const void *context, uint64_t pairs, uint64_t seed,
                               glint_reciprocity *result)
{
    const measure of = {f, context, result};
    glint_random random = {seed};
    *result = (glint_reciprocity){0};
    for (uint64_t i = 0; i < pairs; i++) {
        const glint_vec3 light = draw(&random);
        compare(&of, light, i % 2 == 0 ? draw(&random) : draw_near(&random, light));
    }
    compare_grid(&of);
}
