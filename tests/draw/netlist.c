/* Reads the JSON that Yosys writes of an elaborated circuit; see netlist.h. */
#include "netlist.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "file/json.h"
#include "lockstep/signals.h"

enum { PATH = 1024 };

/* A bit of a cell's output is made of all bits of its inputs; of a bitwise cell, of those in its
 * own place where a port has as many places. */
typedef struct cell {
    const json_t *description;
    bool is_bitwise;
    int width; /* of the output */
} cell;

struct netlist {
    json_t *json, *names; /* of wires: {"bits": […]} */
    int bit_count, cell_count;
    int *driver; /* of each bit: its cell; −1: none, a port */
    int *place;  /* and its place in the cell's output */
    cell *cells;
};

/* ---- Yosys ----------------------------------------------------------------------------------- */

static bool run_yosys(const glint_setting *setting, const char *directory, const char *work)
{
    char script[4 * PATH], command[8 * PATH];
    const glint_circuit *circuit = setting->circuit;
    const char *top = glint_setting_top(setting);
    int length =
        snprintf(script, sizeof script, "read_verilog -I%s %s/*.v; chparam", directory, directory);
    for (int i = 0; i < circuit->parameter_count; i++)
        if (circuit->parameters[i].verilog != NULL)
            length += snprintf(script + length, sizeof script - (size_t)length, " -set %s %d",
                               circuit->parameters[i].verilog, setting->values[i]);
    (void)snprintf(script + length, sizeof script - (size_t)length,
                   " %s; hierarchy -top %s; proc -noopt; flatten; write_json %s/netlist.json", top,
                   top, work);
    (void)snprintf(command, sizeof command, "yosys -q -p '%s' >%s/yosys.log 2>&1", script, work);
    return system(command) == 0;
}

static char *read_text(const char *path)
{
    FILE *stream = fopen(path, "rb");
    char *text = NULL;
    long size;
    if (stream == NULL)
        return NULL;
    if (fseek(stream, 0, SEEK_END) == 0 && (size = ftell(stream)) >= 0 &&
        (text = malloc((size_t)size + 1)) != NULL) {
        rewind(stream);
        text[fread(text, 1, (size_t)size, stream)] = '\0';
    }
    (void)fclose(stream);
    return text;
}

/* ---- The netlist ----------------------------------------------------------------------------- */

/* A bit's number; −1: a constant, which is a string. */
static int bit_of(const json_t *bit)
{
    return json_is_integer(bit) ? (int)json_integer_value(bit) : -1;
}

static void count_bits(netlist *circuit, const json_t *bits)
{
    const json_t *bit;
    glint_json_each(bit, bits)
    {
        if (bit_of(bit) >= circuit->bit_count)
            circuit->bit_count = bit_of(bit) + 1;
    }
}

static bool is_output(const json_t *description, const char *port)
{
    const json_t *directions = json_object_get(description, "port_directions");
    return strcmp(json_string_value(json_object_get(directions, port)), "output") == 0;
}

static bool is_bitwise(const json_t *description)
{
    static const char *const types[] = {"$dff",  "$dffe", "$sdff", "$sdffe", "$adff", "$mux",
                                        "$pmux", "$and",  "$or",   "$xor",   "$xnor", "$not"};
    const char *type = json_string_value(json_object_get(description, "type"));
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++)
        if (strcmp(type, types[i]) == 0)
            return true;
    return false;
}

static void read_cell(netlist *circuit, const json_t *description)
{
    const char *name;
    json_t *port, *bit;
    cell *made = &circuit->cells[circuit->cell_count];
    *made = (cell){.description = description, .is_bitwise = is_bitwise(description)};
    json_object_foreach(json_object_get(description, "connections"), name, port)
    {
        int place = 0;
        if (!is_output(description, name))
            continue;
        made->width = (int)json_array_size(port);
        glint_json_each(bit, port)
        {
            if (bit_of(bit) >= 0) {
                circuit->driver[bit_of(bit)] = circuit->cell_count;
                circuit->place[bit_of(bit)] = place;
            }
            place++;
        }
    }
    circuit->cell_count++;
}

static void read_module(netlist *circuit, const json_t *module)
{
    json_t *cells = json_object_get(module, "cells"), *wire, *description;
    const char *name;
    circuit->names = json_object_get(module, "netnames");
    json_object_foreach(circuit->names, name, wire)
    {
        count_bits(circuit, json_object_get(wire, "bits"));
    }
    circuit->driver = malloc(sizeof *circuit->driver * (size_t)(circuit->bit_count + 1));
    circuit->place = calloc((size_t)circuit->bit_count + 1, sizeof *circuit->place);
    circuit->cells = calloc(json_object_size(cells) + 1, sizeof *circuit->cells);
    for (int i = 0; i < circuit->bit_count; i++)
        circuit->driver[i] = -1;
    json_object_foreach(cells, name, description)
    {
        read_cell(circuit, description);
    }
}

netlist *netlist_make(const glint_setting *setting, const char *directory, const char *work)
{
    char path[PATH];
    netlist *circuit = calloc(1, sizeof *circuit);
    (void)snprintf(path, sizeof path, "%s/netlist.json", work);
    char *text = circuit != NULL && run_yosys(setting, directory, work) ? read_text(path) : NULL;
    if (text != NULL)
        circuit->json = json_loads(text, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    free(text);
    const char *name;
    json_t *module, *modules = circuit != NULL ? json_object_get(circuit->json, "modules") : NULL;
    json_object_foreach(modules, name, module)
    {
        /* The top alone is left, under a name of Yosys's where it has parameters; the modules
         * that it was flattened from have no attribute `top`. */
        if (json_object_get(json_object_get(module, "attributes"), "top") == NULL)
            continue;
        read_module(circuit, module);
        return circuit;
    }
    fprintf(stderr, "Yosys gives no netlist: see %s/yosys.log\n", work);
    netlist_destroy(circuit);
    return NULL;
}

void netlist_destroy(netlist *circuit)
{
    if (circuit == NULL)
        return;
    free(circuit->cells);
    free(circuit->driver);
    free(circuit->place);
    json_decref(circuit->json);
    free(circuit);
}

/* ---- Questions ------------------------------------------------------------------------------- */

static const json_t *bits_of(const netlist *circuit, const char *name)
{
    return json_object_get(json_object_get(circuit->names, name), "bits");
}

bool netlist_has(const netlist *circuit, const char *name)
{
    return bits_of(circuit, name) != NULL;
}

bool netlist_is_constant(const netlist *circuit, const char *name)
{
    const json_t *bit;
    glint_json_each(bit, bits_of(circuit, name))
    {
        if (bit_of(bit) >= 0)
            return false;
    }
    return true;
}

typedef struct search {
    const netlist *circuit;
    const char *wire;
    char (*names)[NETLIST_NAME];
    int count;
    const bool *expected;
    bool *reached;
    bool (*owned)[NETLIST_NAMES_MAX]; /* by bit and name */
    bool *seen;
    int *waiting, waiting_count;
} search;

/* Whether the bit belongs to a name: those expected, else all the others that it has; but a
 * register that holds its own value is fed by nothing. */
static bool stops_at(const search *s, int bit)
{
    bool is_expected = false, is_owned = false, is_self = false;
    for (int i = 0; i < s->count; i++) {
        if (!s->owned[bit][i])
            continue;
        is_owned = true;
        is_self |= strcmp(s->names[i], s->wire) == 0;
        if (s->expected[i])
            s->reached[i] = is_expected = true;
    }
    for (int i = 0; i < s->count && !is_expected && !is_self; i++)
        s->reached[i] |= s->owned[bit][i];
    return is_owned;
}

/* Whether one of the names that the bit has is expected. */
static bool is_renamed(const search *s, int bit)
{
    bool is_expected = false;
    for (int i = 0; i < s->count; i++)
        if (s->owned[bit][i] && s->expected[i])
            s->reached[i] = is_expected = true;
    return is_expected;
}

static void visit(search *s, int bit)
{
    if (s->seen[bit])
        return;
    s->seen[bit] = true;
    if (!stops_at(s, bit))
        s->waiting[s->waiting_count++] = bit;
}

/* What the bit is made of, in the cell that drives it. */
static void visit_inputs(search *s, int of)
{
    const int driver = s->circuit->driver[of];
    const char *name;
    json_t *port, *bit;
    if (driver < 0)
        return;
    const cell *cell = &s->circuit->cells[driver];
    json_object_foreach(json_object_get(cell->description, "connections"), name, port)
    {
        const bool is_in_place =
            cell->is_bitwise && strchr("ABD", name[0]) != NULL &&
            (int)json_array_size(port) % cell->width == 0; /* one word, or several to choose from */
        int place = 0;
        if (is_output(cell->description, name))
            continue;
        glint_json_each(bit, port)
        {
            if (bit_of(bit) >= 0 && (!is_in_place || place % cell->width == s->circuit->place[of]))
                visit(s, bit_of(bit));
            place++;
        }
    }
}

/* A bit of the wire itself. A wire renamed has its source's bits; a register has its own, which may
 * be those of a wire that only renames it. */
static void begin_at(search *s, int bit, bool is_register)
{
    if (is_register || !is_renamed(s, bit))
        visit_inputs(s, bit);
}

static void own(const search *s)
{
    const json_t *bit;
    for (int i = 0; i < s->count; i++)
        glint_json_each(bit, bits_of(s->circuit, s->names[i]))
        {
            if (bit_of(bit) >= 0)
                s->owned[bit_of(bit)][i] = true;
        }
}

void netlist_sources(const netlist *circuit, const char *wire, bool is_register,
                     char (*names)[NETLIST_NAME], int count, const bool *expected, bool *reached)
{
    const size_t bits = (size_t)circuit->bit_count + 1;
    search s = {.circuit = circuit,
                .wire = wire,
                .names = names,
                .count = count,
                .expected = expected,
                .reached = reached,
                .owned = calloc(bits, sizeof *s.owned),
                .seen = calloc(bits, sizeof *s.seen),
                .waiting = calloc(bits, sizeof *s.waiting)};
    const json_t *bit;
    memset(reached, 0, sizeof *reached * (size_t)count);
    own(&s);
    glint_json_each(bit, bits_of(circuit, wire))
    {
        if (bit_of(bit) >= 0)
            begin_at(&s, bit_of(bit), is_register);
    }
    while (s.waiting_count > 0)
        visit_inputs(&s, s.waiting[--s.waiting_count]);
    free(s.owned);
    free(s.seen);
    free(s.waiting);
}
