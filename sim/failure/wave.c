/* Writes the VCD file of a capture, with both sides of every signal, and its GTKWave save file. */
#include "failure/wave.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "circuit/words.h"
#include "failure/wave_signals.h"
#include "file/new_file.h"
#include "rtl/rtl.h"
#include "wave/gtkw.h"

#define HALF_PERIOD (GLINT_RTL_TRACE_PERIOD / 2)

/* The precision of a double: codes up to this width convert without loss. */
#define EXACT_BITS 53

/* What the short names of the variables are numbered by, from 0 on. */
enum { MISMATCH, CLOCK, CLK, FIRST_PIN };
enum { PIN, PIN_NUMBER, OF_A_PIN };
enum { RTL, MODEL, RTL_NUMBER, MODEL_NUMBER, DIFFERS, OF_A_SIGNAL };

typedef struct writer {
    FILE *out;
    const glint_capture *capture;
    int pins;
} writer;

static int pin_id(int index, int of_it)
{
    return FIRST_PIN + index * OF_A_PIN + of_it;
}

static int signal_id(const writer *w, int index, int of_it)
{
    return pin_id(w->pins, 0) + index * OF_A_SIGNAL + of_it;
}

/* A variable's short name: its number in printed characters. */
static void print_id(const writer *w, int id)
{
    const int first = '!', count = '~' - '!' + 1;
    for (; id >= count; id = id / count - 1)
        fputc(first + id % count, w->out);
    fputc(first + id, w->out);
}

/* ---- Declarations -------------------------------------------------------------------------------
 */

static void declare(const writer *w, int id, const char *name, const char *ending, int width)
{
    fprintf(w->out, "$var wire %d ", width);
    print_id(w, id);
    fprintf(w->out, " %s%s", name, ending);
    if (width > 1)
        fprintf(w->out, " [%d:0]", width - 1);
    fprintf(w->out, " $end\n");
}

/* A text: of a real number GTKWave would put the exponent where a narrow clock cuts it off. */
static void declare_number(const writer *w, int id, int frac_bits, const char *name,
                           const char *ending)
{
    if (frac_bits == 0)
        return;
    fprintf(w->out, "$var string 1 ");
    print_id(w, id);
    fprintf(w->out, " %s%s%s $end\n", name, ending, GLINT_FAILURE_REAL);
}

static void declare_pins(const writer *w, int lane)
{
    for (int i = 0; i < w->pins; i++) {
        const glint_pin_info pin = glint_setting_pin(&w->capture->setting, i);
        if (pin.lane != lane)
            continue;
        declare(w, pin_id(i, PIN), pin.name, "", glint_pin_width(&pin));
        declare_number(w, pin_id(i, PIN_NUMBER), pin.frac_bits, pin.name, "");
    }
}

static void declare_signal(const writer *w, int index)
{
    const glint_signal_info *signal = &w->capture->signals.info[index];
    const int width = glint_signal_width(signal);
    declare(w, signal_id(w, index, RTL), signal->name, GLINT_FAILURE_RTL, width);
    declare(w, signal_id(w, index, MODEL), signal->name, GLINT_FAILURE_MODEL, width);
    declare_number(w, signal_id(w, index, RTL_NUMBER), signal->frac_bits, signal->name,
                   GLINT_FAILURE_RTL);
    declare_number(w, signal_id(w, index, MODEL_NUMBER), signal->frac_bits, signal->name,
                   GLINT_FAILURE_MODEL);
    if (glint_capture_differs(w->capture, index))
        declare(w, signal_id(w, index, DIFFERS), signal->name, GLINT_FAILURE_DIFFERS, 1);
}

static void declare_signals(const writer *w, int lane)
{
    for (int i = 0; i < w->capture->signals.count; i++)
        if (w->capture->signals.info[i].lane == lane)
            declare_signal(w, i);
}

static bool has_lane(const writer *w, int lane)
{
    bool has = false;
    for (int i = 0; i < w->pins; i++)
        has |= glint_setting_pin(&w->capture->setting, i).lane == lane;
    for (int i = 0; i < w->capture->signals.count; i++)
        has |= w->capture->signals.info[i].lane == lane;
    return has;
}

static int last_lane(const writer *w)
{
    int last = -1;
    for (int i = 0; i < w->capture->signals.count; i++)
        if (w->capture->signals.info[i].lane > last)
            last = w->capture->signals.info[i].lane;
    return last;
}

const char *glint_failure_own_name(const glint_setting *setting, glint_failure_own which)
{
    static const char *const names[] = {"glint_mismatch", "glint_clock", "glint_clk"};
    const char *name = names[which] + strlen("glint_");
    for (int i = 0; i < glint_setting_pin_count(setting); i++)
        if (strcmp(glint_setting_pin(setting, i).name, name) == 0)
            return names[which];
    return name;
}

static void declare_own(const writer *w, int id, glint_failure_own which, int width)
{
    declare(w, id, glint_failure_own_name(&w->capture->setting, which), "", width);
}

static void declare_all(const writer *w)
{
    fprintf(w->out, "$version Glint $end\n$timescale 1ns $end\n$scope module TOP $end\n");
    declare_own(w, MISMATCH, GLINT_FAILURE_MISMATCH, 1);
    declare_own(w, CLOCK, GLINT_FAILURE_CLOCK, GLINT_FAILURE_CLOCK_BITS);
    declare_own(w, CLK, GLINT_FAILURE_CLK, 1);
    declare_pins(w, -1);
    declare_signals(w, -1);
    for (int lane = 0; lane <= last_lane(w); lane++) {
        if (!has_lane(w, lane))
            continue;
        fprintf(w->out, "$scope module %s[%d] $end\n",
                glint_setting_lane_name(&w->capture->setting), lane);
        declare_pins(w, lane);
        declare_signals(w, lane);
        fprintf(w->out, "$upscope $end\n");
    }
    fprintf(w->out, "$upscope $end\n$enddefinitions $end\n");
}

/* ---- Values -------------------------------------------------------------------------------------
 */

static void put_time(const writer *w, uint64_t time)
{
    fprintf(w->out, "#%" PRIu64 "\n", time);
}

static void put_bit(const writer *w, int id, char bit)
{
    fputc(bit, w->out);
    print_id(w, id);
    fputc('\n', w->out);
}

static void put_bits(const writer *w, int id, int width, const uint64_t *words)
{
    if (width == 1) {
        put_bit(w, id, (words[0] & 1) != 0 ? '1' : '0');
        return;
    }
    fputc('b', w->out);
    for (int i = width - 1; i >= 0; i--)
        fputc((words[i / 64] >> i % 64 & 1) != 0 ? '1' : '0', w->out);
    fputc(' ', w->out);
    print_id(w, id);
    fputc('\n', w->out);
}

static void put_text(const writer *w, int id, const char *text)
{
    fprintf(w->out, "s%s ", text);
    print_id(w, id);
    fputc('\n', w->out);
}

/* All its digits, no exponent: as many places behind the point as the code has, less what is 0. Of
 * a code wider than a double it is the nearest. */
static void put_number(const writer *w, int id, int width, int frac_bits, bool is_signed,
                       const uint64_t *words)
{
    char text[128];
    const double number = glint_words_number(words, width, frac_bits, is_signed);
    if (width > EXACT_BITS || frac_bits > EXACT_BITS) {
        (void)snprintf(text, sizeof text, "%.17g", number);
        put_text(w, id, text);
        return;
    }
    int length = snprintf(text, sizeof text, "%.*f", frac_bits, number);
    while (text[length - 1] == '0' || text[length - 1] == '.')
        if (text[--length] == '.')
            break;
    text[length] = '\0';
    put_text(w, id, text);
}

static bool same(const uint64_t *a, const uint64_t *b, int width)
{
    return memcmp(a, b, (size_t)glint_words_of(width) * sizeof *a) == 0;
}

/* A value of clock `at` of the capture is written where the clock before had another. */
static void put_pin(const writer *w, int at, int index)
{
    const glint_capture_clock *clock = &w->capture->clock[at];
    const glint_pin_info pin = glint_setting_pin(&w->capture->setting, index);
    const int width = glint_pin_width(&pin);
    uint64_t words[GLINT_VALUE_WORDS], before[GLINT_VALUE_WORDS];
    glint_pin_get(&pin, &clock->pins, words);
    if (at > 0)
        glint_pin_get(&pin, &clock[-1].pins, before);
    if (at > 0 && same(words, before, width))
        return;
    put_bits(w, pin_id(index, PIN), width, words);
    if (pin.frac_bits > 0)
        put_number(w, pin_id(index, PIN_NUMBER), width, pin.frac_bits, pin.is_signed, words);
}

static void put_side(const writer *w, int index, int side, const uint64_t *words,
                     const uint64_t *before)
{
    const glint_signal_info *signal = &w->capture->signals.info[index];
    const int width = glint_signal_width(signal);
    if (before != NULL && same(words, before, width))
        return;
    put_bits(w, signal_id(w, index, side), width, words);
    if (signal->frac_bits > 0)
        put_number(w, signal_id(w, index, side == RTL ? RTL_NUMBER : MODEL_NUMBER), width,
                   signal->frac_bits, signal->is_signed, words);
}

/* Whether the signal differs. */
static bool put_signal(const writer *w, int at, int index)
{
    const glint_capture_clock *clock = &w->capture->clock[at];
    const int place = w->capture->signals.place[index];
    const bool differs = glint_capture_differs_at(w->capture, at, index);
    put_side(w, index, RTL, clock->rtl + place, at > 0 ? clock[-1].rtl + place : NULL);
    put_side(w, index, MODEL, clock->model + place, at > 0 ? clock[-1].model + place : NULL);
    if (glint_capture_differs(w->capture, index))
        put_bit(w, signal_id(w, index, DIFFERS), differs ? '1' : '0');
    return differs;
}

static void put_clock(const writer *w, int at)
{
    const glint_capture_clock *clock = &w->capture->clock[at];
    const uint64_t edge = clock->clock * GLINT_RTL_TRACE_PERIOD;
    bool any = false;
    put_time(w, edge - HALF_PERIOD);
    put_bit(w, CLK, '0');
    for (int i = 0; i < w->pins; i++)
        put_pin(w, at, i);
    put_time(w, edge);
    put_bit(w, CLK, '1');
    put_bits(w, CLOCK, GLINT_FAILURE_CLOCK_BITS, &clock->clock);
    for (int i = 0; i < w->capture->signals.count; i++)
        any |= put_signal(w, at, i);
    put_bit(w, MISMATCH, any ? '1' : '0');
}

static void put_unknown(const writer *w, int id, int width, int number_id, int frac_bits)
{
    if (width == 1)
        put_bit(w, id, 'x');
    else {
        fprintf(w->out, "bx ");
        print_id(w, id);
        fputc('\n', w->out);
    }
    if (frac_bits > 0)
        put_text(w, number_id, "x");
}

static void put_unknown_signal(const writer *w, int index)
{
    const glint_signal_info *signal = &w->capture->signals.info[index];
    const int width = glint_signal_width(signal);
    put_unknown(w, signal_id(w, index, RTL), width, signal_id(w, index, RTL_NUMBER),
                signal->frac_bits);
    put_unknown(w, signal_id(w, index, MODEL), width, signal_id(w, index, MODEL_NUMBER),
                signal->frac_bits);
    if (glint_capture_differs(w->capture, index))
        put_bit(w, signal_id(w, index, DIFFERS), 'x');
}

/* Nothing was replayed after the last clock: from here on everything is unknown. */
static void put_end(const writer *w)
{
    put_bit(w, MISMATCH, 'x');
    put_bit(w, CLK, 'x');
    put_unknown(w, CLOCK, GLINT_FAILURE_CLOCK_BITS, 0, 0);
    for (int i = 0; i < w->pins; i++) {
        const glint_pin_info pin = glint_setting_pin(&w->capture->setting, i);
        put_unknown(w, pin_id(i, PIN), glint_pin_width(&pin), pin_id(i, PIN_NUMBER), pin.frac_bits);
    }
    for (int i = 0; i < w->capture->signals.count; i++)
        put_unknown_signal(w, i);
}

static void write_all(const writer *w)
{
    const glint_failure_times times = glint_failure_times_of(w->capture);
    declare_all(w);
    for (int i = 0; i < w->capture->count; i++)
        put_clock(w, i);
    put_time(w, times.last_edge + HALF_PERIOD);
    put_bit(w, CLK, '0');
    if (times.end > times.last_edge + HALF_PERIOD) {
        put_time(w, times.last_edge + GLINT_RTL_TRACE_PERIOD);
        put_end(w);
        put_time(w, times.end);
    }
}

glint_failure_times glint_failure_times_of(const glint_capture *capture)
{
    const uint64_t period = GLINT_RTL_TRACE_PERIOD;
    glint_failure_times times = {
        .first = capture->clock[0].clock * period - HALF_PERIOD,
        .marker = capture->clock[capture->failing].clock * period,
        .last_edge = capture->clock[capture->count - 1].clock * period,
    };
    const uint64_t needed = glint_gtkw_end_for_marker(times.first, times.marker);
    times.end = needed > times.last_edge + period ? needed : times.last_edge + HALF_PERIOD;
    return times;
}

glint_status glint_failure_write_wave(const glint_capture *capture, const char *path,
                                      glint_error *err)
{
    glint_new_file *file;
    const glint_status status = glint_new_file_open(path, &file, err);
    if (status != GLINT_OK)
        return status;
    const writer w = {glint_new_file_stream(file), capture,
                      glint_setting_pin_count(&capture->setting)};
    write_all(&w);
    return glint_new_file_commit(file, err);
}
