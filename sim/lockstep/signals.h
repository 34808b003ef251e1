/* The signals and pins of a setting, in the form that comparisons and displays need. */
#ifndef GLINT_SIM_LOCKSTEP_SIGNALS_H
#define GLINT_SIM_LOCKSTEP_SIGNALS_H

#include "circuit/words.h"

/* All of a setting's signals, looked up once: descriptions are functions, and a comparison visits
 * each signal after each clock. Words stand as glint_signal_places() has them. */
typedef struct glint_signals {
    int count, words;
    int place[GLINT_SIGNAL_WORDS_MAX + 1]; /* signal i: from place[i] to before place[i + 1] */
    glint_signal_info info[GLINT_SIGNAL_WORDS_MAX];
    size_t offset[GLINT_SIGNAL_WORDS_MAX]; /* of each word in the C model's struct of signals */
    uint64_t mask[GLINT_SIGNAL_WORDS_MAX]; /* its bits that belong to the signal */
} glint_signals;

/* GLINT_BAD_ARGUMENT when the setting has more than fit. */
glint_status glint_signals_find(const glint_setting *setting, glint_signals *signals,
                                glint_error *err);

/* The words of every signal of the C model, from its struct. */
void glint_signals_read(const glint_signals *signals, const void *from, uint64_t *words);

/* What the circuit's description says about a setting. */
static inline int glint_setting_signal_count(const glint_setting *setting)
{
    return setting->circuit->signal_count(setting->values);
}
static inline glint_signal_info glint_setting_signal(const glint_setting *setting, int index)
{
    return setting->circuit->signal(setting->values, index);
}
static inline int glint_setting_pin_count(const glint_setting *setting)
{
    return setting->circuit->pin_count(setting->values);
}
static inline glint_pin_info glint_setting_pin(const glint_setting *setting, int index)
{
    return setting->circuit->pin(setting->values, index);
}

/* Clocks from one input to the next: 1 if the circuit accepts one every clock. */
static inline int glint_setting_pace(const glint_setting *setting)
{
    return setting->circuit->pace != NULL ? setting->circuit->pace(setting->values) : 1;
}

/* What signal.lane counts: "lane" or "stage". */
static inline const char *glint_setting_lane_name(const glint_setting *setting)
{
    return setting->circuit->lane_name != NULL ? setting->circuit->lane_name : "lane";
}

#endif
