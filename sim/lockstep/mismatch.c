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

void glint_mismatch_keep(glint_lockstep_result *result, const glint_signal_info *signal,
                         uint64_t model, uint64_t rtl)
{
    if (result->mismatches++ == 0)
        result->first_clock = result->clocks;
    if (result->kept < GLINT_MISMATCHES_KEPT)
        result->mismatch[result->kept++] = (glint_mismatch){result->clocks, *signal, model, rtl};
    add_to_totals(result, signal);
}

/* A value as a reader wants it: its bits, and the number they stand for. */
static void print_value(FILE *out, const glint_signal_info *signal, uint64_t bits)
{
    int width = signal->int_bits + signal->frac_bits;
    double value = (double)bits;
    if (signal->is_signed && (bits >> (width - 1) & 1) != 0)
        value -= (double)(UINT64_C(1) << width);
    value /= (double)(UINT64_C(1) << signal->frac_bits);
    fprintf(out, "0x%0*" PRIx64 " (%.9g)", (width + 3) / 4, bits, value);
}

static void print_mismatch(FILE *out, const glint_mismatch *mismatch, const char *lane_name)
{
    const glint_signal_info *signal = &mismatch->signal;
    fprintf(out, "  clock %" PRIu64 ": %s", mismatch->clock, signal->name);
    if (signal->lane >= 0)
        fprintf(out, ", %s %d", lane_name, signal->lane);
    if (signal->block != 0)
        fprintf(out, ", block %d", signal->block);
    fprintf(out, ", %s: model ", signal->meaning);
    print_value(out, signal, mismatch->model);
    fprintf(out, ", rtl ");
    print_value(out, signal, mismatch->rtl);
    fprintf(out, "\n");
}

void glint_mismatch_print(FILE *out, const glint_lockstep_result *result, const char *lane_name)
{
    for (int i = 0; i < result->kept; i++)
        print_mismatch(out, &result->mismatch[i], lane_name);
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
