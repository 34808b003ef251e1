/* The interface between callers that have fragments and backends that compute their highlights.
 *
 * A caller (rasterizer, `glint eval`, bench) does not know which circuit is behind it. A backend
 * serves one thread at a time; several can exist at once, each with its own circuit. */
#ifndef GLINT_SIM_BACKEND_BACKEND_H
#define GLINT_SIM_BACKEND_BACKEND_H

#include "lockstep/answer.h"
#include "lockstep/history.h"
#include "rtl/batch.h"

/* The first answer of any watched circuit that differs from the C model's. The caller destroys
 * history. */
typedef struct glint_backend_watch {
    bool found;
    glint_setting setting; /* of that circuit */
    glint_answer answer;
    glint_history *history; /* that circuit's history up to there, or that of one that failed to
                             * answer; NULL: neither, or out of memory */
} glint_backend_watch;

typedef enum glint_backend_kind {
    GLINT_BACKEND_C,    /* the C model: glint_highlight_batch() */
    GLINT_BACKEND_RTL,  /* the Verilog under Verilator */
    GLINT_BACKEND_REAL, /* the device's formula, (2.15) of the specular device, in floating point
                         * on the quantised cosine */
    GLINT_BACKEND_COUNT
} glint_backend_kind;

typedef struct glint_backend_config {
    glint_backend_kind kind;
    const glint_circuit *device; /* a highlight unit (circuit/units.h); NULL: the specular device */
    int variant;                 /* the value of the unit's own parameter, if it has one */
    int w_drop;                  /* places of its W that are rounded off */
    glint_gate gate;             /* of the specular device */
    glint_pipeline pipeline;
    int lanes;           /* kind rtl: 1…GLINT_LANES_MAX; 0: the fastest lane count */
    const char *verilog; /* kind rtl: the Verilog's directory, which must outlive the backend; NULL:
                          * Glint's own */
} glint_backend_config;

typedef struct glint_backend glint_backend;

/* The setting of the circuit that kind rtl has, and the model of kind c. */
glint_setting glint_backend_setting(const glint_backend_config *config);

/* From a setting of a highlight unit; its verilog must outlive the backend. */
glint_backend_config glint_backend_config_of(glint_backend_kind kind, const glint_setting *setting);

/* Creates a backend in reset state. GLINT_BAD_ARGUMENT for a setting out of range;
 * GLINT_DEVICE_FAULT if its Verilog does not build. */
glint_status glint_backend_create(const glint_backend_config *config, glint_backend **backend,
                                  glint_error *err);
void glint_backend_destroy(glint_backend *backend); /* NULL is allowed */

/* From now on compares every answer of kind rtl with the C model's and records the first difference
 * in watch; NULL stops this. Several backends of the same thread may share a watch. */
void glint_backend_set_watch(glint_backend *backend, glint_backend_watch *watch);

/* Shades a run of fragments with one material. cos: U1.18, 0…GLINT_COS_CODE_MAX; w: the device's;
 * r, g, b: the highlight's colour, 8 bits. Backend real rounds W and each colour half up. Any
 * length works; long runs are fast. */
glint_status glint_backend_shade(glint_backend *backend, const glint_material *material,
                                 const glint_points *points, glint_error *err);

/* Clocks that the circuit behind this backend has run so far; 0 for kinds without a clock. */
uint64_t glint_backend_clocks(const glint_backend *backend);

#endif
