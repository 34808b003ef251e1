/* Importance sampling: a cosine distribution mixed with a narrow and a wide lobe; see
 * monte_carlo.h. */
#include "energy/monte_carlo.h"

#include <math.h>

#include "circuit/random.h"

#define PI 3.14159265358979323846

/* Shares of the samples: the rest is drawn from the lobe of exponent n. A lobe of √n is for models
 * with a long tail, which would otherwise hang on a few heavy samples. */
#define COSINE_SHARE 0.25
#define WIDE_SHARE   0.25

static const glint_vec3 normal = {0.0, 0.0, 1.0};

typedef struct sampler {
    const glint_reflectance *reflectance;
    glint_reflectance_cosine kind;
    glint_vec3 light, mirrored;
    double cosine_share, wide_share;
    double n, wide_n;
    glint_random random;
} sampler;

/* 0 ≤ x < 1, all 53 bits. */
static double uniform(glint_random *random)
{
    return (double)(glint_random_bits(random) >> 11) * 0x1p-53;
}

/* The direction at an angle, by its cosine, from Z, turned by φ. */
static glint_vec3 around_z(double c, double phi)
{
    const double s = sqrt(fmax(0.0, 1.0 - c * c));
    return (glint_vec3){s * cos(phi), s * sin(phi), c};
}

static glint_vec3 mirror(glint_vec3 v, glint_vec3 at)
{
    return glint_vec3_sub(glint_vec3_scale(at, 2.0 * glint_vec3_dot(at, v)), v);
}

/* Turns Z to the axis: mirrored at the middle of the two. The axis is in the plane of X and Z and
 * not −Z. */
static glint_vec3 around(glint_vec3 axis, glint_vec3 v)
{
    const glint_vec3 sum = glint_vec3_add(axis, normal);
    return mirror(v, glint_vec3_scale(sum, 1.0 / glint_vec3_length(sum)));
}

static glint_vec3 draw(sampler *from)
{
    const double which = uniform(&from->random), u = uniform(&from->random);
    const double phi = 2.0 * PI * uniform(&from->random);
    if (which < from->cosine_share)
        return around_z(sqrt(1.0 - u), phi);
    const double n = which < from->cosine_share + from->wide_share ? from->wide_n : from->n;
    const glint_vec3 lobe = around_z(pow(1.0 - u, 1.0 / (n + 1.0)), phi);
    return from->kind == GLINT_REFLECTANCE_OF_RV ? around(from->mirrored, lobe)
                                                 : mirror(from->light, lobe);
}

/* Of a direction at the cosine c from the axis of a lobe of exponent n, per steradian. */
static double lobe_density(double n, double c)
{
    return (n + 1.0) / (2.0 * PI) * pow(c, n);
}

/* Of V above the surface, per steradian. */
static double density(const sampler *from, const glint_geometry *g)
{
    const bool of_mirror = from->kind == GLINT_REFLECTANCE_OF_RV;
    const double c = of_mirror ? fmax(g->rv, 0.0) : g->nh;
    const double lobes = from->wide_share * lobe_density(from->wide_n, c) +
                         (1.0 - from->cosine_share - from->wide_share) * lobe_density(from->n, c);
    return from->cosine_share * g->nv / PI + (of_mirror ? lobes : lobes / (4.0 * g->vh));
}

/* What one V contributes; 0 below the surface. */
static double weigh(const sampler *from, glint_vec3 viewer)
{
    glint_geometry g;
    if (viewer.z <= 0.0 || glint_geometry_of(normal, from->light, viewer, &g, NULL) != GLINT_OK)
        return 0.0;
    return glint_reflectance_brdf(from->reflectance, &g) * g.nv / density(from, &g);
}

glint_estimate glint_monte_carlo_albedo(const glint_reflectance *reflectance, double angle,
                                        int samples, uint64_t seed)
{
    sampler from = {.reflectance = reflectance,
                    .kind = glint_reflectance_describe(reflectance->model)->cosine,
                    .light = {sin(angle), 0.0, cos(angle)},
                    .mirrored = {-sin(angle), 0.0, cos(angle)},
                    .cosine_share = COSINE_SHARE,
                    .wide_share = WIDE_SHARE,
                    .n = reflectance->n,
                    .wide_n = sqrt(reflectance->n),
                    .random = {seed}};
    if (from.kind == GLINT_REFLECTANCE_OF_NL) {
        from.cosine_share = 1.0;
        from.wide_share = 0.0;
    }
    double mean = 0.0, squares = 0.0; /* Welford's */
    for (int i = 1; i <= samples; i++) {
        const double value = weigh(&from, draw(&from));
        const double step = value - mean;
        mean += step / i;
        squares += step * (value - mean);
    }
    return (glint_estimate){mean, sqrt(squares / (samples - 1) / samples)};
}
