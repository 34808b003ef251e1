/* Lyon's unit, described. */
#include "circuit/unit.h"
#include "glint_rivals.h"

static const char *const ks[GLINT_LYON_VARIANTS] = {"4", "8"};

static const glint_parameter parameters[] = {
    {.name = "k",
     .verilog = "EIGHT",
     .meaning = "power that the line is raised to",
     .choices = ks,
     .max = GLINT_LYON_VARIANTS - 1},
    GLINT_HIGHLIGHT_W_DROP(0, 4, 0, GLINT_HIGHLIGHT_COMMON_DROP(GLINT_LYON_FRAC_BITS)),
    GLINT_HIGHLIGHT_PIPELINE,
    GLINT_HIGHLIGHT_FEW_LANES,
};

#define HEADINGS(X)                                                                                \
    X("Register 1: x", 1)                                                                          \
    X("Blocks 7, 8, 11: t", 7, 8, 11)                                                              \
    X("Multiplier 10: t^k", 10)

GLINT_UNIT_DESCRIPTION(lyon, "Lyon's unit", HEADINGS)
