/* The unit by a bipartite table, described. */
#include "circuit/unit.h"
#include "glint_rivals.h"

static const char *const exponents[GLINT_BIPARTITE_VARIANTS] = {"8", "16", "32"};
_Static_assert(GLINT_BIPARTITE_N(0) == 8 && GLINT_BIPARTITE_N(2) == 32, "the names above");

static const glint_parameter parameters[] = {
    {.name = "exponent",
     .verilog = "EXPONENT",
     .meaning = "n, whatever the pins say",
     .choices = exponents,
     .max = GLINT_BIPARTITE_VARIANTS - 1},
    GLINT_HIGHLIGHT_W_DROP(0, 4, 0),
    GLINT_HIGHLIGHT_PIPELINE,
    GLINT_HIGHLIGHT_FEW_LANES,
};

#define HEADINGS(X)                                                                                \
    X("Register 1: cos", 1)                                                                        \
    X("ROMs 9, 33", 9, 33, 11)                                                                     \
    X("Adder 8: the sum", 8)

GLINT_UNIT_DESCRIPTION(bipartite, "Bipartite table of a power", HEADINGS)
