/* divider.json. */
#include "report/divider_report.h"

#include <math.h>

static cJSON *operations_json(glint_operations operations)
{
    cJSON *json = cJSON_CreateObject();
    cJSON_AddNumberToObject(json, "additions", (double)operations.additions);
    cJSON_AddNumberToObject(json, "divisions", (double)operations.divisions);
    return json;
}

static void add_operations(cJSON *json, const char *name, const glint_span_operations *operations)
{
    static const char *const stages[GLINT_SPAN_STAGE_COUNT] = {"edge_increments", "edge_points",
                                                               "row_increments", "row_points"};
    const glint_operations total = glint_operations_total(operations);
    cJSON *entry = cJSON_AddObjectToObject(json, name);
    for (int i = 0; i < GLINT_SPAN_STAGE_COUNT; i++)
        cJSON_AddItemToObject(entry, stages[i], operations_json(operations->stage[i]));
    cJSON_AddItemToObject(entry, "total", operations_json(total));
    cJSON_AddNumberToObject(entry, "inferred_clocks",
                            (double)glint_operations_clocks(total, GLINT_CLOCKS_DIVISION));
    cJSON_AddNumberToObject(
        entry, "inferred_clocks_by_shifts",
        (double)glint_operations_clocks(total, GLINT_CLOCKS_DIVISION_BY_SHIFTS));
}

static void add_table(cJSON *json, const glint_table_21 *table)
{
    cJSON *entry = cJSON_AddObjectToObject(json, "table_2_1");
    add_operations(entry, "stated", &glint_table_21_stated);
    add_operations(entry, "described", &table->described);
    add_operations(entry, "drawn", &table->drawn);
    cJSON_AddNumberToObject(entry, "described_edge_points", (double)table->described_edge_points);
    cJSON_AddNumberToObject(entry, "described_rows", (double)table->described_rows);
    cJSON_AddNumberToObject(entry, "described_pixels", (double)table->described_pixels);
    cJSON_AddNumberToObject(entry, "drawn_rows", (double)table->drawn_rows);
    cJSON_AddNumberToObject(entry, "drawn_pixels", (double)table->drawn_pixels);
}

static void add_claims(cJSON *json, const glint_claims *claims)
{
    cJSON *list = cJSON_AddArrayToObject(json, "thesis");
    for (int i = 0; i < claims->count; i++) {
        const glint_claim *claim = &claims->claim[i];
        cJSON *entry = cJSON_CreateObject();
        cJSON_AddStringToObject(entry, "what", claim->what);
        cJSON_AddNumberToObject(entry, "stated", claim->judged.stated);
        cJSON_AddNumberToObject(entry, "measured", claim->judged.lowest);
        if (claim->verdict == GLINT_CANNOT_BE_DECIDED)
            cJSON_AddNullToObject(entry, "holds");
        else
            cJSON_AddBoolToObject(entry, "holds", claim->verdict == GLINT_HOLDS);
        cJSON_AddStringToObject(entry, "note", claim->note);
        cJSON_AddItemToArray(list, entry);
    }
}

static cJSON *error_json(const glint_divider_error *error)
{
    cJSON *json = cJSON_CreateObject();
    cJSON_AddNumberToObject(json, "absolute", error->absolute);
    cJSON_AddNumberToObject(json, "absolute_k", error->absolute_k);
    cJSON_AddNumberToObject(json, "relative", error->relative);
    cJSON_AddNumberToObject(json, "relative_k", error->relative_k);
    cJSON_AddNumberToObject(json, "relative_mean", error->relative_mean);
    cJSON_AddNumberToObject(json, "last_pixel", error->last_pixel);
    cJSON_AddNumberToObject(json, "last_pixel_k", error->last_pixel_k);
    cJSON_AddNumberToObject(json, "displayed", error->displayed);
    if (error->displayed > 0) {
        cJSON_AddNumberToObject(json, "displayed_k", error->displayed_k);
        cJSON_AddNumberToObject(json, "displayed_difference", error->displayed_difference);
    }
    return json;
}

static void add_errors(cJSON *json, const glint_divider_report *report)
{
    static const char *const rules[GLINT_BITS_RULE_COUNT] = {"rounded", "truncated"};
    cJSON *list = cJSON_AddArrayToObject(json, "errors");
    for (int i = 0; i < GLINT_REPORT_SHIFTS; i++) {
        cJSON *entry = cJSON_CreateObject();
        cJSON_AddNumberToObject(entry, "shifts", GLINT_DIVIDER_SHIFTS_MIN + i);
        for (int rule = 0; rule < GLINT_BITS_RULE_COUNT; rule++)
            cJSON_AddItemToObject(entry, rules[rule], error_json(&report->error[rule][i]));
        cJSON_AddItemToArray(list, entry);
    }
    cJSON *first = cJSON_AddObjectToObject(json, "first_within_half_a_level");
    for (int rule = 0; rule < GLINT_BITS_RULE_COUNT; rule++)
        cJSON_AddNumberToObject(first, rules[rule], report->first_within_half[rule]);
}

static cJSON *frame_json(const glint_divider_frame *frame)
{
    cJSON *json = cJSON_CreateObject();
    cJSON_AddNumberToObject(json, "shifts", frame->shifts);
    cJSON_AddNumberToObject(json, "nmse", frame->difference.nmse);
    if (isfinite(frame->difference.psnr))
        cJSON_AddNumberToObject(json, "psnr", frame->difference.psnr);
    else
        cJSON_AddNullToObject(json, "psnr");
    cJSON_AddNumberToObject(json, "largest", frame->difference.largest);
    cJSON_AddNumberToObject(json, "differing_pixels", (double)frame->difference.differing_pixels);
    cJSON_AddNumberToObject(json, "object_pixels", (double)frame->difference.object_pixels);
    cJSON_AddNumberToObject(json, "verilog_differing_pixels", (double)frame->verilog_pixels);
    cJSON_AddStringToObject(json, "picture", frame->picture);
    cJSON_AddStringToObject(json, "difference_picture", frame->difference_picture);
    return json;
}

static void add_scenes(cJSON *json, const glint_divider_scene *scenes)
{
    cJSON *list = cJSON_AddArrayToObject(json, "frames");
    for (int i = 0; i < GLINT_DIVIDER_SCENES; i++) {
        cJSON *entry = cJSON_CreateObject();
        cJSON_AddStringToObject(entry, "model", scenes[i].model);
        cJSON_AddNumberToObject(entry, "density", scenes[i].density);
        cJSON_AddNumberToObject(entry, "triangles", (double)scenes[i].drawn);
        cJSON_AddNumberToObject(entry, "divisions", (double)scenes[i].divisions);
        cJSON_AddStringToObject(entry, "exact_picture", scenes[i].exact_picture);
        cJSON *frames = cJSON_AddArrayToObject(entry, "by_shifts");
        for (int j = 0; j < GLINT_DIVIDER_FRAMES; j++)
            cJSON_AddItemToArray(frames, frame_json(&scenes[i].frames[j]));
        cJSON_AddItemToArray(list, entry);
    }
}

cJSON *glint_divider_report_json(const glint_divider_report *report)
{
    cJSON *json = cJSON_CreateObject();
    add_claims(json, &report->claims);
    add_errors(json, report);
    add_table(json, &report->table);
    add_scenes(json, report->scenes);
    cJSON_AddBoolToObject(json, "plotted", report->plotted);
    return json;
}
