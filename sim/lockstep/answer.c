#include "lockstep/answer.h"

#include <stdlib.h>
#include <string.h>

#include "lockstep/batch_pins.h"

#define CLOCKS_AFTER_RESULT 10 /* idle ones, so that a waveform shows what comes behind it */

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
    answer->is_divider = false;
    answer->material = *material;
    answer->count = (int)(kept.last - kept.first);
    answer->at = (int)(at - kept.first);
    memcpy(answer->cos_code, cos_code + kept.first, (size_t)answer->count * sizeof *cos_code);
}

void glint_answer_keep_divisions(glint_answer *answer, const glint_division *divisions,
                                 size_t count, size_t at)
{
    const part kept = part_about(count, at, 1);
    answer->is_divider = true;
    answer->count = (int)(kept.last - kept.first);
    answer->at = (int)(at - kept.first);
    memcpy(answer->division, divisions + kept.first, (size_t)answer->count * sizeof *divisions);
}

static void division_alone(const glint_answer *answer, glint_answer *alone)
{
    const glint_division *asked = &answer->division[answer->at];
    alone->count = 1;
    alone->division[0] = (glint_division){.k = asked->k};
    for (int c = 0; c <= (int)answer->value - GLINT_ANSWER_R; c++)
        alone->division[0].difference[c] = asked->difference[c];
}

static void point_alone(const glint_answer *answer, int lanes, glint_answer *alone)
{
    alone->material = answer->material;
    alone->at = answer->at % lanes;
    alone->count = alone->at + 1;
    for (int i = 0; i < alone->count; i++)
        alone->cos_code[i] = answer->cos_code[answer->at];
}

void glint_answer_alone(const glint_answer *answer, const glint_setting *setting,
                        glint_answer *alone)
{
    memset(alone, 0, sizeof *alone);
    alone->is_divider = answer->is_divider;
    alone->value = answer->value;
    alone->model = answer->model;
    alone->rtl = answer->rtl;
    if (answer->is_divider)
        division_alone(answer, alone);
    else
        point_alone(answer, setting->specular.lanes, alone);
}

const char *glint_answer_value_name(glint_answer_value value)
{
    static const char *const names[] = {"W", "red", "green", "blue"};
    return names[value];
}

/* ---- As a frame asks ----------------------------------------------------------------------------
 */

typedef struct highlights {
    uint32_t w[GLINT_ANSWER_POINTS];
    uint8_t r[GLINT_ANSWER_POINTS], g[GLINT_ANSWER_POINTS], b[GLINT_ANSWER_POINTS];
} highlights;

static int32_t highlight_value(const highlights *of, const glint_answer *answer)
{
    switch (answer->value) {
    case GLINT_ANSWER_R:
        return of->r[answer->at];
    case GLINT_ANSWER_G:
        return of->g[answer->at];
    case GLINT_ANSWER_B:
        return of->b[answer->at];
    default:
        return (int32_t)of->w[answer->at];
    }
}

static glint_status ask_specular(const glint_answer *answer, const glint_setting *setting,
                                 int32_t *model, int32_t *rtl, glint_error *err)
{
    highlights found;
    glint_rtl *circuit;
    const size_t count = (size_t)answer->count;
    glint_status status =
        glint_specular_batch(setting->specular.gate, &answer->material, answer->cos_code, count,
                             found.w, found.r, found.g, found.b);
    if (status != GLINT_OK)
        return glint_fail(err, status, "the C model refuses n = %u", answer->material.n);
    *model = highlight_value(&found, answer);
    status = setting->specular_model != NULL
                 ? glint_rtl_create_from(setting->specular_model, &setting->specular, &circuit, err)
                 : glint_rtl_create_fast(&setting->specular, &circuit, err);
    if (status == GLINT_OK)
        status = glint_rtl_batch(circuit, &answer->material, answer->cos_code, count, found.w,
                                 found.r, found.g, found.b, err);
    glint_rtl_destroy(circuit);
    if (status == GLINT_OK)
        *rtl = highlight_value(&found, answer);
    return status;
}

static int32_t quotient_value(const glint_quotients *quotients, const glint_answer *answer)
{
    return quotients[answer->at].code[answer->value - GLINT_ANSWER_R];
}

static glint_status ask_divider(const glint_answer *answer, const glint_setting *setting,
                                int32_t *model, int32_t *rtl, glint_error *err)
{
    glint_quotients found[GLINT_ANSWER_DIVISIONS];
    glint_divider_rtl *circuit;
    const size_t count = (size_t)answer->count;
    glint_status status = glint_divide_batch(setting->shifts, answer->division, count, found);
    if (status != GLINT_OK)
        return glint_fail(err, status, "the C model refuses %d shifts", setting->shifts);
    *model = quotient_value(found, answer);
    status = setting->divider_model != NULL
                 ? glint_divider_rtl_create_from(setting->divider_model, &circuit, err)
                 : glint_divider_rtl_create(setting->form, setting->shifts, &circuit, err);
    if (status == GLINT_OK)
        status = glint_divider_rtl_batch(circuit, answer->division, count, found, err);
    glint_divider_rtl_destroy(circuit);
    if (status == GLINT_OK)
        *rtl = quotient_value(found, answer);
    return status;
}

glint_status glint_answer_ask(const glint_answer *answer, const glint_setting *setting,
                              int32_t *model, int32_t *rtl, glint_error *err)
{
    return answer->is_divider ? ask_divider(answer, setting, model, rtl, err)
                              : ask_specular(answer, setting, model, rtl, err);
}

/* ---- Clock by clock -----------------------------------------------------------------------------
 */

/* The clock, from 1 on, at which the answer's point is taken. */
static uint64_t clock_taken(const glint_answer *answer, const glint_setting *setting)
{
    if (!setting->is_divider)
        return (uint64_t)(answer->at / setting->specular.lanes) + 1;
    const uint64_t before = glint_batch_feeding_clocks(setting, (size_t)answer->at);
    return setting->form == GLINT_DIVIDER_PIPELINED
               ? before + 1
               : before +
                     (uint64_t)(answer->value - GLINT_ANSWER_R) * (uint64_t)(setting->shifts + 1) +
                     1;
}

glint_pins *glint_answer_pins(const glint_answer *answer, const glint_setting *setting,
                              size_t *count, uint64_t *expected)
{
    const size_t latency = (size_t)glint_setting_latency(setting);
    const glint_batch batch = {.material = &answer->material,
                               .cos_code = answer->cos_code,
                               .division = answer->division,
                               .count = (size_t)answer->count};
    *count = glint_batch_feeding_clocks(setting, batch.count) + latency + CLOCKS_AFTER_RESULT;
    *expected = clock_taken(answer, setting) + latency - 1;
    glint_pins *pins = malloc(*count * sizeof *pins);
    for (size_t clock = 0; pins != NULL && clock < *count; clock++)
        pins[clock] = glint_batch_pins(setting, &batch, clock);
    return pins;
}
