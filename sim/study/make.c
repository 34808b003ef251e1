/* Runs a study for each n and writes its files; see make.h. */
#include "study/make.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "file/json.h"
#include "study/files.h"
#include "study/sheet.h"
#include "study/table.h"

#define COLUMNS     3
#define SHEET_WIDTH 1100 /* of sheet.png, about */

static const char note[] =
    "Difference, largest of a component: blue 1, green 2-3, yellow 4-15, orange 16-63, red 64 and "
    "more levels; grey: none.";

/* A study on its way. */
typedef struct making {
    const glint_study_options *options;
    glint_study *study;
    glint_study_files *files;
    glint_sheet *all;
    bool words;
} making;

static glint_status write_picture(const making *m, const glint_sheet *sheet, const char *name,
                                  glint_error *err)
{
    FILE *stream;
    char path[512];
    snprintf(path, sizeof path, "%.400s/%s", m->options->directory, name);
    glint_status status = glint_study_files_add(m->files, name, &stream, err);
    if (status == GLINT_OK) {
        status = glint_image_print_png(glint_sheet_image(sheet), stream, path,
                                       &(glint_image_control){.stop = m->options->stop}, err);
    }
    return status == GLINT_OK ? glint_study_files_end(m->files, err) : status;
}

/* The words over the three pictures of a row. */
static void put_row(const making *m, glint_sheet *sheet, int at, const glint_study_row *row,
                    const glint_image *difference)
{
    for (int i = 0; i < 2; i++) {
        glint_study_name name;
        char first[128], second[128];
        snprintf(first, sizeof first, "%c: %s, n = %d", "AB"[i],
                 glint_study_method_name(&m->options->setup.method[i], &name), row -> n);
        snprintf(second, sizeof second, "highlight on %" PRIu64 " of %" PRIu64 " triangles",
                 row->highlit[i], row->triangles);
        glint_sheet_put(sheet, at, i, glint_study_picture(m->study, i), first, second);
    }
    char first[128], second[128];
    snprintf(first, sizeof first, "NMSE %.3g: %s", row->difference.nmse,
             glint_image_reading(row->difference.nmse));
    snprintf(second, sizeof second, "PSNR %.4g dB, largest difference %d levels",
             row->difference.psnr, row->difference.largest);
    glint_sheet_put_difference(sheet, at, 2, difference, first, second);
}

static glint_status write_sheet(making *m, int at, const glint_study_row *row,
                                const glint_image *difference, glint_error *err)
{
    const glint_study_setup *setup = &m->options->setup;
    const int shrink =
        glint_sheet_shrink_for(1, COLUMNS, setup->width, setup->height, GLINT_IMAGE_SIDE_MAX);
    glint_sheet *sheet;
    glint_status status =
        glint_sheet_create(1, COLUMNS, setup->width, setup->height, shrink, note, &sheet, err);
    if (status == GLINT_OK) {
        char name[32];
        snprintf(name, sizeof name, "n-%04d.png", row->n);
        put_row(m, sheet, 0, row, difference);
        put_row(m, m->all, at, row, difference);
        m->words = glint_sheet_has_words(sheet);
        status = write_picture(m, sheet, name, err);
    }
    glint_sheet_destroy(sheet);
    return status;
}

static glint_status make_row(making *m, int at, glint_study_row *row, glint_error *err)
{
    const glint_study_options *options = m->options;
    glint_status status =
        glint_study_run(m->study, options->n[at], options->frames, options->stop, row, err);
    glint_image *difference = NULL;
    if (status == GLINT_OK) {
        status = glint_image_difference_picture(glint_study_picture(m->study, 0),
                                                glint_study_picture(m->study, 1), &difference, err);
    }
    if (status == GLINT_OK)
        status = write_sheet(m, at, row, difference, err);
    glint_image_destroy(difference);
    if (status == GLINT_OK && options->progress != NULL)
        options->progress(options->context, at + 1, options->count);
    return status;
}

static glint_status write_table(const making *m, const char *name,
                                void (*write)(FILE *to, const glint_study_setup *setup,
                                              const glint_study_row *rows, int count),
                                const glint_study_row *rows, glint_error *err)
{
    FILE *stream;
    const glint_status status = glint_study_files_add(m->files, name, &stream, err);
    if (status != GLINT_OK)
        return status;
    write(stream, &m->options->setup, rows, m->options->count);
    return glint_study_files_end(m->files, err);
}

static glint_status write_json(const making *m, const glint_study_row *rows, glint_error *err)
{
    json_t *json = glint_study_json(&m->options->setup, rows, m->options->count);
    char *text = glint_json_text(json);
    json_decref(json);
    FILE *stream;
    glint_status status = text != NULL
                              ? glint_study_files_add(m->files, "study.json", &stream, err)
                              : glint_fail(err, GLINT_NO_MEMORY, "not enough memory for JSON");
    if (status == GLINT_OK) {
        fprintf(stream, "%s\n", text);
        status = glint_study_files_end(m->files, err);
    }
    free(text);
    return status;
}

static glint_status write_tables(const making *m, const glint_study_row *rows, glint_error *err)
{
    glint_status status = write_picture(m, m->all, "sheet.png", err);
    if (status == GLINT_OK)
        status = write_table(m, "study.csv", glint_study_write_differences, rows, err);
    if (status == GLINT_OK)
        status = write_json(m, rows, err);
    return status == GLINT_OK && m->options->frames > 0
               ? write_table(m, "times.csv", glint_study_write_times, rows, err)
               : status;
}

static glint_status finish(const making *m, glint_error *err)
{
    return m->options->stop != NULL && *m->options->stop
               ? glint_fail(err, GLINT_INTERRUPTED, "interrupted")
               : glint_study_files_commit(m->files, err);
}

/* Detects an exponent that a model does not accept before any file is written. */
static glint_status check_exponents(const glint_study_options *options, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int i = 0; status == GLINT_OK && i < 2 * options->count; i++) {
        const glint_study_method *method = &options->setup.method[i % 2];
        if (method->by_model)
            status = glint_scene_check_exponent(method->model, options->n[i / 2], err);
    }
    return status;
}

glint_status glint_study_make(const glint_study_options *options, glint_study_row *rows,
                              bool *words, glint_error *err)
{
    if (options->count < 1 || options->count > GLINT_STUDY_ROWS_MAX) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "a study of %d exponents: not from 1 to %d",
                          options->count, GLINT_STUDY_ROWS_MAX);
    }
    const glint_study_setup *setup = &options->setup;
    making m = {.options = options};
    glint_status status = check_exponents(options, err);
    if (status == GLINT_OK)
        status = glint_study_files_create(options->directory, &m.files, err);
    if (status == GLINT_OK)
        status = glint_study_create(setup, &m.study, err);
    if (status == GLINT_OK) {
        const int shrink = glint_sheet_shrink_for(options->count, COLUMNS, setup->width,
                                                  setup->height, SHEET_WIDTH);
        status = glint_sheet_create(options->count, COLUMNS, setup->width, setup->height, shrink,
                                    note, &m.all, err);
    }
    for (int i = 0; status == GLINT_OK && i < options->count; i++)
        status = make_row(&m, i, &rows[i], err);
    if (status == GLINT_OK)
        status = write_tables(&m, rows, err);
    if (status == GLINT_OK)
        status = finish(&m, err);
    *words = m.words;
    glint_sheet_destroy(m.all);
    glint_study_destroy(m.study);
    glint_study_files_destroy(m.files);
    return status;
}
