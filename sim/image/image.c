/* The picture itself: creation and destruction; see image.h. */
#include "image/image.h"

#include <stdlib.h>

glint_status glint_image_create(int width, int height, glint_image **image, glint_error *err)
{
    *image = NULL;
    if (width < 1 || width > GLINT_IMAGE_SIDE_MAX || height < 1 || height > GLINT_IMAGE_SIDE_MAX) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "a picture of %dx%d: each side must be from 1 to %d", width, height,
                          GLINT_IMAGE_SIDE_MAX);
    }
    const size_t pixels = (size_t)width * (size_t)height;
    glint_image *made = calloc(1, sizeof *made);
    if (made != NULL) {
        made->width = width;
        made->height = height;
        made->rgb = calloc(pixels, 3);
        made->object = calloc(pixels, 1);
    }
    if (made == NULL || made->rgb == NULL || made->object == NULL) {
        glint_image_destroy(made);
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a picture of %dx%d", width,
                          height);
    }
    *image = made;
    return GLINT_OK;
}

void glint_image_destroy(glint_image *image)
{
    if (image == NULL)
        return;
    free(image->rgb);
    free(image->object);
    free(image);
}
