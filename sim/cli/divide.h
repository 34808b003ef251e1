/* Divisions on standard input: `glint divide`, and `glint eval --circuit divider`. */
#ifndef GLINT_SIM_CLI_DIVIDE_H
#define GLINT_SIM_CLI_DIVIDE_H

#include <stdbool.h>

#include "backend/divider_backend.h"

/* Reads standard input to its end; command: whose messages they are. Returns an exit status. */
int glint_divide_lines(const char *command, const glint_divider_config *config, bool json);

/* For --help. */
#define GLINT_DIVIDE_DETAILS                                                                       \
    "A line is: difference k, separated by a blank or a comma. difference is -255 to\n"            \
    "255; k, the length of the span, is 1 to 16, the range of the circuit's table: a k\n"          \
    "that the circuit flags as outside its table ends the run with exit status 2.\n"               \
    "Blank lines and lines starting with # are skipped. The first line may be a\n"                 \
    "header, as in this command's own output: the columns difference and k are matched\n"          \
    "by name, others ignored.\n"                                                                   \
    "\n"                                                                                           \
    "The output columns are difference,k,shifts,quotient_code,quotient,exact,error:\n"             \
    "quotient is quotient_code/2^shifts, exact is difference/k, error is their\n"                  \
    "difference, each with the fewest decimals that read back as the same number."

#endif
