/* Schlick's unit by a reciprocal, described. */
#include "circuit/unit.h"
#include "glint_rivals.h"

static const glint_parameter parameters[] = {
    GLINT_HIGHLIGHT_W_DROP(0, 4, 0),
    GLINT_HIGHLIGHT_PIPELINE,
    GLINT_HIGHLIGHT_FEW_LANES,
};

#define HEADINGS(X)                                                                                \
    X("Register 1: cos", 1)                                                                        \
    X("Blocks 7, 8: denominator", 7, 8)                                                            \
    X("Normalised", 9)                                                                             \
    X("ROM 33: 1/m", 33)                                                                           \
    X("Newton's step", 10)

GLINT_UNIT_DESCRIPTION(newton, "Schlick's unit, by Newton's step", HEADINGS)
