/* `glint bench`: its figures as text and as JSON, measured for as short as it can be. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "file/json.h"
#include "run.h"

static void expect_entries(const json_t *json, const char *name, int count, const char *const *keys)
{
    const json_t *list = json_object_get(json, name);
    const json_t *entry;
    assert_int_equal(json_array_size(list), count);
    glint_json_each(entry, list)
    {
        for (int i = 0; keys[i] != NULL; i++) {
            const json_t *value = json_object_get(entry, keys[i]);
            assert_true(json_is_number(value) && json_number_value(value) > 0.0);
        }
    }
}

static void the_json_has_all_parts(void **state)
{
    (void)state;
    static const char *const points[] = {"million_points_per_second", "ratio_to_powf", NULL};
    static const char *const loops[] = {
        "million_points_per_second_scalar", "million_points_per_second_vectorised",
        "scalar_ratio_to_schlick", "vectorised_ratio_to_schlick", NULL};
    static const char *const units[] = {"million_points_per_second_c",
                                        "c_ratio_to_specular",
                                        "million_points_per_second_rtl_1",
                                        "rtl_1_ratio_to_specular",
                                        "million_points_per_second_rtl_4",
                                        "rtl_4_ratio_to_specular",
                                        NULL};
    static const char *const divisions[] = {"million_divisions_per_second", "ratio_to_integer",
                                            "ratio_to_float", NULL};
    static const char *const frames[] = {"width", "height", "fragments", "frames_per_second", NULL};
    outcome done = run("bench --seconds 0.01 --threads 1 --json", "");
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_true(json_is_object(json));
    expect_entries(json, "points", 10, points);
    const json_t *formulas = json_object_get(json, "formulas");
    assert_non_null(strstr(json_string_value(json_object_get(formulas, "compiled")), "-O3"));
    expect_entries(formulas, "loops", 6, loops);
    expect_entries(json, "units", 8, units);
    expect_entries(json, "divisions", 6, divisions);
    expect_entries(json, "frames", 16, frames);
    json_decref(json);
    forget(&done);
}

static void the_text_has_all_parts(void **state)
{
    (void)state;
    static const char *const parts[] = {"points: specular, ",
                                        "\n  powf ",
                                        "\n  rtl-16 ",
                                        "\nformulas: ",
                                        "\n  cosine-quadratic ",
                                        "\nhighlight units: ",
                                        "\n  power ",
                                        "\ndivisions: ",
                                        "\n  integer ",
                                        "\n  rtl-sequential ",
                                        "\n  rtl-pipelined ",
                                        "\nframes: specular, 1 thread,",
                                        "\n  sphere "};
    outcome done = run("bench --seconds 0.01 --threads 1", "");
    assert_outcome(&done, 0, "");
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++)
        assert_says(done.out, parts[i]);
    forget(&done);
}

/* Of the points and of the frames. */
static void another_device_is_measured(void **state)
{
    (void)state;
    outcome done = run("bench --device power --seconds 0.01 --threads 1", "");
    assert_outcome(&done, 0, "");
    assert_says(done.out, "points: power, ");
    assert_says(done.out, "\nframes: power, 1 thread,");
    forget(&done);
    done = run("bench --device lathe --seconds 0.01", "");
    assert_int_equal(done.status, 2);
    assert_says(done.err, "--device");
    forget(&done);
}

/* The others are measured all the same. */
static void a_missing_opengl_has_a_row_that_says_so(void **state)
{
    (void)state;
    scratch_write(scratch_path("libEGL.so.1"), "no library\n", 11);
    assert_int_equal(setenv("LD_LIBRARY_PATH", scratch_directory, 1), 0);
    outcome done = run("bench --seconds 0.01 --threads 1", "");
    assert_outcome(&done, 0, "");
    assert_says(done.out, " gl    backend gl: libEGL.so.1 is missing: install libegl1 and "
                          "libgl1-mesa-dri\n  sphere   640x480   c ");
    forget(&done);
    assert_int_equal(unsetenv("LD_LIBRARY_PATH"), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_json_has_all_parts),
        cmocka_unit_test(the_text_has_all_parts),
        cmocka_unit_test(another_device_is_measured),
        cmocka_unit_test(a_missing_opengl_has_a_row_that_says_so),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
