/* The power device, described. */
#include "circuit/unit.h"
#include "glint_describe.h"
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
    GLINT_HIGHLIGHT_PIPELINE,
    GLINT_HIGHLIGHT_LANES,
};

static const char *const variants[] = {"accuracy half", "accuracy quarter"};

static const glint_unit_heading lane_headings[] = {
    {"Register 1: x", {1}},         {"Multiplier 7: n x", {7}}, {"ROM 9: g(x)", {9}},
    {"Blocks 10, 11: v", {10, 11}}, {"ROM 33: 2^-f", {33}},
};
static const glint_unit_circuit own = {
    .unit = &glint_unit_power,
    .variants = variants,
    .headings = lane_headings,
    .heading_count = sizeof lane_headings / sizeof lane_headings[0],
};
static const glint_heading headings[] = {GLINT_UNIT_HEADINGS(
    {.title = "Register 1: x"}, {.title = "Multiplier 7: n x"}, {.title = "ROM 9: g(x)"},
    {.title = "Blocks 10, 11: v"}, {.title = "ROM 33: 2^-f"})};

GLINT_UNIT_DESCRIPTION(power, "Power device", "power_device")
