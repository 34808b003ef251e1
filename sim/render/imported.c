/* What assimp has read becomes a mesh.
 *
 * What comes from a file is not believed: every coordinate and every index is checked before it is
 * used. Normals are mended where the file's are unusable, geometry never is. */
#include "render/imported.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "render/mesh_build.h"

/* Larger coordinates are taken for damage: their squares would leave the range of a float. */
#define COORDINATE_MAX 1e18

/* Nodes deeper than this are taken for damage: the walk over them is recursive. */
#define DEPTH_MAX 256

/* What the walk over the nodes carries along. */
typedef struct reading {
    const char *path;
    const struct aiScene *scene;
    glint_mesh *mesh;
    size_t vertices, triangles; /* counted first, to make room */
    glint_error *err;
} reading;

static glint_status bad(const reading *in, const char *why)
{
    return glint_fail(in->err, GLINT_BAD_INPUT, "%s: %s", in->path, why);
}

static glint_vec3 vec3_of(const struct aiVector3D *v)
{
    return (glint_vec3){(double)v->x, (double)v->y, (double)v->z};
}

static bool usable_coordinate(double c)
{
    return c >= -COORDINATE_MAX && c <= COORDINATE_MAX; /* false for a NaN */
}

static bool usable_point(glint_vec3 p)
{
    return usable_coordinate(p.x) && usable_coordinate(p.y) && usable_coordinate(p.z);
}

/* A node's transform in double precision: columns x, y, z and the shift. */
typedef struct transform {
    glint_vec3 x, y, z, shift;
} transform;

static transform transform_of(const struct aiMatrix4x4 *m)
{
    return (transform){
        .x = {(double)m->a1, (double)m->b1, (double)m->c1},
        .y = {(double)m->a2, (double)m->b2, (double)m->c2},
        .z = {(double)m->a3, (double)m->b3, (double)m->c3},
        .shift = {(double)m->a4, (double)m->b4, (double)m->c4},
    };
}

static glint_vec3 linear_part(const transform *t, glint_vec3 v)
{
    return glint_vec3_add(glint_vec3_add(glint_vec3_scale(t->x, v.x), glint_vec3_scale(t->y, v.y)),
                          glint_vec3_scale(t->z, v.z));
}

static transform combine(const transform *outer, const transform *inner)
{
    return (transform){
        .x = linear_part(outer, inner->x),
        .y = linear_part(outer, inner->y),
        .z = linear_part(outer, inner->z),
        .shift = glint_vec3_add(linear_part(outer, inner->shift), outer->shift),
    };
}

/* Normals go by the cofactors, which are the inverse transposed times the determinant. */
static transform for_normals(const transform *t)
{
    return (transform){
        .x = glint_vec3_cross(t->y, t->z),
        .y = glint_vec3_cross(t->z, t->x),
        .z = glint_vec3_cross(t->x, t->y),
    };
}

/* A vector of unit length, or of length 0 when it has no usable direction. */
static glint_vec3 unit_or_zero(glint_vec3 v)
{
    const double length = glint_vec3_length(v);
    if (!(length > 0.0) || isinf(length)) {
        return (glint_vec3){0.0, 0.0, 0.0};
    }
    return glint_vec3_scale(v, 1.0 / length);
}

static glint_status add_vertices(reading *in, const struct aiMesh *source, const transform *t,
                                 double side)
{
    const transform n = for_normals(t);
    for (unsigned i = 0; i < source->mNumVertices; i++) {
        const glint_vec3 p =
            glint_vec3_add(linear_part(t, vec3_of(&source->mVertices[i])), t->shift);
        if (!usable_point(p)) {
            return bad(in, "a node moves a vertex beyond all measure");
        }
        glint_vec3 normal = {0.0, 0.0, 0.0};
        if (source->mNormals != NULL) {
            normal = unit_or_zero(linear_part(&n, vec3_of(&source->mNormals[i])));
        }
        glint_mesh_add_vertex(in->mesh, p, glint_vec3_scale(normal, side));
    }
    return GLINT_OK;
}

/* A transform that mirrors turns triangles over: two corners are exchanged to turn them back. */
static glint_status add_triangles(reading *in, const struct aiMesh *source, uint32_t base,
                                  bool mirrored)
{
    for (unsigned i = 0; i < source->mNumFaces; i++) {
        const struct aiFace *face = &source->mFaces[i];
        if (face->mNumIndices != 3) {
            continue; /* points and lines */
        }
        uint32_t corner[3];
        for (int k = 0; k < 3; k++) {
            corner[k] = face->mIndices[k];
            if (corner[k] >= source->mNumVertices) {
                return bad(in, "a face names a vertex that is not there");
            }
            corner[k] += base;
        }
        glint_mesh_add_triangle(in->mesh, corner[0], corner[mirrored ? 2 : 1],
                                corner[mirrored ? 1 : 2]);
    }
    return GLINT_OK;
}

static glint_status add_mesh(reading *in, const struct aiMesh *source, const transform *t)
{
    const double determinant = glint_vec3_dot(t->x, glint_vec3_cross(t->y, t->z));
    const bool mirrored = determinant < 0.0;
    const uint32_t base = (uint32_t)in->mesh->vertex_count;
    const glint_status status = add_vertices(in, source, t, mirrored ? -1.0 : 1.0);
    return status == GLINT_OK ? add_triangles(in, source, base, mirrored) : status;
}

static glint_status count_mesh(reading *in, const struct aiMesh *source)
{
    in->vertices += source->mNumVertices;
    in->triangles += source->mNumFaces;
    if (in->vertices > 3 * GLINT_MESH_TRIANGLES_MAX || in->triangles > GLINT_MESH_TRIANGLES_MAX) {
        return glint_fail(in->err, GLINT_BAD_INPUT, "%s: more than %zu triangles", in->path,
                          GLINT_MESH_TRIANGLES_MAX);
    }
    return GLINT_OK;
}

/* Visits every mesh of every node under its transform: to count it while there is no mesh to add it
 * to, to add it after. */
static glint_status walk(reading *in, const struct aiNode *node, const transform *outer, int depth)
{
    if (depth > DEPTH_MAX) {
        return bad(in, "nodes are nested too deep");
    }
    const transform own = transform_of(&node->mTransformation);
    const transform t = combine(outer, &own);
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        if (node->mMeshes[i] >= in->scene->mNumMeshes) {
            return bad(in, "a node names a mesh that is not there");
        }
        const struct aiMesh *source = in->scene->mMeshes[node->mMeshes[i]];
        const glint_status status =
            in->mesh == NULL ? count_mesh(in, source) : add_mesh(in, source, &t);
        if (status != GLINT_OK) {
            return status;
        }
    }
    for (unsigned i = 0; i < node->mNumChildren; i++) {
        const glint_status status = walk(in, node->mChildren[i], &t, depth + 1);
        if (status != GLINT_OK) {
            return status;
        }
    }
    return GLINT_OK;
}

static bool is_zero(const float v[3])
{
    return v[0] == 0.0f && v[1] == 0.0f && v[2] == 0.0f;
}

/* Adds the triangle's normal, as long as its area, to those of its corners that are marked. */
static void add_face_normal(const glint_mesh *mesh, const uint32_t *corner, const bool *marked,
                            glint_vec3 *sum)
{
    glint_vec3 p[3];
    for (int k = 0; k < 3; k++) {
        p[k] = glint_vec3_of(&mesh->position[3 * (size_t)corner[k]]);
    }
    const glint_vec3 face =
        glint_vec3_cross(glint_vec3_sub(p[1], p[0]), glint_vec3_sub(p[2], p[0]));
    for (int k = 0; k < 3; k++) {
        if (marked[corner[k]]) {
            sum[corner[k]] = glint_vec3_add(sum[corner[k]], face);
        }
    }
}

/* Gives vertices whose normal is missing that of the faces about them. One that no face gives a
 * direction to is of no visible triangle: any unit vector will do. */
static glint_status mend_normals(reading *in)
{
    glint_mesh *mesh = in->mesh;
    bool *missing = calloc(mesh->vertex_count, sizeof *missing);
    glint_vec3 *sum = calloc(mesh->vertex_count, sizeof *sum);
    if (missing == NULL || sum == NULL) {
        free(missing);
        free(sum);
        return glint_fail(in->err, GLINT_NO_MEMORY, "%s: no memory for its normals", in->path);
    }
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        missing[i] = is_zero(&mesh->normal[3 * i]);
    }
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        add_face_normal(mesh, &mesh->index[3 * i], missing, sum);
    }
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        if (missing[i]) {
            const glint_vec3 n = unit_or_zero(sum[i]);
            const bool found = glint_vec3_length(n) > 0.0;
            glint_vec3_store(found ? n : (glint_vec3){0.0, 1.0, 0.0}, &mesh->normal[3 * i]);
        }
    }
    free(missing);
    free(sum);
    return GLINT_OK;
}

static glint_status convert(reading *in)
{
    const transform identity = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 0.0}};
    if (in->scene->mRootNode == NULL) {
        return bad(in, "no triangles in it");
    }
    glint_status status = walk(in, in->scene->mRootNode, &identity, 0);
    if (status != GLINT_OK) {
        return status;
    }
    status = glint_mesh_new(in->path, in->vertices, in->triangles, &in->mesh, in->err);
    if (status != GLINT_OK) {
        return status;
    }
    status = walk(in, in->scene->mRootNode, &identity, 0);
    if (status != GLINT_OK) {
        return status;
    }
    if (in->mesh->triangle_count == 0) { /* assimp has joined what lies so near, too */
        return bad(in,
                   in->triangles == 0
                       ? "no triangles in it"
                       : "each of its triangles has two corners in one place (what is less than "
                         "1e-5 apart counts as one place)");
    }
    return mend_normals(in);
}

glint_status glint_imported_check(const char *path, const struct aiScene *scene, glint_error *err)
{
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        const struct aiMesh *mesh = scene->mMeshes[i];
        for (unsigned k = 0; k < mesh->mNumVertices; k++) {
            if (!usable_point(vec3_of(&mesh->mVertices[k]))) {
                return glint_fail(err, GLINT_BAD_INPUT,
                                  "%s: vertex %u of mesh %u has a coordinate that is not a number "
                                  "or beyond %g",
                                  path, k, i, COORDINATE_MAX);
            }
        }
    }
    return GLINT_OK;
}

glint_status glint_imported_mesh(const char *path, const struct aiScene *scene, glint_mesh **mesh,
                                 glint_error *err)
{
    reading in = {.path = path, .scene = scene, .err = err};
    const glint_status status = convert(&in);
    if (status != GLINT_OK) {
        glint_mesh_destroy(in.mesh);
        return status;
    }
    *mesh = in.mesh;
    return GLINT_OK;
}
