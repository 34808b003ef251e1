/* A whole file in memory. */
#ifndef GLINT_SIM_REPORT_FILE_TEXT_H
#define GLINT_SIM_REPORT_FILE_TEXT_H

#include <stddef.h>

#include "glint_status.h"

/* The bytes of the file and a NUL after them, to be freed; *size is without it. */
glint_status glint_file_text(const char *path, char **text, size_t *size, glint_error *err);

#endif
