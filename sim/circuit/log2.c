/* The power unit by logarithm, described. */
#include "circuit/unit.h"
#include "glint_describe.h"
#include "glint_rivals.h"

static const glint_parameter parameters[] = {GLINT_HIGHLIGHT_PIPELINE, GLINT_HIGHLIGHT_LANES};

static const glint_unit_heading lane_headings[] = {
    {"Register 1: cos", {1}},         {"Normalised", {6}},
    {"ROM 9: lines of log2", {9}},    {"Blocks 7, 8: L", {7, 8}},
    {"Blocks 10, 11: n L", {10, 11}}, {"ROM 33: 2^-f", {33}}};
static const glint_unit_circuit own = {
    .unit = &glint_unit_log2,
    .headings = lane_headings,
    .heading_count = sizeof lane_headings / sizeof lane_headings[0],
};
static const glint_heading headings[] = {GLINT_UNIT_HEADINGS(
    {.title = "Register 1: cos"}, {.title = "Normalised"}, {.title = "ROM 9: lines of log2"},
    {.title = "Blocks 7, 8: L"}, {.title = "Blocks 10, 11: n L"}, {.title = "ROM 33: 2^-f"})};

GLINT_UNIT_DESCRIPTION(log2, "Power unit by logarithm", "log2_device")
