/* What the choices of tracing are called; a program that traces nothing needs no more. */
#include "trace/join.h"

const char *const glint_fill_names[] = {
    [GLINT_FILL_MEAN] = "mean",         [GLINT_FILL_LINEAR] = "linear",
    [GLINT_FILL_CUBIC] = "cubic",       [GLINT_FILL_NEAREST] = "nearest",
    [GLINT_FILL_BILINEAR] = "bilinear", [GLINT_FILL_BICUBIC] = "bicubic",
    [GLINT_FILL_COUNT] = NULL,
};

const char *const glint_measure_names[] = {
    [GLINT_MEASURE_DELTA_E] = "delta-e",
    [GLINT_MEASURE_LEVELS] = "levels",
    [GLINT_MEASURE_RMS] = "rms",
    [GLINT_MEASURE_COUNT] = NULL,
};
