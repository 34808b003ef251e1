/* Circuits are created and destroyed in any order and in any thread, and the remaining ones still
 * work. */
#define _XOPEN_SOURCE 700

#include <dirent.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../wave/vcd.h"

#include "circuit/circuits.h"
#include "circuit/words.h"
#include "rtl/batch.h"
#include "wave/waveform.h"

#define CIRCUITS 4

static const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 4};

static glint_rtl *opened(glint_setting setting, glint_rtl_kind kind)
{
    glint_rtl *rtl;
    glint_error err;
    if (glint_rtl_open(&setting, kind, &rtl, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    return rtl;
}

static glint_rtl *created(void)
{
    return opened(glint_setting_specular(&config), GLINT_RTL_OBSERVED);
}

static glint_rtl *created_divider(glint_divider_form form, int shifts)
{
    return opened(glint_setting_divider(form, shifts), GLINT_RTL_FST);
}

/* Register 2 is the first signal. */
static uint64_t first_signal(const glint_rtl *rtl)
{
    static uint64_t words[GLINT_SIGNAL_WORDS_MAX];
    glint_rtl_read(rtl, words);
    return words[0];
}

/* Lane 0's output of that name. */
static uint64_t output(const glint_rtl *rtl, const char *name)
{
    static uint64_t words[GLINT_SIGNAL_WORDS_MAX];
    static int place[GLINT_SIGNAL_WORDS_MAX];
    const glint_setting *setting = glint_rtl_setting(rtl);
    int index = 0;
    assert_true(glint_signal_places(setting, place));
    for (;; index++) {
        assert_true(index < setting->circuit->signal_count(setting->values));
        const glint_signal_info info = setting->circuit->signal(setting->values, index);
        if (info.kind == GLINT_SIGNAL_OUTPUT && info.lane <= 0 && strcmp(info.name, name) == 0)
            break;
    }
    glint_rtl_read(rtl, words);
    return words[place[index]];
}

/* The centre of a highlight leaves the circuit as the colour it came with. */
static void assert_works(glint_rtl *rtl)
{
    const glint_specular_inputs first = {.en = 1,
                                         .n_we = 1,
                                         .n = 80,
                                         .rgb_we = 1,
                                         .r = 200,
                                         .g = 100,
                                         .b = 50,
                                         .in_valid = 1,
                                         .cos = {GLINT_COS_ONE}};
    const glint_specular_inputs rest = {.en = 1};
    glint_rtl_clock(rtl, &first);
    for (int i = 1; i < GLINT_LATENCY_PIPELINED; i++)
        glint_rtl_clock(rtl, &rest);
    assert_true(output(rtl, "out_w") == GLINT_W_ONE);
    assert_true(output(rtl, "out_r") == 200 && output(rtl, "out_g") == 100);
    assert_true(output(rtl, "out_b") == 50);
}

/* The same of one that can be read: register 2 has the n. */
static void assert_is_read(glint_rtl *rtl)
{
    const glint_specular_inputs material = {.en = 1, .n_we = 1, .n = 80};
    assert_works(rtl);
    glint_rtl_clock(rtl, &material);
    assert_true(first_signal(rtl) == 80);
}

static void in_any_order(void **state)
{
    (void)state;
    static const int orders[][CIRCUITS] = {{0, 1, 2, 3}, {3, 2, 1, 0}, {2, 0, 3, 1}};
    for (size_t o = 0; o < sizeof orders / sizeof orders[0]; o++) {
        glint_rtl *rtl[CIRCUITS];
        for (int i = 0; i < CIRCUITS; i++)
            rtl[i] = created();
        for (int i = 0; i < CIRCUITS; i++) {
            glint_rtl_destroy(rtl[orders[o][i]]);
            for (int j = i + 1; j < CIRCUITS; j++)
                assert_is_read(rtl[orders[o][j]]);
        }
    }
}

static void *destroy_in_thread(void *rtl)
{
    glint_rtl_destroy(rtl);
    return NULL;
}

static void in_another_thread(void **state)
{
    (void)state;
    glint_rtl *rtl[CIRCUITS];
    pthread_t thread[CIRCUITS];
    for (int i = 0; i < CIRCUITS; i++)
        rtl[i] = created();
    for (int i = 0; i < CIRCUITS - 1; i++)
        assert_int_equal(pthread_create(&thread[i], NULL, destroy_in_thread, rtl[i]), 0);
    for (int i = 0; i < CIRCUITS - 1; i++)
        assert_int_equal(pthread_join(thread[i], NULL), 0);
    assert_is_read(rtl[CIRCUITS - 1]);
    glint_rtl_destroy(rtl[CIRCUITS - 1]);
    glint_rtl *after = created();
    assert_works(after);
    glint_rtl_destroy(after);
}

static void with_dividers_between(void **state)
{
    (void)state;
    glint_error err;
    const glint_division division = {{255, -255, 7}, 5};
    glint_quotients quotients;
    glint_rtl *first = created();
    glint_rtl *divider = created_divider(GLINT_DIVIDER_PIPELINED, 12);
    glint_rtl_destroy(first);
    assert_int_equal(glint_rtl_divide(divider, &division, 1, &quotients, &err), GLINT_OK);
    assert_int_equal(quotients.code[0], -quotients.code[1]);
    glint_rtl *second = created();
    glint_rtl_destroy(divider);
    assert_works(second);
    glint_rtl_destroy(second);
}

/* Clocks 2 to 11: the first edge is that of the reset of creation. */
static void assert_ten_clocks(const char *path)
{
    assert_true(glint_wave_is_whole(path));
    vcd wave = vcd_read_fst(path);
    assert_true(wave.signal_count > 0);
    assert_true(wave.last_time - wave.first_time == 10 * GLINT_RTL_TRACE_PERIOD);
    vcd_free(&wave);
}

/* A waveform that is closed is whole while its circuit lives on, and takes no more clocks. */
static void with_waveforms_closed_before_they_end(void **state)
{
    (void)state;
    const glint_specular_inputs inputs = {.en = 1};
    const glint_divider_inputs divider_inputs = {.en = 1};
    glint_error err;
    glint_rtl *rtl = opened(glint_setting_specular(&config), GLINT_RTL_FST);
    glint_rtl *divider = created_divider(GLINT_DIVIDER_SEQUENTIAL, 8);
    assert_int_equal(glint_rtl_trace_open(rtl, scratch_path("rtl.fst"), &err), GLINT_OK);
    assert_int_equal(glint_rtl_trace_open(divider, scratch_path("divider.fst"), &err), GLINT_OK);
    for (int i = 0; i < 30; i++) {
        if (i == 10) {
            glint_rtl_trace_close(rtl);
            glint_rtl_trace_close(divider);
        }
        glint_rtl_clock(rtl, &inputs);
        glint_rtl_clock(divider, &divider_inputs);
    }
    assert_ten_clocks(scratch_path("rtl.fst"));
    assert_ten_clocks(scratch_path("divider.fst"));
    glint_rtl_trace_close(rtl); /* without one, nothing happens */
    assert_works(rtl);
    glint_rtl_destroy(rtl);
    glint_rtl_destroy(divider);
}

/* Threads of this process. */
static int threads(void)
{
    int count = 0;
    DIR *tasks = opendir("/proc/self/task");
    assert_non_null(tasks);
    for (const struct dirent *task; (task = readdir(tasks)) != NULL;)
        count += task->d_name[0] != '.';
    (void)closedir(tasks);
    return count;
}

/* Verilator's own default is one more for each further processor, which on a large machine is more
 * than a process may have. */
static void without_threads_of_their_own(void **state)
{
    (void)state;
    glint_rtl *rtl = created();
    glint_rtl *divider = created_divider(GLINT_DIVIDER_PIPELINED, 12);
    assert_int_equal(threads(), 1);
    glint_rtl_destroy(rtl);
    glint_rtl_destroy(divider);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(in_any_order),
        cmocka_unit_test(in_another_thread),
        cmocka_unit_test(with_dividers_between),
        cmocka_unit_test(with_waveforms_closed_before_they_end),
        cmocka_unit_test(without_threads_of_their_own),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
