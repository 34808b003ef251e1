/* The power device clock by clock: every register and every named internal value.
 *
 * The twin of rtl/power_device.v, driven by the pins of the specular device and with its handshake
 * (glint_specular_device.h): another result, a clock later. */
#ifndef GLINT_CMODEL_POWER_DEVICE_H
#define GLINT_CMODEL_POWER_DEVICE_H

#include "glint_power.h"
#include "glint_signal.h"
#include "glint_specular_device.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The one list of the device's signals: X(name, block, kind, int bits, frac bits, signed, meaning).
 * A width of GLINT_LANES_WIDTH is one bit a lane; fraction bits of GLINT_POWER_TABLE_FRAC are those
 * of the tables' address, of GLINT_POWER_W_FRAC those of W. */
#define GLINT_POWER_TABLE_FRAC (-1)
#define GLINT_POWER_W_FRAC     (-2)

/* Signals shared by all lanes, in the order the data flows. */
#define GLINT_POWER_SHARED_SIGNALS(X)                                                              \
    X(reg2, 2, REGISTER, GLINT_N_BITS, 0, 0, "exponent n")                                         \
    X(reg3, 3, REGISTER, GLINT_COLOR_BITS, 0, 0, "R times Ks")                                     \
    X(reg4, 4, REGISTER, GLINT_COLOR_BITS, 0, 0, "G times Ks")                                     \
    X(reg5, 5, REGISTER, GLINT_COLOR_BITS, 0, 0, "B times Ks")                                     \
    X(s1_valid, 0, STAGE, GLINT_LANES_WIDTH, 0, 0, "stage 1 holds a point")                        \
    X(s2_reg3, 3, STAGE, GLINT_COLOR_BITS, 0, 0, "R, stage 2")                                     \
    X(s2_reg4, 4, STAGE, GLINT_COLOR_BITS, 0, 0, "G, stage 2")                                     \
    X(s2_reg5, 5, STAGE, GLINT_COLOR_BITS, 0, 0, "B, stage 2")                                     \
    X(s2_valid, 0, STAGE, GLINT_LANES_WIDTH, 0, 0, "stage 2 holds a point")                        \
    X(s3_reg3, 3, STAGE, GLINT_COLOR_BITS, 0, 0, "R, stage 3")                                     \
    X(s3_reg4, 4, STAGE, GLINT_COLOR_BITS, 0, 0, "G, stage 3")                                     \
    X(s3_reg5, 5, STAGE, GLINT_COLOR_BITS, 0, 0, "B, stage 3")                                     \
    X(s3_valid, 0, STAGE, GLINT_LANES_WIDTH, 0, 0, "stage 3 holds a point")                        \
    X(s4_reg3, 3, STAGE, GLINT_COLOR_BITS, 0, 0, "R, stage 4")                                     \
    X(s4_reg4, 4, STAGE, GLINT_COLOR_BITS, 0, 0, "G, stage 4")                                     \
    X(s4_reg5, 5, STAGE, GLINT_COLOR_BITS, 0, 0, "B, stage 4")                                     \
    X(s4_valid, 0, STAGE, GLINT_LANES_WIDTH, 0, 0, "stage 4 holds a point")                        \
    X(out_valid, 0, OUTPUT, GLINT_LANES_WIDTH, 0, 0, "an output is valid")

/* Signals of one lane, in the order the data flows. */
#define GLINT_POWER_LANE_SIGNALS(X)                                                                \
    X(reg1, 1, REGISTER, 0, GLINT_POWER_X_BITS, 0, "x = 1 - cos gamma")                            \
    X(mul7, 7, BLOCK, GLINT_POWER_P_INT_BITS, GLINT_POWER_X_BITS, 0, "p = n x")                    \
    X(over7, 7, BLOCK, 1, 0, 0, "p is 16 or more")                                                 \
    X(rom9, 9, BLOCK, GLINT_POWER_L_INT_BITS, GLINT_POWER_TABLE_FRAC, 0, "g(x) = -log2(1 - x)/x")  \
    X(s2_mul7, 7, STAGE, GLINT_POWER_L_INT_BITS, GLINT_POWER_Q_FRAC_BITS, 0,                       \
      "q = the middle of p, stage 2")                                                              \
    X(s2_over7, 7, STAGE, 1, 0, 0, "p is 16 or more, stage 2")                                     \
    X(s2_rom9, 9, STAGE, GLINT_POWER_L_INT_BITS, GLINT_POWER_TABLE_FRAC, 0, "g, stage 2")          \
    X(mul10, 10, BLOCK, GLINT_POWER_V_INT_BITS, GLINT_POWER_TABLE_FRAC, 0, "v = q g")              \
    X(cmp11, 11, BLOCK, 1, 0, 0, "p and v are below 16")                                           \
    X(s3_mul10, 10, STAGE, GLINT_POWER_L_INT_BITS, GLINT_POWER_TABLE_FRAC, 0, "v, stage 3")        \
    X(s3_cmp11, 11, STAGE, 1, 0, 0, "p and v are below 16, stage 3")                               \
    X(rom33, 33, BLOCK, 1, GLINT_POWER_W_FRAC, 0, "2^-f, f the fraction of v")                     \
    X(keys12, 12, BLOCK, 1, GLINT_POWER_W_FRAC, 0, "W: the power, shifted, or zero")               \
    X(s4_keys12, 12, STAGE, 1, GLINT_POWER_W_FRAC, 0, "W, stage 4")                                \
    X(mul13, 13, BLOCK, GLINT_COLOR_BITS, 0, 0, "W R")                                             \
    X(mul14, 14, BLOCK, GLINT_COLOR_BITS, 0, 0, "W G")                                             \
    X(mul15, 15, BLOCK, GLINT_COLOR_BITS, 0, 0, "W B")                                             \
    X(out_w, 12, OUTPUT, 1, GLINT_POWER_W_FRAC, 0, "W that belongs to the outputs")                \
    X(out_r, 13, OUTPUT, GLINT_COLOR_BITS, 0, 0, "R of the highlight")                             \
    X(out_g, 14, OUTPUT, GLINT_COLOR_BITS, 0, 0, "G of the highlight")                             \
    X(out_b, 15, OUTPUT, GLINT_COLOR_BITS, 0, 0, "B of the highlight")

/* The value of every signal. */
#define GLINT_SIGNAL_FIELD(name, block, kind, int_bits, frac_bits, is_signed, meaning) int64_t name;
typedef struct glint_power_lane {
    GLINT_POWER_LANE_SIGNALS(GLINT_SIGNAL_FIELD)
} glint_power_lane;

typedef struct glint_power_signals {
    GLINT_POWER_SHARED_SIGNALS(GLINT_SIGNAL_FIELD)
    glint_power_lane lane[GLINT_LANES_MAX];
} glint_power_signals;
#undef GLINT_SIGNAL_FIELD

typedef struct glint_power_config {
    glint_power_accuracy accuracy;
    glint_pipeline pipeline;
    int lanes; /* 1…GLINT_LANES_MAX */
} glint_power_config;

typedef struct glint_power_device glint_power_device;

/* Creates a device in reset state. GLINT_BAD_ARGUMENT for a setting out of range. */
glint_status glint_power_device_create(const glint_power_config *config,
                                       glint_power_device **device);
void glint_power_device_destroy(glint_power_device *device); /* NULL is allowed */

/* One rising edge of the clock. Inputs wider than their pins are cut to the pins' width. */
void glint_power_device_clock(glint_power_device *device, const glint_specular_inputs *inputs);

/* The signals as the last edge left them; valid until the device is destroyed. */
const glint_power_signals *glint_power_device_signals(const glint_power_device *device);

/* GLINT_POWER_LATENCY_COMBINATIONAL or GLINT_POWER_LATENCY_PIPELINED. */
int glint_power_latency(glint_pipeline pipeline);

/* Number of signals of a device with these settings: the shared ones first, then lane after lane.
 */
int glint_power_signal_count(const glint_power_config *config);

/* Describes signal `index` (0…count−1) under these settings. */
glint_signal_info glint_power_signal_info(const glint_power_config *config, int index);

#ifdef __cplusplus
}
#endif

#endif
