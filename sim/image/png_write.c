/* A picture into a PNG file; see image.h. */
#include <errno.h>
#include <png.h>
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>

#include "file/new_file.h"
#include "image/image.h"

/* What libpng's callbacks reach. */
typedef struct writer {
    const char *path;
    const glint_image_control *control;
    FILE *stream;
    glint_error *err;
} writer;

static bool stopped(const glint_image_control *control)
{
    return control != NULL && control->stop != NULL && *control->stop;
}

/* libpng leaves the failing call through here and may not return. A write that waits for the reader
 * of a pipe fails when a signal arrives. */
static void give_up(png_structp png, png_const_charp message)
{
    const writer *to = png_get_error_ptr(png);
    if (!stopped(to->control))
        glint_fail(to->err, GLINT_IO_ERROR, "cannot write %.400s: %s", to->path, message);
    png_longjmp(png, 1);
}

static void ignore_warning(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

static void put_bytes(png_structp png, png_bytep bytes, size_t count)
{
    const writer *to = png_get_io_ptr(png);
    errno = 0;
    if (fwrite(bytes, 1, count, to->stream) != count)
        png_error(png, strerror(errno != 0 ? errno : EIO));
}

/* The stream is flushed once, when the caller closes it. */
static void flush_nothing(png_structp png)
{
    (void)png;
}

static void join_row(const glint_image *image, size_t y, png_bytep row)
{
    const size_t width = (size_t)image->width;
    const uint8_t *rgb = image->rgb + y * width * 3;
    const uint8_t *object = image->object + y * width;
    for (size_t x = 0; x < width; x++) {
        memcpy(row + 4 * x, rgb + 3 * x, 3);
        row[4 * x + 3] = object[x] ? 255 : 0;
    }
}

/* No variable here changes after setjmp(), so none is lost when libpng jumps back. */
static glint_status write_rows(const glint_image *image, const writer *to, png_structp png,
                               png_infop info, png_bytep row)
{
    if (setjmp(png_jmpbuf(png))) {
        return stopped(to->control) ? glint_fail(to->err, GLINT_INTERRUPTED, "interrupted")
                                    : GLINT_IO_ERROR;
    }
    png_set_IHDR(png, info, (png_uint_32)image->width, (png_uint_32)image->height, 8,
                 PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (int y = 0; y < image->height; y++) {
        if (stopped(to->control))
            return glint_fail(to->err, GLINT_INTERRUPTED, "interrupted");
        join_row(image, (size_t)y, row);
        png_write_row(png, row);
        if (to->control != NULL && to->control->progress != NULL)
            to->control->progress(to->control->context, (uint64_t)y + 1, (uint64_t)image->height);
    }
    png_write_end(png, info);
    return GLINT_OK;
}

static glint_status write_stream(const glint_image *image, writer *to)
{
    glint_status status = GLINT_NO_MEMORY;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, to, give_up, ignore_warning);
    png_infop info = png != NULL ? png_create_info_struct(png) : NULL;
    png_bytep row = malloc((size_t)image->width * 4);
    if (info != NULL && row != NULL) {
        png_set_write_fn(png, to, put_bytes, flush_nothing);
        status = write_rows(image, to, png, info, row);
    } else {
        glint_fail(to->err, status, "not enough memory to write %.400s", to->path);
    }
    free(row);
    png_destroy_write_struct(&png, &info);
    return status;
}

glint_status glint_image_write_png(const glint_image *image, const char *path, glint_error *err)
{
    return glint_image_write_png_until(image, path, NULL, err);
}

glint_status glint_image_print_png(const glint_image *image, FILE *stream, const char *path,
                                   const glint_image_control *control, glint_error *err)
{
    writer to = {.path = path, .control = control, .stream = stream, .err = err};
    return write_stream(image, &to);
}

glint_status glint_image_write_png_until(const glint_image *image, const char *path,
                                         const glint_image_control *control, glint_error *err)
{
    glint_new_file *file;
    glint_status status =
        glint_new_file_open_until(path, control != NULL ? control->stop : NULL, &file, err);
    if (status != GLINT_OK)
        return status;
    status = glint_image_print_png(image, glint_new_file_stream(file), path, control, err);
    if (status != GLINT_OK) {
        glint_new_file_discard(file);
        return status;
    }
    status = glint_new_file_commit(file, err);
    return status == GLINT_IO_ERROR && stopped(control)
               ? glint_fail(err, GLINT_INTERRUPTED, "interrupted")
               : status;
}
