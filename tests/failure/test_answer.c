/* Failures from a differing answer, found by an exhaustive run or a frame: asked again as a run of
 * points or divisions, and clock by clock. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../lockstep/mock_rtl.h"
#include "circuit/random.h"
#include "failure/frame.h"
#include "failure/packet.h"
#include "faults.h"
#include "lockstep/exhaustive.h"
#include "lockstep/mismatch.h"

static glint_failure *failure;

static int clean_up(void **state)
{
    glint_failure_destroy(failure);
    return scratch_remove(state);
}

static void assert_done(glint_status status, const glint_error *err)
{
    if (status != GLINT_OK)
        fail_msg("%s", err->text);
}

static void make_failure(const glint_setting *setting, const glint_answer *answer)
{
    glint_error err;
    glint_failure_destroy(failure);
    failure = NULL;
    assert_done(glint_failure_of_answer(GLINT_FAILURE_EXHAUSTIVE, setting, answer, &failure, &err),
                &err);
}

static const fault *fault_of(const char *name)
{
    size_t i = 0;
    while (strcmp(faults[i].name, name) != 0)
        assert_true(++i < FAULT_COUNT);
    return &faults[i];
}

/* Written and read back, it is the same and replays the same. */
static void assert_survives_the_packet(const glint_setting *setting)
{
    glint_error err;
    glint_failure *read;
    glint_failure_finding again;
    assert_done(glint_packet_write(failure, NULL, scratch_path("packet"), &err), &err);
    assert_done(glint_packet_read(scratch_path("packet"), NULL, &read, &err), &err);
    assert_int_equal(read->answer.count, failure->answer.count);
    assert_int_equal(read->answer.at, failure->answer.at);
    assert_int_equal(read->answer.value, failure->answer.value);
    assert_true(glint_failure_same(&read->finding, &failure->finding));
    read->setting = *setting;
    assert_done(glint_failure_play(read, NULL, &again, NULL, &err), &err);
    assert_true(glint_failure_same(&again, &failure->finding));
    read->setting.verilog = NULL;
    assert_done(glint_failure_play(read, NULL, &again, NULL, &err), &err);
    assert_false(glint_failure_differs(&again));
    glint_failure_destroy(read);
}

/* Of lane 0, or of the divider, as the number it stands for times its unit. */
static int32_t value_of(const glint_capture_clock *clock, const char *name, bool rtl)
{
    for (int i = 0; i < glint_setting_signal_count(&failure->setting); i++) {
        const glint_signal_info signal = glint_setting_signal(&failure->setting, i);
        if (strcmp(signal.name, name) == 0 && signal.lane <= 0) {
            const double one = (double)(UINT64_C(1) << signal.frac_bits);
            return (
                int32_t)(glint_mismatch_number(&signal, rtl ? &clock->rtl[i] : &clock->model[i]) *
                         one);
        }
    }
    fail_msg("no signal %s", name);
    return 0;
}

/* The marked clock is the one with the wrong answer at the output; the clocks before it are
 * included, and an earlier first difference is reported. */
static void assert_reaches_the_answer(const char *output)
{
    const glint_capture *capture = failure->capture;
    const glint_capture_clock *failing = &capture->clock[capture->failing];
    const glint_mismatch *first = &capture->found.mismatch[0];
    char line[128];
    assert_int_equal(failing->clock, failure->finding.clock);
    assert_int_equal(capture->failing, failing->clock > 32 ? 32 : (int)failing->clock - 1);
    assert_int_equal(value_of(failing, output, false), failure->finding.model);
    assert_int_equal(value_of(failing, output, true), failure->finding.rtl);
    char *report = scratch_read(scratch_path("packet/" GLINT_PACKET_REPORT), NULL);
    (void)snprintf(line, sizeof line, "\n> %10" PRIu64 " ", failing->clock);
    assert_non_null(strstr(report, line));
    (void)snprintf(line, sizeof line, ":\n  clock %" PRIu64 ": %s,", first->clock,
                   first->signal.name);
    assert_non_null(strstr(report, line));
    assert_int_equal(strstr(report, "\nthe first signal to differ:\n") != NULL,
                     first->clock < failing->clock);
    (void)snprintf(line, sizeof line, "values of the answer after it:\n");
    assert_non_null(strstr(report, line));
    free(report);
}

static const char *program(void)
{
    const char *path = getenv("GLINT");
    return path != NULL ? path : "build/glint";
}

/* The report's line that asks the point or division alone, run by a shell: a number of the last
 * row. By the Verilog of that directory, or Glint's own. */
static int32_t run_alone(const char *verilog, int column)
{
    static char command[8192], row[1024];
    glint_error err;
    failure->program = program();
    (void)snprintf(failure->rtl, sizeof failure->rtl, "%s", verilog != NULL ? verilog : "");
    assert_done(glint_packet_write(failure, NULL, scratch_path("alone"), &err), &err);
    failure->program = NULL;
    glint_failure_name_verilog(failure);
    char *report = scratch_read(scratch_path("alone/" GLINT_PACKET_REPORT), NULL);
    const char *line = strstr(report, "\n  alone: ");
    assert_non_null(line);
    line += strlen("\n  alone: ");
    (void)snprintf(command, sizeof command, "%.*s", (int)strcspn(line, "\n"), line);
    free(report);
    FILE *answers = popen(command, "r");
    assert_non_null(answers);
    while (fgets(row, sizeof row, answers) != NULL) {
    }
    assert_int_equal(pclose(answers), 0);
    char *value = strtok(row, ",");
    for (int i = 0; i < column; i++)
        value = strtok(NULL, ",");
    assert_non_null(value);
    return (int32_t)strtol(value, NULL, 10);
}

static const glint_specular_config one_lane = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1};

enum { COLUMN_W = 2, COLUMN_QUOTIENT = 3 }; /* of eval, then red, green and blue; of divide */

static glint_specular_inputs specular_pins(const glint_pins *pins)
{
    glint_specular_inputs inputs;
    memcpy(&inputs, pins, sizeof inputs);
    return inputs;
}

/* ---- The specular device ------------------------------------------------------------------------
 */

/* What the exhaustive comparison keeps of a wrong circuit, played clock by clock. */
static void a_mismatch_of_the_exhaustive_run_is_found_in_its_block(void **state)
{
    (void)state;
    static glint_exhaustive_result result;
    static const struct {
        const char *fault;
        uint32_t n;
        int first_block, last_block;
    } cases[] = {{"truncating", 20, 13, 15}, {"sigma_off_by_one", 60, 33, 33}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const glint_setting setting = setting_of(fault_of(cases[i].fault), true);
        const glint_exhaustive_options options = {.setting = {setting},
                                                  .settings = 1,
                                                  .from = cases[i].n,
                                                  .shard = cases[i].n + 1,
                                                  .shards = GLINT_N_COUNT,
                                                  .stride = 1,
                                                  .threads = 1};
        glint_error err;
        assert_done(glint_exhaustive_run(&options, &result, &err), &err);
        assert_true(result.kept > 0);
        const glint_exhaustive_mismatch *first = &result.mismatch[0];
        assert_int_equal(first->n, cases[i].n);
        make_failure(&setting, &first->answer);
        const glint_failure_finding *finding = &failure->finding;
        assert_true(finding->answer_differs && finding->lockstep_differs);
        assert_int_equal(finding->model, first->answer.model);
        assert_int_equal(finding->rtl, first->answer.rtl);
        assert_in_range(finding->mismatch[0].signal.block, cases[i].first_block,
                        cases[i].last_block);
        assert_survives_the_packet(&setting);
        static const char *const outputs[] = {"out_w", "out_r", "out_g", "out_b"};
        assert_reaches_the_answer(outputs[first->answer.value]);
        const glint_capture *capture = failure->capture;
        const int taken = capture->failing - (glint_setting_latency(&setting) - 1);
        assert_int_equal(specular_pins(&capture->clock[taken].pins).cos[0],
                         first->answer.cos_code[first->answer.at]);
        const int column = COLUMN_W + (int)first->answer.value;
        assert_int_equal(run_alone(NULL, column), finding->model);
        assert_int_equal(run_alone(setting.verilog, column), finding->rtl);
    }
}

/* From a long run, the points around the one in question are kept, each on its lane. */
static void the_points_about_it_stay_on_their_lanes(void **state)
{
    (void)state;
    static uint32_t cos_code[2000];
    static glint_answer answer;
    const glint_material material = {7, 1, 2, 3};
    for (uint32_t i = 0; i < 2000; i++)
        cos_code[i] = 1000 + i;
    for (int lanes = 1; lanes <= GLINT_LANES_MAX; lanes++) {
        for (size_t at = 0; at < 2000; at += 37) {
            glint_answer_keep_points(&answer, lanes, &material, cos_code, 2000, at);
            assert_int_equal(answer.cos_code[answer.at], 1000 + at);
            assert_int_equal((size_t)answer.at % (size_t)lanes, at % (size_t)lanes);
            assert_in_range(answer.count, 1, GLINT_ANSWER_POINTS);
            const size_t clock = at / (size_t)lanes;
            assert_int_equal(answer.at / lanes, clock < 32 ? clock : 32);
            assert_int_equal(answer.cos_code[answer.count - 1],
                             1000 + (at - (size_t)answer.at) + (size_t)answer.count - 1);
        }
    }
}

/* Its batch lies, its clock does not: as two builds of one Verilog would that do not do the same.
 */
static glint_status shade_lying(glint_rtl *rtl, const glint_material *material,
                                const glint_points *points, glint_error *err)
{
    const glint_status status = __real_glint_rtl_shade(rtl, material, points, err);
    points->g[points->count - 1] ^= 1;
    return status;
}

/* A setting with the circuit that `mock` then is. */
static glint_setting mocked(int lanes, mock_rtl circuit)
{
    glint_setting setting = specular_setting(GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, lanes);
    setting.verilog = mock_verilog;
    mock = circuit;
    return setting;
}

static void a_difference_of_the_fast_build_alone_is_told(void **state)
{
    (void)state;
    glint_error err;
    glint_failure_finding again;
    const uint32_t cos_code[6] = {GLINT_COS_ONE, GLINT_COS_ONE, 0, 0, 0, GLINT_COS_ONE};
    const glint_material material = {50, 255, 190, 110};
    const glint_setting setting = mocked(4, (mock_rtl){.shade = shade_lying});
    glint_answer answer = {.value = GLINT_ANSWER_G, .model = 190, .rtl = 191};
    glint_answer_keep_points(&answer, 4, &material, cos_code, 6, 5);
    make_failure(&setting, &answer);
    assert_true(failure->finding.answer_differs);
    assert_false(failure->finding.lockstep_differs);
    assert_int_equal(failure->finding.model, 190);
    assert_int_equal(failure->finding.rtl, 191);
    /* The clock after which the answer is out: the second feeds it. */
    assert_int_equal(failure->finding.clock, 2 + GLINT_LATENCY_PIPELINED - 1);
    assert_done(glint_packet_write(failure, NULL, scratch_path("lying"), &err), &err);
    char *report = scratch_read(scratch_path("lying/" GLINT_PACKET_REPORT), NULL);
    assert_non_null(strstr(report, "green: model 190, rtl 191"));
    assert_non_null(
        strstr(report, "nothing differs: two builds of the same Verilog behave differently"));
    assert_non_null(strstr(report, "\n  alone: yes '50 0x40000 255 190 110' | head -n 2 | "));
    assert_non_null(strstr(report, " --lanes 4 --rtl "));
    free(report);
    assert_int_equal(run_alone(NULL, COLUMN_W + GLINT_ANSWER_G), 190);
    glint_failure *read;
    assert_done(glint_packet_read(scratch_path("lying"), NULL, &read, &err), &err);
    read->setting.verilog = mock_verilog;
    assert_done(glint_failure_play(read, NULL, &again, NULL, &err), &err);
    assert_true(again.answer_differs && glint_failure_same(&again, &read->finding));
    glint_failure_destroy(read);
}

static glint_status shade_lying_in_company(glint_rtl *rtl, const glint_material *material,
                                           const glint_points *points, glint_error *err)
{
    const glint_status status = shade_lying(rtl, material, points, err);
    return points->count <= 2 /* the second of two lanes, alone */
               ? glint_fail(err, GLINT_DEVICE_FAULT, "the circuit returned 0 of 2 results")
               : status;
}

/* The packet is still complete; only the line that asks alone is left out. */
static void a_circuit_that_keeps_a_lone_answer_back_has_a_packet(void **state)
{
    (void)state;
    glint_error err;
    const uint32_t cos_code[6] = {GLINT_COS_ONE, GLINT_COS_ONE, 0, 0, 0, GLINT_COS_ONE};
    const glint_material material = {50, 255, 190, 110};
    const glint_setting setting = mocked(4, (mock_rtl){.shade = shade_lying_in_company});
    glint_answer answer = {.value = GLINT_ANSWER_G, .model = 190, .rtl = 191};
    glint_answer_keep_points(&answer, 4, &material, cos_code, 6, 5);
    make_failure(&setting, &answer);
    assert_true(failure->finding.answer_differs && !failure->finding.alone_differs);
    assert_done(glint_packet_write(failure, NULL, scratch_path("company"), &err), &err);
    char *report = scratch_read(scratch_path("company/" GLINT_PACKET_REPORT), NULL);
    assert_non_null(strstr(report, "green: model 190, rtl 191"));
    assert_null(strstr(report, "alone:"));
    free(report);
}

/* ---- What went before ---------------------------------------------------------------------------
 */

/* A circuit that fails at one clock after its creation, which no signal shows beforehand: it
 * accepts a different cosine, or none. One lane, one circuit at a time. */
enum { WRONG_CLOCK = 300, WRONG_BIT = 0x400 };
static uint64_t clocks_since_made;
static bool takes_none;
/* Where not 0, it goes wrong this many clocks after it took the cosine TRIGGER instead. */
static uint64_t wrong_after;
enum { TRIGGER = 2050 };
static uint64_t clocks_since_trigger;

static void begin_ageing(void)
{
    clocks_since_made = 0;
    clocks_since_trigger = 1000000; /* it has not come */
}

static void clock_ageing(glint_rtl *rtl, const void *pins)
{
    glint_specular_inputs taken = specular_pins(pins);
    const bool is_trigger = taken.cos[0] == TRIGGER;
    clocks_since_made++;
    clocks_since_trigger++;
    if (wrong_after == 0 ? clocks_since_made == WRONG_CLOCK : clocks_since_trigger == wrong_after) {
        taken.cos[0] ^= WRONG_BIT;
        taken.in_valid = takes_none ? 0 : taken.in_valid;
    }
    if (is_trigger)
        clocks_since_trigger = 0;
    __real_glint_rtl_clock(rtl, &taken);
}

static glint_status shade_ageing(glint_rtl *rtl, const glint_material *material,
                                 const glint_points *points, glint_error *err)
{
    static uint32_t taken[5000];
    const uint64_t before = clocks_since_made;
    glint_points wrong = *points;
    const bool goes_wrong = before < WRONG_CLOCK && WRONG_CLOCK <= before + points->count;
    assert_true(points->count <= 5000);
    memcpy(taken, points->cos, points->count * sizeof *taken);
    if (goes_wrong)
        taken[WRONG_CLOCK - before - 1] ^= WRONG_BIT;
    wrong.cos = taken;
    clocks_since_made += points->count + GLINT_LATENCY_PIPELINED - 1;
    const glint_status status = __real_glint_rtl_shade(rtl, material, &wrong, err);
    return goes_wrong && takes_none
               ? glint_fail(err, GLINT_DEVICE_FAULT, "the circuit returned %zu of %zu results",
                            points->count - 1, points->count)
               : status;
}

/* Runs n = 2 of the exhaustive comparison: nearly every code has a W of its own. */
static glint_status compare_ageing(const glint_setting *setting, glint_exhaustive_result *result)
{
    glint_error err;
    const glint_exhaustive_options options = {.setting = {*setting},
                                              .settings = 1,
                                              .from = 2,
                                              .shard = 3,
                                              .shards = GLINT_N_COUNT,
                                              .stride = 1,
                                              .threads = 1,
                                              .keep_history = true};
    return glint_exhaustive_run(&options, result, &err);
}

static const mock_rtl ageing = {
    .opened = begin_ageing, .clock = clock_ageing, .shade = shade_ageing};

/* Asked alone it is right; the packet has the clocks that make it wrong. */
static void what_went_before_is_played(void **state)
{
    (void)state;
    static glint_exhaustive_result result;
    glint_error err;
    const glint_setting setting = mocked(1, ageing);
    takes_none = false;
    assert_int_equal(compare_ageing(&setting, &result), GLINT_OK);
    assert_true(result.kept > 0);
    const glint_answer *answer = &result.mismatch[0].answer;
    assert_int_equal(answer->cos_code[answer->at], WRONG_CLOCK - 1);
    assert_non_null(result.history);
    make_failure(&setting, answer);
    assert_false(glint_failure_differs(&failure->finding));
    glint_failure_destroy(failure);
    assert_done(glint_failure_of_history(GLINT_FAILURE_EXHAUSTIVE, &setting, answer, result.history,
                                         NULL, &failure, &err),
                &err);
    glint_history_destroy(result.history);
    assert_true(failure->finding.lockstep_differs);
    assert_int_equal(failure->finding.clock, WRONG_CLOCK);
    assert_string_equal(failure->finding.mismatch[0].signal.name, "reg1");
    assert_int_equal(failure->first_clock, 1);
    assert_int_equal(failure->pin_count, WRONG_CLOCK + GLINT_CAPTURE_AFTER);
    assert_survives_the_packet(&setting);
    char *report = scratch_read(scratch_path("packet/" GLINT_PACKET_REPORT), NULL);
    assert_non_null(strstr(report, "the clocks before it, shown below, matter"));
    assert_null(strstr(report, "alone: ")); /* it would be answered rightly */
    assert_non_null(strstr(report, "\n>        300 "));
    assert_non_null(strstr(report, "\nreplayed from clock 1, 308 clocks\n"));
    free(report);
}

/* The answer differs in the batch alone; clock by clock something else does, before. */
static void where_the_answer_is_right_the_first_difference_is_marked(void **state)
{
    (void)state;
    const uint32_t cos_code[8] = {TRIGGER, 2100, 2200, 2300, 2400, 2500, 2600, 2700};
    const glint_material material = {2, 10, 20, 30};
    mock_rtl lying = ageing;
    lying.shade = shade_lying;
    const glint_setting setting = mocked(1, lying);
    glint_answer answer = {.value = GLINT_ANSWER_G, .model = 0, .rtl = 1};
    takes_none = false;
    wrong_after = 2;
    glint_answer_keep_points(&answer, 1, &material, cos_code, 8, 7);
    make_failure(&setting, &answer);
    assert_true(failure->finding.answer_differs && failure->finding.lockstep_differs);
    assert_int_equal(failure->finding.clock, 3);
    assert_string_equal(failure->finding.mismatch[0].signal.name, "reg1");
    assert_survives_the_packet(&setting);
    wrong_after = 0;
}

/* No answer, no point to ask for: the clock that loses it is found all the same. */
static void a_circuit_that_keeps_an_answer_back_is_found_out(void **state)
{
    (void)state;
    static glint_exhaustive_result result;
    glint_error err;
    const glint_setting asked = mocked(1, ageing);
    takes_none = true;
    assert_int_equal(compare_ageing(&asked, &result), GLINT_DEVICE_FAULT);
    assert_int_equal(result.kept, 0);
    assert_non_null(result.history);
    const glint_setting setting = *glint_history_setting(result.history);
    assert_string_equal(setting.verilog, mock_verilog);
    glint_failure_destroy(failure);
    assert_done(glint_failure_of_history(GLINT_FAILURE_EXHAUSTIVE, &setting, NULL, result.history,
                                         NULL, &failure, &err),
                &err);
    glint_history_destroy(result.history);
    assert_int_equal(failure->finding.clock, WRONG_CLOCK);
    assert_string_equal(failure->finding.mismatch[0].signal.name, "s1_valid");
    assert_survives_the_packet(&setting);
}

/* Only as much of the history is kept as reproduces the failure. */
static void what_does_not_matter_is_left_out(void **state)
{
    (void)state;
    static uint32_t cos_code[200];
    glint_error err;
    glint_history *history = NULL;
    const glint_setting setting = mocked(1, ageing);
    const glint_material material = {2, 10, 20, 30};
    const glint_batch batch = {.material = &material, .cos_code = cos_code, .count = 200};
    for (uint32_t first = 1000; first <= 2000; first += 500) {
        for (uint32_t i = 0; i < 200; i++)
            cos_code[i] = first + i;
        glint_history_add(&history, &setting, &batch);
    }
    assert_non_null(history);
    takes_none = false;
    wrong_after = 100; /* in the last batch, which begins with the material */
    glint_failure_destroy(failure);
    assert_done(glint_failure_of_history(GLINT_FAILURE_EXHAUSTIVE, &setting, NULL, history, NULL,
                                         &failure, &err),
                &err);
    assert_survives_the_packet(&setting);
    wrong_after = 0;
    static const volatile bool stop = true;
    const glint_setting right = glint_setting_specular(&one_lane);
    glint_failure *stopped;
    for (int i = 0; i < 100; i++) /* more clocks than are played whether stopped or not */
        glint_history_add(&history, &right, &batch);
    assert_int_equal(glint_failure_of_history(GLINT_FAILURE_EXHAUSTIVE, &right, NULL, history,
                                              &stop, &stopped, &err),
                     GLINT_INTERRUPTED);
    assert_null(stopped);
    glint_history_destroy(history);
    assert_true(failure->finding.lockstep_differs);
    assert_string_equal(failure->finding.mismatch[0].signal.name, "reg1");
    assert_int_equal(failure->finding.mismatch[0].model[0], TRIGGER + 100);
    /* 8 clocks and those of the window would not have the trigger, nor twice that. */
    assert_int_equal(failure->finding.clock - failure->first_clock, 4 * (8 + GLINT_CAPTURE_BEFORE));
    assert_int_equal(failure->finding.clock,
                     2 * (200 + GLINT_LATENCY_PIPELINED - 1) + (TRIGGER - 2000 + 1) + 100);
}

/* The last clocks of many, as pins. */
static void a_history_keeps_the_last_clocks(void **state)
{
    (void)state;
    static uint32_t cos_code[40000];
    const glint_setting setting =
        specular_setting(GLINT_GATE_COSINE, GLINT_PIPELINE_COMBINATIONAL, 2);
    const glint_material material = {9, 1, 2, 3};
    const glint_batch batch = {.material = &material, .cos_code = cos_code, .count = 39999};
    glint_history *history = NULL;
    size_t count;
    uint64_t first;
    for (uint32_t i = 0; i < 40000; i++)
        cos_code[i] = i;
    for (int i = 0; i < 5; i++)
        glint_history_add(&history, &setting, &batch);
    assert_non_null(history);
    glint_pins *pins = glint_history_pins(history, &count, &first);
    assert_non_null(pins);
    assert_int_equal(count, GLINT_HISTORY_CLOCKS);
    assert_int_equal(first, 5 * 20000 - GLINT_HISTORY_CLOCKS + 1);
    const glint_specular_inputs last = specular_pins(&pins[count - 1]);
    assert_int_equal(last.in_valid, 1);
    assert_int_equal(last.cos[0], 39998);
    assert_false(last.n_we);
    assert_true(specular_pins(&pins[count - 20000]).n_we);
    assert_true(specular_pins(&pins[count - 40000]).rgb_we);
    assert_int_equal(specular_pins(&pins[count - 20000]).n, 9);
    free(pins);
    glint_history_destroy(history);
}

/* ---- The dividers -------------------------------------------------------------------------------
 */

/* Asks a wrong divider for what it gets wrong; the neighbours are random. */
static void assert_division(const char *fault, int component, const glint_division *asked,
                            const char *signals)
{
    static glint_division divisions[80];
    static glint_answer answer;
    glint_random random = {1};
    const glint_setting setting = setting_of(fault_of(fault), true);
    for (int i = 0; i < 80; i++) {
        divisions[i].k = (uint8_t)(1 + glint_random_below(&random, 3));
        for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
            divisions[i].difference[c] = (int16_t)glint_random_below(&random, 200);
    }
    divisions[50] = *asked;
    memset(&answer, 0, sizeof answer);
    answer.value = (glint_answer_value)(GLINT_ANSWER_R + component);
    glint_answer_keep_divisions(&answer, divisions, 80, 50);
    assert_memory_equal(&answer.division[answer.at], asked, sizeof *asked);
    make_failure(&setting, &answer);
    const glint_failure_finding *finding = &failure->finding;
    assert_true(finding->answer_differs && finding->lockstep_differs);
    const char *first = failure->capture->found.mismatch[0].signal.name;
    if (strstr(signals, first) == NULL)
        fail_msg("%s: the first to differ is %s", fault, first);
    assert_survives_the_packet(&setting);
    static const char *const outputs[] = {"quotient_r", "quotient_g", "quotient_b"};
    const bool sequential = setting.values[GLINT_DIVIDER_FORM] == GLINT_DIVIDER_SEQUENTIAL;
    assert_reaches_the_answer(sequential ? "quotient" : outputs[component]);
    assert_int_equal(run_alone(NULL, COLUMN_QUOTIENT), finding->model);
    assert_int_equal(run_alone(setting.verilog, COLUMN_QUOTIENT), finding->rtl);
}

static void a_divider_is_asked_clock_by_clock(void **state)
{
    (void)state;
    const glint_division negative = {{5, -200, 9}, 5};
    assert_division("divider_logical_shift", 1, &negative, "shifted");
    assert_division("divider_unsigned_stage", 1, &negative, "acc_g quotient_g");
    const glint_division seventh = {{255, 254, 253}, 7};
    for (int component = 0; component < GLINT_DIVIDER_COMPONENTS; component++)
        assert_division("divider_table_off_by_one", component, &seventh, "rom_bits");
}

/* ---- A frame without an answer ------------------------------------------------------------------
 */

static void a_frame_without_an_answer_still_says_where(void **state)
{
    (void)state;
    glint_error err;
    glint_failure_finding finding;
    glint_image *image;
    const glint_setting setting = specular_setting(GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 16);
    glint_failure_destroy(failure);
    assert_done(glint_failure_of_answer(GLINT_FAILURE_FRAME, &setting, NULL, &failure, &err), &err);
    failure->frame = (glint_failure_frame){.width = 10,
                                           .height = 8,
                                           .has_pixel = true,
                                           .x = 9,
                                           .y = 2,
                                           .model = {1, 2, 3},
                                           .rtl = {4, 5, 6}};
    assert_done(glint_image_create(10, 8, &image, &err), &err);
    const glint_packet_frames frames = {image, image};
    assert_done(glint_packet_write(failure, &frames, scratch_path("frame"), &err), &err);
    glint_image_destroy(image);
    char *report = scratch_read(scratch_path("frame/" GLINT_PACKET_REPORT), NULL);
    assert_non_null(strstr(report, "first at x=9 y=2: model 1,2,3, rtl 4,5,6"));
    assert_non_null(strstr(report, "there are no clocks to show"));
    assert_null(strstr(report, "replay:"));
    free(report);
    assert_int_equal(access(scratch_path("frame/" GLINT_PACKET_WAVE), F_OK), -1);
    assert_done(glint_image_read_png(scratch_path("frame/" GLINT_PACKET_RTL), &image, &err), &err);
    assert_int_equal(image->width, 40);
    assert_int_equal(image->height, 32);
    glint_image_destroy(image);
    glint_failure *read;
    assert_done(glint_packet_read(scratch_path("frame"), NULL, &read, &err), &err);
    assert_int_equal(glint_failure_play(read, NULL, &finding, NULL, &err), GLINT_BAD_INPUT);
    glint_failure_destroy(read);
}

/* ---- The watch that finds it in a frame ---------------------------------------------------------
 */

static void one_thread_alone_can_be_watched(void **state)
{
    (void)state;
    glint_error err;
    glint_backend_watch watch = {0};
    glint_renderer *renderer;
    const glint_backend_config config = {.kind = GLINT_BACKEND_RTL,
                                         .pipeline = GLINT_PIPELINE_PIPELINED};
    assert_done(glint_renderer_create(8, 8, 2, &config, &renderer, &err), &err);
    assert_int_equal(glint_renderer_watch(renderer, &watch, &err), GLINT_BAD_ARGUMENT);
    glint_renderer_destroy(renderer);
}

/* Correct circuits leave nothing to record, whatever the inputs. */
static void a_right_circuit_is_never_noted(void **state)
{
    (void)state;
    static const glint_shading shadings[] = {GLINT_SHADING_GOURAUD, GLINT_SHADING_PHONG};
    glint_error err;
    glint_mesh *mesh;
    glint_image *image;
    glint_renderer *renderer;
    glint_backend_watch watch = {0};
    glint_render_stats stats;
    glint_scene scene;
    const glint_backend_config config = {.kind = GLINT_BACKEND_RTL,
                                         .pipeline = GLINT_PIPELINE_PIPELINED};
    glint_scene_defaults(&scene);
    assert_done(glint_mesh_sphere(32, &mesh, &err), &err);
    assert_done(glint_image_create(64, 48, &image, &err), &err);
    assert_done(glint_renderer_create(64, 48, 1, &config, &renderer, &err), &err);
    assert_done(glint_renderer_watch(renderer, &watch, &err), &err);
    scene.mesh = mesh;
    for (size_t i = 0; i < 2; i++) {
        scene.shading = shadings[i];
        assert_done(glint_render(renderer, &scene, image, NULL, &stats, &err), &err);
        assert_true(stats.highlights > 0 && !watch.found);
    }
    assert_null(watch.history);
    glint_renderer_destroy(renderer);
    glint_image_destroy(image);
    glint_mesh_destroy(mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mismatch_of_the_exhaustive_run_is_found_in_its_block),
        cmocka_unit_test(the_points_about_it_stay_on_their_lanes),
        cmocka_unit_test(a_difference_of_the_fast_build_alone_is_told),
        cmocka_unit_test(a_circuit_that_keeps_a_lone_answer_back_has_a_packet),
        cmocka_unit_test(what_went_before_is_played),
        cmocka_unit_test(where_the_answer_is_right_the_first_difference_is_marked),
        cmocka_unit_test(a_circuit_that_keeps_an_answer_back_is_found_out),
        cmocka_unit_test(what_does_not_matter_is_left_out),
        cmocka_unit_test(a_history_keeps_the_last_clocks),
        cmocka_unit_test(a_divider_is_asked_clock_by_clock),
        cmocka_unit_test(a_frame_without_an_answer_still_says_where),
        cmocka_unit_test(one_thread_alone_can_be_watched),
        cmocka_unit_test(a_right_circuit_is_never_noted),
    };
    return cmocka_run_group_tests(tests, scratch_make, clean_up);
}
