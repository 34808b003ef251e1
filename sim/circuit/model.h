/* The C model of a setting, as its circuit describes it. */
#ifndef GLINT_SIM_CIRCUIT_MODEL_H
#define GLINT_SIM_CIRCUIT_MODEL_H

#include "circuit/setting.h"

/* In reset state; to be destroyed. */
glint_status glint_model_create(const glint_setting *setting, void **model, glint_error *err);
void glint_model_destroy(const glint_setting *setting, void *model); /* model may be NULL */

/* One rising edge. */
void glint_model_clock(const glint_setting *setting, void *model, const void *pins);

/* The struct that signal.offset counts in. */
const void *glint_model_signals(const glint_setting *setting, const void *model);

#endif
