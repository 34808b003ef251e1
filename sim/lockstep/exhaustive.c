/* Exhaustive comparison of a highlight unit through its batch interface; see exhaustive.h. */
#define _POSIX_C_SOURCE 200809L

#include "lockstep/exhaustive.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/circuits.h"
#include "circuit/random.h"
#include "rtl/batch.h"
#include "thread/crew.h"

enum {
    RUN = 4096,      /* points shaded at a time, at most: small enough for the caches */
    TURN_DIGIT = 16, /* of n, less than which all lanes come up by n itself */
    N_SPECULAR = 2,  /* σ = 1: t is the cosine */
    N_TRIED = 16,    /* of other units each n up to it: together they give every W */
    COLORS = GLINT_COLOR_MAX + 1,
    QUARTERS = GLINT_N_COUNT / COLORS,
    RUNS_REMEMBERED = 512, /* with 32 lanes the clocks of a history */
};

_Static_assert(RUN / GLINT_LANES_MAX * RUNS_REMEMBERED >= GLINT_HISTORY_CLOCKS,
               "a history holds what a sweep remembers");
_Static_assert(QUARTERS >= 1, "every colour value has an n");

/* The sweeps of an n; the last are as many as the circuit's list has parts. */
enum { WHITE, COLORED, MULTIPLIERS };

/* Points of one material: the codes list[begin…end−1], without a list the codes begin…end−1. */
typedef struct sweep {
    const uint32_t *list;
    uint32_t begin, end;
    glint_material material;
} sweep;

/* The way of a sweep through a circuit. Place p goes through lane p mod lanes and has item
 * p + turn, around the end: so item i goes through lane i − turn (mod lanes). That this holds
 * around the end too, there are as many places as fill whole clocks; what is left over repeats item
 * 0. */
typedef struct walk {
    sweep sweep;
    uint32_t offset,
        stride; /* item i is the code in place begin + offset + i·stride of the sweep */
    uint32_t items, places, turn;
    uint32_t run; /* points of a run: full clocks */
} walk;

/* The cosine codes that give each W once: those of a part with its n. */
typedef struct w_list {
    uint32_t count;
    uint32_t cos_code[GLINT_EXHAUSTIVE_WS];
    bool has[GLINT_EXHAUSTIVE_WS]; /* by W */
    int parts;
    struct w_part {
        uint32_t n, begin, end;
    } part[N_TRIED];
} w_list;

typedef struct answers {
    uint32_t w[RUN];
    uint8_t r[RUN], g[RUN], b[RUN];
} answers;

typedef struct work {
    const glint_exhaustive_options *options;
    w_list *lists; /* one for each setting */
    uint32_t first;
    uint32_t parts;            /* how many n there are from first on */
    atomic_uint next;          /* the first part that no thread has taken */
    atomic_bool failed;        /* a thread failed, so the others can stop */
    atomic_uint_fast64_t done; /* points */
    uint64_t total;
} work;

/* The inputs of a run: the places of the walk from `at` on. */
typedef struct asked {
    walk walk;
    uint32_t at;
} asked;

/* The last runs of a circuit; number i is at i mod RUNS_REMEMBERED. */
typedef struct memory {
    uint64_t runs;
    asked asked[RUNS_REMEMBERED];
} memory;

typedef struct worker {
    work *work;
    glint_rtl *rtl[GLINT_EXHAUSTIVE_CIRCUITS_MAX];
    bool (*seen)[GLINT_EXHAUSTIVE_WS]; /* the W codes that occurred, for each setting */
    memory *memory;                    /* for each setting; NULL: no history is wanted */
    uint32_t cos_code[RUN];
    answers model, circuit;
    glint_exhaustive_result found;
    glint_status status;
    glint_error err;
} worker;

uint32_t glint_exhaustive_offset(const glint_exhaustive_options *options, uint32_t n)
{
    glint_random random = {options->seed ^ ((uint64_t)n << 32)};
    return glint_random_below(&random, options->stride);
}

/* ---- What there is to do ------------------------------------------------------------------------
 */

static sweep white_sweep(uint32_t n)
{
    return (sweep){.end = GLINT_EXHAUSTIVE_CODES,
                   .material = {(uint16_t)n, GLINT_COLOR_MAX, GLINT_COLOR_MAX, GLINT_COLOR_MAX}};
}

/* Odd factors, so that each component takes each value. */
static sweep colored_sweep(uint32_t n)
{
    return (sweep){.end = GLINT_EXHAUSTIVE_CODES,
                   .material = {(uint16_t)n, (uint8_t)(37 * n + 11), (uint8_t)(101 * n + 71),
                                (uint8_t)(197 * n + 139)}};
}

static sweep multiplier_sweep(uint32_t n, const w_list *list, int part)
{
    const struct w_part *of = &list->part[part];
    const uint32_t quarter = n / COLORS, count = of->end - of->begin;
    return (sweep){
        .list = list->cos_code,
        .begin = of->begin + count * quarter / QUARTERS,
        .end = of->begin + count * (quarter + 1) / QUARTERS,
        .material = {(uint16_t)of->n, (uint8_t)n, (uint8_t)(n + 85), (uint8_t)(n + 170)}};
}

static sweep sweep_of(const work *work, int unit, uint32_t n, int kind)
{
    switch (kind) {
    case WHITE:
        return white_sweep(n);
    case COLORED:
        return colored_sweep(n);
    default:
        return multiplier_sweep(n, &work->lists[unit], kind - MULTIPLIERS);
    }
}

static int sweeps_of(const work *work, int unit)
{
    return MULTIPLIERS + work->lists[unit].parts;
}

static int repetitions_of(const glint_exhaustive_options *options, int unit)
{
    return options->every_lane ? glint_highlight_lanes(&options->setting[unit]) : 1;
}

/* How many walks there are for an n. */
static int walks_of(const work *work, int unit)
{
    return sweeps_of(work, unit) * repetitions_of(work->options, unit);
}

/* With a digit of n more than n mod lanes, so that the shards of N see all turns too. */
static uint32_t turn_of(uint32_t lanes, uint32_t n, int kind, uint32_t repetition)
{
    const uint32_t ahead = kind == COLORED ? lanes / 2 : 0;
    const uint32_t digit = lanes > TURN_DIGIT ? lanes : TURN_DIGIT;
    return (n + n / digit + ahead + repetition) % lanes;
}

static walk walk_of(const work *work, int unit, uint32_t n, int number)
{
    const glint_exhaustive_options *options = work->options;
    const uint32_t lanes = (uint32_t)glint_highlight_lanes(&options->setting[unit]);
    const int kind = number % sweeps_of(work, unit);
    walk walk = {.sweep = sweep_of(work, unit, n, kind),
                 .offset = glint_exhaustive_offset(options, n),
                 .stride = options->stride,
                 .turn = turn_of(lanes, n, kind, (uint32_t)(number / sweeps_of(work, unit))),
                 .run = RUN / lanes * lanes};
    const uint32_t codes = walk.sweep.end - walk.sweep.begin;
    walk.items = walk.offset < codes ? (codes - walk.offset - 1) / walk.stride + 1 : 0;
    walk.places = (walk.items + lanes - 1) / lanes * lanes;
    return walk;
}

static uint64_t count_points(const work *work)
{
    const glint_exhaustive_options *options = work->options;
    uint64_t points = 0;
    for (uint32_t part = 0; part < work->parts; part++)
        for (int c = 0; c < options->settings; c++)
            for (int w = 0; w < walks_of(work, c); w++)
                points += walk_of(work, c, work->first + part * options->shards, w).places;
    return points;
}

/* The W codes that it does not have yet. Codes above 1.0 have the W of 1.0. */
static glint_status add_ws(const glint_setting *setting, uint32_t n, w_list *list)
{
    const glint_material material = {.n = (uint16_t)n};
    const uint32_t begin = list->count;
    answers found;
    uint32_t codes[RUN];
    glint_status status = GLINT_OK;
    for (uint32_t first = 0; first <= GLINT_COS_ONE && status == GLINT_OK; first += RUN) {
        uint32_t count = 0;
        for (; count < RUN && first + count <= GLINT_COS_ONE; count++)
            codes[count] = first + count;
        status = glint_highlight_batch(setting, &material, codes, count, found.w, found.r, found.g,
                                       found.b);
        for (uint32_t i = 0; i < count && status == GLINT_OK; i++)
            if (!list->has[found.w[i]]) {
                list->has[found.w[i]] = true;
                list->cos_code[list->count++] = codes[i];
            }
    }
    if (list->count > begin)
        list->part[list->parts++] = (struct w_part){n, begin, list->count};
    return status;
}

static uint32_t w_possible(const glint_setting *setting)
{
    return (1u << glint_highlight_w_frac_bits(setting)) + 1u;
}

static glint_status list_ws(const glint_setting *setting, w_list *list)
{
    glint_status status = GLINT_OK;
    if (setting->circuit == &glint_circuit_specular)
        return add_ws(setting, N_SPECULAR, list);
    for (uint32_t n = 1; n <= N_TRIED && status == GLINT_OK && list->count < w_possible(setting);
         n++)
        status = add_ws(setting, n, list);
    return status;
}

static glint_status list_all_ws(work *work, glint_error *err)
{
    const glint_exhaustive_options *options = work->options;
    glint_status status = GLINT_OK;
    work->lists = calloc((size_t)options->settings, sizeof *work->lists);
    if (work->lists == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the W codes");
    for (int c = 0; c < options->settings && status == GLINT_OK; c++) {
        status = list_ws(&options->setting[c], &work->lists[c]);
        if (status != GLINT_OK)
            status = glint_fail(err, status, "circuit %d has no C model", c + 1);
    }
    return status;
}

static glint_status check_setting(const glint_setting *setting, glint_error *err)
{
    if (!glint_is_highlight(setting->circuit))
        return glint_fail(err, GLINT_BAD_ARGUMENT, "circuit %s does not compute highlights",
                          setting->circuit->name);
    if (w_possible(setting) > GLINT_EXHAUSTIVE_WS)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "W has more codes than %u", GLINT_EXHAUSTIVE_WS);
    return glint_setting_check(setting, err);
}

static glint_status check_options(const glint_exhaustive_options *options, glint_error *err)
{
    glint_status status = GLINT_OK;
    if (options->settings < 1 || options->settings > GLINT_EXHAUSTIVE_CIRCUITS_MAX)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "%d circuits at a time; at most %d are possible",
                          options->settings, GLINT_EXHAUSTIVE_CIRCUITS_MAX);
    for (int c = 0; c < options->settings && status == GLINT_OK; c++)
        status = check_setting(&options->setting[c], err);
    if (status != GLINT_OK)
        return status;
    if (options->from > GLINT_N_MAX)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "n = %u is outside 0…%u", options->from,
                          GLINT_N_MAX);
    if (options->shards < 1 || options->shards > GLINT_N_COUNT || options->shard < 1 ||
        options->shard > options->shards)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "shard %u of %u does not exist", options->shard,
                          options->shards);
    if (options->stride < 1 || options->stride > GLINT_EXHAUSTIVE_CODES)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "the stride, %u, is outside 1…%u",
                          options->stride, GLINT_EXHAUSTIVE_CODES);
    if (options->threads < 1 || options->threads > GLINT_EXHAUSTIVE_THREADS_MAX)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "%d threads", options->threads);
    return GLINT_OK;
}

static glint_status plan(work *work, const glint_exhaustive_options *options, glint_error *err)
{
    /* The first n of the shard that is not below from. */
    const uint32_t behind =
        (options->from + options->shards - (options->shard - 1)) % options->shards;
    work->options = options;
    work->first = options->from + (behind != 0 ? options->shards - behind : 0);
    if (work->first > GLINT_N_MAX)
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "nothing to compare: shard %u/%u has no n from %u up", options->shard,
                          options->shards, options->from);
    work->parts = (GLINT_N_MAX - work->first) / options->shards + 1;
    const glint_status status = list_all_ws(work, err);
    if (status != GLINT_OK)
        return status;
    work->total = count_points(work);
    return GLINT_OK;
}

/* ---- What a circuit was asked -------------------------------------------------------------------
 */

/* The codes of a run; returns their count. */
static uint32_t codes_of(const walk *walk, uint32_t at, uint32_t codes[RUN])
{
    const uint32_t left = walk->places - at;
    const uint32_t count = left < walk->run ? left : walk->run;
    const uint32_t first = walk->sweep.begin + walk->offset;
    for (uint32_t i = 0; i < count; i++) {
        uint32_t item = at + i + walk->turn;
        item -= item >= walk->places ? walk->places : 0;
        item = item < walk->items ? item : 0;
        codes[i] = first + item * walk->stride;
    }
    if (walk->sweep.list != NULL)
        for (uint32_t i = 0; i < count; i++)
            codes[i] = walk->sweep.list[codes[i]];
    return count;
}

static void remember(worker *worker, int unit, const walk *walk, uint32_t at)
{
    if (worker->memory == NULL)
        return;
    memory *memory = &worker->memory[unit];
    memory->asked[memory->runs++ % RUNS_REMEMBERED] = (asked){*walk, at};
}

/* The run under way is the last of them. */
static void keep_history(worker *worker, int unit)
{
    const glint_setting *setting = &worker->work->options->setting[unit];
    uint32_t codes[RUN];
    if (worker->memory == NULL || worker->found.history != NULL)
        return;
    const memory *memory = &worker->memory[unit];
    uint64_t run = memory->runs > RUNS_REMEMBERED ? memory->runs - RUNS_REMEMBERED : 0;
    for (; run < memory->runs; run++) {
        const asked *asked = &memory->asked[run % RUNS_REMEMBERED];
        const uint32_t count = codes_of(&asked->walk, asked->at, codes);
        glint_history_add(&worker->found.history, setting,
                          &(glint_batch){.material = &asked->walk.sweep.material,
                                         .cos_code = codes,
                                         .count = count});
    }
}

/* ---- Comparing ----------------------------------------------------------------------------------
 */

static uint32_t value_of(const answers *answers, glint_answer_value value, size_t i)
{
    switch (value) {
    case GLINT_ANSWER_R:
        return answers->r[i];
    case GLINT_ANSWER_G:
        return answers->g[i];
    case GLINT_ANSWER_B:
        return answers->b[i];
    default:
        return answers->w[i];
    }
}

static void count_mismatch(worker *worker, int unit, uint32_t n, const glint_material *material,
                           size_t count, size_t at, glint_answer_value value)
{
    const glint_setting *setting = &worker->work->options->setting[unit];
    glint_exhaustive_result *found = &worker->found;
    found->circuit[unit].mismatches++;
    if (found->kept == 0)
        keep_history(worker, unit);
    if (found->kept == GLINT_EXHAUSTIVE_KEPT)
        return;
    glint_exhaustive_mismatch *kept = &found->mismatch[found->kept++];
    kept->n = n;
    kept->setting = *setting;
    glint_answer_keep_points(&kept->answer, glint_highlight_lanes(setting), material,
                             worker->cos_code, count, at);
    kept->answer.value = value;
    kept->answer.model = (int32_t)value_of(&worker->model, value, at);
    kept->answer.rtl = (int32_t)value_of(&worker->circuit, value, at);
}

/* One by one, once the runs are known to differ. */
static void find_mismatches(worker *worker, int unit, uint32_t n, const glint_material *material,
                            size_t count)
{
    for (size_t i = 0; i < count; i++)
        for (int v = 0; v < GLINT_ANSWER_VALUES; v++) {
            const glint_answer_value value = (glint_answer_value)v;
            if (value_of(&worker->model, value, i) != value_of(&worker->circuit, value, i))
                count_mismatch(worker, unit, n, material, count, i, value);
        }
}

/* Compares count values of the given size and adds to *compared. */
static bool same(const void *a, const void *b, size_t count, size_t bytes, uint64_t *compared)
{
    *compared += count;
    return memcmp(a, b, count * bytes) == 0;
}

static bool equal(const answers *a, const answers *b, size_t count, uint64_t *compared)
{
    const bool w = same(a->w, b->w, count, sizeof a->w[0], compared);
    const bool r = same(a->r, b->r, count, sizeof a->r[0], compared);
    const bool g = same(a->g, b->g, count, sizeof a->g[0], compared);
    const bool blue = same(a->b, b->b, count, sizeof a->b[0], compared);
    return w && r && g && blue;
}

/* The points that stand in worker->cos_code. */
static glint_status compare_run(worker *worker, int unit, uint32_t n,
                                const glint_material *material, size_t count)
{
    answers *model = &worker->model, *circuit = &worker->circuit;
    const glint_setting *setting = &worker->work->options->setting[unit];
    glint_status status = glint_highlight_batch(setting, material, worker->cos_code, count,
                                                model->w, model->r, model->g, model->b);
    if (status != GLINT_OK)
        return glint_fail(&worker->err, status, "the C model rejects n = %u", material->n);
    const glint_points points = {worker->cos_code, count,      circuit->w,
                                 circuit->r,       circuit->g, circuit->b};
    status = glint_rtl_shade(worker->rtl[unit], material, &points, &worker->err);
    if (status == GLINT_DEVICE_FAULT && worker->found.kept == 0)
        keep_history(worker, unit);
    if (status != GLINT_OK)
        return status;
    for (size_t i = 0; i < count; i++)
        worker->seen[unit][model->w[i]] = true;
    if (!equal(model, circuit, count, &worker->found.circuit[unit].comparisons))
        find_mismatches(worker, unit, n, material, count);
    worker->found.circuit[unit].points += count;
    worker->work->done += count;
    return GLINT_OK;
}

static glint_status compare_walk(worker *worker, int unit, uint32_t n, const walk *walk)
{
    glint_status status = GLINT_OK;
    uint32_t at = 0;
    while (at < walk->places && status == GLINT_OK) {
        const uint32_t count = codes_of(walk, at, worker->cos_code);
        remember(worker, unit, walk, at);
        status = compare_run(worker, unit, n, &walk->sweep.material, count);
        at += count;
    }
    return status;
}

static glint_status compare_n(worker *worker, int unit, uint32_t n)
{
    const work *work = worker->work;
    glint_exhaustive_circuit *circuit = &worker->found.circuit[unit];
    glint_status status = GLINT_OK;
    for (int w = 0; w < walks_of(work, unit) && status == GLINT_OK; w++) {
        const walk walk = walk_of(work, unit, n, w);
        const uint64_t before = circuit->points;
        status = compare_walk(worker, unit, n, &walk);
        if (w % sweeps_of(work, unit) >= MULTIPLIERS && status == GLINT_OK)
            circuit->pairs += circuit->points - before - (walk.places - walk.items);
    }
    return status;
}

/* ---- The threads --------------------------------------------------------------------------------
 */

static glint_status create_circuits(worker *worker)
{
    const glint_exhaustive_options *options = worker->work->options;
    glint_status status = GLINT_OK;
    for (int c = 0; c < options->settings && status == GLINT_OK; c++) {
        status =
            glint_rtl_open(&options->setting[c], GLINT_RTL_FAST, &worker->rtl[c], &worker->err);
    }
    return status;
}

/* The next n; false if there is none left, or it must not be started. */
static bool take_n(work *work, uint32_t *n)
{
    const glint_exhaustive_options *options = work->options;
    if (work->failed || (options->stop != NULL && *options->stop))
        return false;
    const uint32_t part = atomic_fetch_add(&work->next, 1);
    *n = work->first + part * options->shards;
    return part < work->parts;
}

/* progress: may be NULL. */
static void work_on(worker *worker, void (*progress)(void *, uint64_t, uint64_t))
{
    work *work = worker->work;
    uint32_t n;
    worker->status = create_circuits(worker);
    while (worker->status == GLINT_OK && take_n(work, &n)) {
        for (int c = 0; c < work->options->settings && worker->status == GLINT_OK; c++)
            worker->status = compare_n(worker, c, n);
        if (worker->status == GLINT_OK)
            worker->found.n_done++;
        else
            worker->found.next = n;
        if (progress != NULL)
            progress(work->options->progress_context, work->done, work->total);
    }
    if (worker->status != GLINT_OK)
        work->failed = true;
    /* Here, because Verilator requires the creating thread to destroy a circuit. */
    for (int c = 0; c < GLINT_EXHAUSTIVE_CIRCUITS_MAX; c++)
        glint_rtl_destroy(worker->rtl[c]);
}

static void free_worker(worker *worker)
{
    if (worker == NULL)
        return;
    glint_history_destroy(worker->found.history);
    free(worker->memory);
    free(worker->seen);
    free(worker);
}

static worker *make_worker(work *work)
{
    worker *made = calloc(1, sizeof *made);
    if (made == NULL)
        return NULL;
    made->work = work;
    made->found.next = GLINT_N_COUNT;
    const size_t settings = (size_t)work->options->settings;
    made->seen = calloc(settings, sizeof *made->seen);
    if (work->options->keep_history)
        made->memory = calloc(settings, sizeof *made->memory);
    if (made->seen == NULL || (made->memory == NULL && work->options->keep_history)) {
        free_worker(made);
        return NULL;
    }
    return made;
}

static void work_as(void *context, int i)
{
    worker *worker = ((struct worker **)context)[i];
    work_on(worker, i == 0 ? worker->work->options->progress : NULL);
}

/* ---- What came of it ----------------------------------------------------------------------------
 */

static void add_circuit(glint_exhaustive_circuit *sum, worker *const *workers, int count, int unit)
{
    const work *work = workers[0]->work;
    const w_list *list = &work->lists[unit];
    sum->pairs_total =
        (uint64_t)list->count * COLORS * (uint64_t)repetitions_of(work->options, unit);
    sum->w_possible = w_possible(&work->options->setting[unit]);
    for (int i = 0; i < count; i++) {
        sum->points += workers[i]->found.circuit[unit].points;
        sum->comparisons += workers[i]->found.circuit[unit].comparisons;
        sum->mismatches += workers[i]->found.circuit[unit].mismatches;
        sum->pairs += workers[i]->found.circuit[unit].pairs;
    }
    for (uint32_t w = 0; w < GLINT_EXHAUSTIVE_WS; w++) {
        bool seen = false;
        for (int i = 0; i < count; i++)
            seen |= workers[i]->seen[unit][w];
        sum->w_codes += seen;
        sum->w_untried += seen && !list->has[w];
    }
}

static void take_history(glint_exhaustive_result *result, worker *worker)
{
    result->history = worker->found.history;
    worker->found.history = NULL;
}

/* Each thread kept its first mismatches in order of n: the smallest n among them is next. */
static void merge_mismatches(glint_exhaustive_result *result, worker *const *workers, int count)
{
    int taken[GLINT_EXHAUSTIVE_THREADS_MAX] = {0};
    const glint_exhaustive_mismatch *first;
    do {
        int from = 0;
        first = NULL;
        for (int i = 0; i < count; i++) {
            const glint_exhaustive_result *found = &workers[i]->found;
            if (taken[i] < found->kept &&
                (first == NULL || found->mismatch[taken[i]].n < first->n)) {
                first = &found->mismatch[taken[i]];
                from = i;
            }
        }
        taken[from]++;
        if (first != NULL && result->kept == 0)
            take_history(result, workers[from]);
        if (first != NULL)
            result->mismatch[result->kept++] = *first;
    } while (first != NULL && result->kept < GLINT_EXHAUSTIVE_KEPT);
}

static glint_status sum_up(const work *work, worker *const *workers, int count,
                           glint_exhaustive_result *result, glint_error *err)
{
    const uint32_t taken = work->next < work->parts ? work->next : work->parts;
    for (int c = 0; c < work->options->settings; c++)
        add_circuit(&result->circuit[c], workers, count, c);
    for (int i = 0; i < count; i++)
        result->n_done += workers[i]->found.n_done;
    merge_mismatches(result, workers, count);
    result->next =
        taken < work->parts ? work->first + taken * work->options->shards : GLINT_N_COUNT;
    for (int i = 0; i < count; i++)
        if (workers[i]->found.next < result->next)
            result->next = workers[i]->found.next;
    for (int i = 0; i < count; i++)
        if (workers[i]->status != GLINT_OK) {
            if (result->kept == 0)
                take_history(result, workers[i]);
            return glint_fail(err, workers[i]->status, "%s", workers[i]->err.text);
        }
    if (taken < work->parts)
        return glint_fail(err, GLINT_INTERRUPTED, "interrupted");
    return GLINT_OK;
}

static glint_status run_planned(work *work, glint_exhaustive_result *result, glint_error *err)
{
    worker *workers[GLINT_EXHAUSTIVE_THREADS_MAX] = {NULL};
    glint_status status = GLINT_OK;
    int count = 0;
    while (count < work->options->threads && (workers[count] = make_worker(work)) != NULL)
        count++;
    if (count == 0) {
        status = glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a thread's points");
    } else {
        status = glint_crew_once(count, work_as, workers, err);
        if (status == GLINT_OK)
            status = sum_up(work, workers, count, result, err);
    }
    for (int i = 0; i < count; i++)
        free_worker(workers[i]);
    return status;
}

glint_status glint_exhaustive_run(const glint_exhaustive_options *options,
                                  glint_exhaustive_result *result, glint_error *err)
{
    work work = {0};
    memset(result, 0, sizeof *result);
    glint_status status = check_options(options, err);
    if (status == GLINT_OK)
        status = plan(&work, options, err);
    if (status == GLINT_OK)
        status = run_planned(&work, result, err);
    free(work.lists);
    return status;
}
