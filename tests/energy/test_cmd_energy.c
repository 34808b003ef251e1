/* `glint energy`: its tables, its summary, and what it refuses. */
#define _XOPEN_SOURCE 700

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "file/json.h"
#include "image/image.h"

#include "../scratch.h"

#include "../cli/run.h"

static outcome energy(const char *options)
{
    char command_line[1200];
    snprintf(command_line, sizeof command_line, "energy --out %s %s", scratch_path("energy"),
             options);
    return run(command_line, "");
}

static char *file_of(const char *name)
{
    char inside[128];
    snprintf(inside, sizeof inside, "energy/%s", name);
    return scratch_read(scratch_path(inside), NULL);
}

/* The row "n,angle,…" of a table; the numbers after the two. */
static int find_row(const char *table, const char *row, double value[3])
{
    char wanted[64];
    snprintf(wanted, sizeof wanted, "\n%s,", row);
    const char *found = strstr(table, wanted);
    assert_non_null(found);
    return sscanf(found + strlen(wanted), "%lf,%lf,%lf", &value[0], &value[1], &value[2]);
}

static void a_table_has_every_cell_by_both_methods(void **state)
{
    (void)state;
    double value[3];
    outcome done = energy("--model blinn,lambert --n 1,40 --angle 0..60:30 --method both "
                          "--samples 4000 --seed 3");
    assert_outcome(&done, 0, "");
    assert_says(done.out, "seed 3, 4000 samples a cell\n");
    assert_says(done.out, "blinn                     R up to 2.860285 (n = 1, 0°), above 1 for 1 n "
                          "(1…1); of 6 cells ");
    assert_says(done.out, "lambert                   R up to 1.0000");
    assert_says(done.out, "never above 1; of 6 cells 100.00, ");
    forget(&done);
    char *table = file_of("albedo-blinn.csv");
    assert_int_equal(strncmp(table, "n,angle,quadrature,monte_carlo,standard_error\n", 46), 0);
    int rows = 0;
    for (const char *c = table; *c != '\0'; c++)
        rows += *c == '\n';
    assert_int_equal(rows, 7);
    static const char *const cells[] = {"1,0", "1,30", "1,60", "40,0", "40,30", "40,60"};
    for (int i = 0; i < 6; i++) {
        assert_int_equal(find_row(table, cells[i], value), 3);
        assert_true(value[2] > 0.0 && fabs(value[0] - value[1]) < 5.0 * value[2]);
    }
    find_row(table, "1,0", value);
    assert_true(fabs(value[0] - 2.86028487) < 1e-8);
    free(table);
}

static void one_method_gives_its_columns_only(void **state)
{
    (void)state;
    double value[3];
    outcome done = energy("--model phong --n 8 --angle 0");
    assert_outcome(&done, 0, "");
    forget(&done);
    char *table = file_of("albedo-phong.csv");
    assert_string_equal(table, "n,angle,quadrature\n8,0,0.628318531\n"); /* 2π/10 */
    free(table);
    done = energy("--model phong --n 8 --angle 0 --method monte-carlo --samples 1000");
    assert_outcome(&done, 0, "");
    forget(&done);
    table = file_of("albedo-phong.csv");
    assert_int_equal(find_row(table, "8,0", value), 2);
    assert_true(fabs(value[0] - 0.628318531) < 8.0 * value[1]);
    free(table);
}

static void the_json_says_where_it_is_above_one(void **state)
{
    (void)state;
    outcome done = run("energy --model energy-conserving --n 1..50 --angle 0,45 --json", "");
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    const json_t *model = json_array_get(json_object_get(json, "models"), 0);
    assert_string_equal(json_string_value(json_object_get(model, "model")), "energy-conserving");
    assert_int_equal(json_integer_value(json_object_get(model, "first_above_1")), 7);
    assert_int_equal(json_integer_value(json_object_get(model, "last_above_1")), 50);
    assert_int_equal(json_integer_value(json_object_get(model, "exponents_above_1")), 44);
    assert_int_equal(json_integer_value(json_object_get(model, "largest_n")), 17);
    assert_int_equal(json_integer_value(json_object_get(json, "exponents")), 50);
    json_decref(json);
    forget(&done);
}

static void the_furnace_is_a_picture(void **state)
{
    (void)state;
    glint_image *image;
    outcome done = energy("--furnace --width 20 --model lambert,blinn --angle 0..80:20");
    assert_outcome(&done, 0, "");
    forget(&done);
    assert_int_equal(glint_image_read_png(scratch_path("energy/furnace.png"), &image, NULL),
                     GLINT_OK);
    assert_int_equal(image->width, 7 * 22 + 2);
    assert_int_equal(image->height, 2 * 22 + 2);
    size_t red = 0;
    for (int i = 0; i < image->width * image->height; i++) {
        const bool colored = image->rgb[3 * i] != image->rgb[3 * i + 2];
        red += colored;
        assert_true(!colored || i / image->width >= 22); /* not Lambert's row */
    }
    assert_true(red > 300);
    glint_image_destroy(image);
}

static void lists_are_read_strictly(void **state)
{
    (void)state;
    static const char *const refused[] = {",",
                                          "1,",
                                          ",1",
                                          "2,1",
                                          "1,1",
                                          "1..",
                                          "..5",
                                          "5..1",
                                          "1..5:",
                                          "1..5:0",
                                          "1..2..3",
                                          "-1..3",
                                          "x",
                                          "1.5..3",
                                          "0x5",
                                          "1..3,3",
                                          "1..5:1:1",
                                          "nan",
                                          "1;2",
                                          "1000001",
                                          "1..1000001:1000",
                                          "99999999999999999999"};
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        char command_line[64], expected[128];
        snprintf(command_line, sizeof command_line, "energy --n %s", refused[i]);
        snprintf(expected, sizeof expected,
                 "glint energy: --n: \"%s\" is not an ascending list of exponents from 0 to "
                 "1000000, such as 1..1000 or "
                 "1,5,80\n",
                 refused[i]);
        outcome done = run(command_line, "");
        assert_outcome(&done, 2, expected);
        forget(&done);
    }
    outcome done = energy("--model quadratic --n 1,1.5,2..10:4,11,13..14 --angle 0");
    assert_outcome(&done, 0, "");
    forget(&done);
    static const char *const taken[] = {"1,0",  "1.5,0", "2,0",  "6,0",
                                        "10,0", "11,0",  "13,0", "14,0"};
    char *table = file_of("albedo-quadratic.csv");
    int rows = 0;
    for (const char *c = table; *c != '\0'; c++)
        rows += *c == '\n';
    assert_int_equal(rows, 9);
    for (size_t i = 0; i < sizeof taken / sizeof taken[0]; i++) {
        double value[3];
        assert_int_equal(find_row(table, taken[i], value), 1);
    }
    free(table);
}

#define MODELS                                                                                     \
    "; choose from lambert, phong, blinn, blinn-normalized, torrance-sparrow, cook-torrance, "     \
    "schlick, schlick-modified, schlick-modified-angle, schlick-modified-linear, "                 \
    "schlick-modified-squared, schlick-modified-power, quadratic, cosine-quadratic, "              \
    "energy-conserving, lyon-2-minimax, lyon-4, lyon-4-minimax, lyon-8, lyon-8-minimax, lyon-16, " \
    "lyon-16-minimax, log2-n, device\n"

static void the_command_line_is_read_strictly(void **state)
{
    (void)state;
    static const struct {
        const char *command_line, *err;
    } refusals[] = {
        {"energy --model blin",
         "glint energy: --model: \"blin\" is not a reflectance model (did you mean "
         "blinn?)" MODELS},
        {"energy --model blinn,", "glint energy: --model: \"\" is not a reflectance model" MODELS},
        {"energy --model blinn,device,blinn", "glint energy: --model: blinn is given twice\n"},
        {"energy --n 5,4",
         "glint energy: --n: \"5,4\" is not an ascending list of exponents from 0 to "
         "1000000, such as 1..1000 or "
         "1,5,80\n"},
        {"energy --angle 90",
         "glint energy: --angle: \"90\" is not an ascending list of degrees from 0 to "
         "89.9999, such as 0..89 or "
         "0,45\n"},
        {"energy --angle 89.99999", "glint energy: --angle: \"89.99999\" is not an ascending list "
                                    "of degrees from 0 to 89.9999, such as 0..89 or 0,45\n"},
        {"energy --n 1e7", "glint energy: --n: \"1e7\" is not an ascending list of exponents from "
                           "0 to 1000000, such as "
                           "1..1000 or 1,5,80\n"},
        {"energy --samples 5",
         "glint energy: --samples and --seed need --method monte-carlo or both\n"},
        {"energy --furnace", "glint energy: --furnace needs --out\n"},
        {"energy --furnace --out x --method monte-carlo",
         "glint energy: --furnace needs quadrature: use --method quadrature or both\n"},
        {"energy --furnace --out x --n 1..400",
         "glint energy: --furnace: 400 spheres side by side are too many (fewer than 150 fit)\n"},
        {"energy --width 50", "glint energy: --width needs --furnace\n"},
    };
    for (size_t i = 0; i < sizeof refusals / sizeof refusals[0]; i++) {
        outcome done = run(refusals[i].command_line, "");
        assert_outcome(&done, 2, refusals[i].err);
        assert_string_equal(done.out, "");
        forget(&done);
    }
}

/* Before anything is integrated, and not after an hour of the models before. */
static void an_exponent_outside_a_model_is_refused(void **state)
{
    (void)state;
    static const struct {
        const char *options, *err;
    } refusals[] = {
        {"energy --n 0,1 --angle 0",
         "glint energy: --n: model schlick takes numbers from 1 to 1e+06, not 0\n"},
        {"energy --n 1,1024 --angle 0",
         "glint energy: --n: model device takes integers from 0 to 1023, not 1024\n"},
        {"energy --model device --n 1.5 --angle 0",
         "glint energy: --n: model device takes integers from 0 to 1023, not 1.5\n"},
    };
    for (size_t i = 0; i < sizeof refusals / sizeof refusals[0]; i++) {
        outcome done = run(refusals[i].options, "");
        assert_outcome(&done, 2, refusals[i].err);
        assert_string_equal(done.out, "");
        forget(&done);
    }
    outcome done = run("energy --model device,blinn --n 0,1023 --angle 0", "");
    assert_outcome(&done, 0, "");
    forget(&done);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_table_has_every_cell_by_both_methods),
        cmocka_unit_test(one_method_gives_its_columns_only),
        cmocka_unit_test(the_json_says_where_it_is_above_one),
        cmocka_unit_test(the_furnace_is_a_picture),
        cmocka_unit_test(lists_are_read_strictly),
        cmocka_unit_test(an_exponent_outside_a_model_is_refused),
        cmocka_unit_test(the_command_line_is_read_strictly),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
