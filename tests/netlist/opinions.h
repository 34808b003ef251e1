/* The circuits that test_opinions.c holds against the C model; the list is written by rules.mk. */
#ifndef GLINT_TESTS_OPINIONS_H
#define GLINT_TESTS_OPINIONS_H

#include <stddef.h>

#include "rtl/divider_model.h"
#include "rtl/rtl_model.h"

typedef struct opinion {
    const char *name;                   /* BUILD[-FAULT]:CIRCUIT, as in tests/circuit.sh */
    const glint_rtl_model *specular;    /* one of the two … */
    const glint_divider_model *divider; /* … the other is NULL */
} opinion;

extern const opinion opinions[];
extern const int opinion_count;

#endif
