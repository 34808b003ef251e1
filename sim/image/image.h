/* An 8-bit RGB picture with a mask of the pixels that belong to the object, PNG in and out, and
 * the comparison of two pictures. */
#ifndef GLINT_SIM_IMAGE_IMAGE_H
#define GLINT_SIM_IMAGE_IMAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "glint_status.h"

#define GLINT_IMAGE_SIDE_MAX 16384

typedef struct glint_image {
    int width, height; /* 1…GLINT_IMAGE_SIDE_MAX */
    uint8_t *rgb;      /* width·height·3, rows top to bottom, R G B R G B … */
    uint8_t *object;   /* width·height, 1 where the object covers the pixel, else 0 */
} glint_image;

/* All pixels 0, object mask 0. */
glint_status glint_image_create(int width, int height, glint_image **image, glint_error *err);
void glint_image_destroy(glint_image *image); /* NULL is allowed */

/* Writes an RGBA PNG: alpha 255 where the object is, 0 on the background, so that the mask travels
 * with the picture. Written beside the target, then renamed: never a half-written file. */
glint_status glint_image_write_png(const glint_image *image, const char *path, glint_error *err);

/* Optional controls for writing a large picture. */
typedef struct glint_image_control {
    const volatile bool *stop; /* aborts with GLINT_INTERRUPTED when true */
    void (*progress)(void *context, uint64_t rows, uint64_t height); /* after each row */
    void *context;
} glint_image_control;

/* The same; control may be NULL. Of 16384x16384 it takes half a minute. */
glint_status glint_image_write_png_until(const glint_image *image, const char *path,
                                         const glint_image_control *control, glint_error *err);

/* The same to a stream that the caller flushes and closes; path: for error messages. */
glint_status glint_image_print_png(const glint_image *image, FILE *stream, const char *path,
                                   const glint_image_control *control, glint_error *err);

/* Reads any PNG that libpng reads: grey becomes R = G = B, palettes and fewer bits are expanded, 16
 * bits are rounded to 8; no gamma or colour profile is applied, and alpha does not change the
 * colours. The object is where alpha is above 0; a picture without alpha is all object.
 * GLINT_BAD_INPUT for a file that is not a complete PNG or has a side above
 * GLINT_IMAGE_SIDE_MAX. */
glint_status glint_image_read_png(const char *path, glint_image **image, glint_error *err);

/* The same, given up with GLINT_INTERRUPTED when *stop becomes true; stop may be NULL. */
glint_status glint_image_read_png_until(const char *path, const volatile bool *stop,
                                        glint_image **image, glint_error *err);

/* The square of side × side pixels centred on (x, y), shifted to stay inside the picture and cut to
 * its size; each pixel becomes factor × factor pixels. */
glint_status glint_image_crop(const glint_image *image, int x, int y, int side, int factor,
                              glint_image **crop, glint_error *err);

/* How two pictures of one size differ, from the reference a to b. */
typedef struct glint_image_difference {
    uint64_t pixels;           /* compared: all of the frame */
    uint64_t object_pixels;    /* of these, the object's in either: nmse and psnr are over these */
    uint64_t differing_pixels; /* with any component unequal, over the frame */
    uint64_t mask_pixels;      /* the object's in one picture only */
    int largest;               /* largest difference of one component, 0…255 */
    int largest_x, largest_y;  /* the first pixel with it; -1 when there is no difference */
    int first_x, first_y;      /* the first pixel, row by row, of differing_pixels or mask_pixels;
                                  -1 when the pictures are equal */
    double nmse; /* thesis (3.1); 0 when equal; INFINITY if the reference is black and b is not */
    double psnr; /* dB, peak 255; INFINITY when equal */
} glint_image_difference;

/* GLINT_BAD_INPUT when the sizes differ. */
glint_status glint_image_compare(const glint_image *a, const glint_image *b,
                                 glint_image_difference *difference, glint_error *err);

/* The thesis's reading of an NMSE (section 3.4): "no visible difference", … */
const char *glint_image_reading(double nmse);

/* A picture of where and by how much they differ; legend in docs/frames.md, "Comparing frames". Its
 * object mask is 1 everywhere, so that a difference on the background is seen too. */
glint_status glint_image_difference_picture(const glint_image *a, const glint_image *b,
                                            glint_image **picture, glint_error *err);

/* How much of a difference a colour of that picture stands for, larger for more; 0: none. */
int glint_image_difference_rank(const uint8_t rgb[3]);

#endif
