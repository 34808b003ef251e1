/* Reads results: our own errors, Yosys's stat, OpenSTA's slack, nextpnr's report. */
#include "compare/result.h"

#include <stdio.h>
#include <string.h>

#define STA_PERIOD_NS 100.0 /* cells.tcl */
#define NAND2_UM2     24.0  /* of osu018's NAND2X1 */
#define UM2_PER_MM2   1e6

static double number(const json_t *json, const char *name)
{
    return json_number_value(json_object_get(json, name));
}

static bool copy(const json_t *json, const char *name, char *text, size_t size)
{
    const char *value = json_string_value(json_object_get(json, name));
    if (value == NULL || strlen(value) >= size)
        return false;
    memcpy(text, value, strlen(value) + 1);
    return true;
}

static glint_status read_errors(const json_t *raw, glint_compare_result *result, glint_error *err)
{
    result->power_steps = number(json_object_get(raw, "power"), "steps");
    result->own_steps = number(json_object_get(raw, "own"), "steps");
    result->nmse = number(raw, "nmse");
    result->nmse_n = number(raw, "nmse_n");
    result->points = number(raw, "points");
    return result->points > 0 ? GLINT_OK
                              : glint_fail(err, GLINT_BAD_INPUT, "errors: no points compared");
}

static glint_status read_library(const json_t *raw, const json_t *design,
                                 glint_compare_result *result, glint_error *err)
{
    const json_t *slack = json_object_get(raw, "slack");
    const double area = number(design, "area");
    if (!json_is_number(slack) || area <= 0)
        return glint_fail(err, GLINT_BAD_INPUT, "cells: no slack or no area");
    result->gates = area / NAND2_UM2;
    result->mm2 = area / UM2_PER_MM2;
    result->mhz = 1000 / (STA_PERIOD_NS - json_number_value(slack));
    return GLINT_OK;
}

static glint_status read_size(const json_t *raw, glint_compare_result *result, glint_error *err)
{
    const json_t *design = json_object_get(json_object_get(raw, "stat"), "design");
    if (strcmp(result->flow, "cells") == 0)
        return read_library(raw, design, result, err);
    return glint_compare_count(result->flow, json_object_get(design, "num_cells_by_type"),
                               &result->cells, err);
}

/* The slowest of its clocks; a buffered one may be listed twice. */
static glint_status read_clock(const json_t *raw, glint_compare_result *result, glint_error *err)
{
    const char *name;
    json_t *clock;
    if (json_object_get(raw, "unplaced") != NULL) {
        result->unplaced = true;
        return GLINT_OK;
    }
    json_object_foreach(json_object_get(raw, "fmax"), name, clock)
    {
        const double mhz = number(clock, "achieved");
        if (mhz > 0 && (result->mhz == 0 || mhz < result->mhz))
            result->mhz = mhz;
    }
    return result->mhz > 0 ? GLINT_OK
                           : glint_fail(err, GLINT_BAD_INPUT, "%s: no clock rate", result->flow);
}

glint_status glint_compare_result_read(const json_t *json, glint_compare_result *result,
                                       glint_error *err)
{
    const json_t *raw = json_object_get(json, "raw");
    *result = (glint_compare_result){.seed = (int)number(json, "seed")};
    if (!copy(json, "unit", result->unit, sizeof result->unit) ||
        !copy(json, "kind", result->kind, sizeof result->kind) ||
        !copy(json, "flow", result->flow, sizeof result->flow) ||
        !copy(json, "tools", result->tools, sizeof result->tools))
        return glint_fail(err, GLINT_BAD_INPUT, "not a result of make compare");
    if (strcmp(result->kind, "errors") == 0)
        return read_errors(raw, result, err);
    if (strcmp(result->kind, "clock") == 0)
        return read_clock(raw, result, err);
    return read_size(raw, result, err);
}
