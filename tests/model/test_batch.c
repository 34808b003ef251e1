/* glint_specular_batch() against glint_specular_eval(): every length that a vectorised loop treats
 * differently, arrays at any alignment, nothing written outside them, with and without W. The whole
 * domain is in test_accuracy.c. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../seed.h"
#include "circuit/random.h"
#include "glint_specular.h"

enum {
    LONGEST = 70, /* 64 a step is the widest loop; and a tail */
    MARGIN = 8,   /* elements before and after that have to stay as they are */
    ROOM = LONGEST + 2 * MARGIN,
    FILLER = 0xa5
};

typedef struct arrays {
    uint32_t cosine[ROOM], w[ROOM];
    uint8_t r[ROOM], g[ROOM], b[ROOM];
} arrays;

/* Where each array starts, 0…MARGIN, in its elements. */
typedef struct offsets {
    uint32_t cosine, w, r, g, b;
} offsets;

static glint_random draw;

static int seed_draw(void **state)
{
    (void)state;
    draw.state = seed_of_this_run();
    return 0;
}

/* Codes of all kinds: anywhere, out of range, around the limit, the corners. */
static uint32_t draw_cosine(uint32_t n)
{
    static const uint32_t corners[] = {
        0, 1, GLINT_COS_ONE - 1, GLINT_COS_ONE, GLINT_COS_ONE + 1, GLINT_COS_CODE_MAX};
    const uint32_t limit = glint_rom9(GLINT_GATE_COSINE, n);
    switch (glint_random_below(&draw, 4)) {
    case 0:
        return glint_random_below(&draw, GLINT_COS_CODE_MAX + 1);
    case 1:
        return (limit + glint_random_below(&draw, 9) - 4u) & GLINT_COS_CODE_MAX;
    case 2:
        return limit + glint_random_below(&draw, GLINT_COS_ONE - limit + 1);
    default:
        return corners[glint_random_below(&draw, 6)];
    }
}

static glint_material draw_material(void)
{
    const uint32_t color = (uint32_t)glint_random_bits(&draw);
    return (glint_material){(uint16_t)glint_random_below(&draw, GLINT_N_COUNT), (uint8_t)color,
                            (uint8_t)(color >> 8), (uint8_t)(color >> 16)};
}

static offsets draw_offsets(void)
{
    return (offsets){glint_random_below(&draw, MARGIN + 1), glint_random_below(&draw, MARGIN + 1),
                     glint_random_below(&draw, MARGIN + 1), glint_random_below(&draw, MARGIN + 1),
                     glint_random_below(&draw, MARGIN + 1)};
}

/* What the arrays have to hold afterwards. */
static void expect(glint_gate gate, const glint_material *material, const offsets *at, size_t count,
                   bool with_w, arrays *a)
{
    for (size_t i = 0; i < count; i++) {
        glint_specular_values v;
        assert_int_equal(glint_specular_eval(gate, material, a->cosine[at->cosine + i], &v),
                         GLINT_OK);
        if (with_w)
            a->w[at->w + i] = v.keys12;
        a->r[at->r + i] = v.mul13;
        a->g[at->g + i] = v.mul14;
        a->b[at->b + i] = v.mul15;
    }
}

static void check_batch(glint_gate gate, size_t count, bool with_w)
{
    static arrays found;
    static arrays expected;
    const glint_material material = draw_material();
    const offsets at = draw_offsets();
    memset(&found, FILLER, sizeof found);
    for (size_t i = 0; i < count; i++)
        found.cosine[at.cosine + i] = draw_cosine(material.n);
    expected = found;
    expect(gate, &material, &at, count, with_w, &expected);
    assert_int_equal(glint_specular_batch(gate, &material, found.cosine + at.cosine, count,
                                          with_w ? found.w + at.w : NULL, found.r + at.r,
                                          found.g + at.g, found.b + at.b),
                     GLINT_OK);
    if (memcmp(&found, &expected, sizeof found) != 0) {
        fail_msg("gate %d, count %zu, n %u, colour %u %u %u, starts %u %u %u %u %u", (int)gate,
                 count, material.n, material.r, material.g, material.b, at.cosine, at.w, at.r, at.g,
                 at.b);
    }
}

static void every_length_at_any_alignment(void **state)
{
    (void)state;
    unsigned runs = 0;
    for (int gate = 0; gate < GLINT_GATE_COUNT; gate++) {
        for (size_t count = 0; count <= LONGEST; count++) {
            for (int again = 0; again < 60; again++) {
                check_batch((glint_gate)gate, count, again % 2 == 0);
                runs++;
            }
        }
    }
    assert_int_equal(runs, 3 * (LONGEST + 1) * 60);
}

/* Exactly as large as said: valgrind and AddressSanitizer see a step beyond. */
static void nothing_beyond_the_end_is_touched(void **state)
{
    (void)state;
    const glint_material material = {60, 255, 190, 110};
    for (size_t count = 1; count <= LONGEST; count++) {
        uint32_t *cosine = calloc(count, sizeof *cosine);
        uint32_t *w = malloc(count * sizeof *w);
        uint8_t *rgb[3] = {malloc(count), malloc(count), malloc(count)};
        assert_true(cosine != NULL && w != NULL && rgb[0] != NULL && rgb[1] != NULL &&
                    rgb[2] != NULL);
        cosine[count - 1] = GLINT_COS_ONE;
        assert_int_equal(glint_specular_batch(GLINT_GATE_COSINE, &material, cosine, count, w,
                                              rgb[0], rgb[1], rgb[2]),
                         GLINT_OK);
        assert_int_equal(w[count - 1], GLINT_W_ONE);
        assert_int_equal(rgb[0][count - 1], 255);
        assert_int_equal(rgb[1][count - 1], 190);
        assert_int_equal(rgb[2][count - 1], 110);
        free(cosine);
        free(w);
        free(rgb[0]);
        free(rgb[1]);
        free(rgb[2]);
    }
}

static void bad_arguments_are_refused(void **state)
{
    (void)state;
    const glint_material good = {1023, 255, 255, 255};
    const glint_material bad = {1024, 255, 255, 255};
    const uint32_t cosine = GLINT_COS_ONE;
    uint32_t w = FILLER;
    uint8_t r = FILLER;
    uint8_t g = FILLER;
    uint8_t b = FILLER;
    assert_int_equal(glint_specular_batch(GLINT_GATE_COUNT, &good, &cosine, 1, &w, &r, &g, &b),
                     GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_specular_batch((glint_gate)-1, &good, &cosine, 1, &w, &r, &g, &b),
                     GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_specular_batch(GLINT_GATE_COSINE, &bad, &cosine, 1, &w, &r, &g, &b),
                     GLINT_BAD_ARGUMENT);
    assert_true(w == FILLER && r == FILLER && g == FILLER && b == FILLER);
    assert_int_equal(glint_specular_batch(GLINT_GATE_COSINE, &good, &cosine, 1, &w, &r, &g, &b),
                     GLINT_OK);
    assert_true(w == GLINT_W_ONE && r == 255 && g == 255 && b == 255);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_length_at_any_alignment),
        cmocka_unit_test(nothing_beyond_the_end_is_touched),
        cmocka_unit_test(bad_arguments_are_refused),
    };
    return cmocka_run_group_tests(tests, seed_draw, NULL);
}
