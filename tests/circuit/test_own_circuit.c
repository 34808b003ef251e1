/* User circuits given on the command line: those of tests/circuit/own, each with a feature that the
 * others lack. Each is verified; a fault in a copy of its Verilog is found and its packet replayed;
 * waveforms and eval work; and any fault in such a directory is reported in one line. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../cli/run.h"
#include "own.h"

#define OWN "tests/circuit/own/"

typedef struct own_circuit {
    const char *name;
    const char *options;          /* of the setting that the faulty copy is tried in */
    const char *file, *from, *to; /* its fault */
    const char *signal;           /* that the verdict names first */
    bool whole;                   /* verified in every listed setting, not in that one alone */
    bool waves;                   /* its waveform is written */
    const char *input, *output;   /* of eval with these options */
} own_circuit;

#define ONES15 "fffffffffffffff"
#define ONES60 ONES15 ONES15 ONES15 ONES15
#define ZERO16 "0000000000000000"

static const own_circuit circuits[] = {
    {"rotate_xor", "", "rotate_xor.v", "{state[86:0], state[99:87]}", "{state[85:0], state[99:86]}",
     "turned", true, false, "1\n0x8000000000000000000000000\n0\n",
     "word,out_valid,state,parity\n"
     "0x0000000000000000000000001,1,0x0000000000000000000000001,1\n"
     "0x8000000000000000000000000,1,0x8000000000000000000002000,0\n"
     "0x0000000000000000000000000,1,0x0000000000000000004001000,0\n"},
    {"wide_sum", "--width 256", "wide_sum.v", "sum <= a + b",
     "sum <= (a + b) & ~$signed(257'd1 << 200)", "sum", true, true,
     "-1 -1\n18446744073709551615 1\n0x7" ONES60 "fff,0x7" ONES60 "fff\n",
     "a,b,out_valid,sum\n"
     "0x" ONES60 "ffff,0x" ONES60 "ffff,1,0x1" ONES60 "fffe\n"
     "0x" ZERO16 ZERO16 ZERO16 "ffffffffffffffff,0x" ZERO16 ZERO16 ZERO16 "0000000000000001,1,0x"
     "0" ZERO16 ZERO16 "0000000000000001" ZERO16 "\n"
     "0x7" ONES60 "fff,0x7" ONES60 "fff,1,0x0" ONES60 "fffe\n"},
    {"signed_order", "--width 8", "signed_order.v", "b < a", "$unsigned(b) < $unsigned(a)", "swap",
     false, true, "-5 7\n127 -128\n",
     "a,b,lesser,greater,distance\n-5,7,-5,7,12\n127,-128,-128,127,255\n"},
    {"staged_alu", "--op subtract --width 8 --stages 3", "alu_stage.v", "in_value - in_operand",
     "in_value + in_operand", "value", false, true, "100 30\n5 2\n",
     "a,b,out_valid,result\n100,30,1,10\n5,2,1,255\n"},
    {"ring", "", "ring.v", "push && (!full || gone)", "push && !full", "taken", true, true,
     "-3\n7\n8\n9\n10\n",
     "data,taken,full,front,level\n-3,1,0,-3,1\n7,1,0,-3,2\n8,1,0,-3,3\n9,1,1,-3,4\n"
     "10,0,1,-3,4\n"},
    {"detector", "--form binary", "detector_binary.v", "default: state <= bit_in ? 2'd1 : 2'd2",
     "default: state <= bit_in ? 2'd1 : 2'd0", "state", true, false, "bit_in\n1\n0\n1\n1\n0\n",
     "bit_in,found,count\n1,0,0\n0,0,0\n1,0,0\n1,1,1\n0,0,1\n"},
    {"clip_lanes", "--lanes 3", "clip_lane.v", "-12'sd128 ? -8'sd128", "-12'sd127 ? -8'sd127",
     "clipped", false, true, "100 200 -2000\n",
     "x[0],x[1],x[2],out_valid,y[0],y[1],y[2]\n100,200,-2000,7,100,127,-128\n"},
    {"free_runner", "", "free_runner.v", "step} + 33'd1", "step} + 33'd2", "count__33", true, true,
     "5\n-1\n-16\n", "step,count__33\n5,6\n-1,6\n-16,8589934583\n"},
    {"serial_mul", "--width 6", "serial_mul.v", "busy && left == 5'd1", "busy && left == 5'd2",
     "done", false, false, "5 7\n63 63\n", "a,b,busy,done,product\n5,7,0,1,35\n63,63,0,1,3969\n"},
    {"wide_fifo", "--depth-log 1", "wide_fifo.v", "= !level[DEPTH_LOG]", "= 1'b1", "s_ready", false,
     false, "s_data m_ready\n5 0\n0x123456789012345678901234 0\n7 1\n",
     "s_data,m_ready,level,s_ready,m_valid,m_data\n"
     "0x000000000000000000000005,0,1,1,1,0x000000000000000000000005\n"
     "0x123456789012345678901234,0,2,0,1,0x000000000000000000000005\n"
     "0x000000000000000000000007,1,1,1,1,0x123456789012345678901234\n"},
    {"gray", "--width 64", "gray.v", "count >> 1", "count >> 2", "code", false, false,
     "clk mismatch ce_n\n1 0 0\n0 1 0\n1 0 1\n",
     "ce_n,clk,mismatch,code,wrapped\n0,1,0,6,0\n0,0,1,18446744073709551613,0\n1,1,0,2,0\n"},
};

enum { CIRCUITS = sizeof circuits / sizeof circuits[0] };

static void directory_of(const own_circuit *circuit, char path[OWN_PATH])
{
    (void)snprintf(path, OWN_PATH, OWN "%s", circuit->name);
}

static void it_is_verified(void **state)
{
    const own_circuit *circuit = *state;
    char directory[OWN_PATH];
    directory_of(circuit, directory);
    outcome done =
        own_run(directory, "", "verify --clocks 3000 %s", circuit->whole ? "" : circuit->options);
    assert_outcome(&done, 0, "");
    assert_says(done.out, "0 mismatches of ");
    assert_null(strstr(done.out, " 0 comparisons"));
    forget(&done);
}

/* With its packet, which shows the mismatch again, and none with the right circuit. */
static void its_wrong_copy_is_found(void **state)
{
    const own_circuit *circuit = *state;
    char right[OWN_PATH], wrong[OWN_PATH], packets[OWN_PATH], packet[OWN_PATH], name[256];
    directory_of(circuit, right);
    (void)snprintf(name, sizeof name, "wrong-%s", circuit->name);
    own_copy(right, name, wrong);
    own_edit(wrong, circuit->file, circuit->from, circuit->to);
    (void)snprintf(packets, sizeof packets, "%s/packets-%s", scratch_directory, circuit->name);

    outcome done = own_run(right, "", "verify --clocks 3000 --rtl %s --out %s %s", wrong, packets,
                           circuit->options);
    assert_int_equal(done.status, 1);
    assert_says(done.out, circuit->signal);
    forget(&done);

    own_only_entry(packets, packet);
    done = own_run(right, "", "replay %s --rtl %s --out %s-again", packet, wrong, packets);
    assert_int_equal(done.status, 1);
    assert_says(done.out, circuit->signal);
    forget(&done);
    done = own_run(right, "", "replay %s --rtl %s", packet, right);
    assert_outcome(&done, 0, "");
    assert_says(done.out, ": gone: ");
    forget(&done);
}

static void its_waveform_has_a_save_file(void **state)
{
    const own_circuit *circuit = *state;
    char directory[OWN_PATH], out[OWN_PATH];
    directory_of(circuit, directory);
    (void)snprintf(out, sizeof out, "%s/wave-%s", scratch_directory, circuit->name);
    outcome done = own_run(directory, "", "wave --out %s %s", out, circuit->options);
    assert_outcome(&done, 0, NULL);
    assert_says(done.out, ".fst");
    assert_says(done.out, ".gtkw");
    forget(&done);
}

static void eval_has_the_right_numbers(void **state)
{
    const own_circuit *circuit = *state;
    static const char *const backends[] = {"c", "rtl"};
    char directory[OWN_PATH];
    directory_of(circuit, directory);
    for (size_t i = 0; i < 2; i++) {
        outcome done = own_run(directory, circuit->input, "eval --backend %s %s", backends[i],
                               circuit->options);
        assert_outcome(&done, 0, "");
        assert_string_equal(done.out, circuit->output);
        forget(&done);
    }
}

/* All points of the two circuits with a domain; another reports that it has none. */
static void every_input_is_tried(void **state)
{
    (void)state;
    static const struct {
        const char *name, *options, *points;
    } domains[] = {{"signed_order", "--width 8", "65536 of 65536 points"},
                   {"signed_order", "--width 5", "1024 of 1024 points"},
                   {"serial_mul", "--width 6", "4096 of 4096 points"}};
    for (size_t i = 0; i < sizeof domains / sizeof domains[0]; i++) {
        char directory[OWN_PATH];
        (void)snprintf(directory, sizeof directory, OWN "%s", domains[i].name);
        outcome done = own_run(directory, "", "verify --exhaustive %s", domains[i].options);
        assert_outcome(&done, 0, "");
        assert_says(done.out, domains[i].points);
        assert_says(done.out, "\n0 mismatches of ");
        forget(&done);
    }
    outcome done = own_run(OWN "ring", "", "verify --exhaustive");
    assert_own_refused(&done, "no domain");
    forget(&done);
}

/* ---- What is wrong in a directory --------------------------------------------------------------
 */

static void what_is_wrong_is_said(void **state)
{
    (void)state;
    static const struct {
        const char *name, *circuit; /* the name is the copy's */
        const char *file, *from, *to;
        const char *words;
    } faults[] = {
        {"width", "rotate_xor", "rotate_xor.c", "DATA, 100, 0", "DATA, 90, 0",
         "pin word has 90 bits in the description and 100 in the Verilog of rotate_xor"},
        {"output-width", "rotate_xor", "rotate_xor.c", "OUTPUT, 100, 0", "OUTPUT, 101, 0",
         "output state has 101 bits in the description and 100 in the Verilog of rotate_xor"},
        {"signal-width", "rotate_xor", "rotate_xor.c", "BLOCK, 100, 0", "BLOCK, 99, 0",
         "signal turned has 99 bits in the description and 100 in the Verilog of rotate_xor"},
        {"signal", "rotate_xor", "rotate_xor.c",
         "GLINT_SIGNAL(signals_now, turned, BLOCK, 100, 0, 0,",
         "GLINT_SIGNAL_OF(signals_now, turned, \"turned\", \"twisted\", BLOCK, 100, 0, 0, -1,",
         "rotate_xor has no signal turned"},
        {"missing-pin", "rotate_xor", "rotate_xor.c", "GLINT_PIN(pins, in_valid, VALID, 1, 0, 0,",
         "GLINT_PIN_OF(pins, in_valid, \"taken\", VALID, 1, 0, 0, -1,",
         "rotate_xor has no pin taken"},
        {"pin", "rotate_xor", "rotate_xor.v", "clk,", "clk, input wire more,",
         "rotate_xor has an input more that is missing from the description"},
        {"clock", "rotate_xor", "rotate_xor.c", "\"clk\"", "\"clock\"",
         "rotate_xor has no clock clock"},
        {"top", "rotate_xor", "rotate_xor.c", ".name = \"rotate_xor\"", ".name = \"turn\"",
         "has no turn.v"},
        {"compiler", "rotate_xor", "rotate_xor.c", "typedef struct pins", "typedef strct pins",
         "the C files do not compile: rotate_xor.c:"},
        {"verilog", "rotate_xor", "rotate_xor.v", "endmodule", "endmodul", "rotate_xor.v:"},
        {"name", "rotate_xor", "rotate_xor.c", "glint_circuit glint_my_circuit",
         "glint_circuit my_circuit",
         "none of the *.c files defines the circuit, const glint_circuit glint_my_circuit"},
        {"no-title", "rotate_xor", "rotate_xor.c", ".title = \"Turned and mixed\",", "",
         "circuit rotate_xor has no title"},
        {"heading", "clip_lanes", "clip_lanes.c", "{.title = VALID}", "{.title = \"Valid\"}",
         "the circuit has no heading \"Valid bits\""},
        {"submodule", "ring", "ring.c", "\"u_sum.acc\"", "\"u_sum.sum\"",
         "ring has no signal sum (u_sum.sum)"},
        {"memory", "ring", "ring.c", "\"mem[\" #i", "\"mem[1\" #i",
         "ring has no signal mem0 (mem[10])"},
        {"scope", "clip_lanes", "clip_lanes.c", "\"lane[%d].u\"", "\"line[%d].u\"",
         "clip_lanes has no signal held (line[0].u.held)"},
        {"parameter", "wide_sum", "wide_sum.c", "\"WIDTH\"", "\"SIZE\"",
         "wide_sum has no parameter SIZE"},
        {"inout", "rotate_xor", "rotate_xor.v", "clk,", "clk, inout wire pad,",
         "rotate_xor has an inout port pad: only inputs and outputs are supported"},
        {"module", "rotate_xor", "rotate_xor.v", "module rotate_xor", "module rotate_xors",
         "rotate_xor.v has no module rotate_xor"},
        {"narrow-member", "rotate_xor", "rotate_xor.c", "state[2];", "state[1];",
         "its 100 bits want an array of uint64_t, not 8 bytes"},
        {"crash", "rotate_xor", "rotate_xor.c", "    settle(s);", "    __builtin_abort();",
         "the C model crashed: abort()"},
        {"exit", "free_runner", "free_runner.c",
         "    s->count +=", "    extern void exit(int);\n    exit(0);\n    s->count +=",
         "called exit(), so there is no verdict"},
        {"mealy", "signed_order", "signed_order.c", "lesser, OUTPUT", "lesser, MEALY",
         "signal lesser: without a clock its kind is OUTPUT, not MEALY"},
        {"option", "wide_sum", "wide_sum.c", ".name = \"width\"", ".name = \"seed\"",
         "a parameter cannot be named seed"},
    };
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        char directory[OWN_PATH], from[OWN_PATH];
        (void)snprintf(from, sizeof from, OWN "%s", faults[i].circuit);
        own_copy(from, faults[i].name, directory);
        own_edit(directory, faults[i].file, faults[i].from, faults[i].to);
        outcome done = own_run(directory, "", "verify --clocks 100");
        assert_own_refused(&done, faults[i].words);
        forget(&done);
    }
}

/* Nothing inside depends on `found`, so that its value before the edge is all there is of it. */
static void a_dead_mealy_output_is_found(void **state)
{
    (void)state;
    char wrong[OWN_PATH];
    own_copy(OWN "detector", "dead-output", wrong);
    own_edit(wrong, "detector_binary.v", "assign found = state == 2'd3 && bit_in;",
             "wire hit = state == 2'd3 && bit_in;\n    assign found = 1'b0;");
    own_edit(wrong, "detector_binary.v", "{7'd0, found}", "{7'd0, hit}");
    outcome done =
        own_run(OWN "detector", "", "verify --form binary --clocks 3000 --rtl %s --out %s", wrong,
                scratch_path("packets-dead"));
    assert_int_equal(done.status, 1);
    assert_says(done.out, ": found, ");
    forget(&done);
}

/* The same output as kind OUTPUT is compared after the edge alone, which is said. */
static void an_output_that_follows_a_pin_is_named(void **state)
{
    (void)state;
    outcome done = own_run(OWN "gray", "", "verify --width 5 --clocks 3000");
    assert_outcome(&done, 0, "");
    assert_says(done.out, "not covered: ");
    assert_says(done.out,
                "code before the edge, where it follows a pin (kind MEALY compares that)");
    forget(&done);
    done = own_run(OWN "ring", "", "verify --clocks 3000");
    assert_null(strstr(done.out, "before the edge"));
    forget(&done);
}

/* Both sides stand still, and agree. */
static void a_wrong_polarity_is_no_verdict(void **state)
{
    (void)state;
    static const struct {
        const char *circuit, *file, *from, *to, *words;
    } faults[] = {
        {"rotate_xor", "rotate_xor.c", "reset, RESET,", "reset, RESET_LOW,", "the roles of reset"},
        {"ring", "ring.c", "rst_n, RESET_LOW,", "rst_n, RESET,", "the roles of rst_n"},
        {"gray", "gray.c", "ce_n, ENABLE_LOW,", "ce_n, ENABLE,", "the roles of ce_n"},
    };
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        char from[OWN_PATH], directory[OWN_PATH], name[64];
        (void)snprintf(from, sizeof from, OWN "%s", faults[i].circuit);
        (void)snprintf(name, sizeof name, "polarity-%s", faults[i].circuit);
        own_copy(from, name, directory);
        own_edit(directory, faults[i].file, faults[i].from, faults[i].to);
        outcome done = own_run(directory, "", "verify --clocks 5000");
        assert_int_equal(done.status, 2);
        assert_says(done.err, "no signal changed in ");
        assert_says(done.out, "no verdict: ");
        assert_null(strstr(done.out, "0 mismatches"));
        assert_says(done.err, faults[i].words);
        forget(&done);
    }
}

/* A packet's waveform has variables of its own, which then have other names. */
static void pins_may_be_called_as_a_packet_s_variables(void **state)
{
    (void)state;
    char wrong[OWN_PATH], packets[OWN_PATH], packet[OWN_PATH], path[OWN_PATH + 20];
    own_copy(OWN "gray", "gray-again", wrong);
    own_edit(wrong, "gray.v", "count >> 1", "count >> 2");
    (void)snprintf(packets, sizeof packets, "%s/packets-of-names", scratch_directory);
    outcome done =
        own_run(OWN "gray", "", "verify --width 5 --clocks 3000 --rtl %s --out %s", wrong, packets);
    assert_int_equal(done.status, 1);
    forget(&done);
    own_only_entry(packets, packet);
    static const struct {
        const char *file, *words;
    } expected[] = {
        {"wave.vcd", " glint_mismatch $end\n"},
        {"wave.vcd", " mismatch $end\n"},
        {"wave.vcd", " glint_clk $end\n"},
        {"wave.vcd", " clk $end\n"},
        {"wave.gtkw", "+{glint_clk} TOP.glint_clk\n"},
        {"wave.gtkw", "+{clk} TOP.clk\n"},
        {"wave.vcd", " clock [47:0] $end\n"},
    };
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        (void)snprintf(path, sizeof path, "%s/%s", packet, expected[i].file);
        char *text = scratch_read(path, NULL);
        assert_says(text, expected[i].words);
        free(text);
    }
}

static void a_directory_without_a_circuit_is_refused(void **state)
{
    (void)state;
    char empty[OWN_PATH];
    own_make("empty", empty);
    outcome done = own_run(empty, "", "verify");
    assert_own_refused(&done, "empty");
    forget(&done);
    done = own_run(scratch_path("nowhere"), "", "verify");
    assert_own_refused(&done, "nowhere");
    forget(&done);
}

/* What the C model is made of may lie in several files; two circuits may not. */
static void several_files_make_one_circuit(void **state)
{
    (void)state;
    char directory[OWN_PATH], path[OWN_PATH + 100];
    own_copy(OWN "rotate_xor", "several", directory);
    own_edit(directory, "rotate_xor.c", "static void settle(",
             "void settle(signals_now *s);\nvoid settle(");
    (void)snprintf(path, sizeof path, "%s/more.c", directory);
    scratch_write(path, "int more(void);\nint more(void) { return 1; }\n", 44);
    outcome done = own_run(directory, "", "verify --clocks 100");
    assert_outcome(&done, 0, "");
    forget(&done);

    static const char twice[] = "#include \"glint_circuit.h\"\n"
                                "const glint_circuit glint_my_circuit = {.name = \"second\"};\n";
    scratch_write(path, twice, sizeof twice - 1);
    done = own_run(directory, "", "verify --clocks 100");
    assert_own_refused(&done, "glint_my_circuit");
    forget(&done);
}

static void a_blank_in_the_name_does_no_harm(void **state)
{
    (void)state;
    char directory[OWN_PATH];
    own_copy(OWN "rotate_xor", "with blank", directory);
    char *argv[] = {NULL,
                    (char[]){"--circuit-dir"},
                    directory,
                    (char[]){"verify"},
                    (char[]){"--clocks"},
                    (char[]){"100"},
                    NULL};
    const plumbing none = {0};
    outcome done = run_arguments(argv, "", 0, &none);
    assert_outcome(&done, 0, "");
    assert_says(done.out, "0 mismatches of 400 comparisons");
    forget(&done);
}

/* ---- All of them -------------------------------------------------------------------------------
 */

int main(void)
{
    static char names[4 * CIRCUITS][128];
    struct CMUnitTest tests[4 * CIRCUITS + 9] = {{0}}; /* those without a name are no tests */
    static const struct {
        const char *what;
        CMUnitTestFunction run;
    } each[] = {{"is verified", it_is_verified},
                {"has a wrong copy that is found", its_wrong_copy_is_found},
                {"has a waveform", its_waveform_has_a_save_file},
                {"is evaluated", eval_has_the_right_numbers}};
    static const struct CMUnitTest others[] = {
        cmocka_unit_test(every_input_is_tried),
        cmocka_unit_test(what_is_wrong_is_said),
        cmocka_unit_test(a_dead_mealy_output_is_found),
        cmocka_unit_test(an_output_that_follows_a_pin_is_named),
        cmocka_unit_test(a_wrong_polarity_is_no_verdict),
        cmocka_unit_test(pins_may_be_called_as_a_packet_s_variables),
        cmocka_unit_test(a_directory_without_a_circuit_is_refused),
        cmocka_unit_test(several_files_make_one_circuit),
        cmocka_unit_test(a_blank_in_the_name_does_no_harm),
    };
    size_t count = 0;
    for (size_t c = 0; c < CIRCUITS; c++) {
        for (size_t t = 0; t < sizeof each / sizeof each[0]; t++) {
            if (each[t].run == its_waveform_has_a_save_file && !circuits[c].waves)
                continue;
            (void)snprintf(names[count], sizeof names[count], "%s %s", circuits[c].name,
                           each[t].what);
            tests[count] = (struct CMUnitTest){names[count], each[t].run, NULL, NULL,
                                               (void *)(uintptr_t)&circuits[c]};
            count++;
        }
    }
    for (size_t t = 0; t < sizeof others / sizeof others[0]; t++)
        tests[count++] = others[t];
    return cmocka_run_group_tests_name("own_circuit", tests, scratch_make, scratch_remove);
}
