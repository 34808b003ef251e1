/* Makes a directory for output. */
#ifndef GLINT_SIM_FILE_DIRECTORY_H
#define GLINT_SIM_FILE_DIRECTORY_H

#include "glint_status.h"

/* Creates path and any missing parent directories. It may already exist. */
glint_status glint_directory_make(const char *path, glint_error *err);

#endif
