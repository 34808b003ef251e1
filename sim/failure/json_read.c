/* Everything is held against its range: a packet may come from anywhere. */
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cjson/cJSON.h>

#include "failure/json.h"
#include "failure/json_names.h"
#include "failure/pins.h"

#define PINS_MAX    65536                     /* clocks */
#define CLOCK_MAX   INT64_C(1000000000000000) /* a double has every integer up to it */
#define SIDE_MAX    16384
#define MEMBERS_MAX 32 /* of an object: twice the most that any has */

/* The file as far as it is understood; the first thing wrong is told, the rest not looked at. */
typedef struct reader {
    glint_failure *failure;
    glint_error *err;
    bool failed;
} reader;

static void refuse(reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void refuse(reader *r, const char *format, ...)
{
    char text[256];
    va_list arguments;
    if (r->failed)
        return;
    va_start(arguments, format);
    (void)vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    (void)glint_fail(r->err, GLINT_BAD_INPUT, "%s", text);
    r->failed = true;
}

/* ---- Values, each of a kind and a range
 * ---------------------------------------------------------- */

static int64_t integer_of(reader *r, const cJSON *item, const char *name, int64_t min, int64_t max)
{
    const double value = cJSON_IsNumber(item) ? item->valuedouble : (double)NAN;
    if (!(value >= (double)min && value <= (double)max) || value != floor(value)) {
        refuse(r, "%s is no whole number from %" PRId64 " to %" PRId64, name, min, max);
        return min;
    }
    return (int64_t)value;
}

static const cJSON *member(const cJSON *json, const char *name)
{
    return cJSON_GetObjectItemCaseSensitive(json, name);
}

static int64_t integer(reader *r, const cJSON *json, const char *name, int64_t min, int64_t max)
{
    return integer_of(r, member(json, name), name, min, max);
}

static bool boolean(reader *r, const cJSON *json, const char *name)
{
    const cJSON *item = member(json, name);
    if (!cJSON_IsBool(item))
        refuse(r, "%s is neither true nor false", name);
    return cJSON_IsTrue(item);
}

static const char *text(reader *r, const cJSON *json, const char *name)
{
    const char *value = cJSON_GetStringValue(member(json, name));
    if (value == NULL)
        refuse(r, "%s is no text", name);
    return value != NULL ? value : "";
}

/* Digits of the base and nothing else. */
static uint64_t exact(reader *r, const cJSON *json, const char *name, int base)
{
    const char *value = text(r, json, name);
    const char *digits = base == 16 && strncmp(value, "0x", 2) == 0 ? value + 2 : value;
    const char *allowed = base == 16 ? "0123456789abcdef" : "0123456789";
    const size_t length = strlen(digits);
    if (length == 0 || length > (base == 16 ? 16u : 19u) || strspn(digits, allowed) != length)
        refuse(r, "%s is no number", name);
    return r->failed ? 0 : strtoull(digits, NULL, base);
}

/* Index of the text among names. */
static int choice(reader *r, const cJSON *json, const char *name, const char *const *names,
                  int count)
{
    const char *value = text(r, json, name);
    for (int i = 0; i < count; i++)
        if (strcmp(names[i], value) == 0)
            return i;
    refuse(r, "%s is none that there is", name);
    return 0;
}

/* An array of that many; NULL after a refusal. */
static const cJSON *array(reader *r, const cJSON *json, const char *name, int min, int max)
{
    const cJSON *list = member(json, name);
    const int size = cJSON_IsArray(list) ? cJSON_GetArraySize(list) : -1;
    if (size < min || size > max)
        refuse(r, "%s is no list of %d to %d", name, min, max);
    return r->failed ? NULL : list;
}

static const cJSON *object(reader *r, const cJSON *json, const char *name)
{
    const cJSON *item = member(json, name);
    if (!cJSON_IsObject(item))
        refuse(r, "%s is missing", name);
    return item;
}

static void rgb(reader *r, const cJSON *json, const char *name, uint8_t values[3])
{
    const cJSON *list = array(r, json, name, 3, 3);
    for (int i = 0; list != NULL && i < 3; i++)
        values[i] = (uint8_t)integer_of(r, cJSON_GetArrayItem(list, i), name, 0, GLINT_COLOR_MAX);
}

/* ---- The parts ----------------------------------------------------------------------------------
 */

static void read_setting(reader *r, const cJSON *json)
{
    static const char *const circuits[] = {"specular", "divider"};
    const char *gates[GLINT_GATE_COUNT];
    const char *pipelines[GLINT_PIPELINE_COUNT];
    const char *forms[GLINT_DIVIDER_FORM_COUNT];
    for (int i = 0; i < GLINT_GATE_COUNT; i++)
        gates[i] = glint_gate_name((glint_gate)i);
    for (int i = 0; i < GLINT_PIPELINE_COUNT; i++)
        pipelines[i] = glint_pipeline_name((glint_pipeline)i);
    for (int i = 0; i < GLINT_DIVIDER_FORM_COUNT; i++)
        forms[i] = glint_divider_form_name((glint_divider_form)i);
    glint_setting *setting = &r->failure->setting;
    glint_error why;
    setting->is_divider = choice(r, json, "circuit", circuits, 2) == 1;
    if (setting->is_divider) {
        setting->form =
            (glint_divider_form)choice(r, json, "form", forms, GLINT_DIVIDER_FORM_COUNT);
        setting->shifts = (int)integer(r, json, "shifts", 0, 64);
    } else {
        setting->specular.gate = (glint_gate)choice(r, json, "gate", gates, GLINT_GATE_COUNT);
        setting->specular.pipeline =
            (glint_pipeline)choice(r, json, "pipeline", pipelines, GLINT_PIPELINE_COUNT);
        setting->specular.lanes = (int)integer(r, json, "lanes", 0, GLINT_LANES_MAX);
    }
    if (!r->failed && glint_setting_check(setting, &why) != GLINT_OK)
        refuse(r, "%s", why.text);
}

static void read_mismatch(reader *r, const cJSON *json, glint_mismatch *mismatch)
{
    const glint_setting *setting = &r->failure->setting;
    const char *name = text(r, json, "signal");
    const int lane = (int)integer(r, json, glint_setting_lane_name(setting), -1, 64);
    int i = 0;
    const int count = glint_setting_signal_count(setting);
    for (; i < count; i++) {
        mismatch->signal = glint_setting_signal(setting, i);
        if (strcmp(mismatch->signal.name, name) == 0 && mismatch->signal.lane == lane)
            break;
    }
    if (i == count)
        refuse(r, "a mismatch is of no signal that the circuit has");
    mismatch->clock = r->failure->finding.clock;
    mismatch->model = exact(r, json, "model", 16);
    mismatch->rtl = exact(r, json, "rtl", 16);
}

static void read_finding(reader *r, const cJSON *json)
{
    glint_failure_finding *finding = &r->failure->finding;
    const cJSON *from = object(r, json, "found");
    finding->lockstep_differs = boolean(r, from, "lockstep_differs");
    finding->clock = (uint64_t)integer(r, from, "clock", 0, CLOCK_MAX);
    const cJSON *list = array(r, from, "mismatches", 0, GLINT_MISMATCHES_KEPT);
    const cJSON *entry;
    cJSON_ArrayForEach(entry, list)
    {
        if (!r->failed)
            read_mismatch(r, entry, &finding->mismatch[finding->count++]);
    }
    if (!r->failure->has_answer)
        return;
    finding->answer_differs = boolean(r, from, "answer_differs");
    finding->model = (int32_t)integer(r, from, "answer_model", INT32_MIN, INT32_MAX);
    finding->rtl = (int32_t)integer(r, from, "answer_rtl", INT32_MIN, INT32_MAX);
}

/* In the order of the values of each clock: what has other names is of another circuit. */
static void check_names(reader *r, const cJSON *json)
{
    const glint_setting *setting = &r->failure->setting;
    const int count = glint_pin_count(setting);
    const cJSON *list = array(r, json, "names", count, count);
    for (int i = 0; list != NULL && i < count; i++) {
        const char *name = cJSON_GetStringValue(cJSON_GetArrayItem(list, i));
        const char *pin = glint_pin(setting, i).name;
        if (name == NULL || strcmp(name, pin) != 0)
            refuse(r, "pin %d of names is not %s", i + 1, pin);
    }
}

static void read_clock(reader *r, const cJSON *values, glint_pins *pins)
{
    const glint_setting *setting = &r->failure->setting;
    const int count = glint_pin_count(setting);
    if (!cJSON_IsArray(values) || cJSON_GetArraySize(values) != count) {
        refuse(r, "a clock does not have %d pins", count);
        return;
    }
    const cJSON *value = values->child;
    for (int i = 0; i < count && !r->failed; i++, value = value->next) {
        const glint_pin_info pin = glint_pin(setting, i);
        glint_pin_set(setting, pins, i, integer_of(r, value, pin.name, pin.min, pin.max));
    }
}

/* A random run without pins is played from its seed. */
static void read_pins(reader *r, const cJSON *json)
{
    glint_failure *failure = r->failure;
    const cJSON *from = member(json, "pins");
    failure->first_clock = 1;
    if (from == NULL || r->failed)
        return;
    failure->first_clock = (uint64_t)integer(r, from, "first_clock", 1, CLOCK_MAX);
    check_names(r, from);
    const cJSON *clocks = array(r, from, "clocks", 1, PINS_MAX);
    if (clocks == NULL)
        return;
    failure->pins = calloc((size_t)cJSON_GetArraySize(clocks), sizeof *failure->pins);
    if (failure->pins == NULL) {
        refuse(r, "no memory for its pins");
        return;
    }
    const cJSON *clock;
    cJSON_ArrayForEach(clock, clocks)
    {
        if (!r->failed)
            read_clock(r, clock, &failure->pins[failure->pin_count++]);
    }
}

static glint_material read_material(reader *r, const cJSON *json)
{
    uint8_t colors[3] = {0};
    const uint16_t n = (uint16_t)integer(r, json, "n", 0, GLINT_N_MAX);
    rgb(r, json, "rgb", colors);
    return (glint_material){n, colors[0], colors[1], colors[2]};
}

static void read_cosines(reader *r, const cJSON *json, glint_answer *answer)
{
    const cJSON *list = array(r, json, "cosines", 1, GLINT_ANSWER_POINTS);
    const cJSON *code;
    cJSON_ArrayForEach(code, list)
    {
        answer->cos_code[answer->count++] =
            (uint32_t)integer_of(r, code, "cosines", 0, GLINT_COS_CODE_MAX);
    }
    answer->material = read_material(r, json);
}

static void read_divisions(reader *r, const cJSON *json, glint_answer *answer)
{
    const cJSON *list = array(r, json, "divisions", 1, GLINT_ANSWER_DIVISIONS);
    const cJSON *values;
    cJSON_ArrayForEach(values, list)
    {
        glint_division *division = &answer->division[answer->count++];
        for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
            division->difference[c] =
                (int16_t)integer_of(r, cJSON_GetArrayItem(values, c), "divisions",
                                    -GLINT_DIVIDER_DIFFERENCE_MAX, GLINT_DIVIDER_DIFFERENCE_MAX);
        division->k = (uint8_t)integer_of(r, cJSON_GetArrayItem(values, GLINT_DIVIDER_COMPONENTS),
                                          "divisions", 0, (1 << GLINT_DIVIDER_K_BITS) - 1);
    }
}

static void read_answer(reader *r, const cJSON *json)
{
    const char *values[GLINT_ANSWER_VALUES];
    for (int i = 0; i < GLINT_ANSWER_VALUES; i++)
        values[i] = glint_answer_value_name((glint_answer_value)i);
    glint_answer *answer = &r->failure->answer;
    const cJSON *from = member(json, "answer");
    r->failure->has_answer = from != NULL;
    if (from == NULL)
        return;
    answer->is_divider = r->failure->setting.is_divider;
    answer->value = (glint_answer_value)choice(r, from, "value", values, GLINT_ANSWER_VALUES);
    if (answer->is_divider && answer->value == GLINT_ANSWER_W)
        refuse(r, "value is none that a divider has");
    answer->model = (int32_t)integer(r, from, "model", INT32_MIN, INT32_MAX);
    answer->rtl = (int32_t)integer(r, from, "rtl", INT32_MIN, INT32_MAX);
    if (answer->is_divider)
        read_divisions(r, from, answer);
    else
        read_cosines(r, from, answer);
    answer->at = (int)integer(r, from, "at", 0, answer->count - 1);
}

static void read_corners(reader *r, const cJSON *json, glint_failure_frame *frame)
{
    const cJSON *corners = array(r, json, "corners", 3, 3);
    for (int i = 0; corners != NULL && i < 3; i++)
        for (int c = 0; c < 3; c++) {
            const cJSON *value = cJSON_GetArrayItem(cJSON_GetArrayItem(corners, i), c);
            if (!cJSON_IsNumber(value) || !(fabs(value->valuedouble) <= 1e30))
                refuse(r, "corners are no coordinates");
            else
                frame->corner[i][c] = (float)value->valuedouble;
        }
}

static void read_frame(reader *r, const cJSON *json)
{
    glint_failure_frame *frame = &r->failure->frame;
    const cJSON *from = object(r, json, "frame");
    frame->width = (int)integer(r, from, "width", 1, SIDE_MAX);
    frame->height = (int)integer(r, from, "height", 1, SIDE_MAX);
    frame->has_pixel = member(from, "x") != NULL;
    if (!frame->has_pixel && r->failure->has_answer)
        refuse(r, "x is missing");
    if (!frame->has_pixel)
        return;
    frame->x = (int)integer(r, from, "x", 0, frame->width - 1);
    frame->y = (int)integer(r, from, "y", 0, frame->height - 1);
    rgb(r, from, "model", frame->model);
    rgb(r, from, "rtl", frame->rtl);
    frame->has_triangle = member(from, "triangle") != NULL;
    if (frame->has_triangle) {
        frame->triangle = (uint32_t)integer(r, from, "triangle", 0, UINT32_MAX);
        read_corners(r, from, frame);
    }
    const cJSON *fragment = member(from, "fragment");
    frame->has_fragment = fragment != NULL;
    if (frame->has_fragment) {
        frame->cos_code = (uint32_t)integer(r, fragment, "cosine", 0, GLINT_COS_CODE_MAX);
        frame->material = read_material(r, fragment);
    }
}

/* The clock that differed is to be among those that are played. */
static void check_clock(reader *r)
{
    const glint_failure *failure = r->failure;
    const uint64_t clock = failure->finding.clock;
    if ((failure->kind != GLINT_FAILURE_RANDOM && failure->pins == NULL) || r->failed)
        return;
    if (clock < failure->first_clock ||
        (failure->pins != NULL && clock - failure->first_clock >= failure->pin_count))
        refuse(r, "clock %" PRIu64 " is not among those of the pins", clock);
}

/* It is printed as it is: nothing in it may work on a terminal. */
static void read_command(reader *r, const cJSON *json)
{
    const char *command = text(r, json, "command");
    for (const char *c = command; *c != '\0'; c++)
        if ((unsigned char)*c < 0x20 || *c == 0x7f)
            refuse(r, "command holds what is no printed character");
    (void)snprintf(r->failure->command, sizeof r->failure->command, "%s", command);
}

/* What may stand in a message as it is. */
static bool is_plain(const char *name)
{
    const size_t length = strspn(name, "abcdefghijklmnopqrstuvwxyz_");
    return name[length] == '\0' && length != 0 && length <= 40;
}

/* Of two values of one name no reader knows which is meant. */
static void check_names_once(reader *r, const cJSON *json)
{
    const cJSON *item;
    int members = 0;
    cJSON_ArrayForEach(item, json)
    {
        if (r->failed)
            return;
        if (cJSON_IsObject(json) && ++members > MEMBERS_MAX)
            refuse(r, "an object has more than %d members", MEMBERS_MAX);
        for (const cJSON *other = item->next; cJSON_IsObject(json) && other != NULL && !r->failed;
             other = other->next)
            if (strcmp(item->string, other->string) == 0)
                refuse(r, "%s is there twice", is_plain(item->string) ? item->string : "a name");
        check_names_once(r, item);
    }
}

static void read_all(reader *r, const cJSON *json)
{
    glint_failure *failure = r->failure;
    check_names_once(r, json);
    if (strcmp(text(r, json, "format"), GLINT_JSON_FORMAT) != 0)
        refuse(r, "it is no failure packet's");
    if (integer(r, json, "version", 0, INT32_MAX) != GLINT_JSON_VERSION)
        refuse(r, "it is of another version than %d", GLINT_JSON_VERSION);
    failure->kind =
        (glint_failure_kind)choice(r, json, "kind", glint_failure_kind_names, GLINT_FAILURE_KINDS);
    read_command(r, json);
    read_setting(r, json);
    if (r->failed)
        return;
    if (failure->kind == GLINT_FAILURE_RANDOM)
        failure->seed = exact(r, json, "seed", 10);
    else
        read_answer(r, json);
    read_pins(r, json);
    if (failure->kind == GLINT_FAILURE_EXHAUSTIVE && !glint_failure_playable(failure))
        refuse(r, "answer is missing");
    if (failure->kind == GLINT_FAILURE_FRAME)
        read_frame(r, json);
    read_finding(r, json);
    check_clock(r);
}

glint_status glint_failure_from_json(const char *text, glint_failure **failure, glint_error *err)
{
    *failure = NULL;
    cJSON *json = cJSON_ParseWithOpts(text, NULL, 1);
    if (json == NULL)
        return glint_fail(err, GLINT_BAD_INPUT, "it is no whole JSON");
    reader r = {.failure = calloc(1, sizeof *r.failure), .err = err};
    if (r.failure == NULL) {
        cJSON_Delete(json);
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for a failure");
    }
    read_all(&r, json);
    cJSON_Delete(json);
    if (r.failed) {
        glint_failure_destroy(r.failure);
        return GLINT_BAD_INPUT;
    }
    *failure = r.failure;
    return GLINT_OK;
}
