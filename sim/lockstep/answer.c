/* Names and checks for single wrong answers; see answer.h. */
#include "lockstep/answer.h"

#include <stdlib.h>
#include <string.h>

#include "circuit/circuits.h"
#include "circuit/units.h"
#include "lockstep/answer_kind.h"

#define CLOCKS_AFTER_RESULT 10 /* idle ones, so that a waveform shows what follows */

const glint_answer_kind *glint_answer_kind_of(const glint_circuit *circuit)
{
    if (glint_is_highlight(circuit))
        return &glint_specular_answers;
    return circuit == &glint_circuit_divider ? &glint_divider_answers
           : circuit == &glint_circuit_span  ? &glint_span_answers
                                             : NULL;
}

bool glint_answer_possible(const glint_circuit *circuit)
{
    return glint_answer_kind_of(circuit) != NULL;
}

/* The part of a run that is kept: items first … last − 1. */
typedef struct part {
    size_t first, last;
} part;

/* `each` items go in at a clock. */
static part part_about(size_t count, size_t at, size_t each)
{
    const size_t clock = at / each;
    const size_t before =
        clock < GLINT_ANSWER_CLOCKS_BEFORE ? clock : (size_t)GLINT_ANSWER_CLOCKS_BEFORE;
    const size_t last = (clock + 1 + GLINT_ANSWER_CLOCKS_AFTER) * each;
    return (part){(clock - before) * each, last < count ? last : count};
}

void glint_answer_keep_points(glint_answer *answer, int lanes, const glint_material *material,
                              const uint32_t *cos_code, size_t count, size_t at)
{
    const part kept = part_about(count, at, (size_t)lanes);
    answer->material = *material;
    answer->count = (int)(kept.last - kept.first);
    answer->at = (int)(at - kept.first);
    memcpy(answer->cos_code, cos_code + kept.first, (size_t)answer->count * sizeof *cos_code);
}

void glint_answer_keep_divisions(glint_answer *answer, const glint_division *divisions,
                                 size_t count, size_t at)
{
    const part kept = part_about(count, at, 1);
    answer->count = (int)(kept.last - kept.first);
    answer->at = (int)(at - kept.first);
    memcpy(answer->division, divisions + kept.first, (size_t)answer->count * sizeof *divisions);
}

void glint_answer_keep_steps(glint_answer *answer, int fraction, const glint_span_step *steps,
                             size_t count, size_t at)
{
    const part kept = part_about(count, at, 1);
    answer->count = (int)(kept.last - kept.first);
    answer->at = (int)(at - kept.first);
    memcpy(answer->step, steps + kept.first, (size_t)answer->count * sizeof *steps);
    if (!answer->step[0].load)
        answer->step[0] = glint_span_step_resumed(fraction, steps, kept.first);
}

void glint_answer_alone(const glint_answer *answer, const glint_setting *setting,
                        glint_answer *alone)
{
    memset(alone, 0, sizeof *alone);
    alone->value = answer->value;
    alone->model = answer->model;
    alone->rtl = answer->rtl;
    glint_answer_kind_of(setting->circuit)->alone(answer, setting, alone);
}

const char *glint_answer_value_name(glint_answer_value value)
{
    static const char *const names[] = {"W", "red", "green", "blue"};
    return names[value];
}

glint_status glint_answer_ask(const glint_answer *answer, const glint_setting *setting,
                              int32_t *model, int32_t *rtl, glint_error *err)
{
    return glint_answer_kind_of(setting->circuit)->ask(answer, setting, model, rtl, err);
}

glint_pins *glint_answer_pins(const glint_answer *answer, const glint_setting *setting,
                              size_t *count, uint64_t *expected)
{
    const glint_answer_kind *kind = glint_answer_kind_of(setting->circuit);
    const size_t latency = (size_t)glint_setting_latency(setting);
    glint_batch batch = {.count = (size_t)answer->count};
    kind->batch(answer, &batch);
    *count = glint_batch_feeding_clocks(setting, batch.count) + latency + CLOCKS_AFTER_RESULT;
    *expected = kind->clock_taken(answer, setting) + latency - 1;
    glint_pins *pins = malloc(*count * sizeof *pins);
    for (size_t clock = 0; pins != NULL && clock < *count; clock++)
        glint_batch_pins(setting, &batch, clock, &pins[clock]);
    return pins;
}
