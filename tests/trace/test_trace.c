/* Traced frames: against the rasterizer, and shadows and mirrors against plane geometry worked out
 * here. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../render/studio.h"
#include "render/camera.h"
#include "render/mesh_build.h"
#include "render/transform.h"
#include "trace/trace.h"

static const glint_join every_pixel = {.centre = -1};

static glint_scene scene_of(const glint_mesh *mesh)
{
    glint_scene scene = {.mesh = mesh};
    glint_scene_defaults(&scene);
    return scene;
}

static glint_tracer_config config_of(const glint_scene *scene, int width, int height)
{
    return (glint_tracer_config){.width = width,
                                 .height = height,
                                 .threads = 1,
                                 .backend = {.pipeline = GLINT_PIPELINE_PIPELINED},
                                 .scene = *scene};
}

static glint_image *traced(const glint_tracer_config *config, const glint_join *how,
                           glint_trace_stats *stats)
{
    glint_tracer *tracer;
    glint_image *image;
    glint_error err = {""};
    if (glint_tracer_create(config, &tracer, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    assert_int_equal(glint_image_create(config->width, config->height, &image, &err), GLINT_OK);
    assert_int_equal(glint_trace(tracer, how, image, stats, &err), GLINT_OK);
    glint_tracer_destroy(tracer);
    return image;
}

static glint_mesh *teapot(int density)
{
    glint_mesh *mesh;
    glint_error err;
    assert_int_equal(glint_mesh_teapot(density, &mesh, &err), GLINT_OK);
    return mesh;
}

/* ---- The rasterizer's picture ---------------------------------------------------------------- */

/* The bound of docs/tracing.md: at most one pixel of 10 000 is at an edge that the two see on
 * different sides; of the others at most one of 500 differs, by one level. */
static void compare_with_rasterizer(const glint_scene *scene, int width, int height)
{
    glint_trace_stats stats;
    const glint_tracer_config config = config_of(scene, width, height);
    glint_image *image = traced(&config, &every_pixel, &stats);
    studio s = open_studio(width, height, 1, GLINT_BACKEND_C);
    shoot(&s, scene);
    uint64_t edges = 0, differing = 0, both = 0;
    const uint64_t pixels = (uint64_t)width * (uint64_t)height;
    for (size_t i = 0; i < pixels; i++) {
        int largest = 0;
        edges += image->object[i] != s.image->object[i];
        if (!image->object[i] || !s.image->object[i])
            continue;
        for (size_t c = 0; c < 3; c++) {
            const int d = abs(image->rgb[3 * i + c] - s.image->rgb[3 * i + c]);
            largest = d > largest ? d : largest;
        }
        edges += largest > 1;
        differing += largest == 1;
        both++;
    }
    print_message("%" PRIu64 " of %" PRIu64 " pixels differ by a level, %" PRIu64 " at edges\n",
                  differing, both, edges);
    assert_int_equal(stats.join.traced, pixels);
    assert_true(edges <= pixels / 10000);
    assert_true(differing <= both / 500);
    close_studio(&s);
    glint_image_destroy(image);
}

static void full_traces_are_the_rasterizers_frames(void **state)
{
    (void)state;
    static const struct {
        float yaw, pitch, distance, fov;
        uint16_t n;
    } views[] = {
        {25, 22, 0, 35, 80}, {130, -50, 0, 35, 1023}, {10, 60, 1.3f, 90, 5}, {25, 22, 900, 1, 300}};
    glint_error err;
    for (int model = 0; model < 3; model++) {
        glint_mesh *mesh = teapot(12);
        if (model > 0)
            glint_mesh_destroy(mesh);
        if (model == 1)
            assert_int_equal(glint_mesh_sphere(64, &mesh, &err), GLINT_OK);
        if (model == 2)
            assert_int_equal(glint_mesh_quad(&mesh, &err), GLINT_OK);
        for (size_t i = 0; i < sizeof views / sizeof views[0]; i++) {
            glint_scene scene = scene_of(mesh);
            scene.yaw = views[i].yaw;
            scene.pitch = views[i].pitch;
            scene.distance = views[i].distance;
            scene.fov = views[i].fov;
            scene.n = views[i].n;
            compare_with_rasterizer(&scene, 320, 240);
        }
        glint_mesh_destroy(mesh);
    }
}

static void frames_of_one_pixel_and_narrow_ones(void **state)
{
    (void)state;
    static const int sizes[][2] = {{1, 1}, {1, 50}, {50, 1}, {2, 2}, {5, 40}};
    glint_mesh *mesh = teapot(8);
    const glint_scene scene = scene_of(mesh);
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        const glint_tracer_config config = config_of(&scene, sizes[i][0], sizes[i][1]);
        glint_image *full = traced(&config, &every_pixel, NULL);
        for (int fill = 0; fill < GLINT_FILL_COUNT; fill++) {
            const glint_join how = {.segment = 7, .centre = -1, .fill = (glint_fill)fill};
            glint_image_difference difference;
            glint_error err;
            glint_image *image = traced(&config, &how, NULL);
            assert_int_equal(glint_image_compare(full, image, &difference, &err), GLINT_OK);
            if (sizes[i][0] * sizes[i][1] <= 4)
                assert_int_equal(difference.differing_pixels, 0);
            glint_image_destroy(image);
        }
        glint_image_destroy(full);
    }
    glint_mesh_destroy(mesh);
}

/* A reflectance model in place of the device is the same model. */
static void a_model_gives_the_rasterizers_highlights(void **state)
{
    (void)state;
    static const glint_reflectance_model models[] = {
        GLINT_REFLECTANCE_PHONG, GLINT_REFLECTANCE_BLINN, GLINT_REFLECTANCE_COOK_TORRANCE,
        GLINT_REFLECTANCE_LAMBERT};
    glint_mesh *mesh = teapot(8);
    for (size_t i = 0; i < sizeof models / sizeof models[0]; i++) {
        glint_scene scene = scene_of(mesh);
        glint_image_difference difference;
        glint_error err;
        scene.by_model = true;
        scene.specular = models[i];
        glint_tracer_config config = config_of(&scene, 160, 120);
        config.backend.kind = GLINT_BACKEND_REAL;
        glint_image *image = traced(&config, &every_pixel, NULL);
        studio s = open_studio(160, 120, 1, GLINT_BACKEND_REAL);
        shoot(&s, &scene);
        assert_int_equal(glint_image_compare(image, s.image, &difference, &err), GLINT_OK);
        assert_in_range(difference.largest, 0, 1);
        close_studio(&s);
        glint_image_destroy(image);
    }
    glint_mesh_destroy(mesh);
}

/* ---- Segments -------------------------------------------------------------------------------- */

static void threads_do_not_change_the_picture(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot(10);
    const glint_scene scene = scene_of(mesh);
    for (int fill = 0; fill < GLINT_FILL_COUNT; fill++) {
        const glint_join how = {
            .segment = 9, .centre = -1, .fill = (glint_fill)fill, .limit = GLINT_LIMIT_DEFAULT};
        glint_tracer_config config = config_of(&scene, 200, 150);
        glint_trace_stats one, five;
        config.shadows = true;
        config.reflect = 0.5;
        glint_image *a = traced(&config, &how, &one);
        config.threads = 5;
        glint_image *b = traced(&config, &how, &five);
        assert_memory_equal(a->rgb, b->rgb, 3 * 200 * 150);
        assert_memory_equal(a->object, b->object, 200 * 150);
        assert_int_equal(one.join.traced, five.join.traced);
        assert_int_equal(one.hits, five.hits);
        assert_int_equal(one.shadow_rays, five.shadow_rays);
        assert_int_equal(one.mirror_rays, five.mirror_rays);
        assert_int_equal(one.highlights, five.highlights);
        glint_image_destroy(a);
        glint_image_destroy(b);
    }
    glint_mesh_destroy(mesh);
}

/* What is traced is exact, and less is traced the longer the segments; so the error grows. */
static void longer_segments_cost_less_and_err_more(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot(10);
    const glint_scene scene = scene_of(mesh);
    const glint_tracer_config config = config_of(&scene, 320, 240);
    glint_image *full = traced(&config, &every_pixel, NULL);
    uint64_t fewest = UINT64_MAX;
    double error = 0.0;
    for (int segment = 1; segment <= 31; segment = 2 * segment + 1) {
        const glint_join how = {
            .segment = segment, .centre = -1, .fill = GLINT_FILL_LINEAR, .limit = (double)INFINITY};
        glint_trace_stats stats;
        glint_image_difference difference;
        glint_error err;
        glint_image *image = traced(&config, &how, &stats);
        assert_int_equal(glint_image_compare(full, image, &difference, &err), GLINT_OK);
        assert_true(stats.join.traced < fewest);
        assert_true(difference.nmse > error);
        fewest = stats.join.traced;
        error = difference.nmse;
        glint_image_destroy(image);
    }
    glint_image_destroy(full);
    glint_mesh_destroy(mesh);
}

/* ---- Shadows and mirrors --------------------------------------------------------------------- */

/* A square at that height whose normal is up or down. */
static void add_square(glint_mesh *mesh, double side, double height, bool up)
{
    const uint32_t first = (uint32_t)mesh->vertex_count;
    const glint_vec3 normal = {0, up ? 1 : -1, 0};
    for (int i = 0; i < 4; i++)
        glint_mesh_add_vertex(
            mesh, (glint_vec3){i == 0 || i == 3 ? -side : side, height, i < 2 ? side : -side},
            normal);
    const uint32_t last = up ? 2 : 1;
    glint_mesh_add_triangle(mesh, first, first + 3 - last, first + last);
    glint_mesh_add_triangle(mesh, first, first + (up ? 2 : 3), first + (up ? 3 : 2));
}

#define FLOOR  2.0
#define PLATE  0.5
#define HEIGHT 0.75
#define CLOSE  1e-3 /* to an edge: the pixel is not judged */

/* A floor, and a plate with two sides above it. */
static glint_mesh *floor_and_plate(void)
{
    glint_mesh *mesh;
    glint_error err;
    assert_int_equal(glint_mesh_new("plate", 12, 6, &mesh, &err), GLINT_OK);
    add_square(mesh, FLOOR, 0.0, true);
    add_square(mesh, PLATE, HEIGHT, true);
    add_square(mesh, PLATE, HEIGHT, false);
    return mesh;
}

/* In the mesh's axes: where the line meets the height. */
static glint_vec3 at_height(glint_vec3 from, glint_vec3 way, double height)
{
    return glint_vec3_add(from, glint_vec3_scale(way, (height - from.y) / way.y));
}

/* Within the square, beyond it, or 0 when too close to say. */
static int within(glint_vec3 p, double side)
{
    const double out = fmax(fabs(p.x), fabs(p.z)) - side;
    return out < -CLOSE ? 1 : out > CLOSE ? -1 : 0;
}

static glint_vec3 in_object_axes(const glint_camera *camera, glint_vec3 v)
{
    return glint_vec3_add(
        glint_vec3_add(glint_vec3_scale(camera->right, v.x), glint_vec3_scale(camera->up, v.y)),
        glint_vec3_scale(camera->back, v.z));
}

/* What a pixel shows. */
typedef struct sight {
    bool sure, floor, shadow, mirror; /* the floor, in the plate's shadow, mirroring the plate */
} sight;

static sight look(const glint_scene *scene, const glint_camera *camera, int x, int y)
{
    const glint_vec3 ray =
        in_object_axes(camera, (glint_vec3){(x + 0.5 - camera->half_width) / camera->focal,
                                            (camera->half_height - y - 0.5) / camera->focal, -1.0});
    glint_vec3 eye =
        in_object_axes(camera, (glint_vec3){camera->aim_x, camera->aim_y, camera->distance});
    eye = glint_vec3_add(glint_vec3_scale(eye, 1.0 / camera->scale), camera->centre);
    const glint_vec3 light = in_object_axes(camera, glint_vec3_of(scene->light));
    const glint_vec3 at = at_height(eye, ray, 0.0);
    const int plate = within(at_height(eye, ray, HEIGHT), PLATE);
    const int floor = within(at, FLOOR);
    const int shadow = within(at_height(at, light, HEIGHT), PLATE);
    const int mirror = within(at_height(at, (glint_vec3){ray.x, -ray.y, ray.z}, HEIGHT), PLATE);
    return (sight){.sure = plate != 0 && floor != 0 && shadow != 0 && mirror != 0,
                   .floor = floor > 0 && plate<0, .shadow = shadow> 0,
                   .mirror = mirror > 0};
}

static uint8_t rounded(double value)
{
    return (uint8_t)(value + 0.5);
}

/* Without a highlight a floor has three colours: lit, in shadow, and either with the plate's under
 * side, which the light does not reach, in its mirror. */
static void shadows_and_mirrors_are_where_geometry_has_them(void **state)
{
    (void)state;
    enum { W = 320, H = 240 };
    glint_mesh *mesh = floor_and_plate();
    glint_scene scene = scene_of(mesh);
    scene.ks = 0.0f;
    scene.light[0] = 0.3f;
    glint_tracer_config config = config_of(&scene, W, H);
    const glint_camera camera = glint_camera_of(&scene, W, H);
    int seen[2][2] = {{0}};
    config.shadows = true;
    config.reflect = 0.5;
    glint_trace_stats stats;
    glint_image *image = traced(&config, &every_pixel, &stats);
    const glint_vec3 light = glint_vec3_of(scene.light);
    const double up = camera.up.y * light.y + camera.right.y * light.x + camera.back.y * light.z;
    const double cosine = up / glint_vec3_length(light);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            const sight s = look(&scene, &camera, x, y);
            if (!s.sure || !s.floor)
                continue;
            for (int c = 0; c < 3; c++) {
                const double ambient = scene.color[c] * (double)scene.ka;
                const double lit = scene.color[c] * (double)scene.kd * cosine;
                const double own = rounded(s.shadow ? ambient : ambient + lit);
                const double mirrored = s.mirror ? 0.5 * rounded(ambient) : 0.0;
                assert_int_equal(image->rgb[3 * (y * W + x) + c], rounded(own + mirrored));
            }
            seen[s.shadow][s.mirror]++;
        }
    assert_true(seen[0][0] > 500 && seen[0][1] > 500 && seen[1][0] > 500);
    assert_int_equal(stats.mirror_rays, stats.hits);
    assert_true(stats.highlights > stats.hits);
    glint_image_destroy(image);
    glint_mesh_destroy(mesh);
}

static glint_image *of_scale(double scale, glint_trace_stats *stats)
{
    const glint_transform transform = {.scale = {scale, scale, scale}};
    glint_error err;
    glint_mesh *mesh = floor_and_plate();
    assert_int_equal(glint_mesh_transform(mesh, &transform, &err), GLINT_OK);
    glint_scene scene = scene_of(mesh);
    scene.light[0] = 0.3f;
    scene.distance = (float)(4.0 * scale);
    glint_tracer_config config = config_of(&scene, 320, 240);
    config.shadows = true;
    config.reflect = 0.5;
    glint_image *image = traced(&config, &every_pixel, stats);
    glint_mesh_destroy(mesh);
    return image;
}

/* A small object seen from as much nearer is the same picture, but for a few pixels at edges. */
static void shadows_and_mirrors_do_not_depend_on_the_objects_size(void **state)
{
    (void)state;
    static const double scales[] = {0.1, 0.01, 0.001};
    glint_trace_stats stats;
    glint_image *whole = of_scale(1.0, &stats);
    print_message("%" PRIu64 " pixels of the object\n", stats.hits);
    assert_true(stats.hits > 5000);
    for (size_t i = 0; i < sizeof scales / sizeof scales[0]; i++) {
        glint_image_difference difference;
        glint_trace_stats small;
        glint_error err;
        glint_image *image = of_scale(scales[i], &small);
        assert_int_equal(glint_image_compare(whole, image, &difference, &err), GLINT_OK);
        print_message("scale %g: %" PRIu64 " pixels differ, by %d at most\n", scales[i],
                      difference.differing_pixels, difference.largest);
        assert_in_range(difference.differing_pixels, 0, 5);
        glint_image_destroy(image);
    }
    glint_image_destroy(whole);
}

/* A ball shadows nothing that the light reaches, but for the facets at its terminator, and mirrors
 * nothing. */
static void a_ball_alone_casts_and_mirrors_nothing(void **state)
{
    (void)state;
    glint_mesh *mesh;
    glint_error err;
    glint_image_difference difference;
    glint_trace_stats stats;
    assert_int_equal(glint_mesh_sphere(256, &mesh, &err), GLINT_OK);
    const glint_scene scene = scene_of(mesh);
    glint_tracer_config config = config_of(&scene, 200, 150);
    glint_image *plain = traced(&config, &every_pixel, &stats);
    assert_int_equal(stats.shadow_rays + stats.mirror_rays, 0);
    config.reflect = 1.0;
    glint_image *mirror = traced(&config, &every_pixel, &stats);
    assert_in_range(stats.mirror_rays, stats.hits - stats.hits / 1000, stats.hits);
    assert_memory_equal(plain->rgb, mirror->rgb, 3 * 200 * 150);
    config.shadows = true;
    glint_image *shadow = traced(&config, &every_pixel, &stats);
    assert_true(stats.shadow_rays > 0 && stats.shadow_rays < stats.hits);
    assert_int_equal(glint_image_compare(plain, shadow, &difference, &err), GLINT_OK);
    assert_in_range(difference.largest, 0, 4);
    glint_image_destroy(plain);
    glint_image_destroy(mirror);
    glint_image_destroy(shadow);
    glint_mesh_destroy(mesh);
}

/* ---- What is refused ------------------------------------------------------------------------- */

static void what_is_out_of_range_is_refused(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot(2);
    const glint_scene scene = scene_of(mesh);
    glint_backend_watch watch = {0};
    glint_tracer_config bad[7];
    static const char *const says[7] = {
        "frame size 0x20: each side must be from 1 to 16384",
        "threads is 0, not from 1 to 64",
        "reflect is 1.5, not from 0 to 1",
        "rays are lit at every point: only Phong's shading can be traced",
        "scene: fov is 0, not from 1 to 170",
        "2 threads cannot share one watch",
        "highlights from a reflectance model need backend real",
    };
    for (int i = 0; i < 7; i++)
        bad[i] = config_of(&scene, 20, 20);
    bad[0].width = 0;
    bad[1].threads = 0;
    bad[2].reflect = 1.5;
    bad[3].scene.shading = GLINT_SHADING_FLAT;
    bad[4].scene.fov = 0.0f;
    bad[5].threads = 2;
    bad[5].watch = &watch;
    bad[6].scene.by_model = true;
    for (int i = 0; i < 7; i++) {
        glint_tracer *tracer;
        glint_error err = {""};
        assert_int_equal(glint_tracer_create(&bad[i], &tracer, &err), GLINT_BAD_ARGUMENT);
        assert_string_equal(err.text, says[i]);
    }
    glint_mesh_destroy(mesh);
}

static void raise_stop(void *context, uint64_t done, uint64_t total)
{
    assert_true(done < total);
    *(bool *)context = true;
}

static void tracing_can_be_stopped(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot(8);
    const glint_scene scene = scene_of(mesh);
    glint_tracer_config config = config_of(&scene, 400, 300);
    static bool stop;
    glint_tracer *tracer;
    glint_image *image;
    glint_error err = {""};
    stop = false;
    config.stop = &stop;
    config.progress = raise_stop;
    config.context = &stop;
    assert_int_equal(glint_tracer_create(&config, &tracer, &err), GLINT_OK);
    assert_int_equal(glint_image_create(400, 300, &image, &err), GLINT_OK);
    assert_int_equal(glint_trace(tracer, &every_pixel, image, NULL, &err), GLINT_INTERRUPTED);
    assert_string_equal(err.text, "tracing abandoned: interrupted");
    glint_tracer_destroy(tracer);
    glint_image_destroy(image);
    glint_mesh_destroy(mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(full_traces_are_the_rasterizers_frames),
        cmocka_unit_test(frames_of_one_pixel_and_narrow_ones),
        cmocka_unit_test(a_model_gives_the_rasterizers_highlights),
        cmocka_unit_test(threads_do_not_change_the_picture),
        cmocka_unit_test(longer_segments_cost_less_and_err_more),
        cmocka_unit_test(shadows_and_mirrors_are_where_geometry_has_them),
        cmocka_unit_test(shadows_and_mirrors_do_not_depend_on_the_objects_size),
        cmocka_unit_test(a_ball_alone_casts_and_mirrors_nothing),
        cmocka_unit_test(what_is_out_of_range_is_refused),
        cmocka_unit_test(tracing_can_be_stopped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
