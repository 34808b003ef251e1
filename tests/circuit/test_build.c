/* How a setting's circuit is obtained: found in the cache or built when its Verilog changes, by
 * exactly one of its users, completely or not at all; and the messages for Verilog that does not
 * build or does not match the description. The circuit is the test's own counter, in the test's own
 * cache; only Verilator's runtime is shared. */
#define _GNU_SOURCE /* nftw, flock */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <time.h>

#include "../scratch.h"

#include "circuit/circuits.h"
#include "circuit/words.h"
#include "glint_describe.h"
#include "rtl/build.h"
#include "rtl/place.h"
#include "rtl/tools.h"

/* ---- The circuit ----------------------------------------------------------------------------- */

typedef struct counter_pins {
    uint8_t reset, en;
    uint8_t step;
} counter_pins;

typedef struct counter_signals {
    int64_t next, count;
} counter_signals;

enum { WIDTH };

/* What the tests of wrong descriptions change. */
static const char *parameter_name = "WIDTH";
static const char *pin_name = "step", *signal_path = "next";
static int signal_wider, pin_wider;

GLINT_PIN_TABLE(pin, GLINT_PIN(counter_pins, reset, RESET, 1, 0, 0, ""),
                GLINT_PIN(counter_pins, en, ENABLE, 1, 0, 0, ""),
                GLINT_PIN_OF(counter_pins, step, pin_name, DATA, 4 + pin_wider, 0, 0, -1, ""))
GLINT_SIGNAL_TABLE(signal_at,
                   GLINT_SIGNAL_OF(counter_signals, next, "next", signal_path, BLOCK,
                                   values[WIDTH] + signal_wider, 0, 0, -1, NULL, ""),
                   GLINT_SIGNAL(counter_signals, count, OUTPUT, values[WIDTH], 0, 0, NULL, ""))

static glint_parameter parameters[] = {
    {.name = "width", .meaning = "bits", .min = 4, .max = 100, .standard = 8}};

/* Its Verilog is looked at, never its C model. */
static glint_circuit counter = {
    .name = "counter",
    .title = "Counter",
    .clock_port = "clk",
    .parameters = parameters,
    .parameter_count = 1,
    GLINT_PINS(counter_pins, pin),
    GLINT_SIGNALS(signal_at),
};

static const char verilog[] = "module counter #(parameter WIDTH = 4) (\n"
                              "    input wire clk, input wire reset, input wire en,\n"
                              "    input wire [3:0] step, output reg [WIDTH-1:0] count\n"
                              ");\n"
                              "    wire [WIDTH-1:0] next = count + {{(WIDTH-4){1'b0}}, step};\n"
                              "    always @(posedge clk)\n"
                              "        if (reset) count <= {WIDTH{1'b0}};\n"
                              "        else if (en) count <= next;\n"
                              "endmodule\n";

static char directory[600];

/* The Verilog with one place changed. */
static void write_verilog(const char *from, const char *to)
{
    char path[700], text[2000];
    const char *found = strstr(verilog, from);
    assert_non_null(found);
    (void)snprintf(text, sizeof text, "%.*s%s%s", (int)(found - verilog), verilog, to,
                   found + strlen(from));
    (void)snprintf(path, sizeof path, "%s/counter.v", directory);
    scratch_write(path, text, strlen(text));
}

static glint_setting setting_of(int width)
{
    parameters[0].verilog = parameter_name;
    return (glint_setting){.circuit = &counter, .values = {width}, .verilog = directory};
}

/* What it counts to in three steps of 5. */
static uint64_t count_of(int width, glint_rtl_kind kind)
{
    const glint_setting setting = setting_of(width);
    uint64_t words[GLINT_SIGNAL_WORDS_MAX] = {0};
    int place[3];
    glint_error err = {""};
    glint_rtl *rtl;
    if (glint_rtl_open(&setting, kind, &rtl, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    const counter_pins pins = {.en = 1, .step = 5};
    for (int i = 0; i < 3; i++)
        glint_rtl_clock(rtl, &pins);
    glint_rtl_read(rtl, words);
    glint_rtl_destroy(rtl);
    assert_true(glint_signal_places(&setting, place));
    return words[place[1]];
}

/* ---- The tools: Verilator behind a script that keeps count ----------------------------------- */

/* While the file `hold` is there, Verilator takes its time. */
static void write_verilator(const char *real)
{
    char text[3000];
    (void)snprintf(
        text, sizeof text,
        "#!/bin/sh\n"
        "echo \"$*\" >>'%s'\n"
        "case $1 in --cc) if [ -e '%s' ]; then echo $$ >'%s'; exec sleep 60; fi ;; esac\n"
        "exec '%s' \"$@\"\n",
        scratch_path("calls"), scratch_path("hold"), scratch_path("held"), real);
    scratch_write(scratch_path("verilator"), text, strlen(text));
    assert_int_equal(chmod(scratch_path("verilator"), 0755), 0);
    assert_int_equal(setenv("VERILATOR", scratch_path("verilator"), 1), 0);
}

/* How often Verilator has built a circuit since the last call. */
static int builds(void)
{
    int count = 0;
    if (access(scratch_path("calls"), R_OK) != 0)
        return 0;
    char *calls = scratch_read(scratch_path("calls"), NULL);
    for (const char *line = calls; (line = strstr(line, "--cc ")) != NULL; line++)
        count++;
    free(calls);
    (void)remove(scratch_path("calls"));
    return count;
}

static void find_real(char path[1000])
{
    FILE *out = popen("command -v \"${VERILATOR:-verilator}\"", "r");
    assert_non_null(out);
    assert_non_null(fgets(path, 1000, out));
    path[strcspn(path, "\n")] = '\0';
    (void)pclose(out);
}

/* A link to what the cache of the build has of Verilator's runtime. */
static void link_runtime(const char *cache)
{
    char from[1400], to[1400];
    DIR *listing = opendir(cache);
    const struct dirent *entry;
    assert_non_null(listing);
    while ((entry = readdir(listing)) != NULL)
        if (strncmp(entry->d_name, "runtime-", 8) == 0 && strstr(entry->d_name, ".lock") == NULL) {
            (void)snprintf(from, sizeof from, "%s/%s", cache, entry->d_name);
            (void)snprintf(to, sizeof to, "%s/%s", scratch_path("cache"), entry->d_name);
            assert_int_equal(symlink(from, to), 0);
        }
    (void)closedir(listing);
}

static int set_up(void **state)
{
    char *cache, *built = NULL, real[1000];
    glint_error err = {""};
    if (scratch_make(state) != 0)
        return -1;
    (void)snprintf(directory, sizeof directory, "%s", scratch_path("verilog"));
    assert_int_equal(mkdir(directory, 0777), 0);
    assert_int_equal(mkdir(scratch_path("cache"), 0777), 0);
    write_verilog("", "");
    const glint_setting setting = setting_of(8);
    if (glint_place_cache(&cache, &err) != GLINT_OK ||
        glint_rtl_build(&setting, GLINT_RTL_OBSERVED, &built, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    link_runtime(cache);
    free(cache);
    free(built);
    assert_int_equal(setenv("GLINT_CACHE", scratch_path("cache"), 1), 0);
    find_real(real);
    write_verilator(real);
    return 0;
}

/* No work directory, no lock: what is in the cache is whole. */
static void assert_nothing_half_built(void)
{
    DIR *listing = opendir(scratch_path("cache"));
    const struct dirent *entry;
    assert_non_null(listing);
    while ((entry = readdir(listing)) != NULL)
        if (strstr(entry->d_name, ".tmp") != NULL || strstr(entry->d_name, ".lock") != NULL)
            fail_msg("%s is left", entry->d_name);
    (void)closedir(listing);
}

/* ---- Building -------------------------------------------------------------------------------- */

static void a_circuit_is_built_once(void **state)
{
    (void)state;
    write_verilog("", "");
    assert_int_equal(count_of(8, GLINT_RTL_OBSERVED), 15);
    assert_int_equal(builds(), 1);
    assert_int_equal(count_of(8, GLINT_RTL_OBSERVED), 15);
    assert_int_equal(builds(), 0);
    assert_nothing_half_built();
}

static void an_edit_builds_anew_and_its_undoing_does_not(void **state)
{
    (void)state;
    write_verilog("count + {", "count - {");
    assert_int_equal(count_of(8, GLINT_RTL_OBSERVED), 256 - 15);
    assert_int_equal(builds(), 1);
    write_verilog("", "");
    assert_int_equal(count_of(8, GLINT_RTL_OBSERVED), 15);
    assert_int_equal(builds(), 0);
}

static void a_fast_circuit_of_another_width(void **state)
{
    (void)state;
    assert_int_equal(count_of(4, GLINT_RTL_FAST), 15);
    assert_int_equal(builds(), 1);
}

static void write_file(const char *name, const char *text)
{
    char path[700];
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    scratch_write(path, text, strlen(text));
}

static void remove_file(const char *name)
{
    char path[700];
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    assert_int_equal(unlink(path), 0);
}

/* An edit of a file that the top cannot reach builds nothing; of one that it can reach, it does,
 * though its modules have other names than the file. */
static void what_is_needed_is_built_anew(void **state)
{
    (void)state;
    static const char sum[] = "module unused; nothing n(); endmodule\n"
                              "module sum #(parameter W = 4) (input wire [W-1:0] a,\n"
                              "    input wire [3:0] b, output wire [W-1:0] c);\n"
                              "    assign c = a + b;\nendmodule\n";
    const glint_rtl_kind both[] = {GLINT_RTL_OBSERVED, GLINT_RTL_FAST};
    write_file("other.v", "module other; endmodule\n");
    assert_int_equal(count_of(8, GLINT_RTL_OBSERVED), 15);
    write_file("other.v", "no Verilog\n");
    assert_int_equal(count_of(8, GLINT_RTL_OBSERVED), 15);
    assert_int_equal(builds(), 0);
    write_verilog("next = count + {{(WIDTH-4){1'b0}}, step};",
                  "next; sum #(WIDTH) s (count, step, next);");
    for (int i = 0; i < 2; i++) {
        char text[1000];
        (void)snprintf(text, sizeof text, "%s", sum);
        write_file("parts.v", text);
        assert_int_equal(count_of(8, both[i]), 15);
        assert_int_equal(builds(), 1);
        *strchr(text, '+') = '-';
        write_file("parts.v", text);
        assert_int_equal(count_of(8, both[i]), 256 - 15);
        assert_int_equal(builds(), 1);
    }
    remove_file("other.v");
    remove_file("parts.v");
    write_verilog("", "");
}

static void system_verilog_is_read_too(void **state)
{
    (void)state;
    remove_file("counter.v");
    write_file("counter.sv", "`include \"types.svh\"\n"
                             "module counter #(parameter WIDTH = 4) (input logic clk, reset, en,\n"
                             "    input nibble step, output logic [WIDTH-1:0] count);\n"
                             "    logic [WIDTH-1:0] next;\n"
                             "    always_comb next = count + WIDTH'(step);\n"
                             "    always_ff @(posedge clk)\n"
                             "        if (reset) count <= '0; else if (en) count <= next;\n"
                             "endmodule\n");
    write_file("types.svh", "typedef logic [3:0] nibble;\n");
    assert_int_equal(count_of(8, GLINT_RTL_OBSERVED), 15);
    assert_int_equal(count_of(8, GLINT_RTL_FAST), 15);
    remove_file("counter.sv");
    remove_file("types.svh");
    write_verilog("", "");
    (void)builds();
}

/* Two processes and, in each, glint_rtl_build_all() with the same circuit twice. */
static void who_comes_second_waits(void **state)
{
    (void)state;
    pid_t child[2];
    for (int i = 0; i < 2; i++)
        if ((child[i] = fork()) == 0) {
            const glint_setting settings[] = {setting_of(70), setting_of(70)};
            const glint_rtl_build_control control = {.threads = 2};
            glint_error err;
            _exit((int)glint_rtl_build_all(settings, 2, GLINT_RTL_OBSERVED, &control, &err));
        }
    for (int i = 0; i < 2; i++) {
        int status;
        assert_int_equal(waitpid(child[i], &status, 0), child[i]);
        assert_true(WIFEXITED(status));
        assert_int_equal(WEXITSTATUS(status), GLINT_OK);
    }
    assert_int_equal(builds(), 1);
    assert_nothing_half_built();
}

enum { RUNTIMES_MAX = 16 };

/* Locks the runtimes of a cache that has none, by the names of those that the other one has. */
static int lock_runtimes(const char *cold, int locks[RUNTIMES_MAX])
{
    char path[1400];
    int count = 0;
    DIR *listing = opendir(scratch_path("cache"));
    const struct dirent *entry;
    assert_non_null(listing);
    while ((entry = readdir(listing)) != NULL)
        if (strncmp(entry->d_name, "runtime-", 8) == 0) {
            assert_in_range(count, 0, RUNTIMES_MAX - 1);
            (void)snprintf(path, sizeof path, "%s/%s.lock", cold, entry->d_name);
            locks[count] = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
            assert_int_equal(flock(locks[count++], LOCK_EX), 0);
        }
    (void)closedir(listing);
    assert_int_not_equal(count, 0);
    return count;
}

/* The locks are the test's own: the child would hold them too. */
static pid_t build_apart(int width, const int *locks, int count)
{
    const pid_t child = fork();
    if (child != 0)
        return child;
    const glint_setting setting = setting_of(width);
    char *built;
    glint_error err;
    for (int i = 0; i < count; i++)
        (void)close(locks[i]);
    _exit((int)glint_rtl_build(&setting, GLINT_RTL_OBSERVED, &built, &err));
}

/* While another process makes the runtime, a circuit is Verilated; only its linking waits. */
static void who_lacks_the_runtime_waits_late(void **state)
{
    (void)state;
    char cold[700];
    char *kept = strdup(getenv("GLINT_CACHE"));
    int locks[RUNTIMES_MAX], status, begun = 0;
    (void)snprintf(cold, sizeof cold, "%s", scratch_path("cold"));
    assert_non_null(kept);
    assert_int_equal(mkdir(cold, 0777), 0);
    const int count = lock_runtimes(cold, locks);
    (void)builds();
    assert_int_equal(setenv("GLINT_CACHE", cold, 1), 0);
    const pid_t child = build_apart(21, locks, count);
    for (int i = 0; i < 3000 && begun == 0; i++) {
        nanosleep(&(struct timespec){.tv_nsec = 10000000}, NULL);
        begun = builds();
    }
    assert_int_equal(begun, 1);
    assert_int_equal(waitpid(child, &status, WNOHANG), 0);
    for (int i = 0; i < count; i++)
        (void)close(locks[i]);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), GLINT_OK);
    assert_int_equal(setenv("GLINT_CACHE", kept, 1), 0);
    free(kept);
}

/* ---- Ended in the middle --------------------------------------------------------------------- */

/* glint sees Ctrl-C too, and still runs to its end. */
static void go_on(int number)
{
    (void)number;
}

/* A process that builds, in a group of its own, and is at it: Verilator holds. */
static pid_t begin_to_build(pid_t *verilator)
{
    scratch_write(scratch_path("hold"), "", 0);
    (void)remove(scratch_path("held"));
    const pid_t child = fork();
    if (child == 0) {
        const glint_setting setting = setting_of(12);
        char *path;
        glint_error err;
        (void)setpgid(0, 0);
        (void)signal(SIGINT, go_on);
        _exit((int)glint_rtl_build(&setting, GLINT_RTL_OBSERVED, &path, &err));
    }
    int number = 0;
    for (int i = 0; i < 3000 && number == 0; i++) {
        FILE *held = fopen(scratch_path("held"), "r");
        if (held != NULL) {
            (void)!fscanf(held, "%d", &number);
            (void)fclose(held);
        }
        nanosleep(&(struct timespec){.tv_nsec = 10000000}, NULL);
    }
    assert_int_not_equal(number, 0);
    *verilator = number;
    return child;
}

static void assert_it_goes(pid_t process)
{
    for (int i = 0; i < 1000 && kill(process, 0) == 0; i++)
        nanosleep(&(struct timespec){.tv_nsec = 10000000}, NULL);
    assert_int_equal(kill(process, 0), -1);
}

static void a_killed_builder_leaves_nothing_to_the_next(void **state)
{
    (void)state;
    pid_t verilator;
    int status;
    const pid_t child = begin_to_build(&verilator);
    assert_int_equal(kill(child, SIGKILL), 0);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_it_goes(verilator);
    assert_int_equal(remove(scratch_path("hold")), 0);
    assert_int_equal(count_of(12, GLINT_RTL_OBSERVED), 15);
    assert_nothing_half_built();
    (void)builds();
}

static void an_interrupted_build_says_so(void **state)
{
    (void)state;
    pid_t verilator;
    int status;
    write_verilog("count + {", "count + 1 + {");
    const pid_t child = begin_to_build(&verilator);
    assert_int_equal(kill(-child, SIGINT), 0);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), GLINT_INTERRUPTED);
    assert_nothing_half_built();
    assert_int_equal(remove(scratch_path("hold")), 0);
    write_verilog("", "");
    (void)builds();
}

/* ---- What does not build --------------------------------------------------------------------- */

static void assert_refused(glint_rtl_kind kind, glint_status status, const char *begin,
                           const char *words)
{
    const glint_setting setting = setting_of(8);
    char *path;
    glint_error err = {""};
    assert_int_equal(glint_rtl_build(&setting, kind, &path, &err), status);
    assert_null(path);
    if (strncmp(err.text, begin, strlen(begin)) != 0 || strstr(err.text, words) == NULL)
        fail_msg("said: %s", err.text);
    assert_null(strchr(err.text, '\n'));
    assert_nothing_half_built();
}

static void verilog_with_an_error(void **state)
{
    (void)state;
    char place[700];
    write_verilog("else if", "els if");
    (void)snprintf(place, sizeof place, "%s/counter.v:8:", directory);
    assert_refused(GLINT_RTL_OBSERVED, GLINT_DEVICE_FAULT, place, "syntax error");
    assert_refused(GLINT_RTL_FAST, GLINT_DEVICE_FAULT, place, "syntax error");
    write_verilog("count + {", "cuont + {");
    (void)snprintf(place, sizeof place, "%s/counter.v:5:", directory);
    assert_refused(GLINT_RTL_OBSERVED, GLINT_DEVICE_FAULT, place, "'cuont'");
    write_verilog("", "");
}

/* It would be in no hash: an edit of it would be missed. */
static void verilog_that_includes_from_elsewhere(void **state)
{
    (void)state;
    char include[700];
    scratch_write(scratch_path("elsewhere.vh"), "`define HOW_MANY 4\n", 19);
    (void)snprintf(include, sizeof include, "`include \"%s\"\nmodule counter",
                   scratch_path("elsewhere.vh"));
    write_verilog("module counter", include);
    assert_refused(GLINT_RTL_OBSERVED, GLINT_DEVICE_FAULT, directory, "its Verilog includes /");
    write_verilog("", "");
    (void)builds();
}

static void a_directory_without_the_top(void **state)
{
    (void)state;
    char kept[600];
    memcpy(kept, directory, sizeof kept);
    (void)snprintf(directory, sizeof directory, "%s", scratch_path("nowhere"));
    assert_refused(GLINT_RTL_OBSERVED, GLINT_IO_ERROR, directory, "No such file");
    assert_int_equal(mkdir(directory, 0777), 0);
    assert_refused(GLINT_RTL_OBSERVED, GLINT_IO_ERROR, directory, "no .v file");
    scratch_write(scratch_path("nowhere/other.v"), "\n", 1);
    assert_refused(GLINT_RTL_OBSERVED, GLINT_IO_ERROR, directory, "has no counter.v");
    memcpy(directory, kept, sizeof kept);
}

static void a_description_that_is_another_circuit_s(void **state)
{
    (void)state;
    const glint_rtl_kind both[] = {GLINT_RTL_OBSERVED, GLINT_RTL_FAST};
    for (int i = 0; i < 2; i++) {
        const glint_rtl_kind kind = both[i];
        signal_path = "reg9";
        assert_refused(kind, GLINT_DEVICE_FAULT, "counter has no signal next", "next");
        signal_path = "next";
        signal_wider = 1;
        assert_refused(kind, GLINT_DEVICE_FAULT, "signal next",
                       "has 9 bits in the description and 8 in the Verilog of counter");
        signal_wider = -1;
        assert_refused(kind, GLINT_DEVICE_FAULT, "signal next",
                       "has 7 bits in the description and 8 in the Verilog of counter");
        signal_wider = 0;
        pin_wider = 2;
        assert_refused(kind, GLINT_DEVICE_FAULT, "pin step",
                       "has 6 bits in the description and 4 in the Verilog of counter");
        pin_wider = 0;
        pin_name = "stride";
        assert_refused(kind, GLINT_DEVICE_FAULT, "counter has no pin stride", "");
        pin_name = "step";
        counter.clock_port = "clock";
        assert_refused(kind, GLINT_DEVICE_FAULT, "counter has no clock clock", "");
        counter.clock_port = "clk";
        parameter_name = "BITS";
        assert_refused(kind, GLINT_DEVICE_FAULT, "counter has no parameter BITS", "");
        parameter_name = "WIDTH";
    }
}

/* An undriven Verilog input is an error; an unused output is not. */
static void ports_that_the_description_has_not(void **state)
{
    (void)state;
    write_verilog("input wire en,", "input wire en, input wire hold,");
    assert_refused(GLINT_RTL_OBSERVED, GLINT_DEVICE_FAULT, "counter has an input hold",
                   "is missing from the description");
    write_verilog("input wire en,", "input wire en, output wire odd,");
    assert_int_equal(count_of(8, GLINT_RTL_OBSERVED), 15);
    write_verilog("", "");
    (void)builds();
}

/* The Verilog with another name for the pin `step`. */
static void call_step(const char *name)
{
    char text[2000] = "";
    for (const char *rest = verilog; *rest != '\0';) {
        const bool found = strncmp(rest, "step", 4) == 0;
        const size_t length = strlen(text);
        (void)snprintf(text + length, sizeof text - length, "%.*s", found ? 100 : 1,
                       found ? name : rest);
        rest += found ? 4 : 1;
    }
    write_file("counter.v", text);
    pin_name = name;
}

/* What C++ or the class that Verilator makes have as names of their own. */
static void ports_with_names_of_others(void **state)
{
    (void)state;
    static const char *const good[] = {"delete", "step__one", "tfp"};
    static const char *const bad[] = {"eval", "rootp"};
    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        call_step(good[i]);
        assert_int_equal(count_of(8, GLINT_RTL_FAST), 15);
    }
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        char told[100];
        (void)snprintf(told, sizeof told, ": port %s cannot be in a waveform", bad[i]);
        call_step(bad[i]);
        if (i == 0)
            assert_int_equal(count_of(8, GLINT_RTL_OBSERVED), 15);
        assert_refused(GLINT_RTL_FAST, GLINT_DEVICE_FAULT, directory, told);
    }
    call_step("class"); /* of SystemVerilog, which Verilator takes all files for */
    assert_refused(GLINT_RTL_OBSERVED, GLINT_DEVICE_FAULT, directory, "unexpected class");
    char path[700];
    (void)snprintf(path, sizeof path, "%s/counter.v", directory);
    char *text = scratch_read(path, NULL);
    char allowed[3000];
    (void)snprintf(allowed, sizeof allowed, "`begin_keywords \"1364-2005\"\n%s`end_keywords\n",
                   text);
    free(text);
    write_file("counter.v", allowed);
    assert_int_equal(count_of(8, GLINT_RTL_FAST), 15);
    pin_name = "step";
    write_verilog("", "");
    (void)builds();
}

/* ---- What does not run ----------------------------------------------------------------------- */

static void run_it(void)
{
    const glint_setting setting = setting_of(8);
    const counter_pins pins = {.en = 1, .step = 5};
    glint_error err = {""};
    glint_rtl *rtl;
    if (glint_rtl_open(&setting, GLINT_RTL_OBSERVED, &rtl, &err) != GLINT_OK)
        fprintf(stderr, "%s\n", err.text);
    else
        glint_rtl_clock(rtl, &pins);
    (void)fflush(stderr);
}

/* In a process of its own, which ends with one line. */
static void assert_gives_up(const char *from, const char *to, const char *words)
{
    int status;
    write_verilog(from, to);
    scratch_write(scratch_path("said"), "", 0);
    const pid_t child = fork();
    if (child == 0) {
        if (freopen(scratch_path("said"), "w", stderr) != NULL)
            run_it();
        _exit(99);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    char *said = scratch_read(scratch_path("said"), NULL);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 2 || strncmp(said, "glint: ", 7) != 0 ||
        strstr(said, words) == NULL || strchr(said, '\n')[1] != '\0')
        fail_msg("status %#x, said: %s", (unsigned)status, said);
    free(said);
    write_verilog("", "");
    (void)builds();
}

static void a_circuit_that_cannot_go_on(void **state)
{
    (void)state;
    assert_gives_up("next = count", "loop = ~loop;\n    wire [WIDTH-1:0] next = loop + count",
                    "converge");
    assert_gives_up("else if (en)", "else if (en && step == 5) $finish; else if (en)", "$finish");
}

/* ---- Tools ----------------------------------------------------------------------------------- */

static void without_verilator_what_is_built_is_used(void **state)
{
    (void)state;
    char *kept = strdup(getenv("VERILATOR")), *path = strdup(getenv("PATH"));
    assert_non_null(kept);
    assert_int_equal(setenv("VERILATOR", "/no/such/verilator", 1), 0);
    assert_int_equal(count_of(8, GLINT_RTL_OBSERVED), 15);
    write_verilog("count + {", "count ^ {");
    assert_refused(GLINT_RTL_OBSERVED, GLINT_IO_ERROR, "VERILATOR=/no/such/verilator",
                   "program not found");
    assert_int_equal(unsetenv("VERILATOR"), 0);
    assert_int_equal(setenv("PATH", "/no/such/directory", 1), 0);
    assert_refused(GLINT_RTL_OBSERVED, GLINT_IO_ERROR,
                   "Verilator, which builds the circuit, was not found", "install");
    assert_int_equal(setenv("VERILATOR", kept, 1), 0);
    assert_refused(GLINT_RTL_OBSERVED, GLINT_IO_ERROR, "no C++ compiler was found", "install");
    write_verilog("", "");
    assert_int_equal(count_of(8, GLINT_RTL_OBSERVED), 15);
    assert_int_equal(setenv("PATH", path, 1), 0);
    free(kept);
    free(path);
}

static void a_tool_is_found_from_here(void **state)
{
    (void)state;
    static const char *const none[] = {"./nowhere", "",
                                       " ",         "no-such-compiler -m64",
                                       "./verilog", "a b c d e f g h i j k l m n o p"};
    char here[1000], expected[600];
    glint_tool tool;
    glint_error err = {""};
    assert_non_null(getcwd(here, sizeof here));
    (void)snprintf(expected, sizeof expected, "%s/./verilator", scratch_directory);
    assert_int_equal(chdir(scratch_directory), 0);
    assert_int_equal(glint_tool_find("CXX", " ./verilator -I./x  ./verilator sh", &tool, &err),
                     GLINT_OK);
    assert_string_equal(tool.word[0], expected);
    assert_string_equal(tool.word[1], "-I./x");
    assert_string_equal(tool.word[2], expected);
    assert_string_equal(tool.word[3], "sh");
    assert_null(tool.word[4]);
    glint_tool_free(&tool);

    assert_int_equal(symlink("verilator", "my tool"), 0); /* a blank in its name */
    assert_int_equal(glint_tool_find("CXX", "./my tool", &tool, &err), GLINT_OK);
    assert_non_null(strstr(tool.word[0], "/./my tool"));
    assert_null(tool.word[1]);
    glint_tool_free(&tool);
    for (size_t i = 0; i < sizeof none / sizeof none[0]; i++) {
        assert_int_equal(glint_tool_find("CXX", none[i], &tool, &err), GLINT_IO_ERROR);
        assert_int_equal(strncmp(err.text, "CXX=", 4), 0);
    }
    assert_int_equal(chdir(here), 0);
}

/* One of another shim than this program was linked with. */
static void a_circuit_of_another_version_is_refused(void **state)
{
    (void)state;
    char command[2000], *path;
    const glint_setting setting = setting_of(11);
    glint_error err = {""};
    glint_rtl *rtl;
    assert_int_equal(glint_rtl_build(&setting, GLINT_RTL_OBSERVED, &path, &err), GLINT_OK);
    (void)snprintf(command, sizeof command,
                   "printf 'const unsigned long glint_circuit_table[16] = {99, 88};' | "
                   "${CC:-cc} -shared -o '%s' -x c -",
                   path);
    assert_int_equal(system(command), 0);
    assert_int_equal(glint_rtl_open(&setting, GLINT_RTL_OBSERVED, &rtl, &err), GLINT_DEVICE_FAULT);
    assert_non_null(strstr(err.text, "another version of sim/rtl/shim.h"));
    assert_null(rtl);
    assert_int_equal(unlink(path), 0);
    free(path);
    (void)builds();
}

static void a_compiler_that_fails(void **state)
{
    (void)state;
    assert_int_equal(setenv("CXX", "false", 1), 0);
    assert_int_equal(count_of(8, GLINT_RTL_OBSERVED), 15);
    write_verilog("count + {", "count ^ {");
    assert_refused(GLINT_RTL_OBSERVED, GLINT_DEVICE_FAULT, "/", "/false --version failed: ");
    assert_int_equal(unsetenv("CXX"), 0);
    write_verilog("", "");
}

/* A directory with a blank in its name, as a home may have. */
static void a_cache_with_a_blank_in_its_path(void **state)
{
    (void)state;
    char from[700], to[700];
    char *kept = strdup(getenv("GLINT_CACHE"));
    assert_non_null(kept);
    (void)snprintf(from, sizeof from, "%s", scratch_path("cache"));
    (void)snprintf(to, sizeof to, "%s", scratch_path("a cache"));
    assert_int_equal(rename(from, to), 0);
    assert_int_equal(setenv("GLINT_CACHE", to, 1), 0);
    assert_int_equal(count_of(9, GLINT_RTL_OBSERVED), 15);
    assert_int_equal(setenv("GLINT_CACHE", kept, 1), 0);
    assert_int_equal(rename(to, from), 0);
    free(kept);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_circuit_is_built_once),
        cmocka_unit_test(an_edit_builds_anew_and_its_undoing_does_not),
        cmocka_unit_test(a_fast_circuit_of_another_width),
        cmocka_unit_test(what_is_needed_is_built_anew),
        cmocka_unit_test(system_verilog_is_read_too),
        cmocka_unit_test(who_comes_second_waits),
        cmocka_unit_test(who_lacks_the_runtime_waits_late),
        cmocka_unit_test(a_killed_builder_leaves_nothing_to_the_next),
        cmocka_unit_test(an_interrupted_build_says_so),
        cmocka_unit_test(verilog_with_an_error),
        cmocka_unit_test(verilog_that_includes_from_elsewhere),
        cmocka_unit_test(a_directory_without_the_top),
        cmocka_unit_test(a_description_that_is_another_circuit_s),
        cmocka_unit_test(ports_that_the_description_has_not),
        cmocka_unit_test(ports_with_names_of_others),
        cmocka_unit_test(a_circuit_that_cannot_go_on),
        cmocka_unit_test(without_verilator_what_is_built_is_used),
        cmocka_unit_test(a_tool_is_found_from_here),
        cmocka_unit_test(a_circuit_of_another_version_is_refused),
        cmocka_unit_test(a_compiler_that_fails),
        cmocka_unit_test(a_cache_with_a_blank_in_its_path),
    };
    return cmocka_run_group_tests(tests, set_up, scratch_remove);
}
