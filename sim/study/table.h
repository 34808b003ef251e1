/* The rows of a study as text for other programs. Times are kept separate from everything else,
 * which is the same on every run. */
#ifndef GLINT_SIM_STUDY_TABLE_H
#define GLINT_SIM_STUDY_TABLE_H

#include <stdio.h>

#include "file/json.h"
#include "study/study.h"

/* CSV with a header: n, NMSE, PSNR (inf: equal), largest difference and where (empty: nowhere),
 * pixels, triangles, what the thesis reads from the NMSE; then A, B, the model and its density
 * (empty: it has none). */
void glint_study_write_differences(FILE *to, const glint_study_setup *setup,
                                   const glint_study_row *rows, int count);

/* CSV with a header: n, frames timed, seconds and frames a second of A and B, B's time to A's; then
 * A, B, the model and its density. */
void glint_study_write_times(FILE *to, const glint_study_setup *setup, const glint_study_row *rows,
                             int count);

/* The methods, the scene with its model, and the same rows; psnr null: infinite, largest_x and
 * largest_y null: nowhere, density null: the model has none. NULL: no memory. */
json_t *glint_study_json(const glint_study_setup *setup, const glint_study_row *rows, int count);

/* An array of the times; NULL: no memory. */
json_t *glint_study_times_json(const glint_study_row *rows, int count);

#endif
