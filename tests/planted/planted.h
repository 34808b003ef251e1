/* Differences planted between a circuit and its comparison: values are altered as they are read, so
 * it is known to the last bit what the comparison must find.
 *
 * The programs of this directory are linked with ld's --wrap, so that the reading functions of
 * rtl/rtl.h and rtl/batch.h are replaced by those in planted.c, which call the real ones.
 *
 * build/planted/glint is the command linked this way. The environment says what to plant:
 * GLINT_PLANTED_SIGNAL and GLINT_PLANTED_CLOCK: the lowest bit of this signal after this clock, in
 * every circuit; GLINT_PLANTED_ANSWER and GLINT_PLANTED_VALUE: as below. */
#ifndef GLINT_TESTS_PLANTED_PLANTED_H
#define GLINT_TESTS_PLANTED_PLANTED_H

#include <stdbool.h>
#include <stdint.h>

#include "circuit/circuits.h"
#include "lockstep/answer.h"

enum { PLANTED_NOWHERE = -1, PLANTED_EVERYWHERE = -2 };

typedef struct planted {
    /* Clock by clock: the signal whose bits are altered, or PLANTED_…, and the bits that are
     * inverted after a clock; clock 1 is the first after the reset of creation. */
    int signal;
    uint64_t (*inverted)(uint64_t clock);

    /* By runs: which of the points or divisions asked for, counted from 0 over all runs; or
     * PLANTED_NOWHERE; and which of its values, whose lowest bit is inverted. */
    long answer;
    glint_answer_value value;
    long asked; /* points or divisions so far */
} planted;

extern planted plant; /* nothing to begin with; a program of one thread */

/* Every listed setting that `glint verify` tries when no circuit is named, and where
 * `with_requested` is given the standard setting of each other circuit; and how many the thesis's
 * circuits have, so that none of them gets lost. */
#define PLANTED_SETTINGS_MAX 512
enum { THESIS_SETTINGS = 52, THESIS_SIGNALS = 5222 };

/* Their number; −1: more than fit. */
static inline int planted_settings(bool with_requested,
                                   glint_setting settings[PLANTED_SETTINGS_MAX])
{
    const glint_circuit *circuit;
    int count = 0;
    for (int c = 0; (circuit = glint_circuit_number(c)) != NULL; c++) {
        glint_setting setting = glint_setting_standard(circuit);
        if (circuit->on_request && with_requested && count < PLANTED_SETTINGS_MAX)
            settings[count++] = setting;
        for (int i = 0; !circuit->on_request && glint_setting_listed(circuit, i, &setting); i++) {
            if (count == PLANTED_SETTINGS_MAX)
                return -1;
            settings[count++] = setting;
        }
    }
    return count;
}

static inline bool planted_in_thesis(const glint_setting *setting)
{
    return setting->circuit == &glint_circuit_specular ||
           setting->circuit == &glint_circuit_divider;
}

#endif
