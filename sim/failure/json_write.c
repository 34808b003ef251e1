/* A failure as JSON: the writing half of json.h; json_read.c is the other. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include <cjson/cJSON.h>

#include "circuit/words.h"
#include "failure/answer_form.h"
#include "failure/json.h"
#include "failure/json_names.h"
#include "file/json_text.h"
#include "lockstep/mismatch.h"

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

static void add_value(cJSON *json, const glint_parameter *parameter, int value)
{
    if (parameter->choices != NULL)
        cJSON_AddStringToObject(json, parameter->name, parameter->choices[value]);
    else
        cJSON_AddNumberToObject(json, parameter->name, value);
}

static void add_setting(cJSON *json, const glint_failure *failure)
{
    const glint_circuit *circuit = failure->setting.circuit;
    cJSON_AddStringToObject(json, "circuit", circuit->name);
    if (failure->circuit_dir[0] != '\0')
        cJSON_AddStringToObject(json, GLINT_JSON_CIRCUIT_DIR, failure->circuit_dir);
    if (glint_failure_rtl(failure)[0] != '\0')
        cJSON_AddStringToObject(json, GLINT_JSON_RTL, failure->rtl);
    cJSON *to =
        glint_json_is_own(circuit) ? json : cJSON_AddObjectToObject(json, GLINT_JSON_PARAMETERS);
    for (int i = 0; i < circuit->parameter_count; i++)
        add_value(to, &circuit->parameters[i], failure->setting.values[i]);
}

static void add_bits(cJSON *json, const char *name, const glint_signal_info *signal,
                     const uint64_t *words)
{
    char text[GLINT_VALUE_TEXT];
    glint_mismatch_bits(signal, words, text);
    cJSON_AddStringToObject(json, name, text);
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
        add_bits(entry, "model", &mismatch->signal, mismatch->model);
        add_bits(entry, "rtl", &mismatch->signal, mismatch->rtl);
        cJSON_AddItemToArray(list, entry);
    }
    if (!failure->has_answer)
        return;
    cJSON_AddBoolToObject(to, "answer_differs", finding->answer_differs);
    cJSON_AddNumberToObject(to, "answer_model", finding->model);
    cJSON_AddNumberToObject(to, "answer_rtl", finding->rtl);
}

static cJSON *pin_of(const glint_pin_info *pin, const glint_pins *pins)
{
    const int width = glint_pin_width(pin);
    uint64_t words[GLINT_VALUE_WORDS];
    char text[GLINT_VALUE_TEXT];
    glint_pin_get(pin, pins, words);
    if (width <= GLINT_JSON_NUMBER_BITS)
        return cJSON_CreateNumber(glint_words_number(words, width, 0, pin->is_signed));
    glint_words_hex(words, width, text);
    return cJSON_CreateString(text);
}

static void add_pins(cJSON *json, const glint_failure *failure)
{
    const glint_setting *setting = &failure->setting;
    const int count = glint_setting_pin_count(setting);
    cJSON *to = cJSON_AddObjectToObject(json, "pins");
    cJSON_AddNumberToObject(to, "first_clock", (double)failure->first_clock);
    cJSON *names = cJSON_AddArrayToObject(to, "names");
    for (int i = 0; i < count; i++)
        cJSON_AddItemToArray(names, cJSON_CreateString(glint_setting_pin(setting, i).name));
    cJSON *clocks = cJSON_AddArrayToObject(to, "clocks");
    for (size_t clock = 0; clock < failure->pin_count; clock++) {
        cJSON *values = cJSON_CreateArray();
        for (int i = 0; i < count; i++) {
            const glint_pin_info pin = glint_setting_pin(setting, i);
            cJSON_AddItemToArray(values, pin_of(&pin, &failure->pins[clock]));
        }
        cJSON_AddItemToArray(clocks, values);
    }
}

static void add_material(cJSON *json, const glint_material *material)
{
    const uint8_t rgb[] = {material->r, material->g, material->b};
    cJSON_AddNumberToObject(json, "n", material->n);
    add_rgb(json, "rgb", rgb);
}

static void add_answer(cJSON *json, const glint_failure *failure)
{
    const glint_answer *answer = &failure->answer;
    cJSON *to = cJSON_AddObjectToObject(json, "answer");
    cJSON_AddNumberToObject(to, "at", answer->at);
    cJSON_AddStringToObject(to, "value", glint_answer_value_name(answer->value));
    cJSON_AddNumberToObject(to, "model", answer->model);
    cJSON_AddNumberToObject(to, "rtl", answer->rtl);
    glint_answer_form_of(failure->setting.circuit)->write(to, answer);
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
    add_setting(json, failure);
    if (failure->kind == GLINT_FAILURE_RANDOM)
        add_exact(json, "seed", "%" PRIu64, failure->seed);
    add_finding(json, failure);
    if (failure->pins != NULL)
        add_pins(json, failure);
    if (failure->has_answer)
        add_answer(json, failure);
    if (failure->kind == GLINT_FAILURE_FRAME)
        add_frame(json, &failure->frame);
    char *text = glint_json_text(json);
    cJSON_Delete(json);
    return text;
}
