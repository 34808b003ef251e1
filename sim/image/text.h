/* Lines of text on pictures, through FreeType. */
#ifndef GLINT_SIM_IMAGE_TEXT_H
#define GLINT_SIM_IMAGE_TEXT_H

#include "image/image.h"

typedef struct glint_text glint_text;

/* Letters of that height of line, in pixels (6…200). NULL when the font is not there (Debian:
 * fonts-dejavu-core) or there is no memory: who labels a picture does without then. */
glint_text *glint_text_open(int height);
void glint_text_close(glint_text *text); /* NULL is allowed */

/* Draws one line of ASCII from (x, y), its upper left corner, over what is there, and no further
 * than column `end`; what reaches out of the picture is left out. */
void glint_text_draw(glint_text *text, glint_image *image, int x, int y, int end, uint8_t grey,
                     const char *line);

#endif
