/* The options that choose what computes the highlights of a frame: --device, the parameters of the
 * specular device and those that are other units' own (circuit/units.h).
 *
 *     glint_device_options device;
 *     glint_device_options_begin(&device);
 *     … glint_option options[OWN + GLINT_DEVICE_OPTIONS] = {…};
 *     const size_t count = OWN + glint_device_options_add(&device, options + OWN);
 *     … glint_options_parse() …
 *     status = glint_device_options_settle("render", &device, &config); */
#ifndef GLINT_SIM_CLI_DEVICE_OPTIONS_H
#define GLINT_SIM_CLI_DEVICE_OPTIONS_H

#include "backend/backend.h"
#include "cli/options.h"

#define GLINT_DEVICES_MAX    16
#define GLINT_DEVICE_OPTIONS (GLINT_DEVICES_MAX + 4) /* rows at most */

/* A unit's own parameter. */
typedef struct glint_own_option {
    const glint_circuit *circuit;
    int value;
    bool given;
    const char *names[8]; /* of its values; NULL ends them */
    char help[128];
} glint_own_option;

/* Must not move once rows point into it. */
typedef struct glint_device_options {
    const glint_circuit *circuit[GLINT_DEVICES_MAX];
    const char *names[GLINT_DEVICES_MAX + 1]; /* theirs; NULL ends them */
    int device;                               /* of them */
    int gate, pipeline;
    int64_t lanes; /* 0: the fastest */
    bool gate_given, pipeline_given, lanes_given;
    int own_count;
    glint_own_option own[GLINT_DEVICES_MAX];
} glint_device_options;

void glint_device_options_begin(glint_device_options *options);

/* Fills rows; returns how many. */
size_t glint_device_options_add(glint_device_options *options, glint_option *rows);

/* After parsing: device, variant, gate, pipeline and lanes of config. Returns GLINT_OPTIONS_RUN, or
 * the exit status to leave with: an option that the device does not have is refused. */
int glint_device_options_settle(const char *command, const glint_device_options *options,
                                glint_backend_config *config);

/* The first option given of those that only the device itself has; NULL: none. */
const char *glint_device_options_needless(const glint_device_options *options);

#endif
