/* Contact sheets: pictures in rows and columns, with two lines of text above each. */
#ifndef GLINT_SIM_STUDY_SHEET_H
#define GLINT_SIM_STUDY_SHEET_H

#include <stdbool.h>

#include "image/image.h"

typedef struct glint_sheet glint_sheet;

/* For rows × columns pictures of width × height pixels, each shrunk so many times (1: as it is).
 * note is written below them all. GLINT_BAD_ARGUMENT when a side would be above
 * GLINT_IMAGE_SIDE_MAX. */
glint_status glint_sheet_create(int rows, int columns, int width, int height, int shrink,
                                const char *note, glint_sheet **sheet, glint_error *err);
void glint_sheet_destroy(glint_sheet *sheet); /* NULL is allowed */

/* The least shrinking (1…) with which the sheet is at most max_width wide and not too high. */
int glint_sheet_shrink_for(int rows, int columns, int width, int height, int max_width);

/* Lays a picture in its place: pixels are means of shrink × shrink, the background dark. */
void glint_sheet_put(glint_sheet *sheet, int row, int column, const glint_image *picture,
                     const char *first_line, const char *second_line);

/* The same for a difference picture: each block of shrink × shrink pixels shows its largest
 * difference, so a single pixel is not lost. */
void glint_sheet_put_difference(glint_sheet *sheet, int row, int column, const glint_image *picture,
                                const char *first_line, const char *second_line);

/* All object. */
const glint_image *glint_sheet_image(const glint_sheet *sheet);

/* False if the font was missing and there is no text. */
bool glint_sheet_has_words(const glint_sheet *sheet);

#endif
