#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include <cjson/cJSON.h>

#include "failure/json.h"
#include "failure/json_names.h"
#include "failure/pins.h"
#include "file/json_text.h"

/* A JSON number would lose the low bits of a large one. */
static void add_exact(cJSON *json, const char *name, const char *format, uint64_t value)
{
    char text[32];
    (void)snprintf(text, sizeof text, format, value);
    cJSON_AddStringToObject(json, name, text);
}

static void add_numbers(cJSON *json, const char *name, const double *values, int count)
{
    cJSON_AddItemToObject(json, name, cJSON_CreateDoubleArray(values, count));
}

static void add_rgb(cJSON *json, const char *name, const uint8_t rgb[3])
{
    const double values[] = {rgb[0], rgb[1], rgb[2]};
    add_numbers(json, name, values, 3);
}

static void add_setting(cJSON *json, const glint_setting *setting)
{
    cJSON_AddStringToObject(json, "circuit", setting->is_divider ? "divider" : "specular");
    if (setting->is_divider) {
        cJSON_AddStringToObject(json, "form", glint_divider_form_name(setting->form));
        cJSON_AddNumberToObject(json, "shifts", setting->shifts);
        return;
    }
    cJSON_AddStringToObject(json, "gate", glint_gate_name(setting->specular.gate));
    cJSON_AddStringToObject(json, "pipeline", glint_pipeline_name(setting->specular.pipeline));
    cJSON_AddNumberToObject(json, "lanes", setting->specular.lanes);
}

static void add_finding(cJSON *json, const glint_failure *failure)
{
    const glint_failure_finding *finding = &failure->finding;
    cJSON *to = cJSON_AddObjectToObject(json, "found");
    cJSON_AddBoolToObject(to, "lockstep_differs", finding->lockstep_differs);
    cJSON_AddNumberToObject(to, "clock", (double)finding->clock);
    cJSON *list = cJSON_AddArrayToObject(to, "mismatches");
    for (int i = 0; i < finding->count; i++) {
        const glint_mismatch *mismatch = &finding->mismatch[i];
        cJSON *entry = cJSON_CreateObject();
        cJSON_AddStringToObject(entry, "signal", mismatch->signal.name);
        cJSON_AddNumberToObject(entry, glint_setting_lane_name(&failure->setting),
                                mismatch->signal.lane);
        cJSON_AddNumberToObject(entry, "block", mismatch->signal.block);
        add_exact(entry, "model", "0x%" PRIx64, mismatch->model);
        add_exact(entry, "rtl", "0x%" PRIx64, mismatch->rtl);
        cJSON_AddItemToArray(list, entry);
    }
    if (!failure->has_answer)
        return;
    cJSON_AddBoolToObject(to, "answer_differs", finding->answer_differs);
    cJSON_AddNumberToObject(to, "answer_model", finding->model);
    cJSON_AddNumberToObject(to, "answer_rtl", finding->rtl);
}

static void add_pins(cJSON *json, const glint_failure *failure)
{
    const glint_setting *setting = &failure->setting;
    const int count = glint_pin_count(setting);
    cJSON *to = cJSON_AddObjectToObject(json, "pins");
    cJSON_AddNumberToObject(to, "first_clock", (double)failure->first_clock);
    cJSON *names = cJSON_AddArrayToObject(to, "names");
    for (int i = 0; i < count; i++)
        cJSON_AddItemToArray(names, cJSON_CreateString(glint_pin(setting, i).name));
    cJSON *clocks = cJSON_AddArrayToObject(to, "clocks");
    for (size_t clock = 0; clock < failure->pin_count; clock++) {
        double values[GLINT_PINS_MAX];
        for (int i = 0; i < count; i++)
            values[i] = (double)glint_pin_get(setting, &failure->pins[clock], i);
        cJSON_AddItemToArray(clocks, cJSON_CreateDoubleArray(values, count));
    }
}

static void add_material(cJSON *json, const glint_material *material)
{
    const uint8_t rgb[] = {material->r, material->g, material->b};
    cJSON_AddNumberToObject(json, "n", material->n);
    add_rgb(json, "rgb", rgb);
}

static cJSON *division_of(const glint_division *division)
{
    const double values[] = {division->difference[0], division->difference[1],
                             division->difference[2], division->k};
    return cJSON_CreateDoubleArray(values, 4);
}

static void add_answer(cJSON *json, const glint_answer *answer)
{
    cJSON *to = cJSON_AddObjectToObject(json, "answer");
    cJSON_AddNumberToObject(to, "at", answer->at);
    cJSON_AddStringToObject(to, "value", glint_answer_value_name(answer->value));
    cJSON_AddNumberToObject(to, "model", answer->model);
    cJSON_AddNumberToObject(to, "rtl", answer->rtl);
    if (!answer->is_divider)
        add_material(to, &answer->material);
    cJSON *list = cJSON_AddArrayToObject(to, answer->is_divider ? "divisions" : "cosines");
    for (int i = 0; i < answer->count; i++)
        cJSON_AddItemToArray(list, answer->is_divider ? division_of(&answer->division[i])
                                                      : cJSON_CreateNumber(answer->cos_code[i]));
}

static void add_frame(cJSON *json, const glint_failure_frame *frame)
{
    cJSON *to = cJSON_AddObjectToObject(json, "frame");
    cJSON_AddNumberToObject(to, "width", frame->width);
    cJSON_AddNumberToObject(to, "height", frame->height);
    if (!frame->has_pixel)
        return;
    cJSON_AddNumberToObject(to, "x", frame->x);
    cJSON_AddNumberToObject(to, "y", frame->y);
    add_rgb(to, "model", frame->model);
    add_rgb(to, "rtl", frame->rtl);
    if (frame->has_triangle) {
        cJSON_AddNumberToObject(to, "triangle", frame->triangle);
        cJSON *corners = cJSON_AddArrayToObject(to, "corners");
        for (int i = 0; i < 3; i++)
            cJSON_AddItemToArray(corners, cJSON_CreateFloatArray(frame->corner[i], 3));
    }
    if (frame->has_fragment) {
        cJSON *fragment = cJSON_AddObjectToObject(to, "fragment");
        cJSON_AddNumberToObject(fragment, "cosine", frame->cos_code);
        add_material(fragment, &frame->material);
    }
}

char *glint_failure_to_json(const glint_failure *failure)
{
    cJSON *json = cJSON_CreateObject();
    cJSON_AddStringToObject(json, "format", GLINT_JSON_FORMAT);
    cJSON_AddNumberToObject(json, "version", GLINT_JSON_VERSION);
    cJSON_AddStringToObject(json, "kind", glint_failure_kind_names[failure->kind]);
    cJSON_AddStringToObject(json, "command", failure->command);
    add_setting(json, &failure->setting);
    if (failure->kind == GLINT_FAILURE_RANDOM)
        add_exact(json, "seed", "%" PRIu64, failure->seed);
    add_finding(json, failure);
    if (failure->pins != NULL)
        add_pins(json, failure);
    if (failure->has_answer)
        add_answer(json, &failure->answer);
    if (failure->kind == GLINT_FAILURE_FRAME)
        add_frame(json, &failure->frame);
    char *text = glint_json_text(json);
    cJSON_Delete(json);
    return text;
}
