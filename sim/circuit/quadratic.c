/* The quadratic's unit, described. */
#include "circuit/unit.h"
#include "glint_rivals.h"

static const glint_parameter parameters[] = {
    GLINT_HIGHLIGHT_W_DROP(0, 6, 0, GLINT_HIGHLIGHT_COMMON_DROP(GLINT_COS_FRAC_BITS)),
    GLINT_HIGHLIGHT_PIPELINE,
    GLINT_HIGHLIGHT_FEW_LANES,
};

#define HEADINGS(X)                                                                                \
    X("Register 1: cos", 1)                                                                        \
    X("ROM 33: a", 33)                                                                             \
    X("Blocks 7, 8, 11: line", 7, 8, 11)

GLINT_UNIT_DESCRIPTION(quadratic, "The thesis's quadratic", HEADINGS)
