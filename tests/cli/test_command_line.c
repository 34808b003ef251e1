/* What every subcommand's command line has in common: help, refusals, exit statuses, and a standard
 * output that does not take what is printed. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "run.h"

static const char *const subcommands[] = {"info",    "models",  "eval",   "divide", "render",
                                          "compare", "convert", "study",  "verify", "replay",
                                          "wave",    "draw",    "energy", "report", "bench"};
#define SUBCOMMAND_COUNT (sizeof subcommands / sizeof subcommands[0])

static void help_lists_every_subcommand(void **state)
{
    (void)state;
    static const char *const asked[] = {"--help", "-h"};
    for (size_t i = 0; i < 2; i++) {
        outcome done = run(asked[i], "");
        assert_outcome(&done, 0, "");
        assert_says(done.out, "Usage: glint SUBCOMMAND");
        for (size_t j = 0; j < SUBCOMMAND_COUNT; j++)
            assert_says(done.out, subcommands[j]);
        forget(&done);
    }
}

static void every_subcommand_has_help(void **state)
{
    (void)state;
    for (size_t i = 0; i < SUBCOMMAND_COUNT; i++) {
        char command_line[64];
        char usage[64];
        snprintf(command_line, sizeof command_line, "%s --help", subcommands[i]);
        snprintf(usage, sizeof usage, "Usage: glint %s", subcommands[i]);
        outcome done = run(command_line, "");
        assert_outcome(&done, 0, "");
        assert_memory_equal(done.out, usage, strlen(usage));
        assert_says(done.out, "\n  --help");
        forget(&done);
    }
}

/* `glint help SUBCOMMAND` is `glint SUBCOMMAND --help`, in which every line fits a terminal, each
 * status has its meaning, and there are examples. */
static void help_fits_and_is_regular(void **state)
{
    (void)state;
    static const char *const others[] = {"verify --exhaustive", ""};
    for (size_t i = 0; i < SUBCOMMAND_COUNT + 2; i++) {
        const char *name = i < SUBCOMMAND_COUNT ? subcommands[i] : others[i - SUBCOMMAND_COUNT];
        char command_line[64];
        snprintf(command_line, sizeof command_line, *name != '\0' ? "help %s" : "help", name);
        outcome done = run(command_line, "");
        snprintf(command_line, sizeof command_line, *name != '\0' ? "%s --help" : "--help", name);
        outcome same = run(command_line, "");
        assert_outcome(&done, 0, "");
        assert_string_equal(done.out, same.out);
        assert_says(done.out, "\nExit status:\n  0  ");
        assert_says(done.out, "\n  2  trouble: ");
        assert_says(done.out, "\nExamples:\n  # ");
        assert_null(strstr(done.out, "\n\n\n"));
        for (char *line = strtok(done.out, "\n"); line != NULL; line = strtok(NULL, "\n")) {
            size_t columns = 0;
            for (const char *c = line; *c != '\0'; c++)
                columns += ((unsigned char)*c & 0xc0) != 0x80;
            if (columns > 80)
                fail_msg("%s: %zu columns: %s", command_line, columns, line);
        }
        forget(&done);
        forget(&same);
    }
}

/* The same exponent, each time: what is drawn does not depend on how it is written. */
static void large_numbers_are_written_as_people_do(void **state)
{
    (void)state;
    static const char *const written[] = {"2000", "2e3", "2E3", "2e+3", "2k", "2K", "0.002M"};
    for (size_t i = 0; i < sizeof written / sizeof written[0]; i++) {
        char command_line[256];
        snprintf(command_line, sizeof command_line,
                 "verify --circuit divider --form pipelined --shifts 12 --seed 1 --clocks %s",
                 written[i]);
        outcome done = run(command_line, "");
        assert_outcome(&done, 0, "");
        assert_says(done.out, ", 2000 clocks, ");
        forget(&done);
    }
}

static void every_subcommand_refuses_what_it_does_not_know(void **state)
{
    (void)state;
    static const char *const unknown[] = {"--no-such-option", "--no-such-option=1", "-z", "--hel"};
    static const char *const shown[] = {"--no-such-option", "--no-such-option", "-z", "--hel"};
    for (size_t i = 0; i < SUBCOMMAND_COUNT; i++) {
        for (size_t j = 0; j < 4; j++) {
            char command_line[64];
            char expected[128];
            snprintf(command_line, sizeof command_line, "%s %s", subcommands[i], unknown[j]);
            snprintf(expected, sizeof expected,
                     "glint %s: unknown option \"%s\" (%ssee glint %s --help)\n", subcommands[i],
                     shown[j], j == 3 ? "did you mean --help? " : "", subcommands[i]);
            outcome done = run(command_line, "");
            assert_outcome(&done, 2, expected);
            assert_string_equal(done.out, "");
            forget(&done);
        }
    }
}

static void the_version_is_printed(void **state)
{
    (void)state;
    outcome brief = run("-V", "");
    outcome done = run("--version", "");
    assert_outcome(&done, 0, "");
    assert_outcome(&brief, 0, "");
    assert_string_equal(brief.out, done.out);
    forget(&brief);
    int major;
    int minor;
    int patch;
    int length = 0;
    assert_int_equal(sscanf(done.out, "glint %d.%d.%d\n%n", &major, &minor, &patch, &length), 3);
    assert_int_equal(length, strlen(done.out));
    forget(&done);
}

typedef struct refusal {
    const char *command_line;
    const char *err;
} refusal;

static void assert_refused(const refusal *refusals, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        outcome done = run(refusals[i].command_line, "");
        assert_outcome(&done, 2, refusals[i].err);
        assert_string_equal(done.out, "");
        forget(&done);
    }
}

static void a_wrong_subcommand_is_refused(void **state)
{
    (void)state;
    static const refusal refusals[] = {
        {"", "glint: no subcommand (see glint --help)\n"},
        {"paint", "glint: unknown subcommand \"paint\" (see glint --help)\n"},
        {"rende", "glint: unknown subcommand \"rende\" (did you mean render? see glint --help)\n"},
        {"help rnder",
         "glint: unknown subcommand \"rnder\" (did you mean render? see glint --help)\n"},
        {"--verson",
         "glint: unknown option \"--verson\" (did you mean --version? see glint --help)\n"},
        {"--json", "glint: unknown option \"--json\" (see glint --help)\n"},
    };
    assert_refused(refusals, sizeof refusals / sizeof refusals[0]);
}

#define COLOR_REFUSAL(TEXT)                                                                        \
    "glint render: --color: \"" TEXT                                                               \
    "\" is not a colour: R,G,B (0 to 255), #rrggbb, hsv:H,S,V (0 "                                 \
    "to 360, %, %) or cmyk:C,M,Y,K (%)\n"

static void options_are_read_strictly(void **state)
{
    (void)state;
    static const refusal refusals[] = {
        {"render", "glint render: --out is required (see glint render --help)\n"},
        {"render --out", "glint render: --out needs a value: a non-empty FILE.png\n"},
        {"render --out=", "glint render: --out: \"\" is not a non-empty FILE.png\n"},
        {"render --out x.png teapot stray", "glint render: unexpected argument \"stray\"\n"},
        {"render --out x.png teapot -- --n", "glint render: unexpected argument \"--n\"\n"},
        {"render --out x.png --model quad teapot",
         "glint render: --model and \"teapot\": only one model can be drawn\n"},
        {"study --out x teapot --model quad",
         "glint study: --model and \"teapot\": only one model can be drawn\n"},
        {"render --out x.png Teapto",
         "glint render: Teapto: No such file or directory; built-in models are teapot, sphere and "
         "quad (did you mean teapot?)\n"},
        {"render --out x.png missing.obj",
         "glint render: missing.obj: No such file or directory; built-in models are teapot, sphere "
         "and quad\n"},
        {"render --ou x.png",
         "glint render: unknown option \"--ou\" (did you mean --out? see glint render --help)\n"},
        {"render --shadnig flat", "glint render: unknown option \"--shadnig\" (did you mean "
                                  "--shading? see glint render --help)\n"},
        {"render --shading Goraud",
         "glint render: --shading: \"Goraud\" is not one of flat, gouraud, gouraud-perspective, "
         "quadratic, quadratic-listing, phong, mixed, gouraud-4, cosine-linear, "
         "phong-unnormalised, phong-newton, "
         "reflection-map, wires, normals (did you mean gouraud?)\n"},
        {"render --isc on --shading flat --out x.png",
         "glint render: --isc needs --shading phong\n"},
        {"render --delta 3 --out x.png", "glint render: --delta needs --shading mixed\n"},
        {"render --map 64 --out x.png", "glint render: --map needs --shading reflection-map\n"},
        {"render --shading wires --out x.png", "glint render: shading wires needs backend real: "
                                               "nothing in it comes from a circuit\n"},
        {"render --isc on --backend gl --out x.png",
         "glint render: --isc needs another backend: --backend gl draws every pixel alike\n"},
        {"render --n 1e4", "glint render: --n: \"1e4\" is not a number from 0 to 1023\n"},
        {"render --n 2k", "glint render: --n: \"2k\" is not a number from 0 to 1023\n"},
        {"render --n 1.5 --out x.png", "glint render: --n: the device's n is a whole number, not "
                                       "1.5; fractions need --backend real "
                                       "--specular MODEL\n"},
        {"render --n k", "glint render: --n: \"k\" is not a number from 0 to 1023\n"},
        {"render --n 1kk", "glint render: --n: \"1kk\" is not a number from 0 to 1023\n"},
        {"verify --clocks 0.0001k",
         "glint verify: --clocks: \"0.0001k\" is not an integer from 1 to 1000000000000\n"},
        {"verify --clocks 1e19",
         "glint verify: --clocks: \"1e19\" is not an integer from 1 to 1000000000000\n"},
        {"verify --clocks 99999999999999999999T",
         "glint verify: --clocks: \"99999999999999999999T\" is not an integer from 1 to "
         "1000000000000\n"},
        {"render --kb 1",
         "glint render: unknown option \"--kb\" (did you mean --k? see glint render --help)\n"},
        {"render --n 1 --n 1", "glint render: --n is given twice\n"},
        {"render --json --json", "glint render: --json is given twice\n"},
        {"render --json=1", "glint render: --json takes no value\n"},
        {"render --help=1", "glint render: --help takes no value\n"},
        {"render --n", "glint render: --n needs a value: a number from 0 to 1023\n"},
        {"render --n 5000", "glint render: --n: \"5000\" is not a number from 0 to 1023\n"},
        {"render --n -1", "glint render: --n: \"-1\" is not a number from 0 to 1023\n"},
        {"render --n=", "glint render: --n: \"\" is not a number from 0 to 1023\n"},
        {"render --n 5x", "glint render: --n: \"5x\" is not a number from 0 to 1023\n"},
        {"render --n 5.0.0", "glint render: --n: \"5.0.0\" is not a number from 0 to 1023\n"},
        {"render --n 0x5", "glint render: --n: \"0x5\" is not a number from 0 to 1023\n"},
        {"render --n 99999999999999999999",
         "glint render: --n: \"99999999999999999999\" is not a number from 0 to 1023\n"},
        {"render --n --json", "glint render: --n: \"--json\" is not a number from 0 to 1023\n"},
        {"render --ie 1.01", "glint render: --ie: \"1.01\" is not a number from 0 to 1, or R,G,B "
                             "each from 0 to 255\n"},
        {"render --ia 1,2,256", "glint render: --ia: \"1,2,256\" is not a number from 0 to 1, or "
                                "R,G,B each from 0 to 255\n"},
        {"render --scene figure-3.8 --out x.png",
         "glint render: --scene: \"figure-3.8\" is not one of default, figure-3.9, listing (did "
         "you mean figure-3.9?)\n"},
        {"render --scale 1,2 --out x.png", "glint render: --scale: \"1,2\" is not one or three "
                                           "comma-separated numbers from -1000 to 1000\n"},
        {"render --scale 1,0,1 --out x.png",
         "glint render: --scale: a factor of 0 would flatten the object: give at least 1e-06, or "
         "at most -1e-06\n"},
        {"render --scale -9e-7 --out x.png",
         "glint render: --scale: a factor of -9e-07 would flatten the object: give at least 1e-06, "
         "or at most -1e-06\n"},
        {"render --ka 1.01", "glint render: --ka: \"1.01\" is not a number from 0 to 1\n"},
        {"render --ka nan", "glint render: --ka: \"nan\" is not a number from 0 to 1\n"},
        {"render --ka 0x1p-1", "glint render: --ka: \"0x1p-1\" is not a number from 0 to 1\n"},
        {"render --ka .5.", "glint render: --ka: \".5.\" is not a number from 0 to 1\n"},
        {"render --fov inf", "glint render: --fov: \"inf\" is not a number from 1 to 170\n"},
        {"render --backend gpu",
         "glint render: --backend: \"gpu\" is not one of c, rtl, real, both, gl\n"},
        {"render --gate Sign",
         "glint render: --gate: \"Sign\" is not one of cosine, sign, drawn (did you mean "
         "sign?)\n"},
        {"render --pipeline p",
         "glint render: --pipeline: \"p\" is not one of combinational, pipelined\n"},
        {"render --lanes 33",
         "glint render: --lanes: \"33\" is not auto or an integer from 1 to 32\n"},
        {"verify --lanes 33",
         "glint verify: --lanes: \"33\" is not an integer from 1 to 32 or all\n"},
        {"verify --gate cosin",
         "glint verify: --gate: \"cosin\" is not one of cosine, sign, drawn, all (did you mean "
         "cosine?)\n"},
        {"verify --gate sign --form sequential",
         "glint verify: --gate, --pipeline, --lanes are for specular, --form, --shifts for "
         "divider\n"},
        {"wave --circuit divider --lanes 2",
         "glint wave: --gate, --pipeline, --lanes are for specular, --form, --shifts for "
         "divider\n"},
        {"eval --shifts 5", "glint eval: --shifts: \"5\" is not an integer from 6 to 16\n"},
        {"eval --rtl rtl",
         "glint eval: --rtl names the Verilog's directory: use it with --backend rtl\n"},
        {"--circuit-dir nowhere verify", "glint verify: nowhere: No such file or directory\n"},
        {"verify --circuit-dir nowhere", "glint verify: nowhere: No such file or directory\n"},
        {"--circuit-dir rtl --circuit-dir cmodel info",
         "glint: --circuit-dir is given twice: name one directory\n"},
        {"--circuit-dir rtl render",
         "glint: render does not take --circuit-dir (see glint render --help)\n"},
        {"--circuit-dir rtl",
         "glint: --circuit-dir DIR must be followed by a subcommand (see glint --help)\n"},
        {"verify --exhaustive --every-lane --circuit divider",
         "glint verify: --every-lane needs a circuit that computes highlights, not divider\n"},
        {"render --size 640",
         "glint render: --size: \"640\" is not WIDTHxHEIGHT, each from 1 to 16384\n"},
        {"render --size 640x480x2",
         "glint render: --size: \"640x480x2\" is not WIDTHxHEIGHT, each from 1 to 16384\n"},
        {"render --size 0x480",
         "glint render: --size: \"0x480\" is not WIDTHxHEIGHT, each from 1 to 16384\n"},
        {"render --size 640x16385",
         "glint render: --size: \"640x16385\" is not WIDTHxHEIGHT, each from 1 to 16384\n"},
        {"render --light 1,2",
         "glint render: --light: \"1,2\" is not three comma-separated numbers from -1e+06 to "
         "1e+06\n"},
        {"render --light 1,,3",
         "glint render: --light: \"1,,3\" is not three comma-separated numbers from -1e+06 "
         "to 1e+06\n"},
        {"render --light 1,2,nan",
         "glint render: --light: \"1,2,nan\" is not three comma-separated numbers from "
         "-1e+06 to 1e+06\n"},
        {"render --color 1,2,256", COLOR_REFUSAL("1,2,256")},
        {"render --color 1,2,3,4", COLOR_REFUSAL("1,2,3,4")},
        {"render --color 1.5,2,3", COLOR_REFUSAL("1.5,2,3")},
        {"render --color red", COLOR_REFUSAL("red")},
        {"render --color #12345", COLOR_REFUSAL("#12345")},
        {"render --color #1234567", COLOR_REFUSAL("#1234567")},
        {"render --color #12345g", COLOR_REFUSAL("#12345g")},
        {"render --color rgb:1,2", COLOR_REFUSAL("rgb:1,2")},
        {"render --color hsv:361,0,0", COLOR_REFUSAL("hsv:361,0,0")},
        {"render --color hsv:0,101,0", COLOR_REFUSAL("hsv:0,101,0")},
        {"render --color hsv:1,2", COLOR_REFUSAL("hsv:1,2")},
        {"render --color hsv:nan,0,0", COLOR_REFUSAL("hsv:nan,0,0")},
        {"render --color cmyk:0,0,0", COLOR_REFUSAL("cmyk:0,0,0")},
        {"render --color cmyk:0,0,0,100.1", COLOR_REFUSAL("cmyk:0,0,0,100.1")},
        {"render --color HSV:1,2,3", COLOR_REFUSAL("HSV:1,2,3")},
        {"render --color hsv:", COLOR_REFUSAL("hsv:")},
        {"render --threads 65", "glint render: --threads: \"65\" is not an integer from 1 to 64\n"},
        {"eval points.csv", "glint eval: unexpected argument \"points.csv\"\n"},
        {"eval --backend both", "glint eval: --backend: \"both\" is not one of c, rtl, real\n"},
        {"compare", "glint compare: A.png is missing (see glint compare --help)\n"},
        {"compare a.png", "glint compare: B.png is missing (see glint compare --help)\n"},
        {"compare a.png b.png c.png", "glint compare: unexpected argument \"c.png\"\n"},
    };
    assert_refused(refusals, sizeof refusals / sizeof refusals[0]);
}

static void a_message_stays_one_line(void **state)
{
    (void)state;
    const plumbing none = {0};
    char longest[100000];
    memset(longest, 'x', sizeof longest - 1);
    longest[sizeof longest - 1] = '\0';
    char *newline[] = {NULL, "render", "--n", "1\n2\x1b[31m", NULL};
    char *lengthy[] = {NULL, "render", "--n", longest, NULL};
    outcome done = run_arguments(newline, "", 0, &none);
    assert_outcome(&done, 2,
                   "glint render: --n: \"1\\x0a2\\x1b[31m\" is not a number from 0 to 1023\n");
    forget(&done);
    done = run_arguments(lengthy, "", 0, &none);
    assert_int_equal(done.status, 2);
    assert_true(strlen(done.err) < 200);
    assert_says(done.err, "xxx...\" is not a number from 0 to 1023\n");
    forget(&done);
}

static void output_that_is_not_taken_is_a_failure(void **state)
{
    (void)state;
    static const char *const printing[] = {"--help",        "--version",   "info",
                                           "render --help", "info --json", "eval"};
    const plumbing full = {.out = "/dev/full"};
    const plumbing closed = {.close_out = true};
    for (size_t i = 0; i < sizeof printing / sizeof printing[0]; i++) {
        outcome done = run_plumbed(printing[i], "1 1 1 1 1\n", &full);
        assert_int_equal(done.status, 2);
        assert_says(done.err, "cannot write to standard output: No space left on device\n");
        forget(&done);
        done = run_plumbed(printing[i], "1 1 1 1 1\n", &closed);
        assert_int_equal(done.status, 2);
        assert_says(done.err, "cannot write to standard output: Bad file descriptor\n");
        forget(&done);
    }
}

#define LACKS                                                                                      \
    " is not in this program, the part of glint that make demo begins with: make builds the "      \
    "whole command\n"

/* glint-first, which make demo links before the rest of the command is compiled. */
static void the_first_part_says_what_it_lacks(void **state)
{
    (void)state;
    static const refusal refusals[] = {
        {"report --chapter divider", "glint: report" LACKS},
        {"verify --exhaustive", "glint: verify --exhaustive" LACKS},
        {"render --backend gl --out a.png", "glint: render --backend gl" LACKS},
        {"rende", "glint: unknown subcommand \"rende\" (did you mean render? see glint --help)\n"},
    };
    const char *build = getenv("GLINT_BUILD");
    char path[4096], *kept = strdup(glint_under_test());
    assert_non_null(kept);
    (void)snprintf(path, sizeof path, "%s/glint-first", build != NULL ? build : "build");
    assert_int_equal(setenv("GLINT", path, 1), 0);
    assert_refused(refusals, sizeof refusals / sizeof refusals[0]);
    outcome done = run("render --help", "");
    assert_outcome(&done, 0, "");
    forget(&done);
    assert_int_equal(setenv("GLINT", kept, 1), 0);
    free(kept);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(help_lists_every_subcommand),
        cmocka_unit_test(every_subcommand_has_help),
        cmocka_unit_test(help_fits_and_is_regular),
        cmocka_unit_test(large_numbers_are_written_as_people_do),
        cmocka_unit_test(every_subcommand_refuses_what_it_does_not_know),
        cmocka_unit_test(the_version_is_printed),
        cmocka_unit_test(a_wrong_subcommand_is_refused),
        cmocka_unit_test(options_are_read_strictly),
        cmocka_unit_test(a_message_stays_one_line),
        cmocka_unit_test(output_that_is_not_taken_is_a_failure),
        cmocka_unit_test(the_first_part_says_what_it_lacks),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
