/* The specular device's demonstration scene: a scan line across a highlight, in over its edge,
 * through its centre and out again, with a stall in the middle; then a new material with the very
 * next point, a gap, a code above 1.0, and a third material between points. */
#ifndef GLINT_SIM_WAVE_SPECULAR_SCENE_H
#define GLINT_SIM_WAVE_SPECULAR_SCENE_H

#include "glint_specular_device.h"

#define GLINT_SPECULAR_SCENE_CLOCKS 48

/* The pins of clock `clock` (1…GLINT_SPECULAR_SCENE_CLOCKS) for a device of `lanes` lanes. */
void glint_specular_scene(int clock, int lanes, glint_specular_inputs *inputs);

/* Clock of the scene at whose edge the centre of the highlight enters register 1. */
int glint_specular_scene_centre(int lanes);

#endif
