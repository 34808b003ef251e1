/* Writes the table of ports from the header that Verilator made; see table.h. */
#define _POSIX_C_SOURCE 200809L

#include "rtl/table.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/units.h"
#include "rtl/data.h"

#define MEMBER 2048 /* characters: every one of a name may become seven */

/* The table while it is written; class: the text of the class's header. */
typedef struct writer {
    const glint_product *product;
    const char *class;
    FILE *out;
    glint_error *err;
} writer;

/* Whether the class has a function or a member of that name besides the port, whose name stands
 * behind `&`. */
static bool is_taken(const char *class, const char *name)
{
    const size_t length = strlen(name);
    for (const char *at = class; (at = strstr(at, name)) != NULL; at += length)
        if (at > class && !isalnum((unsigned char)at[-1]) && strchr("_&", at[-1]) == NULL &&
            (at[length] == '(' || at[length] == ';'))
            return true;
    return false;
}

/* A port's member of Verilator's class: of two underlines in a row, the second is written as a
 * code, and a word of C++ has something before it. */
static void name_member(const char *class, const char *name, char member[MEMBER])
{
    static const char reserved[] = "__SYM__";
    char word[MEMBER + 16];
    size_t length = 0;
    for (const char *c = name; *c != '\0' && length < MEMBER - 20; c++) {
        member[length++] = *c;
        if (c[0] == '_' && c[1] == '_') {
            memcpy(member + length, "__05F", 5);
            length += 5;
            c++;
        }
    }
    member[length] = '\0';
    (void)snprintf(word, sizeof word, "&%s%s,", reserved, member);
    if (strstr(class, word) != NULL) {
        memmove(member + strlen(reserved), member, length + 1);
        memcpy(member, reserved, strlen(reserved));
    }
}

static glint_status print_port(const writer *w, const char *before, const char *name)
{
    char member[MEMBER];
    if (is_taken(w->class, name))
        return glint_fail(w->err, GLINT_DEVICE_FAULT,
                          "%s: port %s cannot be in a waveform, as a function of Verilator's class "
                          "has this name",
                          w->product->verilog, name);
    name_member(w->class, name, member);
    fprintf(w->out, "%s%s", before, member);
    return GLINT_OK;
}

static void print_probe_ports(const writer *w)
{
    const glint_setting *setting = w->product->setting;
    for (int i = 0; i < w->product->ports.count; i++)
        fprintf(w->out, " \\\n    X(\"%s\", glint_p%d)", w->product->ports.port[i].name, i);
    for (int i = 0; i < w->product->ports.signals; i++)
        if (!glint_signal_is_port(setting->circuit->signal(setting->values, i).kind))
            fprintf(w->out, " \\\n    X(\"glint_s%d\", glint_s%d)", i, i);
}

static glint_status print_own_ports(const writer *w)
{
    glint_status status = GLINT_OK;
    for (int i = 0; status == GLINT_OK && i < w->product->ports.count; i++) {
        fprintf(w->out, " \\\n    X(\"%s\"", w->product->ports.port[i].name);
        status = print_port(w, ", ", w->product->ports.port[i].name);
        fputc(')', w->out);
    }
    return status;
}

/* What the loop over points has as constants. */
static void print_shade(const writer *w)
{
    const glint_setting *setting = w->product->setting;
    fprintf(w->out,
            "#define GLINT_SHADE_LANES %d\n#define GLINT_SHADE_W_BITS %d\n"
            "#define GLINT_SHADE_COS_BITS %d\n#define GLINT_SHADE_LATENCY %d\n",
            glint_highlight_lanes(setting), glint_highlight_w_frac_bits(setting) + 1,
            GLINT_COS_BITS, glint_setting_latency(setting));
}

static glint_status print_table(const writer *w)
{
    const glint_rtl_kind kind = w->product->kind;
    const char *clock = w->product->setting->circuit->clock_port;
    glint_status status = GLINT_OK;
    if (kind == GLINT_RTL_FST || kind == GLINT_RTL_VCD)
        fprintf(w->out, "#define GLINT_%s\n", kind == GLINT_RTL_FST ? "FST" : "VCD");
    if (glint_product_shades(w->product))
        print_shade(w);
    if (clock != NULL && kind == GLINT_RTL_OBSERVED)
        fprintf(w->out, "#define GLINT_CLOCK " GLINT_PROBE_CLOCK "\n");
    else if (clock != NULL)
        status = print_port(w, "#define GLINT_CLOCK ", clock);
    fprintf(w->out, "\n#define GLINT_PORTS(X)");
    if (kind == GLINT_RTL_OBSERVED)
        print_probe_ports(w);
    else if (status == GLINT_OK)
        status = print_own_ports(w);
    fprintf(w->out, "\n");
    glint_data_print(&w->product->sources, w->out);
    return status;
}

glint_status glint_table_write(const glint_product *product, const char *directory,
                               glint_error *err)
{
    char *class, *text = NULL;
    size_t size = 0;
    glint_status status = glint_text_read(directory, GLINT_CLASS ".h", &class, &size, err);
    FILE *out = status == GLINT_OK ? open_memstream(&text, &size) : NULL;
    if (out != NULL)
        status = print_table(&(writer){product, class, out, err});
    const bool good = out != NULL && fclose(out) == 0;
    if (status == GLINT_OK)
        status = good ? glint_text_write(directory, "glint_ports.h", text, size, err)
                      : glint_fail(err, GLINT_NO_MEMORY, "not enough memory to build a circuit");
    free(text);
    free(class);
    return status;
}
