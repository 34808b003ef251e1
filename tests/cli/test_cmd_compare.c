/* `glint compare`: its output for two pictures and its exit status. */
#define _XOPEN_SOURCE 700

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "file/json.h"
#include "image/image.h"
#include "run.h"

/* A grey picture of 5 × 4 in the scratch directory, one component of pixel x=2 y=1 changed. */
static void make_png(const char *name, int width, uint8_t changed, uint8_t mask)
{
    glint_image *image;
    glint_error err;
    assert_int_equal(glint_image_create(width, 4, &image, &err), GLINT_OK);
    memset(image->rgb, 100, (size_t)width * 4 * 3);
    memset(image->object, 1, (size_t)width * 4);
    image->rgb[3 * (width + 2) + 1] = changed;
    image->object[0] = mask;
    assert_int_equal(glint_image_write_png(image, scratch_path(name), &err), GLINT_OK);
    glint_image_destroy(image);
}

static outcome compare(const char *a, const char *b, const char *options)
{
    char command_line[2048];
    snprintf(command_line, sizeof command_line, "compare %s %s%s%s", scratch_path(a),
             scratch_path(b), *options != '\0' ? " " : "", options);
    return run(command_line, "");
}

static void equal_pictures(void **state)
{
    (void)state;
    make_png("a.png", 5, 100, 1);
    make_png("b.png", 5, 100, 1);
    outcome done = compare("a.png", "b.png", "");
    assert_outcome(&done, 0, "");
    assert_string_equal(done.out, "0 differing pixels of 20, largest difference 0 of 255\n"
                                  "over the object's 20 pixels: NMSE 0 (equal), PSNR inf dB\n");
    forget(&done);
}

static void a_difference_by_another_name_is_refused(void **state)
{
    (void)state;
    char options[1024];
    make_png("a.png", 5, 100, 1);
    (void)snprintf(options, sizeof options, "--diff %s", scratch_path("difference.gif"));
    outcome done = compare("a.png", "a.png", options);
    assert_int_equal(done.status, 2);
    assert_says(done.err,
                "difference.gif: pictures are written as PNG: use a name ending in .png\n");
    assert_int_equal(access(scratch_path("difference.gif"), F_OK), -1);
    forget(&done);
}

static void differing_pictures(void **state)
{
    (void)state;
    make_png("a.png", 5, 100, 1);
    make_png("b.png", 5, 110, 1);
    outcome done = compare("a.png", "b.png", "");
    assert_outcome(&done, 1, "");
    /* 10² over 60 components of 100²: 1/6000. 10·log10(255²·60/100) = 45.9 dB. */
    assert_string_equal(done.out,
                        "1 differing pixels of 20, largest difference 10 of 255\n"
                        "first at x=2 y=1\n"
                        "over the object's 20 pixels: NMSE 0.000166667 (slight differences), "
                        "PSNR 45.91 dB\n");
    forget(&done);
}

static void a_differing_mask_is_a_difference(void **state)
{
    (void)state;
    make_png("a.png", 5, 100, 1);
    make_png("b.png", 5, 100, 0);
    outcome done = compare("a.png", "b.png", "");
    assert_outcome(&done, 1, "");
    assert_says(done.out, "0 differing pixels of 20");
    assert_says(done.out, "1 pixels belong to the object in one picture only\n");
    assert_says(done.out, "first at x=0 y=0\n");
    forget(&done);
}

static double number(const json_t *json, const char *name)
{
    const json_t *value = json_object_get(json, name);
    if (!json_is_number(value))
        fail_msg("%s is not a number", name);
    return json_number_value(value);
}

static void json_says_the_same(void **state)
{
    (void)state;
    make_png("a.png", 5, 100, 1);
    make_png("b.png", 5, 110, 1);
    outcome done = compare("a.png", "b.png", "--json");
    assert_outcome(&done, 1, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    assert_true(json_is_false(json_object_get(json, "equal")));
    assert_true(number(json, "pixels") == 20 && number(json, "object_pixels") == 20);
    assert_true(number(json, "differing_pixels") == 1 && number(json, "mask_pixels") == 0);
    assert_true(number(json, "largest") == 10);
    assert_true(number(json, "first_x") == 2 && number(json, "first_y") == 1);
    assert_true(fabs(number(json, "nmse") - 1.0 / 6000.0) < 1e-12);
    assert_true(fabs(number(json, "psnr") - 10.0 * log10(255.0 * 255.0 * 0.6)) < 1e-9);
    json_decref(json);
    forget(&done);

    done = compare("a.png", "a.png", "--json");
    assert_outcome(&done, 0, "");
    json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_true(json_is_true(json_object_get(json, "equal")));
    assert_true(json_is_null(json_object_get(json, "psnr")));
    json_decref(json);
    forget(&done);
}

static void the_difference_picture_is_written(void **state)
{
    (void)state;
    char options[1100];
    glint_error err;
    glint_image *picture;
    make_png("a.png", 5, 100, 1);
    make_png("b.png", 5, 110, 1);
    snprintf(options, sizeof options, "--diff %s", scratch_path("d.png"));
    outcome done = compare("a.png", "b.png", options);
    assert_outcome(&done, 1, "");
    forget(&done);
    static const uint8_t yellow[3] = {255, 230, 0};
    static const uint8_t dimmed[3] = {50, 50, 50};
    assert_int_equal(glint_image_read_png(scratch_path("d.png"), &picture, &err), GLINT_OK);
    assert_memory_equal(picture->rgb + 3 * 7, yellow, 3);
    assert_memory_equal(picture->rgb, dimmed, 3);
    glint_image_destroy(picture);
}

static void what_cannot_be_compared_is_a_failure(void **state)
{
    (void)state;
    make_png("a.png", 5, 100, 1);
    make_png("wide.png", 6, 100, 1);
    scratch_write(scratch_path("text.png"), "no picture", 10);
    static const struct {
        const char *b, *reason;
    } failures[] = {
        {"wide.png", "glint compare: the pictures differ in size: 5x4 against 6x4\n"},
        {"missing.png", "missing.png: No such file or directory\n"},
        {"text.png", "text.png: not a readable PNG: Not a PNG file\n"},
    };
    for (size_t i = 0; i < sizeof failures / sizeof failures[0]; i++) {
        outcome done = compare("a.png", failures[i].b, "");
        assert_outcome(&done, 2, NULL);
        assert_string_equal(done.out, "");
        assert_says(done.err, failures[i].reason);
        forget(&done);
    }
    outcome done = compare("a.png", "a.png", "--diff /dev/full");
    assert_outcome(&done, 2, "glint compare: cannot write /dev/full: No space left on device\n");
    forget(&done);
}

static void no_input_is_overwritten(void **state)
{
    (void)state;
    char options[2048];
    make_png("kept.png", 5, 100, 1);
    (void)snprintf(options, sizeof options, "--diff %s", scratch_path("./kept.png"));
    outcome done = compare("kept.png", "kept.png", options);
    assert_int_equal(done.status, 2);
    assert_says(done.err, "is one of the pictures being compared");
    forget(&done);
    done = compare("kept.png", "kept.png", "");
    assert_outcome(&done, 0, "");
    forget(&done);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_pictures),
        cmocka_unit_test(a_difference_by_another_name_is_refused),
        cmocka_unit_test(differing_pictures),
        cmocka_unit_test(a_differing_mask_is_a_difference),
        cmocka_unit_test(json_says_the_same),
        cmocka_unit_test(the_difference_picture_is_written),
        cmocka_unit_test(what_cannot_be_compared_is_a_failure),
        cmocka_unit_test(no_input_is_overwritten),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
