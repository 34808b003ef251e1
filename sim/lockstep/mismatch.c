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

static void keep(glint_lockstep_result *result, const glint_signal_info *signal, uint64_t model,
                 uint64_t rtl)
{
    if (result->mismatches++ == 0)
        result->first_clock = result->clocks;
    if (result->kept < GLINT_MISMATCHES_KEPT)
        result->mismatch[result->kept++] = (glint_mismatch){result->clocks, *signal, model, rtl};
    add_to_totals(result, signal);
}

void glint_mismatch_compare(glint_lockstep_result *result, const glint_setting *setting,
                            const glint_twin *twin)
{
    uint64_t model[GLINT_SETTING_SIGNALS_MAX], rtl[GLINT_SETTING_SIGNALS_MAX];
    glint_twin_read(twin, model, rtl);
    glint_mismatch_compare_values(result, setting, model, rtl);
}

void glint_mismatch_compare_values(glint_lockstep_result *result, const glint_setting *setting,
                                   const uint64_t *model, const uint64_t *rtl)
{
    const int count = glint_setting_signal_count(setting);
    for (int i = 0; i < count; i++) {
        result->comparisons++;
        if (model[i] != rtl[i]) {
            const glint_signal_info signal = glint_setting_signal(setting, i);
            keep(result, &signal, model[i], rtl[i]);
        }
    }
}

double glint_mismatch_number(const glint_signal_info *signal, uint64_t bits)
{
    const int width = signal->int_bits + signal->frac_bits;
    double value = (double)bits;
    if (signal->is_signed && (bits >> (width - 1) & 1) != 0)
        value -= (double)(UINT64_C(1) << width);
    return value / (double)(UINT64_C(1) << signal->frac_bits);
}

/* A value as a reader wants it: its bits, and the number they stand for. */
static void print_value(FILE *out, const glint_signal_info *signal, uint64_t bits)
{
    const int digits = (signal->int_bits + signal->frac_bits + 3) / 4;
    fprintf(out, "0x%0*" PRIx64 " (%.9g)", digits, bits, glint_mismatch_number(signal, bits));
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
