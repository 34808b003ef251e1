/* Looks up a setting's signals and pins once, and lays out their words. */
#include "lockstep/signals.h"

#include <string.h>

static uint64_t low_bits(int count)
{
    return count >= 64 ? UINT64_MAX : (UINT64_C(1) << count) - 1;
}

static void add_words(glint_signals *signals, int index)
{
    const glint_signal_info *info = &signals->info[index];
    const int width = glint_signal_width(info);
    for (int w = 0; w < glint_words_of(width); w++) {
        const int place = signals->place[index] + w;
        signals->offset[place] = info->offset + (size_t)w * sizeof(uint64_t);
        signals->mask[place] = low_bits(width - 64 * w);
    }
}

glint_status glint_signals_find(const glint_setting *setting, glint_signals *signals,
                                glint_error *err)
{
    const int count = glint_setting_signal_count(setting);
    if (count > GLINT_SIGNAL_WORDS_MAX || !glint_signal_places(setting, signals->place))
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "circuit %s: its signals take more than %d 64-bit words",
                          setting->circuit->name, GLINT_SIGNAL_WORDS_MAX);
    signals->count = count;
    signals->words = signals->place[count];
    for (int i = 0; i < count; i++) {
        signals->info[i] = glint_setting_signal(setting, i);
        add_words(signals, i);
    }
    return GLINT_OK;
}

void glint_signals_read(const glint_signals *signals, const void *from, uint64_t *words)
{
    for (int w = 0; w < signals->words; w++) {
        memcpy(&words[w], (const char *)from + signals->offset[w], sizeof words[w]);
        words[w] &= signals->mask[w];
    }
}
