/* Runs of points through every highlight unit besides the specular device: by the C model's batch,
 * and by its Verilog through the backend, against the unit's stages point by point; lengths around
 * multiples of the lanes. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "../seed.h"
#include "backend/backend.h"
#include "circuit/circuits.h"
#include "circuit/random.h"
#include "circuit/units.h"
#include "glint_power.h"
#include "glint_rivals.h"

enum { LONGEST = 1100, ROUNDS = 24, FILLER = 0xa5 };

typedef struct run {
    uint32_t cosine[LONGEST], w[LONGEST];
    uint8_t r[LONGEST], g[LONGEST], b[LONGEST];
} run;

typedef struct known {
    const char *name;
    const glint_unit *unit;
} known;

#define KNOWN(name) {#name, &glint_unit_##name},
static const known units[] = {GLINT_UNITS(KNOWN)};
enum { UNITS = sizeof units / sizeof units[0] };

static glint_random draw;

static int seed_draw(void **state)
{
    (void)state;
    draw.state = seed_of_this_run();
    return 0;
}

static glint_material draw_material(void)
{
    const uint32_t color = (uint32_t)glint_random_bits(&draw);
    return (glint_material){(uint16_t)glint_random_below(&draw, GLINT_N_COUNT), (uint8_t)color,
                            (uint8_t)(color >> 8), (uint8_t)(color >> 16)};
}

/* Half of them near 1, where a large n has its highlight. */
static void draw_run(run *run)
{
    memset(run, FILLER, sizeof *run);
    for (size_t i = 0; i < LONGEST; i++)
        run->cosine[i] = glint_random_chance(&draw, 128)
                             ? glint_random_below(&draw, GLINT_COS_CODE_MAX + 1)
                             : GLINT_COS_ONE - glint_random_below(&draw, 4096);
}

static uint8_t times(uint32_t w, int w_frac_bits, uint8_t color)
{
    return (uint8_t)(((uint64_t)w * color + (UINT64_C(1) << w_frac_bits >> 1)) >> w_frac_bits);
}

/* What a run of count has to hold; what lies behind it stays as it is. */
static void expect(const glint_unit *unit, const glint_backend_config *config,
                   const glint_material *material, size_t count, run *run)
{
    const int bits = unit->w_frac_bits(config->variant) - config->w_drop;
    for (size_t i = 0; i < count; i++) {
        uint32_t w;
        assert_int_equal(
            glint_unit_eval(unit, config->variant, material->n, run->cosine[i], NULL, &w),
            GLINT_OK);
        w = (uint32_t)floor(ldexp(w, -config->w_drop) + 0.5);
        run->w[i] = w;
        run->r[i] = times(w, bits, material->r);
        run->g[i] = times(w, bits, material->g);
        run->b[i] = times(w, bits, material->b);
    }
}

static void check_run(const known *of, const glint_backend_config *config, glint_backend *backend,
                      size_t count)
{
    static run found, expected;
    const glint_material material = draw_material();
    glint_error err;
    draw_run(&found);
    expected = found;
    expect(of->unit, config, &material, count, &expected);
    const glint_points points = {found.cosine, count, found.w, found.r, found.g, found.b};
    if (glint_backend_shade(backend, &material, &points, &err) != GLINT_OK)
        fail_msg("%s: %s", of->name, err.text);
    if (memcmp(&found, &expected, sizeof found) != 0)
        fail_msg("%s, variant %d, %d places rounded off: %zu points of n %u", of->name,
                 config->variant, config->w_drop, count, material.n);
}

static glint_backend_config config_of(const known *of, int variant, glint_backend_kind kind,
                                      int lanes)
{
    return (glint_backend_config){.kind = kind,
                                  .device = glint_circuit_named(of->name),
                                  .variant = variant,
                                  .pipeline = GLINT_PIPELINE_PIPELINED,
                                  .lanes = lanes};
}

static void check_config(const known *of, const glint_backend_config *config)
{
    glint_backend *backend;
    glint_error err;
    if (glint_backend_create(config, &backend, &err) != GLINT_OK)
        fail_msg("%s: %s", of->name, err.text);
    check_run(of, config, backend, LONGEST);
    for (int i = 0; i < ROUNDS; i++)
        check_run(of, config, backend,
                  glint_random_below(&draw, (uint32_t)(3 * config->lanes + 2)));
    glint_backend_destroy(backend);
}

static void check_backend(const known *of, int variant, glint_backend_kind kind, int lanes)
{
    const glint_backend_config config = config_of(of, variant, kind, lanes);
    check_config(of, &config);
}

static void every_unit_in_c(void **state)
{
    (void)state;
    for (int u = 0; u < UNITS; u++)
        for (int variant = 0; variant < units[u].unit->variants; variant++)
            check_backend(&units[u], variant, GLINT_BACKEND_C, 1);
}

static void every_unit_in_verilog(void **state)
{
    (void)state;
    for (int u = 0; u < UNITS; u++)
        check_backend(&units[u], units[u].unit->variants - 1, GLINT_BACKEND_RTL, 1);
}

/* In C any number of places, in the Verilog as many as make the common width of the quadratic. */
static void places_of_w_rounded_off(void **state)
{
    enum { MOST = 4, TO_COMMON = 6 };
    (void)state;
    for (int u = 0; u < UNITS; u++)
        for (int drop = 1; drop <= MOST; drop++) {
            glint_backend_config config = config_of(&units[u], 0, GLINT_BACKEND_C, 1);
            config.w_drop = drop;
            check_config(&units[u], &config);
        }
    for (int u = 0; u < UNITS; u++)
        if (units[u].unit == &glint_unit_quadratic) {
            glint_backend_config config = config_of(&units[u], 0, GLINT_BACKEND_RTL, 4);
            config.w_drop = TO_COMMON;
            check_config(&units[u], &config);
        }
}

/* W across words of the port: 3 × 13 bits, 3 × 19 bits. */
static void lanes_that_end_within_a_word(void **state)
{
    (void)state;
    check_backend(&units[0], GLINT_POWER_HALF, GLINT_BACKEND_RTL, 3);
    check_backend(&units[UNITS - 1], 0, GLINT_BACKEND_RTL, 3);
}

static void the_formula_is_the_units_own(void **state)
{
    (void)state;
    const glint_backend_config config = config_of(&units[0], 0, GLINT_BACKEND_REAL, 1);
    const glint_material material = {80, 255, 255, 255};
    const uint32_t code = GLINT_COS_ONE - 2000;
    uint32_t w;
    uint8_t r, g, b;
    glint_backend *backend;
    glint_error err;
    assert_int_equal(glint_backend_create(&config, &backend, &err), GLINT_OK);
    const glint_points points = {&code, 1, &w, &r, &g, &b};
    assert_int_equal(glint_backend_shade(backend, &material, &points, &err), GLINT_OK);
    assert_int_equal(w, (uint32_t)(glint_power_real(80, code) * 4096 + 0.5));
    glint_backend_destroy(backend);
}

static void what_is_no_unit_is_refused(void **state)
{
    (void)state;
    glint_backend *backend;
    glint_error err;
    glint_backend_config config = {.device = &glint_circuit_divider};
    assert_int_equal(glint_backend_create(&config, &backend, &err), GLINT_BAD_ARGUMENT);
    assert_string_equal(err.text, "circuit divider does not compute highlights");
    config = config_of(&units[0], GLINT_POWER_ACCURACY_COUNT, GLINT_BACKEND_C, 1);
    assert_int_equal(glint_backend_create(&config, &backend, &err), GLINT_BAD_ARGUMENT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_unit_in_c),
        cmocka_unit_test(every_unit_in_verilog),
        cmocka_unit_test(places_of_w_rounded_off),
        cmocka_unit_test(lanes_that_end_within_a_word),
        cmocka_unit_test(the_formula_is_the_units_own),
        cmocka_unit_test(what_is_no_unit_is_refused),
    };
    return cmocka_run_group_tests(tests, seed_draw, NULL);
}
