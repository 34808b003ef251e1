/* Either circuit in one of its settings, for whatever treats the specular device and the divider
 * alike: lockstep, and what is left of a mismatch. */
#ifndef GLINT_SIM_SETTING_H
#define GLINT_SIM_SETTING_H

#include <stdbool.h>
#include <stddef.h>

#include "glint_divider_device.h"
#include "glint_specular_device.h"
#include "rtl/divider_rtl.h"
#include "rtl/rtl.h"

typedef struct glint_setting {
    bool is_divider;
    glint_specular_config specular; /* unless is_divider */
    glint_divider_form form;        /* if is_divider, like shifts */
    int shifts;
    const glint_rtl_model *specular_model; /* NULL: the build for the setting; else a test's own */
    const glint_divider_model *divider_model; /* likewise */
} glint_setting;

/* What the input pins of the circuit carry at one rising edge. */
typedef union glint_pins {
    glint_specular_inputs specular;
    glint_divider_inputs divider;
} glint_pins;

/* At most so many signals, whatever the setting. */
#define GLINT_SETTING_SIGNALS_MAX 512

/* GLINT_BAD_ARGUMENT, naming the value, for a setting that no circuit can have. */
glint_status glint_setting_check(const glint_setting *setting, glint_error *err);

/* The signals, 0…count−1, as glint_specular_signal_info() and glint_divider_signal_info(). */
int glint_setting_signal_count(const glint_setting *setting);
glint_signal_info glint_setting_signal(const glint_setting *setting, int index);

/* What signal.lane counts: "lane" or "stage". */
const char *glint_setting_lane_name(const glint_setting *setting);

/* Clocks from taking a point or a division to the edge after which its result is out. */
int glint_setting_latency(const glint_setting *setting);

/* "gate cosine, pipeline pipelined, lanes 1", "divider sequential, 12 shifts": for people. */
#define GLINT_SETTING_TEXT 64
void glint_setting_describe(const glint_setting *setting, char text[GLINT_SETTING_TEXT]);

/* "specular_cosine_pipelined_1", "divider_sequential_12": for the names of files. */
void glint_setting_name(const glint_setting *setting, char text[GLINT_SETTING_TEXT]);

/* "--circuit specular --gate cosine --pipeline pipelined --lanes 1": for a command line. */
#define GLINT_SETTING_OPTIONS 96
void glint_setting_options(const glint_setting *setting, char text[GLINT_SETTING_OPTIONS]);

#endif
