/* Tests the exhaustive comparison with planted differences: a mock circuit (mock_rtl.h) asks the
 * real one and alters the answers as planned. Each run, sweep, lane and thread and each of W, red,
 * green and blue gets a turn, and the mismatches must be exactly the planted ones, by the test's
 * own count. */
#define _POSIX_C_SOURCE 200809L

#include <errno.h>
#include <inttypes.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "../golden.h"
#include "../wrong.h"
#include "circuit/circuits.h"
#include "lockstep/exhaustive.h"
#include "mock_rtl.h"

enum {
    LANES = 16,
    CODES = 1 << 19,  /* of the cosine pin */
    W_CODES = 196609, /* those that occur with n = 2: test_model counts them by the blocks */
    QUARTER = 49152,  /* of them, in the multipliers' sweep of n = 0…767 */
    THREADS = 4,
    SECONDS = 600, /* seconds to wait for threads before giving up */
};

/* One point of a batch, as the plant sees it. */
typedef struct point {
    const glint_material *material;
    uint32_t code;
    int lane;
    size_t at, count; /* of the batch */
} point;

/* What is altered: the last bit of one value where `where` says so. */
typedef struct plant {
    bool (*where)(const point *point);
    glint_answer_value value;
    /* what `where` compares with */
    uint32_t n, code;
    int lane;
} plant;

static const glint_specular_config sound = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, LANES};
static plant planted;
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t all_have_come = PTHREAD_COND_INITIALIZER;
static uint64_t alterations, batches, asked; /* asked: points */
static int awaited;                          /* threads that must have an n before one goes on */
static int arrived;
static int comparison; /* its number, from 1 on */

/* ---- The circuit --------------------------------------------------------------------------------
 */

/* A thread's first batch waits for the other threads': so each has at least one n. */
static void wait_for_all(void)
{
    static _Thread_local int came_to; /* the comparison that this thread was last waited for in */
    struct timespec until;
    if (awaited == 0 || came_to == comparison)
        return;
    came_to = comparison;
    clock_gettime(CLOCK_REALTIME, &until);
    until.tv_sec += SECONDS;
    arrived++;
    pthread_cond_broadcast(&all_have_come);
    while (arrived < awaited &&
           pthread_cond_timedwait(&all_have_come, &lock, &until) != ETIMEDOUT) {
    }
}

static void alter(const glint_points *io, size_t at)
{
    switch (planted.value) {
    case GLINT_ANSWER_R:
        io->r[at] ^= 1;
        break;
    case GLINT_ANSWER_G:
        io->g[at] ^= 1;
        break;
    case GLINT_ANSWER_B:
        io->b[at] ^= 1;
        break;
    default:
        io->w[at] ^= 1;
    }
    alterations++;
}

static glint_status shade_planted(glint_rtl *rtl, const glint_material *material,
                                  const glint_points *points, glint_error *err)
{
    const glint_status status = __real_glint_rtl_shade(rtl, material, points, err);
    pthread_mutex_lock(&lock);
    wait_for_all();
    for (size_t i = 0; i < points->count; i++) {
        const point point = {material, points->cos[i], (int)(i % LANES), i, points->count};
        if (planted.where(&point))
            alter(points, i);
    }
    batches++;
    asked += points->count;
    pthread_mutex_unlock(&lock);
    return status;
}

static glint_exhaustive_options options_for(glint_specular_config config)
{
    return (glint_exhaustive_options){.setting = {glint_setting_specular(&config)},
                                      .settings = 1,
                                      .shard = 1,
                                      .shards = 1,
                                      .stride = 1,
                                      .threads = 1};
}

static glint_exhaustive_options only_n(glint_exhaustive_options options, uint32_t n)
{
    options.shard = n + 1;
    options.shards = GLINT_N_COUNT;
    return options;
}

static glint_exhaustive_result result;

static void compare(glint_exhaustive_options options)
{
    glint_error err;
    alterations = batches = asked = 0;
    arrived = 0;
    comparison++;
    if (glint_exhaustive_run(&options, &result, &err) != GLINT_OK)
        fail_msg("%s", err.text);
}

static void plant_and_compare(const plant *what, glint_exhaustive_options options)
{
    mock = (mock_rtl){.shade = shade_planted};
    planted = *what;
    options.setting[0].verilog = mock_verilog;
    compare(options);
}

/* What the one circuit was asked and compared, and what differed. */
static void assert_counts(uint64_t points, uint64_t mismatches)
{
    const glint_exhaustive_circuit *circuit = &result.circuit[0];
    if (circuit->points != points || circuit->comparisons != 4 * points ||
        circuit->mismatches != mismatches) {
        fail_msg("%" PRIu64 " points, %" PRIu64 " comparisons, %" PRIu64
                 " mismatches; expected %" PRIu64 ", %" PRIu64 ", %" PRIu64,
                 circuit->points, circuit->comparisons, circuit->mismatches, points, 4 * points,
                 mismatches);
    }
}

/* ---- Every value
 * ----------------------------------------------------------------------------------
 */

static bool everywhere(const point *point)
{
    (void)point;
    return true;
}

/* Each point of each sweep differs in one value: all are reported, whichever value it is. */
static void every_value_of_every_point_is_compared(void **state)
{
    (void)state;
    const uint64_t points = 2 * CODES + QUARTER;
    for (int v = 0; v < GLINT_ANSWER_VALUES; v++) {
        const plant what = {.where = everywhere, .value = (glint_answer_value)v};
        plant_and_compare(&what, only_n(options_for(sound), 80));
        assert_int_equal(asked, points);
        assert_counts(points, points);
        assert_int_equal(result.circuit[0].pairs, QUARTER);
        assert_int_equal(result.kept, GLINT_EXHAUSTIVE_KEPT);
        for (int i = 0; i < result.kept; i++) {
            assert_int_equal(result.mismatch[i].answer.value, v);
            assert_int_equal(result.mismatch[i].answer.model ^ result.mismatch[i].answer.rtl, 1);
        }
    }
}

/* ---- Every run
 * ------------------------------------------------------------------------------------
 */

/* First point, last point, and every place between: another one in each run. */
static bool once_a_run(const point *point)
{
    return point->at == (batches == 1 ? point->count - 1 : batches * 61 % point->count);
}

/* Of a lone difference in a run none is missed: 128 runs of 4096 points are a sweep of all codes.
 */
static void one_difference_in_each_run_is_found(void **state)
{
    (void)state;
    const uint64_t runs = 2 * (CODES / 4096) + QUARTER / 4096;
    for (int v = 0; v < GLINT_ANSWER_VALUES; v++) {
        const plant what = {.where = once_a_run, .value = (glint_answer_value)v};
        plant_and_compare(&what, only_n(options_for(sound), 80));
        assert_int_equal(batches, runs);
        assert_counts(2 * CODES + QUARTER, runs);
    }
}

/* ---- Every sweep
 * ----------------------------------------------------------------------------------
 */

static bool at_code(const point *point)
{
    return point->code == planted.code;
}

/* A code is in both sweeps of an n once, also above 1.0, and where its W is new with n = 2, in the
 * multipliers' sweep of a quarter of the n. */
static void a_code_comes_once_in_each_sweep(void **state)
{
    (void)state;
    static const struct {
        uint32_t code, times;
    } cases[] = {{0, 3},       {1, 2},       {0x3fffe, 2}, {0x3ffff, 2},
                 {0x40000, 2}, {0x40001, 2}, {0x40010, 2}, {CODES - 1, 2}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const plant what = {.where = at_code,
                            .value = (glint_answer_value)(i % GLINT_ANSWER_VALUES),
                            .code = cases[i].code};
        plant_and_compare(&what, only_n(options_for(sound), 200));
        assert_counts(2 * CODES + QUARTER, cases[i].times);
        const glint_answer *answer = &result.mismatch[0].answer;
        assert_int_equal(answer->cos_code[answer->at], cases[i].code);
        assert_int_equal(answer->material.n, 200);
        assert_int_equal(result.kept, cases[i].times);
    }
}

/* The last quarter has one W more, 1.0, and 15 points repeated that it may fill its clocks. */
static void the_multipliers_see_every_w(void **state)
{
    (void)state;
    uint64_t points = 0, pairs = 0;
    for (uint32_t n = 0; n < 4; n++) {
        const plant what = {.where = everywhere, .value = GLINT_ANSWER_B};
        plant_and_compare(&what, only_n(options_for(sound), 256 * n));
        points += result.circuit[0].mismatches;
        pairs += result.circuit[0].pairs;
    }
    assert_int_equal(pairs, W_CODES);
    assert_int_equal(points, 4 * 2 * CODES + W_CODES + 15);
}

/* A real circuit: register 1 saturates the codes above 1.0, but not 1.0 and one code. */
static void a_wrong_saturation_of_the_first_code_is_found(void **state)
{
    (void)state;
    const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1};
    glint_exhaustive_options options = only_n(options_for(config), 2);
    options.setting[0].verilog = wrong_rtl("late_saturation");
    compare(options);
    assert_counts(2 * CODES + QUARTER, 2);
    for (int i = 0; i < 2; i++) {
        const glint_answer *answer = &result.mismatch[i].answer;
        assert_int_equal(answer->cos_code[answer->at], 0x40001);
        assert_int_equal(answer->value, GLINT_ANSWER_W);
        assert_int_equal(answer->model, GLINT_W_ONE);
        assert_int_equal(answer->rtl, GLINT_W_ONE + 2); /* (1 + 2^-18)^2 */
    }
}

/* ---- Every colour and every place of a stride
 */

enum { STRIDE = 64 };

static bool has_color[3][256];    /* in the sweeps in colour */
static bool has_place[2][STRIDE]; /* where the codes of the sweeps in colour and white begin */

static bool note_material(const point *point)
{
    const glint_material *m = point->material;
    const bool is_white = m->r == 255 && m->g == 255 && m->b == 255;
    if (m->n != 2)
        has_place[is_white][point->code % STRIDE] = true;
    if (m->n != 2 && !is_white)
        has_color[0][m->r] = has_color[1][m->g] = has_color[2][m->b] = true;
    return false;
}

static int count_of(const bool *has, int room)
{
    int count = 0;
    for (int i = 0; i < room; i++)
        count += has[i];
    return count;
}

/* Over all n each component takes each value, and a stride begins at each of its places. */
static void colors_and_strides_change_with_n(void **state)
{
    (void)state;
    const plant note = {.where = note_material};
    glint_exhaustive_options options = options_for(sound);
    options.stride = STRIDE;
    options.seed = 1;
    plant_and_compare(&note, options);
    assert_int_equal(result.circuit[0].mismatches, 0);
    for (int component = 0; component < 3; component++)
        assert_int_equal(count_of(has_color[component], 256), 256);
    for (int sweep = 0; sweep < 2; sweep++)
        assert_int_equal(count_of(has_place[sweep], STRIDE), STRIDE);
}

/* ---- Every thread
 * ---------------------------------------------------------------------------------
 */

static bool at_n_and_code(const point *point)
{
    return point->material->n == planted.n && point->code == planted.code;
}

/* Each thread has an n, whose every blue differs: all are summed up, and the first n stands first.
 */
static void the_mismatches_of_every_thread_count(void **state)
{
    (void)state;
    const plant what = {.where = everywhere, .value = GLINT_ANSWER_B};
    glint_exhaustive_options options = options_for(sound);
    options.from = 0;
    options.shard = 1;
    options.shards = GLINT_N_COUNT / THREADS; /* n = 0, 256, 512, 768 */
    options.threads = THREADS;
    awaited = THREADS;
    plant_and_compare(&what, options);
    awaited = 0;
    assert_int_equal(arrived, THREADS);
    assert_int_equal(result.n_done, THREADS);
    const uint64_t points = (uint64_t)THREADS * 2 * CODES + W_CODES + 15;
    assert_counts(points, points);
    assert_int_equal(result.mismatch[0].n, 0);
}

/* A lone difference, whichever thread has its n. */
static void a_lone_mismatch_of_any_thread_is_kept(void **state)
{
    (void)state;
    for (uint32_t n = 0; n < GLINT_N_COUNT; n += GLINT_N_COUNT / THREADS) {
        const plant what = {
            .where = at_n_and_code, .value = GLINT_ANSWER_G, .n = n, .code = 0x2aaaa};
        glint_exhaustive_options options = options_for(sound);
        options.shards = GLINT_N_COUNT / THREADS;
        options.threads = THREADS;
        awaited = THREADS;
        plant_and_compare(&what, options);
        awaited = 0;
        assert_int_equal(arrived, THREADS);
        assert_counts((uint64_t)THREADS * 2 * CODES + W_CODES + 15, 2);
        assert_int_equal(result.kept, 2);
        assert_int_equal(result.mismatch[0].n, n);
        assert_int_equal(result.mismatch[0].answer.material.n, n);
    }
}

/* ---- Every lane
 * -----------------------------------------------------------------------------------
 */

/* How often each lane was given each code; a run whose n are not 2. */
enum { WHITE, COLORED, MULTIPLIERS, SWEEPS };
static uint8_t met[SWEEPS][LANES][CODES];

static bool note_lane(const point *point)
{
    const glint_material *material = point->material;
    const int sweep = material->n == 2                           ? MULTIPLIERS
                      : material->r == 255 && material->g == 255 ? WHITE
                                                                 : COLORED;
    met[sweep][point->lane][point->code]++;
    return false;
}

static void note_lanes(glint_exhaustive_options options)
{
    const plant note = {.where = note_lane};
    memset(met, 0, sizeof met);
    plant_and_compare(&note, options);
}

static void assert_every_lane_met_every_code(int sweep)
{
    for (int lane = 0; lane < LANES; lane++) {
        for (uint32_t code = 0; code < CODES; code++) {
            if (met[sweep][lane][code] != 1) {
                fail_msg("sweep %d: code 0x%05" PRIx32 " came %d times to lane %d", sweep, code,
                         met[sweep][lane][code], lane);
            }
        }
    }
}

/* Sixteen n take every code through every lane: white once, and in colour once. */
static void lanes_turn_from_n_to_n(void **state)
{
    (void)state;
    glint_exhaustive_options options = options_for(sound);
    options.from = GLINT_N_MAX - 15;
    note_lanes(options);
    assert_counts(16 * (2 * CODES + QUARTER + 16), 0);
    assert_every_lane_met_every_code(WHITE);
    assert_every_lane_met_every_code(COLORED);
}

/* White and in colour it is not the same lane. */
static void the_two_sweeps_of_an_n_take_two_lanes(void **state)
{
    (void)state;
    note_lanes(only_n(options_for(sound), 100));
    for (int lane = 0; lane < LANES; lane++)
        for (uint32_t code = 0; code < CODES; code++)
            assert_true(met[WHITE][lane][code] + met[COLORED][lane][code] <= 1);
}

/* Two lanes in the middle answer with each other's W, for one n and one W that one code has. */
static glint_status shade_swapped(glint_rtl *rtl, const glint_material *material,
                                  const glint_points *points, glint_error *err)
{
    const glint_status status = __real_glint_rtl_shade(rtl, material, points, err);
    for (size_t i = 7; i + 1 < points->count; i += LANES) {
        const uint32_t w = points->w[i];
        if (material->n == planted.n && w == planted.code) {
            points->w[i] = points->w[i + 1];
            points->w[i + 1] = w;
            alterations++;
        }
    }
    return status;
}

/* Once in each of the sweeps white and in colour, two values each time. The multipliers' sweep has
 * n = 2, not this one. */
static void two_lanes_swapped_for_one_point_are_found_by_every_lane(void **state)
{
    (void)state;
    static const uint32_t n = 513;
    const glint_material material = {(uint16_t)n, 255, 255, 255};
    const uint32_t code = GLINT_COS_ONE - 700;
    uint32_t w;
    uint8_t r, g, b;
    assert_int_equal(glint_specular_batch(GLINT_GATE_COSINE, &material, &code, 1, &w, &r, &g, &b),
                     GLINT_OK);
    assert_in_range(w, 1, GLINT_W_ONE - 1);
    mock = (mock_rtl){.shade = shade_swapped};
    planted = (plant){.n = n, .code = w};
    glint_exhaustive_options options = only_n(options_for(sound), n);
    options.setting[0].verilog = mock_verilog;
    options.every_lane = true;
    compare(options);
    assert_int_equal(alterations, 2);
    assert_counts((uint64_t)LANES * (2 * CODES + QUARTER), 4);
    assert_int_equal(result.circuit[0].pairs, (uint64_t)LANES * QUARTER);
    assert_int_equal(result.circuit[0].pairs_total, (uint64_t)LANES * W_CODES * 256);
}

/* n = 768 has the quarter of the multipliers that does not fill its clocks. */
static void every_lane_sees_every_code(void **state)
{
    (void)state;
    const uint64_t of_a_lane = 2 * CODES + QUARTER + 16;
    glint_exhaustive_options options = only_n(options_for(sound), 768);
    uint64_t in_multipliers = 0;
    options.every_lane = true;
    note_lanes(options);
    assert_counts(LANES * of_a_lane, 0);
    assert_every_lane_met_every_code(WHITE);
    assert_every_lane_met_every_code(COLORED);
    for (int lane = 0; lane < LANES; lane++)
        for (uint32_t code = 0; code < CODES; code++)
            in_multipliers += met[MULTIPLIERS][lane][code] != 0;
    assert_int_equal(in_multipliers, (uint64_t)LANES * (QUARTER + 1));
}

static bool in_lane(const point *point)
{
    return point->lane == planted.lane;
}

/* Each lane's differences are counted, and told of that lane. */
static void the_differences_of_each_lane_are_found(void **state)
{
    (void)state;
    for (int lane = 0; lane < LANES; lane++) {
        const plant what = {
            .where = in_lane, .value = (glint_answer_value)(lane % 4), .lane = lane};
        plant_and_compare(&what, only_n(options_for(sound), 40));
        assert_counts(2 * CODES + QUARTER, (2 * CODES + QUARTER) / LANES);
        for (int i = 0; i < result.kept; i++)
            assert_int_equal(result.mismatch[i].answer.at % LANES, lane);
    }
}

/* The lanes of a number that is no power of two: of a sweep each sees its part, and the codes that
 * each is given are all of them together. */
static bool note_code(const point *point)
{
    met[WHITE][0][point->code] = 1;
    return false;
}

static void any_number_of_lanes_sees_every_code(void **state)
{
    (void)state;
    static const int lanes[] = {3, 32};
    for (size_t i = 0; i < sizeof lanes / sizeof lanes[0]; i++) {
        const plant note = {.where = note_code};
        glint_specular_config config = sound;
        config.lanes = lanes[i];
        const uint64_t l = (uint64_t)lanes[i];
        memset(met, 0, sizeof met);
        plant_and_compare(&note, only_n(options_for(config), 80));
        const uint64_t sweep = (CODES + l - 1) / l * l;
        assert_counts(2 * sweep + (QUARTER + l - 1) / l * l, 0);
        assert_int_equal(result.circuit[0].pairs, QUARTER);
        for (uint32_t code = 0; code < CODES; code++)
            assert_int_equal(met[WHITE][0][code], 1);
    }
}

/* Lanes that a clock cannot be filled with are refused before anything is planned. */
static void lanes_that_are_none_are_refused(void **state)
{
    (void)state;
    static const int lanes[] = {0, 33, 1000, -1};
    for (size_t i = 0; i < sizeof lanes / sizeof lanes[0]; i++) {
        glint_error err;
        glint_exhaustive_options options = options_for(sound);
        glint_highlight_set_lanes(&options.setting[0], lanes[i]);
        assert_int_equal(glint_exhaustive_run(&options, &result, &err), GLINT_BAD_ARGUMENT);
        assert_non_null(strstr(err.text, "is not from 1 to 32"));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_value_of_every_point_is_compared),
        cmocka_unit_test(one_difference_in_each_run_is_found),
        cmocka_unit_test(a_code_comes_once_in_each_sweep),
        cmocka_unit_test(the_multipliers_see_every_w),
        cmocka_unit_test(a_wrong_saturation_of_the_first_code_is_found),
        cmocka_unit_test(colors_and_strides_change_with_n),
        cmocka_unit_test(the_mismatches_of_every_thread_count),
        cmocka_unit_test(a_lone_mismatch_of_any_thread_is_kept),
        cmocka_unit_test(lanes_turn_from_n_to_n),
        cmocka_unit_test(the_two_sweeps_of_an_n_take_two_lanes),
        cmocka_unit_test(two_lanes_swapped_for_one_point_are_found_by_every_lane),
        cmocka_unit_test(every_lane_sees_every_code),
        cmocka_unit_test(the_differences_of_each_lane_are_found),
        cmocka_unit_test(any_number_of_lanes_sees_every_code),
        cmocka_unit_test(lanes_that_are_none_are_refused),
    };
    return golden_run_group_tests(tests, NULL, NULL);
}
