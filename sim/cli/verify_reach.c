#include "cli/verify_reach.h"

#include <inttypes.h>
#include <stdio.h>

static void keep_least(uint64_t *least, uint64_t value, bool is_first)
{
    if (is_first || value < *least)
        *least = value;
}

static void add_specular(glint_reach_sum *sum, int lanes, const glint_reach *reach)
{
    sum->all.changes += reach->changes;
    sum->all.changes_in_flight += reach->changes_in_flight;
    sum->alone = (sum->lanes == 0 || sum->alone) && reach->lanes_alone == lanes;
    if (lanes < sum->lanes)
        return;
    keep_least(&sum->patterns, reach->patterns, lanes > sum->lanes);
    sum->lanes = lanes;
}

void glint_reach_sum_add(glint_reach_sum *sum, const glint_setting *setting,
                         const glint_reach *reach)
{
    const bool is_first = sum->settings++ == 0;
    keep_least(&sum->least.run, reach->run, is_first);
    keep_least(&sum->least.run_enabled, reach->run_enabled, is_first);
    keep_least(&sum->least.stall, reach->stall, is_first);
    sum->all.resets += reach->resets;
    sum->all.resets_in_flight += reach->resets_in_flight;
    sum->all.ignored += reach->ignored;
    if (!setting->is_divider)
        add_specular(sum, setting->specular.lanes, reach);
}

/* The sets of lanes that can take a point together. */
static uint64_t patterns_of(int lanes)
{
    return (UINT64_C(1) << lanes) - 1;
}

void glint_reach_sum_print(const glint_reach_sum *sum)
{
    if (sum->settings == 0)
        return;
    printf("reached by each setting: %" PRIu64 " clocks without a reset, %" PRIu64
           " enabled; %" PRIu64 " stalls in a row\n"
           "by all together: %" PRIu64 " resets, %" PRIu64 " of them in mid-flow",
           sum->least.run, sum->least.run_enabled, sum->least.stall, sum->all.resets,
           sum->all.resets_in_flight);
    if (sum->lanes != 0)
        printf("; %" PRIu64 " changes of material, %" PRIu64 " with points in flight",
               sum->all.changes, sum->all.changes_in_flight);
    if (sum->all.ignored != 0)
        printf("; %" PRIu64 " starts while busy", sum->all.ignored);
    if (sum->lanes > 1)
        printf("\nvalid lanes: %seach alone, %" PRIu64 " of %" PRIu64 " patterns of %d",
               sum->alone ? "" : "not ", sum->patterns, patterns_of(sum->lanes), sum->lanes);
    printf("\nnot reached: a fault that takes more clocks or stalls in a row to show; more "
           "--clocks reach further\n");
}

/* What every circuit has. */
static cJSON *add_object(cJSON *entry, const glint_reach *depth, const glint_reach *counts)
{
    cJSON *json = cJSON_AddObjectToObject(entry, "reach");
    cJSON_AddNumberToObject(json, "clocks_without_reset", (double)depth->run);
    cJSON_AddNumberToObject(json, "enabled_clocks_without_reset", (double)depth->run_enabled);
    cJSON_AddNumberToObject(json, "stalls_in_a_row", (double)depth->stall);
    cJSON_AddNumberToObject(json, "resets", (double)counts->resets);
    cJSON_AddNumberToObject(json, "resets_in_flight", (double)counts->resets_in_flight);
    return json;
}

static void add_material(cJSON *json, const glint_reach *reach)
{
    cJSON_AddNumberToObject(json, "material_changes", (double)reach->changes);
    cJSON_AddNumberToObject(json, "material_changes_in_flight", (double)reach->changes_in_flight);
}

void glint_reach_json(cJSON *entry, const glint_setting *setting, const glint_reach *reach)
{
    cJSON *json = add_object(entry, reach, reach);
    if (setting->is_divider) {
        if (setting->form == GLINT_DIVIDER_SEQUENTIAL)
            cJSON_AddNumberToObject(json, "starts_while_busy", (double)reach->ignored);
        return;
    }
    add_material(json, reach);
    cJSON_AddNumberToObject(json, "lanes_alone", reach->lanes_alone);
    cJSON_AddNumberToObject(json, "lane_patterns", (double)reach->patterns);
    cJSON_AddNumberToObject(json, "lane_patterns_possible",
                            (double)patterns_of(setting->specular.lanes));
}

void glint_reach_sum_json(cJSON *result, const glint_reach_sum *sum)
{
    cJSON *json = add_object(result, &sum->least, &sum->all);
    if (sum->lanes != 0)
        add_material(json, &sum->all);
}
