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

#define ROW(called, from) GLINT_UNIT_ROW_OF(&glint_unit_power, called, from)

/* In the places of figure 3.1. */
GLINT_BLOCK_TABLE(block, GLINT_BLOCK("reg2", REGISTER, "n", "n", "n_we"),
                  GLINT_BLOCK("reg1", REGISTER, "x = 1 \u2212 cos \u03b3", "cos", "in_valid"),
                  GLINT_BLOCK("reg3", REGISTER, "R", "r", "rgb_we"),
                  GLINT_BLOCK("reg4", REGISTER, "G", "g", "rgb_we"),
                  GLINT_BLOCK("reg5", REGISTER, "B", "b", "rgb_we"),
                  GLINT_BLOCK("s1_valid", REGISTER, NULL, "in_valid", NULL),
                  GLINT_BLOCK("mul7", MULTIPLIER, NULL, "reg2 reg1", NULL),
                  GLINT_BLOCK("over7", COMPARATOR, "\u2265 16", "mul7", NULL),
                  GLINT_BLOCK("rom9", ROM, "g(x)", "reg1", NULL), ROW("s2_mul7", "mul7"),
                  ROW("s2_over7", "over7"), ROW("s2_rom9", "rom9"),
                  GLINT_BLOCK("mul10", MULTIPLIER, NULL, "s2_mul7 s2_rom9", NULL),
                  GLINT_BLOCK("cmp11", COMPARATOR, "< 16", "s2_over7 mul10", NULL),
                  ROW("s3_mul10", "mul10"), ROW("s3_cmp11", "cmp11"),
                  GLINT_BLOCK("rom33", ROM, "2\u207b\u1da0", "s3_mul10", NULL),
                  GLINT_BLOCK("keys12", KEYS, NULL, "s3_cmp11 rom33 s3_mul10", NULL),
                  ROW("s2_reg3", "reg3"), ROW("s2_reg4", "reg4"), ROW("s2_reg5", "reg5"),
                  ROW("s2_valid", "s1_valid"), ROW("s3_reg3", "s2_reg3"), ROW("s3_reg4", "s2_reg4"),
                  ROW("s3_reg5", "s2_reg5"), ROW("s3_valid", "s2_valid"),
                  ROW("s4_keys12", "keys12"), ROW("s4_reg3", "s3_reg3"), ROW("s4_reg4", "s3_reg4"),
                  ROW("s4_reg5", "s3_reg5"), ROW("s4_valid", "s3_valid"),
                  GLINT_BLOCK("mul13", MULTIPLIER, NULL, "s4_keys12 s4_reg3", NULL),
                  GLINT_BLOCK("mul14", MULTIPLIER, NULL, "s4_keys12 s4_reg4", NULL),
                  GLINT_BLOCK("mul15", MULTIPLIER, NULL, "s4_keys12 s4_reg5", NULL),
                  ROW("out_w", "s4_keys12"), ROW("out_r", "mul13"), ROW("out_g", "mul14"),
                  ROW("out_b", "mul15"), ROW("out_valid", "s4_valid"))

GLINT_UNIT_DESCRIPTION_DRAWN(power, "Power device", HEADINGS, block)
