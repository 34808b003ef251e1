/* Hammered metal: waves of whole periods, so that the maps repeat; see gold_maps.h. */
#include "gl/gold_maps.h"

#include <math.h>

#define TURN 6.28318530717958648

/* A wave's periods along the map and across it, its height, and where it begins. */
typedef struct wave {
    int along, across;
    double height, phase;
} wave;

static const wave waves[] = {
    {13, 4, 0.30, 0.0}, {-6, 12, 0.30, 1.1}, {9, -17, 0.20, 2.3},
    {21, 8, 0.15, 4.0}, {3, 5, 0.25, 5.2},
};

/* Height and slopes at a place of the map, 0…1. */
typedef struct surface {
    double height, along, across;
} surface;

static surface surface_at(double u, double v)
{
    surface s = {0.0, 0.0, 0.0};
    for (unsigned i = 0; i < sizeof waves / sizeof waves[0]; i++) {
        const wave *w = &waves[i];
        const double angle = TURN * (w->along * u + w->across * v) + w->phase;
        s.height += w->height * sin(angle);
        s.along += w->height * w->along * cos(angle);
        s.across += w->height * w->across * cos(angle);
    }
    return s;
}

/* How steep the dents are. */
#define DEPTH 0.025

static uint8_t byte_of(double value)
{
    return (uint8_t)floor(255.0 * fmin(fmax(value, 0.0), 1.0) + 0.5);
}

void glint_gold_maps(uint8_t *base, uint8_t *bump)
{
    for (int y = 0; y < GLINT_GOLD_SIDE; y++)
        for (int x = 0; x < GLINT_GOLD_SIDE; x++) {
            const surface s = surface_at((x + 0.5) / GLINT_GOLD_SIDE, (y + 0.5) / GLINT_GOLD_SIDE);
            const double n[3] = {-DEPTH * s.along, -DEPTH * s.across, 1.0};
            const double length = sqrt(n[0] * n[0] + n[1] * n[1] + 1.0);
            static const double tint[3] = {0.80, 0.55, 0.25};
            for (int c = 0; c < 3; c++) {
                *bump++ = byte_of(0.5 * (n[c] / length + 1.0));
                *base++ = byte_of(tint[c] * (0.75 + 0.25 * s.height));
            }
        }
}
