/* Fragments, clocks and frames per second, all measured in one run so that ratios are meaningful on
 * a shared machine. The candidates take turns, round after round; a rate is the median over the
 * rounds, a ratio the median of the ratios within a round. verilog: the directory of the circuits'
 * Verilog, NULL for Glint's own. */
#ifndef GLINT_SIM_BENCH_BENCH_H
#define GLINT_SIM_BENCH_BENCH_H

#include <stdbool.h>
#include <stdint.h>

#include "backend/backend.h"
#include "bench/formulas.h"
#include "circuit/units.h"
#include "glint_divider.h"

#define GLINT_BENCH_N      60   /* exponent of all kernels */
#define GLINT_BENCH_POINTS 8192 /* cosines per pass, uniformly random in GLINT_BENCH_LOWEST…1 */
#define GLINT_BENCH_LOWEST 0.5  /* below this, powf takes a slow path: the power underflows */

typedef enum glint_bench_candidate {
    GLINT_BENCH_POWF,
    GLINT_BENCH_POW,
    GLINT_BENCH_SCHLICK_SCALAR,
    GLINT_BENCH_SCHLICK,
    GLINT_BENCH_C_BATCH,
    GLINT_BENCH_RTL_1,
    GLINT_BENCH_RTL_2,
    GLINT_BENCH_RTL_4,
    GLINT_BENCH_RTL_8,
    GLINT_BENCH_RTL_16,
    GLINT_BENCH_CANDIDATES
} glint_bench_candidate;

typedef struct glint_bench_rates {
    double points[GLINT_BENCH_CANDIDATES];  /* points per second, on one thread */
    double to_powf[GLINT_BENCH_CANDIDATES]; /* the same divided by powf's */
    int lanes[GLINT_BENCH_CANDIDATES];      /* of the RTL candidates, else 0 */
} glint_bench_rates;

/* Name of a candidate, as in the report and in JSON. */
const char *glint_bench_name(glint_bench_candidate candidate);

/* Measures all candidates for about `seconds` each (0.01…60); the C batch and the circuits are of
 * that highlight unit, whatever its lanes. */
glint_status glint_bench_kernels(const glint_setting *device, double seconds,
                                 const volatile bool *stop, glint_bench_rates *rates,
                                 glint_error *err);

/* Points per second on one thread, and their ratio to Schlick's formula (2.1) in the same kind of
 * loop. */
typedef struct glint_bench_formula_rates {
    double scalar[GLINT_FORMULA_COUNT], vectorised[GLINT_FORMULA_COUNT];
    double scalar_to_schlick[GLINT_FORMULA_COUNT], vectorised_to_schlick[GLINT_FORMULA_COUNT];
} glint_bench_formula_rates;

/* Measures every formula, scalar and vectorised, for about `seconds` each (0.01…60). */
glint_status glint_bench_formulas(double seconds, const volatile bool *stop,
                                  glint_bench_formula_rates *rates, glint_error *err);

#define GLINT_BENCH_SHIFTS    GLINT_DIVIDER_SHIFTS_DEFAULT /* of all divisions */
#define GLINT_BENCH_DIVISIONS 3072 /* of a pass, of one component each; k evenly random in 1…16 */

typedef enum glint_bench_divider {
    GLINT_BENCH_INTEGER_DIVISION,
    GLINT_BENCH_FLOAT_DIVISION_SCALAR,
    GLINT_BENCH_FLOAT_DIVISION,
    GLINT_BENCH_DIVIDER_C_BATCH,
    GLINT_BENCH_DIVIDER_SEQUENTIAL,
    GLINT_BENCH_DIVIDER_PIPELINED,
    GLINT_BENCH_DIVIDERS
} glint_bench_divider;

typedef struct glint_bench_divider_rates {
    double divisions[GLINT_BENCH_DIVIDERS]; /* of one component, a second, on one thread */
    double
        to_integer[GLINT_BENCH_DIVIDERS]; /* the same divided by the machine's integer division's */
    double to_float[GLINT_BENCH_DIVIDERS]; /* by its vectorised float division's */
    double clocks[GLINT_BENCH_DIVIDERS];   /* a second, of the circuits; else 0 */
} glint_bench_divider_rates;

const char *glint_bench_divider_name(glint_bench_divider candidate);

/* Measures all of them for about `seconds` each (0.01…60). */
glint_status glint_bench_dividers(const char *verilog, double seconds, const volatile bool *stop,
                                  glint_bench_divider_rates *rates, glint_error *err);

/* The specular device first. */
#define GLINT_BENCH_UNIT_ONE(name) +1
#define GLINT_BENCH_UNITS          (1 GLINT_UNITS(GLINT_BENCH_UNIT_ONE))

typedef enum glint_bench_unit_way {
    GLINT_BENCH_UNIT_C, /* the C model's batch */
    GLINT_BENCH_UNIT_RTL_1,
    GLINT_BENCH_UNIT_RTL_4,
    GLINT_BENCH_UNIT_WAYS
} glint_bench_unit_way;

typedef struct glint_bench_unit_rates {
    int count; /* of the units measured: of those that are in the Verilog's directory */
    const char *name[GLINT_BENCH_UNITS];
    double points[GLINT_BENCH_UNITS][GLINT_BENCH_UNIT_WAYS];      /* a second, on one thread */
    double to_specular[GLINT_BENCH_UNITS][GLINT_BENCH_UNIT_WAYS]; /* by the device's, same way */
} glint_bench_unit_rates;

/* Whether DIR has the top module of a unit in a file of that name. The device, unit 0, counts as
 * being there: that it is not is an error to be told. */
bool glint_bench_unit_is_in(int unit, const char *verilog);

/* The standard setting of unit 0…GLINT_BENCH_UNITS−1 with so many lanes; 0: the standard. */
glint_setting glint_bench_unit_setting(int unit, int lanes);

/* Measures every highlight unit in every way for about `seconds` each (0.01…60). */
glint_status glint_bench_units(const char *verilog, double seconds, const volatile bool *stop,
                               glint_bench_unit_rates *rates, glint_error *err);

typedef struct glint_bench_frame {
    const char *model; /* "teapot" or "sphere" */
    int width, height;
    int backend;        /* a glint_backend_kind, or GLINT_BENCH_GL */
    uint64_t fragments; /* of one frame */
    double frames;      /* a second */
    char missing[160];  /* of GLINT_BENCH_GL: why it could not be measured, else "" */
} glint_bench_frame;

/* Mesa's OpenGL in software (gl/renderer.h): what a user would take instead. */
#define GLINT_BENCH_GL GLINT_BACKEND_COUNT

#define GLINT_BENCH_BACKENDS (GLINT_BACKEND_COUNT + 1)
#define GLINT_BENCH_FRAMES   (2 * 2 * GLINT_BENCH_BACKENDS) /* of 2 models in 2 sizes */

/* Measures whole frames on `threads` threads, for about `seconds` each; backends but OpenGL have
 * their highlights from that unit. */
glint_status glint_bench_frames(const glint_setting *device, int threads, double seconds,
                                const volatile bool *stop,
                                glint_bench_frame frames[GLINT_BENCH_FRAMES], glint_error *err);

#endif
