/* The device at every cosine code of each exponent. */
#ifndef GLINT_SIM_REPORT_DEVICE_ERRORS_H
#define GLINT_SIM_REPORT_DEVICE_ERRORS_H

#include "report/lobe_errors.h"

typedef struct glint_device_errors {
    uint64_t points;
    uint64_t differing;              /* W of the Verilog from W of the C model */
    glint_lobe_worst model;          /* the C model, from exact cosⁿ */
    glint_lobe_worst verilog;        /* the same of the Verilog under Verilator */
    double model_last, verilog_last; /* the absolute errors at the last exponent */
    glint_worst rounding;            /* of the C model's W, from (2.15) in double precision */
    glint_worst output;              /* of an output of full colour, in 8-bit steps */
    /* Points with an output other than with gate cosine. */
    uint64_t sign_differing, drawn_differing;
} glint_device_errors;

/* Two chapters use it: measured when the first one asks. */
glint_status glint_device_errors_of(glint_report *report, const glint_device_errors **errors,
                                    glint_error *err);

#endif
