/* A mesh through the rasterizer; see fuzz.h. */
#include <math.h>
#include <string.h>

#include "fuzz.h"
#include "reflectance/vec3.h"
#include "render/render.h"

#define WIDTH  40
#define HEIGHT 30

static void expect_sound(const glint_mesh *mesh)
{
    FUZZ_EXPECT(mesh->triangle_count > 0);
    for (size_t i = 0; i < 3 * mesh->vertex_count; i++)
        FUZZ_EXPECT(isfinite(mesh->position[i]));
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        const glint_vec3 n = glint_vec3_of(&mesh->normal[3 * v]);
        FUZZ_EXPECT(fabs(glint_vec3_length(n) - 1.0) < 1e-5);
    }
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++)
        FUZZ_EXPECT(mesh->index[i] < mesh->vertex_count);
}

static glint_scene view_of(const glint_mesh *mesh, uint32_t view)
{
    static const float distances[] = {0.0f, 0.0f, 1e-6f, 0.5f, 1.0f, 3.0f, 50.0f, 1000.0f};
    glint_scene scene = {.mesh = mesh};
    glint_scene_defaults(&scene);
    scene.shading = (glint_shading)(view % GLINT_SHADING_WIRES);
    scene.distance = distances[view >> 2 & 7];
    scene.yaw = (float)(view >> 5 & 31) * 13.0f;
    scene.pitch = (float)(view >> 10 & 31) * 7.0f - 90.0f;
    scene.fov = (float)(view >> 15 & 63) * 2.5f + 5.0f;
    scene.n = (uint16_t)(view >> 21 & 1023);
    return scene;
}

/* Made once: threads are not what is tested. */
static glint_renderer *renderer_of(int which)
{
    static glint_renderer *made[2];
    const glint_backend_config config = {.kind = GLINT_BACKEND_C};
    if (made[which] == NULL) {
        FUZZ_EXPECT(glint_renderer_create(WIDTH, HEIGHT, which == 0 ? 1 : 3, &config, &made[which],
                                          NULL) == GLINT_OK);
    }
    return made[which];
}

static uint64_t count_object(const glint_image *image)
{
    uint64_t pixels = 0;
    for (size_t i = 0; i < (size_t)WIDTH * HEIGHT; i++) {
        FUZZ_EXPECT(image->object[i] <= 1);
        pixels += image->object[i];
    }
    return pixels;
}

void fuzz_draw(const glint_mesh *mesh, uint32_t view)
{
    expect_sound(mesh);
    const glint_scene scene = view_of(mesh, view);
    glint_image *image[2];
    glint_render_stats stats[2];
    for (int i = 0; i < 2; i++) {
        glint_error err = {""};
        FUZZ_EXPECT(glint_image_create(WIDTH, HEIGHT, &image[i], NULL) == GLINT_OK);
        FUZZ_EXPECT(glint_render(renderer_of(i), &scene, image[i], NULL, &stats[i], &err) ==
                    GLINT_OK);
        FUZZ_EXPECT(count_object(image[i]) == stats[i].fragments);
    }
    FUZZ_EXPECT(stats[0].drawn == stats[1].drawn);
    FUZZ_EXPECT(stats[0].drawn <= mesh->triangle_count);
    FUZZ_EXPECT(memcmp(image[0]->rgb, image[1]->rgb, 3 * WIDTH * HEIGHT) == 0);
    FUZZ_EXPECT(memcmp(image[0]->object, image[1]->object, WIDTH * HEIGHT) == 0);
    glint_image_destroy(image[0]);
    glint_image_destroy(image[1]);
}
