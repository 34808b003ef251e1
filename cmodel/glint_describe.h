/* Shorthand for a circuit's description: rows that name a struct member just once, the two
 * functions that glint_circuit.h wants for a table of rows, and the members of the circuit that
 * refer to them.
 *
 *     typedef struct mac_pins {
 *         uint8_t reset;
 *         int32_t a;
 *     } mac_pins;
 *
 *     GLINT_PIN_TABLE(pin,
 *         GLINT_PIN(mac_pins, reset, RESET, 1, 0, 0, "clears the sum"),
 *         GLINT_PIN(mac_pins, a, DATA, values[WIDTH], 0, 1, "a factor"))
 *
 * defines pin(values, index) and pin_count(values) as the description wants them. A width may be
 * any expression of `values`. How many rows there are must not depend on it: a circuit with lanes
 * or stages writes the two functions itself, of the same rows.
 *
 *     const glint_circuit glint_my_circuit = {
 *         .name = "mac",
 *         .title = "Multiply-accumulate",
 *         .clock_port = "clk",
 *         GLINT_PARAMETERS(parameters),
 *         GLINT_PINS(mac_pins, pin),
 *         GLINT_SIGNALS(signal),
 *         GLINT_MODEL(mac, begin, clock_edge),
 *     }; */
#ifndef GLINT_CMODEL_DESCRIBE_H
#define GLINT_CMODEL_DESCRIBE_H

#include "glint_circuit.h"

/* The pin `member` of a struct of pins, of the port of the same name; an array is a wide pin. */
#define GLINT_PIN(type, member, role, int_bits, frac_bits, is_signed, meaning)                     \
    GLINT_PIN_OF(type, member, #member, role, int_bits, frac_bits, is_signed, -1, meaning)

/* The same where the port has another name, or the pin is a lane's part of it. */
#define GLINT_PIN_OF(type, member, port, part, ints, fracs, sign, lane_of, text)                   \
    {                                                                                              \
        .name = port, .role = GLINT_PIN_##part, .int_bits = ints, .frac_bits = fracs,              \
        .is_signed = sign, .lane = lane_of, .offset = offsetof(type, member),                      \
        .size = sizeof(((const type *)0)->member), .meaning = text                                 \
    }

/* The signal `member` of the model's struct, found in the Verilog by the same name; `member` is an
 * int64_t, or an array of uint64_t for more than 64 bits. */
#define GLINT_SIGNAL(type, member, kind, int_bits, frac_bits, is_signed, heading, meaning)         \
    GLINT_SIGNAL_OF(type, member, #member, NULL, kind, int_bits, frac_bits, is_signed, -1,         \
                    heading, meaning)

/* The same where it has another name, is found by a path ("u_sub.acc", "mem[3]"; NULL: by the
 * name), or belongs to a lane. */
#define GLINT_SIGNAL_OF(type, member, called, at, sort, ints, fracs, sign, lane_of, title, text)   \
    {                                                                                              \
        .name = called, .kind = GLINT_SIGNAL_##sort, .int_bits = ints, .frac_bits = fracs,         \
        .is_signed = sign, .lane = lane_of, .meaning = text, .offset = offsetof(type, member),     \
        .size = sizeof(((const type *)0)->member), .path = at, .heading = title                    \
    }

/* A block of the drawing: the signal at its output, its symbol, the text inside, its inputs ("a b")
 * and its controls ("en_a"); the last three may be NULL. */
#define GLINT_BLOCK(called, how, says, feeds, obeys)                                               \
    {                                                                                              \
        .name = called, .symbol = GLINT_SYMBOL_##how, .text = says, .inputs = feeds,               \
        .control = obeys                                                                           \
    }

/* The function name(values) whose answer is the same in every setting: of top, latency, pace. */
#define GLINT_ALWAYS(type, name, answer)                                                           \
    static type name(const int *values)                                                            \
    {                                                                                              \
        (void)values;                                                                              \
        return answer;                                                                             \
    }

#define GLINT_PIN_TABLE(row, ...)    GLINT_TABLE(glint_pin_info, row, __VA_ARGS__)
#define GLINT_SIGNAL_TABLE(row, ...) GLINT_TABLE(glint_signal_info, row, __VA_ARGS__)
#define GLINT_BLOCK_TABLE(row, ...)  GLINT_TABLE(glint_block_info, row, __VA_ARGS__)

#define GLINT_TABLE(type, row, ...)                                                                \
    static type row(const int *values, int index)                                                  \
    {                                                                                              \
        (void)values;                                                                              \
        const type rows[] = {__VA_ARGS__};                                                         \
        return rows[index];                                                                        \
    }                                                                                              \
    static int row##_count(const int *values)                                                      \
    {                                                                                              \
        (void)values;                                                                              \
        const type rows[] = {__VA_ARGS__};                                                         \
        return (int)(sizeof rows / sizeof rows[0]);                                                \
    }

/* The values of a parameter that `verify` tries by default. */
#define GLINT_LISTED(...)                                                                          \
    .listed = (const int[]){__VA_ARGS__},                                                          \
    .listed_count = sizeof(const int[]){__VA_ARGS__} / sizeof(int)

/* What a table is to the circuit: of parameters, of headings; the two functions pin() and
 * pin_count(), and the struct of pins; signal() and signal_count(); block() and block_count(). */
#define GLINT_PARAMETERS(table)                                                                    \
    .parameters = table, .parameter_count = sizeof table / sizeof table[0]
#define GLINT_HEADINGS(table) .headings = table, .heading_count = sizeof table / sizeof table[0]
#define GLINT_PINS(type, row) .pins_size = sizeof(type), .pin = row, .pin_count = row##_count
#define GLINT_SIGNALS(row)    .signal = row, .signal_count = row##_count
#define GLINT_BLOCKS(row)     .block = row, .block_count = row##_count

/* A C model that is one struct, its signals first in it: begin(values, model) makes the reset state
 * of zeros, NULL where they are it. */
#define GLINT_MODEL(type, begun_by, edge)                                                          \
    .model_size = sizeof(type), .begin = begun_by, .clock = edge

#endif
