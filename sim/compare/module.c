/* Writes the modules by the description's pins and outputs. Lanes of a port lie side by side, lane
 * 0 lowest, and their rows follow one another in either table. */
#include "compare/module.h"

#include <string.h>

#include "circuit/words.h"

enum { PORTS_MAX = 64 };

typedef struct port {
    const char *name;
    int width;
} port;

typedef struct ports {
    port in[PORTS_MAX], out[PORTS_MAX];
    int in_count, out_count;
    int in_bits, out_bits;
} ports;

static void add(port *list, int *count, int *bits, const char *name, int width)
{
    *bits += width;
    for (int i = 0; i < *count; i++)
        if (strcmp(list[i].name, name) == 0) {
            list[i].width += width;
            return;
        }
    if (*count < PORTS_MAX)
        list[(*count)++] = (port){name, width};
}

static ports ports_of(const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    ports found = {.in_count = 0};
    for (int i = 0; i < circuit->pin_count(setting->values); i++) {
        const glint_pin_info pin = circuit->pin(setting->values, i);
        add(found.in, &found.in_count, &found.in_bits, pin.name, glint_pin_width(&pin));
    }
    for (int i = 0; i < circuit->signal_count(setting->values); i++) {
        const glint_signal_info signal = circuit->signal(setting->values, i);
        if (signal.kind == GLINT_SIGNAL_OUTPUT)
            add(found.out, &found.out_count, &found.out_bits, signal.name,
                glint_signal_width(&signal));
    }
    return found;
}

/* The top with its parameters, up to the clock's connection. */
static void write_instance(FILE *out, const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    const char *comma = "";
    fprintf(out, "    %s #(", glint_setting_top(setting));
    for (int i = 0; i < circuit->parameter_count; i++) {
        if (circuit->parameters[i].verilog == NULL || glint_setting_leaves_out(setting, i))
            continue;
        fprintf(out, "%s.%s(%d)", comma, circuit->parameters[i].verilog, setting->values[i]);
        comma = ", ";
    }
    fprintf(out, ") unit (\n        .%s(clk)", circuit->clock_port);
}

void glint_compare_write_bare(FILE *out, const glint_setting *setting)
{
    const ports of = ports_of(setting);
    fprintf(out, "module " GLINT_COMPARE_MODULE " (\n    input wire clk");
    for (int i = 0; i < of.in_count; i++)
        fprintf(out, ",\n    input wire [%d:0] %s", of.in[i].width - 1, of.in[i].name);
    for (int i = 0; i < of.out_count; i++)
        fprintf(out, ",\n    output wire [%d:0] %s", of.out[i].width - 1, of.out[i].name);
    fprintf(out, "\n);\n");
    write_instance(out, setting);
    for (int i = 0; i < of.in_count; i++)
        fprintf(out, ",\n        .%s(%s)", of.in[i].name, of.in[i].name);
    for (int i = 0; i < of.out_count; i++)
        fprintf(out, ",\n        .%s(%s)", of.out[i].name, of.out[i].name);
    fprintf(out, ");\nendmodule\n");
}

static void write_slices(FILE *out, const char *bus, const port *list, int count)
{
    for (int i = 0, bit = 0; i < count; bit += list[i++].width)
        fprintf(out, ",\n        .%s(%s[%d +: %d])", list[i].name, bus, bit, list[i].width);
}

void glint_compare_write_timed(FILE *out, const glint_setting *setting)
{
    const ports of = ports_of(setting);
    fprintf(out,
            "module " GLINT_COMPARE_MODULE " (\n    input wire clk,\n    input wire in,\n"
            "    output wire out\n);\n"
            "    reg  [%d:0] drive;\n    wire [%d:0] made;\n    reg  [%d:0] taken;\n"
            "    reg  [%d:0] folded;\n",
            of.in_bits - 1, of.out_bits - 1, of.out_bits - 1, of.out_bits - 1);
    fprintf(out,
            "    always @(posedge clk) begin\n"
            "        drive  <= {drive[%d:0], in};\n"
            "        taken  <= made;\n"
            "        folded <= taken ^ {folded[%d:0], 1'b0};\n"
            "    end\n    assign out = folded[%d];\n",
            of.in_bits - 2, of.out_bits - 2, of.out_bits - 1);
    write_instance(out, setting);
    write_slices(out, "drive", of.in, of.in_count);
    write_slices(out, "made", of.out, of.out_count);
    fprintf(out, ");\nendmodule\n");
}
