/* Records mismatches: the first few in full, all of them as counts per signal. */
#include "lockstep/mismatch.h"

#include <inttypes.h>
#include <string.h>

static void add_to_totals(glint_lockstep_result *result, const glint_signal_info *signal)
{
    const int room = (int)(sizeof result->totals / sizeof result->totals[0]);
    int i = 0;
    while (i < result->totals_count && strcmp(result->totals[i].name, signal->name) != 0)
        i++;
    if (i == room)
        return;
    if (i == result->totals_count) {
        result->totals[i].name = signal->name;
        result->totals[i].block = signal->block;
        result->totals_count++;
    }
    result->totals[i].mismatches++;
}

glint_mismatch glint_mismatch_of(uint64_t clock, const glint_signal_info *signal,
                                 const uint64_t *model, const uint64_t *rtl)
{
    glint_mismatch mismatch = {.clock = clock, .signal = *signal};
    const size_t size = (size_t)glint_words_of(glint_signal_width(signal)) * sizeof *model;
    memcpy(mismatch.model, model, size);
    memcpy(mismatch.rtl, rtl, size);
    return mismatch;
}

static void keep(glint_lockstep_result *result, const glint_signal_info *signal,
                 const uint64_t *model, const uint64_t *rtl)
{
    if (result->mismatches++ == 0)
        result->first_clock = result->clocks;
    if (result->kept < GLINT_MISMATCHES_KEPT)
        result->mismatch[result->kept++] = glint_mismatch_of(result->clocks, signal, model, rtl);
    add_to_totals(result, signal);
}

void glint_mismatch_compare(glint_lockstep_result *result, const glint_twin *twin)
{
    uint64_t model[GLINT_SIGNAL_WORDS_MAX], rtl[GLINT_SIGNAL_WORDS_MAX];
    glint_twin_read(twin, model, rtl);
    glint_mismatch_compare_values(result, glint_twin_signals(twin), model, rtl);
}

/* All of them; adds to *compared the pairs of values that it compared. */
static bool same(const glint_signals *signals, const uint64_t *model, const uint64_t *rtl,
                 uint64_t *compared)
{
    *compared += (uint64_t)signals->count;
    return memcmp(model, rtl, (size_t)signals->words * sizeof *model) == 0;
}

void glint_mismatch_compare_values(glint_lockstep_result *result, const glint_signals *signals,
                                   const uint64_t *model, const uint64_t *rtl)
{
    if (same(signals, model, rtl, &result->comparisons))
        return;
    for (int i = 0; i < signals->count; i++) {
        const int at = signals->place[i];
        const size_t size = (size_t)(signals->place[i + 1] - at) * sizeof *model;
        if (memcmp(model + at, rtl + at, size) != 0)
            keep(result, &signals->info[i], model + at, rtl + at);
    }
}

double glint_mismatch_number(const glint_signal_info *signal, const uint64_t *words)
{
    return glint_words_number(words, glint_signal_width(signal), signal->frac_bits,
                              signal->is_signed);
}

void glint_mismatch_bits(const glint_signal_info *signal, const uint64_t *words, char *text)
{
    glint_words_hex(words, glint_signal_width(signal), text);
    const char *digits = text + 2 + strspn(text + 2, "0");
    if (*digits == '\0')
        digits--; /* the last zero */
    memmove(text + 2, digits, strlen(digits) + 1);
}

/* A value for readers: its bits and the number they represent; integers with all digits. */
static void print_value(FILE *out, const glint_signal_info *signal, const uint64_t *words)
{
    const int width = glint_signal_width(signal);
    char text[GLINT_VALUE_TEXT];
    glint_words_hex(words, width, text);
    fprintf(out, "%s (", text);
    if (signal->frac_bits == 0 && width <= 64) {
        glint_words_decimal(words, width, signal->is_signed, text);
        fprintf(out, "%s)", text);
    } else {
        fprintf(out, "%.9g)", glint_mismatch_number(signal, words));
    }
}

void glint_mismatch_print_one(FILE *out, const glint_setting *setting,
                              const glint_mismatch *mismatch)
{
    const glint_signal_info *signal = &mismatch->signal;
    fprintf(out, "  clock %" PRIu64 ": %s", mismatch->clock, signal->name);
    if (signal->lane >= 0)
        fprintf(out, ", %s %d", glint_setting_lane_name(setting), signal->lane);
    if (signal->block != 0)
        fprintf(out, ", block %d", signal->block);
    fprintf(out, ", %s: model ", signal->meaning);
    print_value(out, signal, mismatch->model);
    fprintf(out, ", rtl ");
    print_value(out, signal, mismatch->rtl);
    fprintf(out, "\n");
}

void glint_mismatch_print(FILE *out, const glint_setting *setting,
                          const glint_lockstep_result *result)
{
    for (int i = 0; i < result->kept; i++)
        glint_mismatch_print_one(out, setting, &result->mismatch[i]);
}

void glint_mismatch_print_totals(FILE *out, const glint_lockstep_result *result)
{
    fprintf(out, "totals:\n");
    for (int i = 0; i < result->totals_count; i++) {
        fprintf(out, "  %-12s", result->totals[i].name);
        if (result->totals[i].block != 0)
            fprintf(out, " block %2d", result->totals[i].block);
        fprintf(out, " %" PRIu64 "\n", result->totals[i].mismatches);
    }
}
