/* Prints the tree: Markdown, CSV, points for gnuplot. */
#include "compare/tables.h"

#include <math.h>
#include <string.h>

#include "file/json.h"

static const char *const families[] = {"xilinx", "ecp5", "ice40", "ice40dsp", "gowin", "cyclonev"};
static const char *const family_names[] = {"Xilinx 7",       "ECP5",       "iCE40",
                                           "iCE40 with DSP", "Gowin GW2A", "Cyclone V"};
static const char *const chips[] = {"ice40", "up5k", "ecp5", "nexus", "gowin"};
static const char *const chip_names[] = {"iCE40 HX8K", "iCE40 UP5K, DSP", "ECP5 25k, speed 6",
                                         "Nexus LIFCL-40", "Gowin GW2A-18 *"};
enum {
    FAMILIES = sizeof families / sizeof families[0],
    CHIPS = sizeof chips / sizeof chips[0],
    SEEDS_MAX = 16,
};

static const json_t *at(const json_t *unit, const char *kind, const char *flow)
{
    return json_object_get(json_object_get(unit, kind), flow);
}

static double number(const json_t *object, const char *name)
{
    const json_t *found = json_object_get(object, name);
    return found != NULL ? json_number_value(found) : NAN;
}

static const char *text(const json_t *unit, const char *name)
{
    return json_string_value(json_object_get(unit, name));
}

static int has_lanes(const json_t *unit, int lanes)
{
    return number(unit, "lanes") == lanes;
}

/* ---- Markdown -------------------------------------------------------------------------------- */

static void write_rule(FILE *out, int columns)
{
    for (int i = 0; i < columns; i++)
        fprintf(out, i == 0 ? "|---|" : "---:|");
    fputc('\n', out);
}

static void write_cell(FILE *out, const char *format, double value)
{
    if (isnan(value)) {
        fprintf(out, " – |");
        return;
    }
    fputc(' ', out);
    fprintf(out, format, value);
    fprintf(out, " |");
}

/* The tools of a kind and flow, of whichever unit has been measured. */
static const char *tools_of(const json_t *tree, const char *kind, const char *flow)
{
    json_t *unit;
    glint_json_each(unit, tree)
    {
        const char *tools = text(at(unit, kind, flow), "tools");
        if (tools != NULL)
            return tools;
    }
    return "not measured";
}

static void write_tools(FILE *out, const json_t *tree, const char *kind, const char *const *flows,
                        int count)
{
    fprintf(out, "\nBy");
    for (int i = 0; i < count; i++) {
        const char *tools = tools_of(tree, kind, flows[i]);
        if (i == 0 || strcmp(tools, tools_of(tree, kind, flows[i - 1])) != 0)
            fprintf(out, "%s %s", i == 0 ? "" : ";", tools);
    }
    fprintf(out, ".\n\n");
}

static void write_accuracy(FILE *out, const json_t *tree)
{
    json_t *unit;
    fprintf(out, "### Accuracy, and a standard-cell library\n\n"
                 "| unit | W | clocks | from cosⁿ, 1/255 | from its formula, 1/255 | largest NMSE"
                 " | gates | mm² | MHz |\n");
    write_rule(out, 9);
    glint_json_each(unit, tree)
    {
        const json_t *errors = json_object_get(unit, "errors");
        const json_t *library = at(unit, "size", "cells");
        if (!has_lanes(unit, 1))
            continue;
        fprintf(out, "| %s | U1.%.0f | %.0f |", text(unit, "label"), number(unit, "w_frac_bits"),
                number(unit, "latency"));
        write_cell(out, "%.3g", number(errors, "power_steps"));
        write_cell(out, "%.2g", number(errors, "own_steps"));
        write_cell(out, "%.2g", number(errors, "nmse"));
        write_cell(out, "%.0f", number(library, "gates"));
        write_cell(out, "%.3f", number(library, "mm2"));
        write_cell(out, "%.0f", number(library, "mhz"));
        fputc('\n', out);
    }
    fprintf(out, "\nGates: area in NAND2X1 of osu018 (0.18 µm), ROMs as gates, by %s.\n\n",
            tools_of(tree, "size", "cells"));
}

static void write_use(FILE *out, const json_t *cells)
{
    if (cells == NULL)
        fprintf(out, " – |");
    else
        fprintf(out, " %.0f, %.0f, %.3g, %.3g |", number(cells, "lut"), number(cells, "ff"),
                number(cells, "dsp"), number(cells, "bram"));
}

static int is_measured(const json_t *tree, const char *kind, int lanes)
{
    json_t *unit;
    glint_json_each(unit, tree)
    {
        const json_t *found = json_object_get(unit, kind);
        const size_t library = json_object_get(found, "cells") != NULL;
        if (has_lanes(unit, lanes) && json_object_size(found) > library)
            return 1;
    }
    return 0;
}

/* A table of which nothing has been measured is left out. */
static void write_sizes(FILE *out, const json_t *tree, const char *title, const char *kind,
                        int lanes)
{
    json_t *unit;
    if (!is_measured(tree, kind, lanes))
        return;
    fprintf(out, "### %s\n\n| LUT, FF, DSP, BRAM |", title);
    for (int i = 0; i < FAMILIES; i++)
        fprintf(out, " %s |", family_names[i]);
    fputc('\n', out);
    write_rule(out, 1 + FAMILIES);
    glint_json_each(unit, tree)
    {
        if (!has_lanes(unit, lanes))
            continue;
        fprintf(out, "| %s |", text(unit, "label"));
        for (int i = 0; i < FAMILIES; i++)
            write_use(out, at(unit, kind, families[i]));
        fputc('\n', out);
    }
    write_tools(out, tree, kind, families, FAMILIES);
}

/* The rates of all seeds in order; how many. */
static int rates_of(const json_t *clock, double rates[SEEDS_MAX])
{
    json_t *rate;
    int count = 0;
    glint_json_each(rate, json_object_get(clock, "mhz"))
    {
        int place = count;
        if (count == SEEDS_MAX)
            break;
        for (; place > 0 && rates[place - 1] > json_number_value(rate); place--)
            rates[place] = rates[place - 1];
        rates[place] = json_number_value(rate);
        count++;
    }
    return count;
}

static double median_rate(const json_t *unit, const char *flow)
{
    double rates[SEEDS_MAX];
    const int count = rates_of(at(unit, "clock", flow), rates);
    return count > 0 ? rates[count / 2] : NAN;
}

static void write_rate(FILE *out, const json_t *clock)
{
    double rates[SEEDS_MAX];
    const int count = rates_of(clock, rates);
    if (clock == NULL)
        fprintf(out, " – |");
    else if (count == 0)
        fprintf(out, " does not fit |");
    else
        fprintf(out, " %.1f (%.1f to %.1f) |", rates[count / 2], rates[0], rates[count - 1]);
}

static void write_rates(FILE *out, const json_t *tree)
{
    json_t *unit;
    if (!is_measured(tree, "clock", 1))
        return;
    fprintf(out, "### Clock rate, one lane\n\n| MHz: median (least to most) of three seeds |");
    for (int i = 0; i < CHIPS; i++)
        fprintf(out, " %s |", chip_names[i]);
    fputc('\n', out);
    write_rule(out, 1 + CHIPS);
    glint_json_each(unit, tree)
    {
        if (!has_lanes(unit, 1))
            continue;
        fprintf(out, "| %s |", text(unit, "label"));
        for (int i = 0; i < CHIPS; i++)
            write_rate(out, at(unit, "clock", chips[i]));
        fputc('\n', out);
    }
    write_tools(out, tree, "clock", chips, CHIPS);
}

void glint_compare_write_markdown(FILE *out, const json_t *tree)
{
    write_accuracy(out, tree);
    write_sizes(out, tree, "Size, one lane", "size", 1);
    write_rates(out, tree);
    write_sizes(out, tree, "Size, four lanes", "size", 4);
    write_sizes(out, tree, "Size, one lane, by Debian's Yosys", "debian", 1);
}

/* ---- CSV ---------------------------------------------------------------------------------------
 */

static void write_line(FILE *out, const json_t *unit, const char *kind, const char *flow,
                       const json_t *of, const char *quantity, double value)
{
    const char *tools = text(of, "tools");
    fprintf(out, "%s,%.0f,%.0f,%.0f,%s,%s,\"%s\",%s,%.10g\n", text(unit, "unit"),
            number(unit, "lanes"), number(unit, "w_frac_bits"), number(unit, "latency"), kind, flow,
            tools != NULL ? tools : "", quantity, value);
}

static void write_numbers(FILE *out, const json_t *unit, const char *kind, const char *flow,
                          const json_t *of)
{
    const char *quantity;
    json_t *value, *rate;
    json_object_foreach((json_t *)of, quantity, value)
    {
        if (json_is_number(value))
            write_line(out, unit, kind, flow, of, quantity, json_number_value(value));
        glint_json_each(rate, value)
            write_line(out, unit, kind, flow, of, quantity, json_number_value(rate));
    }
}

void glint_compare_write_csv(FILE *out, const json_t *tree)
{
    static const char *const kinds[] = {"size", "debian", "clock"};
    const char *flow;
    json_t *unit, *of;
    fprintf(out, "unit,lanes,w_frac_bits,latency,kind,flow,tools,quantity,value\n");
    glint_json_each(unit, tree)
    {
        write_numbers(out, unit, "errors", "model", json_object_get(unit, "errors"));
        for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
            json_object_foreach(json_object_get(unit, kinds[i]), flow, of)
                write_numbers(out, unit, kinds[i], flow, of);
    }
}

/* ---- Points ------------------------------------------------------------------------------------
 */

static double gates_of(const json_t *unit)
{
    return number(at(unit, "size", "cells"), "gates");
}

/* Of two costs, less is better: period is the cost of a clock. */
static double cost_of(const json_t *unit, const char *flow)
{
    return flow != NULL ? 1 / median_rate(unit, flow) : gates_of(unit);
}

static double error_of(const json_t *unit)
{
    return number(json_object_get(unit, "errors"), "power_steps");
}

static int takes_any_n(const json_t *unit)
{
    return !(number(unit, "only_n") > 0);
}

/* No other is as good in both and better in one, of those that take any n. flow NULL: by gates. */
static int is_on_front(const json_t *tree, const json_t *unit, const char *flow)
{
    const double error = error_of(unit), cost = cost_of(unit, flow);
    json_t *other;
    if (isnan(error) || isnan(cost) || !takes_any_n(unit))
        return 0;
    glint_json_each(other, tree)
    {
        const double e = error_of(other), c = cost_of(other, flow);
        if (has_lanes(other, 1) && takes_any_n(other) && e <= error && c <= cost &&
            (e < error || c < cost))
            return 0;
    }
    return 1;
}

void glint_compare_write_points(FILE *out, const json_t *tree, const char *flow)
{
    json_t *unit;
    glint_json_each(unit, tree)
    {
        if (has_lanes(unit, 1))
            fprintf(out, "%g %g %g %d %d \"%s\"\n", error_of(unit), gates_of(unit),
                    median_rate(unit, flow), is_on_front(tree, unit, NULL),
                    is_on_front(tree, unit, flow), text(unit, "label"));
    }
}
