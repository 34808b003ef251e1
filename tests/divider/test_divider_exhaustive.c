/* The Verilog of both forms of the divider, for every number of shifts, every k and every
 * difference that the pins can carry: against the C model, and the two forms against each other. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "../record.h"
#include "circuit/circuits.h"
#include "rtl/batch.h"

enum {
    N_FIRST = 6,
    N_LAST = 16,
    K_TABLE = 16,
    K_COUNT = 256,
    /* Nine bits: −255…255, which the divider is for, and −256, which its pins can carry too. */
    D_MIN = -256,
    D_COUNT = 512,
    /* Three at a time, so the sequential form takes 171 divisions of three components a k. */
    DIVISIONS = K_COUNT * D_COUNT,
};

/* The sequential form divides component after component: it needs each difference once. */
enum { GROUPS = (D_COUNT + 2) / 3, DIVISIONS_OF_THREE = K_COUNT * GROUPS };

static glint_division divisions[DIVISIONS];
static glint_quotients of_pipelined[DIVISIONS];
static glint_quotients of_sequential[DIVISIONS_OF_THREE];

static glint_rtl *create(glint_divider_form form, int n)
{
    glint_rtl *rtl;
    glint_error err;
    const glint_setting setting = glint_setting_divider(form, n);
    if (glint_rtl_open(&setting, GLINT_RTL_FAST, &rtl, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    return rtl;
}

/* The clock count proves that the circuit did the dividing, at its throughput: one division per
 * clock, or one component every n + 1 clocks, plus one clock for the initial reset. */
static uint64_t clocks_due(glint_divider_form form, int n, size_t count)
{
    return form == GLINT_DIVIDER_PIPELINED
               ? 1 + count + (uint64_t)n
               : 1 + count * GLINT_DIVIDER_COMPONENTS * (uint64_t)glint_divider_latency(n);
}

static void divide_all(glint_divider_form form, int n, size_t count, glint_quotients *quotients)
{
    glint_error err;
    glint_rtl *rtl = create(form, n);
    if (glint_rtl_divide(rtl, divisions, count, quotients, &err) != GLINT_OK)
        fail_msg("%s, n = %d: %s", glint_divider_form_name(form), n, err.text);
    assert_int_equal(glint_rtl_clocks(rtl), clocks_due(form, n, count));
    glint_rtl_destroy(rtl);
}

/* What the quotient has to be: the model, where it takes the difference. */
static int32_t expected_code(int n, int difference, uint32_t k, bool *out_of_table)
{
    int32_t code = 0;
    if (difference == D_MIN) {
        *out_of_table = k == 0 || k > K_TABLE;
        return difference * (int32_t)glint_divider_bits(n, k);
    }
    assert_int_equal(glint_divide(n, difference, k, &code, out_of_table), GLINT_OK);
    return code;
}

static uint64_t compare(const char *form, int n, const glint_division *division,
                        const glint_quotients *found)
{
    for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++) {
        bool out_of_table = false;
        const int32_t code = expected_code(n, division->difference[c], division->k, &out_of_table);
        if (found->code[c] != code || found->out_of_table != out_of_table) {
            fail_msg("%s, n = %d: %d/%d in component %d gives %" PRId32 "%s, not %" PRId32, form, n,
                     division->difference[c], division->k, c, found->code[c],
                     found->out_of_table ? " (out of the table)" : "", code);
        }
    }
    return GLINT_DIVIDER_COMPONENTS;
}

/* Each component gets every difference, and never the same as another. */
static void fill_divisions_of_every_component(void)
{
    for (int i = 0; i < DIVISIONS; i++) {
        divisions[i].k = (uint8_t)(i / D_COUNT);
        for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
            divisions[i].difference[c] = (int16_t)(D_MIN + (i + 171 * c) % D_COUNT);
    }
}

static int16_t difference_of_three(int group, int component)
{
    const int index = 3 * group + component;
    return (int16_t)(D_MIN + (index < D_COUNT ? index : 0));
}

static void fill_divisions_of_three(void)
{
    for (int i = 0; i < DIVISIONS_OF_THREE; i++) {
        divisions[i].k = (uint8_t)(i / GROUPS);
        for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
            divisions[i].difference[c] = difference_of_three(i % GROUPS, c);
    }
}

static void the_pipelined_form_equals_the_model(void **state)
{
    (void)state;
    const double begin = child_seconds();
    uint64_t compared = 0;
    fill_divisions_of_every_component();
    for (int n = N_FIRST; n <= N_LAST; n++) {
        divide_all(GLINT_DIVIDER_PIPELINED, n, DIVISIONS, of_pipelined);
        for (int i = 0; i < DIVISIONS; i++)
            compared += compare("pipelined", n, &divisions[i], &of_pipelined[i]);
    }
    print_message("pipelined: 0 mismatches of %" PRIu64 " quotients\n", compared);
    assert_true(compared == UINT64_C(11) * K_COUNT * D_COUNT * 3);
    record("rtl-4-divider-pipelined", "RTL = C model: pipelined divider, every k and difference",
           "exhaustion, n = 6…16", compared, "quotients", child_seconds() - begin);
}

/* The sequential form against the model, and both forms against each other. */
static void the_sequential_form_equals_both(void **state)
{
    (void)state;
    const double begin = child_seconds();
    uint64_t compared = 0;
    fill_divisions_of_three();
    for (int n = N_FIRST; n <= N_LAST; n++) {
        divide_all(GLINT_DIVIDER_SEQUENTIAL, n, DIVISIONS_OF_THREE, of_sequential);
        divide_all(GLINT_DIVIDER_PIPELINED, n, DIVISIONS_OF_THREE, of_pipelined);
        for (int i = 0; i < DIVISIONS_OF_THREE; i++) {
            for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++) {
                if (of_sequential[i].code[c] != of_pipelined[i].code[c] ||
                    of_sequential[i].out_of_table != of_pipelined[i].out_of_table) {
                    fail_msg("n = %d: %d/%d is %" PRId32 " sequential, %" PRId32 " pipelined", n,
                             divisions[i].difference[c], divisions[i].k, of_sequential[i].code[c],
                             of_pipelined[i].code[c]);
                }
            }
            compared += compare("sequential", n, &divisions[i], &of_sequential[i]);
        }
    }
    print_message("sequential: 0 mismatches of %" PRIu64 " quotients, with the model and with the "
                  "pipelined form\n",
                  compared);
    assert_true(compared == UINT64_C(11) * K_COUNT * GROUPS * 3);
    record("rtl-3-divider-sequential", "RTL = C model: sequential divider, every k and difference",
           "exhaustion, n = 6…16", compared, "quotients", child_seconds() - begin);
}

/* The claim in the words of its users: the table's k, 0 and one beyond, differences −255…255. It
 * is a part of what ran above; here it is counted. */
static void every_case_of_the_table_was_among_them(void **state)
{
    (void)state;
    static bool seen[2][K_COUNT][D_COUNT];
    uint64_t cases[2] = {0, 0};
    for (int form = 0; form < 2; form++) {
        if (form == 0)
            fill_divisions_of_every_component();
        else
            fill_divisions_of_three();
        for (int i = 0; i < (form == 0 ? DIVISIONS : DIVISIONS_OF_THREE); i++)
            for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
                seen[form][divisions[i].k][divisions[i].difference[c] - D_MIN] = true;
        for (int k = 0; k <= K_TABLE + 1; k++)
            for (int d = -255; d <= 255; d++)
                cases[form] += seen[form][k][d - D_MIN];
    }
    assert_true(cases[0] == 18 * 511 && cases[1] == 18 * 511);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_pipelined_form_equals_the_model),
        cmocka_unit_test(the_sequential_form_equals_both),
        cmocka_unit_test(every_case_of_the_table_was_among_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
