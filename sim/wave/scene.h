/* What a circuit's waveform shows: the pins for a few dozen clocks. The thesis's circuits have
 * their own scenes (specular_scene.h, divider_scene.h); any other gets random pins, with a reset,
 * gaps and a stall. */
#ifndef GLINT_SIM_WAVE_SCENE_H
#define GLINT_SIM_WAVE_SCENE_H

#include "circuit/setting.h"

typedef struct glint_wave_scene {
    int clocks;
    int marker;       /* the clock to look at, 1…clocks */
    glint_pins *pins; /* clocks of them */
} glint_wave_scene;

/* To be freed with free(scene->pins). */
glint_status glint_wave_scene_make(const glint_setting *setting, glint_wave_scene *scene,
                                   glint_error *err);

/* The most clocks that a scene of the circuit has in any setting of a parameter's range: for
 * options that name a clock. */
int glint_wave_scene_clocks(const glint_setting *setting);

#endif
