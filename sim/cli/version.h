/* The version of Glint, for `glint --version` and the installed pkg-config file. */
#ifndef GLINT_SIM_CLI_VERSION_H
#define GLINT_SIM_CLI_VERSION_H

#define GLINT_VERSION "0.1.0"

#endif
