/* Three ways to say how far two colours are apart. */
#define _POSIX_C_SOURCE 200809L

#include "trace/measure.h"

#include <math.h>
#include <pthread.h>
#include <stdlib.h>

static pthread_once_t light_once = PTHREAD_ONCE_INIT;
static double light_of[256];

/* sRGB, IEC 61966-2-1: from 8 bits to light, full scale 1. */
static void find_light(void)
{
    for (int code = 0; code < 256; code++) {
        const double c = code / 255.0;
        light_of[code] = c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
    }
}

/* CIELAB's cube root, which is a straight line close to black. */
static double lab_root(double share)
{
    const double d = 6.0 / 29.0;
    return share > d * d * d ? cbrt(share) : share / (3.0 * d * d) + 4.0 / 29.0;
}

static void lab_of(const uint8_t rgb[3], double lab[3])
{
    static const double rows[3][3] = {
        {0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}};
    const double light[3] = {light_of[rgb[0]], light_of[rgb[1]], light_of[rgb[2]]};
    double root[3];
    for (int i = 0; i < 3; i++) {
        const double *row = rows[i];
        const double white = row[0] + row[1] + row[2];
        root[i] = lab_root((row[0] * light[0] + row[1] * light[1] + row[2] * light[2]) / white);
    }
    lab[0] = 116.0 * root[1] - 16.0;
    lab[1] = 500.0 * (root[0] - root[1]);
    lab[2] = 200.0 * (root[1] - root[2]);
}

static double delta_e(const uint8_t a[3], const uint8_t b[3])
{
    double lab_a[3], lab_b[3];
    (void)pthread_once(&light_once, find_light);
    lab_of(a, lab_a);
    lab_of(b, lab_b);
    double sum = 0.0;
    for (int i = 0; i < 3; i++)
        sum += (lab_a[i] - lab_b[i]) * (lab_a[i] - lab_b[i]);
    return sqrt(sum);
}

double glint_measure_of(glint_measure measure, const uint8_t a[3], const uint8_t b[3])
{
    int largest = 0, squares = 0;
    for (int i = 0; i < 3; i++) {
        const int d = abs(a[i] - b[i]);
        largest = d > largest ? d : largest;
        squares += d * d;
    }
    if (largest == 0 || measure == GLINT_MEASURE_LEVELS)
        return largest;
    return measure == GLINT_MEASURE_RMS ? 100.0 / 255.0 * sqrt((double)squares / 3.0)
                                        : delta_e(a, b);
}
