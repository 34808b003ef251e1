/* The colour models of thesis section 1.4: RGB, CMYK and HSV.
 *
 * RGB is three components of 8 bits, as in a picture. The others are real numbers, so they can
 * represent every RGB colour: the round trip from RGB is exact for all 2^24. The opposite round
 * trip is not, because they have more colours than RGB, and because a grey has no hue and black no
 * saturation. */
#ifndef GLINT_SIM_COLOR_COLOR_H
#define GLINT_SIM_COLOR_COLOR_H

#include <stdint.h>

#include "glint_status.h"

typedef struct glint_rgb {
    uint8_t r, g, b;
} glint_rgb;

/* Section 1.4.3. h: hue in degrees, 0…360, of which 0 and 360 are red, 120 green, 240 blue. s:
 * saturation, 0 (grey) … 1 (pure). v: value, 0 (black) … 1. */
typedef struct glint_hsv {
    double h, s, v;
} glint_hsv;

/* Section 1.4.2. Cyan, magenta, yellow and black ink, each 0…1. */
typedef struct glint_cmyk {
    double c, m, y, k;
} glint_cmyk;

/* v = max, s = (max − min)/max, h from the two larger components; h < 360. Greys, including black,
 * get h = 0 and s = 0. */
glint_hsv glint_hsv_of_rgb(glint_rgb rgb);

/* Each component rounded half up to 8 bits. GLINT_BAD_ARGUMENT when one is out of its range. */
glint_status glint_rgb_of_hsv(const glint_hsv *hsv, glint_rgb *rgb);

/* As much black as the three components share: k = 1 − max, c = (max − R)/max, …: the least ink
 * that gives the colour. Black is black ink alone: c = m = y = 0. */
glint_cmyk glint_cmyk_of_rgb(glint_rgb rgb);

/* R = (1−c)(1−k), …, rounded half up to 8 bits. GLINT_BAD_ARGUMENT when one is not in 0…1. */
glint_status glint_rgb_of_cmyk(const glint_cmyk *cmyk, glint_rgb *rgb);

#endif
