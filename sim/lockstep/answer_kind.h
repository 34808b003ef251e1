/* What differs between the circuits whose answers frames and exhaustive runs ask for by number: the
 * highlight units, specular_answer.c, the divider, divider_answer.c, and the span unit,
 * span_answer.c. */
#ifndef GLINT_SIM_LOCKSTEP_ANSWER_KIND_H
#define GLINT_SIM_LOCKSTEP_ANSWER_KIND_H

#include "lockstep/answer.h"
#include "lockstep/batch_pins.h"
#include "lockstep/signals.h"

typedef struct glint_answer_kind {
    /* glint_batch_feeding_clocks(); whether nothing is left in flight when they are over. */
    size_t (*feeding_clocks)(const glint_setting *setting, size_t count);
    bool (*out_when_fed)(const glint_setting *setting);

    /* glint_batch_pins(), on pins that are 0. */
    void (*put)(const glint_setting *setting, const glint_batch *batch, size_t clock,
                glint_pins *pins);

    /* The answer's points, divisions or pixels as a run. */
    void (*batch)(const glint_answer *answer, glint_batch *batch);

    /* glint_answer_alone(), the rest of it being done; glint_answer_ask(). */
    void (*alone)(const glint_answer *answer, const glint_setting *setting, glint_answer *alone);
    glint_status (*ask)(const glint_answer *answer, const glint_setting *setting, int32_t *model,
                        int32_t *rtl, glint_error *err);

    /* The clock, from 1 on, at which the answer's point is taken. */
    uint64_t (*clock_taken)(const glint_answer *answer, const glint_setting *setting);

    /* Whether the signal is the output with the answer's value. */
    bool (*is_output)(const glint_answer *answer, const glint_setting *setting,
                      const glint_signal_info *signal);
} glint_answer_kind;

extern const glint_answer_kind glint_specular_answers, glint_divider_answers, glint_span_answers;

/* NULL: the circuit's answers are not asked for by number. */
const glint_answer_kind *glint_answer_kind_of(const glint_circuit *circuit);

#endif
