/* A Markdown file as one self-contained HTML page, with embedded pictures, for offline use in light
 * or dark browsers. */
#ifndef GLINT_SIM_REPORT_PAGE_H
#define GLINT_SIM_REPORT_PAGE_H

#include "glint_status.h"

/* Makes DIRECTORY/NAME.html of DIRECTORY/NAME.md (CommonMark and tables). The first heading is the
 * page's title; the headings of level 2 become its table of contents, below it. Pictures, .png and
 * .svg, are looked for in the directory. **holds**, **does not hold** and **cannot be decided**,
 * alone in bold, get the colours of their verdict.
 *
 * GLINT_IO_ERROR when the file or one of its pictures cannot be read, GLINT_BAD_INPUT for a picture
 * of another kind. */
glint_status glint_page_make(const char *directory, const char *name, glint_error *err);

#endif
