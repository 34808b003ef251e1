/* A picture out of a PNG file; see image.h. */
#include <errno.h>
#include <png.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "image/image.h"

/* What libpng's callbacks reach, and what must be released after they have jumped out. */
typedef struct reader {
    const char *path;
    const volatile bool *stop; /* may be NULL */
    FILE *stream;
    glint_status status; /* why the reading failed */
    glint_error *err;
    glint_image *image;
    png_bytep rgba; /* the whole picture: interlaced ones come in several passes */
    png_bytepp rows;
} reader;

/* libpng leaves the failing call through here and may not return. */
static void give_up(png_structp png, png_const_charp message)
{
    reader *from = png_get_error_ptr(png);
    if (from->status == GLINT_OK) {
        from->status = glint_fail(from->err, GLINT_BAD_INPUT, "%.400s: not a readable PNG: %s",
                                  from->path, message);
    }
    png_longjmp(png, 1);
}

static void ignore_warning(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

static void check_stop(png_structp png, reader *from)
{
    if (from->stop != NULL && *from->stop) {
        from->status = glint_fail(from->err, GLINT_INTERRUPTED, "interrupted");
        png_error(png, "interrupted");
    }
}

static void get_bytes(png_structp png, png_bytep bytes, size_t count)
{
    reader *from = png_get_io_ptr(png);
    errno = 0;
    const bool whole = fread(bytes, 1, count, from->stream) == count;
    check_stop(png, from);
    if (whole)
        return;
    if (ferror(from->stream)) {
        from->status = glint_fail(from->err, GLINT_IO_ERROR, "cannot read %.400s: %s", from->path,
                                  strerror(errno != 0 ? errno : EIO));
    }
    png_error(png, "the file ends early");
}

static void check_size(png_structp png, png_infop info, reader *from)
{
    const png_uint_32 width = png_get_image_width(png, info);
    const png_uint_32 height = png_get_image_height(png, info);
    if (width > GLINT_IMAGE_SIDE_MAX || height > GLINT_IMAGE_SIDE_MAX) {
        from->status = glint_fail(
            from->err, GLINT_BAD_INPUT, "%.400s: %lux%lu is too large: each side may be at most %d",
            from->path, (unsigned long)width, (unsigned long)height, GLINT_IMAGE_SIDE_MAX);
        png_error(png, "too large");
    }
}

/* Converts any file to rows of 8-bit R G B A. Returns the number of passes. */
static int ask_for_rgba(png_structp png, png_infop info)
{
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
    const int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    return passes;
}

static void make_room(png_structp png, png_infop info, reader *from)
{
    const png_uint_32 width = png_get_image_width(png, info);
    const png_uint_32 height = png_get_image_height(png, info);
    from->status = glint_image_create((int)width, (int)height, &from->image, from->err);
    if (from->status != GLINT_OK)
        png_error(png, "no room");
    from->rgba = calloc(height, (size_t)width * 4);
    from->rows = calloc(height, sizeof *from->rows);
    if (from->rgba == NULL || from->rows == NULL) {
        from->status =
            glint_fail(from->err, GLINT_NO_MEMORY, "%.400s: not enough memory for %lux%lu pixels",
                       from->path, (unsigned long)width, (unsigned long)height);
        png_error(png, "out of memory");
    }
    for (png_uint_32 y = 0; y < height; y++)
        from->rows[y] = from->rgba + (size_t)y * width * 4;
}

static void read_passes(png_structp png, png_infop info, int passes, reader *from)
{
    const png_uint_32 height = png_get_image_height(png, info);
    for (int pass = 0; pass < passes; pass++) {
        for (png_uint_32 y = 0; y < height; y++) {
            check_stop(png, from);
            png_read_row(png, from->rows[y], NULL);
        }
    }
}

/* No variable here changes after setjmp(), so none is lost when libpng jumps back. */
static void read_rows(png_structp png, png_infop info, reader *from)
{
    if (setjmp(png_jmpbuf(png)))
        return;
    png_set_read_fn(png, from, get_bytes);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX); /* check_size() says it better */
    /* Chunks that no pixel depends on are not read: libpng clears as much memory as such a chunk
     * claims to need, up to 2 GB. */
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, NULL, -1);
    png_read_info(png, info);
    check_size(png, info, from);
    const int passes = ask_for_rgba(png, info);
    make_room(png, info, from);
    read_passes(png, info, passes, from);
    png_read_end(png, NULL);
}

static void split_rgba(const reader *from)
{
    glint_image *image = from->image;
    const size_t pixels = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < pixels; i++) {
        memcpy(image->rgb + 3 * i, from->rgba + 4 * i, 3);
        image->object[i] = from->rgba[4 * i + 3] > 0;
    }
}

static void read_stream(reader *from)
{
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, from, give_up, ignore_warning);
    png_infop info = png != NULL ? png_create_info_struct(png) : NULL;
    if (info != NULL) {
        read_rows(png, info, from);
    } else {
        from->status =
            glint_fail(from->err, GLINT_NO_MEMORY, "not enough memory to read %.400s", from->path);
    }
    png_destroy_read_struct(&png, &info, NULL);
}

glint_status glint_image_read_png(const char *path, glint_image **image, glint_error *err)
{
    return glint_image_read_png_until(path, NULL, image, err);
}

glint_status glint_image_read_png_until(const char *path, const volatile bool *stop,
                                        glint_image **image, glint_error *err)
{
    *image = NULL;
    reader from = {
        .path = path, .stop = stop, .stream = fopen(path, "rb"), .status = GLINT_OK, .err = err};
    if (from.stream == NULL && errno == EINTR && stop != NULL && *stop)
        return glint_fail(err, GLINT_INTERRUPTED, "interrupted");
    if (from.stream == NULL)
        return glint_fail(err, GLINT_IO_ERROR, "cannot read %.400s: %s", path, strerror(errno));
    read_stream(&from);
    fclose(from.stream);
    if (from.status == GLINT_OK) {
        split_rgba(&from);
        *image = from.image;
    } else {
        glint_image_destroy(from.image);
    }
    free(from.rows);
    free(from.rgba);
    return from.status;
}
