/* Frames by OpenGL against the rasterizer's own: every reflectance model and shading, a level of
 * tolerance where the bound is of levels; the device in a shader against the device; and what is
 * said where there is no OpenGL. Which pixels an edge covers is the driver's decision, so those of
 * one frame only are counted apart. */
#define _XOPEN_SOURCE 700

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../cli/run.h"
#include "../render/studio.h"
#include "gl/gold_maps.h"
#include "gl/renderer.h"
#include "gl/texts.h"

#define WIDTH  320
#define HEIGHT 240

/* Largest difference of a component where every pixel shows the same place: a sum that falls on the
 * other side of a half. */
#define LEVELS 1

/* NULL where there is no OpenGL; a shader that does not compile is a failure. */
static glint_gl_renderer *try_open(const glint_mesh *mesh)
{
    glint_error err;
    glint_gl_renderer *renderer = NULL;
    const glint_status status = glint_gl_renderer_create(mesh, WIDTH, HEIGHT, 1, &renderer, &err);
    if (status == GLINT_IO_ERROR)
        print_message("%s\n", err.text);
    else if (status != GLINT_OK)
        fail_msg("%s", err.text);
    return renderer;
}

static glint_mesh *sphere(void)
{
    glint_mesh *mesh = NULL;
    assert_int_equal(glint_mesh_sphere(GLINT_SPHERE_DENSITY, &mesh, NULL), GLINT_OK);
    return mesh;
}

static glint_mesh *teapot(void)
{
    glint_mesh *mesh = NULL;
    assert_int_equal(glint_mesh_teapot(GLINT_TEAPOT_DENSITY, &mesh, NULL), GLINT_OK);
    return mesh;
}

static glint_scene scene_of(const glint_mesh *mesh, glint_reflectance_model model, uint16_t n)
{
    glint_scene scene = {.mesh = mesh};
    glint_scene_defaults(&scene);
    scene.by_model = true;
    scene.specular = model;
    scene.n = n;
    return scene;
}

static glint_image *picture(void)
{
    glint_image *image = NULL;
    assert_int_equal(glint_image_create(WIDTH, HEIGHT, &image, NULL), GLINT_OK);
    return image;
}

static glint_render_stats shoot_gl(glint_gl_renderer *renderer, const glint_scene *scene,
                                   glint_image *image)
{
    glint_render_stats stats;
    glint_error err = {""};
    const glint_status status = glint_gl_render(renderer, scene, image, NULL, &stats, &err);
    assert_string_equal(err.text, "");
    assert_int_equal(status, GLINT_OK);
    return stats;
}

/* How two frames differ, coverage apart. */
typedef struct verdict {
    uint64_t common; /* pixels of the object in both */
    uint64_t beyond; /* of these, more than LEVELS apart */
    uint64_t alone;  /* pixels of the object in one only */
    int largest;     /* of the common ones, of one component */
    double nmse;
} verdict;

static verdict compare(const glint_image *a, const glint_image *b)
{
    verdict v = {0};
    glint_image_difference difference;
    for (size_t i = 0; i < (size_t)WIDTH * HEIGHT; i++) {
        int largest = 0;
        for (size_t c = 3 * i; c < 3 * i + 3; c++) {
            const int apart = abs(a->rgb[c] - b->rgb[c]);
            largest = apart > largest ? apart : largest;
        }
        if (a->object[i] != b->object[i]) {
            v.alone++;
        } else if (a->object[i]) {
            v.common++;
            v.beyond += largest > LEVELS;
            v.largest = largest > v.largest ? largest : v.largest;
        }
    }
    assert_int_equal(glint_image_compare(a, b, &difference, NULL), GLINT_OK);
    v.nmse = difference.nmse;
    assert_true(v.common > 10000);
    return v;
}

/* Pixels of an outline that one frame has and the other has not: a few of the thousand that it is
 * long. */
#define ALONE 4

typedef struct stage {
    glint_mesh *mesh;
    glint_gl_renderer *gl;
    studio real;
    glint_image *image;
} stage;

static bool open_stage(stage *s, glint_mesh *mesh)
{
    *s = (stage){.mesh = mesh, .gl = try_open(mesh)};
    if (s->gl == NULL) {
        glint_mesh_destroy(mesh);
        return false;
    }
    s->image = picture();
    s->real = open_studio(WIDTH, HEIGHT, 1, GLINT_BACKEND_REAL);
    return true;
}

static void close_stage(stage *s)
{
    glint_gl_renderer_destroy(s->gl);
    glint_image_destroy(s->image);
    close_studio(&s->real);
    glint_mesh_destroy(s->mesh);
}

static verdict play(stage *s, const glint_scene *scene)
{
    shoot(&s->real, scene);
    const glint_render_stats stats = shoot_gl(s->gl, scene, s->image);
    const verdict v = compare(s->real.image, s->image);
    assert_true(stats.fragments >= v.common && stats.fragments <= v.common + v.alone);
    return v;
}

static void every_model_is_within_a_level_of_real(void **state)
{
    (void)state;
    static const uint16_t exponents[] = {1, 2, 10, 80, 1000};
    stage s;
    if (!open_stage(&s, sphere()))
        skip();
    for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++) {
        assert_non_null(glint_shader_models[model]);
        for (size_t i = 0; i < sizeof exponents / sizeof exponents[0]; i++) {
            glint_scene scene = scene_of(s.mesh, (glint_reflectance_model)model, exponents[i]);
            scene.f0 = 0.3f;
            const verdict v = play(&s, &scene);
            if (v.beyond > 0 || v.alone > ALONE) {
                fail_msg("%s, n = %d: %d of %d pixels differ by up to %d levels, %d are of one "
                         "frame only",
                         glint_reflectance_names[model], exponents[i], (int)v.beyond, (int)v.common,
                         v.largest, (int)v.alone);
            }
        }
    }
    close_stage(&s);
}

/* The comparison would notice a wrong model, or a light from elsewhere. */
static void another_model_is_noticed(void **state)
{
    (void)state;
    stage s;
    if (!open_stage(&s, sphere()))
        skip();
    glint_scene scene = scene_of(s.mesh, GLINT_REFLECTANCE_BLINN, 80);
    shoot(&s.real, &scene);
    scene.specular = GLINT_REFLECTANCE_LYON_16; /* 0.012 from it */
    (void)shoot_gl(s.gl, &scene, s.image);
    assert_true(compare(s.real.image, s.image).beyond > 50);
    scene.specular = GLINT_REFLECTANCE_BLINN;
    scene.light[0] += 0.05f;
    (void)shoot_gl(s.gl, &scene, s.image);
    assert_true(compare(s.real.image, s.image).beyond > 1000);
    close_stage(&s);
}

/* The integers of the shader are the device's, so all that is left is the code of the cosine. */
static void the_device_in_a_shader_is_the_device(void **state)
{
    (void)state;
    stage s;
    if (!open_stage(&s, sphere()))
        skip();
    studio device = open_studio(WIDTH, HEIGHT, 1, GLINT_BACKEND_C);
    for (unsigned n = 0; n <= GLINT_N_MAX; n = n < 8 ? n + 1 : n * 3 / 2) {
        glint_scene scene = scene_of(s.mesh, GLINT_REFLECTANCE_DEVICE, (uint16_t)n);
        (void)shoot_gl(s.gl, &scene, s.image);
        scene.by_model = false;
        shoot(&device, &scene);
        const verdict v = compare(device.image, s.image);
        if (v.beyond > 0 || v.alone > ALONE)
            fail_msg("n = %u: %d pixels differ by up to %d levels", n, (int)v.beyond, v.largest);
    }
    close_studio(&device);
    close_stage(&s);
}

/* One pixel in a thousand may show another triangle, where one lies behind another's edge. */
static void every_shading_and_view_is_real_s(void **state)
{
    (void)state;
    static const struct {
        glint_shading shading;
        float yaw, distance;
    } views[] = {
        {GLINT_SHADING_PHONG, 25.0f, 0.0f},
        {GLINT_SHADING_PHONG, 200.0f, 2.5f},
        {GLINT_SHADING_PHONG, 77.0f, 0.8f}, /* the camera inside: cut at the near plane */
        {GLINT_SHADING_GOURAUD_PERSPECTIVE, 25.0f, 0.0f},
        {GLINT_SHADING_GOURAUD_PERSPECTIVE, 310.0f, 1.1f},
        {GLINT_SHADING_FLAT, 25.0f, 0.0f},
    };
    stage s;
    if (!open_stage(&s, teapot()))
        skip();
    for (size_t i = 0; i < sizeof views / sizeof views[0]; i++) {
        glint_scene scene = scene_of(s.mesh, GLINT_REFLECTANCE_BLINN, 30);
        scene.shading = views[i].shading;
        scene.yaw = views[i].yaw;
        scene.distance = views[i].distance;
        scene.ie[0] = scene.ie[1] = scene.ie[2] = 0.7f;
        const verdict v = play(&s, &scene);
        const uint64_t allowed = v.common / (scene.shading == GLINT_SHADING_FLAT ? 200 : 1000);
        if (v.beyond > allowed || v.alone > ALONE) {
            fail_msg("view %d: %d of %d pixels differ by more than %d, %d are of one frame only",
                     (int)i, (int)v.beyond, (int)v.common, LEVELS, (int)v.alone);
        }
    }
    close_stage(&s);
}

/* On the screen the rasterizer rounds at the ends of its runs, OpenGL at the pixel alone: no
 * visible difference where triangles are large. */
static void gouraud_is_real_s_but_for_its_runs(void **state)
{
    (void)state;
    glint_mesh *quad = NULL;
    stage s;
    assert_int_equal(glint_mesh_quad(&quad, NULL), GLINT_OK);
    if (!open_stage(&s, quad))
        skip();
    glint_scene scene = scene_of(s.mesh, GLINT_REFLECTANCE_BLINN, 30);
    scene.shading = GLINT_SHADING_GOURAUD;
    const verdict v = play(&s, &scene);
    assert_true(v.beyond * 100 < v.common);
    assert_true(v.nmse < 1e-4);
    scene.shading = GLINT_SHADING_GOURAUD_PERSPECTIVE;
    (void)shoot_gl(s.gl, &scene, s.image);
    assert_true(compare(s.real.image, s.image).nmse > 1e-3);
    close_stage(&s);
}

static void frames_repeat(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot();
    glint_image *first = picture(), *second = picture();
    glint_gl_renderer *renderer = try_open(mesh);
    if (renderer == NULL)
        skip();
    const glint_scene scene = scene_of(mesh, GLINT_REFLECTANCE_PHONG, 40);
    (void)shoot_gl(renderer, &scene, first);
    (void)shoot_gl(renderer, &scene, second);
    assert_memory_equal(first->rgb, second->rgb, 3 * WIDTH * HEIGHT);
    glint_gl_renderer_destroy(renderer);
    assert_int_equal(glint_gl_renderer_create(mesh, WIDTH, HEIGHT, 2, &renderer, NULL), GLINT_OK);
    (void)shoot_gl(renderer, &scene, second);
    assert_memory_equal(first->rgb, second->rgb, 3 * WIDTH * HEIGHT);
    glint_gl_renderer_destroy(renderer);
    glint_image_destroy(first);
    glint_image_destroy(second);
    glint_mesh_destroy(mesh);
}

static void what_is_out_of_range_is_refused(void **state)
{
    (void)state;
    glint_error err;
    stage s;
    if (!open_stage(&s, sphere()))
        skip();
    glint_scene scene = scene_of(s.mesh, GLINT_REFLECTANCE_QUADRATIC, 0);
    assert_int_equal(glint_gl_render(s.gl, &scene, s.image, NULL, NULL, &err), GLINT_BAD_ARGUMENT);
    assert_says(err.text, "model quadratic takes n from 1");
    scene = scene_of(s.mesh, GLINT_REFLECTANCE_BLINN, 5);
    scene.fov = 0.0f;
    assert_int_equal(glint_gl_render(s.gl, &scene, s.image, NULL, NULL, &err), GLINT_BAD_ARGUMENT);
    assert_says(err.text, "fov");
    const volatile bool stop = true;
    scene.fov = 35.0f;
    assert_int_equal(glint_gl_render(s.gl, &scene, s.image, &stop, NULL, &err), GLINT_INTERRUPTED);
    close_stage(&s);
}

/* ---- Gold ------------------------------------------------------------------------------------ */

/* Bilinear, the map repeated; component 0…2, 0…1. */
static double sampled(const uint8_t *map, double u, double v, int component)
{
    const double x = u * GLINT_GOLD_SIDE - 0.5, y = v * GLINT_GOLD_SIDE - 0.5;
    const int left = (int)floor(x), top = (int)floor(y);
    double sum = 0.0;
    for (int i = 0; i < 4; i++) {
        const int column = (left + i % 2 + GLINT_GOLD_SIDE) % GLINT_GOLD_SIDE;
        const int row = (top + i / 2 + GLINT_GOLD_SIDE) % GLINT_GOLD_SIDE;
        const double weight =
            (i % 2 ? x - left : 1.0 - x + left) * (i / 2 ? y - top : 1.0 - y + top);
        sum += weight * map[3 * (row * GLINT_GOLD_SIDE + column) + component];
    }
    return sum / 255.0;
}

/* The listing's lines for the point p of the unit sphere and the eye: red, green, blue in levels.
 */
static void gold_at(const uint8_t *base, const uint8_t *bump, glint_vec3 p, glint_vec3 eye,
                    double levels[3])
{
    static const double gold[3] = {1.0, 0.77, 0.34};
    const glint_vec3 light = glint_vec3_sub(eye, p);
    const glint_vec3 along = {1.0 - p.x * p.x, -p.x * p.y, -p.x * p.z};
    const glint_vec3 across = {-p.z * p.x, -p.z * p.y, 1.0 - p.z * p.z};
    const double u = p.x * 70.0 * 0.0065 + 0.46, v = p.z * 70.0 * 0.0065 + 0.46;
    const glint_vec3 l = {glint_vec3_dot(light, along), glint_vec3_dot(light, across),
                          glint_vec3_dot(light, p)};
    const glint_vec3 b = {2.0 * sampled(bump, u, v, 0) - 1.0, 2.0 * sampled(bump, u, v, 1) - 1.0,
                          2.0 * sampled(bump, u, v, 2) - 1.0};
    const double shine =
        fmax(glint_vec3_dot(l, b) / (glint_vec3_length(l) * glint_vec3_length(b)), 0.0);
    for (int c = 0; c < 3; c++)
        levels[c] =
            255.0 * fmin(shine * 0.2 * sampled(base, u, v, c) + shine * shine * gold[c], 1.0);
}

/* Where the ray through the pixel meets the unit sphere; false: it does not. */
static bool meets_sphere(const glint_scene *scene, int x, int y, glint_vec3 eye, glint_vec3 *p)
{
    const double focal = 0.5 * HEIGHT / tan(0.5 * (double)scene->fov * 3.14159265358979 / 180.0);
    const glint_vec3 ray = {(x + 0.5 - 0.5 * WIDTH) / focal, (0.5 * HEIGHT - y - 0.5) / focal,
                            -1.0};
    const double a = glint_vec3_dot(ray, ray), b = glint_vec3_dot(eye, ray);
    const double root = b * b - a * (glint_vec3_dot(eye, eye) - 1.0);
    *p = glint_vec3_add(eye, glint_vec3_scale(ray, (-b - sqrt(fmax(root, 0.0))) / a));
    return root > 0.0;
}

/* The mesh is a sphere of facets: where the surface is steep, its places on the map are not quite
 * the sphere's. */
static void gold_is_the_listing_s(void **state)
{
    (void)state;
    static uint8_t base[GLINT_GOLD_SIDE * GLINT_GOLD_SIDE * 3], bump[sizeof base];
    const glint_vec3 eye = {0.0, 0.0, 4.0};
    stage s;
    if (!open_stage(&s, sphere()))
        skip();
    glint_scene scene = scene_of(s.mesh, GLINT_REFLECTANCE_BLINN, 10);
    scene.yaw = scene.pitch = 0.0f;
    scene.distance = 4.0f;
    glint_gold_maps(base, bump);
    assert_int_equal(glint_gl_renderer_gild(s.gl, NULL), GLINT_OK);
    (void)shoot_gl(s.gl, &scene, s.image);
    size_t count = 0, beyond = 0, dark = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            glint_vec3 p;
            double levels[3];
            const size_t at = (size_t)y * WIDTH + (size_t)x;
            if (!s.image->object[at] || !meets_sphere(&scene, x, y, eye, &p))
                continue;
            gold_at(base, bump, p, eye, levels);
            const double apart = fmax(fabs(levels[0] - s.image->rgb[3 * at]),
                                      fmax(fabs(levels[1] - s.image->rgb[3 * at + 1]),
                                           fabs(levels[2] - s.image->rgb[3 * at + 2])));
            count++;
            beyond += apart > 3.0;
            dark += levels[0] < 128.0;
        }
    if (count < 10000 || dark < 100 || beyond * 100 > count)
        fail_msg("%d of %d pixels are more than 3 levels off (%d dark)", (int)beyond, (int)count,
                 (int)dark);
    close_stage(&s);
}

/* ---- The command ----------------------------------------------------------------------------- */

static void refused(const char *options, const char *why)
{
    char line[600];
    (void)snprintf(line, sizeof line, "render %s --size 64x48 --out %s", options,
                   scratch_path("a.png"));
    outcome done = run(line, "");
    assert_outcome(&done, 2, NULL);
    assert_says(done.err, why);
    assert_string_equal(strchr(done.err, '\n'), "\n"); /* one line */
    assert_int_equal(access(scratch_path("a.png"), F_OK), -1);
    forget(&done);
}

static void a_missing_egl_is_said_in_a_line(void **state)
{
    (void)state;
    scratch_write(scratch_path("libEGL.so.1"), "no library\n", 11);
    assert_int_equal(setenv("LD_LIBRARY_PATH", scratch_directory, 1), 0);
    refused("--backend gl", "glint render: backend gl: libEGL.so.1 is missing: install libegl1 and "
                            "libgl1-mesa-dri\n");
    assert_int_equal(unsetenv("LD_LIBRARY_PATH"), 0);
    assert_int_equal(unlink(scratch_path("libEGL.so.1")), 0);
    refused("--backend gl --device power", "--device needs another backend");
    refused("--shader gold", "--shader gold needs --backend gl");
    refused("--backend gl --shader gold --specular blinn", "leave --specular out");
    refused("--backend gl --specular device --n 2.5", "not an integer");
}

static void the_command_draws_the_same(void **state)
{
    (void)state;
    char line[600];
    stage s;
    if (!open_stage(&s, sphere()))
        skip();
    (void)snprintf(line, sizeof line,
                   "render --backend gl --model sphere --size %dx%d --n 30 --json --out %s", WIDTH,
                   HEIGHT, scratch_path("gl.png"));
    outcome done = run(line, "");
    assert_outcome(&done, 0, "");
    assert_says(done.out, "\"gl\"");
    assert_says(done.out, "\"cosine-quadratic\"");
    assert_says(done.out, "\"driver\":");
    assert_null(strstr(done.out, "\"device\":"));
    assert_null(strstr(done.out, "\"gate\":"));
    assert_null(strstr(done.out, "\"pipeline\":"));
    forget(&done);
    glint_image *read = NULL;
    assert_int_equal(glint_image_read_png(scratch_path("gl.png"), &read, NULL), GLINT_OK);
    glint_scene scene = scene_of(s.mesh, GLINT_REFLECTANCE_COSINE_QUADRATIC, 30);
    (void)shoot_gl(s.gl, &scene, s.image);
    assert_memory_equal(read->rgb, s.image->rgb, 3 * WIDTH * HEIGHT);
    assert_memory_equal(read->object, s.image->object, WIDTH * HEIGHT);
    glint_image_destroy(read);
    close_stage(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_model_is_within_a_level_of_real),
        cmocka_unit_test(another_model_is_noticed),
        cmocka_unit_test(the_device_in_a_shader_is_the_device),
        cmocka_unit_test(every_shading_and_view_is_real_s),
        cmocka_unit_test(gouraud_is_real_s_but_for_its_runs),
        cmocka_unit_test(frames_repeat),
        cmocka_unit_test(what_is_out_of_range_is_refused),
        cmocka_unit_test(gold_is_the_listing_s),
        cmocka_unit_test(a_missing_egl_is_said_in_a_line),
        cmocka_unit_test(the_command_draws_the_same),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
