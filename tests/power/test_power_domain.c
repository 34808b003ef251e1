/* The numbers the power device has to meet, over its whole domain: every cosine code 0…2^18 for
 * every n 0…1023, with both accuracies.
 *
 *     |W − cosⁿ| ≤ 0.5/255 or 0.25/255     W(1) = 1     W ≤ 1     W never falls as the cosine grows
 *
 * cosⁿ is cosⁿ⁻¹·cos in a double: after 1023 factors off by 10⁻¹³ at most, which the bound has
 * room for. */
#define _XOPEN_SOURCE 700

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "../record.h"
#include "circuit/circuits.h"
#include "circuit/random_pins.h"
#include "circuit/units.h"
#include "glint_power.h"
#include "power_blocks.h"

enum { ONE = GLINT_COS_ONE, WORDS = 1 << GLINT_POWER_TABLE_BITS(GLINT_POWER_HALF) };

/* 8 times 200 000: tests/netlist/test_opinions.c, tests/netlist/run.sh. */
enum { NETLIST_CLOCKS = 8 * 200000 };

/* With a sanitizer only so many n: it is there to find bad accesses. */
#ifdef GLINT_SANITIZED
enum { N_COUNT = 17 };
#else
enum { N_COUNT = GLINT_N_COUNT };
#endif

static double cosine_power[ONE + 1]; /* cosⁿ of each code, for the n at hand */
static uint32_t w[ONE + 1], codes[ONE + 1];
static uint8_t unwanted[3][ONE + 1]; /* a batch's colours */

/* The largest error and where it is. */
typedef struct worst {
    double error;
    uint32_t n, code;
} worst;

static void begin_powers(void)
{
    for (uint32_t code = 0; code <= ONE; code++) {
        cosine_power[code] = 1.0;
        codes[code] = code;
    }
}

static void next_powers(void)
{
    for (uint32_t code = 0; code <= ONE; code++)
        cosine_power[code] *= (double)code / ONE;
}

/* The largest error of this n; to be compiled to vectors. */
static double largest_error(double one)
{
    double largest = 0;
    for (uint32_t code = 0; code < ONE; code++) {
        const double error = fabs((double)(int32_t)w[code] * one - cosine_power[code]);
        largest = error > largest ? error : largest;
    }
    return largest;
}

static void find_worst(uint32_t n, double one, worst *worst)
{
    const double error = largest_error(one);
    if (error <= worst->error)
        return;
    *worst = (struct worst){error, n, 0};
    while (fabs((double)(int32_t)w[worst->code] * one - cosine_power[worst->code]) < error)
        worst->code++;
}

static uint32_t falls(void)
{
    uint32_t count = 0;
    for (uint32_t code = 1; code <= ONE; code++)
        count += w[code] < w[code - 1];
    return count;
}

/* W of every code for this n, from the batch: it never falls and ends at 1.0, so none is larger. */
static void check_n(glint_power_accuracy accuracy, uint32_t n, worst *worst)
{
    const uint32_t one = 1u << GLINT_POWER_W_FRAC_BITS(accuracy);
    const glint_material material = {.n = (uint16_t)n};
    glint_power_values beyond;
    assert_int_equal(glint_power_batch(accuracy, &material, codes, ONE + 1, w, unwanted[0],
                                       unwanted[1], unwanted[2]),
                     GLINT_OK);
    assert_int_equal(w[ONE], one);
    if (falls() != 0)
        fail_msg("n = %u: W falls at %u codes", n, falls());
    find_worst(n, 1.0 / one, worst);
    for (uint32_t code = ONE + 1; code <= GLINT_COS_CODE_MAX; code += 8191) {
        assert_int_equal(glint_power_eval(accuracy, &material, code, &beyond), GLINT_OK);
        assert_int_equal(beyond.keys12, one);
    }
}

static void check_domain(glint_power_accuracy accuracy)
{
    const double bound = accuracy == GLINT_POWER_HALF ? 0.5 : 0.25;
    const double begin = (double)clock() / CLOCKS_PER_SEC;
    const uint64_t points = (uint64_t)N_COUNT * (ONE + 1);
    worst worst = {0};
    char name[32], what[128];
    begin_powers();
    for (uint32_t n = 0; n < N_COUNT; n++) {
        check_n(accuracy, n, &worst);
        next_powers();
    }
    print_message("accuracy %s: largest error %.6f/255 at n = %u, code %u, of %" PRIu64
                  " points; W(1) = 1; W never falls\n",
                  glint_power_accuracy_name(accuracy), worst.error * 255, worst.n, worst.code,
                  points);
    assert_true(worst.error > 0 && worst.error * 255 <= bound);
    (void)snprintf(name, sizeof name, "model-power-%s", glint_power_accuracy_name(accuracy));
    (void)snprintf(what, sizeof what,
                   "power device, %s: W within %.4f/255 of cos^n; W(1) = 1; W monotone",
                   glint_power_accuracy_name(accuracy), worst.error * 255);
    record(name, what, "every cosine code and n", points, "points",
           (double)clock() / CLOCKS_PER_SEC - begin);
}

static void half_is_within_half_a_step(void **state)
{
    (void)state;
    check_domain(GLINT_POWER_HALF);
}

static void quarter_is_within_a_quarter(void **state)
{
    (void)state;
    check_domain(GLINT_POWER_QUARTER);
}

/* ---- Which bits of the ROMs can be seen ------------------------------------------------------ */

/* A word for each address: a bit is 1 where some point had another W with that bit of the table's
 * word inverted. */
typedef struct seen {
    uint32_t log[WORDS], exp[WORDS];
} seen;

static uint32_t bits_of_log(glint_power_accuracy accuracy)
{
    return (uint32_t)(GLINT_POWER_L_INT_BITS + GLINT_POWER_TABLE_BITS(accuracy));
}

static uint32_t w_of(glint_power_accuracy accuracy, uint32_t mul7, uint32_t log, uint32_t flip)
{
    const int table = GLINT_POWER_TABLE_BITS(accuracy);
    const uint32_t v = glint_power_block_mul10(glint_power_block_q(mul7), log);
    const uint32_t pass = glint_power_block_cmp11(table, glint_power_block_over7(mul7), v);
    const uint32_t exp = glint_power_rom33(accuracy, glint_power_block_address33(table, v)) ^ flip;
    return glint_power_block_keys12(table, pass, exp, v);
}

/* What this point shows. */
static void look(glint_power_accuracy accuracy, uint32_t n, uint32_t code, seen *seen)
{
    const int table = GLINT_POWER_TABLE_BITS(accuracy);
    const uint32_t x = glint_power_block_x(code), mul7 = glint_power_block_mul7(n, x);
    const uint32_t address9 = glint_power_block_address9(table, x);
    const uint32_t log = glint_power_rom9(accuracy, address9);
    const uint32_t v = glint_power_block_mul10(glint_power_block_q(mul7), log);
    const uint32_t right = w_of(accuracy, mul7, log, 0);
    for (uint32_t bit = 0; bit < bits_of_log(accuracy); bit++)
        if (w_of(accuracy, mul7, log ^ 1u << bit, 0) != right)
            seen->log[address9] |= 1u << bit;
    for (uint32_t bit = 0; bit <= (uint32_t)GLINT_POWER_W_FRAC_BITS(accuracy); bit++)
        if (w_of(accuracy, mul7, log, 1u << bit) != right)
            seen->exp[glint_power_block_address33(table, v)] |= 1u << bit;
}

static int count_bits(const uint32_t words[WORDS])
{
    int count = 0;
    for (int i = 0; i < WORDS; i++)
        count += __builtin_popcount(words[i]);
    return count;
}

/* By any point: n·x up to 32, as a g with a bit inverted may be small. */
static void look_at_all(seen *seen)
{
    for (uint32_t n = 0; n < GLINT_N_COUNT; n++)
        for (uint32_t x = 0; x < ONE && n * x < 16u << GLINT_POWER_X_BITS; x += 5)
            look(GLINT_POWER_HALF, n, ONE - x, seen);
}

/* By the random pins that lockstep gives every form of the circuit, a netlist too: the point that
 * registers 1 and 2 hold after each clock. */
static void look_at_random(uint64_t clocks, uint64_t seed, seen *seen)
{
    const glint_setting setting = glint_setting_unit(glint_circuit_named("power"), GLINT_POWER_HALF,
                                                     0, GLINT_PIPELINE_PIPELINED, 1);
    glint_random_pins random;
    uint32_t n = 0;
    glint_random_pins_begin(&random, &setting, seed);
    for (uint64_t clock = 0; clock < clocks; clock++) {
        glint_pins pins;
        glint_specular_inputs in;
        glint_random_pins_next(&random, &pins);
        memcpy(&in, &pins, sizeof in);
        if (in.reset)
            n = 0;
        else if (in.en && in.n_we)
            n = in.n;
        if (!in.reset && in.en && in.in_valid != 0)
            look(GLINT_POWER_HALF, n, in.cos[0], seen);
    }
}

/* Every bit of both ROMs shows at some point, and the clocks that make netlist gives a netlist show
 * them all: one wrong bit would be noticed at the pins. */
static void the_vectors_see_every_bit_of_the_roms(void **state)
{
    (void)state;
    static seen any, random;
    look_at_all(&any);
    look_at_random(NETLIST_CLOCKS, 1, &random);
    print_message("ROM 9: %d of %u bits can be seen, random pins see %d\n", count_bits(any.log),
                  WORDS * bits_of_log(GLINT_POWER_HALF), count_bits(random.log));
    print_message("ROM 33: %d of %d bits can be seen, random pins see %d\n", count_bits(any.exp),
                  WORDS * (1 + GLINT_POWER_W_FRAC_BITS(GLINT_POWER_HALF)), count_bits(random.exp));
    assert_int_equal(count_bits(any.log), WORDS * bits_of_log(GLINT_POWER_HALF));
    assert_int_equal(count_bits(any.exp), WORDS * (1 + GLINT_POWER_W_FRAC_BITS(GLINT_POWER_HALF)));
    assert_int_equal(count_bits(random.log), count_bits(any.log));
    assert_int_equal(count_bits(random.exp), count_bits(any.exp));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(half_is_within_half_a_step),
        cmocka_unit_test(quarter_is_within_a_quarter),
        cmocka_unit_test(the_vectors_see_every_bit_of_the_roms),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
