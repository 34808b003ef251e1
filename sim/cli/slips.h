/* The option --slips of `glint render`: which of the listing's slips its shading has. */
#ifndef GLINT_SIM_CLI_SLIPS_H
#define GLINT_SIM_CLI_SLIPS_H

#include "render/listing.h"

/* " means factor division …" */
#define GLINT_SLIP_NAME(id, name, what) " " name
#define GLINT_SLIP_NAMES                GLINT_LISTING_SLIPS(GLINT_SLIP_NAME)

/* "all", "none", or names with commas between them, as a mask. Returns GLINT_OPTIONS_RUN, or the
 * exit status for a name that is none. */
int glint_slips_parse(const char *command, const char *text, unsigned *slips);

#endif
