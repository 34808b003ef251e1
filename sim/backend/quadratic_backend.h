/* The interface between quadratic shading and what walks its spans: the C model of the span unit or
 * its Verilog. (Backend real has no spans: quadratic_band.h.)
 *
 * A backend serves one thread at a time; several can exist at once, each with its own circuit. */
#ifndef GLINT_SIM_BACKEND_QUADRATIC_BACKEND_H
#define GLINT_SIM_BACKEND_QUADRATIC_BACKEND_H

#include "backend/backend.h"
#include "glint_quadratic_span.h"
#include "rtl/batch.h"

typedef struct glint_quadratic_config {
    glint_backend_kind kind; /* c or rtl */
    int fraction;            /* GLINT_QUADRATIC_SPAN_FRACTION_MIN…MAX */
    const char *verilog; /* kind rtl: the Verilog's directory, which must outlive the backend; NULL:
                          * Glint's own */
} glint_quadratic_config;

typedef struct glint_quadratic_backend glint_quadratic_backend;

glint_status glint_quadratic_backend_create(const glint_quadratic_config *config,
                                            glint_quadratic_backend **backend, glint_error *err);
void glint_quadratic_backend_destroy(glint_quadratic_backend *backend); /* NULL is allowed */

/* As glint_backend_set_watch(). */
void glint_quadratic_backend_set_watch(glint_quadratic_backend *backend,
                                       glint_backend_watch *watch);

/* Walks the spans: spans->rgb gets the intensities of all their pixels. */
glint_status glint_quadratic_backend_walk(glint_quadratic_backend *backend,
                                          const glint_spans *spans, glint_error *err);

/* Clocks that the circuit behind this backend has run so far; 0 for kind c. */
uint64_t glint_quadratic_backend_clocks(const glint_quadratic_backend *backend);

#endif
