/* Writes stimulus and expected outputs for $readmemh; see vectors.h. */
#include "vectors.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

#include <cmocka.h>

#include "circuit/divider_stimulus.h"
#include "circuit/stimulus.h"

/* A word of a file: fields one after the other, the first in the highest bits. */
typedef struct word {
    char bits[1024];
    int width;
} word;

static void put(word *word, uint64_t value, int width)
{
    assert_true(word->width + width <= (int)sizeof word->bits);
    for (int bit = width - 1; bit >= 0; bit--)
        word->bits[word->width++] = (char)(value >> bit & 1);
}

static void write_word(FILE *out, const word *word)
{
    int nibble = 0;
    for (int i = 0; i < word->width; i++) {
        nibble = nibble << 1 | word->bits[i];
        if ((word->width - 1 - i) % 4 == 0) {
            fputc("0123456789abcdef"[nibble], out);
            nibble = 0;
        }
    }
    fputc('\n', out);
}

/* ---- The specular device ---- */

typedef struct specular_run {
    const vector_files *files;
    const glint_specular_config *config;
    glint_specular_device *device;
    int clocks;
} specular_run;

static void put_lanes(word *word, const glint_specular_config *config,
                      const glint_specular_signals *s, int width, size_t offset)
{
    for (int lane = config->lanes - 1; lane >= 0; lane--) {
        const char *values = (const char *)&s->lane[lane];
        put(word, (uint64_t) * (const int64_t *)(const void *)(values + offset), width);
    }
}

static void clock_specular(specular_run *run, const glint_specular_inputs *in)
{
    const int lanes = run->config->lanes;
    const glint_specular_signals *s = glint_specular_device_signals(run->device);
    word pins = {.width = 0};
    word outputs = {.width = 0};
    put(&pins, in->reset, 1);
    put(&pins, in->en, 1);
    put(&pins, in->n_we, 1);
    put(&pins, in->n, GLINT_N_BITS);
    put(&pins, in->rgb_we, 1);
    put(&pins, in->r, GLINT_COLOR_BITS);
    put(&pins, in->g, GLINT_COLOR_BITS);
    put(&pins, in->b, GLINT_COLOR_BITS);
    put(&pins, in->in_valid, lanes);
    for (int lane = lanes - 1; lane >= 0; lane--)
        put(&pins, in->cos[lane], GLINT_COS_BITS);
    glint_specular_device_clock(run->device, in);
    put(&outputs, (uint64_t)s->out_valid, lanes);
    put_lanes(&outputs, run->config, s, GLINT_W_BITS, offsetof(glint_specular_lane, out_w));
    put_lanes(&outputs, run->config, s, GLINT_COLOR_BITS, offsetof(glint_specular_lane, out_r));
    put_lanes(&outputs, run->config, s, GLINT_COLOR_BITS, offsetof(glint_specular_lane, out_g));
    put_lanes(&outputs, run->config, s, GLINT_COLOR_BITS, offsetof(glint_specular_lane, out_b));
    write_word(run->files->stimulus, &pins);
    write_word(run->files->expected, &outputs);
    run->clocks++;
}

/* Both ends of the cosine and both sides of the highlight's edge: t from the most negative value
 * there is, −340, over −1 code and 0 to 1. */
static void directed_specular(specular_run *run)
{
    static const uint16_t exponents[] = {0, 1, 2, 3, 7, 60, 255, 511, 512, 1000, 1023};
    for (size_t e = 0; e < sizeof exponents / sizeof exponents[0]; e++) {
        const uint32_t limit = glint_rom9(GLINT_GATE_COSINE, exponents[e]);
        const uint32_t cosines[] = {0,
                                    1,
                                    2,
                                    131071,
                                    131072,
                                    limit - (limit > 1 ? 2 : 0),
                                    limit - (limit > 0 ? 1 : 0),
                                    limit,
                                    limit + 1,
                                    GLINT_COS_ONE - 1,
                                    GLINT_COS_ONE,
                                    GLINT_COS_ONE + 1,
                                    GLINT_COS_CODE_MAX};
        const size_t count = sizeof cosines / sizeof cosines[0];
        for (size_t c = 0; c < count; c++) {
            glint_specular_inputs in = {.en = 1,
                                        .n_we = c == 0,
                                        .n = exponents[e],
                                        .rgb_we = c == 0,
                                        .r = 255,
                                        .g = 128,
                                        .b = 1,
                                        .in_valid = (1u << run->config->lanes) - 1u};
            for (int lane = 0; lane < run->config->lanes; lane++)
                in.cos[lane] = cosines[(c + (size_t)lane) % count];
            clock_specular(run, &in);
        }
    }
}

int vectors_of_specular(const vector_files *files, const glint_specular_config *config, int random,
                        uint64_t seed)
{
    specular_run run = {.files = files, .config = config};
    glint_stimulus stimulus;
    glint_specular_inputs in = {.reset = 1};
    assert_int_equal(glint_specular_device_create(config, &run.device), GLINT_OK);
    clock_specular(&run, &in);
    directed_specular(&run);
    glint_stimulus_init(&stimulus, seed, config->lanes);
    for (int i = 0; i < random; i++) {
        glint_stimulus_next(&stimulus, &in);
        clock_specular(&run, &in);
    }
    glint_specular_device_destroy(run.device);
    return run.clocks;
}

/* ---- The dividers ---- */

typedef struct divider_run {
    const vector_files *files;
    glint_divider_form form;
    int shifts;
    glint_divider_device *device;
    int clocks;
} divider_run;

static void clock_divider(divider_run *run, const glint_divider_inputs *in)
{
    const glint_divider_sequential_signals *s = glint_divider_device_sequential(run->device);
    const glint_divider_pipelined_signals *p = glint_divider_device_pipelined(run->device);
    const int width = GLINT_DIVIDER_DIFFERENCE_BITS + run->shifts;
    word pins = {.width = 0};
    word outputs = {.width = 0};
    put(&pins, in->reset, 1);
    put(&pins, in->en, 1);
    put(&pins, in->start, 1);
    put(&pins, in->k, GLINT_DIVIDER_K_BITS);
    for (int c = 0; c < (s != NULL ? 1 : GLINT_DIVIDER_COMPONENTS); c++)
        put(&pins, (uint64_t)in->difference[c], GLINT_DIVIDER_DIFFERENCE_BITS);
    glint_divider_device_clock(run->device, in);
    if (s != NULL) {
        put(&outputs, (uint64_t)s->busy, 1);
        put(&outputs, (uint64_t)s->done, 1);
        put(&outputs, (uint64_t)s->out_of_table, 1);
        put(&outputs, (uint64_t)s->quotient, width);
    } else {
        put(&outputs, (uint64_t)p->out_valid, 1);
        put(&outputs, (uint64_t)p->out_of_table, 1);
        put(&outputs, (uint64_t)p->quotient_r, width);
        put(&outputs, (uint64_t)p->quotient_g, width);
        put(&outputs, (uint64_t)p->quotient_b, width);
    }
    write_word(run->files->stimulus, &pins);
    write_word(run->files->expected, &outputs);
    run->clocks++;
}

/* A division from its start until its quotient is out, or a clock of the pipeline. */
static void clock_division(divider_run *run, int k, int difference)
{
    glint_divider_inputs in = {.en = 1, .start = 1, .k = (uint8_t)k};
    in.difference[0] = (int16_t)difference;
    in.difference[1] = (int16_t)-difference;
    in.difference[2] = (int16_t)(difference < 0 ? difference + 255 : difference - 255);
    const int clocks =
        run->form == GLINT_DIVIDER_SEQUENTIAL ? glint_divider_latency(run->shifts) : 1;
    for (int i = 0; i < clocks; i++) {
        clock_divider(run, &in);
        in.start = 0;
    }
}

/* Every k of the table, 0 and one beyond: both ends, both sides of 0, powers of two. */
static void directed_divider(divider_run *run)
{
    static const int differences[] = {-255, -254, -129, -128, -127, -3,  -2,  -1,
                                      0,    1,    2,    3,    127,  128, 254, 255};
    for (int k = 0; k <= GLINT_DIVIDER_K_MAX + 1; k++)
        for (size_t d = 0; d < sizeof differences / sizeof differences[0]; d++)
            clock_division(run, k, differences[d]);
}

int vectors_of_divider(const vector_files *files, glint_divider_form form, int shifts, int random,
                       uint64_t seed)
{
    divider_run run = {.files = files, .form = form, .shifts = shifts};
    glint_divider_stimulus stimulus;
    glint_divider_inputs in = {.reset = 1};
    assert_int_equal(glint_divider_device_create(form, shifts, &run.device), GLINT_OK);
    clock_divider(&run, &in);
    directed_divider(&run);
    glint_divider_stimulus_init(&stimulus, seed);
    for (int i = 0; i < random; i++) {
        glint_divider_stimulus_next(&stimulus, &in);
        clock_divider(&run, &in);
    }
    glint_divider_device_destroy(run.device);
    return run.clocks;
}
