/* Picks the one line worth showing from the output of Verilator or a compiler, and rewords it. */
#include "rtl/diagnosis.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/words.h"

/* A message of Verilator: "%Error-KIND: file:line:column: text"; file and position may be missing.
 */
typedef struct message {
    bool is_error;
    const char *begin; /* behind "%Error…: " */
    const char *text;  /* behind the position */
    const char *end;
    int in_probe; /* its line; 0: not about the probe */
} message;

typedef struct subject {
    const glint_setting *setting;
    const glint_ports *ports;
    const glint_probe *probe;
    const char *directory, *top;
} subject;

static const char *line_end(const char *line)
{
    return line + strcspn(line, "\n");
}

static bool begins(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}

/* Whether words stand in the message's text. */
static const char *find(const message *m, const char *words)
{
    const char *found = strstr(m->text, words);
    return found != NULL && found < m->end ? found : NULL;
}

/* Behind "file:12:3: ", where that stands at its beginning; the line in *line. */
static const char *skip_position(const char *text, const char *end, int *line)
{
    int row, column, length = 0;
    const char *colon = memchr(text, ':', (size_t)(end - text));
    if (colon == NULL || memchr(text, ' ', (size_t)(colon - text)) != NULL ||
        sscanf(colon, ":%d:%d: %n", &row, &column, &length) < 2 || length == 0)
        return text;
    *line = row;
    return colon + length;
}

/* The message that a line is, if it is one. */
static bool read_message(const char *line, message *m)
{
    const char *end = line_end(line);
    m->is_error = begins(line, "%Error");
    if (!m->is_error && !begins(line, "%Warning"))
        return false;
    const char *colon = strstr(line, ": ");
    if (colon == NULL || colon >= end)
        return false;
    int row = 0;
    m->begin = colon + 2;
    m->text = skip_position(m->begin, end, &row);
    m->end = end;
    m->in_probe = begins(m->begin, GLINT_PROBE_FILE ":") ? row : 0;
    return true;
}

static bool next_message(const char **said, message *m)
{
    while (**said != '\0') {
        const char *line = *said, *end = line_end(line);
        *said = *end == '\n' ? end + 1 : end;
        if (read_message(line, m))
            return true;
    }
    return false;
}

/* What names no cause. */
static bool is_summary(const message *m)
{
    return find(m, "Exiting due to") == m->text || find(m, "Command Failed") == m->text;
}

/* The numbers of "expects 27 bits … generates 28 bits". */
static bool read_widths(const message *m, int *expects, int *generates)
{
    const char *a = find(m, "expects "), *b = find(m, "generates ");
    return a != NULL && b != NULL && sscanf(a, "expects %d", expects) == 1 &&
           sscanf(b, "generates %d", generates) == 1;
}

static glint_status missing_or_wide(const subject *s, const message *m, const char *what,
                                    int described, int found, glint_error *err)
{
    if (found > 0)
        return glint_fail(err, GLINT_DEVICE_FAULT,
                          "%s has %d bits in the description and %d in the Verilog of %s", what,
                          described, found, s->top);
    if (m->is_error)
        return glint_fail(err, GLINT_DEVICE_FAULT, "%s has no %s", s->top, what);
    return GLINT_OK;
}

/* "signal acc", "signal acc (lane[3].u.acc)": by its path where that is another. */
static void signal_text(const subject *s, const glint_signal_info *signal, char *text, size_t size)
{
    char path[GLINT_PROBE_PATH];
    glint_probe_path(s->setting, signal, path);
    if (strcmp(path, signal->name) == 0)
        (void)snprintf(text, size, "signal %s", signal->name);
    else
        (void)snprintf(text, size, "signal %s (%s)", signal->name, path);
}

static glint_status about_signal(const subject *s, const message *m, int index, glint_error *err)
{
    const glint_signal_info signal = s->setting->circuit->signal(s->setting->values, index);
    char what[GLINT_PROBE_PATH + 300];
    int expects = 0, generates = 0;
    signal_text(s, &signal, what, sizeof what);
    if (find(m, "out of range") != NULL) /* mem[10] of 0 to 3: Verilator only warns */
        return glint_fail(err, GLINT_DEVICE_FAULT, "%s has no %s", s->top, what);
    (void)read_widths(m, &expects, &generates);
    return missing_or_wide(s, m, what, glint_signal_width(&signal), generates, err);
}

static glint_status about_port(const subject *s, const message *m, int index, glint_error *err)
{
    const glint_port *port = &s->ports->port[index];
    char what[300];
    int expects = 0, generates = 0;
    (void)snprintf(what, sizeof what, "%s %s", port->is_output ? "output" : "pin", port->name);
    (void)read_widths(m, &expects, &generates);
    return missing_or_wide(s, m, what, port->width, expects, err);
}

static glint_status about_top(const subject *s, const message *m, glint_error *err)
{
    if (m->is_error && find(m, "Can't resolve module reference") != NULL)
        return glint_fail(err, GLINT_DEVICE_FAULT, "%s/%s.v has no module %s", s->directory, s->top,
                          s->top);
    return m->is_error ? glint_fail(err, GLINT_DEVICE_FAULT, "%s: %.*s", s->top,
                                    (int)(m->end - m->text), m->text)
                       : GLINT_OK;
}

static glint_status about_probe(const subject *s, const message *m, glint_error *err)
{
    if (m->in_probe > s->probe->lines)
        return GLINT_OK;
    const glint_probe_line line = s->probe->line[m->in_probe - 1];
    switch (line.part) {
    case GLINT_PROBE_SIGNAL:
        return about_signal(s, m, line.index, err);
    case GLINT_PROBE_PORT:
        return about_port(s, m, line.index, err);
    case GLINT_PROBE_PARAMETER:
        return m->is_error ? glint_fail(err, GLINT_DEVICE_FAULT, "%s has no parameter %s", s->top,
                                        s->setting->circuit->parameters[line.index].verilog)
                           : GLINT_OK;
    case GLINT_PROBE_CLOCK_PIN:
        return m->is_error ? glint_fail(err, GLINT_DEVICE_FAULT, "%s has no clock %s", s->top,
                                        s->setting->circuit->clock_port)
                           : GLINT_OK;
    case GLINT_PROBE_TOP:
    case GLINT_PROBE_OTHER:
        break;
    }
    return about_top(s, m, err);
}

/* In Verilator's words, with the file where the caller has it. */
static glint_status tell_error(const subject *s, const message *m, int others, glint_error *err)
{
    char more[64] = "";
    if (others > 0)
        (void)snprintf(more, sizeof more, " (and %d more)", others);
    return glint_fail(err, GLINT_DEVICE_FAULT, "%s%s%.*s%s",
                      m->text != m->begin ? s->directory : "", m->text != m->begin ? "/" : "",
                      (int)(m->end - m->begin), m->begin, more);
}

/* The first error about the Verilog itself, with how many more there are. */
static glint_status find_error(const subject *s, const char *said, glint_error *err)
{
    message m, first = {0};
    int count = 0;
    while (next_message(&said, &m)) {
        if (!m.is_error || m.in_probe > 0 || is_summary(&m))
            continue;
        if (count++ == 0)
            first = m;
    }
    return count > 0 ? tell_error(s, &first, count - 1, err) : GLINT_OK;
}

/* Errors about the probe before warnings: one that is missing before one of another width. */
static glint_status find_difference(const subject *s, const char *said, bool errors,
                                    glint_error *err)
{
    message m;
    glint_status status = GLINT_OK;
    while (status == GLINT_OK && next_message(&said, &m))
        if (m.in_probe > 0 && m.is_error == errors)
            status = about_probe(s, &m, err);
    return status;
}

glint_status glint_diagnose_verilator(const char *said, const glint_setting *setting,
                                      const glint_ports *ports, const glint_probe *probe,
                                      const char *directory, glint_error *err)
{
    const subject s = {setting, ports, probe, directory, glint_setting_top(setting)};
    glint_status status = find_error(&s, said, err);
    if (status == GLINT_OK)
        status = find_difference(&s, said, true, err);
    if (status == GLINT_OK)
        status = find_difference(&s, said, false, err);
    return status;
}

/* Whether a signal of the description is that one of the whole circuit: an output may be looked at
 * as one of another kind. */
static bool is_signal(const glint_setting *setting, const glint_ports *ports, const char *name)
{
    for (int i = 0; i < ports->signals; i++) {
        const glint_signal_info signal = setting->circuit->signal(setting->values, i);
        if (signal.lane < 0 && strcmp(signal.name, name) == 0)
            return true;
    }
    return false;
}

const char *glint_diagnose_port(const char *said, const glint_setting *setting,
                                const glint_ports *ports, char name[GLINT_PORT_NAME])
{
    static const char words[] = "missing pin: '";
    message m;
    while (next_message(&said, &m)) {
        const char *found = m.in_probe > 0 ? find(&m, words) : NULL;
        if (found == NULL)
            continue;
        found += strlen(words);
        (void)snprintf(name, GLINT_PORT_NAME, "%.*s", (int)strcspn(found, "'\n"), found);
        if (!is_signal(setting, ports, name))
            return said;
    }
    return NULL;
}

glint_status glint_diagnose_compiler(const char *said, glint_error *err)
{
    const char *error = strstr(said, "error: ");
    const char *begin = said;
    if (error != NULL) {
        begin = error;
        while (begin > said && begin[-1] != '\n')
            begin--;
    }
    if (*begin == '\0')
        begin = "it gives no reason";
    return glint_fail(err, GLINT_DEVICE_FAULT, "the C++ compiler failed: %.*s",
                      (int)(line_end(begin) - begin), begin);
}
