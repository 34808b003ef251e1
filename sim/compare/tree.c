/* Gathers the results of a manifest into one tree. */
#include "compare/result.h"
#include "compare/tables.h"
#include "compare/units.h"
#include "file/json.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The member of that name, made if it is not there. */
static json_t *member(json_t *object, const char *name)
{
    json_t *found = json_object_get(object, name);
    return found != NULL ? found : glint_json_add(object, name, json_object());
}

static bool add_cells(json_t *at, const glint_compare_result *r)
{
    if (strcmp(r->flow, "cells") == 0)
        return glint_json_add_number(at, "gates", r->gates) &&
               glint_json_add_number(at, "mm2", r->mm2) && glint_json_add_number(at, "mhz", r->mhz);
    return glint_json_add_number(at, "lut", r->cells.lut) &&
           glint_json_add_number(at, "ff", r->cells.ff) &&
           glint_json_add_number(at, "dsp", r->cells.dsp) &&
           glint_json_add_number(at, "bram", r->cells.bram);
}

static bool add_errors(json_t *at, const glint_compare_result *r)
{
    return glint_json_add_number(at, "power_steps", r->power_steps) &&
           glint_json_add_number(at, "own_steps", r->own_steps) &&
           glint_json_add_number(at, "nmse", r->nmse) &&
           glint_json_add_number(at, "nmse_n", r->nmse_n) &&
           glint_json_add_number(at, "points", r->points);
}

static bool add_rate(json_t *at, const glint_compare_result *r)
{
    json_t *rates = json_object_get(at, "mhz");
    if (rates == NULL)
        rates = glint_json_add(at, "mhz", json_array());
    return rates != NULL && (r->unplaced || json_array_append_new(rates, json_real(r->mhz)) == 0);
}

static bool add_result(json_t *tree, const glint_compare_result *r)
{
    json_t *unit;
    glint_json_each(unit, tree)
    {
        if (strcmp(json_string_value(json_object_get(unit, "unit")), r->unit) != 0)
            continue;
        json_t *at = member(unit, r->kind);
        if (strcmp(r->kind, "errors") == 0)
            return at != NULL && add_errors(at, r);
        at = at == NULL ? NULL : member(at, r->flow);
        if (at == NULL || !glint_json_add_text(at, "tools", r->tools))
            return false;
        return strcmp(r->kind, "clock") == 0 ? add_rate(at, r) : add_cells(at, r);
    }
    return true; /* of a unit that is no longer compared */
}

static bool add_units(json_t *tree)
{
    glint_setting setting;
    char name[GLINT_SETTING_TEXT], label[GLINT_SETTING_TEXT];
    for (int i = 0; glint_compare_setting(i, &setting); i++) {
        json_t *unit = json_object();
        glint_setting_name(&setting, name);
        glint_compare_label(&setting, label);
        if (json_array_append_new(tree, unit) != 0 || !glint_json_add_text(unit, "unit", name) ||
            !glint_json_add_text(unit, "label", label) ||
            !glint_json_add_number(unit, "lanes", glint_compare_lanes(&setting)) ||
            !glint_json_add_number(unit, "w_frac_bits", glint_compare_w_frac_bits(&setting)) ||
            !glint_json_add_number(unit, "latency", glint_setting_latency(&setting)) ||
            !glint_json_add_number(unit, "only_n", glint_compare_only_n(&setting)))
            return false;
    }
    return true;
}

static glint_status add_file(json_t *tree, const char *path, glint_error *err)
{
    glint_compare_result result;
    glint_error why;
    json_error_t fault;
    if (access(path, F_OK) != 0)
        return GLINT_OK;
    json_t *json = json_load_file(path, 0, &fault);
    if (json == NULL)
        return glint_fail(err, GLINT_BAD_INPUT, "%s: %s", path, fault.text);
    glint_status status = glint_compare_result_read(json, &result, &why);
    json_decref(json);
    if (status != GLINT_OK)
        return glint_fail(err, status, "%s: %s", path, why.text);
    return add_result(tree, &result) ? GLINT_OK
                                     : glint_fail(err, GLINT_NO_MEMORY, "no memory for the table");
}

glint_status glint_compare_tree(const char *manifest, json_t **tree, glint_error *err)
{
    char path[4096];
    glint_status status = GLINT_OK;
    FILE *file = fopen(manifest, "r");
    *tree = NULL;
    if (file == NULL)
        return glint_fail(err, GLINT_IO_ERROR, "%s: %s", manifest, strerror(errno));
    json_t *made = json_array();
    if (made == NULL || !add_units(made))
        status = glint_fail(err, GLINT_NO_MEMORY, "no memory for the table");
    while (status == GLINT_OK && fgets(path, sizeof path, file) != NULL) {
        path[strcspn(path, "\n")] = '\0';
        status = add_file(made, path, err);
    }
    (void)fclose(file);
    if (status == GLINT_OK)
        *tree = made;
    else
        json_decref(made);
    return status;
}
