/* `glint report`: the thesis's numbers, measured, as files to read. */
#define _POSIX_C_SOURCE 200809L

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/parse.h"
#include "report/divider_report.h"

typedef struct report_options {
    const char *subject, *out;
    int64_t threads;
    bool json;
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
         .help = "for the frames; the files are the same",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->threads, 1, GLINT_THREADS_MAX}},
        {.name = "json",
         .help = "print what divider.json holds instead of the summary",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    const glint_positional positionals[] = {{"divider", &chosen->subject}};
    const glint_command_line line = {
        .command = "report",
        .summary = "Measures what the thesis says of the shift-accumulate divider (section 2.4): "
                   "errors of the increment and of the last pixel by number of shifts, operations "
                   "of its triangle, whole frames by Gouraud's shading; each number beside the "
                   "thesis's own.",
        .details =
            "Files: divider.md to read, divider.json, figure-2.12.svg and .png (by gnuplot,\n"
            "from figure-2.12.dat), and the frames with their difference pictures.\n"
            "\n"
            "Exit status: 0 all written, 1 failed, or no gnuplot and so all but the figure,\n"
            "2 malformed command line. A number that does not hold is no failure.",
        .options = options,
        .option_count = sizeof options / sizeof options[0],
        .positionals = positionals,
        .positional_count = 1,
    };
    const int status = glint_options_parse(&line, argc, argv);
    glint_quoted quoted;
    if (status == GLINT_OPTIONS_RUN && strcmp(chosen->subject, "divider") != 0)
        return glint_complain("report", GLINT_EXIT_USAGE, "there is no report on %s: only divider",
                              glint_quote(chosen->subject, &quoted));
    return status;
}

static void print_claims(const glint_claims *claims)
{
    for (int i = 0; i < claims->count; i++) {
        const glint_claim *claim = &claims->claim[i];
        printf("%-15s thesis %-9.*f measured %-11.6g %s\n",
               claim->holds ? "holds" : "does not hold:", claim->decimals, claim->stated,
               claim->measured, claim->what);
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

static void print_summary(const report_options *chosen, const glint_divider_report *report)
{
    print_claims(&report->claims);
    printf("last pixel of a span within half a level: from %d shifts on\n",
           report->first_within_half[GLINT_BITS_ROUNDED]);
    print_frames(report->scenes);
    printf("wrote %s/divider.md, divider.json%s and the frames\n", chosen->out,
           report->plotted ? ", figure-2.12.svg, figure-2.12.png" : "");
}

static int report_divider(const report_options *chosen, glint_divider_report *report)
{
    glint_error err;
    if (glint_divider_report_make(chosen->out, (int)chosen->threads, glint_stop_flag(), report,
                                  &err) != GLINT_OK)
        return glint_complain_error("report", &err);
    if (!chosen->json)
        print_summary(chosen, report);
    else if (!glint_output_json(glint_divider_report_json(report)))
        return glint_complain("report", GLINT_EXIT_FAILURE, "out of memory");
    const int status = glint_output_finish("report", GLINT_EXIT_OK);
    if (status != GLINT_EXIT_OK || report->plotted)
        return status;
    return glint_complain("report", GLINT_EXIT_FAILURE,
                          "there is no gnuplot (package gnuplot-nox), so figure-2.12.svg and "
                          "figure-2.12.png were not made");
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
    glint_divider_report *report = calloc(1, sizeof *report);
    if (report == NULL)
        return glint_complain("report", GLINT_EXIT_FAILURE, "no memory");
    const int status = report_divider(&chosen, report);
    free(report);
    return status;
}
