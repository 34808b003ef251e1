/* The numbers the device has to meet, over its whole domain: every cosine code 0…2^18 for every n
 * 0…1023, in exact integer arithmetic.
 *
 * With d = 2^18 − code, formula (2.15) for the quantised cosine is the fraction
 *
 *     t = (3·2^18 − (n+1)·d) / (3·2^18)      W = t² where t ≥ 0, else 0
 *
 * so an error of W is a whole number of 1/(9·2^36): no tolerance hides in floating point. */
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
#include "../record.h"
#include "../seed.h"
#include "blocks.h"
#include "circuit/random.h"
#include "glint_specular.h"
#include "multiversion.h"

#define CODES       (GLINT_COS_ONE + 1u)
#define UNIT        (UINT64_C(9) << 36) /* 1.0 in units of an error of W */
#define COMPONENTS  3
#define THREADS_MAX 64

/* With a sanitizer only every so manieth n, from a random one on: it is there to find bad accesses.
 */
#ifdef GLINT_SANITIZED
#define N_STEP 61
#else
#define N_STEP 1
#endif

/* Full white shows the most of W; the others are no powers of two. */
static const uint8_t colors[COMPONENTS] = {255, 173, 37};

/* The largest error and where it is. */
typedef struct worst {
    uint64_t error;
    uint32_t n, code;
} worst;

/* What was counted: each of these but points and worst… has to stay 0. */
typedef struct tally {
    uint64_t points;
    uint64_t batch_differs; /* a batch's W from the blocks', three gates */
    uint64_t gates_differ;  /* W or a colour of gate cosine from gate sign */
    uint64_t color_differs; /* a batch's colour from multiplier 13's of its W */
    uint64_t rising;        /* W larger at a code than at the next */
    worst worst_w;          /* units of 1/(9·2^36) */
    worst worst_color[COMPONENTS];
} tally;

typedef struct results {
    uint32_t w[CODES];
    uint8_t rgb[COMPONENTS][CODES];
} results;

/* One thread's share of the sweep. */
typedef struct worker {
    pthread_t thread;
    bool started;
    tally tally;
    results *cosine, *sign;
    uint32_t *blocks;
} worker;

static struct {
    uint32_t codes[CODES];
    uint32_t first_n;
    _Atomic uint32_t next_n;
    worker workers[THREADS_MAX];
    int worker_count;
    tally total;
    double seconds;
} sweep;

/* ---- The loops ------------------------------------------------------------------------------- */

/* The same W out of the figure's blocks, one after the other. */
GLINT_MULTIVERSION
static void compute_by_blocks(glint_gate gate, uint32_t n, uint32_t *w)
{
    const uint32_t rom33 = glint_rom33(n);
    const uint32_t rom9 = glint_rom9(gate, n);
    for (uint32_t code = 0; code < CODES; code++) {
        const uint32_t reg1 = glint_block_saturate1(code);
        const int32_t adder8 =
            glint_block_adder8(glint_block_mul7(rom33, glint_block_adder6(reg1)));
        const uint64_t mul10 = glint_block_mul10_gated(gate, adder8);
        w[code] = glint_block_keys12(glint_block_cmp11(gate, rom9, reg1, adder8, mul10),
                                     glint_block_sat10(gate, mul10));
    }
}

GLINT_MULTIVERSION
static uint64_t count_rising(const uint32_t *w)
{
    uint32_t rising = 0;
    for (uint32_t code = 0; code + 1 < CODES; code++)
        rising += w[code] > w[code + 1];
    return rising;
}

GLINT_MULTIVERSION
static uint64_t count_other_colors(const uint32_t *w, const uint8_t *found, uint8_t color)
{
    uint32_t others = 0;
    for (uint32_t code = 0; code < CODES; code++)
        others += found[code] != glint_block_mul_color(w[code], color);
    return others;
}

/* 9·2^36 times the true W. */
static inline int64_t true_w(int32_t n, int32_t code)
{
    const int32_t numerator = (3 << 18) - (n + 1) * ((1 << 18) - code);
    const int64_t t = numerator > 0 ? numerator : 0;
    return t * t;
}

static inline uint64_t distance(int64_t a, int64_t b)
{
    return (uint64_t)(a > b ? a - b : b - a);
}

static inline uint64_t w_error(uint32_t w, uint32_t n, uint32_t code)
{
    return distance((int64_t)w * (9 << 18), true_w((int32_t)n, (int32_t)code));
}

static inline uint64_t color_error(uint8_t found, uint8_t color, uint32_t n, uint32_t code)
{
    return distance((int64_t)found * (int64_t)UNIT, true_w((int32_t)n, (int32_t)code) * color);
}

GLINT_MULTIVERSION
static uint64_t largest_w_error(const uint32_t *w, uint32_t n)
{
    uint64_t largest = 0;
    for (uint32_t code = 0; code < CODES; code++) {
        const uint64_t error = w_error(w[code], n, code);
        largest = error > largest ? error : largest;
    }
    return largest;
}

GLINT_MULTIVERSION
static uint64_t largest_color_error(const uint8_t *found, uint8_t color, uint32_t n)
{
    uint64_t largest = 0;
    for (uint32_t code = 0; code < CODES; code++) {
        const uint64_t error = color_error(found[code], color, n, code);
        largest = error > largest ? error : largest;
    }
    return largest;
}

/* ---- One n, a thread, all threads -------------------------------------------------------------
 */

static void measure_w(tally *tally, const uint32_t *w, uint32_t n)
{
    const uint64_t largest = largest_w_error(w, n);
    if (largest <= tally->worst_w.error)
        return;
    uint32_t code = 0;
    while (w_error(w[code], n, code) != largest)
        code++;
    tally->worst_w = (worst){largest, n, code};
}

static void measure_color(tally *tally, const uint8_t *found, int component, uint32_t n)
{
    const uint64_t largest = largest_color_error(found, colors[component], n);
    if (largest <= tally->worst_color[component].error)
        return;
    uint32_t code = 0;
    while (color_error(found[code], colors[component], n, code) != largest)
        code++;
    tally->worst_color[component] = (worst){largest, n, code};
}

static void run_batch(glint_gate gate, uint32_t n, results *out)
{
    const glint_material material = {(uint16_t)n, colors[0], colors[1], colors[2]};
    memset(out, 0x5a, sizeof *out);
    if (glint_specular_batch(gate, &material, sweep.codes, CODES, out->w, out->rgb[0], out->rgb[1],
                             out->rgb[2]) != GLINT_OK)
        abort();
}

static void sweep_batches(worker *worker, glint_gate gate, uint32_t n, results *out)
{
    tally *tally = &worker->tally;
    run_batch(gate, n, out);
    compute_by_blocks(gate, n, worker->blocks);
    tally->batch_differs += memcmp(out->w, worker->blocks, sizeof out->w) != 0;
    for (int i = 0; i < COMPONENTS; i++)
        tally->color_differs += count_other_colors(out->w, out->rgb[i], colors[i]);
}

static void sweep_n(worker *worker, uint32_t n)
{
    tally *tally = &worker->tally;
    sweep_batches(worker, GLINT_GATE_DRAWN, n, worker->sign);
    sweep_batches(worker, GLINT_GATE_SIGN, n, worker->sign);
    sweep_batches(worker, GLINT_GATE_COSINE, n, worker->cosine);
    tally->gates_differ += memcmp(worker->cosine, worker->sign, sizeof *worker->sign) != 0;
    tally->rising += count_rising(worker->cosine->w);
    measure_w(tally, worker->cosine->w, n);
    for (int i = 0; i < COMPONENTS; i++)
        measure_color(tally, worker->cosine->rgb[i], i, n);
    tally->points += CODES;
}

static void *sweep_some(void *context)
{
    worker *worker = context;
    uint32_t n;
    while ((n = atomic_fetch_add(&sweep.next_n, N_STEP)) < GLINT_N_COUNT)
        sweep_n(worker, n);
    return NULL;
}

static void keep_worse(worst *kept, const worst *other)
{
    if (other->error > kept->error)
        *kept = *other;
}

static void add_tally(tally *total, const tally *part)
{
    total->points += part->points;
    total->batch_differs += part->batch_differs;
    total->gates_differ += part->gates_differ;
    total->color_differs += part->color_differs;
    total->rising += part->rising;
    keep_worse(&total->worst_w, &part->worst_w);
    for (int i = 0; i < COMPONENTS; i++)
        keep_worse(&total->worst_color[i], &part->worst_color[i]);
}

static int start_worker(worker *worker)
{
    worker->cosine = malloc(sizeof *worker->cosine);
    worker->sign = malloc(sizeof *worker->sign);
    worker->blocks = malloc(CODES * sizeof *worker->blocks);
    if (worker->cosine == NULL || worker->sign == NULL || worker->blocks == NULL)
        return -1;
    worker->started = pthread_create(&worker->thread, NULL, sweep_some, worker) == 0;
    return worker->started ? 0 : -1;
}

static void end_worker(worker *worker)
{
    if (worker->started)
        pthread_join(worker->thread, NULL);
    add_tally(&sweep.total, &worker->tally);
    free(worker->cosine);
    free(worker->sign);
    free(worker->blocks);
}

/* Group setup: the whole sweep, once; the tests below look at what it counted. */
static int run_sweep(void **state)
{
    (void)state;
    glint_random random = {seed_of_this_run()};
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    const double begin = child_seconds();
    int failed = 0;
    sweep.worker_count = (int)(cores < 1 ? 1 : cores > THREADS_MAX ? THREADS_MAX : cores);
    sweep.first_n = glint_random_below(&random, N_STEP);
    sweep.next_n = sweep.first_n;
    for (uint32_t code = 0; code < CODES; code++)
        sweep.codes[code] = code;
    for (int i = 0; i < sweep.worker_count; i++)
        failed |= start_worker(&sweep.workers[i]);
    for (int i = 0; i < sweep.worker_count; i++)
        end_worker(&sweep.workers[i]);
    sweep.seconds = child_seconds() - begin;
    return failed;
}

/* ---- What has to hold -------------------------------------------------------------------------
 */

static void every_point_was_there(void **state)
{
    (void)state;
    const uint64_t ns = (GLINT_N_COUNT - sweep.first_n + N_STEP - 1) / N_STEP;
    print_message("%" PRIu64 " points: %u cosine codes, %" PRIu64 " of %u n, %d threads\n",
                  sweep.total.points, CODES, ns, GLINT_N_COUNT, sweep.worker_count);
    assert_true(sweep.total.points != 0);
    assert_true(sweep.total.points == ns * CODES);
    if (N_STEP == 1)
        assert_true(sweep.total.points == UINT64_C(268436480)); /* (2^18 + 1) · 2^10 */
}

static void batch_is_the_blocks(void **state)
{
    (void)state;
    assert_true(sweep.total.batch_differs == 0);
    assert_true(sweep.total.color_differs == 0);
}

static void gates_cosine_and_sign_agree_in_every_bit(void **state)
{
    (void)state;
    assert_true(sweep.total.gates_differ == 0);
}

static void w_never_rises_with_the_angle(void **state)
{
    (void)state;
    assert_true(sweep.total.rising == 0);
}

static double in_steps(uint64_t error)
{
    return (double)error / (double)UNIT;
}

/* 8-bit outputs of three colours, measured: within 0.52 of a step. */
static void outputs_are_within_the_limit(void **state)
{
    (void)state;
    for (int i = 0; i < COMPONENTS; i++) {
        const worst *w = &sweep.total.worst_color[i];
        print_message("colour %3d: largest error %.6f of a step, n = %u, code %u\n", colors[i],
                      in_steps(w->error), w->n, w->code);
        assert_true(w->error != 0);
        assert_true(100 * w->error <= 52 * UNIT);
    }
    if (N_STEP == 1) {
        record("model-1-accuracy",
               "C model: every colour within 0.52 of a step of the formula; gates cosine and sign "
               "equal; W monotone",
               "exact integers, whole domain", sweep.total.points, "points", sweep.seconds);
    }
}

/* Every colour, proved: the error of W times the colour, 255 at most, and the half step that
 * multipliers 13 to 15 may add (the next test) stay within 0.52 together. */
static void w_leaves_room_for_every_color(void **state)
{
    (void)state;
    const worst *w = &sweep.total.worst_w;
    print_message("W: largest error %.4e, n = %u, code %u: %.6f of a step of white;\n"
                  "with the rounding of the output %.6f at most, whatever the colour\n",
                  in_steps(w->error), w->n, w->code, 255 * in_steps(w->error),
                  255 * in_steps(w->error) + 0.5);
    assert_true(w->error != 0);
    assert_true(100 * (255 * w->error + UNIT / 2) <= 52 * UNIT);
}

/* Every W code and every colour: the output is within half a step of W times colour, and up where
 * it is exactly half. */
static void multiplier13_is_within_half_a_step(void **state)
{
    (void)state;
    uint64_t points = 0;
    for (uint32_t color = 0; color <= GLINT_COLOR_MAX; color++) {
        uint32_t wrong = 0;
        for (uint32_t w = 0; w <= GLINT_W_ONE; w++) {
            const int32_t exact = (int32_t)(w * color);
            const int32_t found = glint_block_mul_color(w, (uint8_t)color) * (1 << 18);
            wrong += found - exact > 1 << 17 || found - exact <= -(1 << 17);
        }
        assert_int_equal(wrong, 0);
        points += GLINT_W_ONE + 1;
    }
    print_message("%" PRIu64 " points: every W code, every colour\n", points);
    assert_true(points == UINT64_C(67109120)); /* (2^18 + 1) · 2^8 */
}

/* glint_specular_eval() is the same chain of blocks; drawn points, as it looks up both ROMs anew.
 */
static void eval_is_the_blocks(void **state)
{
    (void)state;
    static uint32_t w[CODES];
    glint_random random = {seed_of_this_run()};
    uint64_t points = 0;
    for (uint32_t n = sweep.first_n; n < GLINT_N_COUNT; n += N_STEP) {
        for (int gate = 0; gate < GLINT_GATE_COUNT; gate++) {
            compute_by_blocks((glint_gate)gate, n, w);
            for (uint32_t code = glint_random_below(&random, 911); code < CODES; code += 911) {
                const glint_material white = {(uint16_t)n, 255, 255, 255};
                glint_specular_values v;
                assert_int_equal(glint_specular_eval((glint_gate)gate, &white, code, &v), GLINT_OK);
                if (v.keys12 != w[code]) {
                    fail_msg("gate %d, n %u, code %u: eval %u, blocks %u", gate, n, code, v.keys12,
                             w[code]);
                }
                points++;
            }
        }
    }
    print_message("%" PRIu64 " points\n", points);
    assert_true(points > 0);
}

/* The reference that the rest of the project measures against is the same formula. */
static void the_real_formula_is_the_fraction(void **state)
{
    (void)state;
    glint_random random = {seed_of_this_run()};
    for (int i = 0; i < 1000000; i++) {
        const uint32_t n = glint_random_below(&random, GLINT_N_COUNT);
        const uint32_t reach = 3 * GLINT_COS_ONE / (n + 1) + 2; /* the highlight and its edge */
        const uint32_t code =
            GLINT_COS_ONE - glint_random_below(&random, reach < CODES ? reach : CODES);
        const double expected = in_steps((uint64_t)true_w((int32_t)n, (int32_t)code));
        const double found = glint_specular_real(GLINT_GATE_COSINE, n, code);
        if (!(found - expected <= 1e-12 && expected - found <= 1e-12))
            fail_msg("n %u, code %u: %.17g, expected %.17g", n, code, found, expected);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_point_was_there),
        cmocka_unit_test(batch_is_the_blocks),
        cmocka_unit_test(gates_cosine_and_sign_agree_in_every_bit),
        cmocka_unit_test(w_never_rises_with_the_angle),
        cmocka_unit_test(outputs_are_within_the_limit),
        cmocka_unit_test(w_leaves_room_for_every_color),
        cmocka_unit_test(multiplier13_is_within_half_a_step),
        cmocka_unit_test(eval_is_the_blocks),
        cmocka_unit_test(the_real_formula_is_the_fraction),
    };
    return golden_run_group_tests(tests, run_sweep, NULL);
}
