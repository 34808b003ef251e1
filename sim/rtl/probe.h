/* The Verilog wrapper through which a setting is observed: `glint_probe` instantiates the top
 * module as `dut` and has a port for each of its ports and for each signal below it. Verilator's
 * ports are then all that is needed, and Verilator itself checks that the description's pins and
 * signals exist with the right widths: a message about a line of the probe concerns one of them. */
#ifndef GLINT_SIM_RTL_PROBE_H
#define GLINT_SIM_RTL_PROBE_H

#include "rtl/ports.h"

#define GLINT_PROBE_MODULE "glint_probe"
#define GLINT_PROBE_FILE   GLINT_PROBE_MODULE ".v"
#define GLINT_PROBE_CLOCK  "glint_clock"

/* What a line of the probe is about. */
typedef enum glint_probe_part {
    GLINT_PROBE_OTHER,
    GLINT_PROBE_TOP,       /* the instance */
    GLINT_PROBE_PARAMETER, /* index: of the circuit */
    GLINT_PROBE_CLOCK_PIN,
    GLINT_PROBE_PORT,   /* index: of glint_ports */
    GLINT_PROBE_SIGNAL, /* index: of the circuit */
} glint_probe_part;

typedef struct glint_probe_line {
    glint_probe_part part;
    int index;
} glint_probe_line;

typedef struct glint_probe {
    char *text;
    size_t size;
    glint_probe_line *line; /* of line number i + 1 */
    int lines;
} glint_probe;

/* Of the ports: glint_p<index>; of a signal that is no output: glint_s<index>. */
glint_status glint_probe_make(const glint_setting *setting, const glint_ports *ports,
                              glint_probe *probe, glint_error *err);
void glint_probe_free(glint_probe *probe);

/* Where a signal that is no output is looked for, from the top module on: "lane[3].u.acc". */
#define GLINT_PROBE_PATH 512
void glint_probe_path(const glint_setting *setting, const glint_signal_info *signal,
                      char path[GLINT_PROBE_PATH]);

#endif
