/* glint models: the list, its errors, and the table of coefficients, as a script would read them.
 */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "../scratch.h"
#include "file/json.h"
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

static double number(const json_t *entry, const char *key)
{
    const json_t *item = json_object_get(entry, key);
    assert_true(json_is_number(item));
    return json_number_value(item);
}

static void json_has_every_model_and_its_errors(void **state)
{
    (void)state;
    outcome done = run("models --n 10 --level 0.5 --json", "");
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    assert_true(number(json, "n") == 10 && number(json, "level") == 0.5);
    const json_t *models = json_object_get(json, "models");
    assert_int_equal(json_array_size(models), GLINT_REFLECTANCE_COUNT);
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++) {
        const json_t *entry = json_array_get(models, (size_t)i);
        assert_string_equal(json_string_value(json_object_get(entry, "name")),
                            glint_reflectance_names[i]);
    }
    /* (2.15) at n = 10: largest where (2·11/3)(1 − 11/3·u) = 10 (1 − u)^9, u = 0.06036. */
    const json_t *entry = json_array_get(models, (size_t)GLINT_REFLECTANCE_COSINE_QUADRATIC);
    assert_true(fabs(number(entry, "largest_error") - 0.0697867) < 1e-6);
    assert_true(fabs(number(entry, "largest_error_cosine") - 0.93964) < 1e-4);
    assert_true(number(entry, "epicentre_relative_error") > number(entry, "epicentre_error"));
    const json_t *none = json_array_get(models, (size_t)GLINT_REFLECTANCE_COOK_TORRANCE);
    assert_null(json_object_get(none, "largest_error"));
    json_decref(json);
    forget(&done);
}

/* However long the numbers are: of n = 1e6 some are in the thousands. */
static void columns_are_apart(void **state)
{
    (void)state;
    enum { NUMBERS_AT = 46 }; /* after the name and the equation */
    outcome done = run("models --n 1e6", "");
    assert_outcome(&done, 0, "");
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++) {
        char start[64];
        snprintf(start, sizeof start, "\n%s ", glint_reflectance_names[i]);
        const char *line = strstr(done.out, start);
        assert_non_null(line);
        line += 1 + NUMBERS_AT;
        for (int column = 0; column < 3; column++) {
            assert_true(*line == ' ');
            line += strspn(line, " ");
            const size_t length = strcspn(line, " ");
            const char *point = memchr(line, '.', length);
            assert_true((length == 1 && *line == '-') ||
                        (point != NULL && line + length == point + 6));
            line += length;
        }
    }
    forget(&done);
}

/* (2.8) as it is printed, in a longer double: what it loses there is out of sight here. */
static double printed_a(int n)
{
    const long double t = cosl(atanl(1.0L / sqrtl((long double)n - 1.0L)));
    return n == 1 ? 0.0 : (double)((powl(t, (long double)n - 1.0L) - 1.0L) / (t - 1.0L));
}

/* The largest relative error of cos^a/(n − n cos + cos) where cosⁿ ≥ 0.6. */
static double error_of_power(int n, double a)
{
    const double end = pow(0.6, 1.0 / n);
    double largest = 0.0;
    for (int i = 0; i <= 20000; i++) {
        const double c = 1.0 - (1.0 - end) * i / 20000;
        largest = fmax(largest, fabs(pow(c, a - n) / (n - n * c + c) - 1.0));
    }
    return largest;
}

/* How far the lobe is above cosⁿ at most, less how far it is below: 0 for the best width, as a
 * wider one is above by more and below by less. */
static double imbalance_of(int n, int k, double slope)
{
    double above = 0.0, below = 0.0;
    const double end = fmin(1.0, 10.0 / n);
    for (int i = 0; i <= 20000; i++) {
        const double u = end * i / 20000;
        const double apart = pow(fmax(0.0, 1.0 - slope * u), k) - exp(n * log1p(-u));
        above = fmax(above, apart);
        below = fmax(below, -apart);
    }
    return above - below;
}

static double next_number(char **rest)
{
    char *end;
    const double number = strtod(*rest + 1, &end);
    assert_true(end > *rest + 1);
    *rest = end;
    return number;
}

/* Against what defines them, computed here. */
static void coefficients_are_what_defines_them(void **state)
{
    (void)state;
    outcome done = run("models --coefficients", "");
    assert_outcome(&done, 0, "");
    int rows = 0;
    char *rest = strchr(done.out, '\n');
    assert_memory_equal(done.out, "n,quadratic_a,", strlen("n,quadratic_a,"));
    for (int n = 1; rest[1] != '\0'; n++, rows++) {
        assert_true(next_number(&rest) == n);
        assert_true(fabs(next_number(&rest) - printed_a(n)) <= 1e-12 * n);
        const double power = next_number(&rest);
        if (n % 100 == 1 && n > 1) {
            const double best = error_of_power(n, power);
            assert_true(best < error_of_power(n, power * 0.9999));
            assert_true(best < error_of_power(n, power * 1.0001));
        }
        for (int k = 2; k <= 16; k *= 2) {
            const double equal = next_number(&rest), best = next_number(&rest);
            assert_true(fabs(equal - (n + 1.0) / (k + 1.0)) <= 1e-15 * n);
            if (n % 100 == 1 && n > 1) {
                assert_true(fabs(imbalance_of(n, k, best)) < 1e-6);
                assert_true(imbalance_of(n, k, best * 0.999) > 1e-5);
                assert_true(imbalance_of(n, k, best * 1.001) < -1e-5);
            }
        }
        assert_true(*rest == '\n');
    }
    assert_int_equal(rows, 1000);
    forget(&done);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    outcome done = run("models --coefficients --json", "");
    assert_outcome(&done, 2,
                   "glint models: --coefficients prints CSV: it cannot be used with --json\n");
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
        cmocka_unit_test(columns_are_apart),
        cmocka_unit_test(coefficients_are_what_defines_them),
        cmocka_unit_test(what_cannot_be_is_refused),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
