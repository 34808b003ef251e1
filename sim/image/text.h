/* Lines of text on pictures, through FreeType. */
#ifndef GLINT_SIM_IMAGE_TEXT_H
#define GLINT_SIM_IMAGE_TEXT_H

#include "image/image.h"

typedef struct glint_text glint_text;

/* Letters for that line height, in pixels (6…200). NULL if the font is missing (Debian:
 * fonts-dejavu-core) or out of memory; callers then leave the labels out. */
glint_text *glint_text_open(int height);
void glint_text_close(glint_text *text); /* NULL is allowed */

/* Draws one line of ASCII from (x, y), its upper left corner, over what is there, and no further
 * than column `end`; what reaches out of the picture is left out. */
void glint_text_draw(glint_text *text, glint_image *image, int x, int y, int end, uint8_t grey,
                     const char *line);

#endif
