/* Spans, pixel by pixel: answer_kind.h. */
#include <string.h>

#include "circuit/circuits.h"
#include "lockstep/answer_kind.h"
#include "rtl/batch.h"

_Static_assert(sizeof(glint_quadratic_span_pins) <= sizeof(glint_pins), "its pins fit");

static size_t feeding_clocks(const glint_setting *setting, size_t count)
{
    (void)setting;
    return count;
}

static bool out_when_fed(const glint_setting *setting)
{
    (void)setting;
    return false;
}

static void put(const glint_setting *setting, const glint_batch *batch, size_t clock,
                glint_pins *pins)
{
    glint_quadratic_span_pins in = {.en = 1};
    (void)setting;
    if (clock < batch->count) {
        in.load = batch->step[clock].load;
        in.step = 1;
        in.walk = batch->step[clock].walk;
    }
    memcpy(pins, &in, sizeof in);
}

static void batch_of(const glint_answer *answer, glint_batch *batch)
{
    batch->step = answer->step;
}

glint_span_step glint_span_step_resumed(int fraction, const glint_span_step *steps, size_t at)
{
    size_t load = at;
    while (load > 0 && !steps[load].load)
        load--;
    return (glint_span_step){1, glint_quadratic_span_after(fraction, &steps[load].walk, at - load)};
}

/* The pixel by the addition that leads to it, or by its load if that is how it comes about. */
static void alone_of(const glint_answer *answer, const glint_setting *setting, glint_answer *alone)
{
    const size_t at = (size_t)answer->at;
    const bool by_step = at > 0 && !answer->step[at].load;
    alone->at = by_step;
    alone->count = alone->at + 1;
    alone->step[0] = glint_span_step_resumed(setting->values[0], answer->step, at - by_step);
    if (by_step)
        alone->step[1].walk = alone->step[0].walk;
}

static int32_t value_of(const uint8_t *rgb, const glint_answer *answer)
{
    return rgb[GLINT_QUADRATIC_SPAN_COMPONENTS * answer->at + (int)answer->value - GLINT_ANSWER_R];
}

/* The steps as spans. */
typedef struct walks {
    glint_quadratic_walk walk[GLINT_ANSWER_STEPS];
    uint32_t length[GLINT_ANSWER_STEPS];
    size_t count;
} walks;

static void collect(const glint_answer *answer, walks *w)
{
    w->count = 0;
    for (int i = 0; i < answer->count; i++) {
        if (i == 0 || answer->step[i].load) {
            w->walk[w->count] = answer->step[i].walk;
            w->length[w->count++] = 0;
        }
        w->length[w->count - 1]++;
    }
}

static glint_status ask(const glint_answer *answer, const glint_setting *setting, int32_t *model,
                        int32_t *rtl, glint_error *err)
{
    uint8_t rgb[GLINT_QUADRATIC_SPAN_COMPONENTS * GLINT_ANSWER_STEPS];
    walks w;
    glint_rtl *circuit = NULL;
    size_t done = 0;
    collect(answer, &w);
    for (size_t i = 0; i < w.count; done += w.length[i++])
        if (glint_quadratic_span(setting->values[0], &w.walk[i], w.length[i],
                                 rgb + GLINT_QUADRATIC_SPAN_COMPONENTS * done) != GLINT_OK)
            return glint_fail(err, GLINT_BAD_ARGUMENT, "the C model rejects %d fraction bits",
                              setting->values[0]);
    *model = value_of(rgb, answer);
    glint_status status = glint_rtl_open(setting, GLINT_RTL_FAST, &circuit, err);
    const glint_spans spans = {.walk = w.walk, .length = w.length, .count = w.count, .rgb = rgb};
    if (status == GLINT_OK)
        status = glint_rtl_walk(circuit, &spans, err);
    glint_rtl_destroy(circuit);
    if (status == GLINT_OK)
        *rtl = value_of(rgb, answer);
    return status;
}

static uint64_t clock_taken(const glint_answer *answer, const glint_setting *setting)
{
    (void)setting;
    return (uint64_t)answer->at + 1;
}

static bool is_output(const glint_answer *answer, const glint_setting *setting,
                      const glint_signal_info *signal)
{
    static const char *const outputs[] = {"", "r", "g", "b"};
    (void)setting;
    return strcmp(signal->name, outputs[answer->value]) == 0;
}

const glint_answer_kind glint_span_answers = {
    .feeding_clocks = feeding_clocks,
    .out_when_fed = out_when_fed,
    .put = put,
    .batch = batch_of,
    .alone = alone_of,
    .ask = ask,
    .clock_taken = clock_taken,
    .is_output = is_output,
};
