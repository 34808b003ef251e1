/* Measures, then writes; see divider_report.h. */
#include "report/divider_report.h"

#include <stdlib.h>

#include "file/directory.h"
#include "file/json_text.h"
#include "file/new_file.h"
#include "report/divider_parts.h"
#include "report/place.h"
#include "report/plot.h"

static glint_status open_file(const char *directory, const char *name, glint_new_file **file,
                              glint_error *err)
{
    glint_place place;
    const glint_status status = glint_place_in(directory, name, &place, err);
    return status == GLINT_OK ? glint_new_file_open(place.path, file, err) : status;
}

static glint_status write_plot_file(const char *directory, const char *name,
                                    void (*write)(FILE *out), glint_error *err)
{
    glint_new_file *file;
    const glint_status status = open_file(directory, name, &file, err);
    if (status != GLINT_OK)
        return status;
    write(glint_new_file_stream(file));
    return glint_new_file_commit(file, err);
}

static glint_status plot(const char *directory, const volatile bool *stop, bool *plotted,
                         glint_error *err)
{
    const glint_plot_limits limits = {stop, GLINT_PLOT_SECONDS};
    glint_status status =
        write_plot_file(directory, "figure-2.12.dat", glint_divider_write_plot_data, err);
    if (status == GLINT_OK)
        status =
            write_plot_file(directory, "figure-2.12.gnuplot", glint_divider_write_plot_script, err);
    return status == GLINT_OK ? glint_plot(directory, "figure-2.12", &limits, plotted, err)
                              : status;
}

static glint_status write_markdown(const char *directory, const glint_divider_report *report,
                                   glint_error *err)
{
    glint_new_file *file;
    const glint_status status = open_file(directory, "divider.md", &file, err);
    if (status != GLINT_OK)
        return status;
    glint_divider_write_markdown(glint_new_file_stream(file), report);
    return glint_new_file_commit(file, err);
}

static glint_status write_json_text(const char *directory, const char *text, glint_error *err)
{
    glint_new_file *file;
    const glint_status status = open_file(directory, "divider.json", &file, err);
    if (status != GLINT_OK)
        return status;
    fprintf(glint_new_file_stream(file), "%s\n", text);
    return glint_new_file_commit(file, err);
}

static glint_status write_json(const char *directory, const glint_divider_report *report,
                               glint_error *err)
{
    cJSON *json = glint_divider_report_json(report);
    char *text = glint_json_text(json);
    cJSON_Delete(json);
    if (text == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for divider.json");
    const glint_status status = write_json_text(directory, text, err);
    free(text);
    return status;
}

static void measure_errors(glint_divider_report *report)
{
    for (int rule = 0; rule < GLINT_BITS_RULE_COUNT; rule++) {
        for (int i = 0; i < GLINT_REPORT_SHIFTS; i++)
            report->error[rule][i] =
                glint_divider_error_of(GLINT_DIVIDER_SHIFTS_MIN + i, (glint_bits_rule)rule);
        report->first_within_half[rule] = glint_divider_first_within_half((glint_bits_rule)rule);
    }
}

glint_status glint_divider_report_make(const char *directory, int threads,
                                       const volatile bool *stop, glint_divider_report *report,
                                       glint_error *err)
{
    measure_errors(report);
    glint_status status = glint_count_table_21(GLINT_DIVIDER_SHIFTS_DEFAULT, &report->table, err);
    if (status == GLINT_OK)
        status = glint_directory_make(directory, err);
    if (status == GLINT_OK)
        status = plot(directory, stop, &report->plotted, err);
    if (status == GLINT_OK)
        status = glint_divider_render_scenes(directory, threads, stop, report->scenes, err);
    if (status != GLINT_OK)
        return status;
    glint_claims_check(&(glint_claims_facts){.example = glint_divider_example_of(255, 7, 6),
                                             .error = report->error[GLINT_BITS_ROUNDED],
                                             .table = &report->table,
                                             .scenes = report->scenes},
                       &report->claims);
    status = write_markdown(directory, report, err);
    return status == GLINT_OK ? write_json(directory, report, err) : status;
}
