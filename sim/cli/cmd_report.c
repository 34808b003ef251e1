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
#include "report/divider_report.h"
#include "report/file_text.h"
#include "report/place.h"
#include "report/report.h"

typedef struct report_options {
    const char *subject, *out;
    int64_t threads;
    bool quick, json, force;
} report_options;

static int parse(int argc, char **argv, report_options *chosen)
{
    const glint_option options[] = {
        {.name = "out",
         .placeholder = "DIR",
         .help = "where the files go; made if missing",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->out},
        {.name = "threads",
         .usually = "one a processor",
         .help = "the files are the same, but for what is timed",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->threads, 1, GLINT_THREADS_MAX}},
        {.name = "quick",
         .help = "the whole report on coarser grids and with smaller frames, in seconds",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->quick},
        GLINT_FORCE_OPTION(&chosen->force),
        {.name = "json",
         .help = "print what index.json (divider.json) holds instead of the summary",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    const glint_positional positionals[] = {
        {.name = "divider", .value = &chosen->subject, .optional = true}};
    static const glint_example examples[] = {
        {"everything, with coarser grids", "glint report --quick --out report"},
        {"the divider alone", "glint report divider --out divider"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "report",
        .summary =
            "Measures what the thesis claims in numbers and draws figures of it again: claims with "
            "a verdict, the number and the conditions. With "
            "the word divider: only what section 2.4 says of the shift-accumulate divider.",
        .details =
            "Files: index.html (self-contained), index.md, index.json, and the data, plots (by\n"
            "gnuplot) and pictures they are made of; of the divider alone divider.md,\n"
            "divider.json, figure-2.12.svg and .png, and the frames.\n"
            "\n"
            "The index.* files (divider.*) are written last. Ctrl-C or a failure before that\n"
            "leaves those of an earlier run as they were, beside data, plots and pictures, each of "
            "them\n"
            "whole, that were ready. --json prints nothing but the JSON, and nothing at all when\n"
            "interrupted. gnuplot is given a minute for each picture;\n"
            "without gnuplot all but the figures are written, and the exit status is 2.",
        .done = "all written; a claim that does not hold is no failure",
        .examples = examples,
        .options = options,
        .option_count = sizeof options / sizeof options[0],
        .positionals = positionals,
        .positional_count = 1,
    };
    const int status = glint_options_parse(&line, argc, argv);
    glint_quoted quoted;
    if (status != GLINT_OPTIONS_RUN || chosen->subject == NULL)
        return status;
    if (strcmp(chosen->subject, "divider") != 0)
        return glint_complain("report", GLINT_EXIT_TROUBLE,
                              "there is no report on %s: only divider",
                              glint_quote(chosen->subject, &quoted));
    if (chosen->quick)
        return glint_complain("report", GLINT_EXIT_TROUBLE,
                              "--quick goes with the whole report, not with divider");
    return status;
}

/* Before the long work: whether the documents may take the place of what is there. A page without
 * the numbers beside it is no report's. */
static int check_files(const report_options *chosen)
{
    static const char *const whole[] = {"index.json", "index.md", "index.html", NULL};
    static const char *const divider[] = {"divider.json", "divider.md", NULL};
    const char *const *names = chosen->subject != NULL ? divider : whole;
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
            return glint_complain("report", GLINT_EXIT_TROUBLE,
                                  "%s is there and is of no report: take another directory, or "
                                  "--force",
                                  place.path);
    }
    return GLINT_OPTIONS_RUN;
}

static void print_claims(const glint_claims *claims)
{
    for (int i = 0; i < claims->count; i++) {
        const glint_claim *claim = &claims->claim[i];
        printf("%s%-*s thesis %-9.*f measured %-11.6g %s\n", glint_verdict_names[claim->verdict],
               18 - (int)strlen(glint_verdict_names[claim->verdict]),
               claim->verdict == GLINT_HOLDS ? "" : ":", claim->judged.decimals,
               claim->judged.stated, claim->judged.lowest, claim->what);
    }
}

static void print_frames(const glint_divider_scene *scenes)
{
    for (int i = 0; i < GLINT_DIVIDER_SCENES; i++)
        for (int j = 0; j < GLINT_DIVIDER_FRAMES; j++) {
            const glint_divider_frame *frame = &scenes[i].frames[j];
            printf("%s, density %3d, %2d shifts: NMSE %.3g, largest difference %d\n",
                   scenes[i].model, scenes[i].density, frame->shifts, frame->difference.nmse,
                   frame->difference.largest);
        }
}

static void print_divider_summary(const report_options *chosen, const glint_divider_report *report)
{
    print_claims(&report->claims);
    printf("last pixel of a span within half a level: from %d shifts on\n",
           report->first_within_half[GLINT_BITS_ROUNDED]);
    print_frames(report->scenes);
    printf("wrote %s/divider.md, divider.json%s and the frames\n", chosen->out,
           report->plotted ? ", figure-2.12.svg, figure-2.12.png" : "");
}

static int finish(bool plotted, const char *missing)
{
    const int status = glint_output_finish("report", GLINT_EXIT_OK);
    if (status != GLINT_EXIT_OK || plotted)
        return status;
    return glint_complain("report", GLINT_EXIT_TROUBLE,
                          "there is no gnuplot (package gnuplot-nox), so %s were not made",
                          missing);
}

static int report_divider(const report_options *chosen, glint_divider_report *report)
{
    glint_error err;
    if (glint_divider_report_make(chosen->out, (int)chosen->threads, glint_stop_flag(), report,
                                  &err) != GLINT_OK)
        return glint_complain_error("report", &err);
    if (!chosen->json)
        print_divider_summary(chosen, report);
    else if (!glint_output_json(glint_divider_report_json(report)))
        return glint_complain("report", GLINT_EXIT_TROUBLE, "out of memory");
    return finish(report->plotted, "figure-2.12.svg and figure-2.12.png");
}

static int on_divider(const report_options *chosen)
{
    glint_divider_report *report = calloc(1, sizeof *report);
    if (report == NULL)
        return glint_complain("report", GLINT_EXIT_TROUBLE, "no memory");
    const int status = report_divider(chosen, report);
    free(report);
    return status;
}

static void show_section(void *context, const char *section, int done, int count)
{
    (void)context;
    fprintf(stderr, "\r\033[Kglint report: %d of %d: %s", done + 1, count, section);
}

/* The file as it is on the disk, to standard output. */
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
    glint_findings_print(result->findings, stdout);
    printf("%d hold, %d do not hold, %d cannot be decided as stated; %.1f s\n"
           "wrote %s/index.html, index.md and index.json\n",
           glint_findings_count(result->findings, GLINT_HOLDS),
           glint_findings_count(result->findings, GLINT_DOES_NOT_HOLD),
           glint_findings_count(result->findings, GLINT_CANNOT_BE_DECIDED), result->seconds,
           chosen->out);
}

static int on_everything(const report_options *chosen)
{
    glint_error err;
    glint_report_result result;
    const bool shown = isatty(STDERR_FILENO) == 1;
    const glint_report_options options = {.directory = chosen->out,
                                          .threads = (int)chosen->threads,
                                          .quick = chosen->quick,
                                          .stop = glint_stop_flag(),
                                          .progress = shown ? show_section : NULL};
    const glint_status status = glint_report_make(&options, &result, &err);
    if (shown)
        fputs("\r\033[K", stderr);
    if (status != GLINT_OK)
        return glint_complain_error("report", &err);
    if (!chosen->json)
        print_summary(chosen, &result);
    else if (!print_json_file(chosen->out))
        return glint_complain("report", GLINT_EXIT_TROUBLE, "cannot read %s/index.json again",
                              chosen->out);
    glint_findings_destroy(result.findings);
    return finish(result.plotted, "the figures");
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
    return chosen.subject != NULL ? on_divider(&chosen) : on_everything(&chosen);
}
