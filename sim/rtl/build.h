/* Builds the shared object of a setting unless the cache has it for these sources, parameters,
 * compiler and Verilator.
 *
 * The cache is a directory of files NAME-KIND-SOURCES-TOOLS.so: NAME is the setting's, SOURCES a
 * hash over its Verilog, its probe and the shim, TOOLS one over Verilator, the compiler and the
 * flags. Without Verilator or a compiler, the newest object for these sources is used. */
#ifndef GLINT_SIM_RTL_BUILD_H
#define GLINT_SIM_RTL_BUILD_H

#include <stdbool.h>

#include "rtl/rtl.h"

/* The path of a setting's shared object, built if missing; to be freed. Errors as those of
 * glint_rtl_open(). */
glint_status glint_rtl_build(const glint_setting *setting, glint_rtl_kind kind, char **path,
                             glint_error *err);

/* Whether it would have to be built. */
glint_status glint_rtl_is_built(const glint_setting *setting, glint_rtl_kind kind, bool *built,
                                glint_error *err);

typedef struct glint_rtl_build_control {
    int threads;               /* 0: one for each processor */
    const volatile bool *stop; /* may be NULL: ends with GLINT_INTERRUPTED */
    /* Before each one that is built, number `index` (1…) of `count` missing ones; may be NULL.
     * Calls come one after the other, from any thread. */
    void (*show)(void *context, int index, int count, const glint_setting *setting);
    void *context;
} glint_rtl_build_control;

/* Builds those that are missing, several at a time, the first ones first. One that does not build
 * ends it. */
glint_status glint_rtl_build_all(const glint_setting *settings, int count, glint_rtl_kind kind,
                                 const glint_rtl_build_control *control, glint_error *err);

/* Precompiles Verilator's headers, for callers that build many circuits of a kind
 * (glint_rtl_build_all() does it by itself). */
glint_status glint_rtl_precompile(glint_rtl_kind kind, glint_error *err);

/* What Verilator calls itself: "Verilator 5.006 2023-01-22 rev (Debian 5.006-3)"; to be freed.
 * GLINT_IO_ERROR when there is none. */
glint_status glint_rtl_verilator_version(char **version, glint_error *err);

#endif
