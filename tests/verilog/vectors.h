/* Vectors for a Verilog test bench, made by the C models: for each clock the pins before its rising
 * edge and the outputs after it, as hexadecimal words for $readmemh. */
#ifndef GLINT_TESTS_VERILOG_VECTORS_H
#define GLINT_TESTS_VERILOG_VECTORS_H

#include <stdint.h>
#include <stdio.h>

#include "glint_divider_device.h"
#include "glint_specular_device.h"

typedef struct vector_files {
    FILE *stimulus, *expected;
} vector_files;

/* Return the number of clocks. Directed cases first, negative ones of every kind among them, then
 * `random` clocks of lockstep's stimulus. */
int vectors_of_specular(const vector_files *files, const glint_specular_config *config, int random,
                        uint64_t seed);
int vectors_of_divider(const vector_files *files, glint_divider_form form, int shifts, int random,
                       uint64_t seed);

#endif
