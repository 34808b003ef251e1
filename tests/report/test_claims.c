/* The table of claims: every claim is given a number that keeps its rule and one that breaks it,
 * and must change its verdict; and the measuring code's results for known values. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "report/chapter.h"
#include "report/claims.h"
#include "report/energy.h"
#include "report/frame_errors.h"

/* What the line names, each as a number of its own, but for the one that is there already. */
static void put_named(glint_numbers *numbers, const char *line)
{
    while ((line = strchr(line, '{')) != NULL) {
        char name[128];
        const size_t length = strcspn(++line, ":}");
        assert_true(length < sizeof name);
        memcpy(name, line, length);
        name[length] = '\0';
        if (glint_number_find(numbers, name) == NULL)
            glint_number_put(numbers, 7.0, "%s", name);
    }
}

static glint_judgement judge(const glint_claim *claim, double lowest, double highest)
{
    const double scale = claim->kind == GLINT_PER_CENT ? 100.0 : 1.0;
    glint_numbers numbers = {0};
    glint_judgement judgement;
    glint_error err;
    if (claim->number != NULL)
        glint_number_put_range(&numbers, lowest / scale, highest / scale, "%s", claim->number);
    put_named(&numbers, claim->measured);
    if (glint_claim_judge(claim, &numbers, &judgement, &err) != GLINT_OK)
        fail_msg("%s: %s", claim->words, err.text);
    assert_true(strlen(judgement.measured) < sizeof judgement.measured - 1); /* else it is cut */
    glint_numbers_clear(&numbers);
    return judgement;
}

/* A number on either side of the stated one: `step` at its last decimal or well beyond. */
static void claims_follow_their_numbers(void **state)
{
    (void)state;
    for (int i = 0; i < glint_claim_count; i++) {
        const glint_claim *claim = &glint_claim_table[i];
        const double step = fmax(fabs(claim->stated), 1.0);
        const bool more = claim->rule == GLINT_AT_LEAST || claim->rule == GLINT_ABOVE ||
                          claim->rule == GLINT_REACHES;
        const double good = claim->rule == GLINT_ROUNDS_TO ? claim->stated
                            : more                         ? claim->stated + step
                                                           : claim->stated - step;
        const double bad = more ? claim->stated - step : claim->stated + step;
        if (claim->kind == GLINT_NO_NUMBER)
            continue;
        assert_int_equal(judge(claim, good, good).verdict,
                         claim->kind == GLINT_CIRCULAR ? GLINT_CANNOT_BE_DECIDED : GLINT_HOLDS);
        assert_int_equal(judge(claim, bad, bad).verdict, GLINT_DOES_NOT_HOLD);
        assert_int_equal(judge(claim, fmin(good, bad), fmax(good, bad)).verdict,
                         GLINT_CANNOT_BE_DECIDED);
        assert_int_equal(judge(claim, NAN, NAN).verdict, GLINT_CANNOT_BE_DECIDED);
    }
}

/* Tolerances and counts of what contradicts stand in the words of a claim as "is", "every". */
static bool is_a_limit_of_ours(const glint_claim *claim)
{
    return claim->stated == 0.0 || claim->stated == 1.0 ||
           (claim->rule == GLINT_AT_MOST && claim->stated < 2e-3 &&
            strstr(claim->words, "NMSE") == NULL);
}

static void the_words_have_the_stated_number(void **state)
{
    (void)state;
    for (int i = 0; i < glint_claim_count; i++) {
        const glint_claim *claim = &glint_claim_table[i];
        char stated[64];
        snprintf(stated, sizeof stated, "%.*f", claim->decimals, claim->stated);
        if (claim->stated !=
            round(claim->stated * pow(10.0, claim->decimals)) * pow(10.0, -claim->decimals))
            snprintf(stated, sizeof stated, "%.10g", claim->stated);
        if (claim->kind != GLINT_NO_NUMBER && !is_a_limit_of_ours(claim) &&
            strstr(claim->words, stated) == NULL)
            fail_msg("%s is not in \"%s\"", stated, claim->words);
    }
}

static void a_chapter_has_its_claims_together(void **state)
{
    (void)state;
    int at = 0;
    for (int i = 0; i < glint_claim_count; i++) {
        const glint_claim *claim = &glint_claim_table[i];
        while (at < glint_chapter_count && strcmp(glint_chapters[at].name, claim->chapter) != 0)
            at++;
        if (at == glint_chapter_count)
            fail_msg("%s is not in the order of the chapters", claim->words);
        assert_true(strchr(claim->words, '|') == NULL && strchr(claim->measured, '|') == NULL);
    }
}

static void what_nothing_measured_is_named(void **state)
{
    (void)state;
    const glint_claim claim = {"device", "3.1",       "words",    GLINT_AT_MOST, 1.0,
                               0,        GLINT_PLAIN, "a.number", "{another}"};
    glint_numbers numbers = {0};
    glint_judgement judgement;
    glint_error err;
    assert_int_equal(glint_claim_judge(&claim, &numbers, &judgement, &err), GLINT_BAD_ARGUMENT);
    assert_string_equal(err.text, "nothing measured a.number, for the claim \"words\"");
    glint_number_put(&numbers, 1.0, "a.number");
    assert_int_equal(glint_claim_judge(&claim, &numbers, &judgement, &err), GLINT_BAD_ARGUMENT);
    assert_string_equal(err.text, "the report's text has {another}: nothing measured that");
    glint_numbers_clear(&numbers);
}

/* ---- What chapters make of what they measured ------------------------------------------------ */

static double number(const glint_numbers *numbers, const char *name)
{
    const glint_number *found = glint_number_find(numbers, name);
    if (found == NULL)
        fail_msg("no number %s", name);
    return found->lowest;
}

static void albedos_above_1_are_counted(void **state)
{
    (void)state;
    static double albedo[GLINT_ENERGY_N_MAX];
    glint_numbers numbers = {0};
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++)
        albedo[i] = i >= 2 && i < 19 ? 1.5 - 0.001 * i : 0.5;
    glint_energy_put_curve(&numbers, "w", albedo);
    assert_true(number(&numbers, "energy.w.above") == 17.0);
    assert_true(number(&numbers, "energy.w.above.first") == 3.0);
    assert_true(number(&numbers, "energy.w.above.last") == 19.0);
    assert_true(number(&numbers, "energy.w.largest") == 1.498);
    assert_true(number(&numbers, "energy.w.largest.n") == 3.0);
    assert_true(number(&numbers, "energy.w.at-20") == 0.5);
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++)
        albedo[i] = 1.0;
    glint_energy_put_curve(&numbers, "none", albedo);
    assert_true(number(&numbers, "energy.none.above") == 0.0);
    assert_true(isnan(number(&numbers, "energy.none.above.first")));
    glint_numbers_clear(&numbers);
}

static void the_worst_frame_is_over_both_figures_and_the_n_asked_for(void **state)
{
    (void)state;
    const glint_frame_light light = GLINT_LIGHT_LISTING_OWN;
    const glint_frame_method method = GLINT_FRAME_QUADRATIC;
    glint_frame_errors *errors = calloc(1, sizeof *errors);
    assert_non_null(errors);
    errors->count = 2;
    errors->n[0] = 5;
    errors->n[1] = 200;
    errors->nmse[GLINT_FIGURE_SPHERE][light][method][0] = 0.25;
    errors->nmse[GLINT_FIGURE_TEAPOT][light][method][1] = 0.5;
    glint_worst_frame worst = glint_worst_frame_of(errors, light, method, 1, 1000);
    assert_true(worst.nmse == 0.5 && worst.n == 200 && worst.figure == GLINT_FIGURE_TEAPOT);
    worst = glint_worst_frame_of(errors, light, method, 1, 169);
    assert_true(worst.nmse == 0.25 && worst.n == 5 && worst.figure == GLINT_FIGURE_SPHERE);
    assert_true(isnan(glint_worst_frame_of(errors, light, method, 300, 400).nmse));
    free(errors);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(claims_follow_their_numbers),
        cmocka_unit_test(the_words_have_the_stated_number),
        cmocka_unit_test(a_chapter_has_its_claims_together),
        cmocka_unit_test(what_nothing_measured_is_named),
        cmocka_unit_test(albedos_above_1_are_counted),
        cmocka_unit_test(the_worst_frame_is_over_both_figures_and_the_n_asked_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
