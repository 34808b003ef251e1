/* Fuzz target: a picture file. One that is read must survive being written and read again. */
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "image/image.h"

/* Larger ones are not tried: most of the time would go into making room for them. */
#define SIDE_MAX 1024

static void expect_round_trip(const glint_image *image)
{
    glint_image *again, *picture;
    glint_image_difference difference;
    const char *path = fuzz_scratch("again.png");
    FUZZ_EXPECT(glint_image_write_png(image, path, NULL) == GLINT_OK);
    FUZZ_EXPECT(glint_image_read_png(path, &again, NULL) == GLINT_OK);
    FUZZ_EXPECT(glint_image_compare(image, again, &difference, NULL) == GLINT_OK);
    FUZZ_EXPECT(difference.differing_pixels == 0 && difference.mask_pixels == 0);
    FUZZ_EXPECT(glint_image_difference_picture(image, again, &picture, NULL) == GLINT_OK);
    glint_image_destroy(picture);
    glint_image_destroy(again);
}

/* The side that the file's first chunk gives, width or height; 0 when it is cut short. */
static uint32_t side_of(const uint8_t *bytes, size_t count, size_t at)
{
    return count < at + 4 ? 0
                          : (uint32_t)bytes[at] << 24 | (uint32_t)bytes[at + 1] << 16 |
                                (uint32_t)bytes[at + 2] << 8 | (uint32_t)bytes[at + 3];
}

int fuzz_png(const uint8_t *bytes, size_t count)
{
    glint_image *image;
    glint_error err = {""};
    const uint32_t width = side_of(bytes, count, 16), height = side_of(bytes, count, 20);
    if (width <= GLINT_IMAGE_SIDE_MAX && height <= GLINT_IMAGE_SIDE_MAX &&
        (width > SIDE_MAX || height > SIDE_MAX))
        return -1;
    const glint_status status =
        glint_image_read_png(fuzz_write("picture.png", bytes, count), &image, &err);
    FUZZ_EXPECT(status == GLINT_OK || status == GLINT_BAD_INPUT || status == GLINT_NO_MEMORY);
    FUZZ_EXPECT((status == GLINT_OK) == (image != NULL));
    if (status != GLINT_OK)
        FUZZ_EXPECT(strstr(err.text, "picture.png") != NULL && strchr(err.text, '\n') == NULL);
    else
        expect_round_trip(image);
    glint_image_destroy(image);
    return 0;
}
