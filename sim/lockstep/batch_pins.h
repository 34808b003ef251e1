/* The pins that take a run of points or divisions through a highlight unit or the divider clock by
 * clock, exactly as glint_rtl_shade() and glint_rtl_divide() do (answer_kind.h). */
#ifndef GLINT_SIM_LOCKSTEP_BATCH_PINS_H
#define GLINT_SIM_LOCKSTEP_BATCH_PINS_H

#include "circuit/setting.h"
#include "glint_divider.h"
#include "glint_specular.h"

/* Points of one material, for a highlight unit, or divisions. */
typedef struct glint_batch {
    const glint_material *material;
    const uint32_t *cos_code;
    const glint_division *division;
    size_t count;
} glint_batch;

/* Clocks that feed so many points or divisions. */
size_t glint_batch_feeding_clocks(const glint_setting *setting, size_t count);

/* Clocks from the first that feeds to the one after which all has come out. */
size_t glint_batch_clocks(const glint_setting *setting, size_t count);

/* The pins of a clock, 0…; behind those that feed, idle ones. */
void glint_batch_pins(const glint_setting *setting, const glint_batch *batch, size_t clock,
                      glint_pins *pins);

#endif
