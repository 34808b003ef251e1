/* The divider of figure 2.13 clock by clock, in its two forms: every register and every named
 * value.
 *
 * The twins of rtl/shift_divider.v and rtl/pipelined_divider.v. One call of a …_clock() is one
 * rising edge; afterwards every signal holds what the Verilog signal of the same name holds just
 * after it. en = 0 freezes everything; reset = 1 clears everything regardless of en. */
#ifndef GLINT_CMODEL_DIVIDER_DEVICE_H
#define GLINT_CMODEL_DIVIDER_DEVICE_H

#include "glint_divider.h"
#include "glint_signal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum glint_divider_form {
    GLINT_DIVIDER_SEQUENTIAL, /* figure 2.13: one bit of the reciprocal per clock */
    GLINT_DIVIDER_PIPELINED,  /* one division per clock, three components at once */
    GLINT_DIVIDER_FORM_COUNT
} glint_divider_form;

/* What the input pins carry at one rising edge. */
typedef struct glint_divider_inputs {
    uint8_t reset, en;
    uint8_t start; /* sequential: start; pipelined: in_valid */
    uint8_t k;
    int16_t difference[GLINT_DIVIDER_COMPONENTS]; /* sequential: only the first */
} glint_divider_inputs;

/* Widths that depend on the number of shifts n, in the lists below: n bits, n + 1 bits. */
#define GLINT_DIVIDER_WIDTH_N  (-1)
#define GLINT_DIVIDER_WIDTH_N1 (-2)
/* Fraction bits of a code of the accumulator: n. */
#define GLINT_DIVIDER_FRAC_N (-1)

/* The sequential form: X(name, kind, int bits, frac bits, signed, meaning), as the data flows. */
#define GLINT_DIVIDER_SEQUENTIAL_SIGNALS(X)                                                        \
    X(busy, REGISTER, 1, 0, 0, "a division is in progress")                                        \
    X(rom_bits, BLOCK, GLINT_DIVIDER_WIDTH_N1, 0, 0, "table: bits i0 ... in of 1/k")               \
    X(rom_miss, BLOCK, 1, 0, 0, "k is 0 or past the end of the table")                             \
    X(bits_rg, REGISTER, GLINT_DIVIDER_WIDTH_N, 0, 0, "remaining bits ij")                         \
    X(left, REGISTER, GLINT_DIVIDER_LEFT_BITS, 0, 0, "how many")                                   \
    X(shift_rg, REGISTER, GLINT_DIVIDER_DIFFERENCE_BITS, GLINT_DIVIDER_FRAC_N, 1,                  \
      "shift register: the difference, halved each clock")                                         \
    X(shifted, BLOCK, GLINT_DIVIDER_DIFFERENCE_BITS, GLINT_DIVIDER_FRAC_N, 1, "shifted by one")    \
    X(term, BLOCK, GLINT_DIVIDER_DIFFERENCE_BITS, GLINT_DIVIDER_FRAC_N, 1,                         \
      "addend: the shift register, or 0 when ij = 0")                                              \
    X(sum, BLOCK, GLINT_DIVIDER_DIFFERENCE_BITS, GLINT_DIVIDER_FRAC_N, 1, "accumulating adder")    \
    X(acc_rg, REGISTER, GLINT_DIVIDER_DIFFERENCE_BITS, GLINT_DIVIDER_FRAC_N, 1,                    \
      "accumulating register")                                                                     \
    X(done, OUTPUT, 1, 0, 0, "a new quotient is out")                                              \
    X(out_of_table, OUTPUT, 1, 0, 0, "k was 0 or past the end of the table")                       \
    X(quotient, OUTPUT, GLINT_DIVIDER_DIFFERENCE_BITS, GLINT_DIVIDER_FRAC_N, 1, "the quotient")

/* The pipelined form: signals of the whole circuit, then those of each stage 1…n. */
#define GLINT_DIVIDER_PIPELINED_SIGNALS(X)                                                         \
    X(s0_valid, REGISTER, 1, 0, 0, "the input registers hold a division")                          \
    X(s0_k, REGISTER, GLINT_DIVIDER_K_BITS, 0, 0, "k")                                             \
    X(s0_d_r, REGISTER, GLINT_DIVIDER_DIFFERENCE_BITS, 0, 1, "difference of R")                    \
    X(s0_d_g, REGISTER, GLINT_DIVIDER_DIFFERENCE_BITS, 0, 1, "difference of G")                    \
    X(s0_d_b, REGISTER, GLINT_DIVIDER_DIFFERENCE_BITS, 0, 1, "difference of B")                    \
    X(rom_bits, BLOCK, GLINT_DIVIDER_WIDTH_N1, 0, 0, "table: bits i0 ... in of 1/k")               \
    X(rom_miss, BLOCK, 1, 0, 0, "k is 0 or past the end of the table")                             \
    X(out_valid, OUTPUT, 1, 0, 0, "the quotients are valid")                                       \
    X(out_of_table, OUTPUT, 1, 0, 0, "k was 0 or past the end of the table")                       \
    X(quotient_r, OUTPUT, GLINT_DIVIDER_DIFFERENCE_BITS, GLINT_DIVIDER_FRAC_N, 1, "of R")          \
    X(quotient_g, OUTPUT, GLINT_DIVIDER_DIFFERENCE_BITS, GLINT_DIVIDER_FRAC_N, 1, "of G")          \
    X(quotient_b, OUTPUT, GLINT_DIVIDER_DIFFERENCE_BITS, GLINT_DIVIDER_FRAC_N, 1, "of B")

#define GLINT_DIVIDER_STAGE_SIGNALS(X)                                                             \
    X(valid, STAGE, 1, 0, 0, "the stage holds a division")                                         \
    X(miss, STAGE, 1, 0, 0, "its k is 0 or past the end of the table")                             \
    X(bits, STAGE, GLINT_DIVIDER_WIDTH_N1, 0, 0, "its bits i0 ... in")                             \
    X(d_r, STAGE, GLINT_DIVIDER_DIFFERENCE_BITS, 0, 1, "its difference of R")                      \
    X(d_g, STAGE, GLINT_DIVIDER_DIFFERENCE_BITS, 0, 1, "its difference of G")                      \
    X(d_b, STAGE, GLINT_DIVIDER_DIFFERENCE_BITS, 0, 1, "its difference of B")                      \
    X(acc_r, STAGE, GLINT_DIVIDER_DIFFERENCE_BITS, GLINT_DIVIDER_FRAC_N, 1, "running sum of R")    \
    X(acc_g, STAGE, GLINT_DIVIDER_DIFFERENCE_BITS, GLINT_DIVIDER_FRAC_N, 1, "running sum of G")    \
    X(acc_b, STAGE, GLINT_DIVIDER_DIFFERENCE_BITS, GLINT_DIVIDER_FRAC_N, 1, "running sum of B")

/* The value of every signal, as a number. */
#define GLINT_DIVIDER_FIELD(name, kind, int_bits, frac_bits, is_signed, meaning) int64_t name;
typedef struct glint_divider_sequential_signals {
    GLINT_DIVIDER_SEQUENTIAL_SIGNALS(GLINT_DIVIDER_FIELD)
} glint_divider_sequential_signals;

typedef struct glint_divider_stage_signals {
    GLINT_DIVIDER_STAGE_SIGNALS(GLINT_DIVIDER_FIELD)
} glint_divider_stage_signals;

typedef struct glint_divider_pipelined_signals {
    GLINT_DIVIDER_PIPELINED_SIGNALS(GLINT_DIVIDER_FIELD)
    glint_divider_stage_signals stage[GLINT_DIVIDER_SHIFTS_MAX + 1]; /* 1…n */
} glint_divider_pipelined_signals;
#undef GLINT_DIVIDER_FIELD

typedef struct glint_divider_device glint_divider_device;

/* Creates a divider in reset state. GLINT_BAD_ARGUMENT for a form or shifts out of range. */
glint_status glint_divider_device_create(glint_divider_form form, int shifts,
                                         glint_divider_device **device);
void glint_divider_device_destroy(glint_divider_device *device); /* NULL is allowed */

int glint_divider_device_shifts(const glint_divider_device *device);

/* One rising edge of the clock. */
void glint_divider_device_clock(glint_divider_device *device, const glint_divider_inputs *inputs);

/* The signals as the last edge left them; NULL for the other form. */
const glint_divider_sequential_signals *
glint_divider_device_sequential(const glint_divider_device *device);
const glint_divider_pipelined_signals *
glint_divider_device_pipelined(const glint_divider_device *device);

/* Clocks from the edge that accepts a division to the edge after which its quotient is out, both
 * counted; the same for both forms. */
int glint_divider_latency(int shifts);

/* The signals by index 0…count−1: those of the whole circuit, then stage by stage (lane = 1…n). */
int glint_divider_signal_count(glint_divider_form form, int shifts);
glint_signal_info glint_divider_signal_info(glint_divider_form form, int shifts, int index);

/* The bits of signal `index`, as many as its width, the rest 0. */
uint64_t glint_divider_signal_bits(const glint_divider_device *device, int index);

/* "sequential", "pipelined". NULL when out of range. */
const char *glint_divider_form_name(glint_divider_form form);

#ifdef __cplusplus
}
#endif

#endif
