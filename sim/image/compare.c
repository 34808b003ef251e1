/* How two pictures differ, in numbers and as a picture; see image.h. */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "image/image.h"

static glint_status check_sizes(const glint_image *a, const glint_image *b, glint_error *err)
{
    if (a->width != b->width || a->height != b->height) {
        return glint_fail(err, GLINT_BAD_INPUT, "the pictures differ in size: %dx%d against %dx%d",
                          a->width, a->height, b->width, b->height);
    }
    return GLINT_OK;
}

/* The largest difference of a component of two pixels. */
static int pixel_difference(const uint8_t *a, const uint8_t *b)
{
    int largest = 0;
    for (int i = 0; i < 3; i++) {
        const int difference = abs(a[i] - b[i]);
        largest = difference > largest ? difference : largest;
    }
    return largest;
}

/* Sums of squares over the object; integers, so that no order of summing matters. At most
 * 16384²·3·255² < 2^46. */
typedef struct sums {
    uint64_t error, reference;
} sums;

static void add_pixel(const uint8_t *a, const uint8_t *b, sums *sum)
{
    for (int i = 0; i < 3; i++) {
        const int64_t error = a[i] - b[i];
        sum->error += (uint64_t)(error * error);
        sum->reference += (uint64_t)a[i] * a[i];
    }
}

/* Thesis (3.1). */
static double nmse(const sums *sum)
{
    if (sum->error == 0)
        return 0.0;
    return sum->reference == 0 ? INFINITY : (double)sum->error / (double)sum->reference;
}

static double psnr(const sums *sum, uint64_t object_pixels)
{
    if (sum->error == 0)
        return INFINITY;
    const double mean = (double)sum->error / (3.0 * (double)object_pixels);
    return 10.0 * log10(255.0 * 255.0 / mean);
}

static void note_pixel(const glint_image *a, const glint_image *b, size_t pixel,
                       glint_image_difference *difference)
{
    const int largest = pixel_difference(a->rgb + 3 * pixel, b->rgb + 3 * pixel);
    const bool mask_differs = a->object[pixel] != b->object[pixel];
    difference->differing_pixels += largest > 0;
    difference->mask_pixels += mask_differs;
    if (largest > difference->largest) {
        difference->largest = largest;
        difference->largest_x = (int)(pixel % (size_t)a->width);
        difference->largest_y = (int)(pixel / (size_t)a->width);
    }
    if ((largest > 0 || mask_differs) && difference->first_x < 0) {
        difference->first_x = (int)(pixel % (size_t)a->width);
        difference->first_y = (int)(pixel / (size_t)a->width);
    }
}

glint_status glint_image_compare(const glint_image *a, const glint_image *b,
                                 glint_image_difference *difference, glint_error *err)
{
    const glint_status status = check_sizes(a, b, err);
    if (status != GLINT_OK)
        return status;
    const size_t pixels = (size_t)a->width * (size_t)a->height;
    sums sum = {0, 0};
    *difference = (glint_image_difference){
        .pixels = pixels, .largest_x = -1, .largest_y = -1, .first_x = -1, .first_y = -1};
    for (size_t pixel = 0; pixel < pixels; pixel++) {
        note_pixel(a, b, pixel, difference);
        if (a->object[pixel] || b->object[pixel]) {
            difference->object_pixels++;
            add_pixel(a->rgb + 3 * pixel, b->rgb + 3 * pixel, &sum);
        }
    }
    difference->nmse = nmse(&sum);
    difference->psnr = psnr(&sum, difference->object_pixels);
    return GLINT_OK;
}

const char *glint_image_reading(double nmse)
{
    return nmse == 0.0       ? "equal"
           : nmse <= 0.0001  ? "no visible difference"
           : nmse <= 0.00025 ? "slight differences"
           : nmse <= 0.001   ? "visible differences"
                             : "substantially different";
}

/* The legend, which docs/frames.md repeats in words: the first row that a pixel's largest
 * difference reaches gives its colour. */
static const struct {
    int at_least;
    uint8_t color[3];
} legend[] = {
    {64, {255, 0, 0}},   /* red */
    {16, {255, 140, 0}}, /* orange */
    {4, {255, 230, 0}},  /* yellow */
    {2, {0, 220, 100}},  /* green */
    {1, {64, 128, 255}}, /* blue */
};

static const uint8_t mask_color[3] = {255, 0, 255}; /* magenta */

static void copy_color(const uint8_t from[3], uint8_t to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = from[i];
}

/* The reference in grey at half its brightness, so that the shape shows and no colour of the
 * legend is mistaken for it. */
static void dim(const uint8_t reference[3], uint8_t to[3])
{
    const int grey = (reference[0] + reference[1] + reference[2]) / 6;
    to[0] = to[1] = to[2] = (uint8_t)grey;
}

static void show_pixel(const glint_image *a, const glint_image *b, size_t pixel, uint8_t to[3])
{
    const int largest = pixel_difference(a->rgb + 3 * pixel, b->rgb + 3 * pixel);
    for (size_t i = 0; i < sizeof legend / sizeof legend[0]; i++) {
        if (largest >= legend[i].at_least) {
            copy_color(legend[i].color, to);
            return;
        }
    }
    if (a->object[pixel] != b->object[pixel])
        copy_color(mask_color, to);
    else
        dim(a->rgb + 3 * pixel, to);
}

int glint_image_difference_rank(const uint8_t rgb[3])
{
    const int colors = (int)(sizeof legend / sizeof legend[0]);
    for (int i = 0; i < colors; i++)
        if (memcmp(rgb, legend[i].color, 3) == 0)
            return colors - i + 1;
    return memcmp(rgb, mask_color, 3) == 0;
}

glint_status glint_image_difference_picture(const glint_image *a, const glint_image *b,
                                            glint_image **picture, glint_error *err)
{
    *picture = NULL;
    glint_status status = check_sizes(a, b, err);
    if (status == GLINT_OK)
        status = glint_image_create(a->width, a->height, picture, err);
    if (status != GLINT_OK)
        return status;
    const size_t pixels = (size_t)a->width * (size_t)a->height;
    for (size_t pixel = 0; pixel < pixels; pixel++) {
        show_pixel(a, b, pixel, (*picture)->rgb + 3 * pixel);
        (*picture)->object[pixel] = 1;
    }
    return GLINT_OK;
}
