/* Schlick's unit by division, described. */
#include "circuit/unit.h"
#include "glint_describe.h"
#include "glint_rivals.h"

static const glint_parameter parameters[] = {GLINT_HIGHLIGHT_PIPELINE, GLINT_HIGHLIGHT_LANES};

static const glint_unit_heading lane_headings[] = {
    {"Register 1: cos", {1}}, {"Blocks 7, 8: denominator", {7, 8}}, {"Division", {10}}};
static const glint_unit_circuit own = {
    .unit = &glint_unit_schlick,
    .headings = lane_headings,
    .heading_count = sizeof lane_headings / sizeof lane_headings[0],
};
static const glint_heading headings[] = {GLINT_UNIT_HEADINGS(
    {.title = "Register 1: cos"}, {.title = "Blocks 7, 8: denominator"}, {.title = "Division"})};

GLINT_UNIT_DESCRIPTION(schlick, "Schlick's unit, by division", "schlick_device")
