/* Drawings: the committed ones are up to date; nothing overlaps; bad descriptions are refused. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"

#include "../cli/run.h"
#include "circuit/circuits.h"
#include "draw/draw.h"
#include "draw/layout.h"

enum { DRAWINGS_MAX = 16, PATH = 1024 };

/* "NAME OPTIONS" in docs/images/drawings.txt. */
typedef struct drawing {
    char *name, *options;
} drawing;

static char *list;
static drawing drawings[DRAWINGS_MAX];
static int drawing_count;

static int read_list(void **state)
{
    if (scratch_make(state) != 0)
        return -1;
    list = scratch_read("docs/images/drawings.txt", NULL);
    for (char *line = strtok(list, "\n"); line != NULL; line = strtok(NULL, "\n")) {
        char *blank = strchr(line, ' ');
        if (blank == NULL || drawing_count == DRAWINGS_MAX)
            return -1;
        *blank = '\0';
        drawings[drawing_count++] = (drawing){line, blank + 1};
    }
    return drawing_count > 0 ? 0 : -1;
}

static int forget_list(void **state)
{
    free(list);
    return scratch_remove(state);
}

/* ---- What is committed ----------------------------------------------------------------------- */

/* Removes coordinates and sizes, which may differ between versions of dot. What is drawn, and what
 * is connected to what, stays. */
static void forget_places(char *svg)
{
    static const char *const places[] = {" x=\"",  " y=\"",     " d=\"",      " cx=\"",
                                         " cy=\"", " width=\"", " height=\"", " viewBox=\""};
    char *to = svg;
    for (char *from = svg; *from != '\0';) {
        size_t length = 0;
        for (size_t i = 0; i < sizeof places / sizeof places[0] && length == 0; i++)
            if (strncmp(from, places[i], strlen(places[i])) == 0)
                length = strlen(places[i]);
        if (length == 0) {
            *to++ = *from++;
            continue;
        }
        from += length;
        from += strcspn(from, "\"");
    }
    *to = '\0';
}

static void path_of(char path[PATH], const drawing *drawing, const char *ending)
{
    (void)snprintf(path, PATH, "docs/images/%s.%s", drawing->name, ending);
}

static void draw(const char *options, const char *path)
{
    char line[2 * PATH];
    (void)snprintf(line, sizeof line, "draw %s --out %s", options, path);
    outcome done = run(line, "");
    assert_outcome(&done, 0, "");
    forget(&done);
}

static void committed_drawings_are_what_the_descriptions_give(void **state)
{
    (void)state;
    for (int i = 0; i < drawing_count; i++) {
        char path[PATH];
        path_of(path, &drawings[i], "svg");
        draw(drawings[i].options, scratch_path("fresh.svg"));
        char *fresh = scratch_read(scratch_path("fresh.svg"), NULL);
        char *committed = scratch_read(path, NULL);
        forget_places(fresh);
        forget_places(committed);
        assert_true(strlen(fresh) > 2000);
        if (strcmp(fresh, committed) != 0)
            fail_msg("%s: not what the description gives; run `make generate` and commit it", path);
        free(fresh);
        free(committed);
    }
}

/* A change to the drawing itself survives that. */
static void a_stale_drawing_would_be_seen(void **state)
{
    (void)state;
    char a[] = "<g data-net=\"a\" data-to=\"b\"><path d=\"M1 2\"/><text x=\"1\">U1.18</text>";
    char b[] = "<g data-net=\"a\" data-to=\"c\"><path d=\"M3 2\"/><text x=\"9\">U1.18</text>";
    char c[] = "<g data-net=\"a\" data-to=\"b\"><path d=\"M3 2\"/><text x=\"9\">U1.17</text>";
    char d[] = "<g data-net=\"a\" data-to=\"b\"><path d=\"M3 9\"/><text x=\"7\">U1.18</text>";
    forget_places(a);
    forget_places(b);
    forget_places(c);
    forget_places(d);
    assert_string_not_equal(a, b);
    assert_string_not_equal(a, c);
    assert_string_equal(a, d);
}

/* The PNG is the SVG, apart from antialiasing. */
static void committed_pictures_are_the_drawings(void **state)
{
    (void)state;
    for (int i = 0; i < drawing_count; i++) {
        char svg[PATH], png[PATH], line[3 * PATH];
        path_of(svg, &drawings[i], "svg");
        path_of(png, &drawings[i], "png");
        const char *fresh = scratch_path("fresh.png");
        const char *const convert[] = {"rsvg-convert", "--zoom", "1.5", svg, "-o", fresh, NULL};
        assert_int_equal(child_run(convert, 60.0), 0);
        (void)snprintf(line, sizeof line, "compare %s %s", png, fresh);
        outcome done = run(line, "");
        const char *nmse = strstr(done.out, "NMSE ");
        if (nmse == NULL || strtod(nmse + 5, NULL) > 0.001)
            fail_msg("%s is not %s: %s%s", png, svg, done.out, done.err);
        forget(&done);
    }
}

/* ---- The layout ------------------------------------------------------------------------------ */

static glint_draw_graph graph;
static glint_draw_layout layout;

static void lay_out(const glint_setting *setting)
{
    glint_error err;
    if (glint_draw_graph_make(setting, &graph, &err) != GLINT_OK ||
        glint_draw_lay_out(&graph, &layout, &err) != GLINT_OK)
        fail_msg("%s", err.text);
}

static bool overlap(const glint_draw_node *a, const glint_draw_node *b)
{
    return a->x < b->x + b->width && b->x < a->x + a->width &&
           abs(a->y - b->y) < (a->height + b->height) / 2;
}

static void assert_nodes_apart(const char *text)
{
    for (int i = 0; i < graph.count; i++) {
        const glint_draw_node *a = &graph.node[i];
        if (a->x < 0 || a->x + a->width > layout.width || a->y - a->height / 2 < 0 ||
            a->y + a->height / 2 > layout.height)
            fail_msg("%s: %s is outside of the picture", text, a->name);
        for (int j = 0; j < i; j++)
            if (overlap(a, &graph.node[j]))
                fail_msg("%s: %s lies on %s", text, a->name, graph.node[j].name);
        for (int net = 0; net < graph.count; net++)
            if (glint_draw_passes(&graph, net, a->column) &&
                abs(graph.pass[net][a->column] - a->y) <= a->height / 2)
                fail_msg("%s: the wire of %s runs through %s", text, graph.node[net].name, a->name);
    }
}

/* The branch of a wire at height y, between its trunk and a side of the channel. */
typedef struct branch {
    int net, y, from, to;
} branch;

static int branches_of(const glint_draw_channel *channel, branch *branches)
{
    int count = 0;
    for (int i = 0; i < channel->count; i++) {
        const glint_draw_wire *wire = &channel->wire[i];
        const int trunk = wire->trunk >= 0 ? wire->trunk : channel->right;
        for (int j = 0; j < wire->left_count; j++)
            branches[count++] = (branch){wire->net, wire->left[j], channel->left, trunk};
        for (int j = 0; j < wire->right_count; j++)
            branches[count++] = (branch){wire->net, wire->right[j], trunk, channel->right};
    }
    return count;
}

static void assert_wires_apart(const char *text)
{
    static branch branches[GLINT_DRAW_NODES_MAX * 8];
    for (int c = 0; c + 1 < graph.columns; c++) {
        const glint_draw_channel *channel = &layout.channel[c];
        const int count = branches_of(channel, branches);
        for (int i = 0; i < count; i++)
            for (int j = 0; j < i; j++) {
                const branch *a = &branches[i], *b = &branches[j];
                if (a->net != b->net && abs(a->y - b->y) < 3 && a->from < b->to && b->from < a->to)
                    fail_msg("%s: the wires of %s and %s run on one another", text,
                             graph.node[a->net].name, graph.node[b->net].name);
            }
        for (int i = 0; i < channel->count; i++)
            for (int j = 0; j < i; j++)
                if (channel->wire[i].trunk >= 0 && channel->wire[i].trunk == channel->wire[j].trunk)
                    fail_msg("%s: two trunks at one place", text);
    }
}

/* In every listed setting of every circuit that says what its blocks are. */
static void nothing_lies_on_anything_else(void **state)
{
    (void)state;
    const glint_circuit *circuit;
    for (int c = 0; (circuit = glint_circuit_number(c)) != NULL; c++) {
        glint_setting setting;
        for (int i = 0; circuit->block != NULL && glint_setting_listed(circuit, i, &setting); i++) {
            char text[GLINT_SETTING_TEXT];
            glint_setting_describe(&setting, text);
            lay_out(&setting);
            assert_nodes_apart(text);
            assert_wires_apart(text);
        }
    }
}

/* Every number of the figure appears once, and all data flows to the right. */
static void the_figure_is_complete(void **state)
{
    (void)state;
    static const int numbers[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 33};
    const glint_setting setting = glint_setting_standard(&glint_circuit_specular);
    lay_out(&setting);
    for (size_t n = 0; n < sizeof numbers / sizeof numbers[0]; n++) {
        int found = 0;
        for (int i = 0; i < graph.count; i++)
            found += graph.node[i].number == numbers[n];
        if (found != 1)
            fail_msg("block %d: %d times", numbers[n], found);
    }
    for (int e = 0; e < graph.first_edge[graph.count]; e++)
        assert_false(glint_draw_is_feedback(&graph, &graph.edge[e]));
    assert_int_equal(graph.stages, GLINT_LATENCY_PIPELINED);
}

/* ---- What is not drawn ----------------------------------------------------------------------- */

static glint_pin_info with_enable_low(const int *values, int index)
{
    glint_pin_info pin = glint_circuit_specular.pin(values, index);
    if (pin.role == GLINT_PIN_ENABLE)
        pin.role = GLINT_PIN_ENABLE_LOW;
    return pin;
}

static char *drawn(const glint_circuit *circuit)
{
    char *svg = NULL;
    size_t size;
    glint_error err = {""};
    glint_setting setting = glint_setting_standard(&glint_circuit_specular);
    FILE *out = open_memstream(&svg, &size);
    assert_non_null(out);
    setting.circuit = circuit;
    if (glint_draw_svg(&setting, out, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    assert_int_equal(fclose(out), 0);
    return svg;
}

static void an_enable_is_named_whichever_level_it_has(void **state)
{
    (void)state;
    glint_circuit circuit = glint_circuit_specular;
    circuit.pin = with_enable_low;
    char *svg = drawn(&circuit);
    assert_non_null(strstr(svg, ">not drawn: clk, reset, en<"));
    free(svg);
}

/* As dot's language has them. */
static void a_circuit_may_have_the_name_of_a_keyword(void **state)
{
    (void)state;
    glint_circuit circuit = glint_circuit_specular;
    circuit.name = "edge";
    free(drawn(&circuit));
}

/* The page is as wide as the drawing, and wide enough for a title of any length. */
static void a_long_title_fits(void **state)
{
    (void)state;
    char title[301], *svg = NULL;
    size_t size;
    int width = 0, left = 0;
    glint_error err = {""};
    glint_circuit circuit = glint_circuit_specular;
    glint_setting setting = glint_setting_standard(&glint_circuit_specular);
    FILE *out = open_memstream(&svg, &size);
    assert_non_null(out);
    memset(title, 'n', sizeof title - 1);
    title[sizeof title - 1] = '\0';
    circuit.title = title;
    setting.circuit = &circuit;
    assert_int_equal(glint_draw_svg(&setting, out, &err), GLINT_OK);
    assert_int_equal(fclose(out), 0);
    assert_int_equal(sscanf(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\"", &width),
                     1);
    const char *note = strstr(svg, "<text class=\"note\"");
    assert_non_null(note);
    assert_int_equal(sscanf(note, "<text class=\"note\" x=\"%d\"", &left), 1);
    assert_true(left >= 3000 && width > left + 200);
    free(svg);
}

/* ---- Descriptions that make none ------------------------------------------------------------- */

static glint_block_info changed;

static glint_block_info with_change(const int *values, int index)
{
    return index == 5 ? changed : glint_circuit_specular.block(values, index);
}

static void assert_refused(glint_block_info row, const char *words)
{
    glint_error err = {""};
    glint_circuit circuit = glint_circuit_specular;
    glint_setting setting = glint_setting_standard(&glint_circuit_specular);
    changed = row;
    circuit.block = with_change;
    setting.circuit = &circuit;
    assert_int_equal(glint_draw_graph_make(&setting, &graph, &err), GLINT_BAD_INPUT);
    if (strstr(err.text, words) == NULL)
        fail_msg("\"%s\" does not say \"%s\"", err.text, words);
}

static void descriptions_that_make_no_drawing_are_refused(void **state)
{
    (void)state;
    assert_refused((glint_block_info){"reg4", GLINT_SYMBOL_REGISTER, NULL, "nix", NULL, 0},
                   "nix is neither a block of the drawing nor a pin");
    assert_refused((glint_block_info){"reg4", GLINT_SYMBOL_REGISTER, NULL, "g", "g_we", 0},
                   "block reg4: g_we is neither a block of the drawing nor a pin");
    assert_refused((glint_block_info){"reg3", GLINT_SYMBOL_REGISTER, NULL, "g", NULL, 0},
                   "block reg3 appears twice");
    assert_refused((glint_block_info){NULL, GLINT_SYMBOL_REGISTER, NULL, "g", NULL, 0},
                   "block 5 has no name");
    assert_refused((glint_block_info){"reg4", GLINT_SYMBOL_COUNT, NULL, "g", NULL, 0},
                   "no known symbol");
    assert_refused((glint_block_info){"reg4", GLINT_SYMBOL_LOGIC, NULL,
                                      "g g g g g g g g g g g g g g g g g", NULL, 0},
                   "more than 16 inputs");
    assert_refused((glint_block_info){"reg 4", GLINT_SYMBOL_REGISTER, NULL, "g", NULL, 0},
                   "its name has a blank");
}

static void a_circuit_without_blocks_is_refused(void **state)
{
    (void)state;
    char line[PATH];
    (void)snprintf(line, sizeof line, "--circuit-dir tests/circuit/own/ring draw --out %s",
                   scratch_path("none.svg"));
    outcome done = run(line, "");
    assert_outcome(&done, 2,
                   "glint draw: circuit ring: its description has no blocks to draw "
                   "(glint_circuit.h)\n");
    forget(&done);
    assert_int_equal(access(scratch_path("none.svg"), F_OK), -1);
}

/* A program called dot that says something else. */
static void a_dot_that_answers_wrongly_is_refused(void **state)
{
    (void)state;
    static const struct {
        const char *script, *words;
    } dots[] = {
        {"#!/bin/sh\necho graph 1 2 3\n", "dot returned no position for n"},
        {"#!/bin/sh\necho node n0 1 1\n", "dot returned no position for"},
        {"#!/bin/sh\necho it rains; exit 1\n", "failed: it rains"},
        {"#!/bin/sh\nkill -9 $$\n", "dot (package graphviz) failed\n"},
    };
    char path[PATH], with_dot[2 * PATH], line[PATH];
    (void)snprintf(path, sizeof path, "%s", getenv("PATH"));
    (void)snprintf(with_dot, sizeof with_dot, "%s:%s", scratch_directory, path);
    (void)snprintf(line, sizeof line, "draw --out %s", scratch_path("none.svg"));
    for (size_t i = 0; i < sizeof dots / sizeof dots[0]; i++) {
        scratch_write(scratch_path("dot"), dots[i].script, strlen(dots[i].script));
        assert_int_equal(chmod(scratch_path("dot"), 0755), 0);
        assert_int_equal(setenv("PATH", with_dot, 1), 0);
        outcome done = run(line, "");
        assert_int_equal(setenv("PATH", path, 1), 0);
        assert_outcome(&done, 2, NULL);
        assert_says(done.err, dots[i].words);
        assert_int_equal(access(scratch_path("none.svg"), F_OK), -1);
        forget(&done);
    }
    assert_int_equal(unlink(scratch_path("dot")), 0);
}

/* The input for dot can be had without dot; the drawing cannot, and says why. */
static void without_dot_there_is_the_plan(void **state)
{
    (void)state;
    char path[PATH], line[PATH];
    (void)snprintf(path, sizeof path, "%s", getenv("PATH"));
    assert_int_equal(setenv("PATH", scratch_directory, 1), 0);
    draw("--circuit divider", scratch_path("plan.dot"));
    (void)snprintf(line, sizeof line, "draw --out %s", scratch_path("none.svg"));
    outcome done = run(line, "");
    assert_int_equal(setenv("PATH", path, 1), 0);
    assert_outcome(&done, 2, NULL);
    assert_says(done.err, "package graphviz");
    assert_int_equal(access(scratch_path("none.svg"), F_OK), -1);
    forget(&done);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(committed_drawings_are_what_the_descriptions_give),
        cmocka_unit_test(a_stale_drawing_would_be_seen),
        cmocka_unit_test(committed_pictures_are_the_drawings),
        cmocka_unit_test(nothing_lies_on_anything_else),
        cmocka_unit_test(the_figure_is_complete),
        cmocka_unit_test(an_enable_is_named_whichever_level_it_has),
        cmocka_unit_test(a_circuit_may_have_the_name_of_a_keyword),
        cmocka_unit_test(a_long_title_fits),
        cmocka_unit_test(descriptions_that_make_no_drawing_are_refused),
        cmocka_unit_test(a_circuit_without_blocks_is_refused),
        cmocka_unit_test(a_dot_that_answers_wrongly_is_refused),
        cmocka_unit_test(without_dot_there_is_the_plan),
    };
    return cmocka_run_group_tests(tests, read_list, forget_list);
}
