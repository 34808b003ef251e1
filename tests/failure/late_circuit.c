/* A circuit that goes wrong late, which nothing shows before: out_valid is inverted after the clock
 * that the environment variable GLINT_LATE names, counted from its creation, and only then. The
 * only circuit of build/late/glint. */
#define _POSIX_C_SOURCE 200809L

#include <stdlib.h>
#include <string.h>

#include "rtl/rtl_model.h"

extern const glint_rtl_model glint_rtl_model_cosine_pipelined_1;
static const glint_rtl_model *const sound = &glint_rtl_model_cosine_pipelined_1;

typedef struct late {
    void *sound;
    unsigned long long clocks, wrong_at;
    const uint8_t *true_valid; /* of the sound circuit, once it was looked for */
    uint8_t shown_valid;
} late;

static void *create_late(void)
{
    const char *clock = getenv("GLINT_LATE");
    late *made = calloc(1, sizeof *made);
    if (made == NULL)
        return NULL;
    made->wrong_at = clock != NULL ? strtoull(clock, NULL, 10) : 0;
    made->sound = sound->create();
    if (made->sound == NULL) {
        free(made);
        return NULL;
    }
    return made;
}

static void destroy_late(void *instance)
{
    late *of = instance;
    sound->destroy(of->sound);
    free(of);
}

static uint64_t clocks_late(const void *instance)
{
    return sound->clocks(((const late *)instance)->sound);
}

static void clock_late(void *instance, const glint_specular_inputs *inputs)
{
    late *of = instance;
    sound->clock(of->sound, inputs);
    of->clocks++;
    if (of->true_valid != NULL)
        of->shown_valid = *of->true_valid ^ (uint8_t)(of->clocks == of->wrong_at);
}

static bool find_late(void *instance, int lane, const char *name, const void **data, int *size)
{
    late *of = instance;
    const bool found = sound->find(of->sound, lane, name, data, size);
    if (found && strcmp(name, "out_valid") == 0) {
        of->true_valid = *data;
        of->shown_valid = *of->true_valid;
        *data = &of->shown_valid;
    }
    return found;
}

static size_t batch_late(void *instance, const glint_material *material,
                         const glint_rtl_batch_io *io)
{
    return sound->batch(((late *)instance)->sound, material, io);
}

static bool trace_open_late(void *instance, const char *path)
{
    return sound->trace_open(((late *)instance)->sound, path);
}

static void trace_close_late(void *instance)
{
    sound->trace_close(((late *)instance)->sound);
}

const glint_rtl_model glint_late_circuit = {
    .config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1},
    .observed = true,
    .create = create_late,
    .destroy = destroy_late,
    .clock = clock_late,
    .find = find_late,
    .clocks = clocks_late,
    .batch = batch_late,
    .trace_open = trace_open_late,
    .trace_close = trace_close_late,
};
