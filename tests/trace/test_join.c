/* Joining images from traced pixels, without a tracer: the colours come from pictures made up
 * here. Counts against a walk along the row, fills against computations of their own. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <string.h>

#include "../seed.h"
#include "circuit/random.h"
#include "trace/count.h"
#include "trace/join.h"

static glint_random random_state;

/* A picture to trace. */
typedef struct source {
    const glint_image *picture;
    uint8_t *asked; /* of each pixel: how often */
    uint64_t count, calls;
} source;

static glint_image *image_of(int width, int height)
{
    glint_image *image;
    glint_error err;
    assert_int_equal(glint_image_create(width, height, &image, &err), GLINT_OK);
    return image;
}

static size_t pixels_of(const glint_image *image)
{
    return (size_t)image->width * (size_t)image->height;
}

static glint_status take(void *context, const uint32_t *pixel, size_t count, glint_image *image,
                         glint_error *err)
{
    source *s = context;
    (void)err;
    for (size_t i = 0; i < count; i++) {
        memcpy(&image->rgb[3 * pixel[i]], &s->picture->rgb[3 * pixel[i]], 3);
        image->object[pixel[i]] = s->picture->object[pixel[i]];
        s->asked[pixel[i]]++;
    }
    s->count += count;
    s->calls++;
    return GLINT_OK;
}

static const glint_join plain = {
    .centre = -1, .fill = GLINT_FILL_LINEAR, .limit = GLINT_LIMIT_DEFAULT};

/* Joins a picture of garbage anew; checks what holds for every way: pixels asked for are exact,
 * none twice, and the counts are right. */
static glint_image *joined(const glint_image *picture, const glint_join *how,
                           glint_join_stats *stats)
{
    glint_image *image = image_of(picture->width, picture->height);
    memset(image->rgb, 0xa5, 3 * pixels_of(image));
    source s = {.picture = picture, .asked = calloc(pixels_of(image), 1)};
    glint_error err = {""};
    assert_non_null(s.asked);
    assert_int_equal(glint_join_image(how, take, &s, image, stats, &err), GLINT_OK);
    uint64_t traced = 0;
    for (size_t i = 0; i < pixels_of(image); i++) {
        assert_in_range(s.asked[i], 0, 1);
        traced += s.asked[i];
        if (s.asked[i])
            assert_memory_equal(&image->rgb[3 * i], &picture->rgb[3 * i], 3);
    }
    assert_int_equal(stats->traced, traced);
    assert_int_equal(stats->filled, pixels_of(image) - traced);
    free(s.asked);
    return image;
}

static void paint(glint_image *image, uint8_t (*level)(int x, int y, int component))
{
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++) {
            const size_t at = (size_t)y * (size_t)image->width + (size_t)x;
            for (int c = 0; c < 3; c++)
                image->rgb[3 * at + (size_t)c] = level(x, y, c);
            image->object[at] = 1;
        }
}

static uint8_t noise(int x, int y, int component)
{
    (void)x;
    (void)y;
    (void)component;
    return (uint8_t)glint_random_bits(&random_state);
}

/* Noise in patches: ends that are equal and ends that are not. */
static uint8_t patches(int x, int y, int component)
{
    return (uint8_t)(((x / 7) * 31 + (y / 5) * 57 + component * 11) % 4 * 2);
}

static void assert_same(const glint_image *a, const glint_image *b)
{
    assert_memory_equal(a->rgb, b->rgb, 3 * pixels_of(a));
    assert_memory_equal(a->object, b->object, pixels_of(a));
}

/* ---- Which pixels ---------------------------------------------------------------------------- */

/* By walking: pixel 1, then as many as it takes to the last. */
static uint64_t walked(int width, int segment)
{
    uint64_t traced = 1;
    for (int x = 0; x < width - 1; traced++)
        x = x + segment + 1 < width - 1 ? x + segment + 1 : width - 1;
    return traced;
}

/* Where all is equal, or every difference is allowed, only the grid is traced. */
static void counts_are_those_of_the_formula(void **state)
{
    (void)state;
    int one_too_many = 0, cases = 0;
    for (int width = 1; width <= 40; width++) {
        glint_image *flat = image_of(width, 3);
        for (int segment = 0; segment <= 41; segment++) {
            glint_join how = plain;
            glint_join_stats stats;
            how.segment = segment;
            how.limit = 0.0;
            glint_image *image = joined(flat, &how, &stats);
            const uint64_t row = walked(width, segment);
            assert_int_equal(stats.traced, 3 * row);
            assert_int_equal(glint_count_row(width, segment), row);
            const bool divides = (width - 1) % (segment + 1) == 0;
            assert_int_equal(glint_count_by_2_28(width, segment), row + divides);
            assert_int_equal(stats.levels, 0);
            assert_same(image, flat);
            one_too_many += divides;
            cases++;
            glint_image_destroy(image);
        }
        glint_image_destroy(flat);
    }
    print_message("(2.28) is one too many in %d of %d cases\n", one_too_many, cases);
    assert_int_equal(glint_count_by_2_28(640, 7), 81); /* the thesis's row */
    assert_int_equal(glint_count_row(640, 7), 81);
    assert_int_equal(glint_count_by_2_31(640, 80 * 7), 3);
}

static void an_infinite_limit_traces_the_grid_alone(void **state)
{
    (void)state;
    glint_image *picture = image_of(61, 37);
    paint(picture, noise);
    for (int fill = 0; fill < GLINT_FILL_COUNT; fill++)
        for (int segment = 0; segment < 70; segment += 3) {
            glint_join how = plain;
            glint_join_stats stats;
            how.fill = (glint_fill)fill;
            how.segment = segment;
            how.limit = INFINITY;
            glint_image_destroy(joined(picture, &how, &stats));
            const uint64_t rows = glint_fill_is_of_blocks(how.fill) ? walked(37, segment) : 37;
            assert_int_equal(stats.traced, walked(61, segment) * rows);
            assert_int_equal(stats.levels, 0);
        }
    glint_image_destroy(picture);
}

static void length_0_is_the_picture(void **state)
{
    (void)state;
    glint_image *picture = image_of(61, 37);
    paint(picture, noise);
    for (int fill = 0; fill < GLINT_FILL_COUNT; fill++) {
        glint_join how = plain;
        glint_join_stats stats;
        how.fill = (glint_fill)fill;
        how.limit = INFINITY;
        glint_image *image = joined(picture, &how, &stats);
        assert_same(image, picture);
        assert_int_equal(stats.traced, 61 * 37);
        assert_int_equal(stats.segments, 0);
        glint_image_destroy(image);
    }
    glint_image_destroy(picture);
}

/* With limit 0 what differs from the picture lies between two equal ends. Noise has none: by every
 * fill, frames of one row, column or pixel among them. */
static void limit_0_halves_wherever_ends_differ(void **state)
{
    (void)state;
    static const int sizes[][2] = {{61, 37}, {1, 1}, {1, 30}, {30, 1}, {2, 2}, {3, 40}};
    for (size_t s = 0; s < sizeof sizes / sizeof sizes[0]; s++) {
        glint_image *picture = image_of(sizes[s][0], sizes[s][1]);
        paint(picture, noise);
        for (size_t i = 0; i < pixels_of(picture); i++) {
            picture->rgb[3 * i] = (uint8_t)i; /* no two the same anywhere near */
            picture->rgb[3 * i + 1] = (uint8_t)(i >> 8);
        }
        for (int fill = 0; fill < GLINT_FILL_COUNT; fill++)
            for (int segment = 1; segment < 64; segment += 5) {
                glint_join how = plain;
                glint_join_stats stats;
                how.fill = (glint_fill)fill;
                how.segment = segment;
                how.limit = 0.0;
                glint_image *image = joined(picture, &how, &stats);
                assert_same(image, picture);
                glint_image_destroy(image);
            }
        glint_image_destroy(picture);
    }
}

/* The recursion as the header says it, a row at a time and one pixel after the other. */
static void expect(const glint_image *picture, const glint_join *how, int y, int left, int right,
                   uint8_t *traced)
{
    const uint8_t *row = &picture->rgb[3 * (size_t)y * (size_t)picture->width];
    traced[left] = traced[right] = 1;
    if (right - left < 2 || glint_measure_of(how->measure, &row[3 * (size_t)left],
                                             &row[3 * (size_t)right]) <= how->limit)
        return;
    const int middle = (left + right) / 2;
    expect(picture, how, y, left, middle, traced);
    expect(picture, how, y, middle, right, traced);
}

static void halving_is_a_recursion(void **state)
{
    (void)state;
    glint_image *picture = image_of(131, 40);
    paint(picture, patches);
    for (int measure = 0; measure < GLINT_MEASURE_COUNT; measure++)
        for (int segment = 0; segment < 140; segment += 3) {
            glint_join how = plain;
            glint_join_stats stats;
            how.measure = (glint_measure)measure;
            how.limit = 1.0;
            how.segment = segment;
            glint_image_destroy(joined(picture, &how, &stats));
            uint64_t traced = 0;
            for (int y = 0; y < 40; y++) {
                uint8_t row[131] = {0};
                for (int x = 0; x < 130; x += segment + 1)
                    expect(picture, &how, y, x, x + segment + 1 < 130 ? x + segment + 1 : 130, row);
                for (int x = 0; x < 131; x++)
                    traced += row[x];
            }
            assert_int_equal(stats.traced, traced);
        }
    glint_image_destroy(picture);
}

/* In the middle half of rows and columns the steps are shorter. */
static void the_centre_has_its_own_length(void **state)
{
    (void)state;
    glint_image *picture = image_of(160, 80);
    glint_join how = plain;
    glint_join_stats stats;
    how.segment = 9;
    how.centre = 1;
    glint_image_destroy(joined(picture, &how, &stats));
    /* 0, 10 … 40, then 42 … 120, then 130, 140, 150, 159 */
    assert_int_equal(stats.traced, 40 * walked(160, 9) + 40 * (5 + 40 + 4));
    how.centre = 9;
    glint_image_destroy(joined(picture, &how, &stats));
    assert_int_equal(stats.traced, 80 * walked(160, 9));
    glint_image_destroy(picture);
}

/* ---- What is between ------------------------------------------------------------------------- */

static void mean_and_linear_are_one_for_length_1(void **state)
{
    (void)state;
    glint_image *picture = image_of(64, 64);
    paint(picture, noise);
    glint_join how = plain;
    glint_join_stats stats;
    how.segment = 1;
    how.limit = INFINITY;
    glint_image *linear = joined(picture, &how, &stats);
    how.fill = GLINT_FILL_MEAN;
    glint_image *mean = joined(picture, &how, &stats);
    assert_same(linear, mean);
    how.segment = 2;
    glint_image *longer = joined(picture, &how, &stats);
    how.fill = GLINT_FILL_LINEAR;
    glint_image *straight = joined(picture, &how, &stats);
    assert_memory_not_equal(longer->rgb, straight->rgb, 3 * pixels_of(longer));
    glint_image_destroy(linear);
    glint_image_destroy(mean);
    glint_image_destroy(longer);
    glint_image_destroy(straight);
    glint_image_destroy(picture);
}

static int level_at(const glint_image *image, int x, int y, int component)
{
    return image->rgb[3 * ((size_t)y * (size_t)image->width + (size_t)x) + (size_t)component];
}

/* The grid's pixels around one, as the header says. */
static int before(int at, int step)
{
    return at / step * step;
}

static int after(int at, int step, int size)
{
    const int next = before(at, step) + step;
    return next < size ? next : size - 1;
}

static void rows_against_real_numbers(void **state)
{
    (void)state;
    glint_image *picture = image_of(77, 9);
    paint(picture, noise);
    for (int segment = 1; segment < 20; segment++)
        for (int fill = GLINT_FILL_MEAN; fill <= GLINT_FILL_LINEAR; fill++) {
            glint_join how = plain;
            glint_join_stats stats;
            how.segment = segment;
            how.limit = INFINITY;
            how.fill = (glint_fill)fill;
            glint_image *image = joined(picture, &how, &stats);
            for (int x = 0; x < 77; x++) {
                const int left = before(x, segment + 1);
                const int right = after(x, segment + 1, 77);
                const double t =
                    fill == GLINT_FILL_MEAN ? 0.5 : (double)(x - left) / (right - left);
                if (x == left || x == right)
                    continue;
                for (int i = 0; i < 27; i++) {
                    const double a = level_at(picture, left, i / 3, i % 3);
                    const double b = level_at(picture, right, i / 3, i % 3);
                    const double d = level_at(image, x, i / 3, i % 3) - (a + (b - a) * t);
                    assert_true(d > -0.5 - 1e-9 && d <= 0.5 + 1e-9);
                }
            }
            glint_image_destroy(image);
        }
    glint_image_destroy(picture);
}

/* Cubic convolution as it is published, a kernel: (a = −1/2) of the distance in steps. */
static double kernel(double s)
{
    s = fabs(s);
    return s < 1.0   ? 1.5 * s * s * s - 2.5 * s * s + 1.0
           : s < 2.0 ? -0.5 * s * s * s + 2.5 * s * s - 4.0 * s + 2.0
                     : 0.0;
}

static double clamped(double level)
{
    return level < 0.0 ? 0.0 : level > 255.0 ? 255.0 : level;
}

/* On a regular grid, away from its border, both cubic fills are that kernel. */
static void cubic_fills_are_cubic_convolution(void **state)
{
    (void)state;
    for (int step = 2; step <= 8; step++) {
        const int size = 9 * step + 1;
        glint_image *picture = image_of(size, size);
        paint(picture, noise);
        for (int fill = GLINT_FILL_CUBIC; fill <= GLINT_FILL_BICUBIC; fill += 3) {
            glint_join how = plain;
            glint_join_stats stats;
            how.segment = step - 1;
            how.limit = INFINITY;
            how.fill = (glint_fill)fill;
            glint_image *image = joined(picture, &how, &stats);
            for (int y = step; y <= size - step - 1; y++)
                for (int x = step; x <= size - step - 1; x++) {
                    double sum = 0.0;
                    const bool rows = fill == GLINT_FILL_CUBIC;
                    for (int j = rows ? y : 0; j < (rows ? y + 1 : size); j += step)
                        for (int i = 0; i < size; i += step)
                            sum += kernel((double)(x - i) / step) *
                                   (rows ? 1.0 : kernel((double)(y - j) / step)) *
                                   level_at(picture, i, j, 1);
                    assert_true(fabs(level_at(image, x, y, 1) - clamped(sum)) <= 0.5 + 1e-6);
                }
            glint_image_destroy(image);
        }
        glint_image_destroy(picture);
    }
}

static uint8_t slope(int x, int y, int component)
{
    return (uint8_t)(component == 0 ? 2 * x + y : component == 1 ? 200 - x - y : 3 * x);
}

static uint8_t bowl(int x, int y, int component)
{
    return (uint8_t)((x - 30) * (x - 30) / 8.0 + (y - 20) * (y - 20) / 8.0 + 10 * component + 0.5);
}

static int largest_error(const glint_image *picture, glint_fill fill, int segment)
{
    glint_join how = plain;
    glint_join_stats stats;
    glint_image_difference difference;
    glint_error err;
    how.segment = segment;
    how.limit = INFINITY;
    how.fill = fill;
    glint_image *image = joined(picture, &how, &stats);
    assert_int_equal(glint_image_compare(picture, image, &difference, &err), GLINT_OK);
    glint_image_destroy(image);
    return difference.largest;
}

/* A plane is exact by every fill that is at least linear; a paraboloid by the cubic ones alone, and
 * the frame's sides do not fit the steps. */
static void planes_and_paraboloids(void **state)
{
    (void)state;
    glint_image *picture = image_of(60, 43);
    paint(picture, slope);
    for (int segment = 1; segment < 12; segment++) {
        assert_int_equal(largest_error(picture, GLINT_FILL_LINEAR, segment), 0);
        assert_int_equal(largest_error(picture, GLINT_FILL_CUBIC, segment), 0);
        assert_int_equal(largest_error(picture, GLINT_FILL_BILINEAR, segment), 0);
        assert_int_equal(largest_error(picture, GLINT_FILL_BICUBIC, segment), 0);
        assert_true(largest_error(picture, GLINT_FILL_NEAREST, segment) > 0);
    }
    glint_image_destroy(picture);
    picture = image_of(61, 41);
    paint(picture, bowl);
    assert_true(largest_error(picture, GLINT_FILL_BILINEAR, 9) >= 6); /* 2 · 10²/(8 · 4) */
    assert_true(largest_error(picture, GLINT_FILL_BICUBIC, 9) <
                largest_error(picture, GLINT_FILL_BILINEAR, 9));
    assert_true(largest_error(picture, GLINT_FILL_CUBIC, 9) <
                largest_error(picture, GLINT_FILL_LINEAR, 9));
    glint_image_destroy(picture);
}

static void the_nearest_corner(void **state)
{
    (void)state;
    glint_image *picture = image_of(41, 21);
    paint(picture, noise);
    glint_join how = plain;
    glint_join_stats stats;
    how.segment = 4;
    how.limit = INFINITY;
    how.fill = GLINT_FILL_NEAREST;
    glint_image *image = joined(picture, &how, &stats);
    for (int y = 0; y < 21; y++)
        for (int x = 0; x < 41; x++)
            assert_int_equal(level_at(image, x, y, 0),
                             level_at(picture, (x + 2) / 5 * 5, (y + 2) / 5 * 5, 0));
    glint_image_destroy(image);
    glint_image_destroy(picture);
}

/* Its ends are equal: the thin line between them is lost, whatever the limit (2.6's own fault). */
static void a_thin_line_between_equal_ends_is_lost(void **state)
{
    (void)state;
    glint_image *picture = image_of(33, 1);
    glint_join how = plain;
    glint_join_stats stats;
    picture->rgb[3 * 5] = 255;
    how.segment = 7;
    how.limit = 0.0;
    glint_image *image = joined(picture, &how, &stats);
    assert_int_equal(level_at(image, 5, 0, 0), 0);
    assert_int_equal(stats.traced, 5);
    glint_image_destroy(image);
    glint_image_destroy(picture);
}

/* ---- Measures, and what is refused ----------------------------------------------------------- */

static void measures(void **state)
{
    (void)state;
    static const uint8_t black[3] = {0, 0, 0}, white[3] = {255, 255, 255};
    static const uint8_t red[3] = {255, 0, 0}, green[3] = {0, 255, 0}, near[3] = {0, 3, 2};
    assert_true(glint_measure_of(GLINT_MEASURE_DELTA_E, red, red) == 0.0);
    assert_true(fabs(glint_measure_of(GLINT_MEASURE_DELTA_E, black, white) - 100.0) < 1e-9);
    /* L*a*b* of sRGB's primaries as published: 53.24, 80.09, 67.20 and 87.73, −86.18, 83.18 */
    assert_true(fabs(glint_measure_of(GLINT_MEASURE_DELTA_E, red, green) -
                     sqrt(34.49 * 34.49 + 166.27 * 166.27 + 15.98 * 15.98)) < 0.05);
    assert_true(glint_measure_of(GLINT_MEASURE_LEVELS, black, near) == 3.0);
    assert_true(fabs(glint_measure_of(GLINT_MEASURE_RMS, black, white) - 100.0) < 1e-9);
    assert_true(fabs(glint_measure_of(GLINT_MEASURE_RMS, black, near) -
                     100.0 * sqrt(13.0 / 3.0) / 255.0) < 1e-9);
}

static void what_makes_no_sense_is_refused(void **state)
{
    (void)state;
    static const struct {
        glint_join how;
        const char *says;
    } cases[] = {
        {{.segment = -1, .centre = -1}, "segments: a length is not from 0 to 16383"},
        {{.segment = 1 << 14, .centre = -1}, "segments: a length is not from 0 to 16383"},
        {{.centre = -2}, "segments: a length is not from 0 to 16383"},
        {{.centre = -1, .limit = -1.0}, "segments: the limit -1 is below 0"},
        {{.centre = -1, .limit = (double)NAN}, "segments: the limit nan is below 0"},
        {{.centre = 1, .fill = GLINT_FILL_BICUBIC},
         "segments: a length of its own for the centre needs a fill along rows"},
        {{.centre = -1, .fill = GLINT_FILL_COUNT}, "segments: unknown fill or measure"},
        {{.centre = -1, .measure = GLINT_MEASURE_COUNT}, "segments: unknown fill or measure"},
    };
    glint_image *image = image_of(4, 4);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        glint_error err = {""};
        source s = {0};
        assert_int_equal(glint_join_image(&cases[i].how, take, &s, image, NULL, &err),
                         GLINT_BAD_ARGUMENT);
        assert_string_equal(err.text, cases[i].says);
    }
    glint_image_destroy(image);
}

static glint_status refuse(void *context, const uint32_t *pixel, size_t count, glint_image *image,
                           glint_error *err)
{
    source *s = context;
    (void)pixel;
    (void)count;
    memset(image->rgb, 0, 3 * pixels_of(image));
    image->rgb[0] = 255; /* so that a second level is wanted */
    return s->calls++ == 0 ? GLINT_OK : glint_fail(err, GLINT_INTERRUPTED, "enough");
}

static void a_failure_ends_it(void **state)
{
    (void)state;
    glint_image *image = image_of(64, 4);
    glint_join how = plain;
    glint_error err = {""};
    source s = {0};
    how.segment = 15;
    assert_int_equal(glint_join_image(&how, refuse, &s, image, NULL, &err), GLINT_INTERRUPTED);
    assert_string_equal(err.text, "enough");
    assert_int_equal(s.calls, 2);
    glint_image_destroy(image);
}

int main(void)
{
    random_state.state = seed_of_this_run();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(counts_are_those_of_the_formula),
        cmocka_unit_test(an_infinite_limit_traces_the_grid_alone),
        cmocka_unit_test(length_0_is_the_picture),
        cmocka_unit_test(limit_0_halves_wherever_ends_differ),
        cmocka_unit_test(halving_is_a_recursion),
        cmocka_unit_test(the_centre_has_its_own_length),
        cmocka_unit_test(mean_and_linear_are_one_for_length_1),
        cmocka_unit_test(rows_against_real_numbers),
        cmocka_unit_test(cubic_fills_are_cubic_convolution),
        cmocka_unit_test(planes_and_paraboloids),
        cmocka_unit_test(the_nearest_corner),
        cmocka_unit_test(a_thin_line_between_equal_ends_is_lost),
        cmocka_unit_test(measures),
        cmocka_unit_test(what_makes_no_sense_is_refused),
        cmocka_unit_test(a_failure_ends_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
