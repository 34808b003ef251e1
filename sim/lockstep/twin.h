/* A C model and its Verilog side by side, of either circuit: clocked with the same pins, read
 * signal by signal. */
#ifndef GLINT_SIM_TWIN_H
#define GLINT_SIM_TWIN_H

#include "circuit/setting.h"

typedef struct glint_twin glint_twin;

/* Both in reset state. GLINT_BAD_ARGUMENT for a setting that does not exist or was not built. */
glint_status glint_twin_create(const glint_setting *setting, glint_twin **twin, glint_error *err);

/* The C model alone: rtl of glint_twin_read() is then not to be asked for. */
glint_status glint_twin_create_model(const glint_setting *setting, glint_twin **twin,
                                     glint_error *err);

void glint_twin_destroy(glint_twin *twin); /* NULL is allowed */

/* One rising edge. */
void glint_twin_clock(glint_twin *twin, const glint_pins *pins);

/* The bits of every signal as the last edge left them; rtl may be NULL. */
void glint_twin_read(const glint_twin *twin, uint64_t model[GLINT_SETTING_SIGNALS_MAX],
                     uint64_t rtl[GLINT_SETTING_SIGNALS_MAX]);

#endif
