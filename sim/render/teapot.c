/* The Newell teapot, tessellated from its bicubic Bezier patches.
 *
 * A patch is S(u, v) = Σ Bi(u)·Bj(v)·P[i][j]. In the published order of control points ∂S/∂v ×
 * ∂S/∂u points outwards on every one of the 32 patches (tests/render/test_teapot.c holds it against
 * a notion of "outside" of its own), so one rule serves for normals and winding of all. */
#include "render/mesh_build.h"
#include "render/teapot_data.h"

/* The cubic Bernstein polynomials at one parameter, with their derivatives. */
typedef struct basis {
    double value[4], first[4], second[4];
} basis;

/* A point of a patch with all its derivatives up to the second order. */
typedef struct jet {
    glint_vec3 s, su, sv, suu, suv, svv;
} jet;

/* The basis at i/density. 1−t is taken as (density−i)/density, so that the weights at i and at
 * density−i mirror each other to the last bit: two patches that run along a shared edge in opposite
 * directions then get the same points, and no crack opens between them. */
static basis basis_at(int i, int density)
{
    const double t = (double)i / density;
    const double s = (double)(density - i) / density;
    return (basis){
        .value = {s * s * s, 3.0 * s * s * t, 3.0 * t * t * s, t * t * t},
        .first = {-3.0 * s * s, 3.0 * s * s - 6.0 * s * t, 6.0 * s * t - 3.0 * t * t, 3.0 * t * t},
        .second = {6.0 * s, 6.0 * t - 12.0 * s, 6.0 * s - 12.0 * t, 6.0 * t},
    };
}

/* Σ w[k]·p[k], outer and inner pair summed apart: the same to the last bit when both are reversed.
 */
static glint_vec3 blend(const double w[4], const glint_vec3 p[4])
{
    const glint_vec3 outer =
        glint_vec3_add(glint_vec3_scale(p[0], w[0]), glint_vec3_scale(p[3], w[3]));
    const glint_vec3 inner =
        glint_vec3_add(glint_vec3_scale(p[1], w[1]), glint_vec3_scale(p[2], w[2]));
    return glint_vec3_add(outer, inner);
}

/* Control point of the data set in the scene's axes: the data's z is up, the scene's y is. */
static glint_vec3 control_point(int patch, int row, int column)
{
    const double *p = glint_teapot_vertices[glint_teapot_patches[patch][4 * row + column] - 1];
    return (glint_vec3){p[0], p[2], -p[1]};
}

static jet evaluate(int patch, const basis *u, const basis *v)
{
    glint_vec3 value[4], first[4], second[4]; /* of each row, along v */
    for (int row = 0; row < 4; row++) {
        glint_vec3 p[4];
        for (int column = 0; column < 4; column++)
            p[column] = control_point(patch, row, column);
        value[row] = blend(v->value, p);
        first[row] = blend(v->first, p);
        second[row] = blend(v->second, p);
    }
    return (jet){
        .s = blend(u->value, value),
        .su = blend(u->first, value),
        .suu = blend(u->second, value),
        .sv = blend(u->value, first),
        .suv = blend(u->first, first),
        .svv = blend(u->value, second),
    };
}

/* The step from a parameter on the border of the patch into it: +1, −1, or 0 inside. */
static double inward(int i, int density)
{
    return i == 0 ? 1.0 : i == density ? -1.0 : 0.0;
}

/* Where a whole edge of a patch is one point (tip of the lid, centre of the bottom) the product of
 * the partial derivatives is 0. The normal there is the limit of the normals nearby: the direction
 * of the product's own derivative on the way into the patch. */
static glint_vec3 limit_normal(const jet *j, double du, double dv)
{
    const glint_vec3 dsu =
        glint_vec3_add(glint_vec3_scale(j->suu, du), glint_vec3_scale(j->suv, dv));
    const glint_vec3 dsv =
        glint_vec3_add(glint_vec3_scale(j->suv, du), glint_vec3_scale(j->svv, dv));
    return glint_vec3_add(glint_vec3_cross(dsv, j->su), glint_vec3_cross(j->sv, dsu));
}

static glint_vec3 normal(const jet *j, double du, double dv)
{
    glint_vec3 n = glint_vec3_cross(j->sv, j->su);
    double length = glint_vec3_length(n);
    if (length < 1e-9) { /* the smallest regular one is of the order of 1e-2 */
        n = limit_normal(j, du, dv);
        length = glint_vec3_length(n);
    }
    return glint_vec3_scale(n, 1.0 / length);
}

static void add_patch(glint_mesh *mesh, int patch, int density)
{
    const uint32_t start = (uint32_t)mesh->vertex_count;
    const uint32_t row_length = (uint32_t)density + 1;
    for (int i = 0; i <= density; i++) {
        const basis u = basis_at(i, density);
        for (int k = 0; k <= density; k++) {
            const basis v = basis_at(k, density);
            const jet j = evaluate(patch, &u, &v);
            glint_mesh_add_vertex(mesh, j.s, normal(&j, inward(i, density), inward(k, density)));
        }
    }
    for (uint32_t i = 0; i + 1 < row_length; i++) {
        for (uint32_t k = 0; k + 1 < row_length; k++) {
            const uint32_t a = start + i * row_length + k;
            const uint32_t b = a + row_length; /* one step of u from a, as a+1 is one of v */
            glint_mesh_add_triangle(mesh, a, a + 1, b + 1);
            glint_mesh_add_triangle(mesh, a, b + 1, b);
        }
    }
}

glint_status glint_mesh_teapot(int density, glint_mesh **mesh, glint_error *err)
{
    if (density < 1 || density > GLINT_TEAPOT_DENSITY_MAX) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "teapot: density %d is not from 1 to %d",
                          density, GLINT_TEAPOT_DENSITY_MAX);
    }
    const size_t side = (size_t)density;
    glint_mesh *m = NULL;
    const glint_status status =
        glint_mesh_new("teapot", GLINT_TEAPOT_PATCHES * (side + 1) * (side + 1),
                       GLINT_TEAPOT_PATCHES * 2 * side * side, &m, err);
    if (status != GLINT_OK)
        return status;
    for (int patch = 0; patch < GLINT_TEAPOT_PATCHES; patch++)
        add_patch(m, patch, density);
    *mesh = m;
    return GLINT_OK;
}
