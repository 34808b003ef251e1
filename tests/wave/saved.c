/* Parses GTKWave save files line by line. */
#define _XOPEN_SOURCE 700

#include "saved.h"

#include <inttypes.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#define GROUP_BEGIN 0x800000u
#define GROUP_END   0x1000000u

typedef struct reader {
    saved *to;
    unsigned flags;
    int fraction;
    int open_groups;
    int rows;
} reader;

/* "+{reg2} TOP.specular_device.reg2[9:0]": ten bits, shown as "reg2"; without the brackets one. */
static void read_trace(reader *reader, const char *line)
{
    saved *to = reader->to;
    assert_true(to->count < (int)(sizeof to->trace / sizeof to->trace[0]));
    saved_trace *trace = &to->trace[to->count++];
    assert_int_equal(sscanf(line, "+{%63[^}]} TOP.", trace->label), 1);
    line = strstr(line, "} ") + 2;
    const char *bits = strrchr(line, '[');
    int low = 0;
    const bool is_wide = bits != NULL && strchr(bits, ':') != NULL;
    trace->width = 1;
    if (is_wide) {
        assert_int_equal(sscanf(bits, "[%d:%d]", &trace->width, &low), 2);
        trace->width += 1 - low;
    }
    const size_t length = is_wide ? (size_t)(bits - line) : strlen(line);
    assert_true(length < sizeof trace->name);
    memcpy(trace->name, line, length);
    trace->name[length] = '\0';
    trace->flags = reader->flags;
    trace->fraction = reader->fraction;
    trace->row = reader->rows++;
    trace->is_folded = reader->open_groups > 0;
    reader->fraction = 0;
}

/* "-Title": of a group or a heading, as the flags before it say; empty: room for a curve. */
static void read_title(reader *reader, const char *line)
{
    reader->open_groups += (reader->flags & GROUP_BEGIN) != 0;
    reader->open_groups -= (reader->flags & GROUP_END) != 0;
    assert_true(reader->open_groups >= 0);
    reader->to->headings += line[1] != '\0';
    reader->rows++;
    const int length = (int)strlen(line + 1);
    if (length > reader->to->longest_heading)
        reader->to->longest_heading = length;
}

static bool read_setting(reader *reader, const char *line)
{
    saved *to = reader->to;
    int number;
    return sscanf(line, "[dumpfile] \"%127[^\"]\"", to->dumpfile) == 1 ||
           sscanf(line, "[timestart] %" SCNu64, &to->first_time) == 1 ||
           sscanf(line, "[fpshift_count] %d", &reader->fraction) == 1 ||
           sscanf(line, "[color] %d", &number) == 1 ||
           sscanf(line, "[size] %d %d", &to->window_width, &to->window_height) == 2 ||
           sscanf(line, "[pos] %d", &number) == 1 || sscanf(line, "[sst_width] %d", &number) == 1 ||
           sscanf(line, "[signals_width] %d", &to->signals_width) == 1 ||
           sscanf(line, "[sst_expanded] %d", &number) == 1 || strncmp(line, "[*] ", 4) == 0;
}

static void read_line(reader *reader, const char *line)
{
    bool known = true;
    if (line[0] == '+')
        read_trace(reader, line);
    else if (line[0] == '@')
        known = sscanf(line, "@%x", &reader->flags) == 1;
    else if (line[0] == '-')
        read_title(reader, line);
    else if (line[0] == '*')
        known = sscanf(line, "*%lf %" SCNd64, &reader->to->zoom, &reader->to->marker) == 2;
    else
        known = read_setting(reader, line);
    if (!known)
        fail_msg("a line of the save file that means nothing: \"%s\"", line);
}

void saved_read(const char *path, saved *saved)
{
    char line[1024];
    reader reader = {.to = saved};
    FILE *stream = fopen(path, "r");
    assert_non_null(stream);
    memset(saved, 0, sizeof *saved);
    while (fgets(line, sizeof line, stream) != NULL) {
        assert_non_null(strchr(line, '\n'));
        line[strcspn(line, "\n")] = '\0';
        read_line(&reader, line);
    }
    fclose(stream);
    assert_int_equal(reader.open_groups, 0);
}

double saved_view(const saved *saved, double pixels)
{
    return pixels / 200 * exp2(-saved->zoom);
}

void saved_name(const glint_signal_info *signal, char *name, int size)
{
    if (signal->lane >= 0) {
        (void)snprintf(name, (size_t)size, "TOP.specular_device.lane[%d].u.%s", signal->lane,
                       signal->name);
    } else {
        (void)snprintf(name, (size_t)size, "TOP.specular_device.%s", signal->name);
    }
}

int saved_signal(const glint_specular_config *config, const saved_trace *trace)
{
    for (int i = 0; i < glint_specular_signal_count(config); i++) {
        const glint_signal_info info = glint_specular_signal_info(config, i);
        char name[112];
        saved_name(&info, name, sizeof name);
        if (strcmp(name, trace->name) == 0)
            return i;
    }
    return -1;
}
