/* The white furnace: a sphere lit uniformly with 1 from all directions. A pixel's value is the
 * albedo at its viewing angle; a lossless surface is indistinguishable from the background. */
#ifndef GLINT_SIM_ENERGY_FURNACE_H
#define GLINT_SIM_ENERGY_FURNACE_H

#include "energy/table.h"
#include "image/image.h"

/* The colour of a value: up to 1 grey, by sRGB's curve; above 1, where the surface reflects more
 * light than it receives, from yellow (just above 1) through red (1.5) to black (3 and more). */
void glint_furnace_color(double value, uint8_t rgb[3]);

/* Spheres `size` pixels wide by quadrature of the table (which needs it): a row for each of `count`
 * models from `first` on, a column for each n. Between the table's angles, which must ascend, it
 * interpolates; beyond the last it takes the last. On white. */
glint_status glint_furnace_picture(const glint_energy_table *table, int first, int count, int size,
                                   glint_image **image, glint_error *err);

#endif
