/* `glint report --chapter units`: the units' errors against a computation of its own, and sizes as
 * docs/compare.csv has them. */
#define _XOPEN_SOURCE 700

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "file/json.h"
#include "run.h"

static json_t *numbers;

static int make_report(void **state)
{
    char command_line[1200];
    if (scratch_make(state) != 0)
        return -1;
    snprintf(command_line, sizeof command_line, "report --quick --chapter units --out %s",
             scratch_path("report"));
    outcome done = run(command_line, "");
    assert_outcome(&done, 0, "");
    forget(&done);
    char *text = scratch_read(scratch_path("report/index.json"), NULL);
    json_t *json = json_loads(text, JSON_REJECT_DUPLICATES, NULL);
    assert_non_null(json);
    numbers = json_incref(json_object_get(json, "numbers"));
    json_decref(json);
    free(text);
    return 0;
}

static int drop_report(void **state)
{
    json_decref(numbers);
    return scratch_remove(state);
}

static double number(const char *name)
{
    const json_t *item = json_object_get(numbers, name);
    if (!json_is_number(item))
        fail_msg("no number %s", name);
    return json_number_value(item);
}

/* By Schlick's formula without rounding, at the codes that the run took: the unit rounds W to U1.12
 * and so may be half a step of 1/4096 and a little from it. */
static void schlick_is_as_far_from_the_power_as_its_formula(void **state)
{
    (void)state;
    const double codes = 262144.0, stride = number("units.stride");
    double worst = 0.0;
    for (int n = 1; n <= 1000; n++)
        for (double code = 0.0; code <= codes; code += stride) {
            const double c = code / codes;
            worst = fmax(worst, 255.0 * fabs(c / (n - n * c + c) - pow(c, n)));
        }
    assert_true(worst > 40.0);
    assert_true(fabs(number("units.schlick.steps") - worst) < 0.1);
    assert_true(fabs(number("units.newton.steps") - worst) < 0.1);
}

static void the_accurate_units_are_accurate(void **state)
{
    (void)state;
    assert_in_range((int)(1000.0 * number("units.power_half.steps")), 100, 500);
    assert_in_range((int)(1000.0 * number("units.power_quarter.steps")), 50, 250);
    assert_true(number("units.specular_cosine.steps") > 20.0);
    assert_true(number("units.specular_cosine.own") < 0.02);
    assert_true(number("units.power_half.latency") == 5.0);
    assert_true(number("units.specular_cosine.latency") == 4.0);
}

/* The value in the row that begins and ends so. */
static double in_the_file(const char *begin, const char *end)
{
    char *text = scratch_read("docs/compare.csv", NULL), *rest = NULL;
    double value = NAN;
    for (char *line = strtok_r(text, "\n", &rest); line != NULL; line = strtok_r(NULL, "\n", &rest))
        if (strncmp(line, begin, strlen(begin)) == 0 && strstr(line, end) != NULL)
            value = strtod(strrchr(line, ',') + 1, NULL);
    free(text);
    return value;
}

static void sizes_are_those_of_the_comparison(void **state)
{
    (void)state;
    assert_true(number("units.specular_cosine.dsp") > 0.0);
    assert_true(number("units.specular_cosine.dsp") ==
                in_the_file("specular_cosine_pipelined_1,1,18,4,size,xilinx,", ",dsp,"));
    assert_true(number("units.power_half.gates") ==
                in_the_file("power_half_pipelined_1,1,12,5,size,cells,", ",gates,"));
}

/* No smaller one of the table is as accurate. */
static void the_smallest_is_named(void **state)
{
    (void)state;
    const char *best = json_string_value(json_object_get(numbers, "units.best.half"));
    char *text = scratch_read(scratch_path("report/index.md"), NULL);
    assert_non_null(best);
    assert_string_equal(best, "power, accuracy half");
    assert_true(number("units.power_half.gates") < number("units.log2.gates"));
    assert_true(number("units.power_half.gates") < number("units.power_quarter.gates"));
    assert_says(text, "to the last 8-bit level: *power, accuracy half*");
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(schlick_is_as_far_from_the_power_as_its_formula),
        cmocka_unit_test(the_accurate_units_are_accurate),
        cmocka_unit_test(sizes_are_those_of_the_comparison),
        cmocka_unit_test(the_smallest_is_named),
    };
    return cmocka_run_group_tests(tests, make_report, drop_report);
}
