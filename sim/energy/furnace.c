/* Paints the spheres, interpolating in the table of albedos; false colour marks albedos above 1. */
#include "energy/furnace.h"

#include <math.h>
#include <string.h>

#define DEGREE (3.14159265358979323846 / 180.0)

/* From a sphere to the next, in parts of its width. */
#define GAP 0.08

#define LEVEL_MAX 255.0

static double srgb(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
}

void glint_furnace_color(double value, uint8_t rgb[3])
{
    static const struct {
        double value, r, g, b;
    } scale[] = {{1.0, 255, 210, 0}, {1.5, 220, 0, 0}, {3.0, 0, 0, 0}};
    if (value <= GLINT_ENERGY_ONE) {
        memset(rgb, (int)lround(LEVEL_MAX * srgb(fmin(1.0, fmax(0.0, value)))), 3);
        return;
    }
    const double held = fmin(value, scale[2].value);
    const int i = held < scale[1].value ? 0 : 1;
    const double part = (held - scale[i].value) / (scale[i + 1].value - scale[i].value);
    rgb[0] = (uint8_t)lround(scale[i].r + part * (scale[i + 1].r - scale[i].r));
    rgb[1] = (uint8_t)lround(scale[i].g + part * (scale[i + 1].g - scale[i].g));
    rgb[2] = (uint8_t)lround(scale[i].b + part * (scale[i + 1].b - scale[i].b));
}

/* R of a model and n at any angle, degrees. */
static double value_at(const glint_energy_table *table, int model, int n, double angle)
{
    const double *angles = table->plan.angle;
    const int last = table->plan.angle_count - 1;
    int i = 0;
    while (i < last && angles[i + 1] < angle)
        i++;
    const double value = glint_energy_at(table, model, n, i)->quadrature;
    if (i == last || angle <= angles[i])
        return value;
    const double part = (angle - angles[i]) / (angles[i + 1] - angles[i]);
    return value + part * (glint_energy_at(table, model, n, i + 1)->quadrature - value);
}

typedef struct place {
    int left, top, size; /* of a sphere's square, pixels */
} place;

static void paint_sphere(const glint_energy_table *table, int model, int n, place at,
                         glint_image *image)
{
    for (int y = 0; y < at.size; y++)
        for (int x = 0; x < at.size; x++) {
            const double u = (2 * x + 1.0) / at.size - 1.0, v = (2 * y + 1.0) / at.size - 1.0;
            const double r2 = u * u + v * v;
            if (r2 >= 1.0)
                continue;
            const size_t pixel =
                (size_t)(at.top + y) * (size_t)image->width + (size_t)(at.left + x);
            glint_furnace_color(value_at(table, model, n, asin(sqrt(r2)) / DEGREE),
                                &image->rgb[3 * pixel]);
        }
}

glint_status glint_furnace_picture(const glint_energy_table *table, int first, int count, int size,
                                   glint_image **image, glint_error *err)
{
    const int step = size + (int)lround(GAP * size), gap = step - size;
    const glint_status status =
        glint_image_create(table->plan.n_count * step + gap, count * step + gap, image, err);
    if (status != GLINT_OK)
        return status;
    const size_t pixels = (size_t)(*image)->width * (size_t)(*image)->height;
    memset((*image)->rgb, (int)LEVEL_MAX, 3 * pixels);
    memset((*image)->object, 1, pixels);
    for (int i = 0; i < count; i++)
        for (int n = 0; n < table->plan.n_count; n++)
            paint_sphere(table, first + i, n, (place){gap + n * step, gap + i * step, size},
                         *image);
    return GLINT_OK;
}
