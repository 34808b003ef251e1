/* Points of the specular device and of the other highlight units: answer_kind.h. */
#include <string.h>

#include "circuit/units.h"
#include "lockstep/answer_kind.h"
#include "rtl/batch.h"

_Static_assert(sizeof(glint_specular_inputs) <= sizeof(glint_pins), "its pins fit");

static size_t lanes_of(const glint_setting *setting)
{
    return (size_t)glint_highlight_lanes(setting);
}

static size_t feeding_clocks(const glint_setting *setting, size_t count)
{
    return (count + lanes_of(setting) - 1) / lanes_of(setting);
}

static bool out_when_fed(const glint_setting *setting)
{
    (void)setting;
    return false;
}

static void put(const glint_setting *setting, const glint_batch *batch, size_t clock,
                glint_pins *pins)
{
    const size_t lanes = lanes_of(setting);
    glint_specular_inputs in = {.en = 1};
    if (clock == 0) {
        in.n_we = in.rgb_we = 1;
        in.n = batch->material->n;
        in.r = batch->material->r;
        in.g = batch->material->g;
        in.b = batch->material->b;
    }
    for (size_t lane = 0; lane < lanes && clock * lanes + lane < batch->count; lane++) {
        in.cos[lane] = batch->cos_code[clock * lanes + lane];
        in.in_valid |= UINT32_C(1) << lane;
    }
    memcpy(pins, &in, sizeof in);
}

static void batch_of(const glint_answer *answer, glint_batch *batch)
{
    batch->material = &answer->material;
    batch->cos_code = answer->cos_code;
}

static void alone_of(const glint_answer *answer, const glint_setting *setting, glint_answer *alone)
{
    alone->material = answer->material;
    alone->at = answer->at % (int)lanes_of(setting);
    alone->count = alone->at + 1;
    for (int i = 0; i < alone->count; i++)
        alone->cos_code[i] = answer->cos_code[answer->at];
}

typedef struct highlights {
    uint32_t w[GLINT_ANSWER_POINTS];
    uint8_t r[GLINT_ANSWER_POINTS], g[GLINT_ANSWER_POINTS], b[GLINT_ANSWER_POINTS];
} highlights;

static int32_t value_of(const highlights *of, const glint_answer *answer)
{
    switch (answer->value) {
    case GLINT_ANSWER_R:
        return of->r[answer->at];
    case GLINT_ANSWER_G:
        return of->g[answer->at];
    case GLINT_ANSWER_B:
        return of->b[answer->at];
    default:
        return (int32_t)of->w[answer->at];
    }
}

static glint_status ask(const glint_answer *answer, const glint_setting *setting, int32_t *model,
                        int32_t *rtl, glint_error *err)
{
    highlights found;
    glint_rtl *circuit = NULL;
    const glint_points points = {answer->cos_code, (size_t)answer->count, found.w, found.r, found.g,
                                 found.b};
    glint_status status =
        glint_highlight_batch(setting, &answer->material, points.cos, points.count, points.w,
                              points.r, points.g, points.b);
    if (status != GLINT_OK)
        return glint_fail(err, status, "the C model rejects n = %u", answer->material.n);
    *model = value_of(&found, answer);
    status = glint_rtl_open(setting, GLINT_RTL_FAST, &circuit, err);
    if (status == GLINT_OK)
        status = glint_rtl_shade(circuit, &answer->material, &points, err);
    glint_rtl_destroy(circuit);
    if (status == GLINT_OK)
        *rtl = value_of(&found, answer);
    return status;
}

static uint64_t clock_taken(const glint_answer *answer, const glint_setting *setting)
{
    return (uint64_t)answer->at / lanes_of(setting) + 1;
}

static bool is_output(const glint_answer *answer, const glint_setting *setting,
                      const glint_signal_info *signal)
{
    static const char *const outputs[] = {"out_w", "out_r", "out_g", "out_b"};
    return strcmp(signal->name, outputs[answer->value]) == 0 &&
           signal->lane == answer->at % (int)lanes_of(setting);
}

const glint_answer_kind glint_specular_answers = {
    .feeding_clocks = feeding_clocks,
    .out_when_fed = out_when_fed,
    .put = put,
    .batch = batch_of,
    .alone = alone_of,
    .ask = ask,
    .clock_taken = clock_taken,
    .is_output = is_output,
};
