/* Cuts a square out of a picture and enlarges it, for the close-ups in failure packets. */
#include <string.h>

#include "image/image.h"

static int held(int value, int max)
{
    return value < 0 ? 0 : value > max ? max : value;
}

glint_status glint_image_crop(const glint_image *image, int x, int y, int side, int factor,
                              glint_image **crop, glint_error *err)
{
    const int width = side < image->width ? side : image->width;
    const int height = side < image->height ? side : image->height;
    const int left = held(x - width / 2, image->width - width);
    const int top = held(y - height / 2, image->height - height);
    const glint_status status = glint_image_create(width * factor, height * factor, crop, err);
    if (status != GLINT_OK)
        return status;
    for (int row = 0; row < height * factor; row++)
        for (int column = 0; column < width * factor; column++) {
            const size_t to = (size_t)row * (size_t)(width * factor) + (size_t)column;
            const size_t from = (size_t)(top + row / factor) * (size_t)image->width +
                                (size_t)(left + column / factor);
            memcpy(&(*crop)->rgb[3 * to], &image->rgb[3 * from], 3);
            (*crop)->object[to] = image->object[from];
        }
    return GLINT_OK;
}
