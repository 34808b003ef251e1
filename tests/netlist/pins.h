/* The C model and a circuit of which nothing but the pins is known, side by side: a netlist out of
 * synthesis, or one with a fault in it. The pins are driven as in lockstep (sim/lockstep); after
 * each clock every output pin is compared, bit for bit, whether it is valid or not.
 *
 * The circuit is a Verilated build behind the shim of sim/rtl, without readable signals but for its
 * ports, which Verilator is told to keep: tests/netlist/pins.vlt. */
#ifndef GLINT_TESTS_PINS_H
#define GLINT_TESTS_PINS_H

#include <stdbool.h>

#include "circuit/setting.h"

typedef struct pins_options {
    glint_setting setting; /* with the circuit's build: specular_model or divider_model */
    uint64_t clocks;       /* how many; 0 compares nothing, and is refused */
    uint64_t seed;
    bool stop_at_first; /* the run ends with the clock of the first mismatch */
} pins_options;

typedef struct pins_result {
    uint64_t clocks; /* compared */
    uint64_t
        comparisons; /* pins compared, all clocks together; a bus counts as one, a lane apart */
    uint64_t mismatches;
    uint64_t first_clock; /* of the first mismatch: 1 is the first after the reset of creation … */
    const char *first_pin;
    int first_lane; /* −1: a pin of the whole circuit */
    uint64_t first_model, first_circuit;
} pins_result;

/* Runs it. GLINT_OK whatever it finds. GLINT_DEVICE_FAULT when the circuit has not the pins,
 * GLINT_BAD_ARGUMENT for no clocks or a setting without a build. */
glint_status pins_run(const pins_options *options, pins_result *result, glint_error *err);

#endif
