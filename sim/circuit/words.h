/* Values of any width, for pins and signals: words, lowest first. */
#ifndef GLINT_SIM_CIRCUIT_WORDS_H
#define GLINT_SIM_CIRCUIT_WORDS_H

#include "circuit/setting.h"

#define GLINT_VALUE_WORDS 64 /* the widest pin or signal: 4096 bits */

static inline int glint_words_of(int width)
{
    return (width + 63) / 64;
}
static inline int glint_signal_width(const glint_signal_info *signal)
{
    return signal->int_bits + signal->frac_bits;
}
static inline int glint_pin_width(const glint_pin_info *pin)
{
    return pin->int_bits + pin->frac_bits;
}

/* Gets a pin's bits, as many as its width, the rest 0; and sets them, sign-extending a narrow
 * signed pin to its size. */
void glint_pin_get(const glint_pin_info *pin, const glint_pins *pins, uint64_t *words);
void glint_pin_set(const glint_pin_info *pin, glint_pins *pins, const uint64_t *words);

/* Text and number of a value: "0x0ff" with all digits of its width; a decimal (with sign) of any
 * width; as a real number. text has room for 4096/3 + 3 characters. */
#define GLINT_VALUE_TEXT 1400
void glint_words_hex(const uint64_t *words, int width, char *text);
void glint_words_decimal(const uint64_t *words, int width, bool is_signed, char *text);
double glint_words_number(const uint64_t *words, int width, int frac_bits, bool is_signed);

/* A decimal or 0x… of at most that width, the sign where is_signed; false if it is not one or does
 * not fit. */
bool glint_words_parse(const char *text, int width, bool is_signed, uint64_t *words);

/* Where signal i's words begin among all of the setting's, by index; place[count] is their number.
 * false: more than GLINT_SIGNAL_WORDS_MAX. */
bool glint_signal_places(const glint_setting *setting, int *place);

#endif
