/* One run of intensities: cut, set up, walked. */
#include "render/span.h"

#include <string.h>

#define CHANNELS GLINT_DIVIDER_COMPONENTS

int32_t glint_run_segment_count(const glint_run *run)
{
    const int32_t k = run->end - run->start;
    return k > 0 ? (k + GLINT_DIVIDER_K_MAX - 1) / GLINT_DIVIDER_K_MAX : 1;
}

int32_t glint_run_segment_at(const glint_run *run, int32_t place)
{
    const int32_t at = (place - run->start) / GLINT_DIVIDER_K_MAX;
    const int32_t last = glint_run_segment_count(run) - 1;
    return at < last ? at : last;
}

void glint_run_exact(const glint_run *run, int32_t first, int32_t last, uint8_t *values)
{
    const int32_t k = run->end - run->start;
    if (k == 0) {
        memcpy(values, run->from, CHANNELS);
        return;
    }
    for (int32_t place = first; place <= last; place++) {
        const int32_t i = place - run->start;
        for (int c = 0; c < CHANNELS; c++) {
            const int32_t numerator = run->from[c] * (k - i) + run->to[c] * i; /* of value·k */
            *values++ = (uint8_t)((2 * numerator + k) / (2 * k));
        }
    }
}

glint_run glint_run_segment(const glint_run *run, int32_t index)
{
    if (run->end - run->start <= GLINT_DIVIDER_K_MAX)
        return *run;
    glint_run segment = {.start = run->start + index * GLINT_DIVIDER_K_MAX, .end = run->end};
    if (segment.end - segment.start > GLINT_DIVIDER_K_MAX)
        segment.end = segment.start + GLINT_DIVIDER_K_MAX;
    glint_run_exact(run, segment.start, segment.start, segment.from);
    glint_run_exact(run, segment.end, segment.end, segment.to);
    return segment;
}

/* One channel's part: returns its k. */
static int32_t set_channel_up(const glint_run *segment, int c, int16_t *difference,
                              glint_operations *operations)
{
    *difference = (int16_t)(segment->to[c] - segment->from[c]);
    operations->additions++;
    const int32_t k = segment->end - segment->start;
    operations->additions++;
    if (k > 0)
        operations->divisions++;
    return k;
}

bool glint_run_set_up(const glint_run *segment, glint_division *division,
                      glint_operations *operations)
{
    int32_t k = 0;
    for (int c = 0; c < CHANNELS; c++)
        k = set_channel_up(segment, c, &division->difference[c], operations);
    division->k = (uint8_t)k;
    return k > 0;
}

/* A sum with that many fraction bits as an intensity. */
static uint8_t intensity(int32_t sum, int shifts)
{
    const int32_t rounded = (sum + (1 << (shifts - 1))) >> shifts;
    const int32_t above = rounded > 0 ? rounded : 0;
    return (uint8_t)(above < 255 ? above : 255);
}

void glint_run_walk(const glint_run *segment, int shifts, const glint_quotients *quotients,
                    int32_t first, int32_t last, uint8_t *values, glint_operations *operations)
{
    int32_t sum[CHANNELS];
    uint64_t additions = 0;
    for (int c = 0; c < CHANNELS; c++)
        sum[c] = segment->from[c] << shifts;
    for (int32_t place = segment->start;; place++) {
        if (place >= first)
            for (int c = 0; c < CHANNELS; c++)
                *values++ = intensity(sum[c], shifts);
        if (place >= last)
            break;
        for (int c = 0; c < CHANNELS; c++) {
            sum[c] += quotients->code[c];
            additions++;
        }
    }
    operations->additions += additions;
}
