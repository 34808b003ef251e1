/* Fuzz target: a scene as assimp hands it over, with coordinates, indices, nodes and transforms of
 * any value; our own half of the import, then the rasterizer. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "render/detail.h"
#include "render/imported.h"

#define MESHES_MAX   4
#define VERTICES_MAX 16
#define FACES_MAX    16
#define DEEP         300 /* deeper than the import goes */

typedef struct source {
    const uint8_t *bytes;
    size_t count;
} source;

static uint8_t take(source *from)
{
    return fuzz_take(&from->bytes, &from->count);
}

/* Mostly small numbers, so that there is something to see; else a special one, or any bits. */
static float take_float(source *from)
{
    static const float special[] = {NAN,     INFINITY, -INFINITY, FLT_MAX,  -FLT_MAX, FLT_MIN,
                                    1e-45f,  1e18f,    -1e18f,    1.1e18f,  1e9f,     1e-9f,
                                    -1e-30f, 1e30f,    -0.0f,     0x1p-126f};
    const uint8_t kind = take(from);
    if (kind < 224)
        return (float)(int8_t)take(from) / 16.0f;
    if (kind < 248)
        return special[take(from) % (sizeof special / sizeof special[0])];
    uint32_t bits = 0;
    for (int i = 0; i < 4; i++)
        bits = bits << 8 | take(from);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static void *room(size_t count, size_t size)
{
    void *made = calloc(count > 0 ? count : 1, size);
    FUZZ_EXPECT(made != NULL);
    return made;
}

static struct aiVector3D *take_vectors(source *from, unsigned count)
{
    struct aiVector3D *made = room(count, sizeof *made);
    for (unsigned i = 0; i < count; i++)
        made[i] = (struct aiVector3D){take_float(from), take_float(from), take_float(from)};
    return made;
}

static void take_face(source *from, unsigned vertices, struct aiFace *face)
{
    const uint8_t kind = take(from);
    face->mNumIndices = kind < 240 ? 3 : kind % 6;
    face->mIndices = room(face->mNumIndices, sizeof *face->mIndices);
    for (unsigned i = 0; i < face->mNumIndices; i++) {
        const uint8_t which = take(from);
        face->mIndices[i] = which < 250 && vertices > 0 ? which % vertices : UINT32_MAX - which;
    }
}

static struct aiMesh *take_mesh(source *from)
{
    struct aiMesh *mesh = room(1, sizeof *mesh);
    mesh->mNumVertices = take(from) % (VERTICES_MAX + 1);
    mesh->mVertices = take_vectors(from, mesh->mNumVertices);
    if (take(from) % 2 == 1)
        mesh->mNormals = take_vectors(from, mesh->mNumVertices);
    mesh->mNumFaces = take(from) % (FACES_MAX + 1);
    mesh->mFaces = room(mesh->mNumFaces, sizeof *mesh->mFaces);
    for (unsigned i = 0; i < mesh->mNumFaces; i++)
        take_face(from, mesh->mNumVertices, &mesh->mFaces[i]);
    return mesh;
}

static struct aiMatrix4x4 take_transform(source *from)
{
    struct aiMatrix4x4 m = {.a1 = 1.0f, .b2 = 1.0f, .c3 = 1.0f, .d4 = 1.0f};
    float *const element[] = {&m.a1, &m.a2, &m.a3, &m.a4, &m.b1, &m.b2,
                              &m.b3, &m.b4, &m.c1, &m.c2, &m.c3, &m.c4};
    for (int changes = take(from) % 5; changes > 0; changes--) {
        const uint8_t which = take(from);
        *element[which % 12] = take_float(from);
    }
    return m;
}

/* Children come depth first; once the bytes are used up there are none. */
static struct aiNode *take_node(source *from, int depth)
{
    struct aiNode *node = room(1, sizeof *node);
    const uint8_t kind = take(from);
    node->mTransformation = take_transform(from);
    node->mNumMeshes = kind % 4;
    node->mMeshes = room(node->mNumMeshes, sizeof *node->mMeshes);
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        const uint8_t which = take(from);
        node->mMeshes[i] = which < 250 ? which % MESHES_MAX : UINT32_MAX;
    }
    node->mNumChildren = kind == 255 && depth < DEEP ? 1 : depth < 8 ? kind >> 2 & 3 : 0;
    node->mChildren = (struct aiNode **)room(node->mNumChildren, sizeof *node->mChildren);
    for (unsigned i = 0; i < node->mNumChildren; i++)
        node->mChildren[i] = take_node(from, depth + 1);
    return node;
}

static void free_node(struct aiNode *node)
{
    for (unsigned i = 0; i < node->mNumChildren; i++)
        free_node(node->mChildren[i]);
    free(node->mMeshes);
    free((void *)node->mChildren);
    free(node);
}

static void free_mesh(struct aiMesh *mesh)
{
    for (unsigned i = 0; i < mesh->mNumFaces; i++)
        free(mesh->mFaces[i].mIndices);
    free(mesh->mFaces);
    free(mesh->mVertices);
    free(mesh->mNormals);
    free(mesh);
}

static void import_and_draw(const struct aiScene *scene, uint32_t view)
{
    glint_imported imported = {.mesh = NULL};
    glint_remarks remarks = {""};
    glint_error err = {""};
    glint_status status = glint_imported_check("scene", scene, &err);
    if (status == GLINT_OK)
        status = glint_detail_check("scene", scene, &remarks, &err);
    if (status == GLINT_OK)
        status = glint_imported_mesh("scene", scene, NULL, &imported, &err);
    if (status == GLINT_OK)
        status = glint_smooth("scene", &imported.smoothing, &imported.mesh, &err);
    FUZZ_EXPECT(status == GLINT_OK || status == GLINT_BAD_INPUT);
    FUZZ_EXPECT((status == GLINT_OK) == (imported.mesh != NULL));
    FUZZ_EXPECT((status == GLINT_OK) == (err.text[0] == '\0'));
    if (status == GLINT_OK)
        fuzz_draw(imported.mesh, view);
    glint_imported_clear(&imported);
}

int fuzz_scene(const uint8_t *bytes, size_t count)
{
    source from = {bytes, count};
    uint32_t view = 0;
    struct aiScene *scene = room(1, sizeof *scene);
    for (int i = 0; i < 4; i++)
        view = view << 8 | take(&from);
    scene->mNumMeshes = 1 + take(&from) % MESHES_MAX;
    scene->mMeshes = (struct aiMesh **)room(scene->mNumMeshes, sizeof *scene->mMeshes);
    for (unsigned i = 0; i < scene->mNumMeshes; i++)
        scene->mMeshes[i] = take_mesh(&from);
    scene->mRootNode = from.count > 0 ? take_node(&from, 0) : NULL;
    import_and_draw(scene, view);
    for (unsigned i = 0; i < scene->mNumMeshes; i++)
        free_mesh(scene->mMeshes[i]);
    if (scene->mRootNode != NULL)
        free_node(scene->mRootNode);
    free((void *)scene->mMeshes);
    free(scene);
    return 0;
}
