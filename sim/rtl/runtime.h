/* Verilator's runtime, which every circuit is linked with, and its precompiled headers: built once
 * per Verilator and compiler and kept in the cache. */
#ifndef GLINT_SIM_RTL_RUNTIME_H
#define GLINT_SIM_RTL_RUNTIME_H

#include "rtl/rtl.h"
#include "rtl/sources.h"
#include "rtl/tools.h"

#define GLINT_RUNTIME_FILES_MAX 16

/* Begins a command line of the compiler: with the flags that a kind's circuit and its precompiled
 * headers must share. */
void glint_compilation_begin(glint_arguments *line, const glint_tools *tools, glint_rtl_kind kind);

/* "observed", "fast", "vcd": of the names of files. */
const char *glint_rtl_kind_name(glint_rtl_kind kind);

/* A hash over those flags and the tools. */
glint_status glint_compilation_hash(const glint_tools *tools, glint_rtl_kind kind,
                                    char hash[GLINT_HASH_TEXT], glint_error *err);

typedef struct glint_runtime_file {
    char *path, *temporary; /* temporary: it is being made */
    char *source;
    glint_command command;
} glint_runtime_file;

typedef struct glint_runtime {
    const glint_tools *tools;
    glint_rtl_kind kind;
    char *directory, *include, *standard_include;
    char *header; /* to be included first, of this kind: it may be there precompiled */
    glint_runtime_file file[GLINT_RUNTIME_FILES_MAX]; /* objects to link with */
    int count;
    char *lock_path;
    int lock;
} glint_runtime;

/* Starts building whatever every circuit of this kind needs and the cache lacks. Must be ended
 * regardless of the result. */
glint_status glint_runtime_begin(glint_runtime *runtime, const char *cache,
                                 const glint_tools *tools, glint_rtl_kind kind, glint_error *err);

/* The same for one file of Verilator's runtime: "verilated_threads". */
glint_status glint_runtime_add(glint_runtime *runtime, const char *name, glint_error *err);

/* Waits until everything is there. GLINT_DEVICE_FAULT, with the compiler's words, when one is not.
 */
glint_status glint_runtime_wait(glint_runtime *runtime, glint_error *err);

void glint_runtime_end(glint_runtime *runtime);

/* Precompiles Verilator's headers for circuits of this kind: costs as much as four circuits and
 * then halves the time of each. */
glint_status glint_runtime_precompile(const char *cache, const glint_tools *tools,
                                      glint_rtl_kind kind, glint_error *err);

#endif
