/* The Verilated specular device behind a plain C interface.
 *
 * One glint_rtl is one instance of rtl/specular_device.v with a context of its own: instances share
 * nothing and may run, and be destroyed, in different threads.
 *
 * The Makefile Verilates every setting (each gate, both pipelines, 1 to 16 lanes) with all named
 * signals kept readable: what lockstep and waveforms need. Keeping them costs about a third of the
 * speed, so the settings that frames are rendered with are Verilated a second time without. */
#ifndef GLINT_SIM_RTL_H
#define GLINT_SIM_RTL_H

#include "glint_specular_device.h"

typedef struct glint_rtl glint_rtl;
typedef struct glint_rtl_model glint_rtl_model; /* a Verilated build: rtl_model.h */

/* Creates a circuit with these settings, reset for one clock. GLINT_BAD_ARGUMENT when they were not
 * built. */
glint_status glint_rtl_create(const glint_specular_config *config, glint_rtl **rtl,
                              glint_error *err);

/* The same circuit for glint_rtl_batch() at full speed: the build without readable signals where
 * there is one for config, else the other. glint_rtl_signal_bits() is not for it. */
glint_status glint_rtl_create_fast(const glint_specular_config *config, glint_rtl **rtl,
                                   glint_error *err);

/* The settings of build `index` (0…), NULL past the last: what glint_rtl_create() can make. */
const glint_specular_config *glint_rtl_built(int index);

/* The same with a Verilated build of the caller's, for tests of the bench with a wrong circuit. */
glint_status glint_rtl_create_from(const glint_rtl_model *model,
                                   const glint_specular_config *config, glint_rtl **rtl,
                                   glint_error *err);

void glint_rtl_destroy(glint_rtl *rtl); /* closes an open trace; NULL is allowed */

/* One rising edge of the clock with these pins. */
void glint_rtl_clock(glint_rtl *rtl, const glint_specular_inputs *inputs);

/* The bits of signal `index` of glint_specular_signal_info(), read from the circuit by its Verilog
 * name, as the last edge left it. */
uint64_t glint_rtl_signal_bits(const glint_rtl *rtl, int index);

/* Rising edges so far, the reset of creation included. */
uint64_t glint_rtl_clocks(const glint_rtl *rtl);

/* Shades a run: writes the material with the first cosines, then feeds `lanes` cosines a clock with
 * no gap and collects the results. Arrays as in glint_specular_batch(). GLINT_DEVICE_FAULT when the
 * circuit does not give every result back within its latency. Points that glint_rtl_clock() left in
 * flight would be taken for results: let them out first. */
glint_status glint_rtl_batch(glint_rtl *rtl, const glint_material *material,
                             const uint32_t *cos_code, size_t count, uint32_t *w_code, uint8_t *r,
                             uint8_t *g, uint8_t *b, glint_error *err);

/* Opens a waveform (FST) that starts with the next clock, at 10 ns a clock: the rising edge of
 * clock k (glint_rtl_clocks() after it) stands at 10·k ns. GLINT_IO_ERROR when path cannot be
 * written. */
glint_status glint_rtl_trace_open(glint_rtl *rtl, const char *path, glint_error *err);

/* Closes it; without an open waveform, nothing happens. */
void glint_rtl_trace_close(glint_rtl *rtl);

/* The length of one clock in a waveform, in its time unit (ns). */
#define GLINT_RTL_TRACE_PERIOD 10

/* For example "Verilator 5.006 2023-01-22". */
const char *glint_rtl_verilator_version(void);

#endif
