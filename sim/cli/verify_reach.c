/* The coverage counters of random runs, as text and as JSON. */
#include "cli/verify_reach.h"

#include <inttypes.h>
#include <stdio.h>

#include "circuit/units.h"

static void keep_least(uint64_t *least, uint64_t value, bool is_first)
{
    if (is_first || value < *least)
        *least = value;
}

static void add_lanes(glint_reach_sum *sum, int lanes, const glint_reach *reach)
{
    sum->alone = (sum->lanes == 0 || sum->alone) && reach->lanes_alone == lanes;
    if (lanes < sum->lanes)
        return;
    keep_least(&sum->patterns, reach->patterns, lanes > sum->lanes);
    sum->lanes = lanes;
}

/* The strobes of a highlight unit write its material. */
static bool has_material(const glint_setting *setting)
{
    return glint_is_highlight(setting->circuit);
}

static void add_strobes(glint_reach_sum *sum, const glint_setting *setting,
                        const glint_reach *reach)
{
    sum->material = (!sum->strobes || sum->material) && has_material(setting);
    sum->strobes = true;
    sum->all.changes += reach->changes;
    sum->all.changes_in_flight += reach->changes_in_flight;
}

static bool has_either(const glint_setting *setting, glint_pin_role a, glint_pin_role b)
{
    return glint_reach_has(setting, a) || glint_reach_has(setting, b);
}

/* NULL where no output's value before an edge went uncompared. */
static const char *follower_of(const glint_setting *setting, const glint_roles *roles)
{
    return roles->follows >= 0 ? glint_setting_signal(setting, roles->follows).name : NULL;
}

void glint_reach_sum_add(glint_reach_sum *sum, const glint_setting *setting,
                         const glint_lockstep_result *result)
{
    const glint_reach *reach = &result->reach;
    const bool is_first = sum->settings++ == 0;
    const int lanes = glint_reach_lanes(setting);
    const bool resets = has_either(setting, GLINT_PIN_RESET, GLINT_PIN_RESET_LOW);
    sum->resets |= resets;
    sum->enables |= has_either(setting, GLINT_PIN_ENABLE, GLINT_PIN_ENABLE_LOW);
    sum->unreset |= !resets && setting->circuit->clock_port != NULL;
    if (sum->follows == NULL)
        sum->follows = follower_of(setting, &result->roles);
    keep_least(&sum->least.run, reach->run, is_first);
    keep_least(&sum->least.run_enabled, reach->run_enabled, is_first);
    keep_least(&sum->least.stall, reach->stall, is_first);
    sum->all.resets += reach->resets;
    sum->all.resets_in_flight += reach->resets_in_flight;
    sum->all.ignored += reach->ignored;
    if (glint_reach_has(setting, GLINT_PIN_STROBE))
        add_strobes(sum, setting, reach);
    if (lanes != 0)
        add_lanes(sum, lanes, reach);
}

/* The possible sets of lanes that accept a point together. */
static uint64_t patterns_of(int lanes)
{
    return (UINT64_C(1) << lanes) - 1;
}

static void print_lanes(const glint_reach_sum *sum)
{
    printf("\nvalid lanes: %seach alone", sum->alone ? "" : "not ");
    if (sum->lanes <= GLINT_REACH_PATTERN_LANES)
        printf(", %" PRIu64 " of %" PRIu64 " patterns of %d", sum->patterns,
               patterns_of(sum->lanes), sum->lanes);
}

/* What happened in all settings together; nothing of what they have not. */
static void print_events(const glint_reach_sum *sum)
{
    const char *before = "\nin total: ";
    const glint_reach *all = &sum->all;
    if (sum->resets) {
        printf("%s%" PRIu64 " resets, %" PRIu64 " of them mid-flow", before, all->resets,
               all->resets_in_flight);
        before = "; ";
    }
    if (sum->strobes) {
        printf("%s%" PRIu64 " %s, %" PRIu64 " with %s in flight", before, all->changes,
               sum->material ? "changes of material" : "strobes", all->changes_in_flight,
               sum->material ? "points" : "something");
        before = "; ";
    }
    if (all->ignored != 0)
        printf("%s%" PRIu64 " starts while busy", before, all->ignored);
}

void glint_reach_sum_print(const glint_reach_sum *sum)
{
    if (sum->settings == 0)
        return;
    printf("reached in every setting: %" PRIu64 " clocks", sum->least.run);
    if (sum->resets)
        printf(" without a reset");
    if (sum->enables)
        printf(", %" PRIu64 " enabled; %" PRIu64 " stalls in a row", sum->least.run_enabled,
               sum->least.stall);
    print_events(sum);
    if (sum->lanes > 1)
        print_lanes(sum);
    printf("\nnot covered: ");
    if (sum->unreset)
        printf("registers that power up otherwise than with 0 or their `initial` value; ");
    if (sum->follows != NULL)
        printf("%s before the edge, where it follows a pin (kind MEALY compares that); ",
               sum->follows);
    printf("faults that need longer runs%s to show; raise --clocks for those\n",
           sum->enables ? " or longer stalls" : "");
}

/* What every circuit has. */
static json_t *add_object(json_t *entry, const glint_reach *depth, const glint_reach *counts)
{
    json_t *json = glint_json_add(entry, "reach", json_object());
    glint_json_add_number(json, "clocks_without_reset", (double)depth->run);
    glint_json_add_number(json, "enabled_clocks_without_reset", (double)depth->run_enabled);
    glint_json_add_number(json, "stalls_in_a_row", (double)depth->stall);
    glint_json_add_number(json, "resets", (double)counts->resets);
    glint_json_add_number(json, "resets_in_flight", (double)counts->resets_in_flight);
    return json;
}

static void add_changes(json_t *json, bool material, const glint_reach *reach)
{
    glint_json_add_number(json, material ? "material_changes" : "strobes", (double)reach->changes);
    glint_json_add_number(json, material ? "material_changes_in_flight" : "strobes_in_flight",
                          (double)reach->changes_in_flight);
}

static void add_lane_counts(json_t *json, int lanes, const glint_reach *reach)
{
    glint_json_add_number(json, "lanes_alone", reach->lanes_alone);
    if (lanes > GLINT_REACH_PATTERN_LANES)
        return;
    glint_json_add_number(json, "lane_patterns", (double)reach->patterns);
    glint_json_add_number(json, "lane_patterns_possible", (double)patterns_of(lanes));
}

void glint_reach_json(json_t *entry, const glint_setting *setting,
                      const glint_lockstep_result *result)
{
    const glint_reach *reach = &result->reach;
    json_t *json = add_object(entry, reach, reach);
    const int lanes = glint_reach_lanes(setting);
    if (glint_setting_pace(setting) > 1)
        glint_json_add_number(json, "starts_while_busy", (double)reach->ignored);
    if (glint_reach_has(setting, GLINT_PIN_STROBE))
        add_changes(json, has_material(setting), reach);
    if (lanes != 0)
        add_lane_counts(json, lanes, reach);
    if (result->roles.follows >= 0)
        glint_json_add_text(json, "not_compared_before_the_edge",
                            follower_of(setting, &result->roles));
}

void glint_reach_sum_json(json_t *result, const glint_reach_sum *sum)
{
    json_t *json = add_object(result, &sum->least, &sum->all);
    if (sum->strobes)
        add_changes(json, sum->material, &sum->all);
}
