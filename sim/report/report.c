/* Measures chapter after chapter, judges the claims by the numbers, then writes what was found. */
#define _POSIX_C_SOURCE 200809L

#include "report/report.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "file/directory.h"
#include "report/chapter.h"
#include "report/index_json.h"
#include "report/page.h"
#include "report/place.h"
#include "report/texts.h"

/* One run. */
typedef struct run {
    glint_report report;
    const char *only; /* the one chapter; NULL: all */
    glint_claims claims;
    const glint_chapter *chapter; /* that is being written */
} run;

static double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static bool is_asked_for(const run *r, const glint_chapter *chapter)
{
    return r->only == NULL || strcmp(r->only, chapter->name) == 0;
}

/* ---- Measuring ------------------------------------------------------------------------------- */

static glint_status measure(run *r, const glint_report_options *options, glint_error *err)
{
    glint_status status = GLINT_OK;
    const int count = r->only == NULL ? glint_chapter_count : 1;
    int done = 0;
    for (int i = 0; i < glint_chapter_count && status == GLINT_OK; i++) {
        const glint_chapter *chapter = &glint_chapters[i];
        if (!is_asked_for(r, chapter))
            continue;
        if (options->progress != NULL)
            options->progress(options->context, chapter->title, done, count);
        status = glint_report_go_on(&r->report, err);
        if (status == GLINT_OK)
            status = chapter->measure(&r->report, err);
        done++;
    }
    return status;
}

static glint_status judge(run *r, glint_error *err)
{
    static const char *const names[GLINT_VERDICT_COUNT] = {"hold", "do-not-hold", "undecided"};
    glint_numbers *numbers = &r->report.numbers;
    const glint_status status = glint_claims_make(numbers, r->only, &r->claims, err);
    for (int i = 0; i < GLINT_VERDICT_COUNT && status == GLINT_OK; i++)
        glint_number_put(numbers, glint_claims_count(&r->claims, (glint_verdict)i), "claims.%s",
                         names[i]);
    glint_number_put(numbers, r->claims.count, "claims.count");
    glint_number_put_text(
        numbers, r->report.quick ? " with `--quick`, on coarser grids and smaller frames" : "",
        "report.quick");
    return status == GLINT_OK && numbers->incomplete
               ? glint_fail(err, GLINT_NO_MEMORY, "no memory for the report's numbers")
               : status;
}

/* ---- Writing --------------------------------------------------------------------------------- */

static glint_status write_figure(const run *r, const char *name, const char *caption, FILE *out,
                                 glint_error *err)
{
    const glint_template how = {.numbers = &r->report.numbers};
    char text[1024];
    const glint_status status = glint_template_line(&how, caption, text, sizeof text, err);
    if (status != GLINT_OK)
        return status;
    if (r->report.plotted)
        fprintf(out, "<figure>\n\n![%s](%s.svg)\n\n*%s*\n\n</figure>\n", name, name, text);
    else
        fprintf(out, "*%s* (There was no gnuplot to draw it; the data is in %s.dat.)", text, name);
    return GLINT_OK;
}

static const char *title_of(const char *chapter)
{
    return glint_chapter_find(chapter)->title;
}

static glint_status write_word(void *context, const char *word, const char *rest, FILE *out,
                               glint_error *err)
{
    const run *r = context;
    if (strncmp(word, "figure ", 7) == 0)
        return write_figure(r, word + 7, rest, out, err);
    if (strcmp(word, "claims") == 0)
        glint_claims_write_links(&r->claims, r->chapter->name, out);
    else if (strcmp(word, "table") == 0)
        glint_claims_write_table(&r->claims, title_of, out);
    else
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "the report's text has {%s}: nothing measured "
                          "that",
                          word);
    return GLINT_OK;
}

static glint_status write_text(run *r, FILE *out, glint_error *err)
{
    const glint_template how = {&r->report.numbers, write_word, r};
    glint_status status = glint_template_write(&how, glint_text_head, out, err);
    if (status == GLINT_OK && r->only == NULL)
        status = glint_template_write(&how, glint_text_summary, out, err);
    for (int i = 0; i < glint_chapter_count && status == GLINT_OK; i++) {
        r->chapter = &glint_chapters[i];
        if (!is_asked_for(r, r->chapter))
            continue;
        fprintf(out, "\n<a id=\"%s\"></a>\n\n## %s\n\n", r->chapter->name, r->chapter->title);
        status = glint_template_write(&how, r->chapter->text, out, err);
    }
    return status == GLINT_OK ? glint_template_write(&how, glint_text_claims, out, err) : status;
}

static glint_status write_markdown(run *r, glint_error *err)
{
    glint_new_file *file;
    glint_status status = glint_report_open(&r->report, "index.md", &file, err);
    if (status != GLINT_OK)
        return status;
    status = write_text(r, glint_new_file_stream(file), err);
    if (status == GLINT_OK)
        return glint_new_file_commit(file, err);
    glint_new_file_discard(file);
    return status;
}

static glint_status write_json(const run *r, glint_error *err)
{
    char *text = glint_index_json(&r->claims, &r->report.numbers);
    glint_new_file *file;
    if (text == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for index.json");
    glint_status status = glint_report_open(&r->report, "index.json", &file, err);
    if (status == GLINT_OK) {
        fprintf(glint_new_file_stream(file), "%s\n", text);
        status = glint_new_file_commit(file, err);
    }
    free(text);
    return status;
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

static glint_status make(run *r, const glint_report_options *options, glint_error *err)
{
    glint_status status = glint_directory_make(options->directory, err);
    if (status == GLINT_OK)
        status = check_places(options->directory, err);
    if (status == GLINT_OK)
        status = measure(r, options, err);
    if (status == GLINT_OK)
        status = judge(r, err);
    if (status == GLINT_OK)
        status = write_markdown(r, err);
    if (status == GLINT_OK)
        status = write_json(r, err);
    return status == GLINT_OK ? glint_page_make(options->directory, "index", err) : status;
}

glint_status glint_report_make(const glint_report_options *options, glint_report_result *result,
                               glint_error *err)
{
    const double begin = seconds_now();
    run r = {.report = {.directory = options->directory,
                        .threads = options->threads,
                        .quick = options->quick,
                        .stop = options->stop,
                        .plotted = true},
             .only = options->chapter};
    const glint_status status =
        r.only == NULL || glint_chapter_find(r.only) != NULL
            ? make(&r, options, err)
            : glint_fail(err, GLINT_BAD_ARGUMENT, "unknown chapter %.60s", r.only);
    glint_numbers_clear(&r.report.numbers);
    free(r.report.device);
    if (status != GLINT_OK)
        glint_claims_free(&r.claims);
    *result = (glint_report_result){r.claims, r.report.plotted, seconds_now() - begin};
    return status;
}
