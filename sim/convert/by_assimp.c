/* A mesh as assimp's scene, for its exporters. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include <assimp/cexport.h>
#include <assimp/cimport.h>
#include <assimp/scene.h>

#include "convert/formats.h"

/* The mesh's own arrays serve: both have three floats a vertex. */
_Static_assert(sizeof(struct aiVector3D) == 3 * sizeof(float), "assimp of single precision");

static bool fill_faces(const glint_mesh *from, struct aiMesh *to)
{
    to->mFaces = malloc(from->triangle_count * sizeof *to->mFaces);
    for (size_t i = 0; to->mFaces != NULL && i < from->triangle_count; i++) {
        to->mFaces[i].mNumIndices = 3;
        to->mFaces[i].mIndices = &from->index[3 * i];
    }
    return to->mFaces != NULL;
}

static glint_status export_scene(const struct aiScene *scene, const char *exporter, FILE *out,
                                 glint_error *err)
{
    const struct aiExportDataBlob *blob = aiExportSceneToBlob(scene, exporter, 0);
    if (blob == NULL)
        return glint_fail(err, GLINT_BAD_INPUT, "assimp cannot write this mesh: %.300s",
                          aiGetErrorString());
    const bool whole = fwrite(blob->data, 1, blob->size, out) == blob->size;
    const int why = errno;
    aiReleaseExportBlob(blob);
    return whole ? GLINT_OK
                 : glint_fail(err, GLINT_IO_ERROR, "cannot write the mesh: %s", strerror(why));
}

glint_status glint_write_by_assimp(const glint_mesh *mesh, const char *exporter, FILE *out,
                                   glint_converted *converted, glint_error *err)
{
    unsigned first = 0;
    struct aiMaterial material = {.mNumProperties = 0};
    struct aiMaterial *materials[] = {&material};
    struct aiMesh shape = {
        .mPrimitiveTypes = aiPrimitiveType_TRIANGLE,
        .mNumVertices = (unsigned)mesh->vertex_count,
        .mNumFaces = (unsigned)mesh->triangle_count,
        .mVertices = (struct aiVector3D *)mesh->position,
        .mNormals = (struct aiVector3D *)mesh->normal,
    };
    struct aiMesh *shapes[] = {&shape};
    struct aiNode node = {.mNumMeshes = 1, .mMeshes = &first};
    node.mTransformation.a1 = node.mTransformation.b2 = 1.0f;
    node.mTransformation.c3 = node.mTransformation.d4 = 1.0f;
    const struct aiScene scene = {.mRootNode = &node,
                                  .mNumMeshes = 1,
                                  .mMeshes = shapes,
                                  .mNumMaterials = 1,
                                  .mMaterials = materials};
    if (!fill_faces(mesh, &shape))
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for %zu triangles",
                          mesh->triangle_count);
    const glint_status status = export_scene(&scene, exporter, out, err);
    free(shape.mFaces);
    converted->objects = 1;
    converted->vertices = mesh->vertex_count;
    converted->triangles = mesh->triangle_count;
    return status;
}
