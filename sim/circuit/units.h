/* Highlight units behind the pins of the specular device, as functions of points: the thesis's own
 * and those of cmodel/glint_unit.h. What takes points of any of them (batches, frames, exhaustive
 * runs) asks here what is a unit's own. */
#ifndef GLINT_SIM_CIRCUIT_UNITS_H
#define GLINT_SIM_CIRCUIT_UNITS_H

#include "circuit/setting.h"
#include "glint_specular.h"

/* One line for each unit besides the specular device. */
#define GLINT_UNITS(X)                                                                             \
    X(power)                                                                                       \
    X(log2)                                                                                        \
    X(schlick)                                                                                     \
    X(newton)                                                                                      \
    X(lyon)                                                                                        \
    X(bipartite)                                                                                   \
    X(quadratic)

/* The specular device, or one of GLINT_UNITS. */
bool glint_is_highlight(const glint_circuit *circuit);

/* The parameter of one of GLINT_UNITS that is its own, its first; NULL: it has none. */
const glint_parameter *glint_highlight_parameter(const glint_circuit *circuit);

/* The one n that such a setting's unit is made for, whatever its pin n; 0: any. */
int glint_highlight_only_n(const glint_circuit *circuit, int variant);

/* All below: of a circuit that is one. */
int glint_highlight_lanes(const glint_setting *setting);
void glint_highlight_set_lanes(glint_setting *setting, int lanes);
int glint_highlight_w_frac_bits(const glint_setting *setting); /* W is U1.this */

/* A setting of one of GLINT_UNITS; variant: the value of its own parameter, if it has one; w_drop:
 * places of W that are rounded off. */
glint_setting glint_setting_unit(const glint_circuit *circuit, int variant, int w_drop,
                                 glint_pipeline pipeline, int lanes);

/* Points of one material by the C model, as glint_specular_batch() and glint_unit_batch(). */
glint_status glint_highlight_batch(const glint_setting *setting, const glint_material *material,
                                   const uint32_t *cos_code, size_t count, uint32_t *w_code,
                                   uint8_t *r, uint8_t *g, uint8_t *b);

/* The unit's own formula without rounding, 0…1. */
double glint_highlight_real(const glint_setting *setting, uint32_t n, uint32_t cos_code);

#endif
