#include "lockstep/divider_lockstep.h"

#include <string.h>

#include "file/room.h"
#include "lockstep/mismatch.h"
#include "wave/waveform.h"

void glint_divider_stimulus_init(glint_divider_stimulus *stimulus, uint64_t seed)
{
    *stimulus = (glint_divider_stimulus){.random = {seed}};
}

static uint32_t pick(glint_random *random, const uint32_t *choices, uint32_t count)
{
    return choices[glint_random_below(random, count)];
}

/* Time is cut into phases, each with its own mood, as for the specular device. */
static void begin_phase(glint_divider_stimulus *s)
{
    static const uint32_t starts[] = {16, 64, 128, 255, 256};
    static const uint32_t rare_to_often[] = {0, 0, 16, 64, 160};
    s->clocks_left = 32 + glint_random_below(&s->random, 224);
    s->start_chance = pick(&s->random, starts, 5);
    s->stall_chance = pick(&s->random, rare_to_often, 5);
    s->miss_chance = pick(&s->random, rare_to_often, 5);
    s->reset_chance = glint_random_chance(&s->random, 32) ? 8 : 0;
}

/* 0, the first beyond the table, or any other. */
static uint32_t random_miss(glint_random *random)
{
    const uint32_t first = GLINT_DIVIDER_K_MAX + 1u;
    if (glint_random_chance(random, 64))
        return 0;
    if (glint_random_chance(random, 64))
        return first;
    return first + glint_random_below(random, (1u << GLINT_DIVIDER_K_BITS) - first);
}

static uint8_t random_k(glint_divider_stimulus *s)
{
    if (glint_random_chance(&s->random, s->miss_chance))
        return (uint8_t)random_miss(&s->random);
    return (uint8_t)(1 + glint_random_below(&s->random, GLINT_DIVIDER_K_MAX));
}

static int16_t random_difference(glint_random *random)
{
    static const int16_t corners[] = {0, 1, -1, GLINT_DIVIDER_DIFFERENCE_MAX,
                                      -GLINT_DIVIDER_DIFFERENCE_MAX};
    if (glint_random_chance(random, 64))
        return corners[glint_random_below(random, 5)];
    return (int16_t)((int)glint_random_below(random, 2 * GLINT_DIVIDER_DIFFERENCE_MAX + 1) -
                     GLINT_DIVIDER_DIFFERENCE_MAX);
}

void glint_divider_stimulus_next(glint_divider_stimulus *s, glint_divider_inputs *in)
{
    if (s->clocks_left == 0)
        begin_phase(s);
    s->clocks_left--;

    memset(in, 0, sizeof *in);
    in->reset = glint_random_chance(&s->random, s->reset_chance);
    in->en = !glint_random_chance(&s->random, s->stall_chance);
    in->start = glint_random_chance(&s->random, s->start_chance);
    in->k = random_k(s);
    for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
        in->difference[c] = random_difference(&s->random);
}

typedef struct pair {
    const glint_divider_lockstep_options *options;
    glint_divider_device *model;
    glint_divider_rtl *rtl;
    glint_divider_stimulus stimulus;
    glint_divider_inputs inputs;
    int signal_count;
} pair;

static glint_status create_rtl(const glint_divider_lockstep_options *options,
                               glint_divider_rtl **rtl, glint_error *err)
{
    if (options->model != NULL)
        return glint_divider_rtl_create_from(options->model, rtl, err);
    return glint_divider_rtl_create(options->form, options->shifts, rtl, err);
}

static glint_status create_pair(pair *pair, const glint_divider_lockstep_options *options,
                                glint_error *err)
{
    memset(pair, 0, sizeof *pair);
    pair->options = options;
    glint_divider_stimulus_init(&pair->stimulus, options->seed);
    glint_status status = glint_divider_device_create(options->form, options->shifts, &pair->model);
    if (status != GLINT_OK)
        return glint_fail(err, status, "no divider of %d shifts", options->shifts);
    pair->signal_count = glint_divider_signal_count(options->form, options->shifts);
    return create_rtl(options, &pair->rtl, err);
}

static void destroy_pair(pair *pair)
{
    glint_divider_device_destroy(pair->model);
    glint_divider_rtl_destroy(pair->rtl);
}

static void clock_pair(pair *pair)
{
    glint_divider_stimulus_next(&pair->stimulus, &pair->inputs);
    glint_divider_device_clock(pair->model, &pair->inputs);
    glint_divider_rtl_clock(pair->rtl, &pair->inputs);
}

static void compare_pair(const pair *pair, glint_lockstep_result *found)
{
    const glint_divider_lockstep_options *options = pair->options;
    for (int i = 0; i < pair->signal_count; i++) {
        uint64_t model = glint_divider_signal_bits(pair->model, i);
        uint64_t rtl = glint_divider_rtl_signal_bits(pair->rtl, i);
        if (model != rtl) {
            glint_signal_info signal = glint_divider_signal_info(options->form, options->shifts, i);
            glint_mismatch_keep(found, &signal, model, rtl);
        }
    }
    found->comparisons += (uint64_t)pair->signal_count;
}

/* Drops pins from before the last `latency` + 1 edges that were not stalled: a division that was
 * taken there has come out. */
static void forget_old_pins(glint_divider_lockstep_result *result, int latency)
{
    int first = result->history_count, edges = 0;
    while (first > 0 && edges <= latency) {
        first--;
        edges += result->history[first].en != 0 || result->history[first].reset != 0;
    }
    result->history_count -= first;
    memmove(&result->history[0], &result->history[first],
            (size_t)result->history_count * sizeof result->history[0]);
}

/* The pins up to the first mismatch; afterwards they are left as they are. */
static void keep_history(glint_divider_lockstep_result *result, const pair *pair)
{
    if (result->found.mismatches != 0)
        return;
    if (result->history_count == GLINT_HISTORY)
        forget_old_pins(result, glint_divider_latency(pair->options->shifts));
    if (result->history_count == GLINT_HISTORY) { /* a stall longer than the history */
        result->history_count--;
        memmove(&result->history[0], &result->history[1],
                (GLINT_HISTORY - 1) * sizeof result->history[0]);
    }
    result->history[result->history_count++] = pair->inputs;
}

static bool stopped(const glint_divider_lockstep_options *options)
{
    return options->stop != NULL && *options->stop;
}

glint_status glint_divider_lockstep_run(const glint_divider_lockstep_options *options,
                                        glint_divider_lockstep_result *result, glint_error *err)
{
    pair pair;
    memset(result, 0, sizeof *result);
    if (options->clocks == 0)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "0 clocks would compare nothing");
    glint_status status = create_pair(&pair, options, err);
    while (status == GLINT_OK && result->found.clocks < options->clocks) {
        clock_pair(&pair);
        result->found.clocks++;
        keep_history(result, &pair);
        compare_pair(&pair, &result->found);
        if (result->found.clocks % 1024 == 0) {
            if (options->progress != NULL)
                options->progress(options->progress_context, result->found.clocks, options->clocks);
            if (stopped(options))
                status = glint_fail(err, GLINT_INTERRUPTED, "interrupted");
        }
    }
    if (status == GLINT_OK || status == GLINT_INTERRUPTED)
        forget_old_pins(result, glint_divider_latency(options->shifts));
    destroy_pair(&pair);
    return status;
}

glint_status glint_divider_lockstep_trace(const glint_divider_lockstep_options *options,
                                          const char *path, uint64_t first, uint64_t last,
                                          glint_error *err)
{
    glint_divider_rtl *rtl = NULL;
    glint_divider_stimulus stimulus;
    glint_divider_inputs inputs;
    glint_divider_stimulus_init(&stimulus, options->seed);
    glint_status status = create_rtl(options, &rtl, err);
    for (uint64_t clock = 1; status == GLINT_OK && clock <= last; clock++) {
        if (clock == first)
            status = glint_file_room(path, GLINT_WAVE_ROOM, err);
        if (clock == first && status == GLINT_OK)
            status = glint_divider_rtl_trace_open(rtl, path, err);
        glint_divider_stimulus_next(&stimulus, &inputs);
        glint_divider_rtl_clock(rtl, &inputs);
        if (clock % 1024 == 0 && stopped(options))
            status = glint_fail(err, GLINT_INTERRUPTED, "interrupted");
    }
    glint_divider_rtl_destroy(rtl);
    return status;
}
