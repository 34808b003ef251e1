/* Which files of a directory a top can reach: none that it needs is missed, and of the others none
 * is taken where words tell. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rtl/needed.h"
#include "rtl/place.h"

#define FILES_MAX 8

/* The top is in top.v (or .sv) always. */
typedef struct tree {
    const char *what;
    const char *file[FILES_MAX][2]; /* name, text */
    /* Their names, each with a blank behind; a library's with !, packages with their place. */
    const char *needed;
} tree;

static const tree trees[] = {
    {"modules by the names of their files, through others",
     {{"a.v", "module a; b x(); endmodule"},
      {"b.v", "module b; endmodule"},
      {"c.v", "module c; a y(); endmodule"},
      {"top.v", "module top; a x(); endmodule"}},
     "a.v b.v top.v "},
    {"what a comment names is not needed",
     {{"a.v", "module a; endmodule"},
      {"b.v", "module b; endmodule"},
      {"top.v", "// a\n/* b\n * a */ module top; wire w = 4 / 2; endmodule // b"}},
     "top.v "},
    {"what looks like a comment in a string is none",
     {{"a.v", "module a; endmodule"},
      {"top.v", "module top; initial $display(\"// /* \\\" //\"); a x(); endmodule"}},
     "a.v top.v "},
    {"a part of a word is none",
     {{"mul.v", "module mul; endmodule"},
      {"top.v", "module top; mul2 x(); my_mul y(); mul$ z(); endmodule"}},
     "top.v "},
    {"included files, and what they include and name",
     {{"a.v", "module a; endmodule"},
      {"b.vh", "`define PART a"},
      {"c.vh", "`include \"b.vh\""},
      {"d.vh", ""},
      {"my-own.tab.vh", ""},
      {"top.v", "`include \"c.vh\"\n`include \"my-own.tab.vh\"\nmodule top; `PART x(); endmodule"}},
     "a.v b.vh c.vh my-own.tab.vh top.v "},
    {"a file that is included by a macro",
     {{"a.vh", ""},
      {"b.vh", "`define FILE \"a.vh\""},
      {"top.v", "`include \"b.vh\"\n`include `FILE\nmodule top; endmodule"}},
     "a.vh b.vh top.v "},
    {"both branches",
     {{"a.v", "module a; endmodule"},
      {"b.v", "module b; endmodule"},
      {"top.v", "module top;\n`ifdef FAST\na x();\n`else\nb x();\n`endif\nendmodule"}},
     "a.v b.v top.v "},
    {"modules in files of other names",
     {{"lib.v", "module a; c x(); endmodule\nmodule automatic b; endmodule"},
      {"more.sv", "interface c; endinterface"},
      {"other.v", "module d; endmodule"},
      {"top.v", "module top; b x(); e y(); endmodule\nmodule e; endmodule"}},
     "lib.v! more.sv! top.v "},
    {"a copy of a module, beside others that nobody uses",
     {{"a.v", "module a; endmodule"},
      {"old.v", "module a; b x(); endmodule\nmodule b; endmodule"},
      {"top.v", "module top; a x(); endmodule"}},
     "a.v old.v top.v "},
    {"modules in a file that is included",
     {{"parts.v", "module a; endmodule"},
      {"top.v", "`include \"parts.v\"\nmodule top; a x(); endmodule"}},
     "parts.v top.v "},
    {"names that are pasted together", /* from here on words do not tell */
     {{"a_b.v", "module a_b; endmodule"},
      {"top.v", "`define OF(x) a_``x\nmodule top; `OF(b) x(); endmodule"}},
     "a_b.v top.v "},
    {"names that a macro goes on with",
     {{"mul_8.v", "module mul_8; endmodule"},
      {"top.v", "`define N 8\nmodule top; mul_`N x(); endmodule"}},
     "mul_8.v top.v "},
    {"names that go on behind a macro",
     {{"a_b.v", "module a_b; endmodule"},
      {"top.v", "`define OF(x) x\nmodule top; `OF(a)_b x(); endmodule"}},
     "a_b.v top.v "},
    {"names in quotes of a macro",
     {{"a.vh", ""}, {"top.v", "`define OF(x) `\"x.vh`\"\n`include `OF(a)\nmodule top; endmodule"}},
     "a.vh top.v "},
    {"escaped names",
     {{"a+b.v", "module \\a+b ; endmodule"}, {"top.v", "module top; \\a+b x(); endmodule"}},
     "a+b.v! top.v "},
    {"names that are pasted together where nobody needs them",
     {{"a.v", "`define OF(x) a_``x\nmodule a; endmodule"},
      {"b.v", "module b; endmodule"},
      {"top.v", "module top; b x(); initial $display(\"x\\n%d\", 4 / 2); endmodule"}},
     "b.v top.v "},
    {"SystemVerilog",
     {{"a.sv", "module a; endmodule"},
      {"b.sv", "module b; endmodule"},
      {"types.svh", ""},
      {"top.sv", "`include \"types.svh\"\nmodule top; a x(); endmodule"}},
     "a.sv types.svh top.sv "},
    {"packages before those who import them, by a header too, and a module beside one",
     {{"a.sv", "`include \"h.svh\"\npackage a; import z::*; endpackage"},
      {"b.sv", "package b_types; typedef int b; endpackage module one; endmodule"},
      {"h.svh", "`define WIDE b_types :: b"},
      {"top.sv", "module top import a::*; (); one x(); endmodule"},
      {"z.sv", "package z; endpackage"}},
     "a.sv#3 b.sv#1 h.svh top.sv z.sv#2 "},
    {"a package that is included, or the top's own, is read anyway",
     {{"a.sv", "package a; endpackage"},
      {"top.sv", "`include \"a.sv\"\npackage t; endpackage module top import a::*, t::*; ();"
                 " endmodule"}},
     "a.sv top.sv "},
};

static void add(glint_sources *sources, const char *name, const char *text)
{
    glint_error err;
    assert_int_equal(glint_sources_add(sources, name, text, strlen(text), &err), GLINT_OK);
}

static void names_of(const glint_sources *sources, char *text, size_t size)
{
    size_t length = 0;
    text[0] = '\0';
    for (int i = 0; i < sources->count; i++) {
        length += (size_t)snprintf(text + length, size - length, "%s%s", sources->file[i].name,
                                   sources->file[i].is_library ? "!" : "");
        if (sources->file[i].package != 0)
            length +=
                (size_t)snprintf(text + length, size - length, "#%d", sources->file[i].package);
        length += (size_t)snprintf(text + length, size - length, " ");
        assert_true(length < size);
    }
}

static void what_is_needed_is_kept(void **state)
{
    (void)state;
    for (size_t t = 0; t < sizeof trees / sizeof trees[0]; t++) {
        char names[1000];
        const char *top = NULL;
        glint_sources sources = {0};
        glint_error err = {""};
        /* In any order: by name, and the last one first. */
        for (int turn = 0; turn < 2; turn++) {
            for (int i = 0; i < FILES_MAX; i++) {
                const int at = turn == 0 ? i : FILES_MAX - 1 - i;
                if (trees[t].file[at][0] != NULL)
                    add(&sources, trees[t].file[at][0], trees[t].file[at][1]);
            }
            assert_int_equal(glint_sources_need(&sources, "top", "here", &top, &err), GLINT_OK);
            assert_int_equal(strncmp(top, "top.", 4), 0);
            names_of(&sources, names, sizeof names);
            if (turn == 0 && strcmp(names, trees[t].needed) != 0)
                fail_msg("%s: %s, not %s", trees[t].what, names, trees[t].needed);
            assert_int_equal(strlen(names), strlen(trees[t].needed));
            glint_sources_free(&sources);
        }
    }
}

/* Not all of it is text. */
static void a_byte_that_ends_texts_hides_nothing(void **state)
{
    (void)state;
    static const char top[] = "module top;\0 a x(); endmodule";
    const char *file;
    glint_sources sources = {0};
    glint_error err = {""};
    add(&sources, "a.v", "module a; endmodule");
    assert_int_equal(glint_sources_add(&sources, "top.v", top, sizeof top - 1, &err), GLINT_OK);
    assert_int_equal(glint_sources_need(&sources, "top", "here", &file, &err), GLINT_OK);
    assert_int_equal(sources.count, 2);
    glint_sources_free(&sources);
}

static void a_top_that_is_not_there_is_told(void **state)
{
    (void)state;
    const char *file;
    glint_sources sources = {0};
    glint_error err = {""};
    add(&sources, "top.vh", "module top; endmodule");
    assert_int_equal(glint_sources_need(&sources, "top", "here", &file, &err), GLINT_IO_ERROR);
    assert_string_equal(err.text, "here has no top.v");
    glint_sources_free(&sources);
}

/* Verilator would take the library's, and an edit of the other one would change nothing. */
static void a_module_in_a_library_too_is_refused(void **state)
{
    (void)state;
    const char *file;
    glint_sources sources = {0};
    glint_error err = {""};
    add(&sources, "a.v", "module a; endmodule");
    add(&sources, "old.v", "module a; endmodule\nmodule b; endmodule");
    add(&sources, "top.v", "module top; a x(); b y(); endmodule");
    assert_int_equal(glint_sources_need(&sources, "top", "here", &file, &err), GLINT_BAD_INPUT);
    assert_string_equal(err.text, "here: a is both in a.v and in old.v");
    glint_sources_free(&sources);
}

static void a_package_in_two_files_is_refused(void **state)
{
    (void)state;
    const char *file;
    glint_sources sources = {0};
    glint_error err = {""};
    add(&sources, "a.sv", "package a; endpackage");
    add(&sources, "old.sv", "package a; endpackage");
    add(&sources, "top.sv", "module top import a::*; (); endmodule");
    assert_int_equal(glint_sources_need(&sources, "top", "here", &file, &err), GLINT_BAD_INPUT);
    assert_string_equal(err.text, "here: a is both in old.sv and in a.sv");
    glint_sources_free(&sources);
}

/* Of Glint's own an edit of the one circuit leaves the other alone. */
static void the_dividers_do_not_need_the_device(void **state)
{
    (void)state;
    static const char *const endings[] = {".v", ".vh", NULL};
    static const struct {
        const char *top, *needed, *not_needed;
    } tops[] = {
        {"specular_device", "color_multiplier.v ", "divider"},
        {"pipelined_divider", "divider_stage.v ", "color_multiplier.v "},
        {"shift_divider", "shift_divider.v ", "color_multiplier.v "},
    };
    for (size_t i = 0; i < sizeof tops / sizeof tops[0]; i++) {
        char names[2000], *directory;
        const char *file;
        glint_sources sources = {0};
        glint_error err = {""};
        if (glint_place_rtl(&directory, &err) != GLINT_OK ||
            glint_sources_read(&sources, directory, endings, &err) != GLINT_OK ||
            glint_sources_need(&sources, tops[i].top, directory, &file, &err) != GLINT_OK)
            fail_msg("%s", err.text);
        names_of(&sources, names, sizeof names);
        if (strstr(names, tops[i].needed) == NULL || strstr(names, tops[i].not_needed) != NULL ||
            strchr(names, '!') != NULL)
            fail_msg("%s needs %s", tops[i].top, names);
        glint_sources_free(&sources);
        free(directory);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_needed_is_kept),
        cmocka_unit_test(a_byte_that_ends_texts_hides_nothing),
        cmocka_unit_test(a_top_that_is_not_there_is_told),
        cmocka_unit_test(a_module_in_a_library_too_is_refused),
        cmocka_unit_test(a_package_in_two_files_is_refused),
        cmocka_unit_test(the_dividers_do_not_need_the_device),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
