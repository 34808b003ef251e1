/* `glint eval`: its input line by line, and its answers against the formula in double precision. */
#define _XOPEN_SOURCE 700

#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../golden.h"
#include "../scratch.h"
#include "file/json.h"
#include "run.h"

#define HEADER "n,cos_code,w_code,r,g,b\n"

static void assert_answer(const char *options, const char *input, const char *expected)
{
    char command_line[128];
    snprintf(command_line, sizeof command_line, "eval%s%s", *options != '\0' ? " " : "", options);
    outcome done = run(command_line, input);
    assert_outcome(&done, 0, "");
    assert_string_equal(done.out, expected);
    forget(&done);
}

/* n = 2 makes σ = 1 and so W = cos²: figures that can be checked by eye. */
static void a_point_is_answered(void **state)
{
    (void)state;
    static const char *const backends[] = {
        "",
        "--backend c",
        "--backend rtl",
        "--backend real",
        "--backend rtl --lanes 1",
        "--backend rtl --lanes 4 --pipeline combinational",
    };
    for (size_t i = 0; i < sizeof backends / sizeof backends[0]; i++) {
        assert_answer(backends[i], "2 0.5 255 100 4\n", HEADER "2,131072,65536,64,25,1\n");
        assert_answer(backends[i], "1000 1 255 1 0\n", HEADER "1000,262144,262144,255,1,0\n");
    }
}

static void the_input_is_read_generously_in_its_blanks(void **state)
{
    (void)state;
    static const char *const inputs[] = {
        "2 0.5 4 8 12\n",
        "2,0.5,4,8,12\n",
        "2, 0.5,4 ,8 , 12\n",
        " \t2\t0.5  4\t8 12 \t\n",
        "2 0.5 4 8 12",
        "2 0.5 4 8 12\r\n",
        "2 0.5 4 8 12\r",
        "\n\n2 .5 4 8 12\n",
        "# a comment\n2 5e-1 4 8 12\n#\n",
        " \r\n\t\n2 0x20000 4 8 12\n",
        "  # 1 2 3\n+2 0X20000 4 8 12\n \n",
        "002 0.50 004 8 12\n",
    };
    for (size_t i = 0; i < sizeof inputs / sizeof inputs[0]; i++)
        assert_answer("", inputs[i], HEADER "2,131072,65536,1,2,3\n");
}

static void lanes_have_a_range(void **state)
{
    (void)state;
    static const char *const refused[] = {"33", "0", "-1", "3.5", "all"};
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        char line[64];
        char expected[128];
        (void)snprintf(line, sizeof line, "eval --backend rtl --lanes %s", refused[i]);
        (void)snprintf(expected, sizeof expected,
                       "glint eval: --lanes: \"%s\" is not an integer from 1 to 32\n", refused[i]);
        outcome done = run(line, "");
        assert_outcome(&done, 2, expected);
        forget(&done);
    }
    outcome three = run("eval --backend rtl --lanes 3", "80 0.99 255 190 110\n");
    outcome usual = run("eval --backend rtl", "80 0.99 255 190 110\n");
    assert_outcome(&three, 0, "");
    assert_outcome(&usual, 0, "");
    assert_string_equal(three.out, usual.out);
    forget(&three);
    forget(&usual);
    outcome none = run("verify --lanes 0", "");
    assert_outcome(&none, 2,
                   "glint verify: --lanes: \"0\" is not an integer from 1 to 32 or all\n");
    forget(&none);
}

static void an_empty_input_has_no_rows(void **state)
{
    (void)state;
    assert_answer("", "", HEADER);
    assert_answer("", "# nothing\n\n", HEADER);
    assert_answer("--json", "", "[\n]\n");
}

static void a_code_above_one_saturates(void **state)
{
    (void)state;
    assert_answer("", "9 0x40000 3 4 5\n9 0x40001 3 4 5\n9 0x7FFFF 3 4 5\n",
                  HEADER "9,262144,262144,3,4,5\n9,262144,262144,3,4,5\n9,262144,262144,3,4,5\n");
}

/* 2^-19 is half a code, and half goes up. */
static void a_real_cosine_is_rounded_half_up(void **state)
{
    (void)state;
    assert_answer("", "2 0.00000190734863281250 0 0 0\n2 0.00000190734863281249 0 0 0\n",
                  HEADER "2,1,0,0,0,0\n2,0,0,0,0,0\n");
}

static void rows_stay_in_order(void **state)
{
    (void)state;
    char input[20000];
    char expected[20000] = HEADER;
    size_t in = 0;
    size_t out = strlen(expected);
    /* W = 1 passes the colours, so that each row shows which point it belongs to. */
    for (int i = 0; i < 600; i++) {
        const int n = i / 7 % 3;
        in += (size_t)sprintf(input + in, "%d 1 %d %d 0\n", n, i % 256, i / 256);
        out += (size_t)sprintf(expected + out, "%d,262144,262144,%d,%d,0\n", n, i % 256, i / 256);
    }
    assert_answer("", input, expected);
}

typedef struct refusal {
    const char *input;
    size_t count; /* 0: the string's length */
    const char *err;
} refusal;

#define CODES "a code: 0x0 to 0x7ffff or code:0 to code:524287"

#define MANY "a,a,a,a,a,a,a,a,a,a,a,a,a,a,a,a,"

static void malformed_lines_are_named(void **state)
{
    (void)state;
    static const refusal refusals[] = {
        {"1 1 1 1\n", 0, "line 1: fewer than five values (n cos r g b)"},
        {"1 1 1 1 1 1\n", 0, "line 1: more than five values (n cos r g b)"},
        {"n,cos,n,r,g,b\n", 0, "line 1: this header has two columns n"},
        {"n,cos,r,g\n", 0, "line 1: this header has no column b"},
        {"n,r,g,b\n", 0, "line 1: this header has no column cos or cos_code"},
        {"\n\nn,cos,r,g,b\nn,cos,r,g,b\n", 0, "line 4: n: \"n\" is not an integer from 0 to 1023"},
        {"n,cos,r,g,b,\n1,1,1,1,1\n", 0, "line 2: fewer than the header's values"},
        {"n,cos,r,g,b\n1,1,1,1,1,1\n", 0, "line 2: more than the header's values"},
        {"n,cos_code,r,g,b\n1,0.5,1,1,1\n", 0,
         "line 2: cos_code: \"0.5\" is not an integer from 0 to 524287 or " CODES},
        {"n,cos_code,r,g,b\n1,524288,1,1,1\n", 0,
         "line 2: cos_code: \"524288\" is not an integer from 0 to 524287 or " CODES},
        {"a,b,c,d,e,f,g,h,i,j,k,l,m,n,o,p,q\n", 0,
         "line 1: this header has no column cos or cos_code"},
        {MANY MANY MANY MANY MANY MANY MANY MANY "n,cos,r,g,b\n", 0,
         "line 1: this header has no column n"}, /* more than there may be */
        {"1 2 1 1 1", 0, "line 1: cos: \"2\" is not a number from 0 to 1 or " CODES},
        {"1 code:524288 1 1 1", 0,
         "line 1: cos: \"code:524288\" is not a number from 0 to 1 or " CODES},
        {"1 code: 1 1 1", 0, "line 1: cos: \"code:\" is not a number from 0 to 1 or " CODES},
        {"1024 1 1 1 1", 0, "line 1: n: \"1024\" is not an integer from 0 to 1023"},
        {"-1 1 1 1 1", 0, "line 1: n: \"-1\" is not an integer from 0 to 1023"},
        {"1.5 1 1 1 1", 0, "line 1: n: \"1.5\" is not an integer from 0 to 1023"},
        {"1 1.000001 1 1 1", 0, "line 1: cos: \"1.000001\" is not a number from 0 to 1 or " CODES},
        {"1 -0.1 1 1 1", 0, "line 1: cos: \"-0.1\" is not a number from 0 to 1 or " CODES},
        {"1 nan 1 1 1", 0, "line 1: cos: \"nan\" is not a number from 0 to 1 or " CODES},
        {"1 0x1p-1 1 1 1", 0, "line 1: cos: \"0x1p-1\" is not a number from 0 to 1 or " CODES},
        {"1 0x80000 1 1 1", 0, "line 1: cos: \"0x80000\" is not a number from 0 to 1 or " CODES},
        {"1 0x 1 1 1", 0, "line 1: cos: \"0x\" is not a number from 0 to 1 or " CODES},
        {"1 1 256 1 1", 0, "line 1: r: \"256\" is not an integer from 0 to 255"},
        {"1 1 1 0x1 1", 0, "line 1: g: \"0x1\" is not an integer from 0 to 255"},
        {"1 1 1 1 b", 0, "line 1: b: \"b\" is not an integer from 0 to 255"},
        {"1,,1,1,1", 0, "line 1: cos: \"\" is not a number from 0 to 1 or " CODES},
        {",1,1,1,1", 0, "line 1: n: \"\" is not an integer from 0 to 1023"},
        {"1,1,1,1,", 0, "line 1: b: \"\" is not an integer from 0 to 255"},
        {"1,1,1,1,1,", 0, "line 1: more than five values (n cos r g b)"},
        {"1;1;1;1;1", 0, "line 1: fewer than five values (n cos r g b)"},
        {"1 1 1 1 1 # comment", 0, "line 1: more than five values (n cos r g b)"},
        {"1 1 1 1\r1\n", 0, "line 1: fewer than five values (n cos r g b)"},
        {"1 1 1 1 1\0 2\n", 13, "line 1: contains a NUL byte: not text"},
        {"# \0\n", 4, "line 1: contains a NUL byte: not text"},
        {"\n\n# c\n1 1 1 1 1 1\n", 0, "line 4: more than five values (n cos r g b)"},
    };
    const plumbing none = {0};
    for (size_t i = 0; i < sizeof refusals / sizeof refusals[0]; i++) {
        char expected[256];
        char *argv[] = {NULL, "eval", NULL};
        const size_t count = refusals[i].count != 0 ? refusals[i].count : strlen(refusals[i].input);
        snprintf(expected, sizeof expected, "glint eval: %s\n", refusals[i].err);
        outcome done = run_arguments(argv, refusals[i].input, count, &none);
        assert_outcome(&done, 2, expected);
        assert_string_equal(done.out, HEADER);
        forget(&done);
    }
}

static void lines_before_the_malformed_one_are_answered(void **state)
{
    (void)state;
    outcome done = run("eval", "0 1 7 8 9\n0 1 7 8 9\n0 1 7 8\n0 1 7 8 9\n");
    assert_outcome(&done, 2, "glint eval: line 3: fewer than five values (n cos r g b)\n");
    assert_string_equal(done.out, HEADER "0,262144,262144,7,8,9\n0,262144,262144,7,8,9\n");
    forget(&done);
}

static void long_lines_are_read_to_their_end(void **state)
{
    (void)state;
    enum { LENGTH = 3000000 };
    char *line = malloc(LENGTH + 32);
    assert_non_null(line);
    memset(line, ' ', LENGTH);
    strcpy(line + LENGTH, "0 1 7 8 9\n");
    assert_answer("", line, HEADER "0,262144,262144,7,8,9\n");
    memset(line, '7', LENGTH);
    outcome done = run("eval", line);
    assert_int_equal(done.status, 2);
    assert_true(strlen(done.err) < 200);
    assert_says(done.err, "777...\" is not an integer from 0 to 1023\n");
    forget(&done);
    free(line);
}

/* Every printed form is accepted: all three represent the same code. The codes 0 and 1 are
 * included, which as bare numbers would be cosines. */
static void a_code_that_was_printed_is_taken(void **state)
{
    (void)state;
    static const unsigned codes[] = {0, 1, 2, 259523, 262143, 262144, 262145, 524287};
    for (size_t i = 0; i < sizeof codes / sizeof codes[0]; i++) {
        char input[3][128], expected[160];
        const unsigned held = codes[i] < 262144 ? codes[i] : 262144;
        snprintf(input[0], sizeof input[0], "80 0x%x 9 8 7\n", codes[i]);
        snprintf(input[1], sizeof input[1], "80 code:%u 9 8 7\n", codes[i]);
        snprintf(input[2], sizeof input[2], "b,w_code,cos_code,n,r,g\n7,1,%u,80,9,8\n", codes[i]);
        outcome done = run("eval", input[0]);
        assert_outcome(&done, 0, "");
        snprintf(expected, sizeof expected, HEADER "80,%u,", held);
        assert_memory_equal(done.out, expected, strlen(expected));
        for (int k = 1; k < 3; k++) {
            outcome same = run("eval", input[k]);
            assert_outcome(&same, 0, "");
            assert_string_equal(same.out, done.out);
            forget(&same);
        }
        forget(&done);
    }
}

/* As CSV it is read as it was printed: with r, g, b of full brightness W = 1 gives them back. */
static void what_eval_prints_eval_takes(void **state)
{
    (void)state;
    outcome done = run("eval", "80 1 9 8 7\n3 0.999999 255 255 255\n1000 1 0 1 2\n");
    outcome again = run("eval", done.out);
    outcome named = run("eval", "r,g,b,cos,n\n9,8,7,1,80\n255,255,255,0.999999,3\n0,1,2,1,1000\n");
    assert_outcome(&done, 0, "");
    assert_outcome(&again, 0, "");
    assert_outcome(&named, 0, "");
    assert_says(done.out, "\n80,262144,262144,9,8,7\n");
    assert_string_equal(again.out, done.out);
    assert_string_equal(named.out, done.out);
    forget(&done);
    forget(&again);
    forget(&named);
}

static void json_is_an_array_of_objects(void **state)
{
    (void)state;
    outcome done = run("eval --json", "2 0.5 4 8 12\n7 1 1 2 3\n");
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_true(json_is_array(json));
    assert_int_equal(json_array_size(json), 2);
    static const char *const names[] = {"n", "cos_code", "w_code", "r", "g", "b"};
    static const int values[2][6] = {{2, 131072, 65536, 1, 2, 3}, {7, 262144, 262144, 1, 2, 3}};
    for (int i = 0; i < 2; i++) {
        const json_t *point = json_array_get(json, (size_t)i);
        assert_int_equal(json_object_size(point), 6);
        for (int j = 0; j < 6; j++) {
            const json_t *value = json_object_get(point, names[j]);
            assert_true(json_is_number(value));
            assert_int_equal(json_integer_value(value), values[i][j]);
        }
    }
    json_decref(json);
    forget(&done);
}

static void an_unreadable_input_is_a_failure(void **state)
{
    (void)state;
    const plumbing directory = {.in = "."};
    const plumbing closed = {.close_in = true};
    outcome done = run_plumbed("eval", "", &directory);
    assert_outcome(&done, 2, "glint eval: cannot read standard input: Is a directory\n");
    forget(&done);
    done = run_plumbed("eval", "", &closed);
    assert_outcome(&done, 2, "glint eval: cannot read standard input: Bad file descriptor\n");
    forget(&done);
}

/* ---- the answers themselves ---- */

#define POINTS 20000

static uint32_t random_state = 2024;

static uint32_t random_below(uint32_t limit)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 17;
    random_state ^= random_state << 5;
    return random_state % limit;
}

/* A cosine, mostly inside the highlight of n, as a code or as a decimal number. */
static int print_cosine(char *text, int n)
{
    const double edge = n > 2 ? 1.0 - 4.0 / (n + 1.0) : 0.0;
    const double cosine = edge + (1.0 - edge) * random_below(1u << 20) / (double)(1u << 20);
    switch (random_below(4)) {
    case 0:
        return sprintf(text, "0x%x", random_below(0x80000));
    case 1:
        return sprintf(text, "0x%x", (unsigned)(cosine * 262144.0));
    default:
        return sprintf(text, "%.9f", cosine);
    }
}

/* Random points: runs of one material, some of a single point. To be freed. */
static char *random_points(void)
{
    char *text = malloc((size_t)POINTS * 48);
    assert_non_null(text);
    size_t length = 0;
    int n = 0;
    unsigned r = 0, g = 0, b = 0;
    for (int i = 0; i < POINTS; i++) {
        if (random_below(8) == 0) {
            n = (int)random_below(1024) >> random_below(8);
            r = random_below(256);
            g = random_below(256);
            b = random_below(256);
        }
        length += (size_t)sprintf(text + length, "%d ", n);
        length += (size_t)print_cosine(text + length, n);
        length += (size_t)sprintf(text + length, " %u %u %u\n", r, g, b);
    }
    return text;
}

static void c_and_rtl_agree_on_random_points(void **state)
{
    (void)state;
    static const char *const settings[] = {
        "",
        " --gate sign",
        " --gate drawn",
        " --pipeline combinational",
        " --gate sign --pipeline combinational",
        " --gate drawn --pipeline combinational",
    };
    char *points = random_points();
    for (size_t i = 0; i < sizeof settings / sizeof settings[0]; i++) {
        char command_line[128];
        snprintf(command_line, sizeof command_line, "eval --backend c%s", settings[i]);
        outcome c = run(command_line, points);
        snprintf(command_line, sizeof command_line, "eval --backend rtl%s", settings[i]);
        outcome rtl = run(command_line, points);
        assert_outcome(&c, 0, "");
        assert_outcome(&rtl, 0, "");
        assert_true(strlen(c.out) > POINTS * strlen("0,0,0,0,0,0\n"));
        assert_string_equal(c.out, rtl.out);
        forget(&c);
        forget(&rtl);
    }
    free(points);
}

/* (2.15) for the code's cosine, without calling any of Glint's code. */
static double formula(int n, long code)
{
    const double t = (n + 1) / 3.0 * ((double)code / 262144.0 - 1.0) + 1.0;
    return t > 0.0 ? t * t : 0.0;
}

typedef struct point {
    int n;
    char cosine[24];
    int component[3];
} point;

static void read_point(const char *line, point *given)
{
    assert_int_equal(sscanf(line, "%d %23s %d %d %d", &given->n, given->cosine,
                            &given->component[0], &given->component[1], &given->component[2]),
                     5);
}

/* Register 1, by the rules of the input: half up, and at most 1.0. */
static long expected_code(const char *cosine)
{
    const long code = strncmp(cosine, "0x", 2) == 0
                          ? strtol(cosine, NULL, 16)
                          : (long)floor(strtod(cosine, NULL) * 262144.0 + 0.5);
    return code < 262144 ? code : 262144;
}

static void assert_close(double found, double expected, double tolerance, const char *line)
{
    if (!(fabs(found - expected) <= tolerance))
        fail_msg("%g is more than %g from %.9f for %.40s", found, tolerance, expected, line);
}

static void check_row(const char *line, const char *row, double tolerance)
{
    point given;
    int n, component[3];
    long cos_code, w_code;
    read_point(line, &given);
    assert_int_equal(sscanf(row, "%d,%ld,%ld,%d,%d,%d", &n, &cos_code, &w_code, &component[0],
                            &component[1], &component[2]),
                     6);
    assert_int_equal(n, given.n);
    assert_int_equal(cos_code, expected_code(given.cosine));
    const double w = formula(n, cos_code);
    /* What is left of the tolerance after the output's own rounding is W's. */
    assert_close((double)w_code / 262144.0 * 255.0, w * 255.0, tolerance - 0.5, line);
    for (int i = 0; i < 3; i++)
        assert_close(component[i], w * given.component[i], tolerance, line);
}

static const char *next_line(const char *text)
{
    const char *end = strchr(text, '\n');
    assert_non_null(end);
    return end + 1;
}

/* Every output within `tolerance` of one step of the formula of the quantised cosine. */
static void assert_follows_formula(const char *command_line, double tolerance)
{
    char *points = random_points();
    outcome done = run(command_line, points);
    assert_outcome(&done, 0, "");
    const char *line = points;
    const char *row = next_line(done.out);
    for (int i = 0; i < POINTS; i++) {
        check_row(line, row, tolerance);
        line = next_line(line);
        row = next_line(row);
    }
    assert_string_equal(row, "");
    forget(&done);
    free(points);
}

static void c_follows_the_formula(void **state)
{
    (void)state;
    assert_follows_formula("eval --backend c", 0.52);
    assert_follows_formula("eval --backend c --gate sign", 0.52);
}

static void real_is_the_formula(void **state)
{
    (void)state;
    /* W itself is rounded to its code: half a code is 255/2^19 of a step. */
    assert_follows_formula("eval --backend real", 0.5 + 255.0 / 524288.0 + 1e-9);
}

/* ---- Ctrl-C ---- */

/* Starts `glint eval`, with one option or NULL, with pipes at both ends. */
static pid_t start_eval(const char *option, int *input, int *output)
{
    pid_t child;
    int in[2], out[2];
    posix_spawn_file_actions_t actions;
    char *argv[] = {(char *)(uintptr_t)glint_under_test(), "eval", (char *)(uintptr_t)option, NULL};
    assert_int_equal(pipe(in), 0);
    assert_int_equal(pipe(out), 0);
    assert_int_equal(posix_spawn_file_actions_init(&actions), 0);
    assert_int_equal(posix_spawn_file_actions_adddup2(&actions, in[0], 0), 0);
    assert_int_equal(posix_spawn_file_actions_adddup2(&actions, out[1], 1), 0);
    assert_int_equal(posix_spawn_file_actions_addopen(&actions, 2, scratch_path("stderr"),
                                                      O_WRONLY | O_CREAT | O_TRUNC, 0666),
                     0);
    /* Else the child would hold its own input open. */
    assert_int_equal(posix_spawn_file_actions_addclose(&actions, in[1]), 0);
    assert_int_equal(posix_spawn(&child, argv[0], &actions, NULL, argv, environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    close(in[0]);
    close(out[1]);
    *input = in[1];
    *output = out[0];
    return child;
}

/* A command that has ended takes nothing more, which is a failure of the test and not its end. */
static void give(int input, const char *line, int length)
{
    void (*const before)(int) = signal(SIGPIPE, SIG_IGN);
    assert_int_equal(write(input, line, (size_t)length), length);
    (void)signal(SIGPIPE, before);
}

static void an_interrupt_ends_the_wait_for_input(void **state)
{
    (void)state;
    int input;
    int output;
    char line[32];
    const pid_t child = start_eval(NULL, &input, &output);
    /* Single-point runs until standard output's buffer overflows: then it surely runs. */
    for (int i = 0; i < 1500; i++) {
        const int length = snprintf(line, sizeof line, "5 1 %d 2 3\n", i % 2);
        give(input, line, length);
    }
    assert_int_equal(read(output, line, 2), 2);
    assert_int_equal(kill(child, SIGINT), 0);
    assert_int_equal(wait_for(child), 2);
    close(input);
    close(output);
    char *err = scratch_read(scratch_path("stderr"), NULL);
    assert_string_equal(err, "glint eval: interrupted\n");
    free(err);
}

/* Every point that was read is answered, and the array is closed. */
static void an_interrupt_leaves_whole_json(void **state)
{
    (void)state;
    int input;
    int output;
    size_t count = 0;
    ssize_t got;
    static char out[1 << 16];
    const pid_t child = start_eval("--json", &input, &output);
    for (int i = 0; i < 300; i++) { /* of a material each, so that some are answered at once */
        char line[32];
        const int length = snprintf(line, sizeof line, "5 1 %d 2 3\n", i % 2);
        give(input, line, length);
    }
    got = read(output, out, 2); /* standard output's buffer overflowed: it surely runs */
    assert_int_equal(got, 2);
    count += (size_t)got;
    /* It waits for more by now, or still reads what it was given. */
    assert_int_equal(kill(child, SIGINT), 0);
    while ((got = read(output, out + count, sizeof out - 1 - count)) > 0)
        count += (size_t)got;
    assert_int_equal(wait_for(child), 2);
    close(input);
    close(output);
    json_t *json = json_loads(out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_true(json_is_array(json) && (int)json_array_size(json) > 0);
    json_decref(json);
}

static void a_line_without_end_is_refused(void **state)
{
    (void)state;
    static const char *const commands[] = {"eval", "divide"};
    for (size_t i = 0; i < 2; i++) {
        outcome done = run_plumbed(commands[i], "", &(plumbing){.in = "/dev/zero"});
        assert_int_equal(done.status, 2);
        assert_says(done.err, ": line 1: longer than 16 MB: not text\n");
        forget(&done);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_point_is_answered),
        cmocka_unit_test(the_input_is_read_generously_in_its_blanks),
        cmocka_unit_test(lanes_have_a_range),
        cmocka_unit_test(an_empty_input_has_no_rows),
        cmocka_unit_test(a_code_above_one_saturates),
        cmocka_unit_test(a_real_cosine_is_rounded_half_up),
        cmocka_unit_test(rows_stay_in_order),
        cmocka_unit_test(malformed_lines_are_named),
        cmocka_unit_test(lines_before_the_malformed_one_are_answered),
        cmocka_unit_test(long_lines_are_read_to_their_end),
        cmocka_unit_test(a_code_that_was_printed_is_taken),
        cmocka_unit_test(what_eval_prints_eval_takes),
        cmocka_unit_test(json_is_an_array_of_objects),
        cmocka_unit_test(an_unreadable_input_is_a_failure),
        cmocka_unit_test(c_and_rtl_agree_on_random_points),
        cmocka_unit_test(c_follows_the_formula),
        cmocka_unit_test(real_is_the_formula),
        cmocka_unit_test(an_interrupt_ends_the_wait_for_input),
        cmocka_unit_test(an_interrupt_leaves_whole_json),
        cmocka_unit_test(a_line_without_end_is_refused),
    };
    return golden_run_group_tests(tests, scratch_make, scratch_remove);
}
