/* The comparison as a tree of JSON, and what is printed of it. */
#ifndef GLINT_SIM_COMPARE_TABLES_H
#define GLINT_SIM_COMPARE_TABLES_H

#include <stdio.h>

#include <jansson.h>

#include "glint_status.h"

/* A list with an object for each setting compared: unit, label, lanes, w_frac_bits, latency, and of
 * what has been measured
 *
 *     "errors": {"power_steps", "own_steps", "nmse", "nmse_n", "points"}    1/255
 *     "size":   {"xilinx": {"lut", "ff", "dsp", "bram"}, …, "cells": {"gates", "mm2", "mhz"}}
 *     "debian": the same by Debian's Yosys
 *     "clock":  {"ecp5": {"mhz": [a rate for each seed]}, …}               [] where it does not fit
 *
 * each with its "tools". manifest: a file of the paths of the results; those that are not there are
 * left out. To be released with json_decref(). */
glint_status glint_compare_tree(const char *manifest, json_t **tree, glint_error *err);

/* The tables of docs/compare.md. */
void glint_compare_write_markdown(FILE *out, const json_t *tree);

/* unit, lanes, w_frac_bits, latency, kind, flow, tools, quantity, value: a line for each number. */
void glint_compare_write_csv(FILE *out, const json_t *tree);

/* For gnuplot, of one lane: error, gates, clock rate (of flow), on a front or not (1, 0) of area
 * and of clock, label. NaN where nothing has been measured. */
void glint_compare_write_points(FILE *out, const json_t *tree, const char *flow);

#endif
