/* Polygons into triangles; see triangulate.h. */
#include "render/triangulate.h"

#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* The coordinates of a mesh as they were; NULL where they are not changed. */
typedef struct aiVector3D *kept;

static bool has_polygons(const struct aiMesh *mesh)
{
    for (unsigned i = 0; i < mesh->mNumFaces; i++)
        if (mesh->mFaces[i].mNumIndices > 3)
            return true;
    return false;
}

static void fit(float *first, unsigned count, double center, double scale)
{
    for (unsigned i = 0; i < count; i++)
        first[3 * (size_t)i] = (float)(((double)first[3 * (size_t)i] - center) * scale);
}

/* Within −1 … 1, along each axis about its own middle. */
static void normalize(struct aiMesh *mesh)
{
    double middle[3], size = 0.0;
    float *p = &mesh->mVertices[0].x;
    for (int axis = 0; axis < 3; axis++) {
        double low = INFINITY, high = -INFINITY;
        for (unsigned i = 0; i < mesh->mNumVertices; i++) {
            const double c = (double)p[3 * (size_t)i + (size_t)axis];
            low = fmin(low, c);
            high = fmax(high, c);
        }
        middle[axis] = low + (high - low) / 2.0;
        size = fmax(size, high - low);
    }
    for (int axis = 0; axis < 3; axis++)
        fit(p + axis, mesh->mNumVertices, middle[axis], size > 0.0 ? 2.0 / size : 1.0);
}

/* False for want of memory. */
static bool normalize_all(const struct aiScene *scene, kept *kept)
{
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        struct aiMesh *mesh = scene->mMeshes[i];
        const size_t bytes = mesh->mNumVertices * sizeof *mesh->mVertices;
        if (bytes == 0 || !has_polygons(mesh))
            continue;
        kept[i] = malloc(bytes);
        if (kept[i] == NULL)
            return false;
        memcpy(kept[i], mesh->mVertices, bytes);
        normalize(mesh);
    }
    return true;
}

/* The step neither adds meshes nor moves vertices. */
static void restore_all(const struct aiScene *scene, kept *kept, unsigned meshes)
{
    for (unsigned i = 0; i < meshes; i++) {
        if (scene != NULL && kept[i] != NULL) {
            struct aiMesh *mesh = scene->mMeshes[i];
            memcpy(mesh->mVertices, kept[i], mesh->mNumVertices * sizeof *mesh->mVertices);
        }
        free(kept[i]);
    }
}

const struct aiScene *glint_triangulate(const struct aiScene *scene)
{
    const unsigned meshes = scene->mNumMeshes;
    kept *kept = calloc((size_t)meshes + 1, sizeof *kept);
    if (kept == NULL) {
        aiReleaseImport(scene);
        return NULL;
    }
    if (normalize_all(scene, kept)) {
        scene = aiApplyPostProcessing(scene, aiProcess_Triangulate);
    } else {
        aiReleaseImport(scene);
        scene = NULL;
    }
    restore_all(scene, kept, meshes);
    free(kept);
    return scene;
}
