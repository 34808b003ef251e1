/* What `make compare` compares: the highlight units, out of their descriptions.
 *
 * A highlight unit is any circuit that has the parameters pipeline and lanes and gives W (out_w).
 * Its settings are taken pipelined, with 1 and with 4 lanes, in each of its own variants, with W as
 * wide as the unit makes it and rounded to the common width, GLINT_HIGHLIGHT_COMMON_W_FRAC_BITS; a
 * gate only as it is by default, since it does not change what a highlight is inside. */
#ifndef GLINT_SIM_COMPARE_UNITS_H
#define GLINT_SIM_COMPARE_UNITS_H

#include <stdbool.h>
#include <stdint.h>

#include "circuit/setting.h"

/* Setting 0…; false past the last. */
bool glint_compare_setting(int index, glint_setting *setting);

/* By glint_setting_name(); false if it is none of them. */
bool glint_compare_setting_named(const char *name, glint_setting *setting);

/* "power, accuracy half": the unit and its variant, without what all have in common. */
void glint_compare_label(const glint_setting *setting, char text[GLINT_SETTING_TEXT]);

/* The one n that it is made for; 0: any. */
uint32_t glint_compare_only_n(const glint_setting *setting);

int glint_compare_lanes(const glint_setting *setting);
int glint_compare_w_frac_bits(const glint_setting *setting); /* W is U1.this */

#endif
