/* The listed settings of every circuit, for scripts: a line each,
 *
 *   CIRCUIT NAME TOP SIGNALS [PARAMETER=VALUE …]
 *
 * NAME as glint_setting_name() has it, TOP the Verilog's top, SIGNALS how many there are, PARAMETER
 * the Verilog's name of one that it has. In a build: build/settings (tests/circuits.mk).
 *
 *   list-settings --ports NAME
 *
 * prints the ports of one of them for tests/mutation/netlist_shim.cpp, each a pin by itself:
 * PORTS_CLOCK, PORTS_IN(X) and PORTS_OUT(X) of X(name, bits), PORTS_RESET and PORTS_RESET_LEVEL. */
#include <stdio.h>

#include "../netlist/pins.h"
#include "circuit/words.h"
#include "find.h"

static void print_setting(const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    char name[GLINT_SETTING_TEXT];
    glint_setting_name(setting, name);
    printf("%s %s %s %d", circuit->name, name, glint_setting_top(setting),
           circuit->signal_count(setting->values));
    for (int i = 0; i < circuit->parameter_count; i++)
        if (circuit->parameters[i].verilog != NULL)
            printf(" %s=%d", circuit->parameters[i].verilog, setting->values[i]);
    putchar('\n');
}

static void print_all(void)
{
    const glint_circuit *circuit;
    for (int c = 0; (circuit = glint_circuit_number(c)) != NULL; c++) {
        glint_setting setting;
        for (int i = 0; glint_setting_listed(circuit, i, &setting); i++)
            print_setting(&setting);
    }
}

static void print_inputs(const glint_setting *setting)
{
    printf("#define PORTS_IN(X)");
    for (int i = 0; i < setting->circuit->pin_count(setting->values); i++) {
        const glint_pin_info pin = setting->circuit->pin(setting->values, i);
        printf(" X(%s, %d)", pin.name, glint_pin_width(&pin));
    }
    putchar('\n');
    for (int i = 0; i < setting->circuit->pin_count(setting->values); i++) {
        const glint_pin_info pin = setting->circuit->pin(setting->values, i);
        if (pin.role == GLINT_PIN_RESET || pin.role == GLINT_PIN_RESET_LOW)
            printf("#define PORTS_RESET %s\n#define PORTS_RESET_LEVEL %d\n", pin.name,
                   pin.role == GLINT_PIN_RESET);
    }
}

static void print_outputs(const glint_setting *setting)
{
    printf("#define PORTS_OUT(X)");
    for (int i = 0; i < setting->circuit->signal_count(setting->values); i++) {
        const glint_signal_info signal = setting->circuit->signal(setting->values, i);
        printf(" X(%s, %d)", signal.name, glint_signal_width(&signal));
    }
    putchar('\n');
}

static bool print_ports(const char *name)
{
    glint_setting setting;
    if (!settings_find(name, &setting)) {
        (void)fprintf(stderr, "list-settings: there is no setting %s\n", name);
        return false;
    }
    printf("/* Written by list-settings --ports %s */\n", name);
    printf("#define PORTS_CLOCK %s\n", setting.circuit->clock_port);
    print_inputs(&setting);
    const glint_setting netlist = pins_setting(&setting);
    print_outputs(&netlist);
    return true;
}

int main(int argc, char **argv)
{
    if (argc == 3 && strcmp(argv[1], "--ports") == 0) {
        if (!print_ports(argv[2]))
            return 2;
    } else if (argc == 1) {
        print_all();
    } else {
        (void)fprintf(stderr, "list-settings: no argument, or --ports NAME\n");
        return 2;
    }
    return fflush(stdout) == 0 && !ferror(stdout) ? 0 : 1;
}
