#include "lockstep/lockstep.h"

#include <string.h>

#include "file/room.h"
#include "lockstep/mismatch.h"
#include "lockstep/stimulus.h"
#include "wave/waveform.h"

typedef struct pair {
    const glint_specular_config *config;
    glint_specular_device *model;
    glint_rtl *rtl;
    glint_stimulus stimulus;
    glint_specular_inputs inputs;
    int signal_count;
} pair;

static glint_status create_rtl(const glint_lockstep_options *options, glint_rtl **rtl,
                               glint_error *err)
{
    if (options->model != NULL)
        return glint_rtl_create_from(options->model, &options->config, rtl, err);
    return glint_rtl_create(&options->config, rtl, err);
}

static glint_status create_pair(pair *pair, const glint_lockstep_options *options, glint_error *err)
{
    memset(pair, 0, sizeof *pair);
    pair->config = &options->config;
    glint_stimulus_init(&pair->stimulus, options->seed, options->config.lanes);
    glint_status status = glint_specular_device_create(&options->config, &pair->model);
    if (status != GLINT_OK)
        return glint_fail(err, status, "cannot create the C model of these settings");
    pair->signal_count = glint_specular_signal_count(&options->config);
    return create_rtl(options, &pair->rtl, err);
}

static void destroy_pair(pair *pair)
{
    glint_specular_device_destroy(pair->model);
    glint_rtl_destroy(pair->rtl);
}

static void clock_pair(pair *pair)
{
    glint_stimulus_next(&pair->stimulus, &pair->inputs);
    glint_specular_device_clock(pair->model, &pair->inputs);
    glint_rtl_clock(pair->rtl, &pair->inputs);
}

static void compare_pair(const pair *pair, glint_lockstep_result *result)
{
    const glint_specular_signals *signals = glint_specular_device_signals(pair->model);
    for (int i = 0; i < pair->signal_count; i++) {
        uint64_t model = glint_specular_signal_bits(pair->config, signals, i);
        uint64_t rtl = glint_rtl_signal_bits(pair->rtl, i);
        if (model != rtl) {
            glint_signal_info signal = glint_specular_signal_info(pair->config, i);
            glint_mismatch_keep(result, &signal, model, rtl);
        }
    }
    result->comparisons += (uint64_t)pair->signal_count;
}

/* Drops the oldest pins, keeping what they wrote into the material. */
static void forget_pins(glint_lockstep_result *result, int count)
{
    for (int i = 0; i < count; i++) {
        const glint_specular_inputs *in = &result->history[i];
        if (in->reset)
            result->material = (glint_material){0};
        else if (in->en && in->n_we)
            result->material.n = in->n;
        if (!in->reset && in->en && in->rgb_we) {
            result->material.r = in->r;
            result->material.g = in->g;
            result->material.b = in->b;
        }
    }
    result->history_count -= count;
    result->history_clock += (uint64_t)count;
    memmove(&result->history[0], &result->history[count],
            (size_t)result->history_count * sizeof result->history[0]);
}

/* Drops the pins from before the last `latency` + 1 edges that were not stalled: no point that
 * entered there is still in flight. */
static void forget_old_pins(glint_lockstep_result *result, int latency)
{
    int first = result->history_count, edges = 0;
    while (first > 0 && edges <= latency) {
        first--;
        edges += result->history[first].en != 0 || result->history[first].reset != 0;
    }
    forget_pins(result, first);
}

/* The pins up to the first mismatch; afterwards they are left as they are. */
static void keep_history(glint_lockstep_result *result, const pair *pair)
{
    if (result->mismatches != 0)
        return;
    if (result->history_count == GLINT_HISTORY)
        forget_old_pins(result, glint_specular_latency(pair->config->pipeline));
    if (result->history_count == GLINT_HISTORY) /* a stall longer than the history */
        forget_pins(result, 1);
    result->history[result->history_count++] = pair->inputs;
}

static bool stopped(const glint_lockstep_options *options)
{
    return options->stop != NULL && *options->stop;
}

glint_status glint_lockstep_run(const glint_lockstep_options *options,
                                glint_lockstep_result *result, glint_error *err)
{
    pair pair;
    memset(result, 0, sizeof *result);
    result->history_clock = 1;
    if (options->clocks == 0)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "0 clocks would compare nothing");
    glint_status status = create_pair(&pair, options, err);
    while (status == GLINT_OK && result->clocks < options->clocks) {
        clock_pair(&pair);
        result->clocks++;
        keep_history(result, &pair);
        compare_pair(&pair, result);
        if (result->clocks % 1024 == 0) {
            if (options->progress != NULL)
                options->progress(options->progress_context, result->clocks, options->clocks);
            if (stopped(options))
                status = glint_fail(err, GLINT_INTERRUPTED, "interrupted");
        }
    }
    if (status == GLINT_OK || status == GLINT_INTERRUPTED)
        forget_old_pins(result, glint_specular_latency(options->config.pipeline));
    destroy_pair(&pair);
    return status;
}

glint_status glint_lockstep_trace(const glint_lockstep_options *options, const char *path,
                                  uint64_t first, uint64_t last, glint_error *err)
{
    glint_rtl *rtl = NULL;
    glint_stimulus stimulus;
    glint_specular_inputs inputs;
    glint_stimulus_init(&stimulus, options->seed, options->config.lanes);
    glint_status status = create_rtl(options, &rtl, err);
    for (uint64_t clock = 1; status == GLINT_OK && clock <= last; clock++) {
        if (clock == first)
            status = glint_file_room(path, GLINT_WAVE_ROOM, err);
        if (clock == first && status == GLINT_OK)
            status = glint_rtl_trace_open(rtl, path, err);
        glint_stimulus_next(&stimulus, &inputs);
        glint_rtl_clock(rtl, &inputs);
        if (clock % 1024 == 0 && stopped(options))
            status = glint_fail(err, GLINT_INTERRUPTED, "interrupted");
    }
    glint_rtl_destroy(rtl);
    return status;
}
