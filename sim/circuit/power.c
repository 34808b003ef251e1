/* The power device, described. */
#include "circuit/unit.h"
#include "glint_power.h"

static const char *const accuracies[] = {"half", "quarter"};
_Static_assert(sizeof accuracies / sizeof accuracies[0] == GLINT_POWER_ACCURACY_COUNT,
               "a name for each accuracy");

static const glint_parameter parameters[] = {
    {.name = "accuracy",
     .verilog = "ACCURACY",
     .meaning = "largest error of W, of an 8-bit step",
     .choices = accuracies,
     .max = GLINT_POWER_ACCURACY_COUNT - 1,
     .standard = GLINT_POWER_HALF},
    GLINT_HIGHLIGHT_W_DROP(
        0, 4, 0, GLINT_HIGHLIGHT_COMMON_DROP(GLINT_POWER_W_FRAC_BITS(GLINT_POWER_QUARTER))),
    GLINT_HIGHLIGHT_PIPELINE,
    GLINT_HIGHLIGHT_LANES,
};

#define HEADINGS(X)                                                                                \
    X("Register 1: x", 1)                                                                          \
    X("Multiplier 7: n x", 7)                                                                      \
    X("ROM 9: g(x)", 9)                                                                            \
    X("Blocks 10, 11: v", 10, 11)                                                                  \
    X("ROM 33: 2^-f", 33)

GLINT_UNIT_DESCRIPTION(power, "Power device", HEADINGS)
