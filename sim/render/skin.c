/* Blends joint matrices and moves the vertices; see skin.h. */
#include "render/skin.h"

#include <stdlib.h>
#include <string.h>

#include "reflectance/vec3.h"
#include "render/imported.h"

#define DEPTH_MAX 256 /* of nodes; those below are refused later */

/* Three rows of four. */
typedef struct matrix {
    double at[3][4];
} matrix;

static const matrix identity = {{{1.0, 0.0, 0.0, 0.0}, {0.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0}}};

static matrix matrix_of(const struct aiMatrix4x4 *m)
{
    return (matrix){{{(double)m->a1, (double)m->a2, (double)m->a3, (double)m->a4},
                     {(double)m->b1, (double)m->b2, (double)m->b3, (double)m->b4},
                     {(double)m->c1, (double)m->c2, (double)m->c3, (double)m->c4}}};
}

static matrix combine(const matrix *outer, const matrix *inner)
{
    matrix product;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 4; k++) {
            product.at[i][k] = k == 3 ? outer->at[i][3] : 0.0;
            for (int j = 0; j < 3; j++)
                product.at[i][k] += outer->at[i][j] * inner->at[j][k];
        }
    }
    return product;
}

/* ---- Joints -------------------------------------------------------------------------------------
 */

typedef struct search {
    const char *name;
    int found;
    matrix place; /* of the first that was found */
} search;

static void find(search *s, const struct aiNode *node, const matrix *outer, int depth)
{
    const matrix own = matrix_of(&node->mTransformation);
    const matrix place = combine(outer, &own);
    if (strcmp(node->mName.data, s->name) == 0 && s->found++ == 0)
        s->place = place;
    for (unsigned i = 0; depth < DEPTH_MAX && i < node->mNumChildren; i++)
        find(s, node->mChildren[i], &place, depth + 1);
}

/* ---- Meshes -------------------------------------------------------------------------------------
 */

/* For each vertex what its joints make of its place, and their weights' sum. */
typedef struct blend {
    matrix sum;
    double weight;
} blend;

static void add_joint(blend *blends, const struct aiMesh *mesh, const struct aiBone *bone,
                      const matrix *place)
{
    const matrix offset = matrix_of(&bone->mOffsetMatrix);
    const matrix moved = combine(place, &offset);
    for (unsigned i = 0; i < bone->mNumWeights; i++) {
        const double weight = (double)bone->mWeights[i].mWeight;
        if (bone->mWeights[i].mVertexId >= mesh->mNumVertices)
            continue;
        blend *b = &blends[bone->mWeights[i].mVertexId];
        b->weight += weight;
        for (int k = 0; k < 12; k++)
            b->sum.at[k / 4][k % 4] += weight * moved.at[k / 4][k % 4];
    }
}

static glint_vec3 row(const matrix *m, int i)
{
    return (glint_vec3){m->at[i][0], m->at[i][1], m->at[i][2]};
}

static struct aiVector3D stored(double x, double y, double z)
{
    return (struct aiVector3D){(float)x, (float)y, (float)z};
}

/* Normals are transformed by the cofactors, as everywhere (imported.c). The sum need not be divided
 * by the weight: only the direction matters. */
static void move_vertex(const blend *b, struct aiVector3D *vertex, struct aiVector3D *normal)
{
    if (!(b->weight > 0.0))
        return; /* of no joint */
    const glint_vec3 r[3] = {row(&b->sum, 0), row(&b->sum, 1), row(&b->sum, 2)};
    const glint_vec3 v = {(double)vertex->x, (double)vertex->y, (double)vertex->z};
    *vertex = stored((glint_vec3_dot(r[0], v) + b->sum.at[0][3]) / b->weight,
                     (glint_vec3_dot(r[1], v) + b->sum.at[1][3]) / b->weight,
                     (glint_vec3_dot(r[2], v) + b->sum.at[2][3]) / b->weight);
    if (normal != NULL) {
        const glint_vec3 n = {(double)normal->x, (double)normal->y, (double)normal->z};
        *normal = stored(glint_vec3_dot(glint_vec3_cross(r[1], r[2]), n),
                         glint_vec3_dot(glint_vec3_cross(r[2], r[0]), n),
                         glint_vec3_dot(glint_vec3_cross(r[0], r[1]), n));
    }
}

static glint_status pose_mesh(const char *path, const struct aiScene *scene, struct aiMesh *mesh,
                              glint_error *err)
{
    blend *blends = calloc((size_t)mesh->mNumVertices + 1, sizeof *blends);
    glint_status status = GLINT_OK;
    if (blends == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "%.300s: not enough memory for its skin", path);
    for (unsigned i = 0; status == GLINT_OK && i < mesh->mNumBones; i++) {
        const struct aiBone *bone = mesh->mBones[i];
        search s = {.name = bone->mName.data};
        find(&s, scene->mRootNode, &identity, 0);
        if (s.found != 1) {
            status =
                glint_fail(err, GLINT_BAD_INPUT,
                           s.found == 0 ? "%.300s: a joint of its skin is not in the scene: %.60s"
                                        : "%.300s: two nodes share the name of a joint: %.60s",
                           path, bone->mName.data);
        } else {
            add_joint(blends, mesh, bone, &s.place);
        }
    }
    for (unsigned i = 0; status == GLINT_OK && i < mesh->mNumVertices; i++) {
        move_vertex(&blends[i], &mesh->mVertices[i],
                    mesh->mNormals != NULL ? &mesh->mNormals[i] : NULL);
    }
    free(blends);
    return status;
}

bool glint_skin_places(const struct aiScene *scene, const struct aiMesh *mesh)
{
    return mesh->mNumBones > 0 && strcmp(glint_imported_from(scene), "glTF2 Importer") == 0;
}

glint_status glint_skin_pose(const char *path, const struct aiScene *scene, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (unsigned i = 0; status == GLINT_OK && i < scene->mNumMeshes; i++)
        if (scene->mRootNode != NULL && glint_skin_places(scene, scene->mMeshes[i]))
            status = pose_mesh(path, scene, scene->mMeshes[i], err);
    return status;
}
