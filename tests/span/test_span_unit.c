/* The span unit of quadratic interpolation as a function: against exact rationals, its stated error
 * bound, its wrapping sums; and clock by clock against the function. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <gmp.h>

#include "../seed.h"
#include "circuit/random.h"
#include "glint_quadratic_span.h"

enum {
    F_MIN = GLINT_QUADRATIC_SPAN_FRACTION_MIN,
    F_MAX = GLINT_QUADRATIC_SPAN_FRACTION_MAX,
    COMPONENTS = GLINT_QUADRATIC_SPAN_COMPONENTS,
    LONGEST = 11585, /* of 26 bits */
};

static uint64_t seed;
static uint8_t rgb[COMPONENTS * (LONGEST + 1)];

static int draw_seed(void **state)
{
    (void)state;
    seed = seed_of_this_run();
    return 0;
}

/* ---- A row's polynomial in rationals ---- */

/* start + i·first + i·(i−1)/2·second. */
typedef struct exact {
    mpq_t start, first, second;
} exact;

static void init(exact *e)
{
    mpq_inits(e->start, e->first, e->second, NULL);
}

static void clear(exact *e)
{
    mpq_clears(e->start, e->first, e->second, NULL);
}

/* Through three values at the first, the middle and the last of `length` pixels, so that it stays
 * between −85 and 340 as on a triangle: Newton's form, from values in thousandths. */
static void set(exact *e, int length, const int at[3])
{
    const long n = length > 2 ? length - 1 : 2;
    mpq_t a, b;
    mpq_inits(a, b, NULL);
    mpq_set_si(e->start, at[0], 1000);
    mpq_canonicalize(e->start);
    /* I(t) = at0 + t·(−3at0 + 4at1 − at2) + t²·(2at0 − 4at1 + 2at2), t = i/n */
    mpq_set_si(a, -3L * at[0] + 4L * at[1] - at[2], 1000UL * (unsigned long)n);
    mpq_canonicalize(a);
    mpq_set_si(b, 2L * at[0] - 4L * at[1] + 2L * at[2], 1000UL * (unsigned long)(n * n));
    mpq_canonicalize(b);
    mpq_add(e->first, a, b);
    mpq_add(e->second, b, b);
    mpq_clears(a, b, NULL);
}

static void value_at(const exact *e, long i, mpq_t value)
{
    mpq_t term, factor;
    mpq_inits(term, factor, NULL);
    mpq_set(value, e->start);
    mpq_set_si(factor, i, 1);
    mpq_mul(term, e->first, factor);
    mpq_add(value, value, term);
    mpq_set_si(factor, i * (i - 1) / 2, 1);
    mpq_mul(term, e->second, factor);
    mpq_add(value, value, term);
    mpq_clears(term, factor, NULL);
}

/* To nearest, as the renderer has to. */
static int64_t code_of(const mpq_t number, int fraction)
{
    mpq_t scaled, half;
    mpz_t floor;
    mpq_inits(scaled, half, NULL);
    mpz_init(floor);
    mpq_set_ui(half, 1, 2);
    mpq_mul_2exp(scaled, number, (mp_bitcnt_t)fraction);
    mpq_add(scaled, scaled, half);
    mpz_fdiv_q(floor, mpq_numref(scaled), mpq_denref(scaled));
    const int64_t code = mpz_get_si(floor);
    mpz_clear(floor);
    mpq_clears(scaled, half, NULL);
    return code;
}

/* |code/2^fraction − number| in levels. */
static double distance(int64_t code, int fraction, const mpq_t number)
{
    mpq_t of_code;
    mpq_init(of_code);
    mpq_set_si(of_code, code, 1);
    mpq_div_2exp(of_code, of_code, (mp_bitcnt_t)fraction);
    mpq_sub(of_code, of_code, number);
    const double found = fabs(mpq_get_d(of_code));
    mpq_clear(of_code);
    return found;
}

/* 2^−(F+1)·(1 + i + i·(i−1)/2), exactly. */
static double bound(int fraction, long i)
{
    return ldexp((double)(1 + i + i * (i - 1) / 2), -(fraction + 1));
}

static int64_t value_after(const glint_quadratic_walk *walk, int fraction, long i)
{
    return glint_quadratic_span_after(fraction, walk, (size_t)i).start[0];
}

static void check_span(const exact *e, int fraction, int length, double *worst)
{
    const glint_quadratic_walk walk = {.start = {code_of(e->start, fraction)},
                                       .first = {code_of(e->first, fraction)},
                                       .second = {code_of(e->second, fraction)}};
    mpq_t value;
    mpq_init(value);
    assert_int_equal(glint_quadratic_span(fraction, &walk, (size_t)length, rgb), GLINT_OK);
    for (long i = 0; i < length; i += 1 + length / 50) {
        value_at(e, i, value);
        const double off = distance(value_after(&walk, fraction, i), fraction, value);
        assert_true(off <= bound(fraction, i));
        *worst = off > *worst ? off : *worst;
        const double level = fmin(fmax(mpq_get_d(value), 0.0), 255.0);
        assert_true(fabs(rgb[COMPONENTS * i] - level) <= 0.5 + off + 1e-12);
    }
    mpq_clear(value);
}

/* All formats; spans of one pixel, of the longest allowed and in between. */
static void values_are_within_the_bound_of_the_rationals(void **state)
{
    (void)state;
    glint_random random = {seed};
    exact e;
    int spans = 0;
    init(&e);
    for (int fraction = F_MIN; fraction <= F_MAX; fraction++) {
        const int longest = glint_quadratic_span_longest(fraction);
        double worst = 0.0;
        for (int n = 0; n < 24; n++, spans++) {
            const int length = n < 4   ? n + 1
                               : n < 8 ? longest
                                       : 1 + (int)glint_random_below(&random, (uint32_t)longest);
            int at[3];
            for (int k = 0; k < 3; k++)
                at[k] = (int)glint_random_below(&random, 255001);
            set(&e, length, at);
            check_span(&e, fraction, length, &worst);
        }
        assert_true(worst <= 0.5);
    }
    clear(&e);
    print_message("%d spans of %d formats within their bound\n", spans, F_MAX - F_MIN + 1);
}

/* The bound is reached: all three numbers half a code off, the same way. So no format allows a
 * longer span than glint_quadratic_span_longest() says. */
static void the_bound_is_sharp(void **state)
{
    (void)state;
    exact e;
    mpq_t value;
    init(&e);
    mpq_init(value);
    for (int fraction = F_MIN; fraction <= F_MAX; fraction++) {
        const int longest = glint_quadratic_span_longest(fraction);
        const unsigned long two = 2UL << fraction;
        assert_true(bound(fraction, longest - 1) <= 0.5);
        assert_true(bound(fraction, longest) > 0.5);
        mpq_set_si(e.start, (40L << fraction) * 2 - 1, two); /* 40 less half a code */
        mpq_set_si(e.first, -1, two);
        mpq_set_si(e.second, -1, two);
        const glint_quadratic_walk walk = {.start = {code_of(e.start, fraction)},
                                           .first = {code_of(e.first, fraction)},
                                           .second = {code_of(e.second, fraction)}};
        assert_true(walk.start[0] == 40L << fraction && walk.first[0] == 0 && walk.second[0] == 0);
        value_at(&e, longest - 1, value);
        assert_true(distance(walk.start[0], fraction, value) == bound(fraction, longest - 1));
    }
    mpq_clear(value);
    clear(&e);
    assert_int_equal(glint_quadratic_span_longest(F_MIN), 23);
    assert_int_equal(glint_quadratic_span_longest(GLINT_QUADRATIC_SPAN_FRACTION_DEFAULT), 724);
    assert_int_equal(glint_quadratic_span_longest(F_MAX), LONGEST);
}

/* ---- Limits ---- */

/* Without a second difference: the exact line, for every slope of whole codes. */
static void a_line_is_exact(void **state)
{
    (void)state;
    const int fraction = GLINT_QUADRATIC_SPAN_FRACTION_DEFAULT;
    for (int from = 0; from < 256; from += 5)
        for (int to = 0; to < 256; to += 3) {
            const int64_t first = ((int64_t)(to - from) << fraction) / 64;
            const glint_quadratic_walk walk = {.start = {(int64_t)from << fraction},
                                               .first = {first}};
            assert_int_equal(glint_quadratic_span(fraction, &walk, 65, rgb), GLINT_OK);
            for (int i = 0; i <= 64; i++)
                assert_int_equal(rgb[COMPONENTS * i], (2 * (from * (64 - i) + to * i) + 64) / 128);
        }
}

static void a_constant_stays(void **state)
{
    (void)state;
    for (int level = 0; level < 256; level++) {
        const glint_quadratic_walk walk = {
            .start = {(int64_t)level << F_MIN, -(int64_t)level << F_MIN, INT64_C(300) << F_MIN}};
        assert_int_equal(glint_quadratic_span(F_MIN, &walk, 20, rgb), GLINT_OK);
        for (int i = 0; i < 20; i++) {
            assert_int_equal(rgb[COMPONENTS * i], level);
            assert_int_equal(rgb[COMPONENTS * i + 1], 0);
            assert_int_equal(rgb[COMPONENTS * i + 2], 255);
        }
    }
}

/* A value that fits is right, even where a slope or a value before it did not: 1000 is not in S10,
 * nor is −1100. */
static void sums_wrap_harmlessly(void **state)
{
    (void)state;
    for (int fraction = F_MIN; fraction <= F_MAX; fraction++) {
        const glint_quadratic_walk walk = {
            .start = {INT64_C(200) << fraction},
            .first = {INT64_C(1000) << fraction},
            .second = {-(INT64_C(1100) << fraction)},
        };
        /* 200, 1200, 1100, −100 */
        assert_int_equal(glint_quadratic_span(fraction, &walk, 4, rgb), GLINT_OK);
        assert_int_equal(rgb[0], 200);
        assert_int_equal(rgb[9], 0);
        assert_int_equal(value_after(&walk, fraction, 3), -(INT64_C(100) << fraction));
    }
}

static void bits_above_the_format_do_not_count(void **state)
{
    (void)state;
    const glint_quadratic_walk walk = {.start = {100 << F_MIN}, .first = {640}, .second = {-64}};
    glint_quadratic_walk dirty = walk;
    uint8_t clean[12];
    assert_int_equal(glint_quadratic_span(F_MIN, &walk, 4, clean), GLINT_OK);
    dirty.start[0] ^= INT64_C(5) << (10 + F_MIN);
    dirty.first[0] ^= INT64_C(3) << (10 + F_MIN);
    dirty.second[0] ^= INT64_C(9) << (10 + F_MIN);
    assert_int_equal(glint_quadratic_span(F_MIN, &dirty, 4, rgb), GLINT_OK);
    assert_memory_equal(rgb, clean, sizeof clean);
    static const uint8_t expected[] = {100, 103, 105, 107}; /* the example in the Verilog */
    for (size_t i = 0; i < 4; i++)
        assert_int_equal(clean[COMPONENTS * i], expected[i]);
}

static void other_formats_are_refused(void **state)
{
    (void)state;
    const glint_quadratic_walk walk = {{0}, {0}, {0}};
    assert_int_equal(glint_quadratic_span(F_MIN - 1, &walk, 1, rgb), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_quadratic_span(F_MAX + 1, &walk, 1, rgb), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_quadratic_span(F_MIN, &walk, 0, NULL), GLINT_OK);
}

/* ---- Clock by clock ---- */

static int64_t any(glint_random *random)
{
    return (int64_t)glint_random_bits(random) >> glint_random_below(random, 50);
}

static void draw_walk(glint_random *random, glint_quadratic_walk *walk)
{
    for (int c = 0; c < COMPONENTS; c++) {
        walk->start[c] = any(random);
        walk->first[c] = any(random);
        walk->second[c] = any(random);
    }
}

/* Clocks without a pixel, and with the clock enable at 0; returns whether a pixel came out. */
static bool idle(glint_random *random, int fraction, glint_quadratic_span_signals *s)
{
    glint_quadratic_span_pins pins = {.en = 1};
    draw_walk(random, &pins.walk);
    glint_quadratic_span_clock(fraction, s, &pins);
    const bool out = s->out_valid != 0;
    const glint_quadratic_span_signals before = *s;
    pins = (glint_quadratic_span_pins){.load = 1, .step = 1};
    glint_quadratic_span_clock(fraction, s, &pins); /* frozen */
    assert_memory_equal(&before, s, sizeof before);
    return out;
}

static void expect_pixel(const glint_quadratic_span_signals *s, const uint8_t *expected)
{
    for (int c = 0; c < COMPONENTS; c++)
        assert_int_equal(s->component[c].out, expected[c]);
}

static void clocks_give_what_the_function_gives(void **state)
{
    (void)state;
    glint_random random = {seed};
    for (int fraction = F_MIN; fraction <= F_MAX; fraction++) {
        glint_quadratic_span_signals s = {0};
        for (int n = 0; n < 40; n++) {
            const size_t length = 1 + glint_random_below(&random, 60);
            glint_quadratic_span_pins pins = {.en = 1};
            draw_walk(&random, &pins.walk);
            const glint_quadratic_walk walk = pins.walk;
            assert_int_equal(glint_quadratic_span(fraction, &walk, length, rgb), GLINT_OK);
            size_t out = 0;
            for (size_t i = 0; i < length; i++) {
                pins.load = i == 0;
                pins.step = i != 0 || glint_random_chance(&random, 128);
                glint_quadratic_span_clock(fraction, &s, &pins);
                if (i != 0 && s.out_valid)
                    expect_pixel(&s, &rgb[COMPONENTS * out++]);
                draw_walk(&random, &pins.walk); /* which no step looks at */
                if (glint_random_chance(&random, 60) && idle(&random, fraction, &s))
                    expect_pixel(&s, &rgb[COMPONENTS * out++]);
            }
            if (idle(&random, fraction, &s))
                expect_pixel(&s, &rgb[COMPONENTS * out++]);
            assert_int_equal(out, length);
            assert_false(idle(&random, fraction, &s));
        }
        const glint_quadratic_span_pins reset = {.reset = 1};
        const glint_quadratic_span_signals zero = {0};
        glint_quadratic_span_clock(fraction, &s, &reset);
        assert_memory_equal(&s, &zero, sizeof zero);
    }
}

static void a_walk_goes_on_from_its_registers(void **state)
{
    (void)state;
    glint_random random = {seed};
    for (int n = 0; n < 500; n++) {
        const int fraction = F_MIN + (int)glint_random_below(&random, F_MAX - F_MIN + 1);
        const size_t steps = glint_random_below(&random, 100);
        glint_quadratic_walk walk;
        uint8_t rest[COMPONENTS * 30];
        draw_walk(&random, &walk);
        const glint_quadratic_walk after = glint_quadratic_span_after(fraction, &walk, steps);
        assert_int_equal(glint_quadratic_span(fraction, &walk, steps + 30, rgb), GLINT_OK);
        assert_int_equal(glint_quadratic_span(fraction, &after, 30, rest), GLINT_OK);
        assert_memory_equal(rest, rgb + COMPONENTS * steps, sizeof rest);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_are_within_the_bound_of_the_rationals),
        cmocka_unit_test(the_bound_is_sharp),
        cmocka_unit_test(a_line_is_exact),
        cmocka_unit_test(a_constant_stays),
        cmocka_unit_test(sums_wrap_harmlessly),
        cmocka_unit_test(bits_above_the_format_do_not_count),
        cmocka_unit_test(other_formats_are_refused),
        cmocka_unit_test(clocks_give_what_the_function_gives),
        cmocka_unit_test(a_walk_goes_on_from_its_registers),
    };
    return cmocka_run_group_tests(tests, draw_seed, NULL);
}
