/* `--scene`: scenes of the program that the thesis's section 3.3 describes, as far as it gives
 * them. */
#ifndef GLINT_SIM_CLI_PRESET_H
#define GLINT_SIM_CLI_PRESET_H

#include "cli/scene_options.h"

typedef enum glint_preset {
    GLINT_PRESET_DEFAULT,    /* glint_scene_defaults() */
    GLINT_PRESET_FIGURE_3_9, /* the fields of figure 3.9: a white object in orange light */
    GLINT_PRESET_LISTING,    /* appendix A's calcColor: cos·colour + white·cosⁿ */
    GLINT_PRESET_COUNT
} glint_preset;

/* For GLINT_OPTION_CHOICE. */
extern const char *const glint_preset_names[];

/* Ia, Ie, Ka, Kd, Ks, C and S of the preset chosen, where the command line gives none. */
void glint_preset_apply(glint_scene_options *chosen);

/* Its exponent; the default's for the default. */
double glint_preset_n(const glint_scene_options *chosen);

#endif
