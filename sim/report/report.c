/* Runs the sections into memory, then writes the whole: the verdicts stand before the sections that
 * they come from. */
#define _POSIX_C_SOURCE 200809L

#include "report/report.h"

#include <stdlib.h>
#include <time.h>

#include "file/directory.h"
#include "file/json_text.h"
#include "reflectance/reflectance.h"
#include "report/page.h"
#include "report/place.h"
#include "report/sections.h"

static double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static glint_status run_section(const glint_report_entry *entry, glint_report *report,
                                cJSON *numbers, glint_error *err)
{
    const glint_status status = glint_report_go_on(report, err);
    if (status != GLINT_OK)
        return status;
    report->numbers = cJSON_AddObjectToObject(numbers, entry->name);
    if (report->numbers == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the numbers of %s", entry->name);
    fprintf(report->markdown, "\n## %s\n\n", entry->title);
    return entry->write(report, err);
}

static glint_status run_sections(const glint_report_options *options, glint_report *report,
                                 cJSON *numbers, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int i = 0; i < glint_report_section_count && status == GLINT_OK; i++) {
        const glint_report_entry *entry = &glint_report_sections[i];
        if (options->progress != NULL)
            options->progress(options->context, entry->title, i, glint_report_section_count);
        status = run_section(entry, report, numbers, err);
    }
    if (status == GLINT_OK && !glint_findings_complete(report->findings))
        status = glint_fail(err, GLINT_NO_MEMORY, "no memory for the claims");
    return status;
}

static glint_status write_markdown(const glint_report *report, const char *sections,
                                   glint_error *err)
{
    glint_new_file *file;
    const glint_status status = glint_report_open(report, "index.md", &file, err);
    if (status != GLINT_OK)
        return status;
    FILE *out = glint_new_file_stream(file);
    fprintf(out,
            "# What the thesis claims, measured\n\n"
            "Made by `glint report`%s. The measured numbers here, and the verdicts with them, were "
            "computed by that run; the formulas are\nevaluated in double precision, and rows "
            "called *device* are the fixed-point "
            "circuit.\n\n"
            "A highlight is a function of c = cos γ, the cosine between the normal and the half "
            "vector, and of the\nexponent n, 1 to 1000. Blinn's cos^n is what the others stand "
            "for; W is the thesis's cosine-quadratic (2.15),\n((n+1)/3 (c−1) + 1)², zero beyond "
            "its zero. The *epicentre* is where cos^n ≥ %g (section 2.1). R is the\nshare of a "
            "beam of light that the surface gives back.\n\n%s\n\n"
            "## The claims\n\n"
            "%d hold, %d do not hold, %d cannot be decided as stated.\n\n",
            report->quick ? " with `--quick`, on coarser grids and smaller frames" : "",
            GLINT_EPICENTRE_LEVEL, glint_verdict_rules,
            glint_findings_count(report->findings, GLINT_HOLDS),
            glint_findings_count(report->findings, GLINT_DOES_NOT_HOLD),
            glint_findings_count(report->findings, GLINT_CANNOT_BE_DECIDED));
    glint_findings_write(report->findings, out);
    fputs(sections, out);
    return glint_new_file_commit(file, err);
}

static glint_status write_json(const glint_report *report, cJSON *json, glint_error *err)
{
    cJSON *claims = glint_findings_json(report->findings);
    char *text = claims != NULL && cJSON_AddItemToObject(json, "claims", claims)
                     ? glint_json_text(json)
                     : NULL;
    glint_new_file *file;
    if (text == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for index.json");
    glint_status status = glint_report_open(report, "index.json", &file, err);
    if (status == GLINT_OK) {
        fprintf(glint_new_file_stream(file), "%s\n", text);
        status = glint_new_file_commit(file, err);
    }
    free(text);
    return status;
}

/* The sections' text is in memory; json has their numbers. */
static glint_status write_all(const glint_report *report, const char *sections, cJSON *json,
                              glint_error *err)
{
    glint_status status = write_markdown(report, sections, err);
    if (status == GLINT_OK)
        status = write_json(report, json, err);
    return status == GLINT_OK ? glint_page_make(report->directory, "index", err) : status;
}

/* Before the long work: whether its end can be written. */
static glint_status check_places(const char *directory, glint_error *err)
{
    static const char *const names[] = {"index.md", "index.json", "index.html"};
    glint_place place;
    glint_status status = GLINT_OK;
    for (size_t i = 0; i < sizeof names / sizeof names[0] && status == GLINT_OK; i++) {
        status = glint_place_in(directory, names[i], &place, err);
        if (status == GLINT_OK)
            status = glint_new_file_check(place.path, err);
    }
    return status;
}

static glint_status make(const glint_report_options *options, glint_report *report, cJSON *json,
                         glint_error *err)
{
    char *sections = NULL;
    size_t size = 0;
    report->markdown = open_memstream(&sections, &size);
    if (report->markdown == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the report");
    glint_status status = run_sections(options, report, json, err);
    if (fclose(report->markdown) != 0 && status == GLINT_OK)
        status = glint_fail(err, GLINT_NO_MEMORY, "no memory for the report's text");
    if (status == GLINT_OK)
        status = write_all(report, sections, json, err);
    free(sections);
    return status;
}

glint_status glint_report_make(const glint_report_options *options, glint_report_result *result,
                               glint_error *err)
{
    const double begin = seconds_now();
    glint_report report = {.directory = options->directory,
                           .threads = options->threads,
                           .quick = options->quick,
                           .stop = options->stop,
                           .findings = glint_findings_create(),
                           .plotted = true};
    cJSON *json = cJSON_CreateObject();
    glint_status status = report.findings != NULL && json != NULL
                              ? glint_directory_make(options->directory, err)
                              : glint_fail(err, GLINT_NO_MEMORY, "no memory for the report");
    if (status == GLINT_OK)
        status = check_places(options->directory, err);
    if (status == GLINT_OK)
        status = make(options, &report, json, err);
    cJSON_Delete(json);
    if (status != GLINT_OK) {
        glint_findings_destroy(report.findings);
        report.findings = NULL;
    }
    *result = (glint_report_result){report.findings, report.plotted, seconds_now() - begin};
    return status;
}
