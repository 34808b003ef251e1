/* The text generated from an option table: --help, and what a value must be. */
#ifndef GLINT_SIM_CLI_OPTIONS_HELP_H
#define GLINT_SIM_CLI_OPTIONS_HELP_H

#include <stddef.h>

#include "cli/options.h"

/* "an integer from 0 to 1023": what the option's value must be. */
void glint_option_expectation(const glint_option *option, char *text, size_t size);

/* The whole --help text on standard output. */
void glint_options_print_help(const glint_command_line *line);

#endif
