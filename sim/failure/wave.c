#include "failure/wave.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include <gtkwave/fstapi.h> /* comes with Verilator */

#include "failure/pins.h"
#include "failure/wave_signals.h"
#include "file/room.h"
#include "lockstep/mismatch.h"
#include "wave/gtkw.h"
#include "wave/waveform.h"

#define HALF_PERIOD (GLINT_RTL_TRACE_PERIOD / 2)

/* One variable of the file, and what it was last. */
typedef struct variable {
    fstHandle handle;
    int width; /* 0: not there */
    bool written;
    uint64_t bits;
    fstHandle number; /* what bits stand for, as a variable of its own; 0: none */
    int frac_bits;    /* if there is one */
} variable;

typedef struct writer {
    void *fst;
    const glint_capture *capture;
    variable mismatch, clock, clk;
    variable pin[GLINT_PINS_MAX];
    variable rtl[GLINT_SETTING_SIGNALS_MAX], model[GLINT_SETTING_SIGNALS_MAX];
    variable differs[GLINT_SETTING_SIGNALS_MAX]; /* of signals that never do: not there */
} writer;

static variable declare(const writer *w, const char *name, const char *ending, int width)
{
    char text[64];
    if (width > 1)
        (void)snprintf(text, sizeof text, "%s%s [%d:0]", name, ending, width - 1);
    else
        (void)snprintf(text, sizeof text, "%s%s", name, ending);
    return (variable){.width = width,
                      .handle = fstWriterCreateVar(w->fst, FST_VT_VCD_WIRE, FST_VD_IMPLICIT,
                                                   (uint32_t)width, text, 0)};
}

/* A text: of a real number GTKWave would put the exponent where a narrow clock cuts it off. */
static void declare_number(const writer *w, variable *of, int frac_bits, const char *name,
                           const char *ending)
{
    char text[64];
    if (frac_bits == 0)
        return;
    (void)snprintf(text, sizeof text, "%s%s%s", name, ending, GLINT_FAILURE_REAL);
    of->number = fstWriterCreateVar(w->fst, FST_VT_GEN_STRING, FST_VD_IMPLICIT, 0, text, 0);
    of->frac_bits = frac_bits;
}

static void declare_pins(writer *w, int lane)
{
    const glint_setting *setting = &w->capture->setting;
    for (int i = 0; i < glint_pin_count(setting); i++) {
        const glint_pin_info pin = glint_pin(setting, i);
        if (pin.lane != lane)
            continue;
        w->pin[i] = declare(w, pin.name, "", pin.width);
        declare_number(w, &w->pin[i], pin.frac_bits, pin.name, "");
    }
}

static void declare_signals(writer *w, int lane)
{
    const glint_setting *setting = &w->capture->setting;
    for (int i = 0; i < glint_setting_signal_count(setting); i++) {
        const glint_signal_info signal = glint_setting_signal(setting, i);
        const int width = signal.int_bits + signal.frac_bits;
        if (signal.lane != lane)
            continue;
        w->rtl[i] = declare(w, signal.name, GLINT_FAILURE_RTL, width);
        w->model[i] = declare(w, signal.name, GLINT_FAILURE_MODEL, width);
        declare_number(w, &w->rtl[i], signal.frac_bits, signal.name, GLINT_FAILURE_RTL);
        declare_number(w, &w->model[i], signal.frac_bits, signal.name, GLINT_FAILURE_MODEL);
        if (glint_capture_differs(w->capture, i))
            w->differs[i] = declare(w, signal.name, GLINT_FAILURE_DIFFERS, 1);
    }
}

static void open_scope(const writer *w, const char *name)
{
    fstWriterSetScope(w->fst, FST_ST_VCD_MODULE, name, NULL);
}

static void declare_all(writer *w)
{
    const glint_setting *setting = &w->capture->setting;
    int last_lane = -1;
    for (int i = 0; i < glint_setting_signal_count(setting); i++) {
        const glint_signal_info signal = glint_setting_signal(setting, i);
        last_lane = signal.lane > last_lane ? signal.lane : last_lane;
    }
    open_scope(w, "TOP");
    w->mismatch = declare(w, "mismatch", "", 1);
    w->clock = declare(w, "clock", "", GLINT_FAILURE_CLOCK_BITS);
    w->clk = declare(w, "clk", "", 1);
    declare_pins(w, -1);
    declare_signals(w, -1);
    for (int lane = setting->is_divider ? 1 : 0; lane <= last_lane; lane++) {
        char name[32];
        (void)snprintf(name, sizeof name, "%s[%d]", glint_setting_lane_name(setting), lane);
        open_scope(w, name);
        declare_pins(w, lane);
        declare_signals(w, lane);
        fstWriterSetUpscope(w->fst);
    }
    fstWriterSetUpscope(w->fst);
}

/* Whether it changes something. */
static bool put(const writer *w, variable *variable, uint64_t bits)
{
    char text[65];
    if (variable->width == 0 || (variable->written && variable->bits == bits))
        return false;
    for (int i = 0; i < variable->width; i++)
        text[i] = (char)('0' + (bits >> (variable->width - 1 - i) & 1));
    fstWriterEmitValueChange(w->fst, variable->handle, text);
    variable->written = true;
    variable->bits = bits;
    return true;
}

static void put_text(const writer *w, const variable *variable, const char *text)
{
    if (variable->number != 0)
        fstWriterEmitVariableLengthValueChange(w->fst, variable->number, text,
                                               (uint32_t)strlen(text));
}

/* All its digits, no exponent: as many places behind the point as the code has, less what is 0. */
static void put_number(const writer *w, const variable *variable, double number)
{
    char text[64];
    int length = snprintf(text, sizeof text, "%.*f", variable->frac_bits, number);
    while (variable->frac_bits > 0 && (text[length - 1] == '0' || text[length - 1] == '.'))
        if (text[--length] == '.')
            break;
    text[length] = '\0';
    put_text(w, variable, text);
}

static void put_signal(const writer *w, variable *variable, const glint_signal_info *signal,
                       uint64_t bits)
{
    if (put(w, variable, bits))
        put_number(w, variable, glint_mismatch_number(signal, bits));
}

static void put_pins(writer *w, const glint_capture_clock *clock)
{
    const glint_setting *setting = &w->capture->setting;
    for (int i = 0; i < glint_pin_count(setting); i++) {
        const uint64_t mask = (UINT64_C(1) << w->pin[i].width) - 1;
        const int64_t value = glint_pin_get(setting, &clock->pins, i);
        if (put(w, &w->pin[i], (uint64_t)value & mask))
            put_number(w, &w->pin[i], (double)value / (double)(UINT64_C(1) << w->pin[i].frac_bits));
    }
}

static void put_signals(writer *w, const glint_capture_clock *clock)
{
    bool any = false;
    for (int i = 0; i < glint_setting_signal_count(&w->capture->setting); i++) {
        const glint_signal_info signal = glint_setting_signal(&w->capture->setting, i);
        const bool differs = clock->rtl[i] != clock->model[i];
        put_signal(w, &w->rtl[i], &signal, clock->rtl[i]);
        put_signal(w, &w->model[i], &signal, clock->model[i]);
        put(w, &w->differs[i], differs);
        any |= differs;
    }
    put(w, &w->mismatch, any);
}

static void put_clock(writer *w, const glint_capture_clock *clock)
{
    const uint64_t edge = clock->clock * GLINT_RTL_TRACE_PERIOD;
    fstWriterEmitTimeChange(w->fst, edge - HALF_PERIOD);
    put(w, &w->clk, 0);
    put_pins(w, clock);
    fstWriterEmitTimeChange(w->fst, edge);
    put(w, &w->clk, 1);
    put(w, &w->clock, clock->clock);
    put_signals(w, clock);
}

static void put_unknown(const writer *w, const variable *variable)
{
    char text[65];
    memset(text, 'x', (size_t)variable->width);
    if (variable->width > 0)
        fstWriterEmitValueChange(w->fst, variable->handle, text);
    put_text(w, variable, "x");
}

/* Nothing was played behind the last clock: from here on all is unknown. */
static void put_end(const writer *w)
{
    const glint_setting *setting = &w->capture->setting;
    put_unknown(w, &w->mismatch);
    put_unknown(w, &w->clock);
    put_unknown(w, &w->clk);
    for (int i = 0; i < glint_pin_count(setting); i++)
        put_unknown(w, &w->pin[i]);
    for (int i = 0; i < glint_setting_signal_count(setting); i++) {
        put_unknown(w, &w->rtl[i]);
        put_unknown(w, &w->model[i]);
        put_unknown(w, &w->differs[i]);
    }
}

static glint_status record(const void *context, const char *path, glint_error *err)
{
    writer w = {.capture = context};
    const glint_status status = glint_file_room(path, GLINT_WAVE_ROOM, err);
    if (status != GLINT_OK)
        return status;
    w.fst = fstWriterCreate(path, 1);
    if (w.fst == NULL)
        return glint_fail(err, GLINT_IO_ERROR, "%s: cannot write a waveform", path);
    fstWriterSetPackType(w.fst, FST_WR_PT_LZ4);
    fstWriterSetTimescaleFromString(w.fst, "1ns");
    declare_all(&w);
    for (int i = 0; i < w.capture->count; i++)
        put_clock(&w, &w.capture->clock[i]);
    const glint_failure_times times = glint_failure_times_of(w.capture);
    fstWriterEmitTimeChange(w.fst, times.last_edge + HALF_PERIOD);
    put(&w, &w.clk, 0);
    if (times.end > times.last_edge + HALF_PERIOD) {
        fstWriterEmitTimeChange(w.fst, times.last_edge + GLINT_RTL_TRACE_PERIOD);
        put_end(&w);
        fstWriterEmitTimeChange(w.fst, times.end);
    }
    fstWriterClose(w.fst);
    return GLINT_OK;
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
    return glint_wave_write(path, GLINT_WAVE_FST, record, capture, err);
}
