/* The pins that take a run of points, divisions or spans through a highlight unit, the divider or
 * the span unit clock by clock, exactly as glint_rtl_shade(), glint_rtl_divide() and
 * glint_rtl_walk() do (answer_kind.h). */
#ifndef GLINT_SIM_LOCKSTEP_BATCH_PINS_H
#define GLINT_SIM_LOCKSTEP_BATCH_PINS_H

#include "circuit/setting.h"
#include "glint_divider.h"
#include "glint_quadratic_span.h"
#include "glint_specular.h"

/* A pixel of a span: its first, or the next one. */
typedef struct glint_span_step {
    uint8_t load;
    glint_quadratic_walk walk; /* of its span */
} glint_span_step;

/* Points of one material, for a highlight unit, or divisions, or pixels of spans. */
typedef struct glint_batch {
    const glint_material *material;
    const uint32_t *cos_code;
    const glint_division *division;
    const glint_span_step *step;
    size_t count;
} glint_batch;

/* Clocks that feed so many points, divisions or pixels. */
size_t glint_batch_feeding_clocks(const glint_setting *setting, size_t count);

/* Clocks from the first that feeds to the one after which all has come out. */
size_t glint_batch_clocks(const glint_setting *setting, size_t count);

/* The pins of a clock, 0…; behind those that feed, idle ones. */
void glint_batch_pins(const glint_setting *setting, const glint_batch *batch, size_t clock,
                      glint_pins *pins);

#endif
