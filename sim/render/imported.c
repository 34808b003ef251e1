/* What assimp has read becomes a mesh.
 *
 * What comes from a file is not believed: every coordinate and every index is checked before it is
 * used. Geometry is never mended. */
#include "render/imported.h"

#include <assimp/commonMetaData.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "render/mesh_build.h"
#include "render/skin.h"

/* Larger coordinates are taken for damage: their squares would leave the range of a float. */
#define COORDINATE_MAX 1e18

/* Nodes deeper than this are taken for damage: the walk over them is recursive. */
#define DEPTH_MAX 256

/* How triangles get the normals that the file does not give. */
typedef enum rule {
    BY_CREASES, /* smooth but for sharp edges */
    FLAT,       /* STL: a facet's normal is its own */
    FLAT_MESH,  /* glTF: likewise, in a mesh that has none at all; so its specification */
    BY_GROUPS,  /* 3ds, ASE */
} rule;

/* What the walk over the nodes carries along. */
typedef struct reading {
    const char *path;
    const struct aiScene *scene;
    const glint_groups *groups; /* with BY_GROUPS */
    rule rule;
    glint_imported *to;
    size_t vertices, triangles; /* counted first, to make room */
    glint_vec3 low, high;       /* of what the triangles name, found in the same walk */
    glint_vec3 center;          /* becomes the origin, */
    double scale;               /* then all is multiplied by this */
    uint32_t objects;           /* meshes of nodes added so far */
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

static const transform identity = {
    {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 0.0}};

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
    if (!(length > 0.0) || isinf(length))
        return (glint_vec3){0.0, 0.0, 0.0};
    return glint_vec3_scale(v, 1.0 / length);
}

static glint_vec3 placed(const transform *t, const struct aiVector3D *v)
{
    return glint_vec3_add(linear_part(t, vec3_of(v)), t->shift);
}

static void add_vertices(reading *in, const struct aiMesh *source, const transform *t, double side)
{
    const transform n = for_normals(t);
    for (unsigned i = 0; i < source->mNumVertices; i++) {
        glint_vec3 p = placed(t, &source->mVertices[i]);
        if (!usable_point(p)) /* of no triangle */
            p = in->center;
        glint_vec3 normal = {0.0, 0.0, 0.0};
        if (source->mNormals != NULL && in->rule != BY_GROUPS) /* those would be assimp's */
            normal = unit_or_zero(linear_part(&n, unit_or_zero(vec3_of(&source->mNormals[i]))));
        glint_mesh_add_vertex(in->to->mesh,
                              glint_vec3_scale(glint_vec3_sub(p, in->center), in->scale),
                              glint_vec3_scale(normal, side));
    }
}

/* The smoothing group of a face of the mesh. */
static uint32_t group_of(const reading *in, const struct aiMesh *source, const uint32_t *groups,
                         unsigned face)
{
    if (groups != NULL)
        return groups[face];
    return in->rule == FLAT || (in->rule == FLAT_MESH && source->mNormals == NULL) ? 0 : 1;
}

/* A transform that mirrors turns triangles over: two corners are exchanged to turn them back. */
static void add_triangles(reading *in, const struct aiMesh *source, const uint32_t *groups,
                          uint32_t base, bool mirrored)
{
    glint_mesh *mesh = in->to->mesh;
    for (unsigned i = 0; i < source->mNumFaces; i++) {
        const struct aiFace *face = &source->mFaces[i];
        const size_t at = mesh->triangle_count;
        if (face->mNumIndices != 3)
            continue; /* points and lines */
        glint_mesh_add_triangle(mesh, base + face->mIndices[0],
                                base + face->mIndices[mirrored ? 2 : 1],
                                base + face->mIndices[mirrored ? 1 : 2]);
        if (mesh->triangle_count > at) {
            in->to->smoothing.group[at] = group_of(in, source, groups, i);
            if (in->to->smoothing.object != NULL)
                in->to->smoothing.object[at] = in->objects;
        }
    }
}

/* assimp's meshes are the file's objects, in their order. */
static bool groups_fit(const struct aiScene *scene, const glint_groups *groups)
{
    if (groups == NULL || scene->mNumMeshes != groups->objects)
        return false;
    for (unsigned i = 0; i < scene->mNumMeshes; i++)
        if (scene->mMeshes[i]->mNumFaces != groups->object[i].faces)
            return false;
    return true;
}

static void add_mesh(reading *in, unsigned index, const transform *t)
{
    const struct aiMesh *source = in->scene->mMeshes[index];
    const double determinant = glint_vec3_dot(t->x, glint_vec3_cross(t->y, t->z));
    const bool mirrored = determinant < 0.0;
    const uint32_t base = (uint32_t)in->to->mesh->vertex_count;
    add_vertices(in, source, t, mirrored ? -1.0 : 1.0);
    add_triangles(in, source, in->rule == BY_GROUPS ? in->groups->object[index].group : NULL, base,
                  mirrored);
    in->objects++;
}

static void include(reading *in, glint_vec3 p)
{
    in->low = (glint_vec3){fmin(in->low.x, p.x), fmin(in->low.y, p.y), fmin(in->low.z, p.z)};
    in->high = (glint_vec3){fmax(in->high.x, p.x), fmax(in->high.y, p.y), fmax(in->high.z, p.z)};
}

static glint_status measure_face(reading *in, const struct aiMesh *source,
                                 const struct aiFace *face, const transform *t)
{
    for (unsigned k = 0; k < 3; k++) {
        if (face->mIndices[k] >= source->mNumVertices)
            return bad(in, "a face refers to a vertex that does not exist");
        const glint_vec3 p = placed(t, &source->mVertices[face->mIndices[k]]);
        if (!usable_point(p))
            return bad(in, "a node moves a vertex out of range");
        include(in, p);
    }
    return GLINT_OK;
}

static glint_status measure_mesh(reading *in, unsigned index, const transform *t)
{
    const struct aiMesh *source = in->scene->mMeshes[index];
    glint_status status = GLINT_OK;
    in->vertices += source->mNumVertices;
    for (unsigned i = 0; status == GLINT_OK && i < source->mNumFaces; i++) {
        if (source->mFaces[i].mNumIndices == 3) {
            in->triangles++;
            status = measure_face(in, source, &source->mFaces[i], t);
        }
    }
    if (in->vertices > 3 * GLINT_MESH_TRIANGLES_MAX || in->triangles > GLINT_MESH_TRIANGLES_MAX) {
        return glint_fail(in->err, GLINT_BAD_INPUT, "%s: more than %zu triangles", in->path,
                          GLINT_MESH_TRIANGLES_MAX);
    }
    return status;
}

/* Visits every mesh of every node under its transform: first to measure, then, once there is a
 * mesh, to add to it. */
static glint_status walk(reading *in, const struct aiNode *node, const transform *outer, int depth)
{
    if (depth > DEPTH_MAX)
        return bad(in, "nodes are nested too deep");
    const transform own = transform_of(&node->mTransformation);
    const transform t = combine(outer, &own);
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        if (node->mMeshes[i] >= in->scene->mNumMeshes)
            return bad(in, "a node refers to a mesh that does not exist");
        const bool placed = glint_skin_places(in->scene, in->scene->mMeshes[node->mMeshes[i]]);
        const transform *place = placed ? &identity : &t;
        if (in->to->mesh != NULL) {
            add_mesh(in, node->mMeshes[i], place);
            continue;
        }
        const glint_status status = measure_mesh(in, node->mMeshes[i], place);
        if (status != GLINT_OK)
            return status;
    }
    for (unsigned i = 0; i < node->mNumChildren; i++) {
        const glint_status status = walk(in, node->mChildren[i], &t, depth + 1);
        if (status != GLINT_OK)
            return status;
    }
    return GLINT_OK;
}

static glint_status make_room(reading *in)
{
    glint_imported *to = in->to;
    glint_smoothing *s = &to->smoothing;
    const glint_status status =
        glint_mesh_new(in->path, in->vertices, in->triangles, &to->mesh, in->err);
    if (status != GLINT_OK)
        return status;
    const bool by_groups = in->rule == BY_GROUPS;
    s->creased = !by_groups;
    s->group = malloc(in->triangles * sizeof *s->group);
    s->object = by_groups ? malloc(in->triangles * sizeof *s->object) : NULL;
    if (s->group == NULL || (by_groups && s->object == NULL)) {
        return glint_fail(in->err, GLINT_NO_MEMORY, "%s: not enough memory for %zu triangles",
                          in->path, in->triangles);
    }
    return GLINT_OK;
}

/* The middle becomes the origin, half the largest extent becomes 1. */
static void find_place(reading *in)
{
    const glint_vec3 extent = glint_vec3_sub(in->high, in->low);
    const double size = fmax(extent.x, fmax(extent.y, extent.z));
    in->center = glint_vec3_add(in->low, glint_vec3_scale(extent, 0.5));
    in->scale = size > 0.0 ? 2.0 / size : 1.0;
}

/* Which group belongs to which triangle must be beyond doubt. */
static glint_status check_groups(reading *in)
{
    if (in->rule != BY_GROUPS || groups_fit(in->scene, in->groups))
        return GLINT_OK;
    return bad(in, "damaged: smoothing groups cannot be assigned to triangles");
}

static glint_status convert(reading *in)
{
    if (in->scene->mRootNode == NULL)
        return bad(in, "contains no triangles");
    glint_status status = walk(in, in->scene->mRootNode, &identity, 0);
    if (status == GLINT_OK && in->triangles == 0)
        return bad(in, "contains no triangles");
    if (status == GLINT_OK)
        status = check_groups(in);
    if (status == GLINT_OK) {
        find_place(in);
        status = make_room(in);
    }
    if (status == GLINT_OK)
        status = walk(in, in->scene->mRootNode, &identity, 0);
    if (status == GLINT_OK && in->to->mesh->triangle_count == 0)
        return bad(in, "all of its triangles have two corners that coincide in single precision");
    return status;
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

const char *glint_imported_from(const struct aiScene *scene)
{
    const struct aiMetadata *data = scene->mMetaData;
    for (unsigned i = 0; data != NULL && i < data->mNumProperties; i++)
        if (strcmp(data->mKeys[i].data, AI_METADATA_SOURCE_FORMAT) == 0 &&
            data->mValues[i].mType == AI_AISTRING)
            return ((const struct aiString *)data->mValues[i].mData)->data;
    return "";
}

static rule rule_for(const struct aiScene *scene)
{
    static const struct {
        const char *importer; /* as assimp 5.2 calls them */
        rule rule;
    } rules[] = {
        {"Stereolithography (STL) Importer", FLAT},
        {"glTF Importer", FLAT_MESH},
        {"glTF2 Importer", FLAT_MESH},
        {"Discreet 3DS Importer", BY_GROUPS},
        {"ASE Importer", BY_GROUPS},
    };
    const char *importer = glint_imported_from(scene);
    for (size_t i = 0; i < sizeof rules / sizeof rules[0]; i++)
        if (strcmp(importer, rules[i].importer) == 0)
            return rules[i].rule;
    return BY_CREASES;
}

void glint_imported_clear(glint_imported *imported)
{
    glint_mesh_destroy(imported->mesh);
    free(imported->smoothing.group);
    free(imported->smoothing.object);
    *imported = (glint_imported){.mesh = NULL};
}

glint_status glint_imported_mesh(const char *path, const struct aiScene *scene,
                                 const glint_groups *groups, glint_imported *imported,
                                 glint_error *err)
{
    *imported = (glint_imported){.mesh = NULL};
    reading in = {
        .path = path,
        .scene = scene,
        .groups = groups,
        .rule = rule_for(scene),
        .to = imported,
        .low = {INFINITY, INFINITY, INFINITY},
        .high = {-INFINITY, -INFINITY, -INFINITY},
        .err = err,
    };
    const glint_status status = convert(&in);
    if (status != GLINT_OK)
        glint_imported_clear(imported);
    return status;
}
