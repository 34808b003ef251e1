/* The pins and parameters that every highlight unit has. */
#include "circuit/highlight.h"

const char *const glint_highlight_pipelines[GLINT_PIPELINE_COUNT] = {"combinational", "pipelined"};

#define PIN(pin, role, bits, meaning)                                                              \
    GLINT_PIN(glint_specular_inputs, pin, role, bits, 0, 0, meaning)

static const glint_pin_info shared_pins[] = {
    PIN(reset, RESET, 1, "clears every register"),
    PIN(en, ENABLE, 1, "0 freezes the device"),
    PIN(n_we, STROBE, 1, "writes n"),
    PIN(n, DATA, GLINT_N_BITS, "exponent"),
    PIN(rgb_we, STROBE, 1, "writes r, g, b"),
    PIN(r, DATA, GLINT_COLOR_BITS, "R times Ks"),
    PIN(g, DATA, GLINT_COLOR_BITS, "G times Ks"),
    PIN(b, DATA, GLINT_COLOR_BITS, "B times Ks"),
    PIN(in_valid, VALID, GLINT_LANES_WIDTH, "the lane's cosine is valid"),
};
enum { SHARED_PINS = sizeof shared_pins / sizeof shared_pins[0] };

int glint_highlight_pin_count(int lanes)
{
    return SHARED_PINS + lanes;
}

glint_pin_info glint_highlight_pin(int lanes, int index)
{
    const int lane = index - SHARED_PINS;
    if (lane >= 0)
        return (glint_pin_info){.name = "cos",
                                .role = GLINT_PIN_DATA,
                                .int_bits = GLINT_COS_BITS - GLINT_COS_FRAC_BITS,
                                .frac_bits = GLINT_COS_FRAC_BITS,
                                .lane = lane,
                                .offset = offsetof(glint_specular_inputs, cos) +
                                          (size_t)lane * sizeof(uint32_t),
                                .size = sizeof(uint32_t),
                                .meaning = "cos gamma, a code"};
    glint_pin_info info = shared_pins[index];
    if (info.int_bits == GLINT_LANES_WIDTH)
        info.int_bits = lanes;
    return info;
}
