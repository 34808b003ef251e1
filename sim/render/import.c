/* Mesh files through assimp; see import.h. */
#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <stdbool.h>
#include <string.h>

#include "render/import.h"
#include "render/imported.h"

/* Where normals have to be made, faces that meet at more than this stay apart: a cube keeps its
 * edges, a coarse animal still looks round. */
#define CREASE_DEGREES 66.0f

/* assimp's message as one line of modest length. */
static glint_status refused(const char *path, glint_error *err)
{
    char why[256];
    strncpy(why, aiGetErrorString(), sizeof why - 1);
    why[sizeof why - 1] = '\0';
    why[strcspn(why, "\r\n")] = '\0';
    if (strstr(why, "bad_alloc") != NULL || strstr(why, "length_error") != NULL) {
        return glint_fail(err, GLINT_NO_MEMORY,
                          "%.300s: not enough memory to read it: damaged, or too large", path);
    }
    return glint_fail(err, GLINT_BAD_INPUT, "%.300s: assimp cannot read it: %s", path,
                      why[0] != '\0' ? why : "no reason given");
}

/* Some of assimp's readers put another vertex in the place of one that a face names and that is not
 * there, and say so in the log only; in these words, which are those of assimp 5.2. */
static const char *const replacing[] = {
    "3DS: Vertex index overflow",
    "AC3D: Invalid vertex reference",
    "Index overflow in MDL7 vertex list",
    "Index overflow in MDLn vertex list",
    "Index overflow in Q1-MDL vertex list",
    "LWO2: Failure evaluating face record, index is out of range",
    "LWOB: face index is out of range",
    "MD2: Vertex index is outside the allowed range",
    "MDC vertex index is out of range",
    "NFF2: Vertex index overflow",
    "OFF: Vertex index is out of range",
    "Quick3D: Vertex index overflow",
};

/* aiLogStreamCallback; user: a bool, set where one of these is said. */
static void listen(const char *message, char *user)
{
    bool *replaced = (bool *)user;
    for (size_t i = 0; i < sizeof replacing / sizeof replacing[0]; i++) {
        *replaced = *replaced || strstr(message, replacing[i]) != NULL;
    }
}

static const struct aiScene *read_scene(const char *path, unsigned steps)
{
    struct aiPropertyStore *settings = aiCreatePropertyStore();
    if (settings == NULL) {
        return NULL;
    }
    /* Faces that are not triangles after all are sorted apart, then dropped. */
    aiSetImportPropertyInteger(settings, AI_CONFIG_PP_SBP_REMOVE,
                               aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    aiSetImportPropertyFloat(settings, AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, CREASE_DEGREES);
    const struct aiScene *scene = aiImportFileExWithProperties(path, steps, NULL, settings);
    aiReleasePropertyStore(settings);
    return scene;
}

/* The file is first read as it is and looked through: when assimp joins equal vertices, a NaN
 * equals everything to it, and the damage would be lost in the joining. It is then read anew with
 * all steps, as a scene whose later processing fails is released twice (assimp 5.2). */
static glint_status check_content(const char *path, glint_error *err)
{
    bool replaced = false;
    const struct aiLogStream log = {listen, (char *)&replaced};
    aiAttachLogStream(&log);
    const struct aiScene *scene = read_scene(path, aiProcess_ValidateDataStructure);
    (void)aiDetachLogStream(&log);
    if (scene == NULL) {
        return refused(path, err);
    }
    const glint_status status =
        replaced ? glint_fail(err, GLINT_BAD_INPUT,
                              "%.300s: a face names a vertex that is not there", path)
                 : glint_imported_check(path, scene, err);
    aiReleaseImport(scene);
    return status;
}

glint_status glint_mesh_import(const char *path, glint_mesh **mesh, glint_error *err)
{
    glint_status status = check_content(path, err);
    if (status != GLINT_OK) {
        return status;
    }
    const struct aiScene *scene = read_scene(
        path, aiProcess_ValidateDataStructure | aiProcess_Triangulate | aiProcess_SortByPType |
                  aiProcess_GenSmoothNormals | aiProcess_JoinIdenticalVertices);
    if (scene == NULL) {
        return refused(path, err);
    }
    status = glint_imported_mesh(path, scene, mesh, err);
    aiReleaseImport(scene);
    return status;
}
