/* The specular-colour device clock by clock: every register and every named internal value.
 *
 * The twin of rtl/specular_device.v. One call of glint_specular_device_clock() is one rising edge;
 * afterwards every signal holds what the Verilog signal of the same name holds just after that
 * edge.
 *
 * On each enabled edge, n and (R, G, B) are loaded if their strobe is 1, and each lane whose
 * in_valid bit is 1 accepts its cosine; a material written together with a cosine applies to that
 * cosine and to later ones. Results leave in order, `latency` clocks later, in out_w, out_r, out_g,
 * out_b, marked in out_valid. en = 0 freezes everything; reset = 1 clears everything regardless of
 * en. */
#ifndef GLINT_CMODEL_SPECULAR_DEVICE_H
#define GLINT_CMODEL_SPECULAR_DEVICE_H

#include "glint_signal.h"
#include "glint_specular.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The list of the device's signals: X(name, block, kind, int bits, frac bits, signed, meaning). int
 * bits include the sign. A width of GLINT_LANES_WIDTH means one bit per lane; GLINT_MUL10_WIDTH is
 * 1 integer bit, or GLINT_W_DRAWN_INT_BITS with gate drawn. */
#define GLINT_LANES_WIDTH 0
#define GLINT_MUL10_WIDTH (-1)

/* Signals shared by all lanes, in the order the data flows. */
#define GLINT_SPECULAR_SHARED_SIGNALS(X)                                                           \
    X(reg2, 2, REGISTER, GLINT_N_BITS, 0, 0, "exponent n")                                         \
    X(reg3, 3, REGISTER, GLINT_COLOR_BITS, 0, 0, "R times Ks")                                     \
    X(reg4, 4, REGISTER, GLINT_COLOR_BITS, 0, 0, "G times Ks")                                     \
    X(reg5, 5, REGISTER, GLINT_COLOR_BITS, 0, 0, "B times Ks")                                     \
    X(s1_valid, 0, STAGE, GLINT_LANES_WIDTH, 0, 0, "stage 1 holds a point")                        \
    X(rom33, 33, BLOCK, GLINT_SIGMA_INT_BITS, GLINT_SIGMA_FRAC_BITS, 0, "sigma = (n+1)/3")         \
    X(rom9, 9, BLOCK, 1, GLINT_COS_FRAC_BITS, 0, "limit for comparator 11")                        \
    X(s2_rom9, 9, STAGE, 1, GLINT_COS_FRAC_BITS, 0, "limit, stage 2")                              \
    X(s2_reg3, 3, STAGE, GLINT_COLOR_BITS, 0, 0, "R, stage 2")                                     \
    X(s2_reg4, 4, STAGE, GLINT_COLOR_BITS, 0, 0, "G, stage 2")                                     \
    X(s2_reg5, 5, STAGE, GLINT_COLOR_BITS, 0, 0, "B, stage 2")                                     \
    X(s2_valid, 0, STAGE, GLINT_LANES_WIDTH, 0, 0, "stage 2 holds a point")                        \
    X(s3_reg3, 3, STAGE, GLINT_COLOR_BITS, 0, 0, "R, stage 3")                                     \
    X(s3_reg4, 4, STAGE, GLINT_COLOR_BITS, 0, 0, "G, stage 3")                                     \
    X(s3_reg5, 5, STAGE, GLINT_COLOR_BITS, 0, 0, "B, stage 3")                                     \
    X(s3_valid, 0, STAGE, GLINT_LANES_WIDTH, 0, 0, "stage 3 holds a point")                        \
    X(out_valid, 0, OUTPUT, GLINT_LANES_WIDTH, 0, 0, "an output is valid")

/* Signals of one lane, in the order the data flows. */
#define GLINT_SPECULAR_LANE_SIGNALS(X)                                                             \
    X(reg1, 1, REGISTER, 1, GLINT_COS_FRAC_BITS, 0, "cos gamma, saturated to 1")                   \
    X(adder6, 6, BLOCK, 1, GLINT_COS_FRAC_BITS, 1, "cos gamma - 1")                                \
    X(mul7, 7, BLOCK, GLINT_T_INT_BITS, GLINT_T_FRAC_BITS, 1, "sigma (cos gamma - 1)")             \
    X(adder8, 8, BLOCK, GLINT_T_INT_BITS, GLINT_T_FRAC_BITS, 1, "t = sigma (cos gamma - 1) + 1")   \
    X(s2_adder8, 8, STAGE, GLINT_T_INT_BITS, GLINT_T_FRAC_BITS, 1, "t, stage 2")                   \
    X(cmp11, 11, BLOCK, 1, 0, 0, "the point is inside the highlight")                              \
    X(s2_cmp11, 11, STAGE, 1, 0, 0, "inside, stage 2")                                             \
    X(mul10, 10, BLOCK, GLINT_MUL10_WIDTH, GLINT_W_FRAC_BITS, 0, "t squared")                      \
    X(sat10, 10, BLOCK, 1, GLINT_W_FRAC_BITS, 0, "t squared, saturated to 1 (gate drawn)")         \
    X(keys12, 12, BLOCK, 1, GLINT_W_FRAC_BITS, 0, "W: the square, or zero")                        \
    X(s3_keys12, 12, STAGE, 1, GLINT_W_FRAC_BITS, 0, "W, stage 3")                                 \
    X(mul13, 13, BLOCK, GLINT_COLOR_BITS, 0, 0, "W R")                                             \
    X(mul14, 14, BLOCK, GLINT_COLOR_BITS, 0, 0, "W G")                                             \
    X(mul15, 15, BLOCK, GLINT_COLOR_BITS, 0, 0, "W B")                                             \
    X(out_w, 12, OUTPUT, 1, GLINT_W_FRAC_BITS, 0, "W that belongs to the outputs")                 \
    X(out_r, 13, OUTPUT, GLINT_COLOR_BITS, 0, 0, "R of the highlight")                             \
    X(out_g, 14, OUTPUT, GLINT_COLOR_BITS, 0, 0, "G of the highlight")                             \
    X(out_b, 15, OUTPUT, GLINT_COLOR_BITS, 0, 0, "B of the highlight")

/* The value of every signal, as a number (a signed signal may be negative). */
#define GLINT_SIGNAL_FIELD(name, block, kind, int_bits, frac_bits, is_signed, meaning) int64_t name;
typedef struct glint_specular_lane {
    GLINT_SPECULAR_LANE_SIGNALS(GLINT_SIGNAL_FIELD)
} glint_specular_lane;

typedef struct glint_specular_signals {
    GLINT_SPECULAR_SHARED_SIGNALS(GLINT_SIGNAL_FIELD)
    glint_specular_lane lane[GLINT_LANES_MAX];
} glint_specular_signals;
#undef GLINT_SIGNAL_FIELD

/* What the input pins carry at one rising edge. */
typedef struct glint_specular_inputs {
    uint8_t reset, en;
    uint8_t n_we;                  /* control input 18 */
    uint16_t n;                    /* information input 17 */
    uint8_t rgb_we;                /* strobe of registers 3, 4, 5 */
    uint8_t r, g, b;               /* already multiplied by Ks */
    uint32_t in_valid;             /* bit i: lane i takes cos[i] */
    uint32_t cos[GLINT_LANES_MAX]; /* information input 32, U1.18, one code per lane */
} glint_specular_inputs;

typedef struct glint_specular_config {
    glint_gate gate;
    glint_pipeline pipeline;
    int lanes; /* 1…GLINT_LANES_MAX */
} glint_specular_config;

typedef struct glint_specular_device glint_specular_device;

/* Creates a device in reset state. GLINT_BAD_ARGUMENT for a setting out of range. */
glint_status glint_specular_device_create(const glint_specular_config *config,
                                          glint_specular_device **device);

/* The same with the last w_drop places of W rounded off, half up, in front of stage 3, while
 * GLINT_COLOR_BITS are left: s3_keys12 and out_w have so many fraction bits less. */
glint_status glint_specular_device_create_narrow(const glint_specular_config *config, int w_drop,
                                                 glint_specular_device **device);
void glint_specular_device_destroy(glint_specular_device *device); /* NULL is allowed */

/* One rising edge of the clock. Inputs wider than their pins are truncated. */
void glint_specular_device_clock(glint_specular_device *device,
                                 const glint_specular_inputs *inputs);

/* The signals as the last edge left them; valid until the device is destroyed. */
const glint_specular_signals *glint_specular_device_signals(const glint_specular_device *device);

/* Clocks from the edge that accepts a cosine to the edge after which its result is out, both
 * counted: GLINT_LATENCY_COMBINATIONAL or GLINT_LATENCY_PIPELINED. */
int glint_specular_latency(glint_pipeline pipeline);

/* Number of signals of a device with these settings: the shared ones first, then lane by lane. */
int glint_specular_signal_count(const glint_specular_config *config);

/* Describes signal `index` (0…count−1) under these settings. */
glint_signal_info glint_specular_signal_info(const glint_specular_config *config, int index);

/* The bits of signal `index`, as many as its width, the rest 0. */
uint64_t glint_specular_signal_bits(const glint_specular_config *config,
                                    const glint_specular_signals *signals, int index);

/* "cosine", "sign", "drawn"; "combinational", "pipelined". NULL when out of range. */
const char *glint_gate_name(glint_gate gate);
const char *glint_pipeline_name(glint_pipeline pipeline);

#ifdef __cplusplus
}
#endif

#endif
