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

/* The width of W, U1.this, at which units are compared besides their own: the least of those. */
#define GLINT_HIGHLIGHT_COMMON_W_FRAC_BITS 12

/* Of least…most places; listed are those that follow. */
#define GLINT_HIGHLIGHT_W_DROP(...)                                                                \
    {                                                                                              \
        GLINT_HIGHLIGHT_W_DROP_MEMBERS(__VA_ARGS__), .goes_unsaid = 1                              \
    }
#define GLINT_HIGHLIGHT_W_DROP_MEMBERS(least, most, ...)                                           \
    .name = GLINT_HIGHLIGHT_W_DROP_NAME, .verilog = "W_DROP",                                      \
    .meaning = "places of W rounded off", .min = (least), .max = (most), GLINT_LISTED(__VA_ARGS__)
#define GLINT_HIGHLIGHT_W_DROP_NAME "w-drop"

/* What takes a W of U1.own to the common width. */
#define GLINT_HIGHLIGHT_COMMON_DROP(own) ((own)-GLINT_HIGHLIGHT_COMMON_W_FRAC_BITS)

extern const char *const glint_highlight_pipelines[GLINT_PIPELINE_COUNT];

/* The pins of a unit with so many lanes: 0…count−1, in glint_specular_inputs. */
int glint_highlight_pin_count(int lanes);
glint_pin_info glint_highlight_pin(int lanes, int index);

#endif
