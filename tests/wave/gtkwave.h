/* GTKWave itself, on a private display: opens a waveform with its save file and reports what it
 * shows. The files are in the scratch directory. Include it after cmocka.h and scratch.h. */
#ifndef GLINT_TESTS_WAVE_GTKWAVE_H
#define GLINT_TESTS_WAVE_GTKWAVE_H

#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../child.h"

#define GTKWAVE_ROWS_MAX 2048

/* GTKWave's own report. */
typedef struct gtkwave_shown {
    char name[GTKWAVE_ROWS_MAX][64];  /* "" for room below a curve */
    char value[GTKWAVE_ROWS_MAX][64]; /* at the marker */
    int count;
    int64_t from, to, marker;                /* ns: what the wave area shows */
    int64_t first, last;                     /* what the waveform has */
    int wave_width, wave_height, row_height; /* pixels */
} gtkwave_shown;

enum { GTKWAVE_SECONDS = 120 /* it takes two; a busy machine, many times that */ };

/* The window has its size some time after it was asked for: first it is drawn until nothing
 * changes. */
static const char gtkwave_script[] =
    "set quiet 0\n"
    "set last {}\n"
    "for {set i 0} {$i < 400 && $quiet < 8} {incr i} {\n"
    "  after 25\n"
    "  gtkwave::nop\n"
    "  set now [list [gtkwave::getWaveWidth] [gtkwave::getWaveHeight] "
    "[gtkwave::getWindowStartTime]]\n"
    "  if {$now eq $last && [gtkwave::getWaveWidth] > 100} {incr quiet} else {set quiet 0}\n"
    "  set last $now\n"
    "}\n"
    "set out [open $::env(GLINT_GTKWAVE_REPORT) w]\n"
    "puts $out \"window [gtkwave::getWindowStartTime] [gtkwave::getWindowEndTime] "
    "[gtkwave::getMarker] [gtkwave::getMinTime] [gtkwave::getMaxTime] [gtkwave::getWaveWidth] "
    "[gtkwave::getWaveHeight] [gtkwave::getFontHeight]\"\n"
    "for {set i 0} {$i < [gtkwave::getTotalNumTraces]} {incr i} {\n"
    "  puts $out \"|[gtkwave::getTraceNameFromIndex $i]|"
    "[gtkwave::getTraceValueAtMarkerFromIndex $i]|\"\n"
    "}\n"
    "close $out\n"
    "gtkwave::/File/Quit\n";

/* Once, before the first gtkwave_open(); 0: done. */
static inline int gtkwave_prepare(void)
{
    scratch_write(scratch_path("ask.tcl"), gtkwave_script, sizeof gtkwave_script - 1);
    /* Ignores the user's settings. */
    return setenv("HOME", scratch_directory, 1) |
           setenv("GLINT_GTKWAVE_REPORT", scratch_path("report"), 1);
}

/* "|name|value|"; groups and headings have no value, and neither has what a folded group hides. */
static inline void gtkwave_read_line(gtkwave_shown *shown, const char *line)
{
    const char *value = strchr(line + 1, '|') + 1;
    const int name_length = (int)(value - line - 2);
    const int value_length = (int)(strrchr(value, '|') - value);
    assert_true(shown->count < GTKWAVE_ROWS_MAX);
    assert_true(name_length < 64 && value_length < 64);
    (void)snprintf(shown->name[shown->count], 64, "%.*s", name_length, line + 1);
    (void)snprintf(shown->value[shown->count], 64, "%.*s", value_length, value);
    shown->count++;
}

static inline void gtkwave_read_report(gtkwave_shown *shown)
{
    char line[512];
    FILE *stream = fopen(scratch_path("report"), "r");
    assert_non_null(stream);
    memset(shown, 0, sizeof *shown);
    assert_non_null(fgets(line, sizeof line, stream));
    assert_int_equal(
        sscanf(line, "window %" SCNd64 " %" SCNd64 " %" SCNd64 " %" SCNd64 " %" SCNd64 " %d %d %d",
               &shown->from, &shown->to, &shown->marker, &shown->first, &shown->last,
               &shown->wave_width, &shown->wave_height, &shown->row_height),
        8);
    while (fgets(line, sizeof line, stream) != NULL)
        gtkwave_read_line(shown, line);
    fclose(stream);
}

static inline void gtkwave_assert_silent(const char *file)
{
    static const char *const complaints[] = {"not found", "rror",  "arning",
                                             "ould not",  "annot", "nvalid"};
    char *said = scratch_read(scratch_path(file), NULL);
    for (size_t i = 0; i < sizeof complaints / sizeof complaints[0]; i++)
        if (strstr(said, complaints[i]) != NULL)
            fail_msg("GTKWave says:\n%s", said);
    free(said);
}

/* The save file with another size in it; what the window manager says takes its place. */
static inline void gtkwave_resize(const char *save_file, int width, int height, const char *to)
{
    size_t length;
    char *text = scratch_read(save_file, &length);
    char *size = strstr(text, "\n[size] ");
    char *rest = size != NULL ? strchr(size + 1, '\n') : NULL;
    FILE *stream = fopen(to, "w");
    assert_true(rest != NULL && stream != NULL);
    fprintf(stream, "%.*s\n[size] %d %d%s", (int)(size - text), text, width, height, rest);
    assert_int_equal(fclose(stream), 0);
    free(text);
}

/* Fails the test if GTKWave does not open the files or complains about anything. A width other than
 * 0 is what a window manager gives the window instead of what the save file asks for. */
static inline void gtkwave_open(const char *waveform, const char *save_file, int width, int height,
                                gtkwave_shown *shown)
{
    char paths[3][1024];
    (void)snprintf(paths[0], sizeof paths[0], "%s", scratch_path("ask.tcl"));
    (void)snprintf(paths[1], sizeof paths[1], "%s", scratch_path(waveform));
    (void)snprintf(paths[2], sizeof paths[2], "%s", scratch_path(save_file));
    if (width != 0) {
        (void)snprintf(paths[2], sizeof paths[2], "%s", scratch_path("resized.gtkw"));
        gtkwave_resize(scratch_path(save_file), width, height, paths[2]);
    }
    const char *const argv[] = {"xvfb-run", "-a", "-s",     "-screen 0 4096x2160x24",
                                "gtkwave",  "-S", paths[0], paths[1],
                                paths[2],   NULL};
    (void)remove(scratch_path("report"));
    const int status = child_run(argv, GTKWAVE_SECONDS);
    if (status != 0) {
        fail_msg("gtkwave %s %s: status %d; installed by sim/deps.sh gtkwave; it says:\n%s%s",
                 waveform, save_file, status, scratch_read(scratch_path("child.out"), NULL),
                 scratch_read(scratch_path("child.err"), NULL));
    }
    gtkwave_assert_silent("child.out");
    gtkwave_assert_silent("child.err");
    gtkwave_read_report(shown);
}

#endif
