/* The message for an unknown reflectance model. */
#ifndef GLINT_SIM_CLI_MODEL_NAMES_H
#define GLINT_SIM_CLI_MODEL_NAMES_H

/* Reports that the option's value is not a model, with a suggestion and the list of models. Returns
 * the exit status. */
int glint_refuse_model(const char *command, const char *option, const char *name);

#endif
