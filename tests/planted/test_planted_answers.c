/* Whether what watches the answers of a circuit looks at all of them: each value of each point and
 * division differs once, and just that has to be noted. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "backend/backend.h"
#include "backend/divider_backend.h"
#include "circuit/circuits.h"
#include "lockstep/answer.h"
#include "planted.h"

enum { POINTS = 67, DIVISIONS = 7 }; /* points: lanes that are not filled, at the end */

static const glint_material material = {3, 255, 200, 77};
static uint32_t cosine[POINTS]; /* all different, and so are the answers' neighbours */
static glint_division divisions[DIVISIONS];

static int make_questions(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < POINTS; i++)
        cosine[i] = GLINT_COS_ONE - 1000 * i;
    for (int i = 0; i < DIVISIONS; i++) {
        divisions[i] = (glint_division){
            .k = (uint8_t)(i + 1),
            .difference = {(int16_t)(100 + i), (int16_t)(-90 - i), (int16_t)(17 * i)}};
    }
    return 0;
}

static int pull_out(void **state)
{
    (void)state;
    plant.answer = PLANTED_NOWHERE;
    return 0;
}

static void plant_answer(long at, glint_answer_value value)
{
    plant.answer = at;
    plant.value = value;
    plant.asked = 0;
}

static void assert_noted(const glint_answer *answer, glint_answer_value value)
{
    assert_int_equal(answer->value, value);
    assert_int_equal(answer->model ^ answer->rtl, 1);
}

/* What the C model answers. */
static int32_t model_value(uint32_t code, glint_answer_value value)
{
    glint_specular_values v;
    assert_int_equal(glint_specular_eval(GLINT_GATE_COSINE, &material, code, &v), GLINT_OK);
    const int32_t values[] = {(int32_t)v.keys12, v.mul13, v.mul14, v.mul15};
    return values[value];
}

/* ---- The watch of a frame -----------------------------------------------------------------------
 */

static void shade(glint_backend *backend, glint_backend_watch *watch, bool with_w)
{
    uint32_t w[POINTS];
    uint8_t r[POINTS], g[POINTS], b[POINTS];
    glint_error err;
    memset(watch, 0, sizeof *watch);
    glint_backend_set_watch(backend, watch);
    const glint_points points = {cosine, POINTS, with_w ? w : NULL, r, g, b};
    assert_int_equal(glint_backend_shade(backend, &material, &points, &err), GLINT_OK);
}

static void assert_watched(glint_backend *backend, long at, glint_answer_value value)
{
    for (int with_w = 0; with_w <= 1; with_w++) {
        glint_backend_watch watch;
        plant_answer(at, value);
        shade(backend, &watch, with_w);
        assert_int_equal(watch.found, with_w || value != GLINT_ANSWER_W);
        if (watch.found) {
            assert_noted(&watch.answer, value);
            assert_int_equal(watch.answer.cos_code[watch.answer.at], cosine[at]);
            assert_int_equal(watch.answer.model, model_value(cosine[at], value));
        }
        glint_history_destroy(watch.history);
    }
}

static void each_value_of_each_point_is_watched(void **state)
{
    (void)state;
    for (int pipeline = 0; pipeline < GLINT_PIPELINE_COUNT; pipeline++) {
        for (int lanes = 1; lanes <= GLINT_LANES_MAX; lanes *= 2) {
            const glint_backend_config config = {.kind = GLINT_BACKEND_RTL,
                                                 .gate = GLINT_GATE_COSINE,
                                                 .pipeline = (glint_pipeline)pipeline,
                                                 .lanes = lanes};
            glint_backend *backend;
            glint_backend_watch watch;
            glint_error err;
            assert_int_equal(glint_backend_create(&config, &backend, &err), GLINT_OK);
            for (long at = 0; at < POINTS; at++)
                for (int v = 0; v < GLINT_ANSWER_VALUES; v++)
                    assert_watched(backend, at, (glint_answer_value)v);
            plant.answer = PLANTED_NOWHERE;
            shade(backend, &watch, true);
            assert_false(watch.found);
            glint_backend_destroy(backend);
        }
    }
}

static void assert_division_watched(glint_divider_backend *backend, long at, int component)
{
    glint_backend_watch watch = {0};
    glint_quotients quotients[DIVISIONS];
    glint_error err;
    plant_answer(at, (glint_answer_value)(GLINT_ANSWER_R + component));
    glint_divider_backend_set_watch(backend, &watch);
    assert_int_equal(glint_divider_backend_divide(backend, divisions, DIVISIONS, quotients, &err),
                     GLINT_OK);
    assert_true(watch.found);
    assert_noted(&watch.answer, (glint_answer_value)(GLINT_ANSWER_R + component));
    assert_memory_equal(&watch.answer.division[watch.answer.at], &divisions[at],
                        sizeof divisions[at]);
    glint_history_destroy(watch.history);
}

static void each_quotient_of_each_division_is_watched(void **state)
{
    (void)state;
    for (int form = 0; form < GLINT_DIVIDER_FORM_COUNT; form++) {
        for (int n = GLINT_DIVIDER_SHIFTS_MIN; n <= GLINT_DIVIDER_SHIFTS_MAX; n++) {
            const glint_divider_config config = {
                .kind = GLINT_BACKEND_RTL, .form = (glint_divider_form)form, .shifts = n};
            glint_divider_backend *backend;
            glint_error err;
            assert_int_equal(glint_divider_backend_create(&config, &backend, &err), GLINT_OK);
            for (long at = 0; at < DIVISIONS; at++)
                for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
                    assert_division_watched(backend, at, c);
            glint_divider_backend_destroy(backend);
        }
    }
}

/* ---- An answer asked again, for a packet --------------------------------------------------------
 */

static void ask(const glint_answer *answer, const glint_setting *setting, bool planted_there)
{
    int32_t model;
    int32_t rtl;
    glint_error err;
    plant_answer(planted_there ? answer->at : PLANTED_NOWHERE, answer->value);
    assert_int_equal(glint_answer_ask(answer, setting, &model, &rtl, &err), GLINT_OK);
    assert_int_equal(model ^ rtl, planted_there);
    if (setting->circuit == &glint_circuit_specular)
        assert_int_equal(model, model_value(answer->cos_code[answer->at], answer->value));
}

static void each_value_is_asked_again(void **state)
{
    (void)state;
    for (size_t at = 0; at < POINTS; at++) {
        for (int v = 0; v < GLINT_ANSWER_VALUES; v++) {
            const glint_setting setting = glint_setting_specular(
                &(glint_specular_config){GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 4});
            glint_answer answer = {.value = (glint_answer_value)v};
            glint_answer_keep_points(&answer, 4, &material, cosine, POINTS, at);
            ask(&answer, &setting, true);
            ask(&answer, &setting, false);
        }
    }
    for (size_t at = 0; at < DIVISIONS; at++) {
        for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++) {
            for (int form = 0; form < GLINT_DIVIDER_FORM_COUNT; form++) {
                const glint_setting setting = glint_setting_divider((glint_divider_form)form, 12);
                glint_answer answer = {.value = (glint_answer_value)(GLINT_ANSWER_R + c)};
                glint_answer_keep_divisions(&answer, divisions, DIVISIONS, at);
                ask(&answer, &setting, true);
                ask(&answer, &setting, false);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(each_value_of_each_point_is_watched, pull_out),
        cmocka_unit_test_teardown(each_quotient_of_each_division_is_watched, pull_out),
        cmocka_unit_test_teardown(each_value_is_asked_again, pull_out),
    };
    return cmocka_run_group_tests(tests, make_questions, NULL);
}
