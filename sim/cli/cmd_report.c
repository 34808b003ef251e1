/* `glint report`: the thesis's numbers, measured, as files to read. */
#define _POSIX_C_SOURCE 200809L

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/parse.h"
#include "cli/picture.h"
#include "file/kind.h"
#include "render/render.h"
#include "report/chapter.h"
#include "report/file_text.h"
#include "report/place.h"
#include "report/report.h"

typedef struct report_options {
    const char *chapter, *out;
    int64_t threads;
    bool quick, json, force;
} report_options;

/* "device, lobes, …": the chapters there are. */
static const char *chapter_names(char *text, size_t room)
{
    size_t length = 0;
    for (int i = 0; i < glint_chapter_count && length < room; i++)
        length += (size_t)snprintf(text + length, room - length, "%s%s", i > 0 ? ", " : "",
                                   glint_chapters[i].name);
    return text;
}

/* The requested chapter must exist. */
static int check_chapter(const report_options *chosen)
{
    char names[256];
    glint_quoted quoted;
    if (chosen->chapter == NULL || glint_chapter_find(chosen->chapter) != NULL)
        return GLINT_OPTIONS_RUN;
    return glint_complain("report", GLINT_EXIT_TROUBLE, "--chapter: %s is none of %s",
                          glint_quote(chosen->chapter, &quoted),
                          chapter_names(names, sizeof names));
}

static int parse(int argc, char **argv, report_options *chosen)
{
    char names[256], help[300];
    (void)snprintf(help, sizeof help, "only that one: %s", chapter_names(names, sizeof names));
    const glint_option options[] = {
        {.name = "chapter",
         .placeholder = "NAME",
         .usually = "all",
         .help = help,
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->chapter},
        {.name = "out",
         .placeholder = "DIR",
         .help = "directory for the files; created if missing",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->out},
        {.name = "threads",
         .usually = "one per processor",
         .help = "does not change the files, except for timings",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->threads, 1, GLINT_THREADS_MAX}},
        {.name = "quick",
         .help = "coarser grids and smaller frames, in seconds",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->quick},
        GLINT_FORCE_OPTION(&chosen->force),
        {.name = "json",
         .help = "print the content of index.json instead of the summary",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    static const glint_example examples[] = {
        {"everything, with coarser grids", "glint report --quick --out report"},
        {"the divider alone", "glint report --chapter divider --out divider"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "report",
        .summary = "Measures what the thesis claims and draws its figures again: each claim with a "
                   "verdict and the number it follows from.",
        .details =
            "Files: index.html (self-contained), index.md, index.json, and the data, plots (by\n"
            "gnuplot) and pictures they are made of.\n"
            "\n"
            "The index.* files are written last. Ctrl-C or a failure before that leaves those of\n"
            "an earlier run as they were, beside data, plots and pictures, each of them whole,\n"
            "that were ready. --json prints nothing but the JSON, and nothing at all when\n"
            "interrupted. gnuplot is given a minute for each picture; without gnuplot all but\n"
            "the figures are written, and the exit status is 2.",
        .done = "everything was written, whether or not the claims hold",
        .examples = examples,
        .options = options,
        .option_count = sizeof options / sizeof options[0],
    };
    const int status = glint_options_parse(&line, argc, argv);
    return status == GLINT_OPTIONS_RUN ? check_chapter(chosen) : status;
}

/* Before the long work: checks that existing documents may be replaced. A page without the numbers
 * next to it is not from a report. */
static int check_files(const report_options *chosen)
{
    static const char *const names[] = {"index.json", "index.md", "index.html", NULL};
    bool numbers = false;
    for (int i = 0; names[i] != NULL && !chosen->force; i++) {
        glint_place place;
        glint_error err;
        if (glint_place_in(chosen->out, names[i], &place, &err) != GLINT_OK ||
            glint_file_replaceable(place.path, &err) != GLINT_OK)
            return glint_complain_error("report", &err);
        struct stat found;
        const bool there = stat(place.path, &found) == 0 && S_ISREG(found.st_mode);
        numbers = i == 0 ? there : numbers;
        if (there && !numbers)
            return glint_complain(
                "report", GLINT_EXIT_TROUBLE,
                "%s exists but is not from a report: use another directory or --force", place.path);
    }
    return GLINT_OPTIONS_RUN;
}

static void show_chapter(void *context, const char *chapter, int done, int count)
{
    (void)context;
    fprintf(stderr, "\r\033[Kglint report: %d of %d: %s", done + 1, count, chapter);
}

/* Copies the file on disk to standard output. */
static bool print_json_file(const char *directory)
{
    glint_place place;
    char *text;
    size_t size;
    if (glint_place_in(directory, "index.json", &place, NULL) != GLINT_OK ||
        glint_file_text(place.path, &text, &size, NULL) != GLINT_OK)
        return false;
    fwrite(text, 1, size, stdout);
    free(text);
    return true;
}

static void print_summary(const report_options *chosen, const glint_report_result *result)
{
    glint_claims_print(&result->claims, stdout);
    printf("%d hold, %d do not hold, %d cannot be decided as stated; %.1f s\n"
           "wrote %s/index.html, index.md and index.json\n",
           glint_claims_count(&result->claims, GLINT_HOLDS),
           glint_claims_count(&result->claims, GLINT_DOES_NOT_HOLD),
           glint_claims_count(&result->claims, GLINT_CANNOT_BE_DECIDED), result->seconds,
           chosen->out);
}

static int make_report(const report_options *chosen)
{
    glint_error err;
    glint_report_result result;
    const bool shown = isatty(STDERR_FILENO) == 1;
    const glint_report_options options = {.directory = chosen->out,
                                          .chapter = chosen->chapter,
                                          .threads = (int)chosen->threads,
                                          .quick = chosen->quick,
                                          .stop = glint_stop_flag(),
                                          .progress = shown ? show_chapter : NULL};
    int status = (int)glint_report_make(&options, &result, &err);
    if (shown)
        fputs("\r\033[K", stderr);
    if (status != (int)GLINT_OK)
        return glint_complain_error("report", &err);
    if (!chosen->json)
        print_summary(chosen, &result);
    else if (!print_json_file(chosen->out))
        return glint_complain("report", GLINT_EXIT_TROUBLE, "cannot read %s/index.json again",
                              chosen->out);
    glint_claims_free(&result.claims);
    status = glint_output_finish("report", GLINT_EXIT_OK);
    if (status != GLINT_EXIT_OK || result.plotted)
        return status;
    return glint_complain(
        "report", GLINT_EXIT_TROUBLE,
        "gnuplot (package gnuplot-nox) is not installed, so the figures were not made");
}

static int64_t online_cores(void)
{
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    return cores < 1 ? 1 : cores > GLINT_THREADS_MAX ? GLINT_THREADS_MAX : cores;
}

int glint_cmd_report(int argc, char **argv)
{
    report_options chosen = {.out = "report", .threads = online_cores()};
    const int parsed = parse(argc, argv, &chosen);
    if (parsed != GLINT_OPTIONS_RUN)
        return parsed;
    const int refused = check_files(&chosen);
    if (refused != GLINT_OPTIONS_RUN)
        return refused;
    return make_report(&chosen);
}
