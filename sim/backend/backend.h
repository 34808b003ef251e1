/* The one interface between whoever has fragments and whatever computes their highlights.
 *
 * A caller (rasterizer, `glint eval`, bench) does not know which circuit is behind it. One backend
 * serves one thread at a time; several may live at once, each with a circuit of its own. */
#ifndef GLINT_SIM_BACKEND_BACKEND_H
#define GLINT_SIM_BACKEND_BACKEND_H

#include "lockstep/answer.h"
#include "lockstep/history.h"
#include "rtl/batch.h"

/* The first answer of any circuit under watch that is not the C model's. Destroy history. */
typedef struct glint_backend_watch {
    bool found;
    glint_setting setting; /* of that circuit */
    glint_answer answer;
    glint_history *history; /* of that circuit up to there, or of one that kept an answer back;
                             * NULL: neither, or no memory */
} glint_backend_watch;

typedef enum glint_backend_kind {
    GLINT_BACKEND_C,    /* glint_specular_batch() */
    GLINT_BACKEND_RTL,  /* the Verilog under Verilator */
    GLINT_BACKEND_REAL, /* formula (2.15) in floating point on the quantised cosine */
    GLINT_BACKEND_COUNT
} glint_backend_kind;

typedef struct glint_backend_config {
    glint_backend_kind kind;
    glint_gate gate;
    glint_pipeline pipeline;
    int lanes;           /* kind rtl: 1…GLINT_LANES_MAX; 0: the fastest lane count */
    const char *verilog; /* kind rtl: the directory with the Verilog, to stay; NULL: Glint's own */
} glint_backend_config;

typedef struct glint_backend glint_backend;

/* The setting of the circuit that kind rtl has. */
glint_setting glint_backend_setting(const glint_backend_config *config);

/* Creates a backend in reset state. GLINT_BAD_ARGUMENT for a setting out of range;
 * GLINT_DEVICE_FAULT when its Verilog does not build. */
glint_status glint_backend_create(const glint_backend_config *config, glint_backend **backend,
                                  glint_error *err);
void glint_backend_destroy(glint_backend *backend); /* NULL is allowed */

/* From now on every answer of kind rtl is held against the C model's, and the first that differs is
 * noted in watch; NULL: no more. One watch may serve several backends, all of one thread. */
void glint_backend_set_watch(glint_backend *backend, glint_backend_watch *watch);

/* Shades a run of fragments with one material. cos: U1.18, 0…GLINT_COS_CODE_MAX; w: U1.18; r, g, b:
 * the highlight's colour, 8 bits. Backend real rounds W and each colour half up. Runs of any length
 * are right; long ones are fast. */
glint_status glint_backend_shade(glint_backend *backend, const glint_material *material,
                                 const glint_points *points, glint_error *err);

/* Clocks that the circuit behind this backend has run so far; 0 for kinds without a clock. */
uint64_t glint_backend_clocks(const glint_backend *backend);

#endif
