/* Mesh files through assimp; see import.h. */
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <stdbool.h>
#include <string.h>

#include "render/detail.h"
#include "render/import.h"
#include "render/imported.h"
#include "render/left_out.h"
#include "render/skin.h"
#include "render/source.h"
#include "render/triangulate.h"

/* A file on its way. */
typedef struct reading {
    const char *path;
    glint_source *source;
    glint_groups *groups; /* NULL for other formats */
    glint_remarks remarks;
    glint_error *err;
} reading;

/* assimp's message as one line of modest length. */
static glint_status refused(const reading *in)
{
    const char *beside = glint_source_refused(in->source);
    char why[256];
    if (beside[0] != '\0') {
        return glint_fail(in->err, GLINT_BAD_INPUT,
                          "%.200s: needs %.200s, which is not a regular file", in->path, beside);
    }
    strncpy(why, aiGetErrorString(), sizeof why - 1);
    why[sizeof why - 1] = '\0';
    why[strcspn(why, "\r\n")] = '\0';
    if (strstr(why, "bad_alloc") != NULL || strstr(why, "length_error") != NULL) {
        return glint_fail(in->err, GLINT_NO_MEMORY,
                          "%.300s: not enough memory to read it: damaged, or too large", in->path);
    }
    return glint_fail(in->err, GLINT_BAD_INPUT, "%.300s: assimp cannot read it: %s", in->path,
                      why[0] != '\0' ? why : "no reason given");
}

/* Some of assimp's readers replace a missing vertex of a face with another one and mention it only
 * in the log, in these words (assimp 5.2). */
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

/* aiLogStreamCallback; user: a bool, set when one of these appears. */
static void listen(const char *message, char *user)
{
    bool *replaced = (bool *)user;
    for (size_t i = 0; i < sizeof replacing / sizeof replacing[0]; i++)
        *replaced = *replaced || strstr(message, replacing[i]) != NULL;
}

static const struct aiScene *read_scene(const reading *in)
{
    struct aiPropertyStore *settings = aiCreatePropertyStore();
    if (settings == NULL)
        return NULL;
    const unsigned steps = aiProcess_ValidateDataStructure;
    const struct aiScene *scene =
        in->groups != NULL
            ? aiImportFileFromMemoryWithProperties((const char *)in->groups->bytes,
                                                   (unsigned)in->groups->count, steps,
                                                   in->groups->format, settings)
            : aiImportFileExWithProperties(in->path, steps, glint_source_io(in->source), settings);
    aiReleasePropertyStore(settings);
    return scene;
}

/* The scene as the file has it, looked through. */
static glint_status read_checked(reading *in, const struct aiScene **scene)
{
    bool replaced = false;
    const struct aiLogStream log = {listen, (char *)&replaced};
    aiAttachLogStream(&log);
    *scene = read_scene(in);
    (void)aiDetachLogStream(&log);
    if (*scene == NULL)
        return refused(in);
    glint_status status =
        replaced ? glint_fail(in->err, GLINT_BAD_INPUT,
                              "%.300s: a face refers to a vertex that does not exist", in->path)
                 : glint_imported_check(in->path, *scene, in->err);
    if (status == GLINT_OK)
        status = glint_skin_pose(in->path, *scene, in->err);
    if (status != GLINT_OK)
        aiReleaseImport(*scene);
    return status;
}

static glint_status read_triangles(reading *in, glint_imported *imported)
{
    const struct aiScene *scene;
    glint_status status = read_checked(in, &scene);
    if (status != GLINT_OK)
        return status;
    glint_left_out(scene, &in->remarks);
    scene = glint_triangulate(scene);
    if (scene == NULL) {
        return glint_fail(in->err, GLINT_NO_MEMORY, "%.300s: not enough memory for its triangles",
                          in->path);
    }
    status = glint_detail_check(in->path, scene, &in->remarks, in->err);
    if (status == GLINT_OK)
        status = glint_imported_mesh(in->path, scene, in->groups, imported, in->err);
    aiReleaseImport(scene);
    return status;
}

static glint_status make_mesh(reading *in, glint_mesh **mesh)
{
    glint_imported imported = {.mesh = NULL};
    glint_status status = read_triangles(in, &imported);
    if (status == GLINT_OK) /* assimp's memory is given back by now */
        status = glint_smooth(in->path, &imported.smoothing, &imported.mesh, in->err);
    if (status == GLINT_OK) {
        *mesh = imported.mesh;
        imported.mesh = NULL;
        memcpy((*mesh)->remarks, in->remarks.text, sizeof in->remarks.text);
    }
    glint_imported_clear(&imported);
    return status;
}

glint_status glint_mesh_import(const char *path, glint_mesh **mesh, glint_error *err)
{
    reading in = {.path = path, .err = err};
    glint_status status = glint_source_open(path, &in.source, &in.remarks, err);
    if (status == GLINT_OK)
        status = glint_groups_read(path, &in.groups, err);
    if (status == GLINT_OK)
        status = make_mesh(&in, mesh);
    glint_groups_destroy(in.groups);
    glint_source_close(in.source);
    return status;
}
