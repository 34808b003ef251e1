/* Verilator and the C++ compiler: where they are, and which ones. */
#ifndef GLINT_SIM_RTL_TOOLS_H
#define GLINT_SIM_RTL_TOOLS_H

#include <stdbool.h>

#include "glint_status.h"

#define GLINT_TOOL_WORDS_MAX 8

typedef struct glint_tools {
    char *verilator; /* $VERILATOR, else verilator, else Python's verilator-cli, of the PATH */
    /* $CXX, else c++, else g++, else clang++: its words ("ccache g++"), the last NULL. */
    const char *compiler[GLINT_TOOL_WORDS_MAX + 1];
    char *version; /* of Verilator: what it calls itself */
    char *root;    /* its VERILATOR_ROOT: its runtime is in include/ */
    char *compiler_version;
    char *compiler_text; /* what compiler[] points into */
} glint_tools;

/* GLINT_IO_ERROR, saying what to install, when one is missing. The versions are asked once and then
 * kept in the cache directory, beside which files they are of. */
glint_status glint_tools_find(const char *cache, glint_tools *tools, glint_error *err);
bool glint_tools_are_clang(const glint_tools *tools);
void glint_tools_free(glint_tools *tools); /* all zeros: nothing happens */

#endif
