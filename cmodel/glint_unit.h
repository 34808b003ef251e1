/* Highlight units clock by clock: any circuit that takes cosines and a material by the pins of the
 * specular device (glint_specular_inputs) and gives W and W times the colour.
 *
 * What all of them share is here and in rtl/material_path.v and rtl/color_stage.v: registers 2 to
 * 5, the valid bits and the material that travel beside the lanes, multipliers 13 to 15 and the
 * outputs. What is a unit's own is how a lane makes W of its cosine and n: a table, glint_unit.
 *
 * A unit has stages 1…S: registers 1 to 5 stand in front of stage 1, a row of registers in front of
 * each other stage, and the output registers behind stage S, in which the colours are multiplied.
 * With the combinational pipeline all rows but the first are wires. */
#ifndef GLINT_CMODEL_UNIT_H
#define GLINT_CMODEL_UNIT_H

#include <stddef.h>
#include <stdint.h>

#include "glint_signal.h"
#include "glint_specular_device.h"

#ifdef __cplusplus
extern "C" {
#endif

#define GLINT_UNIT_STAGES_MAX 24

/* What travels beside the lanes, as it is in one stage. */
typedef struct glint_unit_stage {
    int64_t valid, reg2, reg3, reg4, reg5;
} glint_unit_stage;

/* Shared by all lanes. stage[1] holds registers 2 to 5 themselves. */
typedef struct glint_unit_path {
    glint_unit_stage stage[GLINT_UNIT_STAGES_MAX + 1];
    int64_t out_valid;
} glint_unit_path;

/* The end of every lane: the first member of a unit's lane. */
typedef struct glint_unit_end {
    int64_t keys12;   /* W, of stage S − 1 */
    int64_t s_keys12; /* the same, rounded, stage S */
    int64_t mul13, mul14, mul15;
    int64_t out_w, out_r, out_g, out_b;
} glint_unit_end;

/* One unit. `variant` is the value of the one parameter of its own, 0…; 0 where it has none. */
typedef struct glint_unit {
    int variants;
    int (*stages)(int variant);      /* S, 2…GLINT_UNIT_STAGES_MAX */
    int (*n_stages)(int variant);    /* the last stage that needs n */
    int (*w_frac_bits)(int variant); /* W is U1.this, unless places of it are rounded off */
    size_t lane_size;                /* of its lane, which begins with a glint_unit_end */

    /* The registers in front of stage 1 take a code of U1.18, 0…GLINT_COS_CODE_MAX. */
    void (*load)(int variant, void *lane, uint32_t cos_code);
    /* The registers in front of stage 2…S−1 take what stage − 1 has; S has s_keys12 alone. */
    void (*pass)(int variant, int stage, void *lane);
    /* What stage 1…S−1 computes of its registers and n; S − 1 computes keys12. */
    void (*settle)(int variant, int stage, uint32_t n, void *lane);

    /* W of count codes with one n, through all stages: load(), pass(), settle() at speed. */
    void (*ws)(int variant, uint32_t n, const uint32_t *cos_code, size_t count, uint32_t *w_code);

    /* Signals of its lane but for those of glint_unit_end, as the data flows. */
    int (*row_count)(int variant);
    glint_signal_info (*row)(int variant, int index);

    /* What it computes without rounding, 0…1: its own formula. */
    double (*real)(int variant, uint32_t n, uint32_t cos_code);

    /* The one n that it is made for, whatever its pins say. NULL: that of its pins. */
    uint32_t (*fixed_n)(int variant);
} glint_unit;

typedef struct glint_unit_config {
    const glint_unit *unit;
    int variant;
    glint_pipeline pipeline;
    int lanes; /* 1…GLINT_LANES_MAX */
    int w_drop; /* places of W that are rounded off, half up, in front of stage S; 0…, while W keeps
                 * GLINT_UNIT_W_FRAC_MIN */
} glint_unit_config;

#define GLINT_UNIT_W_FRAC_MIN GLINT_COLOR_BITS

/* W is U1.this at the outputs. */
int glint_unit_w_frac_bits(const glint_unit_config *config);

typedef struct glint_unit_device glint_unit_device;

/* Creates a device in reset state. GLINT_BAD_ARGUMENT for a setting out of range. */
glint_status glint_unit_device_create(const glint_unit_config *config, glint_unit_device **device);
void glint_unit_device_destroy(glint_unit_device *device); /* NULL is allowed */

/* One rising edge of the clock. Inputs wider than their pins are cut to the pins' width. */
void glint_unit_device_clock(glint_unit_device *device, const glint_specular_inputs *inputs);

/* What signal.offset counts in: a glint_unit_path, then the lanes. */
const void *glint_unit_device_signals(const glint_unit_device *device);

/* Clocks from the edge that takes a cosine to its result, both counted: S + 1, combinational 1. */
int glint_unit_latency(const glint_unit_config *config);

/* Signals 0…count−1: the shared ones first, then lane after lane. */
int glint_unit_signal_count(const glint_unit_config *config);
glint_signal_info glint_unit_signal_info(const glint_unit_config *config, int index);

/* One point through a lane, all stages: *w is its W. lane: of unit->lane_size bytes; may be NULL.
 * GLINT_BAD_ARGUMENT when n or the code is out of range. */
glint_status glint_unit_eval(const glint_unit *unit, int variant, uint32_t n, uint32_t cos_code,
                             void *lane, uint32_t *w);

/* Computes count points with one material, bit-equal to glint_unit_eval() with the rounding of W
 * and multipliers 13 to 15 behind it; pipeline and lanes of config do not matter. cos_code: count
 * codes U1.18, each 0…GLINT_COS_CODE_MAX; w_code (may be NULL), r, g, b: count results each. The
 * arrays may not overlap. GLINT_BAD_ARGUMENT when the variant, w_drop or material->n is out of
 * range (codes are not checked). */
glint_status glint_unit_batch(const glint_unit_config *config, const glint_material *material,
                              const uint32_t *cos_code, size_t count, uint32_t *w_code, uint8_t *r,
                              uint8_t *g, uint8_t *b);

/* cos γ of a code, 0…1: what every unit's formula begins with. */
double glint_unit_cosine(uint32_t cos_code);

#ifdef __cplusplus
}
#endif

#endif
