/* The return type of every Glint function that can fail, and how the reason is reported.
 *
 * Library code never prints: it returns a glint_status and, where the caller passed a glint_error,
 * fills it with one line: what went wrong, where, and what to do. */
#ifndef GLINT_CMODEL_STATUS_H
#define GLINT_CMODEL_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

typedef enum glint_status {
    GLINT_OK = 0,
    GLINT_BAD_ARGUMENT, /* a value outside the range that the function's header states */
    GLINT_BAD_INPUT,    /* a file or line with unusable content */
    GLINT_IO_ERROR,     /* the operating system refused: missing file, full disk, permissions */
    GLINT_NO_MEMORY,
    GLINT_DEVICE_FAULT, /* a circuit violated its contract */
    GLINT_INTERRUPTED,  /* the caller's stop flag was raised; what was produced so far is discarded
                         */
} glint_status;

typedef struct glint_error {
    char text[512]; /* one line, no newline at its end */
} glint_error;

/* Writes the formatted line into err (which may be NULL) and returns status, so that a failing
 * function can end with `return glint_fail(err, GLINT_IO_ERROR, "%s: %s", path, why);`. */
glint_status glint_fail(glint_error *err, glint_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#ifdef __cplusplus
}
#endif

#endif
