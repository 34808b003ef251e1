/* The object's own affine transform; see transform.h. */
#include "render/transform.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "reflectance/vec3.h"
#include "render/render.h"

#define RADIANS (3.14159265358979323846 / 180.0)

/* Rows of a rotation; its inverse is its transpose, so it turns normals too. */
typedef struct rotation {
    glint_vec3 row[3];
} rotation;

static glint_vec3 turn(const rotation *r, glint_vec3 v)
{
    return (glint_vec3){glint_vec3_dot(r->row[0], v), glint_vec3_dot(r->row[1], v),
                        glint_vec3_dot(r->row[2], v)};
}

/* Rz·Ry·Rx. */
static rotation rotation_of(const double degrees[3])
{
    const double cx = cos(degrees[0] * RADIANS), sx = sin(degrees[0] * RADIANS);
    const double cy = cos(degrees[1] * RADIANS), sy = sin(degrees[1] * RADIANS);
    const double cz = cos(degrees[2] * RADIANS), sz = sin(degrees[2] * RADIANS);
    return (rotation){{{cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx},
                       {sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx},
                       {-sy, cy * sx, cy * cx}}};
}

/* The comparison is false for a NaN. */
static bool within(double value, double limit)
{
    return value >= -limit && value <= limit;
}

static glint_status check(const glint_transform *t, glint_error *err)
{
    for (int axis = 0; axis < 3; axis++) {
        if (!(fabs(t->scale[axis]) >= GLINT_SCALE_MIN)) { /* nor a NaN */
            return glint_fail(err, GLINT_BAD_ARGUMENT,
                              "transform: a scale of %g along %c would flatten the object",
                              t->scale[axis], "xyz"[axis]);
        }
        if (!within(t->scale[axis], GLINT_SCALE_MAX) || !within(t->move[axis], GLINT_MOVE_MAX) ||
            !within(t->rotate[axis], (double)GLINT_ANGLE_MAX))
            return glint_fail(err, GLINT_BAD_ARGUMENT, "transform: a value is out of range");
    }
    return GLINT_OK;
}

/* What the transform is about, and its unit of length: as the camera has them (camera.c). */
static glint_vec3 centre_of(const glint_mesh *mesh)
{
    glint_vec3 low = {DBL_MAX, DBL_MAX, DBL_MAX};
    glint_vec3 high = {-DBL_MAX, -DBL_MAX, -DBL_MAX};
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const glint_vec3 p = glint_vec3_of(&mesh->position[3 * i]);
        low = (glint_vec3){fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z)};
        high = (glint_vec3){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
    }
    return glint_vec3_scale(glint_vec3_add(low, high), 0.5);
}

static double radius_about(const glint_mesh *mesh, glint_vec3 centre)
{
    double radius = 0.0;
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const glint_vec3 p = glint_vec3_of(&mesh->position[3 * i]);
        radius = fmax(radius, glint_vec3_length(glint_vec3_sub(p, centre)));
    }
    return radius;
}

static void transform_vertices(glint_mesh *mesh, const glint_transform *t)
{
    const rotation r = rotation_of(t->rotate);
    const glint_vec3 centre = centre_of(mesh);
    const double radius = radius_about(mesh, centre);
    const glint_vec3 move = {t->move[0] * radius, t->move[1] * radius, t->move[2] * radius};
    const double *s = t->scale;
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const glint_vec3 p = glint_vec3_sub(glint_vec3_of(&mesh->position[3 * i]), centre);
        const glint_vec3 n = glint_vec3_of(&mesh->normal[3 * i]);
        const glint_vec3 place = turn(&r, (glint_vec3){s[0] * p.x, s[1] * p.y, s[2] * p.z});
        const glint_vec3 normal = turn(&r, (glint_vec3){n.x / s[0], n.y / s[1], n.z / s[2]});
        const double length = glint_vec3_length(normal);
        glint_vec3_store(glint_vec3_add(glint_vec3_add(place, centre), move),
                         &mesh->position[3 * i]);
        glint_vec3_store(glint_vec3_scale(normal, length > 0.0 ? 1.0 / length : 0.0),
                         &mesh->normal[3 * i]);
    }
}

/* Counter-clockwise from outside again. */
static void turn_triangles_over(glint_mesh *mesh)
{
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        uint32_t *corner = &mesh->index[3 * i];
        const uint32_t second = corner[1];
        corner[1] = corner[2];
        corner[2] = second;
    }
}

bool glint_transform_is_identity(const glint_transform *transform)
{
    for (int i = 0; i < 3; i++)
        if (transform->rotate[i] != 0.0 || transform->scale[i] != 1.0 || transform->move[i] != 0.0)
            return false;
    return true;
}

glint_status glint_mesh_transform(glint_mesh *mesh, const glint_transform *transform,
                                  glint_error *err)
{
    const glint_status status = check(transform, err);
    if (status != GLINT_OK || glint_transform_is_identity(transform) || mesh->vertex_count == 0)
        return status;
    const size_t size = 3 * mesh->vertex_count * sizeof *mesh->position;
    if (mesh->rest == NULL) {
        mesh->rest = malloc(size);
        if (mesh->rest == NULL) {
            return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for %zu vertices twice",
                              mesh->vertex_count);
        }
        memcpy(mesh->rest, mesh->position, size);
    }
    mesh->transform = *transform;
    transform_vertices(mesh, transform);
    if (transform->scale[0] * transform->scale[1] * transform->scale[2] < 0.0)
        turn_triangles_over(mesh);
    return GLINT_OK;
}
