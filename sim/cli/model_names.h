/* The reflectance models by name, where one that is none was given. */
#ifndef GLINT_SIM_CLI_MODEL_NAMES_H
#define GLINT_SIM_CLI_MODEL_NAMES_H

/* Says that the option's value is no model, which it may have meant, and which there are. Returns
 * the exit status. */
int glint_refuse_model(const char *command, const char *option, const char *name);

#endif
