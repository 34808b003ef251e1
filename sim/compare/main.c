/* glint-compare: what `make compare` (sim/compare/compare.sh) asks of C.
 *
 *   glint-compare units             the settings that are compared, one a line: name, top, lanes,
 *                                   a hash of the Verilog that the top can reach
 *   glint-compare bare NAME         the Verilog module that shows what a setting costs
 *   glint-compare timed NAME        the one whose clock rate is that of a setting (module.h)
 *   glint-compare errors NAME [STRIDE]   how far its W is from cosⁿ and its formula, as JSON
 *   glint-compare tables MANIFEST DIR    compare.json, compare.csv, compare.md and compare.dat in
 * DIR, of the results that MANIFEST lists
 *
 * Exit status 0: done; 2: trouble. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/setting.h"
#include "compare/errors.h"
#include "compare/module.h"
#include "compare/tables.h"
#include "compare/units.h"
#include "file/json.h"
#include "file/new_file.h"
#include "rtl/needed.h"
#include "rtl/place.h"

static const char *const verilog[] = {".v", ".vh", NULL};

static glint_status hash_of(const glint_setting *setting, char hash[GLINT_HASH_TEXT],
                            glint_error *err)
{
    glint_sources sources = {.count = 0};
    const char *top = glint_setting_top(setting), *file;
    char *directory;
    glint_status status = glint_place_rtl(&directory, err);
    if (status != GLINT_OK)
        return status;
    status = glint_sources_read(&sources, directory, verilog, err);
    if (status == GLINT_OK)
        status = glint_sources_need(&sources, top, directory, &file, err);
    if (status == GLINT_OK)
        glint_sources_hash(&sources, hash);
    glint_sources_free(&sources);
    free(directory);
    return status;
}

static glint_status print_units(glint_error *err)
{
    char name[GLINT_SETTING_TEXT], hash[GLINT_HASH_TEXT];
    glint_setting setting;
    for (int i = 0; glint_compare_setting(i, &setting); i++) {
        const glint_status status = hash_of(&setting, hash, err);
        if (status != GLINT_OK)
            return status;
        glint_setting_name(&setting, name);
        printf("%s %s %d %s\n", name, glint_setting_top(&setting), glint_compare_lanes(&setting),
               hash);
    }
    return GLINT_OK;
}

static bool add_worst(json_t *object, const char *name, const glint_compare_worst *worst)
{
    json_t *json = glint_json_add(object, name, json_object());
    return json != NULL && glint_json_add_number(json, "steps", worst->steps) &&
           glint_json_add_number(json, "n", worst->n) &&
           glint_json_add_number(json, "code", worst->code);
}

static glint_status print_errors(const glint_setting *setting, uint32_t stride, glint_error *err)
{
    glint_compare_errors errors;
    const glint_status status = glint_compare_measure(setting, stride, &errors, err);
    if (status != GLINT_OK)
        return status;
    json_t *json = json_object();
    const bool is_whole = glint_json_add_number(json, "points", (double)errors.points) &&
                          add_worst(json, "power", &errors.power) &&
                          add_worst(json, "own", &errors.own) &&
                          glint_json_add_number(json, "nmse", errors.nmse) &&
                          glint_json_add_number(json, "nmse_n", errors.nmse_n);
    char *text = is_whole ? glint_json_text(json) : NULL;
    json_decref(json);
    if (text == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the result");
    printf("%s\n", text);
    free(text);
    return GLINT_OK;
}

/* ---- Tables --------------------------------------------------------------------------------- */

#define PLOTTED "ecp5" /* whose clock rates are plotted: its multipliers' delays are known */

static void write_json(FILE *out, const json_t *tree)
{
    char *text = glint_json_text(tree);
    fprintf(out, "%s\n", text != NULL ? text : "");
    free(text);
}

static void write_points(FILE *out, const json_t *tree)
{
    glint_compare_write_points(out, tree, PLOTTED);
}

static glint_status write_file(const char *directory, const char *name, const json_t *tree,
                               void (*write)(FILE *out, const json_t *tree), glint_error *err)
{
    char path[4096];
    glint_new_file *file;
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    const glint_status status = glint_new_file_open(path, &file, err);
    if (status != GLINT_OK)
        return status;
    write(glint_new_file_stream(file), tree);
    return glint_new_file_commit(file, err);
}

static glint_status write_tables(const char *manifest, const char *directory, glint_error *err)
{
    json_t *tree;
    glint_status status = glint_compare_tree(manifest, &tree, err);
    if (status == GLINT_OK)
        status = write_file(directory, "compare.json", tree, write_json, err);
    if (status == GLINT_OK)
        status = write_file(directory, "compare.csv", tree, glint_compare_write_csv, err);
    if (status == GLINT_OK)
        status = write_file(directory, "compare.md", tree, glint_compare_write_markdown, err);
    if (status == GLINT_OK)
        status = write_file(directory, "compare.dat", tree, write_points, err);
    json_decref(tree);
    return status;
}

static glint_status run_of(const char *what, const char *name, const char *stride, glint_error *err)
{
    glint_setting setting;
    const int step = stride != NULL ? atoi(stride) : 1;
    if (!glint_compare_setting_named(name, &setting))
        return glint_fail(err, GLINT_BAD_ARGUMENT, "%s is not among the settings compared", name);
    if (step < 1)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "stride %s is not a whole number from 1",
                          stride);
    if (strcmp(what, "errors") == 0)
        return print_errors(&setting, (uint32_t)step, err);
    if (strcmp(what, "bare") == 0)
        glint_compare_write_bare(stdout, &setting);
    else if (strcmp(what, "timed") == 0)
        glint_compare_write_timed(stdout, &setting);
    else
        return glint_fail(err, GLINT_BAD_ARGUMENT, "unknown: %s", what);
    return GLINT_OK;
}

static glint_status run(int argc, char **argv, glint_error *err)
{
    if (argc == 2 && strcmp(argv[1], "units") == 0)
        return print_units(err);
    if (argc == 4 && strcmp(argv[1], "tables") == 0)
        return write_tables(argv[2], argv[3], err);
    if (argc == 3 || argc == 4)
        return run_of(argv[1], argv[2], argc == 4 ? argv[3] : NULL, err);
    return glint_fail(
        err, GLINT_BAD_ARGUMENT,
        "usage: glint-compare units | bare NAME | timed NAME | errors NAME [STRIDE] | "
        "tables MANIFEST DIR");
}

int main(int argc, char **argv)
{
    glint_error err;
    glint_status status = run(argc, argv, &err);
    if (fflush(stdout) != 0 && status == GLINT_OK)
        status = glint_fail(&err, GLINT_IO_ERROR, "cannot write to standard output");
    if (status != GLINT_OK)
        fprintf(stderr, "glint-compare: %s\n", err.text);
    return status == GLINT_OK ? 0 : 2;
}
