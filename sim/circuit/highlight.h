/* What the descriptions of highlight units have in common: the pins of the specular device
 * (glint_specular_inputs), the pipeline and lanes as parameters, and random pins. */
#ifndef GLINT_SIM_CIRCUIT_HIGHLIGHT_H
#define GLINT_SIM_CIRCUIT_HIGHLIGHT_H

#include "glint_describe.h"
#include "glint_specular_device.h"

/* Initialisers of parameters: they stand in the description's own table. */
#define GLINT_HIGHLIGHT_PIPELINE                                                                   \
    {                                                                                              \
        .name = "pipeline", .verilog = "PIPELINED",                                                \
        .meaning = "registers or wires between the stages", .choices = glint_highlight_pipelines,  \
        .max = GLINT_PIPELINE_COUNT - 1, .standard = GLINT_PIPELINE_PIPELINED                      \
    }
#define GLINT_HIGHLIGHT_LANES     GLINT_HIGHLIGHT_LANES_OF(1, 2, 4, 8, 16)
#define GLINT_HIGHLIGHT_FEW_LANES GLINT_HIGHLIGHT_LANES_OF(1, 4) /* of a unit to compare with */
#define GLINT_HIGHLIGHT_LANES_OF(...)                                                              \
    {                                                                                              \
        .name = "lanes", .verilog = "LANES", .meaning = "cosines per clock", .min = 1,             \
        .max = GLINT_LANES_MAX, .standard = 1, GLINT_LISTED(__VA_ARGS__)                           \
    }

extern const char *const glint_highlight_pipelines[GLINT_PIPELINE_COUNT];

/* The pins of a unit with so many lanes: 0…count−1, in glint_specular_inputs. */
int glint_highlight_pin_count(int lanes);
glint_pin_info glint_highlight_pin(int lanes, int index);

#endif
