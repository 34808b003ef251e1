/* The path of a file in the report's directory. */
#ifndef GLINT_SIM_REPORT_PLACE_H
#define GLINT_SIM_REPORT_PLACE_H

#include "glint_status.h"

typedef struct glint_place {
    char path[4096];
} glint_place;

/* GLINT_BAD_ARGUMENT when the whole does not fit. */
glint_status glint_place_in(const char *directory, const char *name, glint_place *place,
                            glint_error *err);

#endif
