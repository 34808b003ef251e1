/* The names in failure.json that both its writer and its reader use. */
#ifndef GLINT_SIM_FAILURE_JSON_NAMES_H
#define GLINT_SIM_FAILURE_JSON_NAMES_H

#define GLINT_JSON_FORMAT  "glint failure"
#define GLINT_JSON_VERSION 1

#endif
