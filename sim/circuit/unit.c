/* What the descriptions of all highlight units do alike. */
#include "circuit/unit.h"

#include <string.h>

glint_unit_config glint_unit_config_of(const glint_unit *unit, const int *values)
{
    const int has_variant = unit->variants > 1;
    return (glint_unit_config){.unit = unit,
                               .variant = has_variant ? values[0] : 0,
                               .w_drop = values[has_variant],
                               .pipeline = (glint_pipeline)values[has_variant + 1],
                               .lanes = values[has_variant + 2]};
}

void glint_unit_config_values(const glint_unit_config *config, int *values)
{
    const int has_variant = config->unit->variants > 1;
    if (has_variant)
        values[0] = config->variant;
    values[has_variant] = config->w_drop;
    values[has_variant + 1] = (int)config->pipeline;
    values[has_variant + 2] = config->lanes;
}

static const char *heading_of(const glint_unit_circuit *of, const glint_signal_info *signal)
{
    if (signal->kind == GLINT_SIGNAL_OUTPUT)
        return GLINT_UNIT_HEADING_OUTPUTS;
    if (signal->lane < 0) {
        if (signal->block == 0)
            return GLINT_UNIT_HEADING_VALID;
        if (signal->kind == GLINT_SIGNAL_STAGE)
            return GLINT_UNIT_HEADING_DELAYED;
        return signal->block == 2 ? GLINT_UNIT_HEADING_N : GLINT_UNIT_HEADING_COLORS;
    }
    for (int i = 0; i < of->heading_count; i++)
        if (memchr(of->headings[i].block, signal->block, sizeof of->headings[i].block) != NULL)
            return of->headings[i].title;
    return signal->block == 12 ? GLINT_UNIT_HEADING_W : GLINT_UNIT_HEADING_MUL;
}

/* With the combinational pipeline a stage of the shared path is a wire and says nothing new. */
static int is_copy(const glint_unit_config *config, const glint_signal_info *signal)
{
    return signal->kind == GLINT_SIGNAL_STAGE && signal->lane < 0 &&
           config->pipeline == GLINT_PIPELINE_COMBINATIONAL &&
           strcmp(signal->name, "s1_valid") != 0;
}

glint_signal_info glint_unit_signal(const glint_unit_circuit *of, const int *values, int index)
{
    const glint_unit_config config = glint_unit_config_of(of->unit, values);
    glint_signal_info info = glint_unit_signal_info(&config, index);
    info.heading = heading_of(of, &info);
    info.is_copy = is_copy(&config, &info);
    return info;
}

glint_status glint_unit_create(const glint_unit *unit, const int *values, void **model)
{
    const glint_unit_config config = glint_unit_config_of(unit, values);
    glint_unit_device *device;
    const glint_status status = glint_unit_device_create(&config, &device);
    *model = device;
    return status;
}

void glint_unit_destroy(void *model)
{
    glint_unit_device_destroy(model);
}

void glint_unit_clock(void *model, const void *pins)
{
    glint_unit_device_clock(model, pins);
}

const void *glint_unit_signals(const void *model)
{
    return glint_unit_device_signals(model);
}

void glint_unit_stimulus_next(void *stimulus, void *pins)
{
    glint_stimulus_next(stimulus, pins);
}

/* ---- Domain ---------------------------------------------------------------------------------- */

static uint64_t clocks_of_n(int lanes)
{
    return ((uint64_t)GLINT_COS_CODE_MAX + (uint64_t)lanes) / (uint64_t)lanes;
}

uint64_t glint_unit_points(int lanes)
{
    return GLINT_N_COUNT * clocks_of_n(lanes);
}

/* A component is white, the others take all values; the material is written with every clock. */
void glint_unit_put(int lanes, uint64_t point, void *pins)
{
    glint_specular_inputs *in = pins;
    const uint64_t n = point / clocks_of_n(lanes);
    const uint64_t first = point % clocks_of_n(lanes) * (uint64_t)lanes;
    in->n_we = in->rgb_we = 1;
    in->n = (uint16_t)n;
    in->r = GLINT_COLOR_MAX;
    in->g = (uint8_t)(GLINT_COLOR_MAX - n);
    in->b = (uint8_t)(37 * n + first);
    in->in_valid = (uint32_t)((UINT64_C(1) << lanes) - 1);
    for (int i = 0; i < lanes; i++)
        in->cos[i] = (uint32_t)(first + (uint64_t)i) & GLINT_COS_CODE_MAX;
}
