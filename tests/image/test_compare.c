/* The comparison of two pictures, against figures worked out by hand. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "image/image.h"

/* A picture of 4 × 2 pixels, all object, every component 100. */
static glint_image *make_grey(void)
{
    glint_image *image;
    glint_error err;
    assert_int_equal(glint_image_create(4, 2, &image, &err), GLINT_OK);
    memset(image->rgb, 100, 24);
    memset(image->object, 1, 8);
    return image;
}

static glint_image_difference compare(const glint_image *a, const glint_image *b)
{
    glint_image_difference difference;
    glint_error err;
    assert_int_equal(glint_image_compare(a, b, &difference, &err), GLINT_OK);
    return difference;
}

static void assert_near(double found, double expected)
{
    if (!(fabs(found - expected) <= 1e-12 * fabs(expected)))
        fail_msg("%.17g is not %.17g", found, expected);
}

static void equal_pictures(void **state)
{
    (void)state;
    glint_image *a = make_grey();
    const glint_image_difference difference = compare(a, a);
    assert_int_equal(difference.pixels, 8);
    assert_int_equal(difference.object_pixels, 8);
    assert_int_equal(difference.differing_pixels, 0);
    assert_int_equal(difference.mask_pixels, 0);
    assert_int_equal(difference.largest, 0);
    assert_int_equal(difference.first_x, -1);
    assert_int_equal(difference.first_y, -1);
    assert_true(difference.nmse == 0.0);
    assert_true(isinf(difference.psnr));
    glint_image_destroy(a);
}

static void counts_and_errors(void **state)
{
    (void)state;
    glint_image *a = make_grey();
    glint_image *b = make_grey();
    b->rgb[3 * 5 + 0] = 103; /* pixel x=1 y=1: 3² + 4² */
    b->rgb[3 * 5 + 2] = 96;
    b->rgb[3 * 7 + 1] = 90; /* pixel x=3 y=1: 10² */
    const glint_image_difference difference = compare(a, b);
    assert_int_equal(difference.differing_pixels, 2);
    assert_int_equal(difference.largest, 10);
    assert_int_equal(difference.first_x, 1);
    assert_int_equal(difference.first_y, 1);
    assert_near(difference.nmse, 125.0 / (24 * 100.0 * 100.0));
    assert_near(difference.psnr, 10 * log10(255.0 * 255.0 * 24.0 / 125.0));
    glint_image_destroy(a);
    glint_image_destroy(b);
}

/* A difference of one in one component of one pixel, or in its mask, and nothing else. */
static void each_component_of_each_pixel_is_looked_at(void **state)
{
    (void)state;
    glint_image *a = make_grey();
    for (int i = 0; i < 4 * 8; i++) {
        glint_image *b = make_grey();
        const int pixel = i / 4;
        const bool is_mask = i % 4 == 3;
        if (is_mask)
            b->object[pixel] = 0;
        else
            b->rgb[3 * pixel + i % 4] = 101;
        const glint_image_difference difference = compare(a, b);
        assert_int_equal(difference.differing_pixels, !is_mask);
        assert_int_equal(difference.mask_pixels, is_mask);
        assert_int_equal(difference.largest, !is_mask);
        assert_int_equal(difference.first_x, pixel % 4);
        assert_int_equal(difference.first_y, pixel / 4);
        assert_near(difference.nmse, is_mask ? 0.0 : 1.0 / (24 * 100.0 * 100.0));
        glint_image_destroy(b);
    }
    glint_image_destroy(a);
}

static void the_background_counts_as_differing_but_not_in_nmse(void **state)
{
    (void)state;
    glint_image *a = make_grey();
    glint_image *b = make_grey();
    a->object[0] = b->object[0] = 0;
    b->rgb[0] = 200;
    const glint_image_difference difference = compare(a, b);
    assert_int_equal(difference.object_pixels, 7);
    assert_int_equal(difference.differing_pixels, 1);
    assert_int_equal(difference.largest, 100);
    assert_true(difference.nmse == 0.0);
    assert_true(isinf(difference.psnr));
    glint_image_destroy(a);
    glint_image_destroy(b);
}

static void the_object_of_either_counts(void **state)
{
    (void)state;
    glint_image *a = make_grey();
    glint_image *b = make_grey();
    memset(a->object, 0, 8);
    memset(b->object, 0, 8);
    a->object[2] = 1;
    b->object[3] = 1;
    b->rgb[9] = 110; /* pixel 3 */
    const glint_image_difference difference = compare(a, b);
    assert_int_equal(difference.object_pixels, 2);
    assert_int_equal(difference.mask_pixels, 2);
    assert_int_equal(difference.first_x, 2);
    assert_int_equal(difference.first_y, 0);
    assert_near(difference.nmse, 100.0 / (6 * 100.0 * 100.0));
    glint_image_destroy(a);
    glint_image_destroy(b);
}

static void nmse_is_relative_to_the_first(void **state)
{
    (void)state;
    glint_image *a = make_grey();
    glint_image *b = make_grey();
    memset(b->rgb, 200, 24);
    assert_near(compare(a, b).nmse, 1.0);
    assert_near(compare(b, a).nmse, 0.25);
    memset(a->rgb, 0, 24);
    assert_true(isinf(compare(a, b).nmse));
    glint_image_destroy(a);
    glint_image_destroy(b);
}

static void sizes_must_agree(void **state)
{
    (void)state;
    glint_image *a = make_grey();
    glint_image *b;
    glint_image *picture;
    glint_image_difference difference;
    glint_error err;
    assert_int_equal(glint_image_create(2, 4, &b, &err), GLINT_OK);
    assert_int_equal(glint_image_compare(a, b, &difference, &err), GLINT_BAD_INPUT);
    assert_string_equal(err.text, "the pictures differ in size: 4x2 against 2x4");
    assert_int_equal(glint_image_difference_picture(a, b, &picture, &err), GLINT_BAD_INPUT);
    assert_null(picture);
    glint_image_destroy(a);
    glint_image_destroy(b);
}

static void the_difference_picture_follows_its_legend(void **state)
{
    (void)state;
    glint_image *a = make_grey();
    glint_image *b = make_grey();
    glint_image *picture;
    glint_error err;
    static const uint8_t expected[8][3] = {{64, 128, 255}, {0, 220, 100}, {0, 220, 100},
                                           {255, 230, 0},  {255, 140, 0}, {255, 0, 0},
                                           {255, 0, 255},  {50, 50, 50}};
    b->rgb[0] = 99;                  /* 1 */
    b->rgb[3 + 1] = 102;             /* 2 */
    b->rgb[6 + 2] = 103;             /* 3 */
    b->rgb[9] = 115;                 /* 15 */
    b->rgb[12] = 37;                 /* 63 */
    b->rgb[15] = 164;                /* 64 */
    b->object[6] = 0;                /* same colour, other mask */
    a->object[7] = b->object[7] = 0; /* equal, background */
    assert_int_equal(glint_image_difference_picture(a, b, &picture, &err), GLINT_OK);
    for (size_t i = 0; i < 8; i++) {
        assert_memory_equal(picture->rgb + 3 * i, expected[i], 3);
        assert_int_equal(picture->object[i], 1);
    }
    glint_image_destroy(a);
    glint_image_destroy(b);
    glint_image_destroy(picture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_pictures),
        cmocka_unit_test(counts_and_errors),
        cmocka_unit_test(each_component_of_each_pixel_is_looked_at),
        cmocka_unit_test(the_background_counts_as_differing_but_not_in_nmse),
        cmocka_unit_test(the_object_of_either_counts),
        cmocka_unit_test(nmse_is_relative_to_the_first),
        cmocka_unit_test(sizes_must_agree),
        cmocka_unit_test(the_difference_picture_follows_its_legend),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
