/* `glint divide`: its input line by line, and its answers against rational arithmetic in integers;
 * nothing of Glint's own is called. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/resource.h>

#include <cmocka.h>

#include "../scratch.h"
#include "file/json.h"
#include "run.h"

#define HEADER "difference,k,shifts,quotient_code,quotient,exact,error\n"

static void assert_answer(const char *options, const char *input, const char *expected)
{
    char command_line[128];
    snprintf(command_line, sizeof command_line, "divide%s%s", *options != '\0' ? " " : "", options);
    outcome done = run(command_line, input);
    assert_outcome(&done, 0, "");
    assert_string_equal(done.out, expected);
    forget(&done);
}

/* The thesis's example, and figures that can be checked by eye. */
static void a_division_is_answered(void **state)
{
    (void)state;
    static const char *const backends[] = {
        "--shifts 6", "--backend c --shifts 6", "--backend rtl --shifts 6",
        "--backend rtl --form sequential --shifts 6", "--backend rtl --form pipelined --shifts 6"};
    for (size_t i = 0; i < 5; i++) {
        assert_answer(backends[i], "255 7\n",
                      HEADER "255,7,6,2295,35.859375,36.42857142857143,-0.5691964285714286\n");
        assert_answer(backends[i], "-3 16\n-255 1\n0 5\n",
                      HEADER "-3,16,6,-12,-0.1875,-0.1875,0\n-255,1,6,-16320,-255,-255,0\n"
                             "0,5,6,0,0,0,0\n");
    }
    assert_answer("", "1 2\n", HEADER "1,2,12,2048,0.5,0.5,0\n");
    assert_answer("--shifts 16", "-255 1\n", HEADER "-255,1,16,-16711680,-255,-255,0\n");
}

static void real_is_exact_division_rounded_half_up(void **state)
{
    (void)state;
    /* 255·64/7 = 2331.4, 5·64/3 = 106.7, ±64/12 = ±5.3 */
    outcome done = run("divide --backend real --shifts 6", "255 7\n5 3\n1 12\n-1 12\n-3 16\n");
    assert_outcome(&done, 0, "");
    assert_says(done.out, "\n255,7,6,2331,");
    assert_says(done.out, "\n5,3,6,107,");
    assert_says(done.out, "\n1,12,6,5,");
    assert_says(done.out, "\n-1,12,6,-5,");
    assert_says(done.out, "\n-3,16,6,-12,-0.1875,-0.1875,0\n");
    forget(&done);
}

static void the_input_is_read_generously_in_its_blanks(void **state)
{
    (void)state;
    static const char *const inputs[] = {
        "12 3\n",        "12,3\n",         "12 , 3\n",
        " \t12\t3 \t\n", "12 3",           "12 3\r\n",
        "12 3\r",        "\n\n12 3\n",     "# a comment\n12 3\n#\n",
        " \r\n+12 3\n",  "  # 1 2\n12 03", "0012\t\t,\t003\n",
    };
    for (size_t i = 0; i < sizeof inputs / sizeof inputs[0]; i++)
        assert_answer("--shifts 8", inputs[i], HEADER "12,3,8,1020,3.984375,4,-0.015625\n");
}

static void what_divide_prints_divide_takes(void **state)
{
    (void)state;
    outcome done = run("divide --shifts 6", "255 7\n-3 16\n0 1\n");
    outcome again = run("divide --shifts 6", done.out);
    outcome finer = run("divide", done.out);
    assert_outcome(&done, 0, "");
    assert_outcome(&again, 0, "");
    assert_string_equal(again.out, done.out);
    assert_says(finer.out, "\n255,7,12,");
    forget(&done);
    forget(&again);
    forget(&finer);
}

/* Seconds of a processor that finished children took. */
static double children_seconds(void)
{
    struct rusage usage;
    assert_int_equal(getrusage(RUSAGE_CHILDREN, &usage), 0);
    return (double)usage.ru_utime.tv_sec + 1e-6 * (double)usage.ru_utime.tv_usec;
}

static int lines_in(const char *text)
{
    int count = 0;
    for (const char *c = text; *c != '\0'; c++)
        count += *c == '\n';
    return count;
}

static double seconds_of(const char *command_line, const char *input)
{
    const double before = children_seconds();
    outcome done = run(command_line, input);
    assert_outcome(&done, 0, "");
    assert_int_equal(lines_in(done.out), 1 + lines_in(input));
    forget(&done);
    return children_seconds() - before;
}

/* A row of divide costs about what one of eval does: 1.1 to 1.5 times, and once 16 times. */
static void a_row_costs_no_more_than_its_like(void **state)
{
    (void)state;
    enum { ROWS = 300000, LENGTH = 24 };
    char *divisions = malloc(ROWS * LENGTH + 1), *points = malloc(ROWS * LENGTH + 1);
    assert_non_null(divisions);
    assert_non_null(points);
    size_t d = 0, p = 0;
    for (int i = 0; i < ROWS; i++) {
        d += (size_t)snprintf(divisions + d, LENGTH, "%d %d\n", i % 511 - 255, i / 511 % 16 + 1);
        p += (size_t)snprintf(points + p, LENGTH, "80 %.5f 255 190 110\n", i / (double)ROWS);
    }
    const double of_points = seconds_of("eval", points);
    const double of_divisions = seconds_of("divide", divisions);
    if (of_divisions > 4.0 * of_points)
        fail_msg("%d divisions %.2f s, as many points %.2f s", ROWS, of_divisions, of_points);
    free(divisions);
    free(points);
}

static void an_empty_input_has_no_rows(void **state)
{
    (void)state;
    assert_answer("", "", HEADER);
    assert_answer("", "# nothing\n\n", HEADER);
    assert_answer("--json", "", "[\n]\n");
}

typedef struct refusal {
    const char *input;
    size_t count; /* 0: the string's length */
    const char *err;
} refusal;

static void malformed_lines_are_named(void **state)
{
    (void)state;
    static const refusal refusals[] = {
        {"1\n", 0, "line 1: fewer than two values (difference k)"},
        {"1 2 3\n", 0, "line 1: more than two values (difference k)"},
        {"1 2 # comment\n", 0, "line 1: more than two values (difference k)"},
        {"1;2\n", 0, "line 1: fewer than two values (difference k)"},
        {"1\r2\n", 0, "line 1: fewer than two values (difference k)"},
        {"difference,length\n", 0, "line 1: this header has no column k"},
        {"difference,k\ndifference,k\n", 0,
         "line 2: difference: \"difference\" is not an integer from -255 to 255"},
        {"k,difference\n17,0\n", 0, "line 2: k = 17 is not in the table (1 to 16)"},
        {"256 2", 0, "line 1: difference: \"256\" is not an integer from -255 to 255"},
        {"-256 2", 0, "line 1: difference: \"-256\" is not an integer from -255 to 255"},
        {"1.0 2", 0, "line 1: difference: \"1.0\" is not an integer from -255 to 255"},
        {"0x1 2", 0, "line 1: difference: \"0x1\" is not an integer from -255 to 255"},
        {"99999999999999999999 2", 0,
         "line 1: difference: \"99999999999999999999\" is not an integer from -255 to 255"},
        {",2", 0, "line 1: difference: \"\" is not an integer from -255 to 255"},
        {"1,,2", 0, "line 1: more than two values (difference k)"},
        {"1,", 0, "line 1: k: \"\" is not an integer from 0 to 255"},
        {"1 2,", 0, "line 1: more than two values (difference k)"},
        {"1 256", 0, "line 1: k: \"256\" is not an integer from 0 to 255"},
        {"1 -1", 0, "line 1: k: \"-1\" is not an integer from 0 to 255"},
        {"1 k", 0, "line 1: k: \"k\" is not an integer from 0 to 255"},
        {"1 2\0 3\n", 7, "line 1: contains a NUL byte: not text"},
        {"# \0\n", 4, "line 1: contains a NUL byte: not text"},
        {"1 0\n", 0, "line 1: k = 0 is not in the table (1 to 16)"},
        {"1 17\n", 0, "line 1: k = 17 is not in the table (1 to 16)"},
        {"0 255\n", 0, "line 1: k = 255 is not in the table (1 to 16)"},
        {"\n\n# c\n1 20\n1 2 3\n", 0, "line 4: k = 20 is not in the table (1 to 16)"},
        {"\n\n# c\n1 2 3\n1 20\n", 0, "line 4: more than two values (difference k)"},
    };
    const plumbing none = {0};
    for (size_t i = 0; i < sizeof refusals / sizeof refusals[0]; i++) {
        char expected[256];
        char *argv[] = {NULL, "divide", NULL};
        const size_t count = refusals[i].count != 0 ? refusals[i].count : strlen(refusals[i].input);
        snprintf(expected, sizeof expected, "glint divide: %s\n", refusals[i].err);
        outcome done = run_arguments(argv, refusals[i].input, count, &none);
        assert_outcome(&done, 2, expected);
        assert_string_equal(done.out, HEADER);
        forget(&done);
    }
}

/* Every k that the input can have is answered or refused, by every backend and form. */
static void no_k_is_silently_wrong(void **state)
{
    (void)state;
    static const char *const options[] = {"c", "real", "rtl --form sequential",
                                          "rtl --form pipelined"};
    for (size_t i = 0; i < 4; i++) {
        for (int k = 0; k < 256; k += k < 17 ? 1 : 17) {
            char command_line[64], input[32], expected[96];
            snprintf(command_line, sizeof command_line, "divide --backend %s", options[i]);
            snprintf(input, sizeof input, "100 %d\n", k);
            snprintf(expected, sizeof expected,
                     "glint divide: line 1: k = %d is not in the table (1 to 16)\n", k);
            const bool in_table = k >= 1 && k <= 16;
            outcome done = run(command_line, input);
            assert_outcome(&done, in_table ? 0 : 2, in_table ? "" : expected);
            assert_int_equal(strlen(done.out) > strlen(HEADER), in_table);
            forget(&done);
        }
    }
}

static void lines_before_the_refused_one_are_answered(void **state)
{
    (void)state;
    static const char *const rows = HEADER "8,4,12,8192,2,2,0\n8,4,12,8192,2,2,0\n";
    outcome done = run("divide", "8 4\n8 4\n8\n8 4\n");
    assert_outcome(&done, 2, "glint divide: line 3: fewer than two values (difference k)\n");
    assert_string_equal(done.out, rows);
    forget(&done);
    done = run("divide", "8 4\n8 4\n8 17\n8 4\n");
    assert_outcome(&done, 2, "glint divide: line 3: k = 17 is not in the table (1 to 16)\n");
    assert_string_equal(done.out, rows);
    forget(&done);
}

static void long_lines_are_read_to_their_end(void **state)
{
    (void)state;
    enum { LENGTH = 2000000 };
    char *line = malloc(LENGTH + 32);
    assert_non_null(line);
    memset(line, ' ', LENGTH);
    strcpy(line + LENGTH, "8 4\n");
    assert_answer("", line, HEADER "8,4,12,8192,2,2,0\n");
    memset(line, '7', LENGTH);
    outcome done = run("divide", line);
    assert_int_equal(done.status, 2);
    assert_true(strlen(done.err) < 200);
    assert_says(done.err, "777...\" is not an integer from -255 to 255\n");
    forget(&done);
    free(line);
}

static void json_is_an_array_of_objects(void **state)
{
    (void)state;
    static const char *const names[] = {"difference", "k",     "shifts", "quotient_code",
                                        "quotient",   "exact", "error"};
    static const double values[2][7] = {{255, 7, 6, 2295, 35.859375, 255.0 / 7.0, -4080.0 / 7168.0},
                                        {-8, 4, 6, -128, -2, -2, 0}};
    outcome done = run("divide --json --shifts 6", "255 7\n-8 4\n");
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_true(json_is_array(json));
    assert_int_equal(json_array_size(json), 2);
    for (int i = 0; i < 2; i++) {
        const json_t *row = json_array_get(json, (size_t)i);
        assert_int_equal(json_object_size(row), 7);
        for (int j = 0; j < 7; j++) {
            const json_t *value = json_object_get(row, names[j]);
            assert_true(json_is_number(value));
            assert_true(json_number_value(value) == values[i][j]);
        }
    }
    json_decref(json);
    forget(&done);
}

static void options_are_read_strictly(void **state)
{
    (void)state;
    static const struct {
        const char *command_line, *err;
    } refusals[] = {
        {"divide --shifts 5", "glint divide: --shifts: \"5\" is not an integer from 6 to 16\n"},
        {"divide --shifts 17", "glint divide: --shifts: \"17\" is not an integer from 6 to 16\n"},
        {"divide --backend both", "glint divide: --backend: \"both\" is not one of c, rtl, real\n"},
        {"divide --form drawn",
         "glint divide: --form: \"drawn\" is not one of sequential, pipelined\n"},
        {"divide x", "glint divide: unexpected argument \"x\"\n"},
    };
    for (size_t i = 0; i < sizeof refusals / sizeof refusals[0]; i++) {
        outcome done = run(refusals[i].command_line, "");
        assert_outcome(&done, 2, refusals[i].err);
        assert_string_equal(done.out, "");
        forget(&done);
    }
}

static void an_unreadable_input_is_a_failure(void **state)
{
    (void)state;
    const plumbing directory = {.in = "."};
    outcome done = run_plumbed("divide", "", &directory);
    assert_outcome(&done, 2, "glint divide: cannot read standard input: Is a directory\n");
    forget(&done);
}

static void output_that_is_not_taken_is_a_failure(void **state)
{
    (void)state;
    const plumbing full = {.out = "/dev/full"};
    outcome done = run_plumbed("divide", "8 4\n", &full);
    assert_outcome(&done, 2,
                   "glint divide: cannot write to standard output: No space left on device\n");
    forget(&done);
}

/* ---- every division ---- */

/* Every k with every difference; k_inside: k changes from line to line. To be freed. */
static char *all_divisions(bool k_inside)
{
    char *text = malloc(16 * 511 * 12 + 1);
    assert_non_null(text);
    size_t length = 0;
    for (int i = 0; i < 16 * 511; i++) {
        const int k = k_inside ? i % 16 + 1 : i / 511 + 1;
        const int difference = (k_inside ? i / 16 : i % 511) - 255;
        length += (size_t)sprintf(text + length, "%d %d\n", difference, k);
    }
    return text;
}

/* The row that the definition gives: bits by rounding 2ⁿ/k, all else as rationals. */
static void check_row(const char *row, const char *division, int shifts)
{
    int difference, k, found_difference, found_k, found_shifts;
    int64_t code;
    double quotient, exact, error;
    assert_int_equal(sscanf(division, "%d %d", &difference, &k), 2);
    assert_int_equal(sscanf(row, "%d,%d,%d,%" SCNd64 ",%lf,%lf,%lf", &found_difference, &found_k,
                            &found_shifts, &code, &quotient, &exact, &error),
                     7);
    const int64_t one = INT64_C(1) << shifts;
    int64_t bits = one / k;
    if (2 * (one - bits * k) >= k)
        bits++;
    assert_int_equal(found_difference, difference);
    assert_int_equal(found_k, k);
    assert_int_equal(found_shifts, shifts);
    assert_int_equal(code, bits * difference);
    assert_true(quotient * (double)one == (double)code);
    assert_true(exact == (double)difference / (double)k);
    assert_true(error == (double)(code * k - difference * one) / (double)(k * one));
    /* The bound that the table gives: half a last place for each unit of the difference. */
    assert_true(2 * llabs(code * k - difference * one) <= llabs(difference) * k);
}

static void check_rows(const char *out, const char *divisions, int shifts)
{
    assert_memory_equal(out, HEADER, strlen(HEADER));
    const char *row = out + strlen(HEADER);
    const char *division = divisions;
    while (*division != '\0') {
        check_row(row, division, shifts);
        row = strchr(row, '\n') + 1;
        division = strchr(division, '\n') + 1;
    }
    assert_string_equal(row, "");
}

static outcome divide_all(const char *options, int shifts, const char *divisions)
{
    char command_line[128];
    snprintf(command_line, sizeof command_line, "divide --shifts %d --backend %s", shifts, options);
    outcome done = run(command_line, divisions);
    assert_outcome(&done, 0, "");
    assert_int_equal(lines_in(done.out), 1 + lines_in(divisions));
    return done;
}

static void every_division_follows_the_definition(void **state)
{
    (void)state;
    char *divisions = all_divisions(false);
    for (int shifts = 6; shifts <= 16; shifts++) {
        outcome done = divide_all("c", shifts, divisions);
        check_rows(done.out, divisions, shifts);
        forget(&done);
    }
    free(divisions);
}

static void c_and_rtl_agree_on_every_division(void **state)
{
    (void)state;
    static const char *const forms[] = {"rtl --form sequential", "rtl --form pipelined"};
    for (int order = 0; order < 2; order++) {
        char *divisions = all_divisions(order == 1);
        for (int shifts = 6; shifts <= 16; shifts++) {
            outcome c = divide_all("c", shifts, divisions);
            for (int form = 0; form < 2; form++) {
                outcome rtl = divide_all(forms[form], shifts, divisions);
                assert_string_equal(rtl.out, c.out);
                forget(&rtl);
            }
            forget(&c);
        }
        free(divisions);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_division_is_answered),
        cmocka_unit_test(real_is_exact_division_rounded_half_up),
        cmocka_unit_test(the_input_is_read_generously_in_its_blanks),
        cmocka_unit_test(what_divide_prints_divide_takes),
        cmocka_unit_test(a_row_costs_no_more_than_its_like),
        cmocka_unit_test(an_empty_input_has_no_rows),
        cmocka_unit_test(malformed_lines_are_named),
        cmocka_unit_test(no_k_is_silently_wrong),
        cmocka_unit_test(lines_before_the_refused_one_are_answered),
        cmocka_unit_test(long_lines_are_read_to_their_end),
        cmocka_unit_test(json_is_an_array_of_objects),
        cmocka_unit_test(options_are_read_strictly),
        cmocka_unit_test(an_unreadable_input_is_a_failure),
        cmocka_unit_test(output_that_is_not_taken_is_a_failure),
        cmocka_unit_test(every_division_follows_the_definition),
        cmocka_unit_test(c_and_rtl_agree_on_every_division),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
