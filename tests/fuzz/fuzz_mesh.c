/* Fuzz target: a mesh file of any format, through assimp and the rasterizer.
 *
 * assimp is the system's library, not compiled for coverage; it runs in the process that
 * glint_mesh_load() gives it. How often it was stopped there is printed at the end: each of those
 * would have been a crash of the command. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "render/load.h"

/* Of assimp's formats, those of triangles that people exchange. */
static const char *const endings[] = {"obj", "ply", "stl", "3ds", "off",  "dae",
                                      "x",   "ac",  "ase", "fbx", "gltf", "lwo"};

static unsigned long crashed, stopped, drawn;

static void say_counts(void)
{
    printf("mesh: %lu drawn; assimp crashed %lu times and was stopped %lu times, all contained\n",
           drawn, crashed, stopped);
}

static void expect_message(const glint_error *err)
{
    FUZZ_EXPECT(err->text[0] != '\0' && strchr(err->text, '\n') == NULL);
    crashed += strstr(err->text, "assimp crashed") != NULL;
    stopped += strstr(err->text, "was stopped") != NULL;
}

static void load_and_draw(const char *path, uint32_t view)
{
    const glint_load_limits limits = {.seconds = 1, .bytes = (size_t)256 << 20};
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    const glint_status status = glint_mesh_load_within(path, &limits, NULL, &mesh, &err);
    FUZZ_EXPECT(status == GLINT_OK || status == GLINT_BAD_INPUT || status == GLINT_NO_MEMORY);
    FUZZ_EXPECT((status == GLINT_OK) == (mesh != NULL));
    if (status == GLINT_OK) {
        fuzz_draw(mesh, view);
        drawn++;
    } else {
        expect_message(&err);
    }
    glint_mesh_destroy(mesh);
}

int fuzz_mesh(const uint8_t *bytes, size_t count)
{
    static int counting;
    char line[32], name[16];
    if (!counting)
        counting = atexit(say_counts) == 0;
    const size_t taken = fuzz_first_line(bytes, count, line, sizeof line);
    for (size_t i = 0; i < sizeof endings / sizeof endings[0]; i++) {
        if (strcmp(line, endings[i]) == 0) {
            snprintf(name, sizeof name, "mesh.%s", endings[i]);
            load_and_draw(fuzz_write(name, bytes + taken, count - taken),
                          (uint32_t)count * 2654435761u);
            return 0;
        }
    }
    return -1; /* libFuzzer does not keep it */
}
