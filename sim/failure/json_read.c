/* Every value is range-checked: a packet may come from anywhere. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/circuits.h"
#include "failure/answer_form.h"
#include "failure/json.h"
#include "failure/json_names.h"
#include "failure/json_reader.h"

#define PINS_MAX  65536                     /* clocks */
#define CLOCK_MAX INT64_C(1000000000000000) /* a double has every integer up to it */
#define SIDE_MAX  16384

/* The file, parsed so far. */
typedef struct reader {
    glint_json_reader json;
    const glint_circuit *extra; /* may be NULL */
    glint_failure *failure;
} reader;

/* ---- The setting ------------------------------------------------------------------------------
 */

static void read_circuit(reader *r, const json_t *json)
{
    const char *name = glint_json_string(&r->json, json, "circuit");
    const glint_circuit *circuit = glint_circuit_named(name);
    const bool is_elsewhere = r->failure->circuit_dir[0] != '\0';
    if (r->extra != NULL && strcmp(r->extra->name, name) == 0)
        circuit = r->extra;
    if (is_elsewhere && (circuit == NULL || circuit != r->extra))
        glint_json_refuse(
            &r->json, "circuit is not one of Glint's own: give its description with --circuit-dir");
    else if (circuit == NULL)
        glint_json_refuse(&r->json, "circuit is unknown");
    r->failure->setting.circuit = circuit;
}

static int read_value(reader *r, const json_t *json, const glint_parameter *parameter)
{
    if (parameter->goes_unsaid && json_object_get(json, parameter->name) == NULL)
        return parameter->standard;
    if (parameter->choices != NULL)
        return glint_json_choice(&r->json, json, parameter->name, parameter->choices,
                                 parameter->max + 1);
    return (int)glint_json_integer(&r->json, json, parameter->name, parameter->min, parameter->max);
}

/* Where it was looked for: a packet says so only of what is not Glint's own. It is to be said, not
 * to be opened. */
static void read_directories(reader *r, const json_t *json)
{
    glint_failure *failure = r->failure;
    if (json_object_get(json, GLINT_JSON_CIRCUIT_DIR) != NULL)
        glint_json_printed(&r->json, json, GLINT_JSON_CIRCUIT_DIR, failure->circuit_dir,
                           sizeof failure->circuit_dir);
    if (json_object_get(json, GLINT_JSON_RTL) != NULL)
        glint_json_printed(&r->json, json, GLINT_JSON_RTL, failure->rtl, sizeof failure->rtl);
}

static void read_setting(reader *r, const json_t *json)
{
    glint_setting *setting = &r->failure->setting;
    glint_error why;
    read_directories(r, json);
    read_circuit(r, json);
    if (r->json.failed)
        return;
    const glint_circuit *circuit = setting->circuit;
    const json_t *from = glint_json_is_own(circuit)
                             ? json
                             : glint_json_object(&r->json, json, GLINT_JSON_PARAMETERS);
    for (int i = 0; i < circuit->parameter_count && !r->json.failed; i++)
        setting->values[i] = read_value(r, from, &circuit->parameters[i]);
    if (!r->json.failed && glint_setting_check(setting, &why) != GLINT_OK)
        glint_json_refuse(&r->json, "%s", why.text);
}

/* ---- What was found ---------------------------------------------------------------------------
 */

static void read_mismatch(reader *r, const json_t *json, glint_mismatch *mismatch)
{
    const glint_setting *setting = &r->failure->setting;
    const char *name = glint_json_string(&r->json, json, "signal");
    const int lane = (int)glint_json_integer(&r->json, json, glint_setting_lane_name(setting), -1,
                                             GLINT_SIGNAL_WORDS_MAX);
    int i = 0;
    const int count = glint_setting_signal_count(setting);
    for (; i < count; i++) {
        mismatch->signal = glint_setting_signal(setting, i);
        if (strcmp(mismatch->signal.name, name) == 0 && mismatch->signal.lane == lane)
            break;
    }
    if (i == count) {
        glint_json_refuse(&r->json, "a mismatch is of a signal that the circuit does not have");
        return;
    }
    const int width = glint_signal_width(&mismatch->signal);
    mismatch->clock = r->failure->finding.clock;
    glint_json_words(&r->json, json_object_get(json, "model"), "model", width, mismatch->model);
    glint_json_words(&r->json, json_object_get(json, "rtl"), "rtl", width, mismatch->rtl);
}

static void read_finding(reader *r, const json_t *json)
{
    glint_failure_finding *finding = &r->failure->finding;
    const json_t *from = glint_json_object(&r->json, json, "found");
    finding->lockstep_differs = glint_json_boolean(&r->json, from, "lockstep_differs");
    finding->clock = (uint64_t)glint_json_integer(&r->json, from, "clock", 0, CLOCK_MAX);
    const json_t *list = glint_json_array(&r->json, from, "mismatches", 0, GLINT_MISMATCHES_KEPT);
    const json_t *entry;
    glint_json_each(entry, list)
    {
        if (!r->json.failed)
            read_mismatch(r, entry, &finding->mismatch[finding->count++]);
    }
    if (!r->failure->has_answer)
        return;
    finding->answer_differs = glint_json_boolean(&r->json, from, "answer_differs");
    finding->model =
        (int32_t)glint_json_integer(&r->json, from, "answer_model", INT32_MIN, INT32_MAX);
    finding->rtl = (int32_t)glint_json_integer(&r->json, from, "answer_rtl", INT32_MIN, INT32_MAX);
}

/* ---- Pins -------------------------------------------------------------------------------------
 */

/* In the order of the values of each clock: what has other names is of another circuit. */
static void check_pin_names(reader *r, const json_t *json)
{
    const glint_setting *setting = &r->failure->setting;
    const int count = glint_setting_pin_count(setting);
    const json_t *list = glint_json_array(&r->json, json, "names", count, count);
    for (int i = 0; list != NULL && i < count; i++) {
        const char *name = json_string_value(json_array_get(list, (size_t)i));
        const char *pin = glint_setting_pin(setting, i).name;
        if (name == NULL || strcmp(name, pin) != 0)
            glint_json_refuse(&r->json, "pin %d of names is not %s", i + 1, pin);
    }
}

static void read_pin(reader *r, const json_t *value, const glint_pin_info *pin, glint_pins *pins)
{
    const int width = glint_pin_width(pin);
    uint64_t words[GLINT_VALUE_WORDS];
    if (width > GLINT_JSON_NUMBER_BITS) {
        glint_json_words(&r->json, value, pin->name, width, words);
    } else {
        const int64_t values = INT64_C(1) << width;
        const int64_t min = pin->is_signed ? -values / 2 : 0;
        words[0] =
            (uint64_t)glint_json_integer_of(&r->json, value, pin->name, min, min + values - 1);
    }
    glint_pin_set(pin, pins, words);
}

static void read_clock(reader *r, const json_t *values, glint_pins *pins)
{
    const glint_setting *setting = &r->failure->setting;
    const int count = glint_setting_pin_count(setting);
    if (!json_is_array(values) || (int)json_array_size(values) != count) {
        glint_json_refuse(&r->json, "a clock does not have %d pins", count);
        return;
    }
    for (int i = 0; i < count && !r->json.failed; i++) {
        const glint_pin_info pin = glint_setting_pin(setting, i);
        read_pin(r, json_array_get(values, (size_t)i), &pin, pins);
    }
}

/* A random run without pins is played from its seed. */
static void read_pins(reader *r, const json_t *json)
{
    glint_failure *failure = r->failure;
    const json_t *from = json_object_get(json, "pins");
    failure->first_clock = 1;
    if (from == NULL || r->json.failed)
        return;
    failure->first_clock =
        (uint64_t)glint_json_integer(&r->json, from, "first_clock", 1, CLOCK_MAX);
    check_pin_names(r, from);
    const json_t *clocks = glint_json_array(&r->json, from, "clocks", 1, PINS_MAX);
    if (clocks == NULL)
        return;
    failure->pins = calloc((size_t)(int)json_array_size(clocks), sizeof *failure->pins);
    if (failure->pins == NULL) {
        glint_json_refuse(&r->json, "not enough memory for its pins");
        return;
    }
    const json_t *clock;
    glint_json_each(clock, clocks)
    {
        if (!r->json.failed)
            read_clock(r, clock, &failure->pins[failure->pin_count++]);
    }
}

/* ---- Answers and frames -----------------------------------------------------------------------
 */

static void read_answer(reader *r, const json_t *json)
{
    const char *values[GLINT_ANSWER_VALUES];
    for (int i = 0; i < GLINT_ANSWER_VALUES; i++)
        values[i] = glint_answer_value_name((glint_answer_value)i);
    const glint_answer_form *form = glint_answer_form_of(r->failure->setting.circuit);
    glint_answer *answer = &r->failure->answer;
    const json_t *from = json_object_get(json, "answer");
    r->failure->has_answer = from != NULL;
    if (from == NULL)
        return;
    if (form == NULL) {
        glint_json_refuse(&r->json, "answer belongs to a circuit without answers");
        return;
    }
    answer->value =
        (glint_answer_value)glint_json_choice(&r->json, from, "value", values, GLINT_ANSWER_VALUES);
    answer->model = (int32_t)glint_json_integer(&r->json, from, "model", INT32_MIN, INT32_MAX);
    answer->rtl = (int32_t)glint_json_integer(&r->json, from, "rtl", INT32_MIN, INT32_MAX);
    form->read(&r->json, from, answer);
    answer->at = (int)glint_json_integer(&r->json, from, "at", 0, answer->count - 1);
}

static void read_corners(reader *r, const json_t *json, glint_failure_frame *frame)
{
    const json_t *corners = glint_json_array(&r->json, json, "corners", 3, 3);
    for (int i = 0; corners != NULL && i < 3; i++)
        for (int c = 0; c < 3; c++) {
            const json_t *value = json_array_get(json_array_get(corners, (size_t)i), (size_t)c);
            if (!json_is_number(value) || !(fabs(json_number_value(value)) <= 1e30))
                glint_json_refuse(&r->json, "corners are not coordinates");
            else
                frame->corner[i][c] = (float)json_number_value(value);
        }
}

static void read_frame(reader *r, const json_t *json)
{
    glint_failure_frame *frame = &r->failure->frame;
    const json_t *from = glint_json_object(&r->json, json, "frame");
    frame->width = (int)glint_json_integer(&r->json, from, "width", 1, SIDE_MAX);
    frame->height = (int)glint_json_integer(&r->json, from, "height", 1, SIDE_MAX);
    frame->has_pixel = json_object_get(from, "x") != NULL;
    if (!frame->has_pixel && r->failure->has_answer)
        glint_json_refuse(&r->json, "x is missing");
    if (!frame->has_pixel)
        return;
    frame->x = (int)glint_json_integer(&r->json, from, "x", 0, frame->width - 1);
    frame->y = (int)glint_json_integer(&r->json, from, "y", 0, frame->height - 1);
    glint_json_rgb(&r->json, from, "model", frame->model);
    glint_json_rgb(&r->json, from, "rtl", frame->rtl);
    frame->has_triangle = json_object_get(from, "triangle") != NULL;
    if (frame->has_triangle) {
        frame->triangle = (uint32_t)glint_json_integer(&r->json, from, "triangle", 0, UINT32_MAX);
        read_corners(r, from, frame);
    }
    const json_t *fragment = json_object_get(from, "fragment");
    frame->has_fragment = fragment != NULL;
    if (frame->has_fragment) {
        frame->cos_code =
            (uint32_t)glint_json_integer(&r->json, fragment, "cosine", 0, GLINT_COS_CODE_MAX);
        frame->material = glint_json_material(&r->json, fragment);
    }
}

/* The clock that differed must be among those replayed. */
static void check_clock(reader *r)
{
    const glint_failure *failure = r->failure;
    const uint64_t clock = failure->finding.clock;
    if ((failure->kind != GLINT_FAILURE_RANDOM && failure->pins == NULL) || r->json.failed)
        return;
    if (clock < failure->first_clock ||
        (failure->pins != NULL && clock - failure->first_clock >= failure->pin_count))
        glint_json_refuse(&r->json, "the pins do not include clock %" PRIu64, clock);
}

/* ---- All of it --------------------------------------------------------------------------------
 */

static void read_all(reader *r, const json_t *json)
{
    glint_failure *failure = r->failure;
    if (strcmp(glint_json_string(&r->json, json, "format"), GLINT_JSON_FORMAT) != 0)
        glint_json_refuse(&r->json, "not from a failure packet");
    if (glint_json_integer(&r->json, json, "version", 0, INT32_MAX) != GLINT_JSON_VERSION)
        glint_json_refuse(&r->json, "its version is not %d", GLINT_JSON_VERSION);
    failure->kind = (glint_failure_kind)glint_json_choice(
        &r->json, json, "kind", glint_failure_kind_names, GLINT_FAILURE_KINDS);
    glint_json_printed(&r->json, json, "command", failure->command, sizeof failure->command);
    read_setting(r, json);
    if (r->json.failed)
        return;
    if (failure->kind == GLINT_FAILURE_RANDOM)
        failure->seed = glint_json_decimal(&r->json, json, "seed");
    else
        read_answer(r, json);
    read_pins(r, json);
    if (failure->kind == GLINT_FAILURE_EXHAUSTIVE && !glint_failure_playable(failure))
        glint_json_refuse(&r->json, "answer is missing");
    if (failure->kind == GLINT_FAILURE_FRAME)
        read_frame(r, json);
    read_finding(r, json);
    check_clock(r);
}

/* The message quotes nothing from the file, which may contain anything. */
static glint_status parse(const char *text, json_t **json, glint_error *err)
{
    json_error_t why;
    *json = json_loads(text, JSON_REJECT_DUPLICATES, &why);
    if (*json != NULL)
        return GLINT_OK;
    if (json_error_code(&why) == json_error_duplicate_key)
        return glint_fail(err, GLINT_BAD_INPUT, "duplicate name in line %d", why.line);
    return glint_fail(err, GLINT_BAD_INPUT, "invalid or incomplete JSON: line %d", why.line);
}

glint_status glint_failure_from_json(const char *text, const glint_circuit *extra,
                                     glint_failure **failure, glint_error *err)
{
    *failure = NULL;
    json_t *json;
    const glint_status status = parse(text, &json, err);
    if (status != GLINT_OK)
        return status;
    reader r = {.json = {.err = err}, .extra = extra, .failure = calloc(1, sizeof *r.failure)};
    if (r.failure == NULL) {
        json_decref(json);
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a failure");
    }
    read_all(&r, json);
    json_decref(json);
    if (r.json.failed) {
        glint_failure_destroy(r.failure);
        return GLINT_BAD_INPUT;
    }
    *failure = r.failure;
    return GLINT_OK;
}
