/* The one place where error lines are formatted. */
#include "glint_status.h"

#include <stdarg.h>
#include <stdio.h>

glint_status glint_fail(glint_error *err, glint_status status, const char *format, ...)
{
    if (err != NULL) {
        va_list args;
        va_start(args, format);
        (void)vsnprintf(err->text, sizeof err->text, format, args);
        va_end(args);
    }
    return status;
}
