/* Any Verilated circuit behind a plain C interface.
 *
 * A glint_rtl is one instance with its own context: instances share nothing and may run, and be
 * destroyed, in different threads. The circuit is a shared object that glint_rtl_open() loads,
 * building it first if the cache has none for these sources, parameters, compiler and Verilator
 * (build.h). */
#ifndef GLINT_SIM_RTL_RTL_H
#define GLINT_SIM_RTL_RTL_H

#include <stdbool.h>
#include <stddef.h>

#include "circuit/setting.h"

typedef struct glint_rtl glint_rtl;

typedef enum glint_rtl_kind {
    GLINT_RTL_OBSERVED, /* every signal readable: for lockstep */
    GLINT_RTL_FAST,     /* inputs and outputs only, tuned for this machine: for batches */
    GLINT_RTL_FST,      /* inputs and outputs, and waveforms as FST … */
    GLINT_RTL_VCD,      /* … or as VCD */
} glint_rtl_kind;

/* Loads the circuit, building it if needed, and creates an instance: reset for one clock, enable 1;
 * without a reset its registers are as they begin. GLINT_BAD_ARGUMENT for a setting out of range;
 * GLINT_DEVICE_FAULT, with the tool's own message, if the Verilog does not build or lacks the
 * description's pins and signals. */
glint_status glint_rtl_open(const glint_setting *setting, glint_rtl_kind kind, glint_rtl **rtl,
                            glint_error *err);
void glint_rtl_destroy(glint_rtl *rtl); /* closes an open trace; NULL is allowed */

/* One rising edge of the clock with these pins: the circuit's own struct of them. */
void glint_rtl_clock(glint_rtl *rtl, const void *pins);

/* What those pins make of every signal before the edge, which has yet to come. */
void glint_rtl_settle(glint_rtl *rtl, const void *pins, uint64_t *words);

/* Every signal's words as the last edge left them (those of kind GLINT_SIGNAL_MEALY: found them),
 * in the places of glint_signal_places(). Of a circuit that is not observed those of ports alone;
 * the others' words are left as they are. */
void glint_rtl_read(const glint_rtl *rtl, uint64_t *words);

/* Rising edges so far, the reset of creation included. */
uint64_t glint_rtl_clocks(const glint_rtl *rtl);

/* For fast paths: the memory of a port, NULL when there is none, as Verilator has it: an integer
 * of 1, 2, 4 or 8 bytes, or 32-bit words, the lowest first. And an edge with what is in it. */
void *glint_rtl_port(glint_rtl *rtl, const char *name, size_t *size);
void glint_rtl_edge(glint_rtl *rtl);

/* For fast paths in the circuit's shared object: one of its symbols, NULL when there is none, and
 * the instance that its functions take. */
void *glint_rtl_symbol(const glint_rtl *rtl, const char *name);
void *glint_rtl_instance(glint_rtl *rtl);

/* What it was opened with. */
const glint_setting *glint_rtl_setting(const glint_rtl *rtl);

/* Scratch space for a fast path's notes on its circuit: initially zero, aligned for pointers. */
#define GLINT_RTL_NOTES_SIZE 512
void *glint_rtl_notes(glint_rtl *rtl);

/* Opens a waveform (FST, or VCD by its kind) that starts with the next clock, at 10 ns a clock: the
 * rising edge of clock k (glint_rtl_clocks() after it) stands at 10·k ns. GLINT_IO_ERROR when path
 * cannot be written. Of a fast circuit, and of one of kind GLINT_RTL_VCD. */
glint_status glint_rtl_trace_open(glint_rtl *rtl, const char *path, glint_error *err);
void glint_rtl_trace_close(glint_rtl *rtl); /* without an open waveform, nothing happens */

/* The length of one clock in a waveform, in its time unit (ns). */
#define GLINT_RTL_TRACE_PERIOD 10

#endif
