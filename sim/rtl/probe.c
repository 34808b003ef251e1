/* Generates the probe module's Verilog; see probe.h. */
#define _POSIX_C_SOURCE 200809L

#include "rtl/probe.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/words.h"

/* The probe while it is written. */
typedef struct writer {
    const glint_setting *setting;
    const glint_ports *ports;
    glint_probe *probe;
    FILE *out;
    int room; /* in probe->line */
    bool failed;
} writer;

/* One line, and what it is about. */
__attribute__((format(printf, 4, 5))) static void line(writer *w, glint_probe_part part, int index,
                                                       const char *format, ...)
{
    if (w->probe->lines == w->room) {
        w->room = 2 * w->room + 64;
        glint_probe_line *grown = realloc(w->probe->line, (size_t)w->room * sizeof *grown);
        if (grown == NULL) {
            w->failed = true;
            w->room = w->probe->lines;
            return;
        }
        w->probe->line = grown;
    }
    w->probe->line[w->probe->lines++] = (glint_probe_line){part, index};
    va_list arguments;
    va_start(arguments, format);
    vfprintf(w->out, format, arguments);
    va_end(arguments);
    fputc('\n', w->out);
}

static bool is_below(const glint_signal_info *signal)
{
    return !glint_signal_is_port(signal->kind);
}

static void write_ports(writer *w)
{
    const glint_circuit *circuit = w->setting->circuit;
    const char *comma = "";
    /* So a port may be called as a word of SystemVerilog is, where its own file allows it. */
    line(w, GLINT_PROBE_OTHER, 0, "`begin_keywords \"1364-2005\"");
    line(w, GLINT_PROBE_OTHER, 0, "module " GLINT_PROBE_MODULE " (");
    if (circuit->clock_port != NULL) {
        line(w, GLINT_PROBE_OTHER, 0, "    input wire " GLINT_PROBE_CLOCK);
        comma = ", ";
    }
    for (int i = 0; i < w->ports->count; i++, comma = ", ")
        line(w, GLINT_PROBE_OTHER, 0, "    %s%s wire [%d:0] glint_p%d", comma,
             w->ports->port[i].is_output ? "output" : "input", w->ports->port[i].width - 1, i);
    for (int i = 0; i < w->ports->signals; i++) {
        const glint_signal_info signal = circuit->signal(w->setting->values, i);
        if (is_below(&signal))
            line(w, GLINT_PROBE_OTHER, 0, "    , output wire [%d:0] glint_s%d",
                 glint_signal_width(&signal) - 1, i);
    }
    line(w, GLINT_PROBE_OTHER, 0, ");");
}

/* "#(.A(1), .B(2))", or nothing: Verilog has no empty list. */
static void write_parameters(writer *w)
{
    const glint_circuit *circuit = w->setting->circuit;
    const char *before = "#(";
    for (int i = 0; i < circuit->parameter_count; i++)
        if (circuit->parameters[i].verilog != NULL) {
            line(w, GLINT_PROBE_PARAMETER, i, "        %s.%s(%d)", before,
                 circuit->parameters[i].verilog, w->setting->values[i]);
            before = ", ";
        }
    line(w, GLINT_PROBE_TOP, 0, "    %s dut (", before[0] == ',' ? ")" : "");
}

static void write_instance(writer *w)
{
    const glint_circuit *circuit = w->setting->circuit;
    const char *comma = "";
    line(w, GLINT_PROBE_TOP, 0, "    %s", glint_setting_top(w->setting));
    write_parameters(w);
    if (circuit->clock_port != NULL) {
        line(w, GLINT_PROBE_CLOCK_PIN, 0, "        .%s(" GLINT_PROBE_CLOCK ")",
             circuit->clock_port);
        comma = ", ";
    }
    for (int i = 0; i < w->ports->count; i++, comma = ", ")
        line(w, GLINT_PROBE_PORT, i, "        %s.%s(glint_p%d)", comma, w->ports->port[i].name, i);
    line(w, GLINT_PROBE_OTHER, 0, "    );");
}

void glint_probe_path(const glint_setting *setting, const glint_signal_info *signal,
                      char path[GLINT_PROBE_PATH])
{
    const char *scope = setting->circuit->lane_scope;
    const char *name = signal->path != NULL ? signal->path : signal->name;
    const char *number = signal->lane >= 0 && scope != NULL ? strstr(scope, "%d") : NULL;
    if (signal->lane < 0 || scope == NULL)
        (void)snprintf(path, GLINT_PROBE_PATH, "%s", name);
    else if (number == NULL)
        (void)snprintf(path, GLINT_PROBE_PATH, "%s.%s", scope, name);
    else
        (void)snprintf(path, GLINT_PROBE_PATH, "%.*s%d%s.%s", (int)(number - scope), scope,
                       signal->lane, number + 2, name);
}

static void write_signals(writer *w)
{
    for (int i = 0; i < w->ports->signals; i++) {
        const glint_signal_info signal = w->setting->circuit->signal(w->setting->values, i);
        char path[GLINT_PROBE_PATH];
        if (!is_below(&signal))
            continue;
        glint_probe_path(w->setting, &signal, path);
        line(w, GLINT_PROBE_SIGNAL, i, "    assign glint_s%d = dut.%s;", i, path);
    }
}

glint_status glint_probe_make(const glint_setting *setting, const glint_ports *ports,
                              glint_probe *probe, glint_error *err)
{
    *probe = (glint_probe){0};
    writer w = {setting, ports, probe, open_memstream(&probe->text, &probe->size), 0, false};
    if (w.out == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the probe of a circuit");
    write_ports(&w);
    write_instance(&w);
    write_signals(&w);
    line(&w, GLINT_PROBE_OTHER, 0, "endmodule");
    line(&w, GLINT_PROBE_OTHER, 0, "`end_keywords");
    const bool failed = ferror(w.out) != 0;
    if (fclose(w.out) != 0 || failed || w.failed) {
        glint_probe_free(probe);
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the probe of a circuit");
    }
    return GLINT_OK;
}

void glint_probe_free(glint_probe *probe)
{
    free(probe->text);
    free(probe->line);
    *probe = (glint_probe){0};
}
