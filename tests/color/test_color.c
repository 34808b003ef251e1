/* Colour models: every colour there and back, known colours, what has no hue or no saturation. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>
#include <math.h>

#include "color/color.h"

#define COLORS (1u << 24)

static glint_rgb rgb_of(uint32_t code)
{
    return (glint_rgb){(uint8_t)(code >> 16), (uint8_t)(code >> 8), (uint8_t)code};
}

static uint32_t code_of(glint_rgb rgb)
{
    return (uint32_t)rgb.r << 16 | (uint32_t)rgb.g << 8 | rgb.b;
}

static void every_rgb_comes_back_from_hsv(void **state)
{
    (void)state;
    for (uint32_t code = 0; code < COLORS; code++) {
        const glint_hsv hsv = glint_hsv_of_rgb(rgb_of(code));
        glint_rgb back = {0, 0, 0};
        const bool held = hsv.h >= 0.0 && hsv.h < 360.0 && hsv.s >= 0.0 && hsv.s <= 1.0 &&
                          hsv.v >= 0.0 && hsv.v <= 1.0;
        if (!held || glint_rgb_of_hsv(&hsv, &back) != GLINT_OK || code_of(back) != code)
            fail_msg("#%06x is hsv %g,%g,%g is #%06x", code, hsv.h, hsv.s, hsv.v, code_of(back));
    }
}

static void every_rgb_comes_back_from_cmyk(void **state)
{
    (void)state;
    for (uint32_t code = 0; code < COLORS; code++) {
        const glint_cmyk cmyk = glint_cmyk_of_rgb(rgb_of(code));
        glint_rgb back = {0, 0, 0};
        /* The least ink: one of the three is absent. */
        const bool least = cmyk.c == 0.0 || cmyk.m == 0.0 || cmyk.y == 0.0;
        if (!least || glint_rgb_of_cmyk(&cmyk, &back) != GLINT_OK || code_of(back) != code) {
            fail_msg("#%06x is cmyk %g,%g,%g,%g is #%06x", code, cmyk.c, cmyk.m, cmyk.y, cmyk.k,
                     code_of(back));
        }
    }
}

static void known_colors(void **state)
{
    (void)state;
    static const struct {
        uint32_t rgb;
        glint_hsv hsv;
        glint_cmyk cmyk;
    } known[] = {
        {0xff0000, {0, 1, 1}, {0, 1, 1, 0}},
        {0xffff00, {60, 1, 1}, {0, 0, 1, 0}},
        {0x00ff00, {120, 1, 1}, {1, 0, 1, 0}},
        {0x00ffff, {180, 1, 1}, {1, 0, 0, 0}},
        {0x0000ff, {240, 1, 1}, {1, 1, 0, 0}},
        {0xff00ff, {300, 1, 1}, {0, 1, 0, 0}},
        {0xffffff, {0, 0, 1}, {0, 0, 0, 0}},
        {0x000000, {0, 0, 0}, {0, 0, 0, 1}},
        {0x333333, {0, 0, 0.2}, {0, 0, 0, 0.8}},
        {0x336699, {210, 2.0 / 3.0, 0.6}, {2.0 / 3.0, 1.0 / 3.0, 0, 0.4}},
        {0x993366, {330, 2.0 / 3.0, 0.6}, {0, 2.0 / 3.0, 1.0 / 3.0, 0.4}},
    };
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        const glint_hsv hsv = glint_hsv_of_rgb(rgb_of(known[i].rgb));
        const glint_cmyk cmyk = glint_cmyk_of_rgb(rgb_of(known[i].rgb));
        assert_true(fabs(hsv.h - known[i].hsv.h) < 1e-12 && fabs(hsv.s - known[i].hsv.s) < 1e-15 &&
                    fabs(hsv.v - known[i].hsv.v) < 1e-15);
        assert_true(
            fabs(cmyk.c - known[i].cmyk.c) < 1e-15 && fabs(cmyk.m - known[i].cmyk.m) < 1e-15 &&
            fabs(cmyk.y - known[i].cmyk.y) < 1e-15 && fabs(cmyk.k - known[i].cmyk.k) < 1e-15);
        glint_rgb rgb = {1, 2, 3};
        assert_int_equal(glint_rgb_of_hsv(&known[i].hsv, &rgb), GLINT_OK);
        assert_int_equal(code_of(rgb), known[i].rgb);
        assert_int_equal(glint_rgb_of_cmyk(&known[i].cmyk, &rgb), GLINT_OK);
        assert_int_equal(code_of(rgb), known[i].rgb);
    }
}

/* There are more of them than of RGB's. */
static void what_differs_may_be_one_rgb_color(void **state)
{
    (void)state;
    glint_rgb rgb;
    for (int degrees = 0; degrees <= 360; degrees++) {
        const glint_hsv black = {degrees, 0.7, 0.0}, grey = {degrees, 0.0, 0.2};
        assert_int_equal(glint_rgb_of_hsv(&black, &rgb), GLINT_OK);
        assert_int_equal(code_of(rgb), 0x000000);
        assert_int_equal(glint_rgb_of_hsv(&grey, &rgb), GLINT_OK);
        assert_int_equal(code_of(rgb), 0x333333);
    }
    const glint_hsv full_circle = {360, 1, 1};
    assert_int_equal(glint_rgb_of_hsv(&full_circle, &rgb), GLINT_OK);
    assert_int_equal(code_of(rgb), 0xff0000);
    const glint_cmyk inks[] = {{1, 1, 1, 0}, {1, 1, 1, 1}, {0.3, 0.9, 0, 1}, {0, 0, 0, 1}};
    for (int i = 0; i < 4; i++) {
        assert_int_equal(glint_rgb_of_cmyk(&inks[i], &rgb), GLINT_OK);
        assert_int_equal(code_of(rgb), 0x000000);
    }
}

/* Half a level is rounded up though a double is a little short of it. */
static void halves_are_rounded_up(void **state)
{
    (void)state;
    static const glint_cmyk tenth[] = {{0, 0, 0, 0.9}, {0.5, 0.5, 0.5, 0.8}, {0.9, 0.9, 0.9, 0}};
    static const glint_hsv red[] = {{0, 0.9, 1}, {0, 0.8, 0.5}, {360, 0.9, 1}};
    glint_rgb rgb;
    for (int i = 0; i < 3; i++) {
        assert_int_equal(glint_rgb_of_cmyk(&tenth[i], &rgb), GLINT_OK);
        assert_int_equal(code_of(rgb), 0x1a1a1a);
        assert_int_equal(glint_rgb_of_hsv(&red[i], &rgb), GLINT_OK);
        assert_int_equal(code_of(rgb) & 0xffff, 0x1a1a);
    }
    /* Every whole hue, percent and percent, against integers: v(100·60 − s·f)·255 / 600000. */
    for (int f = 0; f < 60; f++)
        for (int s = 0; s <= 100; s++)
            for (int v = 0; v <= 100; v++) {
                const glint_hsv hsv = {60 + f, s / 100.0, v / 100.0};
                assert_int_equal(glint_rgb_of_hsv(&hsv, &rgb), GLINT_OK);
                assert_int_equal(rgb.r, (v * (6000 - s * f) * 51 + 60000) / 120000);
            }
}

/* Whole degrees and percents are too few for 2^24 colours; how many of them come back is quoted in
 * docs/frames.md. */
static void whole_degrees_and_percents_lose_colors(void **state)
{
    (void)state;
    unsigned hsv_back = 0, cmyk_back = 0;
    for (uint32_t code = 0; code < COLORS; code++) {
        const glint_hsv hsv = glint_hsv_of_rgb(rgb_of(code));
        const glint_cmyk cmyk = glint_cmyk_of_rgb(rgb_of(code));
        const glint_hsv rounded = {(int)(hsv.h + 0.5), (int)(hsv.s * 100 + 0.5) / 100.0,
                                   (int)(hsv.v * 100 + 0.5) / 100.0};
        const glint_cmyk percents = {
            (int)(cmyk.c * 100 + 0.5) / 100.0, (int)(cmyk.m * 100 + 0.5) / 100.0,
            (int)(cmyk.y * 100 + 0.5) / 100.0, (int)(cmyk.k * 100 + 0.5) / 100.0};
        glint_rgb back;
        glint_rgb_of_hsv(&rounded, &back);
        hsv_back += code_of(back) == code;
        glint_rgb_of_cmyk(&percents, &back);
        cmyk_back += code_of(back) == code;
    }
    print_message("of %u colours %u come back from whole HSV, %u from whole CMYK\n", COLORS,
                  hsv_back, cmyk_back);
    assert_int_equal(hsv_back, 2044735);
    assert_int_equal(cmyk_back, 2135387);
}

static void values_out_of_range_are_refused(void **state)
{
    (void)state;
    const glint_hsv hsv[] = {{-1, 0, 0},    {360.1, 0, 0}, {0, 1.1, 0}, {0, -0.1, 0},
                             {0, 0, 1.001}, {NAN, 0, 0},   {0, NAN, 0}, {0, 0, -0.1}};
    const glint_cmyk cmyk[] = {{-0.1, 0, 0, 0}, {0, 1.1, 0, 0}, {0, 0, 1.1, 0},
                               {0, 0, 0, 1.1},  {NAN, 0, 0, 0}, {0, 0, 0, NAN}};
    glint_rgb rgb = {1, 2, 3};
    for (size_t i = 0; i < sizeof hsv / sizeof hsv[0]; i++)
        assert_int_equal(glint_rgb_of_hsv(&hsv[i], &rgb), GLINT_BAD_ARGUMENT);
    for (size_t i = 0; i < sizeof cmyk / sizeof cmyk[0]; i++)
        assert_int_equal(glint_rgb_of_cmyk(&cmyk[i], &rgb), GLINT_BAD_ARGUMENT);
    assert_int_equal(code_of(rgb), 0x010203);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_rgb_comes_back_from_hsv),
        cmocka_unit_test(every_rgb_comes_back_from_cmyk),
        cmocka_unit_test(known_colors),
        cmocka_unit_test(what_differs_may_be_one_rgb_color),
        cmocka_unit_test(halves_are_rounded_up),
        cmocka_unit_test(whole_degrees_and_percents_lose_colors),
        cmocka_unit_test(values_out_of_range_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
