/* Makes a directory for output. */
#ifndef GLINT_SIM_FILE_DIRECTORY_H
#define GLINT_SIM_FILE_DIRECTORY_H

#include "glint_status.h"

/* Makes path and the directories above it that are missing. One that is there already is fine. */
glint_status glint_directory_make(const char *path, glint_error *err);

#endif
