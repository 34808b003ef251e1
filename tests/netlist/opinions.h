/* The circuits of a program, as tests/circuits.mk lists them. */
#ifndef GLINT_TESTS_OPINIONS_H
#define GLINT_TESTS_OPINIONS_H

#include <stddef.h>

#include "circuit/setting.h"
#include "rtl/divider_model.h"
#include "rtl/rtl_model.h"

typedef struct opinion {
    const char *name;                   /* BUILD[-FAULT]:CIRCUIT, as in tests/circuit.sh */
    const glint_rtl_model *specular;    /* one of the two … */
    const glint_divider_model *divider; /* … the other is NULL */
} opinion;

extern const opinion opinions[];
extern const int opinion_count;

static inline glint_setting opinion_setting(const opinion *opinion)
{
    glint_setting setting = {.is_divider = opinion->divider != NULL,
                             .specular_model = opinion->specular,
                             .divider_model = opinion->divider};
    if (opinion->specular != NULL)
        setting.specular = opinion->specular->config;
    if (opinion->divider != NULL) {
        setting.form = opinion->divider->form;
        setting.shifts = opinion->divider->shifts;
    }
    return setting;
}

#endif
