/* Picks the scene for a circuit and fills it with pins; see scene.h. */
#include "wave/scene.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/circuits.h"
#include "circuit/random_pins.h"
#include "circuit/words.h"
#include "lockstep/signals.h"
#include "wave/divider_scene.h"
#include "wave/specular_scene.h"

/* For a circuit without its own scene. */
enum {
    RESET_CLOCK = 1,
    FIRST_CLOCK = 3,  /* that takes something */
    RUN_CLOCKS = 40,  /* from there on, as far as the circuit is not slower */
    THINGS = 4,       /* inputs that even a slow circuit accepts */
    STALL_CLOCKS = 3, /* a third of the way */
    GAP_CLOCKS = 2,   /* two thirds of the way, for certain */
};
#define SEED 11

static int run_clocks(const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    const int pace = circuit->pace != NULL ? circuit->pace(setting->values) : 1;
    return pace * THINGS > RUN_CLOCKS ? pace * THINGS : RUN_CLOCKS;
}

static int random_clocks(const glint_setting *setting)
{
    return FIRST_CLOCK + run_clocks(setting) + glint_setting_latency(setting) + STALL_CLOCKS;
}

static void put(const glint_pin_info *pin, glint_pins *pins, uint64_t value)
{
    uint64_t words[GLINT_VALUE_WORDS] = {value};
    glint_pin_set(pin, pins, words);
}

/* What the clock is for, put on the pins that control the circuit; the data is random. */
static void control(const glint_setting *setting, int clock, glint_pins *pins)
{
    const int run = run_clocks(setting);
    const int stall = FIRST_CLOCK + run / 3;
    const int gap = FIRST_CLOCK + 2 * run / 3;
    const bool is_reset = clock == RESET_CLOCK;
    const bool is_stalled = clock >= stall && clock < stall + STALL_CLOCKS;
    const bool is_quiet = clock < FIRST_CLOCK || clock >= FIRST_CLOCK + run + STALL_CLOCKS ||
                          (clock >= gap && clock < gap + GAP_CLOCKS);
    for (int i = 0; i < setting->circuit->pin_count(setting->values); i++) {
        const glint_pin_info pin = setting->circuit->pin(setting->values, i);
        if (pin.role == GLINT_PIN_RESET)
            put(&pin, pins, is_reset);
        else if (pin.role == GLINT_PIN_RESET_LOW)
            put(&pin, pins, !is_reset);
        else if (pin.role == GLINT_PIN_ENABLE)
            put(&pin, pins, !is_stalled);
        else if (pin.role == GLINT_PIN_ENABLE_LOW)
            put(&pin, pins, is_stalled);
        else if (pin.role == GLINT_PIN_VALID && is_quiet)
            put(&pin, pins, 0);
    }
}

static void fill_random(const glint_setting *setting, glint_wave_scene *scene)
{
    glint_random_pins source;
    glint_random_pins_begin(&source, setting, SEED);
    for (int i = 0; i < scene->clocks; i++) {
        glint_random_pins_next(&source, &scene->pins[i]);
        control(setting, i + 1, &scene->pins[i]);
    }
}

static void fill_specular(const glint_setting *setting, glint_wave_scene *scene)
{
    for (int i = 0; i < scene->clocks; i++)
        glint_specular_scene(i + 1, setting->values[GLINT_SPECULAR_LANES],
                             (glint_specular_inputs *)(void *)&scene->pins[i]);
}

static glint_divider_form form_of(const glint_setting *setting)
{
    return (glint_divider_form)setting->values[GLINT_DIVIDER_FORM];
}

static void fill_divider(const glint_setting *setting, glint_wave_scene *scene)
{
    for (int i = 0; i < scene->clocks; i++)
        glint_divider_scene(form_of(setting), setting->values[GLINT_DIVIDER_SHIFTS], i + 1,
                            (glint_divider_inputs *)(void *)&scene->pins[i]);
}

int glint_wave_scene_clocks(const glint_setting *setting)
{
    return setting->circuit == &glint_circuit_specular ? GLINT_SPECULAR_SCENE_CLOCKS
           : setting->circuit == &glint_circuit_divider
               ? glint_divider_scene_clocks(form_of(setting), setting->values[GLINT_DIVIDER_SHIFTS])
               : random_clocks(setting);
}

static int marker_of(const glint_setting *setting)
{
    return setting->circuit == &glint_circuit_specular
               ? glint_specular_scene_centre(setting->values[GLINT_SPECULAR_LANES])
           : setting->circuit == &glint_circuit_divider
               ? glint_divider_scene_first_result(form_of(setting),
                                                  setting->values[GLINT_DIVIDER_SHIFTS]) -
                     1
               : FIRST_CLOCK;
}

glint_status glint_wave_scene_make(const glint_setting *setting, glint_wave_scene *scene,
                                   glint_error *err)
{
    scene->clocks = glint_wave_scene_clocks(setting);
    scene->marker = marker_of(setting);
    scene->pins = calloc((size_t)scene->clocks, sizeof *scene->pins);
    if (scene->pins == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a scene");
    (setting->circuit == &glint_circuit_specular  ? fill_specular
     : setting->circuit == &glint_circuit_divider ? fill_divider
                                                  : fill_random)(setting, scene);
    return GLINT_OK;
}
