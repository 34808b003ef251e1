/* PNG files out and in: pictures survive the round trip, other kinds of PNG are understood, broken
 * ones are rejected with a reason. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/resource.h>

#include <cmocka.h>
#include <png.h>

#include "../scratch.h"
#include "image/image.h"

/* A picture with every kind of pixel: any colour, also on the background. */
static glint_image *make_picture(int width, int height)
{
    glint_image *image;
    glint_error err;
    assert_int_equal(glint_image_create(width, height, &image, &err), GLINT_OK);
    uint32_t random = 1;
    for (size_t i = 0; i < (size_t)width * (size_t)height; i++) {
        for (int c = 0; c < 3; c++) {
            random = random * 1664525u + 1013904223u;
            image->rgb[3 * i + (size_t)c] = (uint8_t)(random >> 24);
        }
        image->object[i] = (random >> 23) & 1;
    }
    return image;
}

static void assert_same(const glint_image *a, const glint_image *b)
{
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    const size_t pixels = (size_t)a->width * (size_t)a->height;
    assert_memory_equal(a->rgb, b->rgb, 3 * pixels);
    assert_memory_equal(a->object, b->object, pixels);
}

static void what_is_written_comes_back(void **state)
{
    (void)state;
    static const int sizes[][2] = {{1, 1}, {1, 7}, {13, 1}, {64, 48}, {257, 3}};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        glint_error err;
        glint_image *back;
        glint_image *image = make_picture(sizes[i][0], sizes[i][1]);
        assert_int_equal(glint_image_write_png(image, scratch_path("a.png"), &err), GLINT_OK);
        assert_int_equal(glint_image_read_png(scratch_path("a.png"), &back, &err), GLINT_OK);
        assert_same(image, back);
        glint_image_destroy(image);
        glint_image_destroy(back);
    }
}

/* One kind of PNG that Glint does not write itself. */
typedef struct foreign {
    int width, height, depth, color_type, interlace;
    int transparent_grey; /* -1: no tRNS chunk */
    const uint8_t *rows;  /* as the file has them, packed */
    size_t row_bytes;
} foreign;

static const png_color palette[4] = {{10, 20, 30}, {40, 50, 60}, {70, 80, 90}, {255, 254, 253}};

/* Through libpng alone: an error of it aborts, which is right for a test. */
static void write_foreign(const char *path, const foreign *kind)
{
    FILE *stream = fopen(path, "wb");
    assert_non_null(stream);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, stream);
    png_set_IHDR(png, info, (png_uint_32)kind->width, (png_uint_32)kind->height, kind->depth,
                 kind->color_type, kind->interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (kind->color_type == PNG_COLOR_TYPE_PALETTE)
        png_set_PLTE(png, info, palette, 4);
    if (kind->transparent_grey >= 0) {
        const png_color_16 transparent = {.gray = (png_uint_16)kind->transparent_grey};
        png_set_tRNS(png, info, NULL, 0, &transparent);
    }
    png_write_info(png, info);
    const int passes = png_set_interlace_handling(png);
    for (int pass = 0; pass < passes; pass++)
        for (int y = 0; y < kind->height; y++)
            png_write_row(png, kind->rows + (size_t)y * kind->row_bytes);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    assert_int_equal(fclose(stream), 0);
}

static void assert_reads_as(const foreign *kind, const uint8_t *rgb, const uint8_t *object)
{
    glint_error err;
    glint_image *image;
    write_foreign(scratch_path("foreign.png"), kind);
    assert_int_equal(glint_image_read_png(scratch_path("foreign.png"), &image, &err), GLINT_OK);
    const size_t pixels = (size_t)kind->width * (size_t)kind->height;
    assert_int_equal(image->width, kind->width);
    assert_int_equal(image->height, kind->height);
    assert_memory_equal(image->rgb, rgb, 3 * pixels);
    assert_memory_equal(image->object, object, pixels);
    glint_image_destroy(image);
}

static void rgb_is_all_object(void **state)
{
    (void)state;
    const uint8_t rows[] = {1, 2, 3, 250, 251, 252};
    const foreign kind = {2, 1, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, -1, rows, 6};
    assert_reads_as(&kind, rows, (const uint8_t[]){1, 1});
}

static void any_alpha_above_zero_is_object(void **state)
{
    (void)state;
    const uint8_t rows[] = {9, 8, 7, 0, 6, 5, 4, 1, 3, 2, 1, 255};
    const foreign kind = {3, 1, 8, PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE, -1, rows, 12};
    assert_reads_as(&kind, (const uint8_t[]){9, 8, 7, 6, 5, 4, 3, 2, 1},
                    (const uint8_t[]){0, 1, 1});
}

static void grey_with_a_transparent_value(void **state)
{
    (void)state;
    const uint8_t rows[] = {0, 77, 255};
    const foreign kind = {3, 1, 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, 77, rows, 3};
    assert_reads_as(&kind, (const uint8_t[]){0, 0, 0, 77, 77, 77, 255, 255, 255},
                    (const uint8_t[]){1, 0, 1});
}

static void one_bit_grey(void **state)
{
    (void)state;
    const uint8_t rows[] = {0xa0};
    const foreign kind = {3, 1, 1, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, -1, rows, 1};
    assert_reads_as(&kind, (const uint8_t[]){255, 255, 255, 0, 0, 0, 255, 255, 255},
                    (const uint8_t[]){1, 1, 1});
}

static void two_bit_palette(void **state)
{
    (void)state;
    const uint8_t rows[] = {0x1b};
    const foreign kind = {4, 1, 2, PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE, -1, rows, 1};
    assert_reads_as(&kind, (const uint8_t[]){10, 20, 30, 40, 50, 60, 70, 80, 90, 255, 254, 253},
                    (const uint8_t[]){1, 1, 1, 1});
}

static void sixteen_bits_are_rounded(void **state)
{
    (void)state;
    /* 0x0081 is 0.502 of an 8-bit step of 257, 0x0080 is 0.498. */
    const uint8_t rows[] = {0x00, 0x80, 0x00, 0x81, 0xff, 0xff};
    const foreign kind = {1, 1, 16, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, -1, rows, 6};
    assert_reads_as(&kind, (const uint8_t[]){0, 1, 255}, (const uint8_t[]){1});
}

static void interlaced(void **state)
{
    (void)state;
    uint8_t rows[9 * 11 * 3];
    uint8_t object[9 * 11];
    for (size_t i = 0; i < sizeof rows; i++)
        rows[i] = (uint8_t)(i * 37);
    memset(object, 1, sizeof object);
    const foreign kind = {9, 11, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_ADAM7, -1, rows, 27};
    assert_reads_as(&kind, rows, object);
}

static void assert_refused(const char *path, glint_status status, const char *reason)
{
    glint_error err;
    glint_image *image;
    assert_int_equal(glint_image_read_png(path, &image, &err), status);
    assert_null(image);
    assert_non_null(strstr(err.text, path));
    if (strstr(err.text, reason) == NULL)
        fail_msg("\"%s\" does not say \"%s\"", err.text, reason);
}

static void every_truncation_is_refused(void **state)
{
    (void)state;
    glint_error err;
    glint_image *image = make_picture(20, 20);
    assert_int_equal(glint_image_write_png(image, scratch_path("whole.png"), &err), GLINT_OK);
    glint_image_destroy(image);
    size_t count;
    char *bytes = scratch_read(scratch_path("whole.png"), &count);
    assert_true(count > 100);
    for (size_t kept = 0; kept < count; kept++) {
        scratch_write(scratch_path("cut.png"), bytes, kept);
        assert_refused(scratch_path("cut.png"), GLINT_BAD_INPUT, "the file ends early");
    }
    free(bytes);
}

static void a_flipped_bit_is_refused(void **state)
{
    (void)state;
    glint_error err;
    glint_image *image = make_picture(20, 20);
    assert_int_equal(glint_image_write_png(image, scratch_path("whole.png"), &err), GLINT_OK);
    glint_image_destroy(image);
    size_t count;
    char *bytes = scratch_read(scratch_path("whole.png"), &count);
    bytes[count / 2] ^= 1;
    scratch_write(scratch_path("flipped.png"), bytes, count);
    free(bytes);
    assert_refused(scratch_path("flipped.png"), GLINT_BAD_INPUT, "not a readable PNG");
}

static void what_is_no_png_is_refused(void **state)
{
    (void)state;
    scratch_write(scratch_path("text.png"), "P6 1 1 255 abc", 14);
    assert_refused(scratch_path("text.png"), GLINT_BAD_INPUT, "Not a PNG file");
    assert_refused(scratch_path("missing.png"), GLINT_IO_ERROR, "No such file or directory");
    assert_refused(scratch_path("."), GLINT_IO_ERROR, "Is a directory");
}

static void too_large_a_side_is_refused(void **state)
{
    (void)state;
    static uint8_t row[3 * (GLINT_IMAGE_SIDE_MAX + 1)];
    const foreign kind = {GLINT_IMAGE_SIDE_MAX + 1, 1,  8,   PNG_COLOR_TYPE_RGB,
                          PNG_INTERLACE_NONE,       -1, row, sizeof row};
    write_foreign(scratch_path("wide.png"), &kind);
    assert_refused(scratch_path("wide.png"), GLINT_BAD_INPUT, "16385x1 is too large");
}

/* 44 bytes whose text claims to be 2 GB long. */
static void a_chunk_takes_no_memory_that_it_only_claims(void **state)
{
    (void)state;
    static const uint8_t bytes[] =
        "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x10\0\0\0\x10\x08\x06\0\0\0\x1f\xf3\xff\x61"
        "\x7f\xff\xff\xfftEXtabc";
    struct rusage before, after;
    scratch_write(scratch_path("claims.png"), bytes, sizeof bytes - 1);
    assert_int_equal(getrusage(RUSAGE_SELF, &before), 0);
    assert_refused(scratch_path("claims.png"), GLINT_BAD_INPUT, "the file ends early");
    assert_int_equal(getrusage(RUSAGE_SELF, &after), 0);
    assert_true(after.ru_maxrss - before.ru_maxrss < 200000); /* kilobytes */
}

static void a_failed_write_leaves_nothing(void **state)
{
    (void)state;
    glint_error err;
    glint_image *image = make_picture(300, 300); /* more than one buffer of the stream */
    const int before = scratch_count();
    assert_int_equal(glint_image_write_png(image, scratch_path("no/a.png"), &err), GLINT_IO_ERROR);
    assert_int_equal(scratch_count(), before);
    assert_int_equal(glint_image_write_png(image, "/dev/full", &err), GLINT_IO_ERROR);
    assert_string_equal(err.text, "cannot write /dev/full: No space left on device");
    glint_image_destroy(image);
}

static void sizes_are_checked(void **state)
{
    (void)state;
    static const int sizes[][2] = {{0, 1}, {1, 0}, {-1, 1}, {GLINT_IMAGE_SIDE_MAX + 1, 1}};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        glint_error err;
        glint_image *image;
        assert_int_equal(glint_image_create(sizes[i][0], sizes[i][1], &image, &err),
                         GLINT_BAD_ARGUMENT);
        assert_null(image);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_comes_back),
        cmocka_unit_test(rgb_is_all_object),
        cmocka_unit_test(any_alpha_above_zero_is_object),
        cmocka_unit_test(grey_with_a_transparent_value),
        cmocka_unit_test(one_bit_grey),
        cmocka_unit_test(two_bit_palette),
        cmocka_unit_test(sixteen_bits_are_rounded),
        cmocka_unit_test(interlaced),
        cmocka_unit_test(every_truncation_is_refused),
        cmocka_unit_test(a_flipped_bit_is_refused),
        cmocka_unit_test(what_is_no_png_is_refused),
        cmocka_unit_test(too_large_a_side_is_refused),
        cmocka_unit_test(a_chunk_takes_no_memory_that_it_only_claims),
        cmocka_unit_test(a_failed_write_leaves_nothing),
        cmocka_unit_test(sizes_are_checked),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
