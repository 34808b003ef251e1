/* A failure as JSON: the writing half of json.h; json_read.c is the other. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "circuit/words.h"
#include "failure/answer_form.h"
#include "failure/json.h"
#include "failure/json_names.h"
#include "file/json.h"
#include "lockstep/mismatch.h"

/* A JSON number would lose the low bits of a large one. */
static void add_exact(json_t *json, const char *name, const char *format, uint64_t value)
{
    char text[32];
    (void)snprintf(text, sizeof text, format, value);
    glint_json_add_text(json, name, text);
}

static void add_numbers(json_t *json, const char *name, const double *values, int count)
{
    json_object_set_new(json, name, glint_json_numbers_of(values, count));
}

static void add_rgb(json_t *json, const char *name, const uint8_t rgb[3])
{
    const double values[] = {rgb[0], rgb[1], rgb[2]};
    add_numbers(json, name, values, 3);
}

static void add_value(json_t *json, const glint_parameter *parameter, int value)
{
    if (parameter->choices != NULL)
        glint_json_add_text(json, parameter->name, parameter->choices[value]);
    else
        glint_json_add_number(json, parameter->name, value);
}

static void add_setting(json_t *json, const glint_failure *failure)
{
    const glint_circuit *circuit = failure->setting.circuit;
    glint_json_add_text(json, "circuit", circuit->name);
    if (failure->circuit_dir[0] != '\0')
        glint_json_add_text(json, GLINT_JSON_CIRCUIT_DIR, failure->circuit_dir);
    if (glint_failure_rtl(failure)[0] != '\0')
        glint_json_add_text(json, GLINT_JSON_RTL, failure->rtl);
    json_t *to = glint_json_is_own(circuit)
                     ? json
                     : glint_json_add(json, GLINT_JSON_PARAMETERS, json_object());
    for (int i = 0; i < circuit->parameter_count; i++)
        if (!glint_setting_leaves_out(&failure->setting, i))
            add_value(to, &circuit->parameters[i], failure->setting.values[i]);
}

static void add_bits(json_t *json, const char *name, const glint_signal_info *signal,
                     const uint64_t *words)
{
    char text[GLINT_VALUE_TEXT];
    glint_mismatch_bits(signal, words, text);
    glint_json_add_text(json, name, text);
}

static void add_finding(json_t *json, const glint_failure *failure)
{
    const glint_failure_finding *finding = &failure->finding;
    json_t *to = glint_json_add(json, "found", json_object());
    json_object_set_new(to, "lockstep_differs", json_boolean(finding->lockstep_differs));
    glint_json_add_number(to, "clock", (double)finding->clock);
    json_t *list = glint_json_add(to, "mismatches", json_array());
    for (int i = 0; i < finding->count; i++) {
        const glint_mismatch *mismatch = &finding->mismatch[i];
        json_t *entry = json_object();
        glint_json_add_text(entry, "signal", mismatch->signal.name);
        glint_json_add_number(entry, glint_setting_lane_name(&failure->setting),
                              mismatch->signal.lane);
        glint_json_add_number(entry, "block", mismatch->signal.block);
        add_bits(entry, "model", &mismatch->signal, mismatch->model);
        add_bits(entry, "rtl", &mismatch->signal, mismatch->rtl);
        json_array_append_new(list, entry);
    }
    if (!failure->has_answer)
        return;
    json_object_set_new(to, "answer_differs", json_boolean(finding->answer_differs));
    glint_json_add_number(to, "answer_model", finding->model);
    glint_json_add_number(to, "answer_rtl", finding->rtl);
}

static json_t *pin_of(const glint_pin_info *pin, const glint_pins *pins)
{
    const int width = glint_pin_width(pin);
    uint64_t words[GLINT_VALUE_WORDS];
    char text[GLINT_VALUE_TEXT];
    glint_pin_get(pin, pins, words);
    if (width <= GLINT_JSON_NUMBER_BITS)
        return glint_json_number_of(glint_words_number(words, width, 0, pin->is_signed));
    glint_words_hex(words, width, text);
    return glint_json_text_of(text);
}

static void add_pins(json_t *json, const glint_failure *failure)
{
    const glint_setting *setting = &failure->setting;
    const int count = glint_setting_pin_count(setting);
    json_t *to = glint_json_add(json, "pins", json_object());
    glint_json_add_number(to, "first_clock", (double)failure->first_clock);
    json_t *names = glint_json_add(to, "names", json_array());
    for (int i = 0; i < count; i++)
        json_array_append_new(names, glint_json_text_of(glint_setting_pin(setting, i).name));
    json_t *clocks = glint_json_add(to, "clocks", json_array());
    for (size_t clock = 0; clock < failure->pin_count; clock++) {
        json_t *values = json_array();
        for (int i = 0; i < count; i++) {
            const glint_pin_info pin = glint_setting_pin(setting, i);
            json_array_append_new(values, pin_of(&pin, &failure->pins[clock]));
        }
        json_array_append_new(clocks, values);
    }
}

static void add_material(json_t *json, const glint_material *material)
{
    const uint8_t rgb[] = {material->r, material->g, material->b};
    glint_json_add_number(json, "n", material->n);
    add_rgb(json, "rgb", rgb);
}

static void add_answer(json_t *json, const glint_failure *failure)
{
    const glint_answer *answer = &failure->answer;
    json_t *to = glint_json_add(json, "answer", json_object());
    glint_json_add_number(to, "at", answer->at);
    glint_json_add_text(to, "value", glint_answer_value_name(answer->value));
    glint_json_add_number(to, "model", answer->model);
    glint_json_add_number(to, "rtl", answer->rtl);
    glint_answer_form_of(failure->setting.circuit)->write(to, answer);
}

static void add_frame(json_t *json, const glint_failure_frame *frame)
{
    json_t *to = glint_json_add(json, "frame", json_object());
    glint_json_add_number(to, "width", frame->width);
    glint_json_add_number(to, "height", frame->height);
    if (!frame->has_pixel)
        return;
    glint_json_add_number(to, "x", frame->x);
    glint_json_add_number(to, "y", frame->y);
    add_rgb(to, "model", frame->model);
    add_rgb(to, "rtl", frame->rtl);
    if (frame->has_triangle) {
        glint_json_add_number(to, "triangle", frame->triangle);
        json_t *corners = glint_json_add(to, "corners", json_array());
        for (int i = 0; i < 3; i++)
            json_array_append_new(
                corners, glint_json_numbers_of((const double[]){(double)frame->corner[i][0],
                                                                (double)frame->corner[i][1],
                                                                (double)frame->corner[i][2]},
                                               3));
    }
    if (frame->has_fragment) {
        json_t *fragment = glint_json_add(to, "fragment", json_object());
        glint_json_add_number(fragment, "cosine", frame->cos_code);
        add_material(fragment, &frame->material);
    }
}

char *glint_failure_to_json(const glint_failure *failure)
{
    json_t *json = json_object();
    glint_json_add_text(json, "format", GLINT_JSON_FORMAT);
    glint_json_add_number(json, "version", GLINT_JSON_VERSION);
    glint_json_add_text(json, "kind", glint_failure_kind_names[failure->kind]);
    glint_json_add_text(json, "command", failure->command);
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
    json_decref(json);
    return text;
}
