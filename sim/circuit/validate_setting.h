/* The part of validate.h that depends on the setting. */
#ifndef GLINT_SIM_VALIDATE_SETTING_H
#define GLINT_SIM_VALIDATE_SETTING_H

#include "circuit/setting.h"

/* Of C, and so of Verilog; NULL is none. */
bool glint_is_identifier(const char *name);

/* Pins, signals, latency and C model of one setting of a circuit whose names, functions and
 * headings are in order. */
glint_status glint_setting_describes(const glint_setting *setting, glint_error *err);

#endif
