/* From a setting of a highlight unit to its C model; see units.h. */
#include "circuit/units.h"

#include <stdlib.h>

#include "circuit/circuits.h"
#include "circuit/unit.h"
#include "glint_power.h"
#include "glint_rivals.h"

typedef struct entry {
    const glint_circuit *circuit;
    const glint_unit *unit;
} entry;

#define DECLARE(name) extern const glint_circuit glint_circuit_##name;
#define ENTRY(name)   {&glint_circuit_##name, &glint_unit_##name},

GLINT_UNITS(DECLARE)
static const entry entries[] = {GLINT_UNITS(ENTRY)};

/* NULL: it is none of GLINT_UNITS. */
static const glint_unit *unit_of(const glint_circuit *circuit)
{
    for (size_t i = 0; i < sizeof entries / sizeof entries[0]; i++)
        if (entries[i].circuit == circuit)
            return entries[i].unit;
    return NULL;
}

bool glint_is_highlight(const glint_circuit *circuit)
{
    return circuit == &glint_circuit_specular || unit_of(circuit) != NULL;
}

const glint_parameter *glint_highlight_parameter(const glint_circuit *circuit)
{
    const glint_unit *unit = unit_of(circuit);
    return unit != NULL && unit->variants > 1 ? &circuit->parameters[0] : NULL;
}

int glint_highlight_only_n(const glint_circuit *circuit, int variant)
{
    if (circuit != &glint_circuit_bipartite)
        return 0;
    return (int)strtol(circuit->parameters[0].choices[variant], NULL, 10);
}

glint_setting glint_setting_unit(const glint_circuit *circuit, int variant, int w_drop,
                                 glint_pipeline pipeline, int lanes)
{
    const glint_unit *unit = unit_of(circuit);
    glint_setting setting = {.circuit = circuit};
    glint_unit_config_values(&(glint_unit_config){.unit = unit,
                                                  .variant = variant,
                                                  .w_drop = w_drop,
                                                  .pipeline = pipeline,
                                                  .lanes = lanes},
                             setting.values);
    return setting;
}

int glint_highlight_lanes(const glint_setting *setting)
{
    return glint_setting_value(setting, "lanes", 1);
}

/* The last parameter of every highlight unit. */
void glint_highlight_set_lanes(glint_setting *setting, int lanes)
{
    setting->values[setting->circuit->parameter_count - 1] = lanes;
}

int glint_highlight_w_frac_bits(const glint_setting *setting)
{
    const glint_unit *unit = unit_of(setting->circuit);
    if (unit == NULL)
        return GLINT_W_FRAC_BITS;
    const glint_unit_config config = glint_unit_config_of(unit, setting->values);
    return glint_unit_w_frac_bits(&config);
}

static glint_gate gate_of(const glint_setting *setting)
{
    return (glint_gate)setting->values[GLINT_SPECULAR_GATE];
}

glint_status glint_highlight_batch(const glint_setting *setting, const glint_material *material,
                                   const uint32_t *cos_code, size_t count, uint32_t *w_code,
                                   uint8_t *r, uint8_t *g, uint8_t *b)
{
    const glint_unit *unit = unit_of(setting->circuit);
    if (unit == NULL)
        return glint_specular_batch(gate_of(setting), material, cos_code, count, w_code, r, g, b);
    const glint_unit_config config = glint_unit_config_of(unit, setting->values);
    return glint_unit_batch(&config, material, cos_code, count, w_code, r, g, b);
}

double glint_highlight_real(const glint_setting *setting, uint32_t n, uint32_t cos_code)
{
    if (setting->circuit == &glint_circuit_specular) /* a frame asks for each pixel */
        return glint_specular_real(gate_of(setting), n, cos_code);
    const glint_unit *unit = unit_of(setting->circuit);
    return unit->real(glint_unit_config_of(unit, setting->values).variant, n, cos_code);
}
