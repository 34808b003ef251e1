/* The device of a frame by its options; see device_options.h. */
#include "cli/device_options.h"

#include <stdio.h>

#include "circuit/circuits.h"
#include "circuit/units.h"
#include "cli/output.h"

/* The parameter's values by their names. */
static void add_own(glint_device_options *options, const glint_circuit *circuit,
                    const glint_parameter *parameter)
{
    glint_own_option *own = &options->own[options->own_count++];
    own->circuit = circuit;
    own->value = parameter->standard;
    for (int i = 0; i <= parameter->max && i < 7; i++)
        own->names[i] = parameter->choices[i];
    (void)snprintf(own->help, sizeof own->help, "of --device %s: %s", circuit->name,
                   parameter->meaning);
}

void glint_device_options_begin(glint_device_options *options)
{
    const glint_circuit *circuit;
    int count = 0;
    *options = (glint_device_options){.pipeline = GLINT_PIPELINE_PIPELINED};
    for (int i = 0; (circuit = glint_circuit_number(i)) != NULL; i++) {
        if (!glint_is_highlight(circuit) || count == GLINT_DEVICES_MAX)
            continue;
        const glint_parameter *parameter = glint_highlight_parameter(circuit);
        options->circuit[count] = circuit;
        options->names[count++] = circuit->name;
        if (parameter != NULL)
            add_own(options, circuit, parameter);
    }
}

size_t glint_device_options_add(glint_device_options *options, glint_option *rows)
{
    size_t count = 0;
    rows[count++] =
        (glint_option){.name = "device",
                       .placeholder = "NAME",
                       .help = "the highlight unit: specular, power, or a rival of them",
                       .kind = GLINT_OPTION_CHOICE,
                       .choice = {&options->device, options->names}};
    rows[count++] = (glint_option){.name = "gate",
                                   .given = &options->gate_given,
                                   .help = "how points outside the highlight are detected",
                                   .kind = GLINT_OPTION_CHOICE,
                                   .choice = {&options->gate, glint_gate_names}};
    for (int i = 0; i < options->own_count; i++)
        rows[count++] =
            (glint_option){.name = glint_highlight_parameter(options->own[i].circuit)->name,
                           .given = &options->own[i].given,
                           .help = options->own[i].help,
                           .kind = GLINT_OPTION_CHOICE,
                           .choice = {&options->own[i].value, options->own[i].names}};
    rows[count++] = (glint_option){.name = "pipeline",
                                   .given = &options->pipeline_given,
                                   .help = "register placement in the Verilog",
                                   .kind = GLINT_OPTION_CHOICE,
                                   .choice = {&options->pipeline, glint_pipeline_names}};
    rows[count++] = (glint_option){.name = "lanes",
                                   .placeholder = "auto|N",
                                   .given = &options->lanes_given,
                                   .help = "cosines per clock in the Verilog, 1 to 32",
                                   .kind = GLINT_OPTION_COUNT_OR,
                                   .count_or = {&options->lanes, 1, GLINT_LANES_MAX, "auto", 0}};
    return count;
}

static int refuse(const char *command, const char *option, const char *owner, const char *device)
{
    return glint_complain(command, GLINT_EXIT_TROUBLE, "--%s is of --device %s, not of %s", option,
                          owner, device);
}

int glint_device_options_settle(const char *command, const glint_device_options *options,
                                glint_backend_config *config)
{
    const glint_circuit *device = options->circuit[options->device];
    if (options->gate_given && device != &glint_circuit_specular)
        return refuse(command, "gate", glint_circuit_specular.name, device->name);
    config->device = device;
    config->variant = 0;
    for (int i = 0; i < options->own_count; i++) {
        const glint_own_option *own = &options->own[i];
        if (own->circuit == device)
            config->variant = own->value;
        else if (own->given)
            return refuse(command, glint_highlight_parameter(own->circuit)->name,
                          own->circuit->name, device->name);
    }
    config->gate = (glint_gate)options->gate;
    config->pipeline = (glint_pipeline)options->pipeline;
    config->lanes = (int)options->lanes;
    return GLINT_OPTIONS_RUN;
}

const char *glint_device_options_needless(const glint_device_options *options)
{
    return options->gate_given       ? "gate"
           : options->pipeline_given ? "pipeline"
           : options->lanes_given    ? "lanes"
                                     : NULL;
}
