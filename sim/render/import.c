/* Mesh files through assimp; see import.h. */
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <stdbool.h>
#include <string.h>

#include "render/detail.h"
#include "render/import.h"
#include "render/imported.h"
#include "render/triangulate.h"

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

static const struct aiScene *read_scene(const char *path, const glint_groups3ds *groups)
{
    struct aiPropertyStore *settings = aiCreatePropertyStore();
    if (settings == NULL) {
        return NULL;
    }
    const unsigned steps = aiProcess_ValidateDataStructure;
    const struct aiScene *scene =
        groups != NULL
            ? aiImportFileFromMemoryWithProperties((const char *)groups->bytes,
                                                   (unsigned)groups->count, steps, "3ds", settings)
            : aiImportFileExWithProperties(path, steps, NULL, settings);
    aiReleasePropertyStore(settings);
    return scene;
}

/* The scene as the file has it, looked through. */
static glint_status read_checked(const char *path, const glint_groups3ds *groups,
                                 const struct aiScene **scene, glint_error *err)
{
    bool replaced = false;
    const struct aiLogStream log = {listen, (char *)&replaced};
    aiAttachLogStream(&log);
    *scene = read_scene(path, groups);
    (void)aiDetachLogStream(&log);
    if (*scene == NULL) {
        return refused(path, err);
    }
    const glint_status status =
        replaced ? glint_fail(err, GLINT_BAD_INPUT,
                              "%.300s: a face names a vertex that is not there", path)
                 : glint_imported_check(path, *scene, err);
    if (status != GLINT_OK) {
        aiReleaseImport(*scene);
    }
    return status;
}

static glint_status read_triangles(const char *path, const glint_groups3ds *groups,
                                   glint_imported *imported, glint_error *err)
{
    const struct aiScene *scene;
    glint_status status = read_checked(path, groups, &scene, err);
    if (status != GLINT_OK) {
        return status;
    }
    scene = glint_triangulate(scene);
    if (scene == NULL) {
        return glint_fail(err, GLINT_NO_MEMORY, "%.300s: no memory for its triangles", path);
    }
    status = glint_detail_check(path, scene, err);
    if (status == GLINT_OK) {
        status = glint_imported_mesh(path, scene, groups, imported, err);
    }
    aiReleaseImport(scene);
    return status;
}

glint_status glint_mesh_import(const char *path, glint_mesh **mesh, glint_error *err)
{
    glint_groups3ds *groups;
    glint_status status = glint_groups3ds_read(path, &groups, err);
    if (status != GLINT_OK) {
        return status;
    }
    glint_imported imported = {.mesh = NULL};
    status = read_triangles(path, groups, &imported, err);
    glint_groups3ds_destroy(groups);
    if (status == GLINT_OK) { /* assimp's memory is given back by now */
        status = glint_smooth(path, &imported.smoothing, &imported.mesh, err);
    }
    if (status == GLINT_OK) {
        *mesh = imported.mesh;
        imported.mesh = NULL;
    }
    glint_imported_clear(&imported);
    return status;
}
