/* What the Verilog of a user's circuit brings along and says: packages, files of data, and lines
 * that it prints; and what becomes of C that ends the program. Each is a copy of a small circuit
 * with other Verilog or C. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"
#include "../cli/run.h"
#include "own.h"

#define OWN "tests/circuit/own/"

static void write_file(const char *directory, const char *name, const char *text)
{
    char path[OWN_PATH + 100];
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    scratch_write(path, text, strlen(text));
}

static void remove_file(const char *directory, const char *name)
{
    char path[OWN_PATH + 100];
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    assert_int_equal(remove(path), 0);
}

static void verify(const char *directory, int status, const char *words)
{
    outcome done =
        own_run(directory, "", "verify --clocks 300 --seed 1 --out %s", scratch_path("packets"));
    assert_int_equal(done.status, status);
    assert_says(status == 2 ? done.err : done.out, words);
    forget(&done);
}

/* ---- Packages ---------------------------------------------------------------------------------
 */

/* Not in the order of their names, one of them by what a header says, one not in a file of its
 * name, and one of them with a module. */
static void packages_come_first(void **state)
{
    (void)state;
    char directory[OWN_PATH];
    own_copy(OWN "free_runner", "packages", directory);
    remove_file(directory, "free_runner.v");
    write_file(directory, "a_counts.sv",
               "`include \"uses.svh\"\n"
               "package counts;\n    typedef logic [`WIDTH-1:0] count_t;\nendpackage\n"
               "module plus import counts::*; (input count_t a, input count_t b,\n"
               "    output count_t c);\n    assign c = a + b;\nendmodule\n");
    write_file(directory, "uses.svh", "`define WIDTH sizes :: WIDTH + 1\n");
    write_file(directory, "z.sv", "package sizes;\n    localparam int WIDTH = 32;\nendpackage\n");
    write_file(directory, "free_runner.sv",
               "module free_runner import counts::*; (\n"
               "    input logic clk_i, input logic signed [4:0] step, output count_t count__33);\n"
               "    initial count__33 = 0;\n"
               "    count_t next;\n"
               "    plus u_plus (.a(count__33), .b(count_t'(step) + 1), .c(next));\n"
               "    always_ff @(posedge clk_i) count__33 <= next;\n"
               "endmodule\n");
    verify(directory, 0, "0 mismatches of 300 comparisons");
    outcome done = own_run(directory, "", "wave --out %s", scratch_path("waves"));
    assert_outcome(&done, 0, "");
    forget(&done);
    done = own_run(directory, "5\n", "eval --backend rtl");
    assert_outcome(&done, 0, "");
    assert_string_equal(done.out, "step,count__33\n5,6\n");
    forget(&done);
}

/* ---- Data -------------------------------------------------------------------------------------
 */

/* Found beside the Verilog, built anew when it is edited, and missed when it is not there: a memory
 * of zeros would be right here. */
static void a_file_of_data_lies_beside_the_verilog(void **state)
{
    (void)state;
    char directory[OWN_PATH], other[OWN_PATH];
    own_copy(OWN "free_runner", "data", directory);
    own_edit(directory, "free_runner.v", "initial count__33 = 33'd0;",
             "reg [32:0] start [0:0];\n    initial begin $readmemh(\"start.hex\", start);\n"
             "        count__33 = start[0]; end");
    write_file(directory, "start.hex", "0\n");
    verify(directory, 0, "0 mismatches of 300 comparisons");
    outcome done = own_run(directory, "", "wave --out %s", scratch_path("waves"));
    assert_outcome(&done, 0, "");
    forget(&done);

    own_copy(directory, "edited-data", other);
    write_file(other, "start.hex", "1\n");
    verify(other, 1, "300 mismatches of 300");
    done = own_run(directory, "", "verify --clocks 300 --seed 1 --rtl %s --out %s", other,
                   scratch_path("packets"));
    assert_int_equal(done.status, 1);
    forget(&done);

    remove_file(other, "start.hex");
    done = own_run(other, "", "verify --clocks 300");
    assert_own_refused(&done, "start.hex: $readmem file not found; it belongs into the directory "
                              "with the Verilog");
    forget(&done);
}

/* What the Verilog writes is a file where the command runs, whether an earlier run has left one
 * beside the Verilog, and whether that one is taken for a source (by a name that is not in the
 * call) or not. */
static void a_file_that_is_written_is_not_the_one_kept(void **state)
{
    (void)state;
    static const char *const calls[] = {
        "initial begin log = $fopen(\"glint-run.log\", \"w\");",
        "localparam NAME = \"glint-run.log\";\n    initial begin log = $fopen(NAME, \"w\");",
    };
    for (size_t i = 0; i < 2; i++) {
        char directory[OWN_PATH], verilog[1000];
        own_copy(OWN "free_runner", i == 0 ? "log" : "named-log", directory);
        (void)snprintf(
            verilog, sizeof verilog,
            "reg [32:0] start [0:0];\n    integer log;\n"
            "    initial begin $readmemh(\"rom.hex\", start); count__33 = start[0]; end\n"
            "    %s $fwrite(log, \"begun\"); $fclose(log); end",
            calls[i]);
        own_edit(directory, "free_runner.v", "initial count__33 = 33'd0;", verilog);
        write_file(directory, "rom.hex", "0\n");
        write_file(directory, "glint-run.log", "before");
        verify(directory, 0, "0 mismatches of 300 comparisons");
        char *text = scratch_read("glint-run.log", NULL);
        assert_int_equal(remove("glint-run.log"), 0);
        assert_string_equal(text, "begun");
        free(text);
    }
}

/* ---- Words ------------------------------------------------------------------------------------
 */

static void what_the_verilog_prints_is_not_among_the_results(void **state)
{
    (void)state;
    char directory[OWN_PATH];
    own_copy(OWN "free_runner", "words", directory);
    own_edit(directory, "free_runner.v", "    always @(posedge clk_i) ",
             "    always @(posedge clk_i) $display(\"now %d\", count__33);\n"
             "    always @(posedge clk_i) ");
    outcome done = own_run(directory, "5\n", "eval --backend rtl");
    assert_outcome(&done, 0, NULL);
    assert_string_equal(done.out, "step,count__33\n5,6\n");
    assert_says(done.err, "now ");
    forget(&done);
    done = own_run(directory, "", "verify --clocks 30 --json");
    assert_outcome(&done, 0, NULL);
    assert_int_equal(done.out[0], '{');
    assert_null(strstr(done.out, "now "));
    assert_says(done.err, "now ");
    forget(&done);
}

/* ---- Waveforms --------------------------------------------------------------------------------
 */

static const char lanes_in_a_block[] =
    "    generate\n"
    "        for (i = 0; i < LANES; i = i + 1) begin : lane\n"
    "            wire signed [11:0] number = x[i*12 +: 12];\n"
    "            reg signed [11:0] held;\n"
    "            wire signed [7:0] clipped = held > 12'sd127 ? 8'sd127\n"
    "                : held < -12'sd128 ? -8'sd128 : held[7:0];\n"
    "            reg signed [7:0] result;\n"
    "            assign y[i*8 +: 8] = result;\n"
    "            always @(posedge clk)\n"
    "                if (reset) begin held <= 0; result <= 0; end\n"
    "                else if (en) begin\n"
    "                    if (in_valid[i]) held <= number;\n"
    "                    result <= clipped;\n"
    "                end\n"
    "        end\n"
    "    endgenerate\nendmodule\n";

/* Every row of a save file names what the VCD has: a name below the scopes before it. */
static void assert_rows_are_there(const char *saved, const char *waveform)
{
    int rows = 0;
    for (const char *line = saved; (line = strstr(line, "\n+{")) != NULL; rows++) {
        char declared[300];
        const char *name = strstr(++line, "} TOP.") + 6;
        const char *end = name + strcspn(name, "\n");
        const char *last = end;
        while (last[-1] != '.')
            last--;
        const int length = (int)strcspn(last, "[\n");
        (void)snprintf(declared, sizeof declared, " %.*s%s%.*s $end", length, last,
                       last + length < end ? " " : "", (int)(end - last) - length, last + length);
        if (strstr(waveform, declared) == NULL)
            fail_msg("the waveform has no%s", declared);
    }
    assert_true(rows > 5);
}

/* A generate block has no ports: the whole ones are shown, and no row is dead. */
static void lanes_in_a_bare_block_have_rows_that_exist(void **state)
{
    (void)state;
    char directory[OWN_PATH], path[OWN_PATH + 100];
    own_copy(OWN "clip_lanes", "bare", directory);
    remove_file(directory, "clip_lane.v");
    own_edit(directory, "clip_lanes.c", "\"lane[%d].u\"", "\"lane[%d]\"");
    (void)snprintf(path, sizeof path, "%s/clip_lanes.v", directory);
    char *text = scratch_read(path, NULL), *at = strstr(text, "    generate\n");
    assert_non_null(at);
    *at = '\0';
    char *whole = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&whole, &size);
    assert_non_null(out);
    assert_true(fprintf(out, "%s%s", text, lanes_in_a_block) > 0);
    assert_int_equal(fclose(out), 0);
    scratch_write(path, whole, size);
    free(whole);
    free(text);

    outcome done =
        own_run(directory, "", "wave --lanes 3 --format vcd --out %s", scratch_path("bare-waves"));
    assert_outcome(&done, 0, "");
    forget(&done);
    char *saved = scratch_read(scratch_path("bare-waves/clip_lanes_3.gtkw"), NULL);
    char *waveform = scratch_read(scratch_path("bare-waves/clip_lanes_3.vcd"), NULL);
    assert_says(saved, "TOP.clip_lanes.x[35:0]\n");
    assert_says(saved, "TOP.clip_lanes.y[23:0]\n");
    assert_says(saved, "TOP.clip_lanes.lane[2].held[11:0]\n");
    assert_rows_are_there(saved, waveform);
    free(saved);
    free(waveform);
}

/* ---- The C files ------------------------------------------------------------------------------
 */

/* What waits for the lock of a circuit would be there only until it is built. */
static void a_crash_leaves_no_lock(void **state)
{
    (void)state;
    char directory[OWN_PATH], *shared = NULL;
    const char *cache = getenv("GLINT_CACHE");
    if (cache != NULL)
        assert_non_null(shared = strdup(cache));
    own_copy(OWN "free_runner", "crash", directory);
    own_edit(directory, "free_runner.c", "static void clock_edge(",
             "__attribute__((constructor)) static void crash(void)\n{\n    __builtin_abort();\n}\n"
             "static void clock_edge(");
    assert_int_equal(mkdir(scratch_path("cache"), 0777), 0);
    assert_int_equal(setenv("GLINT_CACHE", scratch_path("cache"), 1), 0);
    outcome done = own_run(directory, "", "info");
    assert_own_refused(&done, "crashed in the description");
    forget(&done);
    char entry[OWN_PATH];
    own_only_entry(scratch_path("cache"), entry);
    assert_non_null(strstr(entry, "/own-"));
    assert_null(strstr(entry, ".lock"));
    if (shared != NULL)
        assert_int_equal(setenv("GLINT_CACHE", shared, 1), 0);
    else
        assert_int_equal(unsetenv("GLINT_CACHE"), 0);
    free(shared);
}

/* Ctrl-C while the model begins, or before: no line that could be taken for a verdict. */
static void an_interrupt_before_the_first_comparison_is_no_verdict(void **state)
{
    (void)state;
    static const char *const ways[] = {NULL, "--json"};
    char directory[OWN_PATH];
    own_copy(OWN "free_runner", "slow", directory);
    own_edit(directory, "free_runner.c", "static void clock_edge(",
             "#include <unistd.h>\nstatic void begin(const int *values, void *model)\n{\n"
             "    (void)values, (void)model;\n    sleep(3);\n}\nstatic void clock_edge(");
    own_edit(directory, "free_runner.c", "GLINT_MODEL(signals_now, NULL,",
             "GLINT_MODEL(signals_now, begin,");
    outcome done = own_run(directory, "", "info"); /* compiles it */
    assert_outcome(&done, 0, "");
    forget(&done);
    for (size_t i = 0; i < 2; i++) {
        const char *const argv[] = {glint_under_test(), "--circuit-dir", directory,
                                    "verify",           ways[i],         NULL};
        const pid_t child = child_start(argv, scratch_path("slow.out"), scratch_path("slow.err"));
        child_wait_for_handler(child);
        for (int wait = 0; wait < 10; wait++)
            child_pause();
        assert_int_equal(kill(child, SIGINT), 0);
        assert_int_equal(child_wait(child, 60.0), 2);
        char *out = scratch_read(scratch_path("slow.out"), NULL);
        if (i == 0)
            assert_says(out, "no verdict: nothing was compared");
        else
            assert_says(out, "\"interrupted\":\ttrue");
        assert_null(strstr(out, "0 mismatches"));
        free(out);
    }
}

/* The examples of its --help are for a circuit of one's own, none of which has lanes here. */
static void the_examples_have_only_its_options(void **state)
{
    (void)state;
    static const char *const commands[] = {"verify", "wave", "info", "draw", "eval"};
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        outcome done = own_run(OWN "free_runner", "", "%s --help", commands[i]);
        assert_outcome(&done, 0, "");
        assert_null(strstr(done.out, "--lanes"));
        assert_null(strstr(done.out, "--gate"));
        assert_null(strstr(done.out, "--circuit divider"));
        if (i < 4)
            assert_says(done.out, "glint --circuit-dir DIR ");
        forget(&done);
    }
}

static void a_compiler_that_says_nothing_is_named(void **state)
{
    (void)state;
    char *before = NULL;
    const char *compiler = getenv("CC");
    if (compiler != NULL)
        assert_non_null(before = strdup(compiler));
    assert_int_equal(setenv("CC", "/bin/false", 1), 0);
    outcome done = own_run(OWN "free_runner", "", "info");
    assert_own_refused(&done, "do not compile: /bin/false gives no reason");
    forget(&done);
    if (before != NULL)
        assert_int_equal(setenv("CC", before, 1), 0);
    else
        assert_int_equal(unsetenv("CC"), 0);
    free(before);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(packages_come_first),
        cmocka_unit_test(a_file_of_data_lies_beside_the_verilog),
        cmocka_unit_test(a_file_that_is_written_is_not_the_one_kept),
        cmocka_unit_test(what_the_verilog_prints_is_not_among_the_results),
        cmocka_unit_test(lanes_in_a_bare_block_have_rows_that_exist),
        cmocka_unit_test(a_crash_leaves_no_lock),
        cmocka_unit_test(a_compiler_that_says_nothing_is_named),
        cmocka_unit_test(the_examples_have_only_its_options),
        cmocka_unit_test(an_interrupt_before_the_first_comparison_is_no_verdict),
    };
    return cmocka_run_group_tests_name("surroundings", tests, scratch_make, scratch_remove);
}
