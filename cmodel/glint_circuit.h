/* The description of a circuit: its name, parameters, pins and signals, and its C model.
 *
 * Everything else follows from one `glint_circuit`: sim/rtl builds and loads the Verilog from it,
 * and lockstep, exhaustive runs, packets and replay, waveforms and save files, `glint eval`,
 * options, help and JSON are loops over its tables. docs/your-circuit.md develops one from scratch.
 *
 * A *setting* is a circuit with a value for each of its parameters, `values[i]` for parameters[i].
 * Whatever depends on the setting is a function of values.
 *
 * Values. A pin or a signal of at most 64 bits is an integer in memory, of the size and signedness
 * given in its table (for a signal: int64_t); a wider one is an array of uint64_t, lowest word
 * first. Only as many bits as its width count, in two's complement; higher bits are ignored. */
#ifndef GLINT_CMODEL_CIRCUIT_H
#define GLINT_CMODEL_CIRCUIT_H

#include <stddef.h>
#include <stdint.h>

#include "glint_signal.h"
#include "glint_status.h"

#ifdef __cplusplus
extern "C" {
#endif

#define GLINT_PARAMETERS_MAX    8
#define GLINT_STIMULUS_SIZE_MAX 4096

typedef struct glint_parameter {
    const char *name;    /* of its option and in JSON: "lanes" is --lanes */
    const char *verilog; /* the Verilog parameter; NULL: none (the top module depends on it) */
    const char *meaning; /* for --help */
    const char *const *choices; /* names of the values 0…max, with min 0; NULL: a number */
    int min, max;
    int standard;      /* when nothing is said */
    int goes_unsaid;   /* 1: names and descriptions of settings leave the standard value out */
    const int *listed; /* the listed_count values that `verify` tries by default; NULL: min…max */
    int listed_count;
} glint_parameter;

/* What a pin is for. */
typedef enum glint_pin_role {
    GLINT_PIN_RESET,      /* 1 resets, at the clock's edge or at once */
    GLINT_PIN_RESET_LOW,  /* 0 resets */
    GLINT_PIN_ENABLE,     /* 0 freezes everything but reset */
    GLINT_PIN_ENABLE_LOW, /* 1 does */
    GLINT_PIN_VALID,      /* 1 (for several bits: any 1): input is accepted */
    GLINT_PIN_STROBE,     /* a one-bit control, driven at random */
    GLINT_PIN_DATA,       /* numbers, which `eval` reads in this order */
} glint_pin_role;

/* An input pin other than the clock. The Verilog port `name` carries this pin alone (lane −1) or
 * those of all lanes side by side, lane 0 lowest. */
typedef struct glint_pin_info {
    const char *name;
    glint_pin_role role;
    int int_bits, frac_bits, is_signed; /* width: int_bits + frac_bits; int_bits include the sign */
    int lane;
    size_t offset, size; /* size in the pin struct: 1, 2, 4 or 8 bytes; wider pins: 8 per word */
    const char *meaning;
} glint_pin_info;

/* A heading of waveforms. */
typedef struct glint_heading {
    const char *title;
    int folded;     /* of use to few */
    int every_lane; /* of one signal a lane, which stands below its lane's own heading as well */
} glint_heading;

/* What `verify --exhaustive` enumerates: every input of a circuit that has few enough of them.
 * Point p goes in on one clock (and, in a circuit with lanes, through one lane). The C model and
 * the Verilog are clocked with the same pins, and every signal of kind OUTPUT is compared after
 * every clock. */
typedef struct glint_domain {
    const char *what; /* "every k with every difference", for the help and the verdict */
    uint64_t (*points)(const int *values);
    /* Called with all pins 0 except enables, the lowest bit of valid pins and active-low resets,
     * which are 1. */
    void (*put)(const int *values, uint64_t point, void *pins);
} glint_domain;

/* How a block is drawn. */
typedef enum glint_symbol {
    GLINT_SYMBOL_PIN, /* an input; needs a row only to have a text, or a place in the order */
    GLINT_SYMBOL_REGISTER,
    GLINT_SYMBOL_ROM,
    GLINT_SYMBOL_MULTIPLIER,
    GLINT_SYMBOL_ADDER,
    GLINT_SYMBOL_COMPARATOR,
    GLINT_SYMBOL_KEYS,  /* passes a number, or zero */
    GLINT_SYMBOL_LOGIC, /* anything else */
    GLINT_SYMBOL_MORE,  /* further stages like the previous one, left out */
    GLINT_SYMBOL_WIRE,  /* not drawn: its input goes straight through */
    GLINT_SYMBOL_COUNT
} glint_symbol;

/* A block of the drawing (`glint draw`). */
typedef struct glint_block_info {
    /* The signal at its output ("acc[3]": of lane 3; without a lane: of the first), or a pin, or a
     * name made up here if the Verilog has none. */
    const char *name;
    glint_symbol symbol;
    const char *text;    /* shown inside; NULL: the symbol's own */
    const char *inputs;  /* pins and blocks that feed it, top to bottom: "rom33 adder6"; or NULL */
    const char *control; /* those that enable it, written beside it, not wired: "n_we"; or NULL */
    int stacked;         /* stands for several alike */
} glint_block_info;

typedef struct glint_circuit {
    const char *name;       /* used in --circuit, file names and JSON: a C identifier */
    const char *title;      /* for people: "Specular-colour device" */
    const char *clock_port; /* the clock's port, rising edge; NULL: a circuit without one */
    /* Of one built in: 1: taken only if it is named, if all are, or if it alone has an option that
     * is given. */
    int on_request;
    /* The top module, in the Verilog file of the same name; NULL: `name`. */
    const char *(*top)(const int *values);

    const glint_parameter *parameters;
    int parameter_count; /* 0…GLINT_PARAMETERS_MAX */
    /* A human-readable setting: "divider sequential, 12 shifts". NULL: "name, width 16, depth
     * 4". */
    void (*describe)(const int *values, char *text, size_t size);

    /* Pins 0…count−1. The lanes of a port must be consecutive. */
    int (*pin_count)(const int *values);
    glint_pin_info (*pin)(const int *values, int index);
    size_t pins_size; /* of the struct that they lie in; 0 is every pin's rest but reset-low's */

    /* Signals 0…count−1, which are compared after every clock. One of kind GLINT_SIGNAL_OUTPUT or
     * GLINT_SIGNAL_MEALY is the output port of that name, or a lane's part of it; any other is
     * found below the top module by its path (signal.path, or else its name), prefixed with its
     * lane's scope. clock() leaves in a MEALY signal what the old state and the clock's pins make.
     */
    int (*signal_count)(const int *values);
    glint_signal_info (*signal)(const int *values, int index);
    const char *lane_name;  /* "lane", "stage": what signal.lane counts; NULL: none does */
    const char *lane_scope; /* "lane[%d].u": %d is signal.lane */

    /* In waveform order; signal.heading is one of these. NULL: the signals' headings in order of
     * appearance. */
    const glint_heading *headings;
    int heading_count;

    /* Clocks from the edge that accepts an input to the one after which its result is out, both
     * counted; 0: outputs follow the pins with no register in between. NULL: 1, without a clock
     * 0. */
    int (*latency)(const int *values);
    /* Clocks from an edge that accepts an input to the next edge that can; NULL: 1, every edge. */
    int (*pace)(const int *values);

    /* The C model. Either its size, and what makes the reset state of so many zeros (NULL: they are
     * it); or functions that allocate and free it. */
    size_t model_size;
    void (*begin)(const int *values, void *model);
    glint_status (*create)(const int *values, void **model);
    void (*destroy)(void *model);
    /* One rising edge with these pins, after which signals() is what the Verilog's have with these
     * pins still there: the struct that signal.offset counts in. NULL, but not with create(): the
     * model begins with it. */
    void (*clock)(void *model, const void *pins);
    const void *(*signals)(const void *model);

    /* The circuit's own random pins, from a state of stimulus_size bytes, at most
     * GLINT_STIMULUS_SIZE_MAX, that begins with zeros, as the pins of each clock do; NULL: every
     * pin by its role, with data anywhere and at the ends of its range. The same seed gives the
     * same pins. */
    size_t stimulus_size;
    void (*stimulus_begin)(void *stimulus, const int *values, uint64_t seed);
    void (*stimulus_next)(void *stimulus, void *pins);

    const glint_domain *domain; /* NULL: `verify --exhaustive` reports that there is none */

    /* Blocks 0…count−1 of the drawing, in the order in which data flows: an input from a later row
     * is feedback. Outputs, and pins that feed a block, need no rows. NULL: nothing to draw. */
    int (*block_count)(const int *values);
    glint_block_info (*block)(const int *values, int index);
} glint_circuit;

/* What a user's directory must define (glint --circuit-dir): one circuit. */
extern const glint_circuit glint_my_circuit;

#ifdef __cplusplus
}
#endif

#endif
