/* Studies: their numbers against frames rendered and compared apart, what counts as touched by the
 * highlight, the names of methods, contact sheets, and what is refused. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "study/sheet.h"
#include "study/study.h"

#define WIDTH  160
#define HEIGHT 120

static glint_study_method method(const char *text)
{
    glint_study_method parsed;
    glint_error err;
    if (glint_study_method_parse(text, &parsed, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    return parsed;
}

static glint_study_setup setup_of(const glint_mesh *mesh, const char *a, const char *b)
{
    glint_study_setup setup = {
        .method = {method(a), method(b)}, .width = WIDTH, .height = HEIGHT, .threads = 2};
    setup.scene.mesh = mesh;
    glint_scene_defaults(&setup.scene);
    return setup;
}

static glint_study *open_study(const glint_study_setup *setup)
{
    glint_study *study = NULL;
    glint_error err;
    if (glint_study_create(setup, &study, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    return study;
}

static glint_study_row run(glint_study *study, int n, int frames)
{
    glint_study_row row;
    glint_error err;
    if (glint_study_run(study, n, frames, NULL, &row, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    assert_int_equal(row.n, n);
    return row;
}

static glint_study_row run_once(const glint_study_setup *setup, int n)
{
    glint_study *study = open_study(setup);
    const glint_study_row row = run(study, n, 0);
    glint_study_destroy(study);
    return row;
}

static glint_mesh *sphere(int density)
{
    glint_mesh *mesh = NULL;
    assert_int_equal(glint_mesh_sphere(density, &mesh, NULL), GLINT_OK);
    return mesh;
}

/* One method's frame, by a renderer of its own. */
static glint_image *frame_of(const glint_study_setup *setup, int which, int n)
{
    const glint_study_method *m = &setup->method[which];
    const glint_backend_config config = {.kind = m->by_model ? GLINT_BACKEND_REAL : m->backend,
                                         .pipeline = GLINT_PIPELINE_PIPELINED};
    glint_scene scene = setup->scene;
    scene.n = (uint16_t)n;
    scene.by_model = m->by_model;
    scene.specular = m->model;
    scene.shading = m->shading;
    glint_renderer *renderer = NULL;
    glint_image *image = NULL;
    assert_int_equal(glint_renderer_create(WIDTH, HEIGHT, 1, &config, &renderer, NULL), GLINT_OK);
    assert_int_equal(glint_image_create(WIDTH, HEIGHT, &image, NULL), GLINT_OK);
    assert_int_equal(glint_render(renderer, &scene, image, NULL, NULL, NULL), GLINT_OK);
    glint_renderer_destroy(renderer);
    return image;
}

/* (3.1) and the PSNR of the object's pixels, term by term. */
static void assert_difference(const glint_image_difference *found, const glint_image *a,
                              const glint_image *b)
{
    double squares = 0.0, reference = 0.0;
    uint64_t pixels = 0, differing = 0;
    int largest = 0;
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            const int at = y * WIDTH + x;
            bool differs = false;
            for (int c = 3 * at; c < 3 * at + 3; c++) {
                const int apart = a->rgb[c] - b->rgb[c];
                squares += (double)(apart * apart);
                reference += (double)(a->rgb[c] * a->rgb[c]);
                differs = differs || apart != 0;
                largest = abs(apart) > largest ? abs(apart) : largest;
            }
            assert_int_equal(a->object[at], b->object[at]);
            assert_true(a->object[at] != 0 || !differs);
            if (a->object[at] == 0) /* the background is no part of either sum */
                assert_int_equal(a->rgb[3 * at] + a->rgb[3 * at + 1] + a->rgb[3 * at + 2], 0);
            pixels += a->object[at] != 0;
            differing += differs;
        }
    }
    assert_true(pixels > 1000 && squares > 0.0);
    assert_true(found->object_pixels == pixels && found->differing_pixels == differing);
    assert_int_equal(found->largest, largest);
    assert_true(fabs(found->nmse / (squares / reference) - 1.0) < 1e-12);
    const double psnr = 10.0 * log10(255.0 * 255.0 * 3.0 * (double)pixels / squares);
    assert_true(fabs(found->psnr - psnr) < 1e-9);
    int at_largest = 0;
    const int at = 3 * (found->largest_y * WIDTH + found->largest_x);
    for (int c = at; c < at + 3; c++) {
        at_largest =
            abs(a->rgb[c] - b->rgb[c]) > at_largest ? abs(a->rgb[c] - b->rgb[c]) : at_largest;
    }
    assert_int_equal(at_largest, largest);
}

static void the_numbers_are_those_of_two_frames(void **state)
{
    (void)state;
    static const char *const pairs[][2] = {{"blinn", "cosine-quadratic"},
                                           {"phong", "blinn"},
                                           {"real:gouraud", "c:gouraud"},
                                           {"cook-torrance:flat", "rtl"},
                                           {"device", "c:gouraud-perspective"}};
    glint_mesh *mesh = sphere(48);
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        const glint_study_setup setup = setup_of(mesh, pairs[i][0], pairs[i][1]);
        glint_study *study = open_study(&setup);
        for (int n = 7; n < 800; n *= 10) {
            const glint_study_row row = run(study, n, 0);
            glint_image *a = frame_of(&setup, 0, n);
            glint_image *b = frame_of(&setup, 1, n);
            assert_difference(&row.difference, a, b);
            assert_memory_equal(glint_study_picture(study, 0)->rgb, a->rgb, 3 * WIDTH * HEIGHT);
            assert_memory_equal(glint_study_picture(study, 1)->rgb, b->rgb, 3 * WIDTH * HEIGHT);
            glint_image_destroy(a);
            glint_image_destroy(b);
        }
        glint_study_destroy(study);
    }
    glint_mesh_destroy(mesh);
}

static void c_and_verilog_are_equal(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(48);
    const glint_study_setup setup = setup_of(mesh, "c", "rtl");
    const glint_study_row row = run_once(&setup, 60);
    assert_int_equal(row.difference.differing_pixels, 0);
    assert_int_equal(row.difference.largest_x, -1);
    assert_true(row.difference.nmse == 0.0);
    assert_int_equal(row.highlit[0], row.highlit[1]);
    assert_true(row.highlit[0] > 0 && row.highlit[0] < row.seen);
    glint_mesh_destroy(mesh);
}

/* Which triangles are drawn does not depend on the order of the methods, nor on parts of them. */
static void drawn_are_triangles_of_the_mesh(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(16);
    for (int near = 0; near < 2; near++) {
        glint_study_setup ab = setup_of(mesh, "c", "c:gouraud-4");
        glint_study_setup ba = setup_of(mesh, "c:gouraud-4", "c");
        ab.scene.distance = ba.scene.distance = near ? 1.05f : 0.0f;
        const glint_study_row one = run_once(&ab, 60), other = run_once(&ba, 60);
        assert_true(one.seen <= one.drawn && one.drawn <= one.triangles / 2);
        assert_int_equal(one.drawn, other.drawn);
    }
    glint_mesh_destroy(mesh);
}

/* n = 0: a lobe is 1 wherever light falls, and with the light behind the eye that is all that is
 * seen but for some triangles at the outline, whose normals turn away. No Ks, or Lambert's:
 * nowhere. */
static void which_triangles_the_highlight_touches(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(32);
    glint_study_setup setup = setup_of(mesh, "blinn", "lambert");
    setup.scene.light[0] = setup.scene.light[1] = 0.0f;
    setup.scene.fov = 1.0f;
    glint_study_row row = run_once(&setup, 0);
    assert_int_equal(row.triangles, mesh->triangle_count);
    assert_true(row.seen > 100 && row.seen <= row.drawn && row.drawn < row.triangles);
    assert_in_range(row.highlit[0], row.seen - row.seen / 50, row.seen);
    assert_int_equal(row.highlit[1], 0);
    uint64_t before = row.seen;
    for (int n = 10; n <= 1000; n *= 10) {
        row = run_once(&setup, n);
        assert_true(row.highlit[0] > 0 && row.highlit[0] < before);
        before = row.highlit[0];
    }
    setup.scene.ks = 0.0f;
    row = run_once(&setup, 10);
    assert_int_equal(row.highlit[0], 0);
    glint_mesh_destroy(mesh);
}

static void times_are_measured_when_asked_for(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(32);
    const glint_study_setup setup = setup_of(mesh, "blinn", "schlick");
    glint_study *study = open_study(&setup);
    const glint_study_row timed = run(study, 20, 4);
    const glint_study_row plain = run(study, 20, 0);
    assert_int_equal(timed.frames, 4);
    assert_true(timed.seconds[0] > 0.0 && timed.seconds[1] > 0.0 && timed.ratio > 0.0);
    assert_int_equal(plain.frames, 0);
    assert_true(plain.seconds[0] == 0.0 && plain.seconds[1] == 0.0 && plain.ratio == 0.0);
    assert_memory_equal(&timed.difference, &plain.difference, sizeof plain.difference);
    assert_memory_equal(timed.highlit, plain.highlit, sizeof plain.highlit);
    glint_study_destroy(study);
    glint_mesh_destroy(mesh);
}

static void threads_do_not_change_the_numbers(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(48);
    glint_study_setup setup = setup_of(mesh, "torrance-sparrow", "energy-conserving:gouraud");
    glint_study_row row[2];
    for (int i = 0; i < 2; i++) {
        setup.threads = i == 0 ? 1 : 5;
        row[i] = run_once(&setup, 30);
    }
    assert_memory_equal(&row[0], &row[1], sizeof row[0]);
    glint_mesh_destroy(mesh);
}

/* The scene of the thesis's figure 3.9 (no ambient light, Kd = Ks = 0.5, 238,138,32), a sphere that
 * fills the frame: what another program, written apart, found for cosⁿ and the cosine-quadratic. */
static void the_scene_of_figure_3_9(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(128);
    glint_study_setup setup = setup_of(mesh, "blinn", "cosine-quadratic");
    setup.width = setup.height = 240;
    setup.scene.ka = 0.0f;
    setup.scene.kd = setup.scene.ks = 0.5f;
    setup.scene.fov = 1.0f;
    memcpy(setup.scene.light, (float[]){1.0f, 1.0f, 2.0f}, sizeof setup.scene.light);
    memcpy(setup.scene.color, (uint8_t[]){238, 138, 32}, 3);
    assert_true(fabs(run_once(&setup, 13).difference.nmse - 2.7e-3) < 0.05e-3);
    assert_true(fabs(run_once(&setup, 1000).difference.nmse - 1.3e-4) < 0.1e-4);
    memcpy(setup.scene.highlight, (uint8_t[]){238, 138, 32}, 3);
    assert_true(fabs(run_once(&setup, 10).difference.nmse - 1.3e-3) < 0.05e-3);
    glint_mesh_destroy(mesh);
}

static void methods_have_names(void **state)
{
    (void)state;
    static const char *const names[] = {"c",
                                        "rtl",
                                        "real",
                                        "rtl:flat",
                                        "c:gouraud",
                                        "blinn",
                                        "phong",
                                        "phong:gouraud",
                                        "lyon-4:flat",
                                        "device",
                                        "blinn:gouraud-perspective"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const glint_study_method parsed = method(names[i]);
        glint_study_name name;
        assert_string_equal(glint_study_method_name(&parsed, &name), names[i]);
    }
    const glint_study_method phong = method("schlick:phong");
    glint_study_name name;
    assert_string_equal(glint_study_method_name(&phong, &name), "schlick");
    static const char *const bad[] = {
        "",
        "Blinn",
        "blinn:",
        ":flat",
        "blinn:Flat",
        "blinn:flat ",
        "verilog",
        "c:flat:flat",
        "blinnblinnblinnblinnblinnblinnblinnblinnblinnblinnblinnblinnblinn"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        glint_study_method parsed;
        glint_error err = {""};
        assert_int_equal(glint_study_method_parse(bad[i], &parsed, &err), GLINT_BAD_ARGUMENT);
        assert_string_not_equal(err.text, "");
    }
}

static void a_comparison_is_that_of_a_run(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(16);
    const glint_study_setup setup = setup_of(mesh, "blinn", "quadratic");
    glint_study *study = open_study(&setup);
    glint_image_difference difference;
    glint_error err;
    const volatile bool stop = true;
    const glint_study_row row = run(study, 20, 0);
    assert_int_equal(glint_study_compare(study, 20, NULL, &difference, &err), GLINT_OK);
    assert_true(difference.nmse > 0.0 && difference.nmse == row.difference.nmse);
    assert_true(difference.psnr == row.difference.psnr);
    assert_int_equal(difference.largest, row.difference.largest);
    assert_int_equal(glint_study_compare(study, 1024, NULL, &difference, &err), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_study_compare(study, 0, NULL, &difference, &err), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_study_compare(study, 5, &stop, &difference, &err), GLINT_INTERRUPTED);
    glint_study_destroy(study);
    glint_mesh_destroy(mesh);
}

static void what_cannot_be_studied_is_refused(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(16);
    glint_study_setup setup = setup_of(mesh, "blinn", "quadratic");
    glint_study *study = open_study(&setup);
    glint_study_row row;
    glint_error err;
    assert_int_equal(glint_study_run(study, 0, 0, NULL, &row, &err), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_study_run(study, 1024, 0, NULL, &row, &err), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_study_run(study, -1, 0, NULL, &row, &err), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_study_run(study, 5, -1, NULL, &row, &err), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_study_run(study, 5, GLINT_STUDY_FRAMES_MAX + 1, NULL, &row, &err),
                     GLINT_BAD_ARGUMENT);
    const volatile bool stop = true;
    assert_int_equal(glint_study_run(study, 5, 0, &stop, &row, &err), GLINT_INTERRUPTED);
    assert_int_equal(glint_study_run(study, 5, 0, NULL, &row, &err), GLINT_OK);
    glint_study_destroy(study);
    setup.scene.distance = 0.5f; /* inside, where only backs are */
    study = open_study(&setup);
    assert_int_equal(glint_study_run(study, 5, 0, NULL, &row, &err), GLINT_BAD_INPUT);
    glint_study_destroy(study);
    setup.threads = 0;
    assert_int_equal(glint_study_create(&setup, &study, &err), GLINT_BAD_ARGUMENT);
    assert_null(study);
    glint_study_destroy(NULL);
    glint_mesh_destroy(mesh);
}

/* ---- Sheets ---------------------------------------------------------------------------------- */

static glint_image *gradient(int width, int height)
{
    glint_image *image = NULL;
    assert_int_equal(glint_image_create(width, height, &image, NULL), GLINT_OK);
    for (int i = 0; i < width * height; i++) {
        image->object[i] = 1;
        image->rgb[3 * i] = (uint8_t)(i % width);
        image->rgb[3 * i + 1] = (uint8_t)(i / width);
        image->rgb[3 * i + 2] = 77;
    }
    return image;
}

/* Where in the sheet a pixel of exactly these components is; -1 when nowhere. */
static int find_pixel(const glint_image *sheet, int red, int green, int blue)
{
    for (int i = 0; i < sheet->width * sheet->height; i++) {
        const uint8_t *rgb = &sheet->rgb[3 * i];
        if (rgb[0] == red && rgb[1] == green && rgb[2] == blue)
            return i;
    }
    return -1;
}

static void a_sheet_holds_the_pictures(void **state)
{
    (void)state;
    glint_image *picture = gradient(200, 100);
    glint_sheet *sheet = NULL;
    assert_int_equal(glint_sheet_create(2, 3, 200, 100, 1, "", &sheet, NULL), GLINT_OK);
    const glint_image *page = glint_sheet_image(sheet);
    assert_int_equal(find_pixel(page, 0, 0, 77), -1);
    glint_sheet_put(sheet, 1, 2, picture, "", "");
    const int at = find_pixel(page, 0, 0, 77);
    assert_true(at % page->width > 2 * page->width / 3 - 20);
    assert_true(at / page->width > page->height / 2 - 20);
    for (int y = 0; y < 100; y++) {
        assert_memory_equal(&page->rgb[3 * (at + y * page->width)], &picture->rgb[3 * 200 * y],
                            3 * 200);
    }
    glint_sheet_destroy(sheet);
    assert_int_equal(glint_sheet_create(1, 1, 200, 100, 2, "", &sheet, NULL), GLINT_OK);
    glint_sheet_put(sheet, 0, 0, picture, "", "");
    page = glint_sheet_image(sheet);
    const int half = find_pixel(page, 1, 1, 77); /* means of 0, 1 rounded half up */
    assert_true(half >= 0);
    const uint8_t *next = &page->rgb[3 * (half + 10 * page->width + 30)];
    assert_int_equal(next[0], 61);
    assert_int_equal(next[1], 21);
    glint_sheet_destroy(sheet);
    glint_image_destroy(picture);
}

/* One pixel of a million that differs by one step, in a sheet that shrinks 16 times: it is there,
 * in the colour of the legend; of several the largest is. */
static void a_sheet_loses_no_difference(void **state)
{
    (void)state;
    glint_image *a = NULL;
    glint_image *b = NULL;
    glint_image *difference = NULL;
    glint_sheet *sheet = NULL;
    assert_int_equal(glint_image_create(1000, 1000, &a, NULL), GLINT_OK);
    assert_int_equal(glint_image_create(1000, 1000, &b, NULL), GLINT_OK);
    memset(a->rgb, 100, 3000000);
    memset(b->rgb, 100, 3000000);
    memset(a->object, 1, 1000000);
    memset(b->object, 1, 1000000);
    const int levels[] = {1, 2, 80};
    static const int colors[][3] = {{64, 128, 255}, {0, 220, 100}, {255, 0, 0}};
    for (int i = 0; i < 3; i++) {
        b->rgb[3 * (617 * 1000 + 417 + i)] = (uint8_t)(100 + levels[i]);
        assert_int_equal(glint_image_difference_picture(a, b, &difference, NULL), GLINT_OK);
        assert_int_equal(glint_sheet_create(1, 1, 1000, 1000, 16, "", &sheet, NULL), GLINT_OK);
        glint_sheet_put_difference(sheet, 0, 0, difference, "", "");
        const glint_image *page = glint_sheet_image(sheet);
        assert_true(find_pixel(page, colors[i][0], colors[i][1], colors[i][2]) >= 0);
        assert_true(i == 0 ||
                    find_pixel(page, colors[i - 1][0], colors[i - 1][1], colors[i - 1][2]) < 0);
        glint_sheet_destroy(sheet);
        glint_image_destroy(difference);
    }
    glint_image_destroy(a);
    glint_image_destroy(b);
}

static int bright_pixels(const glint_image *image)
{
    int count = 0;
    for (int i = 0; i < image->width * image->height; i++)
        count += image->rgb[3 * i] > 128;
    return count;
}

static void a_sheet_has_words(void **state)
{
    (void)state;
    glint_sheet *sheet = NULL;
    glint_image *black = NULL;
    assert_int_equal(glint_image_create(64, 32, &black, NULL), GLINT_OK);
    assert_int_equal(glint_sheet_create(1, 1, 64, 32, 1, "", &sheet, NULL), GLINT_OK);
    assert_true(glint_sheet_has_words(sheet));
    glint_sheet_put(sheet, 0, 0, black, "", "");
    assert_int_equal(bright_pixels(glint_sheet_image(sheet)), 0);
    glint_sheet_put(sheet, 0, 0, black, "A: blinn, n = 50", "");
    const int one = bright_pixels(glint_sheet_image(sheet));
    assert_in_range(one, 100, 1500);
    glint_sheet_put(sheet, 0, 0, black, "", "highlight on 3 of 40 triangles");
    assert_true(bright_pixels(glint_sheet_image(sheet)) > one + 100);
    glint_sheet_destroy(sheet);
    glint_image_destroy(black);
}

static void a_sheet_fits(void **state)
{
    (void)state;
    glint_sheet *sheet = NULL;
    glint_error err;
    assert_int_equal(glint_sheet_create(60, 3, 1920, 1080, 1, "", &sheet, &err),
                     GLINT_BAD_ARGUMENT);
    assert_null(sheet);
    const int shrink = glint_sheet_shrink_for(60, 3, 1920, 1080, 1100);
    assert_int_equal(shrink, 6);
    assert_int_equal(glint_sheet_create(60, 3, 1920, 1080, shrink, "", &sheet, &err), GLINT_OK);
    assert_true(glint_sheet_image(sheet)->width <= 1100);
    glint_sheet_destroy(sheet);
    assert_int_equal(glint_sheet_shrink_for(1, 3, 100, 100, 1100), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_numbers_are_those_of_two_frames),
        cmocka_unit_test(c_and_verilog_are_equal),
        cmocka_unit_test(drawn_are_triangles_of_the_mesh),
        cmocka_unit_test(which_triangles_the_highlight_touches),
        cmocka_unit_test(times_are_measured_when_asked_for),
        cmocka_unit_test(threads_do_not_change_the_numbers),
        cmocka_unit_test(the_scene_of_figure_3_9),
        cmocka_unit_test(methods_have_names),
        cmocka_unit_test(a_comparison_is_that_of_a_run),
        cmocka_unit_test(what_cannot_be_studied_is_refused),
        cmocka_unit_test(a_sheet_holds_the_pictures),
        cmocka_unit_test(a_sheet_loses_no_difference),
        cmocka_unit_test(a_sheet_has_words),
        cmocka_unit_test(a_sheet_fits),
    };
    return cmocka_run_group_tests_name("study", tests, NULL, NULL);
}
