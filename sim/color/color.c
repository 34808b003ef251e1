/* RGB to and from HSV and CMYK; see color.h. */
#include "color/color.h"

#include <stdbool.h>

#define FULL 255.0

static bool is_share(double x)
{
    return x >= 0.0 && x <= 1.0;
}

/* A value just short of half a level because of floating-point rounding counts as half a level: a
 * tenth of white, as 1 − 0.9, is 25.5 levels. */
#define HALF (0.5 + 1e-9)

static uint8_t component(double share)
{
    return (uint8_t)(share * FULL + HALF);
}

static int largest(glint_rgb rgb)
{
    const int rg = rgb.r > rgb.g ? rgb.r : rgb.g;
    return rg > rgb.b ? rg : rgb.b;
}

static int smallest(glint_rgb rgb)
{
    const int rg = rgb.r < rgb.g ? rgb.r : rgb.g;
    return rg < rgb.b ? rg : rgb.b;
}

/* In sixths of the circle, for a colour that is not grey. */
static double hue(glint_rgb rgb, int max, double range)
{
    if (max == rgb.r) {
        const double from_red = (rgb.g - rgb.b) / range;
        return from_red < 0.0 ? from_red + 6.0 : from_red;
    }
    return max == rgb.g ? 2.0 + (rgb.b - rgb.r) / range : 4.0 + (rgb.r - rgb.g) / range;
}

glint_hsv glint_hsv_of_rgb(glint_rgb rgb)
{
    const int max = largest(rgb);
    const int range = max - smallest(rgb);
    if (range == 0)
        return (glint_hsv){0.0, 0.0, max / FULL};
    return (glint_hsv){60.0 * hue(rgb, max, range), (double)range / max, max / FULL};
}

/* The component whose hue lies `from` sixths of the circle before: full within one sixth of its
 * hue, then falling, and (1−s)v opposite to it. */
static double share_of_hsv(const glint_hsv *hsv, double from)
{
    const double sixths = from + hsv->h / 60.0;
    const double place = sixths < 6.0 ? sixths : sixths - 6.0;
    const double side = place < 2.0 ? place : 4.0 - place;
    const double missing = side < 0.0 ? 0.0 : side > 1.0 ? 1.0 : side;
    return hsv->v * (1.0 - hsv->s * missing);
}

glint_status glint_rgb_of_hsv(const glint_hsv *hsv, glint_rgb *rgb)
{
    if (!(hsv->h >= 0.0 && hsv->h <= 360.0) || !is_share(hsv->s) || !is_share(hsv->v))
        return GLINT_BAD_ARGUMENT;
    *rgb = (glint_rgb){component(share_of_hsv(hsv, 5.0)), component(share_of_hsv(hsv, 3.0)),
                       component(share_of_hsv(hsv, 1.0))};
    return GLINT_OK;
}

glint_cmyk glint_cmyk_of_rgb(glint_rgb rgb)
{
    const double max = largest(rgb);
    if (max == 0.0)
        return (glint_cmyk){0.0, 0.0, 0.0, 1.0};
    return (glint_cmyk){(max - rgb.r) / max, (max - rgb.g) / max, (max - rgb.b) / max,
                        (FULL - max) / FULL};
}

glint_status glint_rgb_of_cmyk(const glint_cmyk *cmyk, glint_rgb *rgb)
{
    if (!is_share(cmyk->c) || !is_share(cmyk->m) || !is_share(cmyk->y) || !is_share(cmyk->k))
        return GLINT_BAD_ARGUMENT;
    const double white = 1.0 - cmyk->k;
    *rgb = (glint_rgb){component((1.0 - cmyk->c) * white), component((1.0 - cmyk->m) * white),
                       component((1.0 - cmyk->y) * white)};
    return GLINT_OK;
}
