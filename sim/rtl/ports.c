/* Groups pins and output signals into Verilog ports; see ports.h. */
#include "rtl/ports.h"

#include <stdlib.h>
#include <string.h>

#include "circuit/words.h"

/* The port of that name and direction; a new one where there is none. */
static int port_named(glint_ports *ports, const char *name, bool is_output)
{
    for (int i = 0; i < ports->count; i++)
        if (ports->port[i].is_output == is_output && strcmp(ports->port[i].name, name) == 0)
            return i;
    ports->port[ports->count] = (glint_port){name, 0, is_output};
    return ports->count++;
}

/* Lane by lane from the lowest: a pin stands behind those before it, an output where its lane is.
 */
static glint_status place(glint_ports *ports, const char *name, bool is_output, int width, int lane,
                          int *of, int *at, glint_error *err)
{
    if (width < 1 || width > 64 * GLINT_VALUE_WORDS)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "%s has %d bits, not from 1 to %d", name, width,
                          64 * GLINT_VALUE_WORDS);
    *of = port_named(ports, name, is_output);
    glint_port *port = &ports->port[*of];
    *at = lane > 0 ? lane * width : 0;
    if (*at > port->width || (lane <= 0 && port->width > 0))
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "the lanes of port %s are not in sequence from lane 0", name);
    port->width = *at + width;
    return GLINT_OK;
}

static glint_status place_all(const glint_setting *setting, glint_ports *ports, glint_error *err)
{
    const glint_circuit *circuit = setting->circuit;
    glint_status status = GLINT_OK;
    for (int i = 0; status == GLINT_OK && i < ports->pins; i++) {
        const glint_pin_info pin = circuit->pin(setting->values, i);
        status = place(ports, pin.name, false, glint_pin_width(&pin), pin.lane, &ports->of_pin[i],
                       &ports->pin_at[i], err);
        if (status == GLINT_OK && pin.lane > 0 && ports->of_pin[i] != ports->of_pin[i - 1])
            status = glint_fail(err, GLINT_BAD_ARGUMENT, "the lanes of pin %s are not in sequence",
                                pin.name);
    }
    for (int i = 0; status == GLINT_OK && i < ports->signals; i++) {
        const glint_signal_info signal = circuit->signal(setting->values, i);
        ports->of_signal[i] = -1;
        if (glint_signal_is_port(signal.kind))
            status = place(ports, signal.name, true, glint_signal_width(&signal), signal.lane,
                           &ports->of_signal[i], &ports->signal_at[i], err);
    }
    return status;
}

glint_status glint_ports_make(const glint_setting *setting, glint_ports *ports, glint_error *err)
{
    *ports = (glint_ports){.pins = setting->circuit->pin_count(setting->values),
                           .signals = setting->circuit->signal_count(setting->values)};
    const size_t pins = (size_t)ports->pins + 1, signals = (size_t)ports->signals + 1;
    ports->port = calloc(pins + signals, sizeof *ports->port);
    ports->of_pin = calloc(pins, sizeof *ports->of_pin);
    ports->pin_at = calloc(pins, sizeof *ports->pin_at);
    ports->of_signal = calloc(signals, sizeof *ports->of_signal);
    ports->signal_at = calloc(signals, sizeof *ports->signal_at);
    if (ports->port == NULL || ports->of_pin == NULL || ports->pin_at == NULL ||
        ports->of_signal == NULL || ports->signal_at == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a circuit's ports");
    return place_all(setting, ports, err);
}

void glint_ports_free(glint_ports *ports)
{
    free(ports->port);
    free(ports->of_pin);
    free(ports->pin_at);
    free(ports->of_signal);
    free(ports->signal_at);
    *ports = (glint_ports){0};
}
