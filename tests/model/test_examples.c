/* The worked example in the header of each module of rtl/, number by number, by the C model: one
 * that has gone stale fails here. (Those of the ROMs are generated with them.) */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../golden.h"
#include "../scratch.h"

#include "blocks.h"
#include "glint_divider_device.h"

enum { NUMBERS_MAX = 32, NAME_SIZE = 16 };

typedef struct number {
    char name[NAME_SIZE];
    long value;
} number;

typedef struct example {
    const char *module;
    number list[NUMBERS_MAX];
    int count;
} example;

/* The value of a name; the example must have it. */
static long given(const example *e, const char *name)
{
    for (int i = 0; i < e->count; i++)
        if (strcmp(e->list[i].name, name) == 0)
            return e->list[i].value;
    fail_msg("rtl/%s.v: its example has no %s", e->module, name);
    return 0;
}

/* Each "name = number" of a text. */
static void read_numbers(const char *text, example *e)
{
    for (const char *sign = text; (sign = strstr(sign, " = ")) != NULL; sign += 3) {
        const char *name = sign;
        while (name > text && strchr(" (,\n", name[-1]) == NULL)
            name--;
        char *end;
        const long value = strtol(sign + 3, &end, 10);
        assert_true(end > sign + 3 && e->count < NUMBERS_MAX && sign - name < NAME_SIZE);
        number *n = &e->list[e->count++];
        (void)snprintf(n->name, sizeof n->name, "%.*s", (int)(sign - name), name);
        n->value = value;
    }
}

/* The lines from "// Example" to the next heading, or to the end of the header. */
static example read_example(const char *module)
{
    example e = {.module = module};
    char path[64];
    (void)snprintf(path, sizeof path, "rtl/%s.v", module);
    char *text = scratch_read(path, NULL);
    char *begin = strstr(text, "\n// Example ");
    if (begin == NULL)
        fail_msg("%s: no example", path);
    char *end = strchr(begin + 1, '\n');
    while (end != NULL && strncmp(end, "\n//   ", 6) == 0)
        end = strchr(end + 1, '\n');
    assert_non_null(end);
    *end = '\0';
    read_numbers(begin, &e);
    free(text);
    return e;
}

/* Every number of the example, but for the inputs, is one of these. */
static void compare(const example *e, const number *model, size_t count, int inputs)
{
    assert_true(e->count > inputs);
    for (int i = inputs; i < e->count; i++) {
        size_t at = 0;
        while (at < count && strcmp(model[at].name, e->list[i].name) != 0)
            at++;
        if (at == count)
            fail_msg("rtl/%s.v: the model has no %s", e->module, e->list[i].name);
        if (model[at].value != e->list[i].value)
            fail_msg("rtl/%s.v: %s = %ld in its example, %ld by the model", e->module,
                     e->list[i].name, e->list[i].value, model[at].value);
    }
}

static void specular(const char *module)
{
    const example e = read_example(module);
    const glint_material material = {.n = (uint16_t)given(&e, "n"),
                                     .r = (uint8_t)given(&e, "r"),
                                     .g = (uint8_t)given(&e, "g"),
                                     .b = (uint8_t)given(&e, "b")};
    glint_specular_values v;
    assert_int_equal(
        glint_specular_eval(GLINT_GATE_COSINE, &material, (uint32_t)given(&e, "cos"), &v),
        GLINT_OK);
    const number model[] = {
        {"reg1", v.reg1},     {"rom33", v.rom33},   {"rom9", v.rom9},   {"adder6", v.adder6},
        {"mul7", v.mul7},     {"adder8", v.adder8}, {"cmp11", v.cmp11}, {"mul10", (long)v.mul10},
        {"keys12", v.keys12}, {"out_w", v.keys12},  {"mul13", v.mul13}, {"mul14", v.mul14},
        {"mul15", v.mul15},   {"out_r", v.mul13},   {"out_g", v.mul14}, {"out_b", v.mul15},
    };
    compare(&e, model, sizeof model / sizeof model[0], 5);
}

static void of_the_device(void **state)
{
    (void)state;
    specular("specular_device");
    specular("specular_lane");
}

static void of_a_color_multiplier(void **state)
{
    (void)state;
    const example e = read_example("color_multiplier");
    const number model[] = {
        {"product", glint_block_mul_color((uint32_t)given(&e, "w"), (uint8_t)given(&e, "color"))}};
    compare(&e, model, 1, 2);
}

/* A divider that has taken the inputs, as many clocks ago as it now has had but one. */
static glint_divider_device *divider(glint_divider_form form, int shifts,
                                     glint_divider_inputs inputs, int clocks)
{
    glint_divider_device *device;
    assert_int_equal(glint_divider_device_create(form, shifts, &device), GLINT_OK);
    inputs.en = inputs.start = 1;
    for (int clock = 0; clock < clocks; clock++) {
        glint_divider_device_clock(device, &inputs);
        inputs.start = 0;
    }
    return device;
}

static void of_the_sequential_divider(void **state)
{
    (void)state;
    const example e = read_example("shift_divider");
    const int shifts = (int)given(&e, "SHIFTS");
    const glint_divider_inputs inputs = {.k = (uint8_t)given(&e, "k"),
                                         .difference = {(int16_t)given(&e, "difference")}};
    glint_divider_device *device =
        divider(GLINT_DIVIDER_SEQUENTIAL, shifts, inputs, glint_divider_latency(shifts));
    const glint_divider_sequential_signals *s = glint_divider_device_sequential(device);
    const number model[] = {
        {"rom_bits", s->rom_bits}, {"done", s->done}, {"quotient", s->quotient}};
    compare(&e, model, sizeof model / sizeof model[0], 3);
    glint_divider_device_destroy(device);
}

static void of_the_pipelined_divider(void **state)
{
    (void)state;
    const example e = read_example("pipelined_divider");
    const int shifts = (int)given(&e, "SHIFTS");
    const glint_divider_inputs inputs = {.k = (uint8_t)given(&e, "k"),
                                         .difference = {(int16_t)given(&e, "difference_r"),
                                                        (int16_t)given(&e, "difference_g"),
                                                        (int16_t)given(&e, "difference_b")}};
    glint_divider_device *device =
        divider(GLINT_DIVIDER_PIPELINED, shifts, inputs, glint_divider_latency(shifts));
    const glint_divider_pipelined_signals *s = glint_divider_device_pipelined(device);
    const number model[] = {{"rom_bits", s->rom_bits},
                            {"out_valid", s->out_valid},
                            {"quotient_r", s->quotient_r},
                            {"quotient_g", s->quotient_g},
                            {"quotient_b", s->quotient_b}};
    compare(&e, model, sizeof model / sizeof model[0], 5);
    glint_divider_device_destroy(device);
}

static void of_a_stage_of_it(void **state)
{
    (void)state;
    const example e = read_example("divider_stage");
    const long stage = given(&e, "STAGE");
    const glint_divider_inputs inputs = {.k = (uint8_t)given(&e, "k"),
                                         .difference = {(int16_t)given(&e, "in_d_r")}};
    glint_divider_device *device =
        divider(GLINT_DIVIDER_PIPELINED, (int)given(&e, "SHIFTS"), inputs, (int)stage);
    const glint_divider_pipelined_signals *s = glint_divider_device_pipelined(device);
    const glint_divider_stage_signals in = s->stage[stage - 1];
    glint_divider_device_clock(device, &(glint_divider_inputs){.en = 1});
    const number model[] = {{"in_bits", in.bits},
                            {"in_acc_r", in.acc_r},
                            {"d_r", s->stage[stage].d_r},
                            {"acc_r", s->stage[stage].acc_r}};
    compare(&e, model, sizeof model / sizeof model[0], 4);
    glint_divider_device_destroy(device);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_the_device),
        cmocka_unit_test(of_a_color_multiplier),
        cmocka_unit_test(of_the_sequential_divider),
        cmocka_unit_test(of_the_pipelined_divider),
        cmocka_unit_test(of_a_stage_of_it),
    };
    return golden_run_group_tests(tests, NULL, NULL);
}
