/* The published data of the Newell teapot: 32 bicubic Bezier patches over 306 control points. */
#ifndef GLINT_SIM_RENDER_TEAPOT_DATA_H
#define GLINT_SIM_RENDER_TEAPOT_DATA_H

#include <stdint.h>

#define GLINT_TEAPOT_PATCHES  32
#define GLINT_TEAPOT_VERTICES 306

/* Sixteen control points a patch, four rows of four, as 1-based places in glint_teapot_vertices. */
extern const uint16_t glint_teapot_patches[GLINT_TEAPOT_PATCHES][16];

/* x, y, z with z up; the spout points along +x. Four of them (205, 206, 216, 223) belong to no
 * patch: the published list carries them, so they are kept. */
extern const double glint_teapot_vertices[GLINT_TEAPOT_VERTICES][3];

#endif
