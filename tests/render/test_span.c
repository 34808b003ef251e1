/* The span unit: its values against sums made otherwise, runs of any length, and what it counts. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <math.h>

#include "../seed.h"
#include "render/span.h"

/* Longer than any edge within the guard square. */
#define LONGEST 66000

static glint_operations ignored;

/* All values of a run, segment after segment, as a row of pixels gets them. */
static void interpolate(const glint_run *run, int shifts, uint8_t *values)
{
    const int32_t count = glint_run_segment_count(run);
    for (int32_t i = 0; i < count; i++) {
        const glint_run segment = glint_run_segment(run, i);
        uint8_t *at = values + 3 * (size_t)(segment.start - run->start);
        glint_division division;
        if (!glint_run_set_up(&segment, &division, &ignored)) {
            memcpy(at, segment.from, 3);
            continue;
        }
        glint_quotients quotients;
        assert_int_equal(glint_divide_batch(shifts, &division, 1, &quotients), GLINT_OK);
        assert_false(quotients.out_of_table);
        const int32_t last = i == count - 1 ? segment.end : segment.end - 1;
        glint_run_walk(&segment, shifts, &quotients, segment.start, last, at, &ignored);
    }
}

/* from + (to − from)·i/k, not rounded. */
static double linear(uint8_t from, uint8_t to, int32_t i, int32_t k)
{
    return k == 0 ? from : from + (double)(to - from) * i / k;
}

static glint_run run_of(int32_t start, int32_t k, int from, int to)
{
    return (glint_run){start,
                       start + k,
                       {(uint8_t)from, (uint8_t)to, (uint8_t)((from + 2 * to) / 3)},
                       {(uint8_t)to, (uint8_t)from, (uint8_t)(255 - to)}};
}

/* The sum (2.18) in floating point, which holds it exactly. */
static void values_are_the_rounded_sum(void **state)
{
    (void)state;
    for (int shifts = GLINT_DIVIDER_SHIFTS_MIN; shifts <= GLINT_DIVIDER_SHIFTS_MAX; shifts++) {
        for (int32_t k = 1; k <= GLINT_DIVIDER_K_MAX; k++) {
            const double reciprocal = floor(ldexp(1.0, shifts) / k + 0.5) / ldexp(1.0, shifts);
            for (int from = 0; from <= 255; from += 15) {
                for (int to = 0; to <= 255; to += 17) {
                    const glint_run run = run_of(-5, k, from, to);
                    uint8_t values[GLINT_DIVIDER_K_MAX + 1][3];
                    interpolate(&run, shifts, values[0]);
                    for (int32_t i = 0; i <= k; i++) {
                        for (int c = 0; c < 3; c++) {
                            const double sum =
                                run.from[c] + i * (run.to[c] - run.from[c]) * reciprocal;
                            const double held = fmin(fmax(floor(sum + 0.5), 0.0), 255.0);
                            assert_int_equal(values[i][c], (int)held);
                        }
                    }
                }
            }
        }
    }
}

/* With the default number of shifts the sum is within half a level of the end's intensity, so that
 * the end's own value comes out, over every difference and every length in the table. */
static void the_last_pixel_is_right(void **state)
{
    (void)state;
    for (int32_t k = 1; k <= GLINT_DIVIDER_K_MAX; k++) {
        for (int difference = 0; difference <= 255; difference++) {
            const glint_run run = {
                0, k, {0, 255, 100}, {(uint8_t)difference, (uint8_t)(255 - difference), 100}};
            uint8_t values[GLINT_DIVIDER_K_MAX + 1][3];
            interpolate(&run, GLINT_DIVIDER_SHIFTS_DEFAULT, values[0]);
            assert_memory_equal(values[k], run.to, 3);
            for (int32_t i = 0; i <= k; i++)
                for (int c = 0; c < 3; c++)
                    assert_true(fabs(values[i][c] - linear(run.from[c], run.to[c], i, k)) < 1.0);
        }
    }
}

static void few_shifts_are_off_at_the_last_pixel(void **state)
{
    (void)state;
    const glint_run run = {0, 15, {0, 0, 0}, {255, 255, 255}};
    uint8_t values[16][3];
    interpolate(&run, 8, values[0]); /* 17/256 for 1/15: 15 · 17 · 255/256 = 254.004 */
    assert_int_equal(values[15][0], 254);
    interpolate(&run, 6, values[0]); /* 4/64 for 1/15: 239.06 */
    assert_int_equal(values[15][0], 239);
}

static void a_run_of_any_length_is_right(void **state)
{
    (void)state;
    uint8_t *values = malloc(3 * (LONGEST + 1));
    uint8_t *exact = malloc(3 * (LONGEST + 1));
    assert_non_null(values);
    assert_non_null(exact);
    uint64_t random = seed_of_this_run();
    for (int round = 0; round < 400; round++) {
        random = random * 6364136223846793005u + 1442695040888963407u;
        const int from = (int)(random >> 56);
        const int to = (int)(random >> 48 & 255);
        const int32_t k = round < 300 ? round : (int32_t)(random % LONGEST);
        const glint_run run = run_of((int32_t)(random >> 32 & 0xFFFF) - 32768, k, from, to);
        interpolate(&run, GLINT_DIVIDER_SHIFTS_DEFAULT, values);
        glint_run_exact(&run, run.start, run.end, exact);
        for (int32_t i = 0; i <= k; i++) {
            for (int c = 0; c < 3; c++) {
                const double true_value = linear(run.from[c], run.to[c], i, k);
                const int value = values[3 * i + c];
                assert_int_equal(exact[3 * i + c], (int)floor(true_value + 0.5 + 1e-9));
                assert_true(abs(value - exact[3 * i + c]) <= 1);
                assert_true(i % GLINT_DIVIDER_K_MAX != 0 || value == exact[3 * i + c]);
            }
        }
        assert_memory_equal(values + 3 * k, k > 0 ? run.to : run.from, 3);
    }
    free(exact);
    free(values);
}

static void runs_are_monotone_with_any_shifts(void **state)
{
    (void)state;
    uint8_t values[301][3];
    for (int shifts = GLINT_DIVIDER_SHIFTS_MIN; shifts <= GLINT_DIVIDER_SHIFTS_MAX; shifts++) {
        for (int32_t k = 1; k <= 300; k++) {
            const glint_run run = run_of(0, k, 255 - (int)(k % 50), 3 * (int)(k % 30));
            interpolate(&run, shifts, values[0]);
            for (int32_t i = 1; i <= k; i++) {
                for (int c = 0; c < 3; c++) {
                    const int step = values[i][c] - values[i - 1][c];
                    assert_true((run.to[c] - run.from[c]) * step >= 0);
                }
            }
        }
    }
}

static void a_constant_stays_constant(void **state)
{
    (void)state;
    uint8_t values[101][3];
    for (int shifts = GLINT_DIVIDER_SHIFTS_MIN; shifts <= GLINT_DIVIDER_SHIFTS_MAX; shifts++) {
        for (int value = 0; value <= 255; value++) {
            const uint8_t v = (uint8_t)value;
            const glint_run run = {7, 107, {v, v, v}, {v, v, v}};
            interpolate(&run, shifts, values[0]);
            for (int i = 0; i <= 100; i++)
                assert_memory_equal(values[i], run.from, 3);
        }
    }
}

/* A part of a segment has the values that the whole has there. */
static void a_part_is_like_the_whole(void **state)
{
    (void)state;
    const glint_run run = run_of(40, 13, 250, 7);
    uint8_t whole[14][3];
    interpolate(&run, 8, whole[0]);
    glint_division division;
    glint_quotients quotients;
    assert_true(glint_run_set_up(&run, &division, &ignored));
    assert_int_equal(glint_divide_batch(8, &division, 1, &quotients), GLINT_OK);
    for (int32_t first = 0; first <= 13; first++) {
        for (int32_t last = first; last <= 13; last++) {
            uint8_t part[15][3];
            memset(part, 0xAA, sizeof part);
            glint_run_walk(&run, 8, &quotients, 40 + first, 40 + last, part[0], &ignored);
            assert_memory_equal(part, whole[first], 3 * (size_t)(last - first + 1));
            assert_int_equal(part[last - first + 1][0], 0xAA);
        }
    }
}

static void segments_meet(void **state)
{
    (void)state;
    for (int32_t k = 0; k <= 200; k++) {
        const glint_run run = run_of(-100, k, 11, 240);
        const int32_t count = glint_run_segment_count(&run);
        int32_t place = run.start;
        for (int32_t i = 0; i < count; i++) {
            const glint_run segment = glint_run_segment(&run, i);
            assert_int_equal(segment.start, place);
            assert_true(segment.end - segment.start <= GLINT_DIVIDER_K_MAX);
            assert_true(segment.end > segment.start || k == 0);
            assert_int_equal(glint_run_segment_at(&run, segment.start), i);
            place = segment.end;
        }
        assert_int_equal(place, run.end);
        assert_int_equal(glint_run_segment_at(&run, run.end), count - 1);
    }
}

static void operations_are_counted(void **state)
{
    (void)state;
    glint_operations increments = {0}, points = {0};
    const glint_run run = run_of(0, 9, 200, 100);
    glint_division division;
    assert_true(glint_run_set_up(&run, &division, &increments));
    assert_int_equal(increments.additions, 6);
    assert_int_equal(increments.divisions, 3);
    const glint_run pixel = run_of(5, 0, 200, 100);
    assert_false(glint_run_set_up(&pixel, &division, &increments));
    assert_int_equal(increments.additions, 12);
    assert_int_equal(increments.divisions, 3);
    const glint_quotients quotients = {{0}, false};
    uint8_t values[10][3];
    glint_run_walk(&run, 12, &quotients, 3, 7, values[0], &points);
    assert_int_equal(points.additions, 7 * 3);
    assert_int_equal(points.divisions, 0);
}

static void expect_operations(const glint_span_operations *counted, const uint64_t expected[4][2])
{
    for (int i = 0; i < GLINT_SPAN_STAGE_COUNT; i++) {
        assert_int_equal(counted->stage[i].additions, expected[i][0]);
        assert_int_equal(counted->stage[i].divisions, expected[i][1]);
    }
}

/* Table 2.1 as printed; and what differs when the triangle is drawn by the fill rule. Its 79 pixels
 * are the 75 inside, three on BC and B itself. Of BC only the 12 steps to its last covered row are
 * walked, not 15 (3 · 3 = 9 fewer); the 11 rows begin with a pixel that needs no addition
 * (3 · (79 − 11) = 204); and the first of them is one pixel long, so that nothing is divided. */
static void table_2_1(void **state)
{
    (void)state;
    static const uint64_t thesis[4][2] = {{18, 9}, {99, 0}, {66, 33}, {225, 0}};
    static const uint64_t drawn[4][2] = {{18, 9}, {90, 0}, {66, 30}, {204, 0}};
    for (int shifts = GLINT_DIVIDER_SHIFTS_MIN; shifts <= GLINT_DIVIDER_SHIFTS_MAX; shifts++) {
        glint_table_21 table;
        glint_error err = {""};
        assert_int_equal(glint_count_table_21(shifts, &table, &err), GLINT_OK);
        expect_operations(&table.described, thesis);
        expect_operations(&table.drawn, drawn);
        assert_int_equal(table.drawn_rows, 11);
        assert_int_equal(table.drawn_pixels, 79);
        assert_int_equal(table.described_edge_points, 33);
        assert_int_equal(table.described_rows, 11);
        assert_int_equal(table.described_pixels, 75);
    }
    glint_table_21 table;
    glint_error err = {""};
    assert_int_equal(glint_count_table_21(5, &table, &err), GLINT_BAD_ARGUMENT);
    assert_string_not_equal(err.text, "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_are_the_rounded_sum),
        cmocka_unit_test(the_last_pixel_is_right),
        cmocka_unit_test(few_shifts_are_off_at_the_last_pixel),
        cmocka_unit_test(a_run_of_any_length_is_right),
        cmocka_unit_test(runs_are_monotone_with_any_shifts),
        cmocka_unit_test(a_constant_stays_constant),
        cmocka_unit_test(a_part_is_like_the_whole),
        cmocka_unit_test(segments_meet),
        cmocka_unit_test(operations_are_counted),
        cmocka_unit_test(table_2_1),
    };
    return cmocka_run_group_tests_name("span", tests, NULL, NULL);
}
