/* Deferred quadratic shading of one band of rows (quadratic.h): the pixels of a row in which one
 * triangle is seen are a span, which the span unit walks (glint_quadratic_span.h). A span longer
 * than keeps within half a level becomes several, each set up anew. */
#ifndef GLINT_SIM_RENDER_QUADRATIC_BAND_H
#define GLINT_SIM_RENDER_QUADRATIC_BAND_H

#include "backend/quadratic_backend.h"
#include "image/image.h"
#include "render/quadratic.h"

/* In place of a number of fraction bits: every pixel has the polynomial's value in double
 * precision, rounded half up and held in 0 … 255, without the unit. */
#define GLINT_FRACTION_EXACT 0

/* One thread's room, backend and counters. */
typedef struct glint_quadratic_shader glint_quadratic_shader;

/* Makes *shader ready for a frame of that width, and it itself when it is NULL. With kind real
 * values are exact whatever the number of fraction bits. watch may be NULL. */
glint_status glint_quadratic_shader_prepare(glint_quadratic_shader **shader, int32_t width,
                                            const glint_quadratic_config *config,
                                            glint_backend_watch *watch, glint_error *err);
void glint_quadratic_shader_destroy(glint_quadratic_shader *shader); /* NULL is allowed */

/* As glint_backend_set_watch(). */
void glint_quadratic_shader_watch(glint_quadratic_shader *shader, glint_backend_watch *watch);

/* Shades the band into the image. Adds to *fragments. */
glint_status glint_quadratic_band(glint_quadratic_shader *shader, const glint_visibility *band,
                                  glint_image *image, uint64_t *fragments, glint_error *err);

/* Of the frame that it was last prepared for; NULL has none. */
uint64_t glint_quadratic_shader_spans(const glint_quadratic_shader *shader);
uint64_t glint_quadratic_shader_clocks(const glint_quadratic_shader *shader);

/* The three numbers of a span for each component: of weights u, v at its first pixel and what they
 * grow by from pixel to pixel, rounded to codes. Numbers that a span so short does not use are 0:
 * across a thin triangle they may be large. */
glint_quadratic_walk glint_quadratic_walk_of(const glint_quadratic q[3], const glint_weights *w,
                                             uint32_t length, int fraction);

#endif
