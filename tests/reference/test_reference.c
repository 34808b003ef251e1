/* The C model against an independent reference in exact rationals (reference.h), bit for bit: W of
 * every n with every cosine code that 19 bits hold, each gate; every W code with every colour; both
 * ROMs; every division. GLINT_REFERENCE_STEP: every so manieth n, from a random one on; 1 is the
 * whole domain (make reference), 8 what make test does. */
#define _XOPEN_SOURCE 700

#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "../golden.h"
#include "../seed.h"
#include "blocks.h"
#include "circuit/random.h"
#include "glint_divider.h"
#include "glint_specular.h"
#include "reference.h"

#define THREADS_MAX 64
#define COLORS      256

/* What was compared, and how much of it differs. */
typedef struct tally {
    uint64_t points, roms, w_differ, colors_differ, roms_differ;
} tally;

static struct {
    uint8_t products[COLORS][REFERENCE_W_CODES];
    uint32_t codes[REFERENCE_CODES];
    uint32_t step, first_n;
    _Atomic uint32_t next_n;
} all;

/* One thread's share. */
typedef struct worker {
    pthread_t thread;
    tally tally;
    uint32_t expected[REFERENCE_CODES], drawn[REFERENCE_CODES], w[REFERENCE_CODES];
    uint8_t rgb[3][REFERENCE_CODES];
} worker;

static tally sum;
static glint_random draw;

/* ---- The specular device -----------------------------------------------------------------------
 */

static void compare_colors(worker *worker, const uint32_t *expected, const glint_material *m)
{
    const uint8_t colors[] = {m->r, m->g, m->b};
    for (int i = 0; i < 3; i++) {
        const uint8_t *products = all.products[colors[i]];
        uint32_t differ = 0;
        for (uint32_t code = 0; code < REFERENCE_CODES; code++)
            differ += worker->rgb[i][code] != products[expected[code]];
        worker->tally.colors_differ += differ;
    }
}

static void compare_gate(worker *worker, glint_gate gate, uint32_t n, const uint32_t *expected)
{
    const glint_material material = {(uint16_t)n, 255, (uint8_t)n, (uint8_t)(n * 7 / 4 + 85)};
    uint32_t differ = 0;
    memset(worker->w, 0x5a, sizeof worker->w);
    if (glint_specular_batch(gate, &material, all.codes, REFERENCE_CODES, worker->w, worker->rgb[0],
                             worker->rgb[1], worker->rgb[2]) != GLINT_OK)
        abort();
    for (uint32_t code = 0; code < REFERENCE_CODES; code++)
        differ += worker->w[code] != expected[code];
    worker->tally.w_differ += differ;
    worker->tally.points += REFERENCE_CODES;
    compare_colors(worker, expected, &material);
}

static void compare_n(worker *worker, uint32_t n)
{
    uint32_t limit;
    reference_w(n, worker->expected, worker->drawn, &limit);
    compare_gate(worker, GLINT_GATE_COSINE, n, worker->expected);
    compare_gate(worker, GLINT_GATE_SIGN, n, worker->expected);
    compare_gate(worker, GLINT_GATE_DRAWN, n, worker->drawn);
    worker->tally.roms += 2;
    worker->tally.roms_differ += glint_rom9(GLINT_GATE_COSINE, n) != limit;
    worker->tally.roms_differ += (long)glint_rom33(n) != reference_nearest_of((long)n + 1, 3, 13);
}

static void *compare_some(void *context)
{
    worker *worker = context;
    uint32_t n;
    while ((n = atomic_fetch_add(&all.next_n, all.step)) < GLINT_N_COUNT)
        compare_n(worker, n);
    return NULL;
}

static void add_tally(const tally *part)
{
    sum.points += part->points;
    sum.roms += part->roms;
    sum.w_differ += part->w_differ;
    sum.colors_differ += part->colors_differ;
    sum.roms_differ += part->roms_differ;
}

static int start_workers(worker **workers, int count)
{
    for (int i = 0; i < count; i++) {
        workers[i] = calloc(1, sizeof *workers[i]);
        if (workers[i] == NULL ||
            pthread_create(&workers[i]->thread, NULL, compare_some, workers[i]) != 0)
            return -1;
    }
    return 0;
}

/* Group setup: the sweep over n, once; the tests look at what it counted. */
static int run_sweep(void **state)
{
    (void)state;
    static worker *workers[THREADS_MAX];
    const char *step = getenv("GLINT_REFERENCE_STEP");
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    const int count = (int)(cores < 1 ? 1 : cores > THREADS_MAX ? THREADS_MAX : cores);
    draw.state = seed_of_this_run();
    all.step = step != NULL ? (uint32_t)strtoul(step, NULL, 10) : 8;
    if (all.step < 1 || all.step > GLINT_N_COUNT)
        return -1;
    all.first_n = glint_random_below(&draw, all.step);
    all.next_n = all.first_n;
    for (uint32_t code = 0; code < REFERENCE_CODES; code++)
        all.codes[code] = code;
    for (unsigned long color = 0; color < COLORS; color++)
        reference_colors(color, all.products[color]);
    if (start_workers(workers, count) != 0)
        return -1;
    for (int i = 0; i < count; i++) {
        pthread_join(workers[i]->thread, NULL);
        add_tally(&workers[i]->tally);
        free(workers[i]);
    }
    return 0;
}

static void w_is_the_reference_in_every_bit(void **state)
{
    (void)state;
    const uint64_t ns = (GLINT_N_COUNT - all.first_n + all.step - 1) / all.step;
    print_message("W: %" PRIu64 " differ of %" PRIu64 " points: 3 gates, %" PRIu64
                  " n, %d cosine codes\n",
                  sum.w_differ, sum.points, ns, REFERENCE_CODES);
    assert_true(ns > 0 && sum.points == 3 * ns * REFERENCE_CODES);
    assert_true(sum.w_differ == 0);
}

static void colors_are_the_reference_in_every_bit(void **state)
{
    (void)state;
    print_message("colours: %" PRIu64 " differ of %" PRIu64 "\n", sum.colors_differ,
                  3 * sum.points);
    assert_true(sum.points > 0 && sum.colors_differ == 0);
}

static void roms_are_the_reference(void **state)
{
    (void)state;
    print_message("ROMs: %" PRIu64 " differ of %" PRIu64 " words\n", sum.roms_differ, sum.roms);
    assert_true(sum.roms > 0 && sum.roms_differ == 0);
}

static void multiplier13_is_the_reference(void **state)
{
    (void)state;
    uint64_t points = 0;
    uint64_t differ = 0;
    for (uint32_t color = 0; color < COLORS; color++) {
        for (uint32_t w = 0; w < REFERENCE_W_CODES; w++)
            differ += glint_block_mul_color(w, (uint8_t)color) != all.products[color][w];
        points += REFERENCE_W_CODES;
    }
    print_message("multiplier 13: %" PRIu64 " differ of %" PRIu64 " points\n", differ, points);
    assert_true(differ == 0);
    assert_true(points == UINT64_C(67109120)); /* (2^18 + 1) · 2^8 */
}

/* The tables of reference_colors() by the definition itself, at drawn points. */
static void products_are_by_definition(void **state)
{
    (void)state;
    for (int i = 0; i < 200000; i++) {
        const uint32_t w = glint_random_below(&draw, REFERENCE_W_CODES);
        const uint32_t color = glint_random_below(&draw, COLORS);
        assert_int_equal(all.products[color][w],
                         reference_nearest_of((long)w * (long)color, REFERENCE_ONE, 0));
    }
}

/* ---- Whether the comparison looks at everything
 * -------------------------------------------------- This program is linked with ld's --wrap:
 * glint_specular_batch() comes through here, where one value of one point may be altered. */

enum { PLANTED_W, PLANTED_R, PLANTED_G, PLANTED_B, PLANTED_VALUES };

static struct {
    bool is;
    uint32_t code;
    int value;
} planted;

glint_status __real_glint_specular_batch(glint_gate gate, const glint_material *material,
                                         const uint32_t *cos_code, size_t count, uint32_t *w_code,
                                         uint8_t *r, uint8_t *g, uint8_t *b);
glint_status __wrap_glint_specular_batch(glint_gate gate, const glint_material *material,
                                         const uint32_t *cos_code, size_t count, uint32_t *w_code,
                                         uint8_t *r, uint8_t *g, uint8_t *b);

glint_status __wrap_glint_specular_batch(glint_gate gate, const glint_material *material,
                                         const uint32_t *cos_code, size_t count, uint32_t *w_code,
                                         uint8_t *r, uint8_t *g, uint8_t *b)
{
    uint8_t *const colors[] = {r, g, b};
    const glint_status status =
        __real_glint_specular_batch(gate, material, cos_code, count, w_code, r, g, b);
    if (planted.is && planted.value == PLANTED_W)
        w_code[planted.code] ^= 1;
    else if (planted.is)
        colors[planted.value - PLANTED_R][planted.code] ^= 1;
    return status;
}

static void each_value_of_each_gate_is_looked_at(void **state)
{
    (void)state;
    static worker one;
    static const uint32_t codes[] = {0, 1, REFERENCE_ONE / 2, REFERENCE_ONE, REFERENCE_CODES - 1};
    const uint32_t n = 100;
    uint32_t limit;
    reference_w(n, one.expected, one.drawn, &limit);
    for (int gate = 0; gate < GLINT_GATE_COUNT; gate++) {
        for (size_t c = 0; c < sizeof codes / sizeof codes[0]; c++) {
            for (int value = 0; value < PLANTED_VALUES; value++) {
                planted.is = true;
                planted.code = codes[c];
                planted.value = value;
                one.tally = (tally){0};
                compare_gate(&one, (glint_gate)gate, n,
                             gate == GLINT_GATE_DRAWN ? one.drawn : one.expected);
                planted.is = false;
                assert_int_equal(one.tally.points, REFERENCE_CODES);
                assert_int_equal(one.tally.w_differ, value == PLANTED_W);
                assert_int_equal(one.tally.colors_differ, value != PLANTED_W);
            }
        }
    }
}

/* ---- Blocks between input and output -----------------------------------------------------------
 */

static void blocks_are_exact_or_nearest(void **state)
{
    (void)state;
    for (int i = 0; i < 200000; i++) {
        const glint_material white = {(uint16_t)glint_random_below(&draw, GLINT_N_COUNT), 255, 255,
                                      255};
        const uint32_t code = glint_random_below(&draw, REFERENCE_CODES);
        const long c = code > REFERENCE_ONE ? REFERENCE_ONE : (long)code;
        glint_specular_values v;
        assert_int_equal(glint_specular_eval(GLINT_GATE_DRAWN, &white, code, &v), GLINT_OK);
        assert_int_equal(v.reg1, c);
        assert_int_equal(v.adder6, c - REFERENCE_ONE);
        const long product = (long)v.rom33 * (c - REFERENCE_ONE); /* of 13 + 18 fraction bits */
        assert_int_equal(v.mul7, reference_nearest_of(product, 1ul << 31, 18));
        assert_int_equal(v.adder8, v.mul7 + REFERENCE_ONE);
        const long t2 = (long)v.adder8 * v.adder8; /* of 36 */
        assert_int_equal(v.mul10, reference_nearest_of(t2, 1ul << 36, 18));
    }
}

/* A double is a rational too: what a host's cosine becomes. */
static void a_hosts_cosine_becomes_the_nearest_code(void **state)
{
    (void)state;
    mpq_t x;
    mpq_init(x);
    for (int i = 0; i < 300000; i++) {
        double cosine = (double)glint_random_below(&draw, 2 * REFERENCE_ONE + 1) /
                        (2.0 * REFERENCE_ONE); /* a code, or exactly between two */
        const uint32_t kind = glint_random_below(&draw, 3);
        cosine = kind == 0   ? cosine
                 : kind == 1 ? cosine * (1.0 - 0x1p-53)
                             : (double)(glint_random_bits(&draw) >> 11) * 0x1p-53;
        mpq_set_d(x, cosine);
        assert_int_equal(glint_cos_code(cosine), reference_nearest(x, REFERENCE_COS_BITS));
    }
    mpq_clear(x);
}

/* ---- The divider -------------------------------------------------------------------------------
 */

static void divisions_are_the_sum_of_the_terms(void **state)
{
    (void)state;
    uint64_t points = 0;
    uint64_t differ = 0;
    for (unsigned shifts = 6; shifts <= 16; shifts++) {
        for (unsigned k = 0; k < 256; k++) {
            const long bits = reference_reciprocal(shifts, k);
            assert_int_equal(glint_divider_bits((int)shifts, k), bits);
            for (int difference = -255; difference <= 255; difference++) {
                const glint_division division = {{(int16_t)difference, (int16_t)-difference, 1},
                                                 (uint8_t)k};
                glint_quotients batch;
                int32_t quotient;
                bool miss;
                long expected;
                assert_true(reference_quotient(shifts, difference, bits, &expected));
                assert_int_equal(glint_divide((int)shifts, difference, k, &quotient, &miss),
                                 GLINT_OK);
                assert_int_equal(glint_divide_batch((int)shifts, &division, 1, &batch), GLINT_OK);
                assert_true(miss == (k < 1 || k > 16) && batch.out_of_table == miss);
                differ += quotient != expected || batch.code[0] != expected ||
                          batch.code[1] != -expected || batch.code[2] != bits;
                points++;
            }
        }
    }
    print_message("divider: %" PRIu64 " differ of %" PRIu64 " divisions\n", differ, points);
    assert_true(differ == 0);
    assert_true(points == UINT64_C(11) * 256 * 511);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(w_is_the_reference_in_every_bit),
        cmocka_unit_test(colors_are_the_reference_in_every_bit),
        cmocka_unit_test(roms_are_the_reference),
        cmocka_unit_test(multiplier13_is_the_reference),
        cmocka_unit_test(each_value_of_each_gate_is_looked_at),
        cmocka_unit_test(products_are_by_definition),
        cmocka_unit_test(blocks_are_exact_or_nearest),
        cmocka_unit_test(a_hosts_cosine_becomes_the_nearest_code),
        cmocka_unit_test(divisions_are_the_sum_of_the_terms),
    };
    return golden_run_group_tests(tests, run_sweep, NULL);
}
