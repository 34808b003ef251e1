/* The dividers' demonstration scene: 255/7, −255/9 with a stall in the middle, a start while that
 * division is in progress, 100/1 (the bit i₀), 200/16, and 37/17, which is outside the table. The
 * sequential form takes them one after another, the pipelined form one per clock. */
#ifndef GLINT_SIM_WAVE_DIVIDER_SCENE_H
#define GLINT_SIM_WAVE_DIVIDER_SCENE_H

#include "glint_divider_device.h"

#define GLINT_DIVIDER_SCENE_DIVISIONS 5

/* Clocks of the scene: every division has come out when it ends. */
int glint_divider_scene_clocks(glint_divider_form form, int shifts);

/* The circuit's clock (the reset of creation is its first) after which the first quotient is out.
 */
int glint_divider_scene_first_result(glint_divider_form form, int shifts);

/* The pins of clock `clock` (1…glint_divider_scene_clocks()). */
void glint_divider_scene(glint_divider_form form, int shifts, int clock,
                         glint_divider_inputs *inputs);

#endif
