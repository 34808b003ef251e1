/* Exhaustive comparison for any circuit whose description names a domain; see domain.h. */
#define _POSIX_C_SOURCE 200809L

#include "lockstep/domain.h"

#include <inttypes.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/random.h"
#include "lockstep/mismatch.h"
#include "thread/crew.h"

/* The chosen points are first, first + step, …: `items` of them, `each` in a block. */
typedef struct plan {
    const glint_domain_options *options;
    uint64_t total; /* points of the domain */
    uint64_t first, step, items;
    uint64_t each, blocks;
    uint64_t pace, idle; /* clocks per point; clocks after a block's last point */
    glint_pins rest;     /* nothing is taken */
    glint_pins asking;   /* what put() begins with */
} plan;

typedef struct work {
    plan plan;
    atomic_uint_fast64_t next; /* the first block that no thread has taken */
    atomic_uint_fast64_t done; /* points */
    atomic_bool failed;        /* a thread failed, so the others can stop */
} work;

typedef struct worker {
    work *work;
    uint64_t model[GLINT_SIGNAL_WORDS_MAX], rtl[GLINT_SIGNAL_WORDS_MAX];
    glint_domain_result found; /* its next: the number of the block that failed */
    glint_status status;
    glint_error err;
} worker;

uint64_t glint_domain_offset(const glint_domain_options *options)
{
    glint_random random = {options->seed};
    return glint_random_bits(&random) % options->stride;
}

/* ---- What there is to do ------------------------------------------------------------------------
 */

static void set_pin(const glint_pin_info *pin, glint_pins *pins, uint64_t value)
{
    const uint64_t words[GLINT_VALUE_WORDS] = {value};
    glint_pin_set(pin, pins, words);
}

static void make_pins(plan *plan)
{
    const glint_setting *setting = &plan->options->setting;
    memset(&plan->rest, 0, sizeof plan->rest);
    for (int i = 0; i < glint_setting_pin_count(setting); i++) {
        const glint_pin_info pin = glint_setting_pin(setting, i);
        if (pin.role == GLINT_PIN_ENABLE || pin.role == GLINT_PIN_RESET_LOW)
            set_pin(&pin, &plan->rest, 1);
    }
    plan->asking = plan->rest;
    for (int i = 0; i < glint_setting_pin_count(setting); i++) {
        const glint_pin_info pin = glint_setting_pin(setting, i);
        if (pin.role == GLINT_PIN_VALID)
            set_pin(&pin, &plan->asking, 1);
    }
}

static bool has_outputs(const glint_setting *setting)
{
    bool has = false;
    for (int i = 0; i < glint_setting_signal_count(setting); i++)
        has |= glint_signal_is_port(glint_setting_signal(setting, i).kind);
    return has;
}

static glint_status check_options(const glint_domain_options *options, glint_error *err)
{
    const glint_setting *setting = &options->setting;
    glint_status status = glint_setting_check(setting, err);
    if (status != GLINT_OK)
        return status;
    if (setting->circuit->domain == NULL)
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "circuit %s: its description has no domain to enumerate",
                          setting->circuit->name);
    if (!has_outputs(setting))
        return glint_fail(err, GLINT_BAD_ARGUMENT, "circuit %s: none of its signals is an output",
                          setting->circuit->name);
    if (options->shards < 1 || options->shard < 1 || options->shard > options->shards)
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "shard %" PRIu64 " of %" PRIu64 " does not exist", options->shard,
                          options->shards);
    if (options->stride < 1)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "a stride of 0 visits no point");
    if (options->threads < 1 || options->threads > GLINT_DOMAIN_THREADS_MAX)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "%d threads", options->threads);
    return GLINT_OK;
}

/* Of the points shard − 1 + shards·(offset + stride·i) those from `from` to before `total`. All of
 * it below 2^64: what is beyond the domain is left before it is multiplied. */
static void choose(plan *plan)
{
    const glint_domain_options *options = plan->options;
    const uint64_t in_shard =
        plan->total < options->shard ? 0 : (plan->total - options->shard) / options->shards + 1;
    const uint64_t offset = glint_domain_offset(options);
    const uint64_t chosen = in_shard > offset ? (in_shard - offset - 1) / options->stride + 1 : 0;
    plan->items = 0;
    if (chosen == 0)
        return;
    plan->first = options->shard - 1 + options->shards * offset;
    plan->step = chosen > 1 ? options->shards * options->stride : 1;
    const uint64_t before =
        options->from > plan->first ? (options->from - plan->first - 1) / plan->step + 1 : 0;
    if (before >= chosen)
        return;
    plan->first += before * plan->step;
    plan->items = chosen - before;
}

static void make_plan(plan *plan, const glint_domain_options *options)
{
    const glint_setting *setting = &options->setting;
    plan->options = options;
    plan->total = setting->circuit->domain->points(setting->values);
    plan->pace = (uint64_t)glint_setting_pace(setting);
    /* The point's own clock is the first of its latency. */
    plan->idle = (uint64_t)glint_setting_latency(setting) + 1;
    plan->each = GLINT_DOMAIN_BLOCK / plan->pace > 0 ? GLINT_DOMAIN_BLOCK / plan->pace : 1;
    choose(plan);
    plan->blocks = (plan->items + plan->each - 1) / plan->each;
    make_pins(plan);
}

static glint_status plan_all(plan *plan, const glint_domain_options *options, glint_error *err)
{
    const glint_status status = check_options(options, err);
    if (status != GLINT_OK)
        return status;
    make_plan(plan, options);
    if (plan->total == 0)
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "circuit %s: its description has no domain for this setting",
                          options->setting.circuit->name);
    if (plan->blocks == 0)
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "nothing to compare: shard %" PRIu64 "/%" PRIu64 " with stride %" PRIu64
                          " has no point from %" PRIu64 " to below %" PRIu64,
                          options->shard, options->shards, options->stride, options->from,
                          plan->total);
    return GLINT_OK;
}

static uint64_t items_of(const plan *plan, uint64_t block)
{
    const uint64_t left = plan->items - block * plan->each;
    return left < plan->each ? left : plan->each;
}

static uint64_t clocks_of(const plan *plan, uint64_t block)
{
    return items_of(plan, block) * plan->pace + plan->idle;
}

static uint64_t point_of(const plan *plan, uint64_t block, uint64_t item)
{
    return plan->first + (block * plan->each + item) * plan->step;
}

/* The pins of a block's clock, from 1 on. */
static void pins_of(const plan *plan, uint64_t block, uint64_t clock, glint_pins *pins)
{
    const glint_setting *setting = &plan->options->setting;
    const uint64_t item = (clock - 1) / plan->pace;
    const size_t size = setting->circuit->pins_size;
    if ((clock - 1) % plan->pace != 0 || item >= items_of(plan, block)) {
        memcpy(pins, &plan->rest, size);
        return;
    }
    memcpy(pins, &plan->asking, size);
    setting->circuit->domain->put(setting->values, point_of(plan, block, item), pins);
}

glint_pins *glint_domain_pins(const glint_domain_options *options, uint64_t block, uint64_t clock,
                              uint64_t after, size_t *count)
{
    plan plan;
    make_plan(&plan, options);
    const uint64_t last = clocks_of(&plan, block);
    *count = (size_t)(last > clock && last - clock > after ? clock + after : last);
    glint_pins *pins = calloc(*count, sizeof *pins);
    for (size_t i = 0; pins != NULL && i < *count; i++)
        pins_of(&plan, block, i + 1, &pins[i]);
    return pins;
}

/* ---- Comparing ----------------------------------------------------------------------------------
 */

static void count_mismatch(worker *worker, uint64_t block, uint64_t clock, int index,
                           const glint_signals *signals)
{
    const plan *plan = &worker->work->plan;
    glint_domain_result *found = &worker->found;
    const int at = signals->place[index];
    found->mismatches++;
    if (found->kept == GLINT_MISMATCHES_KEPT)
        return;
    const uint64_t item = (clock - 1) / plan->pace, last = items_of(plan, block) - 1;
    found->mismatch[found->kept++] = (glint_domain_mismatch){
        block, point_of(plan, block, item < last ? item : last),
        glint_mismatch_of(clock, &signals->info[index], worker->model + at, worker->rtl + at)};
}

static void compare_outputs(worker *worker, uint64_t block, uint64_t clock,
                            const glint_signals *signals)
{
    for (int i = 0; i < signals->count; i++) {
        const int at = signals->place[i];
        if (!glint_signal_is_port(signals->info[i].kind))
            continue;
        bool same = true;
        for (int w = at; w < signals->place[i + 1]; w++)
            same &= worker->model[w] == worker->rtl[w];
        worker->found.comparisons++;
        if (!same)
            count_mismatch(worker, block, clock, i, signals);
    }
    worker->found.clocks++;
}

static glint_status compare_block(worker *worker, uint64_t block)
{
    const plan *plan = &worker->work->plan;
    const uint64_t clocks = clocks_of(plan, block);
    glint_twin *twin;
    glint_pins pins = {{0}};
    const glint_status status = glint_twin_create(&plan->options->setting, &twin, &worker->err);
    if (status != GLINT_OK)
        return status;
    const glint_signals *signals = glint_twin_signals(twin);
    for (uint64_t clock = 1; clock <= clocks; clock++) {
        pins_of(plan, block, clock, &pins);
        glint_twin_clock(twin, &pins);
        glint_twin_read(twin, worker->model, worker->rtl);
        compare_outputs(worker, block, clock, signals);
    }
    glint_twin_destroy(twin);
    worker->found.points += items_of(plan, block);
    worker->work->done += items_of(plan, block);
    return GLINT_OK;
}

/* ---- The threads --------------------------------------------------------------------------------
 */

/* The next block; false if there is none left, or it must not be started. */
static bool take_block(work *work, uint64_t *block)
{
    const glint_domain_options *options = work->plan.options;
    if (work->failed || (options->stop != NULL && *options->stop))
        return false;
    *block = atomic_fetch_add(&work->next, 1);
    return *block < work->plan.blocks;
}

/* progress: may be NULL. */
static void work_on(worker *worker, void (*progress)(void *, uint64_t, uint64_t))
{
    work *work = worker->work;
    uint64_t block;
    while (worker->status == GLINT_OK && take_block(work, &block)) {
        worker->status = compare_block(worker, block);
        if (worker->status != GLINT_OK)
            worker->found.next = block;
        if (progress != NULL)
            progress(work->plan.options->progress_context, work->done, work->plan.items);
    }
    if (worker->status != GLINT_OK)
        work->failed = true;
}

static void work_as(void *context, int i)
{
    worker *worker = &((struct worker *)context)[i];
    work_on(worker, i == 0 ? worker->work->plan.options->progress : NULL);
}

/* ---- What came of it ----------------------------------------------------------------------------
 */

/* Each thread kept its first mismatches in block order: the lowest block among them is next. */
static void merge_mismatches(glint_domain_result *result, const worker *workers, int count)
{
    int taken[GLINT_DOMAIN_THREADS_MAX] = {0};
    while (result->kept < GLINT_MISMATCHES_KEPT) {
        const glint_domain_mismatch *first = NULL;
        int from = 0;
        for (int i = 0; i < count; i++) {
            const glint_domain_result *found = &workers[i].found;
            if (taken[i] < found->kept &&
                (first == NULL || found->mismatch[taken[i]].block < first->block)) {
                first = &found->mismatch[taken[i]];
                from = i;
            }
        }
        if (first == NULL)
            return;
        result->mismatch[result->kept++] = *first;
        taken[from]++;
    }
}

static glint_status sum_up(const work *work, const worker *workers, int count,
                           glint_domain_result *result, glint_error *err)
{
    const plan *plan = &work->plan;
    uint64_t undone = work->next < plan->blocks ? work->next : plan->blocks;
    const bool all_taken = undone == plan->blocks;
    glint_status status = GLINT_OK;
    result->points_total = plan->total;
    for (int i = 0; i < count; i++) {
        const worker *worker = &workers[i];
        result->points += worker->found.points;
        result->clocks += worker->found.clocks;
        result->comparisons += worker->found.comparisons;
        result->mismatches += worker->found.mismatches;
        if (worker->status != GLINT_OK && status == GLINT_OK)
            status = glint_fail(err, worker->status, "%s", worker->err.text);
        if (worker->status != GLINT_OK && worker->found.next < undone)
            undone = worker->found.next;
    }
    merge_mismatches(result, workers, count);
    result->next = undone < plan->blocks ? point_of(plan, undone, 0) : plan->total;
    if (status == GLINT_OK && !all_taken)
        return glint_fail(err, GLINT_INTERRUPTED, "interrupted");
    return status;
}

glint_status glint_domain_run(const glint_domain_options *options, glint_domain_result *result,
                              glint_error *err)
{
    work work = {0};
    memset(result, 0, sizeof *result);
    glint_status status = plan_all(&work.plan, options, err);
    if (status != GLINT_OK)
        return status;
    worker *workers = calloc((size_t)options->threads, sizeof *workers);
    if (workers == NULL)
        return glint_fail(err, GLINT_NO_MEMORY,
                          "not enough memory for the threads of an exhaustive run");
    for (int i = 0; i < options->threads; i++)
        workers[i].work = &work;
    status = glint_crew_once(options->threads, work_as, workers, err);
    if (status == GLINT_OK)
        status = sum_up(&work, workers, options->threads, result, err);
    free(workers);
    return status;
}
