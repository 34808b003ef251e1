/* R(L) by Gauss's rule in coordinates around the highlight; see albedo.h. */
#include "energy/albedo.h"

#include <math.h>
#include <stdbool.h>

#define PI 3.14159265358979323846

#define BISECTIONS 60

/* A lobe that is below this part of its height counts as nothing. */
#define NOTHING 1e-17

/* Beyond this many roughnesses m the facets are below that. */
#define FACETS_REACH 6.5

#define LINE_ORDER  16
#define PLANE_ORDER 8

/* The device's steps need many nodes rather than good ones. */
#define STAIRCASE_PIECES 8

/* One angle of incidence. */
typedef struct incidence {
    const glint_albedo *albedo;
    bool over_sphere;   /* φ by quadrature too */
    double angle, c, s; /* of L, its cosine and sine */
    double bound, end;  /* φ is bounded from the first on, and nothing lies beyond the second */
} incidence;

void glint_albedo_rules_make(int fineness, glint_albedo_rules *rules)
{
    glint_gauss_make(fineness * LINE_ORDER, &rules->line);
    glint_gauss_make(fineness * PLANE_ORDER, &rules->plane);
    rules->staircase = fineness * STAIRCASE_PIECES;
}

/* ---- The lobe's extent ----------------------------------------------------------------------- */

static double of_angle(const glint_reflectance *reflectance, double t)
{
    return glint_reflectance_of_cosine(reflectance, cos(t));
}

/* The angle from the axis at which the lobe falls to a level; π/2 if it does not. */
static double angle_of_level(const glint_reflectance *reflectance, double level)
{
    double above = 0.0, below = 0.5 * PI;
    if (of_angle(reflectance, below) > level)
        return below;
    for (int i = 0; i < BISECTIONS; i++) {
        const double middle = 0.5 * (above + below);
        *(of_angle(reflectance, middle) > level ? &above : &below) = middle;
    }
    return below;
}

static bool is_lobe(glint_reflectance_cosine kind)
{
    return kind == GLINT_REFLECTANCE_OF_NH || kind == GLINT_REFLECTANCE_OF_RV;
}

void glint_albedo_prepare(const glint_reflectance *reflectance, const glint_albedo_rules *rules,
                          glint_albedo *albedo)
{
    *albedo = (glint_albedo){.reflectance = reflectance,
                             .rules = rules,
                             .kind = glint_reflectance_describe(reflectance->model)->cosine,
                             .half_width = 0.5 * PI,
                             .reach = PI,
                             .pieces = 1};
    if (is_lobe(albedo->kind)) {
        const double height = of_angle(reflectance, 0.0);
        albedo->half_width = angle_of_level(reflectance, 0.5 * height);
        albedo->reach = angle_of_level(reflectance, NOTHING * height);
    } else if (albedo->kind == GLINT_REFLECTANCE_OF_GEOMETRY) {
        const double m = glint_roughness_of_exponent(reflectance->n);
        albedo->half_width = m * sqrt(log(2.0));
        albedo->reach = FACETS_REACH * m;
    }
    if (reflectance->model == GLINT_REFLECTANCE_DEVICE)
        albedo->pieces = rules->staircase;
}

/* ---- Around the axis: φ ------------------------------------------------------------------------
 */

/* φ beyond which r + s cos φ, which is N·V, is negative. */
static double bound_of(double r, double s)
{
    if (r >= s)
        return PI;
    return r <= -s ? 0.0 : acos(-r / s);
}

/* A lobe of N·H: its part at the angle t between N and H. */
static double ring_of_half(const incidence *at, double t)
{
    const double p = at->c * cos(t), q = at->s * sin(t);             /* L·H = p + q cos φ */
    const double r = at->c * cos(2.0 * t), s = at->s * sin(2.0 * t); /* N·V = r + s cos φ */
    const double phi = bound_of(r, s), sine = sin(phi);
    const double ring =
        p * r * phi + (p * s + q * r) * sine + 0.5 * q * s * (phi + sine * cos(phi));
    return 8.0 * ring * of_angle(at->albedo->reflectance, t) * sin(t);
}

/* A lobe of R·V: its part at the angle t between R and V. */
static double ring_of_mirror(const incidence *at, double t)
{
    const double r = at->c * cos(t), s = at->s * sin(t); /* N·V = r + s cos φ */
    const double phi = bound_of(r, s);
    return 2.0 * (r * phi + s * sin(phi)) * of_angle(at->albedo->reflectance, t) * sin(t);
}

/* Any model, at one H. */
typedef struct ring {
    const incidence *at;
    double nh, p, q, r, s;
} ring;

static double of_phi(const void *context, double phi)
{
    const ring *of = context;
    const double c = cos(phi);
    const double lh = of->p + of->q * c, nv = of->r + of->s * c, nl = of->at->c;
    const glint_geometry geometry = {
        .nl = nl, .nv = nv, .nh = of->nh, .vh = lh, .rv = 2.0 * nl * nv - (2.0 * lh * lh - 1.0)};
    return nv > 0.0 && lh > 0.0
               ? lh * nv * glint_reflectance_brdf(of->at->albedo->reflectance, &geometry)
               : 0.0;
}

static void insert(double *sorted, int count, double value)
{
    int i = count;
    for (; i > 0 && sorted[i - 1] > value; i--)
        sorted[i] = sorted[i - 1];
    sorted[i] = value;
}

#define EDGES_MAX 4

/* The φ up to the bound at which L·H has one of the values where the geometry term changes from one
 * formula to another; the bound is the last. Returns how many. */
static int find_edges(const ring *of, double bound, double edge[EDGES_MAX])
{
    const double nl = of->at->c, nh = of->nh;
    const double values[] = {nl / nh,                                /* N·L = N·V */
                             2.0 * nl * nh,                          /* 2 (N·H)(N·L) = V·H */
                             2.0 * nl * nh / (4.0 * nh * nh - 1.0)}; /* 2 (N·H)(N·V) = V·H */
    int count = 0;
    for (int i = 0; i < EDGES_MAX - 1; i++) {
        const double c = (values[i] - of->p) / of->q;
        if (c > -1.0 && c < 1.0 && acos(c) < bound)
            insert(edge, count++, acos(c));
    }
    edge[count++] = bound;
    return count;
}

static double ring_of_geometry(const incidence *at, double t)
{
    const ring of = {
        at, cos(t), at->c * cos(t), at->s * sin(t), at->c * cos(2.0 * t), at->s * sin(2.0 * t)};
    double edge[EDGES_MAX], sum = 0.0, from = 0.0;
    const int count = find_edges(&of, bound_of(of.r, of.s), edge);
    for (int i = 0; i < count; i++) {
        sum += glint_gauss_integrate(&at->albedo->rules->plane, of_phi, &of, from, edge[i]);
        from = edge[i];
    }
    return 8.0 * sum * sin(t);
}

/* ---- Along the lobe: t -------------------------------------------------------------------------
 */

static double part_at(const incidence *at, double t)
{
    if (at->over_sphere)
        return ring_of_geometry(at, t);
    return at->albedo->kind == GLINT_REFLECTANCE_OF_RV ? ring_of_mirror(at, t)
                                                       : ring_of_half(at, t);
}

static double whole(const void *context, double t)
{
    return part_at(context, t);
}

static double bounded(const void *context, double u)
{
    const incidence *at = context;
    const double range = at->end - at->bound, sine = sin(u);
    return part_at(at, at->bound + range * sine * sine) * range * sin(2.0 * u);
}

static double u_of(const incidence *at, double t)
{
    return asin(sqrt(fmin(1.0, (t - at->bound) / (at->end - at->bound))));
}

static double integrate_pieces(const incidence *at, glint_integrand *f, double from, double to)
{
    const glint_albedo_rules *rules = at->albedo->rules;
    const glint_gauss *rule = at->over_sphere ? &rules->plane : &rules->line;
    const int pieces = at->albedo->pieces;
    double sum = 0.0;
    for (int i = 0; i < pieces; i++)
        sum += glint_gauss_integrate(rule, f, at, from + (to - from) * i / pieces,
                                     from + (to - from) * (i + 1) / pieces);
    return sum;
}

/* The least of the values that is beyond t. */
static double next_of(const double *value, int count, double t)
{
    double next = INFINITY;
    for (int i = 0; i < count; i++)
        if (value[i] > t && value[i] < next)
            next = value[i];
    return next;
}

/* t from the one to the other, cut at the half width and its doubles and, where φ is integrated
 * piece by piece, where one of its pieces begins. */
static double integrate(const incidence *at, double from, double to, bool is_bounded)
{
    const double begins[] = {at->angle, 0.5 * PI - at->angle, (PI - 2.0 * at->angle) / 6.0,
                             (PI + 2.0 * at->angle) / 6.0};
    double sum = 0.0, cut = at->albedo->half_width;
    while (from < to) {
        while (cut <= from)
            cut *= 2.0;
        const double edge = at->over_sphere ? next_of(begins, 4, from) : to;
        const double next = fmin(fmin(cut, edge), to);
        sum += is_bounded ? integrate_pieces(at, bounded, u_of(at, from), u_of(at, next))
                          : integrate_pieces(at, whole, from, next);
        from = next;
    }
    return sum;
}

static double integrate_all(const glint_albedo *albedo, double angle, bool over_sphere)
{
    incidence at = {.albedo = albedo,
                    .over_sphere = over_sphere,
                    .angle = angle,
                    .c = cos(angle),
                    .s = sin(angle)};
    const bool of_mirror = !over_sphere && albedo->kind == GLINT_REFLECTANCE_OF_RV;
    at.bound = of_mirror ? 0.5 * PI - angle : 0.25 * PI - 0.5 * angle;
    at.end = of_mirror ? 0.5 * PI + angle : 0.25 * PI + 0.5 * angle;
    return integrate(&at, 0.0, fmin(at.bound, albedo->reach), false) +
           integrate(&at, at.bound, fmin(at.end, albedo->reach), true);
}

double glint_albedo_at(const glint_albedo *albedo, double angle)
{
    return integrate_all(albedo, angle, !is_lobe(albedo->kind));
}

double glint_albedo_over_sphere(const glint_albedo *albedo, double angle)
{
    /* Phong's lobe is around R: as a function of H it is half as wide, and stretched sideways at
     * grazing incidence, so the pieces are cut for its narrowest extent and continue to the end. */
    glint_albedo wide = *albedo;
    if (albedo->kind == GLINT_REFLECTANCE_OF_RV) {
        wide.half_width *= 0.5;
        wide.reach = PI;
    }
    return integrate_all(&wide, angle, true);
}
