/* The interface between callers that divide differences by a length and backends that do it.
 *
 * A backend serves one thread at a time; several can exist at once, each with its own circuit. */
#ifndef GLINT_SIM_BACKEND_DIVIDER_BACKEND_H
#define GLINT_SIM_BACKEND_DIVIDER_BACKEND_H

#include "backend/backend.h"
#include "glint_divider_device.h"

typedef struct glint_divider_config {
    glint_backend_kind kind; /* c: glint_divide_batch(); rtl: the Verilog; real: exact division,
                                rounded half up to the same fraction bits */
    glint_divider_form form; /* kind rtl only; both give the same quotients */
    int shifts;              /* GLINT_DIVIDER_SHIFTS_MIN…MAX */
    const char *verilog; /* kind rtl: the Verilog's directory, which must outlive the backend; NULL:
                          * Glint's own */
} glint_divider_config;

typedef struct glint_divider_backend glint_divider_backend;

glint_status glint_divider_backend_create(const glint_divider_config *config,
                                          glint_divider_backend **backend, glint_error *err);
void glint_divider_backend_destroy(glint_divider_backend *backend); /* NULL is allowed */

/* As glint_backend_set_watch(). */
void glint_divider_backend_set_watch(glint_divider_backend *backend, glint_backend_watch *watch);

/* Divides count times. Quotients are codes with `shifts` fraction bits, S9.n. With every kind, a k
 * of 0 or past the end of the table gives quotient 0 and out_of_table. */
glint_status glint_divider_backend_divide(glint_divider_backend *backend,
                                          const glint_division *divisions, size_t count,
                                          glint_quotients *quotients, glint_error *err);

/* Clocks that the circuit behind this backend has run so far; 0 for kinds without a clock. */
uint64_t glint_divider_backend_clocks(const glint_divider_backend *backend);

#endif
