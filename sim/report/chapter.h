/* A chapter of the report takes measurements: it stores its numbers by name and its pictures in the
 * directory. The text about them is in text/NAME.md (template.h), the thesis's claims in
 * claim_table.c. */
#ifndef GLINT_SIM_REPORT_CHAPTER_H
#define GLINT_SIM_REPORT_CHAPTER_H

#include <stdbool.h>

#include "file/new_file.h"
#include "image/image.h"
#include "report/numbers.h"

typedef struct glint_report {
    const char *directory; /* is there */
    int threads;
    bool quick;                /* coarser grids and smaller frames, the same code: for tests */
    const volatile bool *stop; /* may be NULL; when it becomes true: GLINT_INTERRUPTED */
    glint_numbers numbers;     /* to put into */
    bool plotted;              /* false once gnuplot was missing */
    struct glint_device_errors *device; /* device_errors.h; NULL: not measured yet */
} glint_report;

typedef glint_status glint_chapter_measure(glint_report *report, glint_error *err);

typedef struct glint_chapter {
    const char *name;  /* of its place in the page, and before its numbers' names */
    const char *title; /* its heading */
    glint_chapter_measure *measure;
    const char *const *text;
} glint_chapter;

/* In the order of the page. */
extern const glint_chapter glint_chapters[];
extern const int glint_chapter_count;

/* NULL: there is none. */
const glint_chapter *glint_chapter_find(const char *name);

/* ---- For the chapters ------------------------------------------------------------------------ */

/* GLINT_INTERRUPTED when the stop flag is up. */
glint_status glint_report_go_on(const glint_report *report, glint_error *err);

/* A file of the report, to be committed or discarded (file/new_file.h). */
glint_status glint_report_open(const glint_report *report, const char *name, glint_new_file **file,
                               glint_error *err);

glint_status glint_report_write_png(const glint_report *report, const glint_image *image,
                                    const char *name, glint_error *err);

/* Lines as in texts.h. */
glint_status glint_report_write_lines(const glint_report *report, const char *const *lines,
                                      const char *name, glint_error *err);

glint_chapter_measure glint_chapter_device, glint_chapter_lobes, glint_chapter_divider,
    glint_chapter_energy, glint_chapter_frames, glint_chapter_speed, glint_chapter_units,
    glint_chapter_rasterizers, glint_chapter_trace;

#endif
