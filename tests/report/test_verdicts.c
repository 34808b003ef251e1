/* Every claim of the report is fed two sets of numbers, one of them false, and must change its
 * verdict; and what it says of the conditions must be those that it was measured under. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "report/claims.h"
#include "report/energy_parts.h"
#include "report/frame_times.h"
#include "report/lobe_parts.h"
#include "report/speeds.h"

#define assert_says(text, part)                                                                    \
    do {                                                                                           \
        if (strstr(text, part) == NULL)                                                            \
            fail_msg("\"%s\" is not in \"%s\"", part, text);                                       \
    } while (0)

static glint_findings *new_findings(void)
{
    glint_findings *findings = glint_findings_create();
    assert_non_null(findings);
    return findings;
}

static int count_of(const glint_findings *findings)
{
    int count = 0;
    for (int i = 0; i < GLINT_VERDICT_COUNT; i++)
        count += glint_findings_count(findings, (glint_verdict)i);
    return count;
}

/* Each claim of the one has the same place in the other, with another verdict. */
static void all_differ(const glint_findings *findings, const glint_findings *others, int count)
{
    assert_int_equal(count_of(findings), count);
    assert_int_equal(count_of(others), count);
    for (int i = 0; i < count; i++) {
        const glint_finding *one = glint_findings_get(findings, i);
        const glint_finding *other = glint_findings_get(others, i);
        assert_string_equal(one->claim, other->claim);
        if (one->verdict == other->verdict)
            fail_msg("%s both times: %s (%s; %s)", glint_verdict_names[one->verdict], one->claim,
                     one->measured, other->measured);
        assert_true(strlen(one->claim) < sizeof one->claim - 1); /* there it would be cut */
        assert_true(strlen(one->measured) < sizeof one->measured - 1);
        assert_true(strlen(one->conditions) < sizeof one->conditions - 1);
    }
}

static const glint_finding *claim(const glint_findings *findings, const char *words)
{
    const glint_finding *found;
    for (int i = 0; (found = glint_findings_get(findings, i)) != NULL; i++)
        if (strstr(found->claim, words) != NULL)
            return found;
    fail_msg("no claim with \"%s\"", words);
    return NULL;
}

/* ---- The lobes ------------------------------------------------------------------------------- */

static glint_accuracy accuracy(double absolute, double in_epicentre, double relative)
{
    return (glint_accuracy){{absolute, 0.5}, {in_epicentre, 0.9}, {relative, 0.9}};
}

/* Lobes that are as wrong as a factor says, at n = 1, 2 and 50; Schlick's function, by which others
 * are measured, as it is told. */
static glint_lobes *lobes_of(double factor, double schlick)
{
    glint_lobes *lobes = calloc(1, sizeof *lobes);
    const glint_accuracy all = accuracy(factor, factor, factor);
    assert_non_null(lobes);
    lobes->exponents = (glint_exponents){.n = {1.0, 2.0, 50.0}, .count = 3};
    for (int i = 0; i < lobes->exponents.count; i++) {
        for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++)
            lobes->by_n[model][i] = all;
        lobes->by_n[GLINT_REFLECTANCE_SCHLICK][i] = accuracy(schlick, schlick, schlick);
        lobes->quadratic[i] = lobes->quadratic_decay[i] = lobes->cosine_quadratic_decay[i] = all;
    }
    return lobes;
}

static const glint_derivations right = {.a_count = 1000,
                                        .relative_level = {0.3, 0.3},
                                        .relative_there = {0.2, 0.2},
                                        .relative_at_end = {0.1, 0.1},
                                        .level_at_end = {0.125, 0.25},
                                        .absolute_to_end = {1.0, 1.0}};
static const glint_derivations wrong = {.a_count = 1000,
                                        .a_undefined = 2,
                                        .a_first_undefined = 7,
                                        .integral_apart = 1e-6,
                                        .relative_apart = {0.0, 0.01},
                                        .relative_level = {0.1, 0.5},
                                        .relative_there = {0.2, 0.2},
                                        .relative_at_end = {0.21, 0.21},
                                        .level_at_end = {0.0625, 0.5},
                                        .absolute_to_end = {1.0, 1.1}};

static glint_findings *find_lobes(const glint_lobes *lobes)
{
    glint_findings *findings = new_findings();
    glint_lobes_find(lobes, findings);
    return findings;
}

static void claims_on_lobes_follow_their_numbers(void **state)
{
    (void)state;
    glint_lobes *good = lobes_of(0.001, 0.02), *bad = lobes_of(0.12, 0.10);
    good->derived = right;
    bad->derived = wrong;
    glint_findings *holding = find_lobes(good), *others = find_lobes(bad);
    all_differ(holding, others, 23);
    /* One that holds for Schlick's 10 % alone. */
    assert_int_equal(glint_findings_get(holding, 1)->verdict, GLINT_DOES_NOT_HOLD);
    assert_int_equal(glint_findings_get(others, 1)->verdict, GLINT_HOLDS);
    /* Some a would do, the thesis does not say which; then none would. */
    assert_int_equal(claim(holding, "cos^a")->verdict, GLINT_CANNOT_BE_DECIDED);
    assert_int_equal(claim(others, "cos^a")->verdict, GLINT_DOES_NOT_HOLD);
    glint_findings_destroy(holding);
    glint_findings_destroy(others);
    free(good);
    free(bad);
}

/* It is not said than what: when it is so by everything it holds, by nothing it does not. */
static void ten_times_as_accurate_is_measured(void **state)
{
    (void)state;
    static const struct {
        double quadratic, schlick;
        glint_verdict verdict;
    } cases[] = {{0.01, 0.2, GLINT_HOLDS},
                 {0.01, 0.1, GLINT_CANNOT_BE_DECIDED}, /* 10 times is not more than 10 */
                 {0.1, 0.2, GLINT_DOES_NOT_HOLD}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        glint_lobes *lobes = lobes_of(0.2, cases[i].schlick);
        for (int n = 0; n < lobes->exponents.count; n++)
            lobes->by_n[GLINT_REFLECTANCE_QUADRATIC][n] =
                accuracy(1.0, cases[i].quadratic, cases[i].quadratic);
        glint_findings *findings = find_lobes(lobes);
        assert_int_equal(claim(findings, "10 times as accurate")->verdict, cases[i].verdict);
        glint_findings_destroy(findings);
        free(lobes);
    }
}

static void lobes_say_which_n_they_were_measured_at(void **state)
{
    (void)state;
    glint_lobes *lobes = lobes_of(0.001, 0.02);
    glint_findings *findings = find_lobes(lobes);
    const glint_finding *found;
    for (int i = 0; (found = glint_findings_get(findings, i)) != NULL; i++) {
        if (strncmp(found->where, "(2.8)", 5) == 0)
            continue; /* of 1…1000, whatever the exponents */
        if (strstr(found->conditions, "1000") != NULL)
            fail_msg("%s: %s", found->claim, found->conditions);
        assert_true(strncmp(found->conditions, "3 exponents n = 1…50, ", 21) == 0 ||
                    strncmp(found->conditions, "2 exponents n = 2…50, ", 21) == 0 ||
                    strncmp(found->conditions, "n = 1, ", 7) == 0 ||
                    strncmp(found->conditions, "n = 50, ", 8) == 0);
    }
    assert_says(claim(findings, "at most 0.1, n = 2…1000")->conditions, "2 exponents n = 2…50, ");
    assert_says(claim(findings, "at most 0.1, n = 1")->conditions, "n = 1, ");
    glint_findings_destroy(findings);
    lobes->exponents = (glint_exponents){.n = {50.0}, .count = 1};
    findings = find_lobes(lobes);
    assert_int_equal(claim(findings, "at most 0.1, n = 2")->verdict, GLINT_HOLDS);
    found = claim(findings, "at most 0.1, n = 1");
    assert_int_equal(found->verdict, GLINT_CANNOT_BE_DECIDED);
    assert_says(found->measured, "nothing was measured");
    assert_says(found->conditions, "no exponent, ");
    glint_findings_destroy(findings);
    free(lobes);
}

static void an_error_at_n_1_is_not_left_out(void **state)
{
    (void)state;
    glint_lobes *lobes = lobes_of(0.001, 0.02);
    lobes->derived = right;
    lobes->cosine_quadratic_decay[0].epicentre_relative.error = 10.56;
    glint_findings *findings = find_lobes(lobes);
    const glint_finding *found = claim(findings, "Cosine-quadratic: the same 3 % in the zone");
    assert_int_equal(found->verdict, GLINT_DOES_NOT_HOLD);
    assert_says(found->measured, "1056 % at n = 1; from n = 2 on 0 %");
    assert_says(found->conditions, "W reaches zero where cos^n is still 0.125 to 0.250");
    glint_findings_destroy(findings);
    free(lobes);
}

/* ---- The divider ----------------------------------------------------------------------------- */

static glint_divider_error errors[GLINT_DIVIDER_SHIFTS_MAX - GLINT_DIVIDER_SHIFTS_MIN + 1];
static glint_divider_scene scenes[GLINT_DIVIDER_SCENES];

static glint_claims claims_of(const glint_table_21 *table, const glint_divider_example *example,
                              double error, double nmse)
{
    glint_claims claims;
    const glint_claims_facts facts = {
        .example = *example, .error = errors, .table = table, .scenes = scenes};
    errors[0].displayed = 33;
    errors[2] = (glint_divider_error){
        .absolute = error, .absolute_k = 5, .relative_mean = error * 0.81 / 0.4427 / 100.0};
    scenes[0].frames[0].shifts = 6;
    scenes[GLINT_DIVIDER_SCENES - 1].frames[0].difference.nmse = nmse;
    glint_claims_check(&facts, &claims);
    return claims;
}

static void claims_on_the_divider_follow_their_numbers(void **state)
{
    (void)state;
    static const glint_divider_example example = {255, 7, 6, 9, 36.42857, 35.85938, 0.0156};
    static const glint_divider_example other = {255, 7, 6, 8, 37.0, 36.4307, 0.0146};
    glint_table_21 table = {.drawn_pixels = 100, .area = 12.5, .described = glint_table_21_stated};
    glint_claims good = claims_of(&table, &example, 0.4427, 0.00009);
    for (int i = 0; i < GLINT_SPAN_STAGE_COUNT; i++) {
        table.described.stage[i].additions += 1;
        table.described.stage[i].divisions += 1;
    }
    table.drawn_pixels = 99;
    table.area = 12.25;
    glint_claims bad = claims_of(&table, &other, 0.5, 0.00011);
    assert_int_equal(good.count, 21);
    assert_int_equal(bad.count, good.count);
    for (int i = 0; i < good.count; i++) {
        assert_string_equal(good.claim[i].what, bad.claim[i].what);
        if (good.claim[i].verdict == bad.claim[i].verdict &&
            strcmp(good.claim[i].what, "times faster") != 0)
            fail_msg("%s both times: %s", glint_verdict_names[good.claim[i].verdict],
                     good.claim[i].what);
        assert_true(strlen(good.claim[i].what) < sizeof good.claim[i].what - 1);
        assert_true(strlen(good.claim[i].note) < sizeof good.claim[i].note - 1);
    }
    assert_says(good.claim[6].note, "over 4 frames; the last pixel of one span may be 33 levels");
    assert_says(good.claim[7].note, "at k = 5;");
    assert_says(good.claim[9].note, "area is 12.5 pixels");
    assert_says(bad.claim[9].note, "area is 12.25 pixels");
}

/* The clocks of an operation come from the totals themselves: nothing is proven by them, nor by
 * their quotient; other counts contradict them. */
static void a_number_computed_from_the_claim_does_not_prove_it(void **state)
{
    (void)state;
    static const glint_divider_example example = {255, 7, 6, 9, 36.42857, 35.85938, 0.0156};
    glint_table_21 table = {.described = glint_table_21_stated};
    glint_claims claims = claims_of(&table, &example, 0.4427, 0.0);
    for (int i = 18; i < 21; i++)
        assert_int_equal(claims.claim[i].verdict, GLINT_CANNOT_BE_DECIDED);
    assert_string_equal(claims.claim[20].what, "times faster");
    table.described.stage[0].divisions *= 2;
    claims = claims_of(&table, &example, 0.4427, 0.0);
    for (int i = 18; i < 21; i++)
        assert_int_equal(claims.claim[i].verdict, GLINT_DOES_NOT_HOLD);
}

/* ---- Frames ---------------------------------------------------------------------------------- */

static void fill(glint_frame_errors *frames, int light, double nmse)
{
    for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++)
        for (int method = 0; method < GLINT_FRAME_COUNT; method++)
            for (int i = 0; i < frames->count; i++)
                frames->nmse[figure][light][method][i] = nmse;
}

static glint_frame_errors frames_of(double nmse)
{
    glint_frame_errors frames = {.width = 64, .height = 48, .count = 2, .n = {5, 200}};
    for (int light = 0; light < GLINT_LIGHT_COUNT; light++)
        fill(&frames, light, nmse);
    return frames;
}

static glint_findings *find_frames(const glint_frame_errors *frames)
{
    glint_findings *findings = new_findings();
    glint_frame_errors_find(frames, findings);
    return findings;
}

static void claims_on_frames_follow_their_numbers(void **state)
{
    (void)state;
    const glint_frame_errors good = frames_of(0.00007), bad = frames_of(0.001);
    glint_findings *holding = find_frames(&good), *others = find_frames(&bad);
    all_differ(holding, others, 8 * GLINT_LIGHT_COUNT);
    glint_findings_destroy(holding);
    glint_findings_destroy(others);
}

/* What one scene gives is said of that scene, and of no other. */
static void a_scene_has_its_own_verdict_and_conditions(void **state)
{
    (void)state;
    for (int light = 0; light < GLINT_LIGHT_COUNT; light++) {
        char words[96];
        glint_scene scene = {0};
        glint_frame_errors frames = frames_of(0.00007);
        fill(&frames, light, 0.001);
        glint_findings *findings = find_frames(&frames);
        assert_int_equal(glint_findings_count(findings, GLINT_DOES_NOT_HOLD), 8);
        glint_frame_scene((glint_frame_light)light, &scene);
        const char *highlight =
            scene.highlight[2] == 255 ? "highlight white" : "highlight of the object's colour";
        snprintf(words, sizeof words, "%s, Ka = %g", highlight, (double)scene.ka);
        const glint_finding *found;
        for (int i = 0; (found = glint_findings_get(findings, i)) != NULL; i++)
            assert_int_equal(strstr(found->claim, words) != NULL,
                             found->verdict == GLINT_DOES_NOT_HOLD);
        found = claim(findings, words);
        assert_says(found->conditions, "sphere and teapot, 64x48; object's colour 238,138,32, ");
        assert_says(found->conditions, highlight);
        snprintf(words, sizeof words, "Ka = %g, Kd = 0.5, Ks = 0.5, ", (double)scene.ka);
        assert_says(found->conditions, words);
        assert_says(claim(findings, "n < 170")->conditions, "; n = 5;");
        assert_says(claim(findings, "the other n")->conditions, "; n = 200;");
        assert_says(claim(findings, "Cosine-quadratic: NMSE")->conditions,
                    "; 2 exponents n = 5…200; method cosine-quadratic against blinn");
        assert_says(claim(findings, "The device")->conditions, "method rtl against blinn");
        glint_findings_destroy(findings);
    }
}

static void claims_on_times_follow_their_numbers(void **state)
{
    (void)state;
    glint_findings *findings[3];
    /* 1/1.2 of the time is 20 % more frames a second. */
    static const double ratios[3] = {0.83, 0.84, 0.9};
    for (int i = 0; i < 3; i++) {
        glint_frame_times times = {.width = 64, .height = 48, .count = 1, .n = {5}};
        for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++)
            times.row[figure][GLINT_TIMED_COSINE_QUADRATIC][0] =
                (glint_study_row){.frames = 9, .ratio = ratios[i]};
        findings[i] = new_findings();
        glint_frame_times_find(&times, 3, findings[i]);
        assert_says(glint_findings_get(findings[i], 0)->conditions, "3 threads, 64x48; object's");
        assert_says(glint_findings_get(findings[i], 0)->conditions, "highlight white");
        assert_says(glint_findings_get(findings[i], 0)->conditions, "; n = 5, ");
    }
    all_differ(findings[0], findings[2], GLINT_FIGURE_COUNT);
    assert_int_equal(glint_findings_get(findings[0], 0)->verdict, GLINT_HOLDS);
    assert_int_equal(glint_findings_get(findings[1], 0)->verdict, GLINT_DOES_NOT_HOLD);
    for (int i = 0; i < 3; i++)
        glint_findings_destroy(findings[i]);
}

static void claims_on_speed_follow_their_numbers(void **state)
{
    (void)state;
    glint_findings *findings[2];
    for (int i = 0; i < 2; i++) {
        glint_speeds speeds = {0};
        for (int run = 0; run < GLINT_SPEED_RUNS; run++) {
            const double ratio = i == 0 ? 1.65 + 0.1 * run : 1.64 - 0.1 * run;
            speeds.run[run].scalar_to_schlick[GLINT_FORMULA_COSINE_QUADRATIC] = ratio;
            speeds.run[run].vectorised_to_schlick[GLINT_FORMULA_COSINE_QUADRATIC] = ratio;
        }
        findings[i] = new_findings();
        glint_speeds_find(&speeds, findings[i]);
    }
    all_differ(findings[0], findings[1], 2);
    glint_findings_destroy(findings[0]);
    glint_findings_destroy(findings[1]);
}

/* ---- Energy ---------------------------------------------------------------------------------- */

enum { GRID_N = 2, GRID_ANGLES = 2 };

static const double grid_n[GRID_N] = {3, 40}, grid_angle[GRID_ANGLES] = {0, 60};

/* Albedos of one value at normal incidence and another beside it. */
static glint_energy_table *grid_of(double normal, double beside)
{
    glint_energy_table *table = calloc(1, sizeof *table);
    assert_non_null(table);
    table->plan = (glint_energy_plan){.model_count = GLINT_REFLECTANCE_COUNT,
                                      .n = grid_n,
                                      .n_count = GRID_N,
                                      .angle = grid_angle,
                                      .angle_count = GRID_ANGLES,
                                      .quadrature = true};
    table->cell =
        calloc((size_t)GLINT_REFLECTANCE_COUNT * GRID_N * GRID_ANGLES, sizeof *table->cell);
    assert_non_null(table->cell);
    for (int i = 0; i < (int)GLINT_REFLECTANCE_COUNT * GRID_N * GRID_ANGLES; i++)
        table->cell[i].quadrature = i % GRID_ANGLES == 0 ? normal : beside;
    return table;
}

static glint_energy_results *energy_of(bool good, const glint_energy_table *grid)
{
    glint_energy_results *results = calloc(1, sizeof *results);
    assert_non_null(results);
    glint_energy_normal *normal = &results->normal;
    results->grid = grid;
    results->asymmetry[3] = good ? 1e-15 : 1e-9;
    results->pairs = 77;
    results->pairs_n_count = 2;
    results->pairs_n_first = 4;
    results->pairs_n_last = 6;
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++) {
        normal->w[i] = normal->with_limit[i] = i < (good ? 17 : 19) ? 1.5 : 0.5;
        normal->half_angle[i] = (good ? 1.0 : 1.01) * normal->w[i];
        normal->held[i] = 0.5;
        normal->solid_angle[i] = good ? 0.5 : 0.51;
        normal->blinn[i] = good ? 1.0 : 0.99;
        normal->zero[i] = good ? 5.9 : 4.9;
        normal->claimed[i] = good || i != 500 ? 0.9 : 1.01;
    }
    return results;
}

static void claims_on_energy_follow_their_numbers(void **state)
{
    (void)state;
    glint_findings *findings[2];
    for (int i = 0; i < 2; i++) {
        glint_energy_table *grid = i == 0 ? grid_of(0.9, 0.8) : grid_of(1.1, 1.2);
        glint_energy_results *results = energy_of(i == 0, grid);
        findings[i] = new_findings();
        glint_energy_find(results, findings[i]);
        free(results);
        glint_energy_table_destroy(grid);
    }
    all_differ(findings[0], findings[1], 9);
    assert_int_equal(glint_findings_count(findings[0], GLINT_HOLDS), 9);
    assert_says(claim(findings[0], "reciprocal")->conditions,
                "77 pairs of directions for each model, over 2 exponents n = 4…6");
    assert_says(claim(findings[0], "worst case")->conditions,
                "2 exponents n = 3…40, 2 incidences 0…60°");
    assert_says(claim(findings[1], "24.55")->conditions, "2 cells of the grid");
    assert_says(claim(findings[1], "24.55")->measured, "R > 1 for 1 exponents, n = 501…501");
    glint_findings_destroy(findings[0]);
    glint_findings_destroy(findings[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(claims_on_lobes_follow_their_numbers),
        cmocka_unit_test(ten_times_as_accurate_is_measured),
        cmocka_unit_test(lobes_say_which_n_they_were_measured_at),
        cmocka_unit_test(an_error_at_n_1_is_not_left_out),
        cmocka_unit_test(claims_on_the_divider_follow_their_numbers),
        cmocka_unit_test(a_number_computed_from_the_claim_does_not_prove_it),
        cmocka_unit_test(claims_on_frames_follow_their_numbers),
        cmocka_unit_test(a_scene_has_its_own_verdict_and_conditions),
        cmocka_unit_test(claims_on_times_follow_their_numbers),
        cmocka_unit_test(claims_on_speed_follow_their_numbers),
        cmocka_unit_test(claims_on_energy_follow_their_numbers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
