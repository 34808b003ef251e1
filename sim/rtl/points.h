/* A run of points through a highlight unit, and the function of a fast circuit's shared object that
 * takes one: specular_batch.cpp defines it, specular_batch.c calls it. */
#ifndef GLINT_SIM_RTL_POINTS_H
#define GLINT_SIM_RTL_POINTS_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A run of points of one material; arrays of `count`. */
typedef struct glint_points {
    const uint32_t *cos;
    size_t count;
    uint32_t *w; /* as wide as the circuit's; may be NULL */
    uint8_t *r, *g, *b;
} glint_points;

/* Writes n, r, g, b with the first cosines, feeds the points and collects the results. Returns how
 * many came back: points->count if the circuit works. */
typedef size_t glint_shade_function(void *instance, uint16_t n, uint8_t r, uint8_t g, uint8_t b,
                                    const glint_points *points);

/* The symbol: a constant pointer to it. */
#define GLINT_SHADE_SYMBOL glint_circuit_shade

#ifdef __cplusplus
}
#endif

#endif
