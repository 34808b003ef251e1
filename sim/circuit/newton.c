/* Schlick's unit by a reciprocal, described. */
#include "circuit/unit.h"
#include "glint_describe.h"
#include "glint_rivals.h"

static const glint_parameter parameters[] = {GLINT_HIGHLIGHT_PIPELINE, GLINT_HIGHLIGHT_LANES};

static const glint_unit_heading lane_headings[] = {{"Register 1: cos", {1}},
                                                   {"Blocks 7, 8: denominator", {7, 8}},
                                                   {"Normalised", {9}},
                                                   {"ROM 33: 1/m", {33}},
                                                   {"Newton's step", {10}}};
static const glint_unit_circuit own = {
    .unit = &glint_unit_newton,
    .headings = lane_headings,
    .heading_count = sizeof lane_headings / sizeof lane_headings[0],
};
static const glint_heading headings[] = {GLINT_UNIT_HEADINGS(
    {.title = "Register 1: cos"}, {.title = "Blocks 7, 8: denominator"}, {.title = "Normalised"},
    {.title = "ROM 33: 1/m"}, {.title = "Newton's step"})};

GLINT_UNIT_DESCRIPTION(newton, "Schlick's unit, by Newton's step", "newton_device")
