/* The difference K of two traced colours that decides whether what lies between them is
 * interpolated (thesis 2.30). The thesis gives the limit, 2.3, and no unit; 2.3 is the just
 * noticeable difference in CIELAB, so that is the default. */
#ifndef GLINT_SIM_TRACE_MEASURE_H
#define GLINT_SIM_TRACE_MEASURE_H

#include <stdint.h>

typedef enum glint_measure {
    GLINT_MEASURE_DELTA_E, /* CIE 1976: the distance in CIELAB; sRGB, D65 */
    GLINT_MEASURE_LEVELS,  /* the largest difference of a component, 0…255 */
    GLINT_MEASURE_RMS,     /* root of the components' mean square, in per cent of full scale */
    GLINT_MEASURE_COUNT
} glint_measure;

/* "delta-e", "levels", "rms"; NULL ends them. */
extern const char *const glint_measure_names[];

#define GLINT_LIMIT_DEFAULT 2.3

double glint_measure_of(glint_measure measure, const uint8_t a[3], const uint8_t b[3]);

#endif
