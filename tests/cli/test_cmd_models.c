/* glint models: the list, its errors, and the table of coefficients, as a script would read them.
 */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cjson/cJSON.h>
#include <cmocka.h>
#include <math.h>

#include "../scratch.h"
#include "reflectance/reflectance.h"
#include "run.h"

static void the_list_has_every_model(void **state)
{
    (void)state;
    outcome done = run("models --n 10", "");
    assert_outcome(&done, 0, "");
    assert_says(done.out, "n = 10:");
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++) {
        const glint_reflectance_info *info = glint_reflectance_describe((glint_reflectance_model)i);
        assert_says(done.out, glint_reflectance_names[i]);
        assert_says(done.out, info->formula);
        assert_says(done.out, info->edges);
    }
    forget(&done);
}

static double number(const cJSON *entry, const char *key)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(entry, key);
    assert_true(cJSON_IsNumber(item));
    return item->valuedouble;
}

static void json_has_every_model_and_its_errors(void **state)
{
    (void)state;
    outcome done = run("models --n 10 --level 0.5 --json", "");
    assert_outcome(&done, 0, "");
    cJSON *json = cJSON_Parse(done.out);
    assert_non_null(json);
    assert_true(number(json, "n") == 10 && number(json, "level") == 0.5);
    const cJSON *models = cJSON_GetObjectItemCaseSensitive(json, "models");
    assert_int_equal(cJSON_GetArraySize(models), GLINT_REFLECTANCE_COUNT);
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++) {
        const cJSON *entry = cJSON_GetArrayItem(models, i);
        assert_string_equal(cJSON_GetObjectItemCaseSensitive(entry, "name")->valuestring,
                            glint_reflectance_names[i]);
    }
    /* (2.15) at n = 10: largest where (2·11/3)(1 − 11/3·u) = 10 (1 − u)^9, u = 0.06036. */
    const cJSON *entry = cJSON_GetArrayItem(models, GLINT_REFLECTANCE_COSINE_QUADRATIC);
    assert_true(fabs(number(entry, "largest_error") - 0.0697867) < 1e-6);
    assert_true(fabs(number(entry, "largest_error_cosine") - 0.93964) < 1e-4);
    assert_true(number(entry, "epicentre_relative_error") > number(entry, "epicentre_error"));
    const cJSON *none = cJSON_GetArrayItem(models, GLINT_REFLECTANCE_COOK_TORRANCE);
    assert_null(cJSON_GetObjectItemCaseSensitive(none, "largest_error"));
    cJSON_Delete(json);
    forget(&done);
}

static void coefficients_are_those_of_the_library(void **state)
{
    (void)state;
    outcome done = run("models --coefficients", "");
    assert_outcome(&done, 0, "");
    int rows = 0;
    char *rest = strchr(done.out, '\n') + 1;
    assert_memory_equal(done.out, "n,quadratic_a,", strlen("n,quadratic_a,"));
    for (int n = 1; *rest != '\0'; n++, rows++) {
        assert_true(strtod(rest, &rest) == n);
        assert_true(strtod(rest + 1, &rest) == glint_quadratic_a(n));
        if (n % 100 == 1) {
            assert_true(strtod(rest + 1, &rest) == glint_schlick_power_a(n));
            for (int k = 2; k <= 16; k *= 2) {
                assert_true(strtod(rest + 1, &rest) == glint_lyon_slope_equal(k, n));
                assert_true(strtod(rest + 1, &rest) == glint_lyon_slope_minimax(k, n));
            }
            assert_true(*rest == '\n');
        }
        rest = strchr(rest, '\n') + 1;
    }
    assert_int_equal(rows, 1000);
    forget(&done);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    outcome done = run("models --coefficients --json", "");
    assert_outcome(&done, 2, "glint models: --coefficients is CSV: leave out --json\n");
    forget(&done);
    done = run("models --n 0.5", "");
    assert_outcome(&done, 2, "glint models: --n: \"0.5\" is not a number from 1 to 1e+06\n");
    forget(&done);
    done = run("models --level 1", "");
    assert_outcome(&done, 2, "glint models: --level: \"1\" is not a number from 0.01 to 0.99\n");
    forget(&done);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_list_has_every_model),
        cmocka_unit_test(json_has_every_model_and_its_errors),
        cmocka_unit_test(coefficients_are_those_of_the_library),
        cmocka_unit_test(what_cannot_be_is_refused),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
