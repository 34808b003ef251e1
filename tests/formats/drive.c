/* One choice of the formats, tried: built by tests/formats/try.sh with the edit made.
 *
 *     drive SETTING...     of the specular device: cosine-pipelined-4
 *
 * glint_specular_batch() against the blocks one after the other, every value that it gives, for
 * each gate: every code of the cosine for a few n, and random points. W of the blocks against the
 * real-valued formula. Then the C model against the Verilog, clock by clock. Says the counts in a
 * line each; exit status 1 when something differs. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/circuits.h"
#include "circuit/random.h"
#include "glint.h"
#include "lockstep/lockstep.h"

enum {
    RUN = 4096,
    RANDOM_RUNS = 200,
    SHORTEST = 7, /* no whole step of a vectorised loop, so that its tail is tried as well */
    CLOCKS = 20000
};

/* Dense: those whose highlights are widest, and some that are narrow; sigma exact and not. */
static const uint16_t dense_n[] = {0, 1, 2, 3, 80, 256, 511, 683, 1000, GLINT_N_MAX};

typedef struct tally {
    uint64_t points, differences; /* the batch form, and points at which it is not the blocks' */
    uint64_t weighed, too_far;    /* W, and those further from the formula than roundings go */
    double worst;                 /* distance, of what roundings allow */
} tally;

typedef struct run {
    glint_material material;
    size_t count;
    uint32_t cos_code[RUN], w[RUN];
    uint8_t r[RUN], g[RUN], b[RUN];
} run;

static void draw_colors(run *run, glint_random *random)
{
    const uint64_t bits = glint_random_bits(random);
    run->material.r = (uint8_t)bits;
    run->material.g = (uint8_t)(bits >> 8);
    run->material.b = (uint8_t)(bits >> 16);
}

/* How far roundings alone may take W from the formula of an unrounded sigma, where t is in 0...1:
 * 2 t of what sigma and t are off, the square of that, and half a code of W (docs/formats.md). */
static double allowed(void)
{
    const double sigma = 1.0 / (3 << GLINT_SIGMA_FRAC_BITS), code = 0.5 / GLINT_W_ONE;
    return 4.0 / 3.0 * sigma + 2.0 * code + (sigma + code) * (sigma + code) + code;
}

/* Gate drawn steps where its limit is, so that W cannot be near the formula there. */
static void weigh(glint_gate gate, uint32_t n, uint32_t cos_code, uint32_t w, tally *tally)
{
    if (gate == GLINT_GATE_DRAWN)
        return;
    const double off = fabs((double)w / GLINT_W_ONE - glint_specular_real(gate, n, cos_code));
    tally->weighed++;
    tally->too_far += off > allowed();
    tally->worst = fmax(tally->worst, off / allowed());
}

static void compare_point(glint_gate gate, const run *run, size_t i, tally *tally)
{
    glint_specular_values v;
    if (glint_specular_eval(gate, &run->material, run->cos_code[i], &v) != GLINT_OK)
        exit(2);
    tally->points++;
    tally->differences += run->w[i] != v.keys12 || run->r[i] != v.mul13 || run->g[i] != v.mul14 ||
                          run->b[i] != v.mul15;
    weigh(gate, run->material.n, run->cos_code[i], v.keys12, tally);
}

/* Each gate, of the codes that the run holds. */
static void compare_run(run *run, tally *tally)
{
    for (glint_gate gate = 0; gate < GLINT_GATE_COUNT; gate++) {
        if (glint_specular_batch(gate, &run->material, run->cos_code, run->count, run->w, run->r,
                                 run->g, run->b) != GLINT_OK)
            exit(2);
        for (size_t i = 0; i < run->count; i++)
            compare_point(gate, run, i, tally);
    }
}

static void compare_every_code(run *run, glint_random *random, tally *tally)
{
    for (size_t i = 0; i < sizeof dense_n / sizeof dense_n[0]; i++)
        for (uint32_t code = 0; code <= GLINT_COS_CODE_MAX;) {
            run->material.n = dense_n[i] & GLINT_N_MAX;
            draw_colors(run, random);
            for (run->count = 0; run->count < RUN && code <= GLINT_COS_CODE_MAX; code++)
                run->cos_code[run->count++] = code;
            compare_run(run, tally);
        }
}

/* Half of the codes anywhere, half about the edge of the highlight and inside. */
static void compare_random(run *run, glint_random *random, tally *tally)
{
    for (int i = 0; i < RANDOM_RUNS; i++) {
        run->material.n = (uint16_t)glint_random_below(random, GLINT_N_COUNT);
        run->count = SHORTEST + glint_random_below(random, RUN - SHORTEST);
        draw_colors(run, random);
        const uint32_t limit = glint_rom9(GLINT_GATE_COSINE, run->material.n);
        const uint32_t first = limit >= 4 ? limit - 4 : 0;
        for (size_t p = 0; p < run->count; p++)
            run->cos_code[p] = p % 2 == 0
                                   ? glint_random_below(random, GLINT_COS_CODE_MAX + 1)
                                   : first + glint_random_below(random, GLINT_COS_ONE - first + 1);
        compare_run(run, tally);
    }
}

static bool compare_batch(void)
{
    static run run;
    tally tally = {0};
    glint_random random = {2026};
    compare_every_code(&run, &random, &tally);
    compare_random(&run, &random, &tally);
    printf("batch = blocks: %" PRIu64 " points, %" PRIu64 " differ\n", tally.points,
           tally.differences);
    printf("blocks = formula: %" PRIu64 " points, %" PRIu64
           " further than roundings go; the worst at %.3f of that\n",
           tally.weighed, tally.too_far, tally.worst);
    return tally.points > 0 && tally.differences == 0 && tally.too_far == 0;
}

static bool compare_circuit(const glint_setting *setting)
{
    char name[GLINT_SETTING_TEXT];
    glint_error err;
    glint_lockstep_result result;
    const glint_lockstep_options options = {.setting = *setting, .clocks = CLOCKS, .seed = 1};
    glint_setting_describe(setting, name);
    if (glint_lockstep_run(&options, &result, &err) != GLINT_OK) {
        printf("C = Verilog, %s: %s\n", name, err.text);
        return false;
    }
    printf("C = Verilog, %s: %" PRIu64 " clocks, %" PRIu64 " comparisons, %" PRIu64 " differ\n",
           name, result.clocks, result.comparisons, result.mismatches);
    return result.comparisons > 0 && result.mismatches == 0;
}

static int number_of(const char *name, const char *(*name_of)(int), int count)
{
    for (int i = 0; i < count; i++)
        if (strcmp(name, name_of(i)) == 0)
            return i;
    fprintf(stderr, "there is no \"%s\"\n", name);
    exit(2);
}

static const char *gate_name(int gate)
{
    return glint_gate_name((glint_gate)gate);
}

static const char *pipeline_name(int pipeline)
{
    return glint_pipeline_name((glint_pipeline)pipeline);
}

/* gate-pipeline-lanes */
static glint_setting setting_of(const char *name)
{
    char gate[16], pipeline[16];
    glint_specular_config config;
    if (sscanf(name, "%15[a-z]-%15[a-z]-%d", gate, pipeline, &config.lanes) != 3)
        exit(2);
    config.gate = (glint_gate)number_of(gate, gate_name, GLINT_GATE_COUNT);
    config.pipeline = (glint_pipeline)number_of(pipeline, pipeline_name, GLINT_PIPELINE_COUNT);
    return glint_setting_specular(&config);
}

int main(int argc, char **argv)
{
    bool good = compare_batch();
    for (int i = 1; i < argc; i++) {
        const glint_setting setting = setting_of(argv[i]);
        good &= compare_circuit(&setting);
    }
    return good && argc > 1 ? 0 : 1;
}
