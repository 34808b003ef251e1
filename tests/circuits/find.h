/* A listed setting by its name, as build/settings has it. */
#ifndef GLINT_TESTS_CIRCUITS_FIND_H
#define GLINT_TESTS_CIRCUITS_FIND_H

#include <string.h>

#include "circuit/circuits.h"

static inline bool settings_find(const char *name, glint_setting *setting)
{
    const glint_circuit *circuit;
    char text[GLINT_SETTING_TEXT];
    for (int c = 0; (circuit = glint_circuit_number(c)) != NULL; c++) {
        for (int i = 0; glint_setting_listed(circuit, i, setting); i++) {
            glint_setting_name(setting, text);
            if (strcmp(text, name) == 0)
                return true;
        }
    }
    return false;
}

#endif
