/* A whole study as files: a contact sheet for each n, an overview sheet, and the tables. */
#ifndef GLINT_SIM_STUDY_MAKE_H
#define GLINT_SIM_STUDY_MAKE_H

#include "study/study.h"

#define GLINT_STUDY_ROWS_MAX 64

typedef struct glint_study_options {
    glint_study_setup setup;
    int n[GLINT_STUDY_ROWS_MAX];                          /* no two alike */
    int count;                                            /* 1…GLINT_STUDY_ROWS_MAX */
    int frames;                                           /* as in glint_study_run() */
    const char *directory;                                /* made if missing */
    const volatile bool *stop;                            /* may be NULL */
    void (*progress)(void *context, int done, int count); /* after each n; may be NULL */
    void *context;
} glint_study_options;

/* All files are renamed into place together at the end; until then, or if it fails or is
 * interrupted, the directory is unchanged (see glint_study_files_commit()). Then n-NNNN.png and
 * times.csv of an earlier study that this one did not write are removed.
 *
 * Fills rows[0] … rows[count − 1] and writes
 *   n-0050.png   A, B and their difference (docs/frames.md has its colours), for each n
 *   sheet.png    a row for each n, smaller
 *   study.csv, study.json    glint_study_write_differences(), glint_study_json()
 *   times.csv    glint_study_write_times(), when frames are timed
 * *words: false when there was no font to label the sheets with. */
glint_status glint_study_make(const glint_study_options *options, glint_study_row *rows,
                              bool *words, glint_error *err);

#endif
