/* The power unit by logarithm, described. */
#include "circuit/unit.h"
#include "glint_rivals.h"

static const glint_parameter parameters[] = {
    GLINT_HIGHLIGHT_W_DROP(0, 4, 0),
    GLINT_HIGHLIGHT_PIPELINE,
    GLINT_HIGHLIGHT_FEW_LANES,
};

#define HEADINGS(X)                                                                                \
    X("Register 1: cos", 1)                                                                        \
    X("Normalised", 6)                                                                             \
    X("ROM 9: lines of log2", 9)                                                                   \
    X("Blocks 7, 8: L", 7, 8)                                                                      \
    X("Blocks 10, 11: n L", 10, 11)                                                                \
    X("ROM 33: 2^-f", 33)

GLINT_UNIT_DESCRIPTION(log2, "Power unit by logarithm", HEADINGS)
