/* What a highlight unit's setting may be. Private to cmodel/. */
#ifndef GLINT_CMODEL_UNIT_RANGE_H
#define GLINT_CMODEL_UNIT_RANGE_H

#include "glint_unit.h"

/* The variant and the width of W; the pipeline and the lanes are a device's. */
static inline int glint_unit_is_in_range(const glint_unit_config *config)
{
    return config->variant >= 0 && config->variant < config->unit->variants &&
           config->w_drop >= 0 && glint_unit_w_frac_bits(config) >= GLINT_UNIT_W_FRAC_MIN;
}

#endif
