/* Finds Verilator and the C++ compiler and identifies their versions. */
#ifndef GLINT_SIM_RTL_TOOLS_H
#define GLINT_SIM_RTL_TOOLS_H

#include <stdbool.h>

#include "rtl/command.h"

#define GLINT_TOOL_WORDS_MAX 15

/* A program and what it is always told first: "ccache g++ -m64". The program has its whole path,
 * and so has every word that is the path of one from here: a tool is started elsewhere. */
typedef struct glint_tool {
    char *word[GLINT_TOOL_WORDS_MAX + 1]; /* the last NULL */
} glint_tool;

/* GLINT_IO_ERROR, naming the variable that told it, when there is no such program. */
glint_status glint_tool_find(const char *variable, const char *told, glint_tool *tool,
                             glint_error *err);
void glint_tool_add(const glint_tool *tool, glint_arguments *line);
void glint_tool_free(glint_tool *tool); /* all zeros: nothing happens */

typedef struct glint_tools {
    glint_tool verilator; /* $VERILATOR, else verilator, else Python's verilator-cli, of the PATH */
    glint_tool compiler;  /* $CXX, else c++, else g++, else clang++ */
    char *version;        /* of Verilator: what it calls itself */
    char *root;           /* its VERILATOR_ROOT: its runtime is in include/ */
    char *compiler_version;
} glint_tools;

/* GLINT_IO_ERROR, saying what to install, if one is missing. Versions are queried once and then
 * kept in the cache directory, together with the identity of the files. */
glint_status glint_tools_find(const char *cache, glint_tools *tools, glint_error *err);
bool glint_tools_are_clang(const glint_tools *tools);
void glint_tools_free(glint_tools *tools); /* all zeros: nothing happens */

#endif
