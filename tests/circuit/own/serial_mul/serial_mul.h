/* The C model of serial_mul.v. */
#ifndef SERIAL_MUL_H
#define SERIAL_MUL_H

#include <stdint.h>

#include "glint_status.h"

typedef struct serial_pins {
    uint8_t arst, en, start;
    uint16_t a, b;
} serial_pins;

typedef struct serial_signals {
    int64_t busy, done, product, addend, bits, left, sum;
} serial_signals;

glint_status serial_create(const int *values, void **model);
void serial_destroy(void *model);
void serial_clock(void *model, const void *pins);
const void *serial_state(const void *model);

#endif
