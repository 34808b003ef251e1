/* Divisions: answer_kind.h. */
#include <string.h>

#include "circuit/circuits.h"
#include "lockstep/answer_kind.h"
#include "rtl/batch.h"

_Static_assert(sizeof(glint_divider_inputs) <= sizeof(glint_pins), "its pins fit");

static bool is_sequential(const glint_setting *setting)
{
    return setting->values[GLINT_DIVIDER_FORM] == GLINT_DIVIDER_SEQUENTIAL;
}

static size_t pace_of(const glint_setting *setting)
{
    return (size_t)glint_setting_pace(setting);
}

/* The sequential form takes one component after another. */
static size_t turns_of(const glint_setting *setting)
{
    return is_sequential(setting) ? GLINT_DIVIDER_COMPONENTS : 1;
}

static size_t feeding_clocks(const glint_setting *setting, size_t count)
{
    return count * turns_of(setting) * pace_of(setting);
}

static void put(const glint_setting *setting, const glint_batch *batch, size_t clock,
                glint_pins *pins)
{
    const size_t pace = pace_of(setting), turns = turns_of(setting);
    const size_t turn = clock / pace;
    glint_divider_inputs in = {.en = 1};
    if (clock % pace == 0 && turn < batch->count * turns) {
        const glint_division *division = &batch->division[turn / turns];
        in.start = 1;
        in.k = division->k;
        memcpy(in.difference, division->difference, sizeof in.difference);
        if (is_sequential(setting))
            in.difference[0] = division->difference[turn % turns];
    }
    memcpy(pins, &in, sizeof in);
}

static void batch_of(const glint_answer *answer, glint_batch *batch)
{
    batch->division = answer->division;
}

static void alone_of(const glint_answer *answer, const glint_setting *setting, glint_answer *alone)
{
    const glint_division *asked = &answer->division[answer->at];
    (void)setting;
    alone->count = 1;
    alone->division[0] = (glint_division){.k = asked->k};
    for (int c = 0; c <= (int)answer->value - GLINT_ANSWER_R; c++)
        alone->division[0].difference[c] = asked->difference[c];
}

static int32_t value_of(const glint_quotients *quotients, const glint_answer *answer)
{
    return quotients[answer->at].code[answer->value - GLINT_ANSWER_R];
}

static glint_status ask(const glint_answer *answer, const glint_setting *setting, int32_t *model,
                        int32_t *rtl, glint_error *err)
{
    glint_quotients found[GLINT_ANSWER_DIVISIONS];
    glint_rtl *circuit = NULL;
    const int shifts = setting->values[GLINT_DIVIDER_SHIFTS];
    const size_t count = (size_t)answer->count;
    glint_status status = glint_divide_batch(shifts, answer->division, count, found);
    if (status != GLINT_OK)
        return glint_fail(err, status, "the C model rejects %d shifts", shifts);
    *model = value_of(found, answer);
    status = glint_rtl_open(setting, GLINT_RTL_FAST, &circuit, err);
    if (status == GLINT_OK)
        status = glint_rtl_divide(circuit, answer->division, count, found, err);
    glint_rtl_destroy(circuit);
    if (status == GLINT_OK)
        *rtl = value_of(found, answer);
    return status;
}

static uint64_t clock_taken(const glint_answer *answer, const glint_setting *setting)
{
    const uint64_t before = feeding_clocks(setting, (size_t)answer->at);
    const uint64_t turn = is_sequential(setting) ? (uint64_t)(answer->value - GLINT_ANSWER_R) : 0;
    return before + turn * pace_of(setting) + 1;
}

static bool is_output(const glint_answer *answer, const glint_setting *setting,
                      const glint_signal_info *signal)
{
    static const char *const outputs[] = {"", "quotient_r", "quotient_g", "quotient_b"};
    return strcmp(signal->name, is_sequential(setting) ? "quotient" : outputs[answer->value]) == 0;
}

const glint_answer_kind glint_divider_answers = {
    .feeding_clocks = feeding_clocks,
    .out_when_fed = is_sequential,
    .put = put,
    .batch = batch_of,
    .alone = alone_of,
    .ask = ask,
    .clock_taken = clock_taken,
    .is_output = is_output,
};
