/* Whether single precision is enough for an object; see detail.h. */
#include "render/detail.h"

#include <float.h>
#include <stdbool.h>

#include "reflectance/vec3.h"

/* For an object this many rounding steps large, precision is ample: finer detail is invisible. */
#define STEPS_ENOUGH 0x1p18

/* A triangle lower than so many of these steps is lost in the rounding, which can tilt it by more
 * than a quarter of a degree. */
#define STEPS_NEEDED 128.0

typedef struct extent {
    glint_vec3 low, high;
} extent;

static glint_vec3 vec3_of(const struct aiVector3D *v)
{
    return (glint_vec3){(double)v->x, (double)v->y, (double)v->z};
}

static bool is_triangle(const struct aiMesh *mesh, const struct aiFace *face)
{
    for (unsigned k = 0; k < 3 && face->mNumIndices == 3; k++)
        if (face->mIndices[k] >= mesh->mNumVertices)
            return false;
    return face->mNumIndices == 3;
}

static extent extent_of(const struct aiMesh *mesh)
{
    extent e = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (unsigned i = 0; i < mesh->mNumVertices; i++) {
        const glint_vec3 p = vec3_of(&mesh->mVertices[i]);
        e.low = (glint_vec3){fmin(e.low.x, p.x), fmin(e.low.y, p.y), fmin(e.low.z, p.z)};
        e.high = (glint_vec3){fmax(e.high.x, p.x), fmax(e.high.y, p.y), fmax(e.high.z, p.z)};
    }
    return e;
}

static double largest(glint_vec3 v)
{
    return fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
}

/* The distance of the floats next to a value. */
static double step_at(double value)
{
    int exponent;
    (void)frexp(value, &exponent);
    return ldexp(1.0, (exponent > FLT_MIN_EXP ? exponent : FLT_MIN_EXP) - FLT_MANT_DIG);
}

/* Of a triangle above its longest side. */
static double height_of(const struct aiMesh *mesh, const struct aiFace *face)
{
    const glint_vec3 a = vec3_of(&mesh->mVertices[face->mIndices[0]]);
    const glint_vec3 b = vec3_of(&mesh->mVertices[face->mIndices[1]]);
    const glint_vec3 c = vec3_of(&mesh->mVertices[face->mIndices[2]]);
    const glint_vec3 ab = glint_vec3_sub(b, a);
    const glint_vec3 ac = glint_vec3_sub(c, a);
    const double longest = fmax(glint_vec3_length(glint_vec3_sub(c, b)),
                                fmax(glint_vec3_length(ab), glint_vec3_length(ac)));
    return longest > 0.0 ? glint_vec3_length(glint_vec3_cross(ab, ac)) / longest : 0.0;
}

/* What the check finds. */
typedef struct findings {
    size_t triangles, lost; /* of all meshes */
    size_t meshes;          /* those that have lost most of their triangles */
    double reach, size;     /* of the one of them that has lost the most */
    size_t most;
} findings;

static void check_mesh(const struct aiMesh *mesh, findings *found)
{
    if (mesh->mNumVertices == 0)
        return;
    const extent e = extent_of(mesh);
    const double size = largest(glint_vec3_sub(e.high, e.low));
    const double reach = fmax(largest(e.low), largest(e.high));
    const double step = step_at(reach);
    if (reach == 0.0) /* all in the origin: nowhere are steps finer */
        return;
    const bool is_held = size >= STEPS_ENOUGH * step;
    size_t count = 0, lost = 0;
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        if (is_triangle(mesh, &mesh->mFaces[i])) {
            count++;
            lost += !is_held && height_of(mesh, &mesh->mFaces[i]) < STEPS_NEEDED * step;
        }
    }
    found->triangles += count;
    if (2 * lost <= count)
        return;
    found->lost += lost;
    found->meshes++;
    if (lost > found->most) {
        found->most = lost;
        found->reach = reach;
        found->size = size;
    }
}

glint_status glint_detail_check(const char *path, const struct aiScene *scene,
                                glint_remarks *remarks, glint_error *err)
{
    findings found = {0};
    for (unsigned i = 0; i < scene->mNumMeshes; i++)
        check_mesh(scene->mMeshes[i], &found);
    if (found.meshes == 0)
        return GLINT_OK;
    if (2 * found.lost <= found.triangles) {
        glint_remark(remarks, "%zu %s", found.meshes,
                     found.meshes == 1
                         ? "mesh is too fine for single precision at its position"
                         : "meshes are too fine for single precision at their position");
        return GLINT_OK;
    }
    return glint_fail(err, GLINT_BAD_INPUT,
                      "%.300s: single precision is not enough: at coordinates near %.3g its steps "
                      "are %.2g, too coarse for %zu of %zu triangles of an object of size %.3g; "
                      "move it to the origin or scale it up",
                      path, found.reach, step_at(found.reach), found.lost, found.triangles,
                      found.size);
}
