/* The quadratic's unit, described. */
#include "circuit/unit.h"
#include "glint_describe.h"
#include "glint_rivals.h"

static const glint_parameter parameters[] = {GLINT_HIGHLIGHT_PIPELINE, GLINT_HIGHLIGHT_LANES};

static const glint_unit_heading lane_headings[] = {
    {"Register 1: cos", {1}}, {"ROM 33: a", {33}}, {"Blocks 7, 8, 11: line", {7, 8, 11}}};
static const glint_unit_circuit own = {
    .unit = &glint_unit_quadratic,
    .headings = lane_headings,
    .heading_count = sizeof lane_headings / sizeof lane_headings[0],
};
static const glint_heading headings[] = {GLINT_UNIT_HEADINGS(
    {.title = "Register 1: cos"}, {.title = "ROM 33: a"}, {.title = "Blocks 7, 8, 11: line"})};

GLINT_UNIT_DESCRIPTION(quadratic, "The thesis's quadratic", "quadratic_device")
