/* The listed settings of every circuit, for scripts: a line each,
 *
 *   CIRCUIT NAME TOP SIGNALS [PARAMETER=VALUE …]
 *
 * NAME as glint_setting_name() has it, TOP the Verilog's top, SIGNALS how many there are, PARAMETER
 * the Verilog's name of one that it has. Written to build/settings (tests/settings/rules.mk). */
#include <stdio.h>

#include "circuit/circuits.h"

static void print_setting(const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    char name[GLINT_SETTING_TEXT];
    glint_setting_name(setting, name);
    printf("%s %s %s %d", circuit->name, name, circuit->top(setting->values),
           circuit->signal_count(setting->values));
    for (int i = 0; i < circuit->parameter_count; i++)
        if (circuit->parameters[i].verilog != NULL)
            printf(" %s=%d", circuit->parameters[i].verilog, setting->values[i]);
    putchar('\n');
}

int main(void)
{
    const glint_circuit *circuit;
    for (int c = 0; (circuit = glint_circuit_number(c)) != NULL; c++) {
        glint_setting setting;
        for (int i = 0; glint_setting_listed(circuit, i, &setting); i++)
            print_setting(&setting);
    }
    return fflush(stdout) == 0 && !ferror(stdout) ? 0 : 1;
}
