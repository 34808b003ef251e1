/* Runs of points, of divisions and of spans at full speed through a fast circuit: points by a loop
 * in the circuit's own shared object (specular_batch.cpp, for all highlight units), divisions and
 * spans through its ports (divider_batch.c, span_batch.c). */
#ifndef GLINT_SIM_RTL_BATCH_H
#define GLINT_SIM_RTL_BATCH_H

#include "glint_divider_device.h"
#include "glint_quadratic_span.h"
#include "glint_specular.h"
#include "rtl/points.h"
#include "rtl/rtl.h"

/* The memory of a port that must be of so many bytes; else *good becomes false. */
static inline void *glint_batch_port(glint_rtl *rtl, const char *name, size_t size, bool *good)
{
    size_t found = 0;
    void *data = glint_rtl_port(rtl, name, &found);
    *good = *good && data != NULL && found == size;
    return data;
}

/* Writes the material with the first cosines, then feeds `lanes` cosines per clock without gaps and
 * collects the results. GLINT_DEVICE_FAULT if the circuit does not return every result within its
 * latency. Nothing may be left in flight from glint_rtl_clock(): it would be mistaken for
 * results. */
glint_status glint_rtl_shade(glint_rtl *rtl, const glint_material *material,
                             const glint_points *points, glint_error *err);

/* Divides count times: the pipelined form takes one division per clock, the sequential one
 * component after component. GLINT_DEVICE_FAULT if the circuit does not return every quotient in
 * time. */
glint_status glint_rtl_divide(glint_rtl *rtl, const glint_division *divisions, size_t count,
                              glint_quotients *quotients, glint_error *err);

/* Spans of quadratic interpolation, one after the other. */
typedef struct glint_spans {
    const glint_quadratic_walk *walk;
    const uint32_t *length; /* pixels of each, at least 1 */
    size_t count;
    uint8_t *rgb; /* three bytes for each pixel of all spans */
} glint_spans;

/* Walks them without gaps, a pixel a clock. GLINT_DEVICE_FAULT if the circuit does not return every
 * pixel in time. */
glint_status glint_rtl_walk(glint_rtl *rtl, const glint_spans *spans, glint_error *err);

#endif
