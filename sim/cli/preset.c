/* The values of the program's scenes; see preset.h. */
#include "cli/preset.h"

#include <string.h>

const char *const glint_preset_names[] = {
    [GLINT_PRESET_DEFAULT] = "default",
    [GLINT_PRESET_FIGURE_3_9] = "figure-3.9",
    [GLINT_PRESET_LISTING] = "listing",
    [GLINT_PRESET_COUNT] = NULL,
};

#define ORANGE                                                                                     \
    {                                                                                              \
        238, 138, 32                                                                               \
    }

typedef struct preset {
    double ie[3]; /* 0…255 */
    double kd, ks;
    uint8_t color[3];
} preset;

/* Both have n = 100, Ia = 0, Ka = 1 and a white highlight. */
#define PRESET_N 100.0

static const preset presets[GLINT_PRESET_COUNT] = {
    [GLINT_PRESET_FIGURE_3_9] = {.ie = ORANGE, .kd = 0.5, .ks = 0.5, .color = {255, 255, 255}},
    [GLINT_PRESET_LISTING] = {.ie = {255, 255, 255}, .kd = 1.0, .ks = 1.0, .color = ORANGE},
};

static void set(double *value, bool given, double preset_value)
{
    if (!given)
        *value = preset_value;
}

void glint_preset_apply(glint_scene_options *chosen)
{
    if (chosen->preset == GLINT_PRESET_DEFAULT)
        return;
    const preset *p = &presets[chosen->preset];
    const glint_scene_given *given = &chosen->given;
    set(&chosen->ka, given->ka, 1.0);
    set(&chosen->kd, given->kd, p->kd);
    set(&chosen->ks, given->ks, p->ks);
    for (int i = 0; i < 3; i++) {
        set(&chosen->ia[i], given->ia, 0.0);
        set(&chosen->ie[i], given->ie, p->ie[i] / 255.0);
    }
    if (!given->color)
        memcpy(chosen->color, p->color, sizeof chosen->color);
    if (!given->highlight)
        memset(chosen->highlight, 255, sizeof chosen->highlight);
}

double glint_preset_n(const glint_scene_options *chosen)
{
    glint_scene scene = {0};
    glint_scene_defaults(&scene);
    return chosen->preset == GLINT_PRESET_DEFAULT ? scene.n : PRESET_N;
}
