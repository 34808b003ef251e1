/* Lyon's unit, described. */
#include "circuit/unit.h"
#include "glint_describe.h"
#include "glint_rivals.h"

static const char *const ks[GLINT_LYON_VARIANTS] = {"4", "8"};

static const glint_parameter parameters[] = {
    {.name = "k",
     .verilog = "EIGHT",
     .meaning = "power that the line is raised to",
     .choices = ks,
     .max = GLINT_LYON_VARIANTS - 1},
    GLINT_HIGHLIGHT_PIPELINE,
    GLINT_HIGHLIGHT_LANES,
};

static const char *const variants[] = {"k 4", "k 8"};

static const glint_unit_heading lane_headings[] = {
    {"Register 1: x", {1}}, {"Blocks 7, 8, 11: t", {7, 8, 11}}, {"Multiplier 10: t^k", {10}}};
static const glint_unit_circuit own = {
    .unit = &glint_unit_lyon,
    .variants = variants,
    .headings = lane_headings,
    .heading_count = sizeof lane_headings / sizeof lane_headings[0],
};
static const glint_heading headings[] = {GLINT_UNIT_HEADINGS(
    {.title = "Register 1: x"}, {.title = "Blocks 7, 8, 11: t"}, {.title = "Multiplier 10: t^k"})};

GLINT_UNIT_DESCRIPTION(lyon, "Lyon's unit", "lyon_device")
