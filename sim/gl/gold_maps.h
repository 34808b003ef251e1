/* The two maps of the gold shader. The thesis's came with the tool that showed it, and are not in
 * its text; these are hammered metal, made here. */
#ifndef GLINT_SIM_GL_GOLD_MAPS_H
#define GLINT_SIM_GL_GOLD_MAPS_H

#include <stdint.h>

#define GLINT_GOLD_SIDE 256

/* The texture units that hold them. */
#define GLINT_GOLD_BASE 0
#define GLINT_GOLD_BUMP 1

/* Side × side pixels R, G, B, which repeat: the base colour, and normals as (N + 1)/2. */
void glint_gold_maps(uint8_t *base, uint8_t *bump);

#endif
