/* Checks an output picture's name before the work starts, and writes the picture after it. */
#define _POSIX_C_SOURCE 200809L

#include "cli/picture.h"

#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/output.h"
#include "file/kind.h"

bool glint_picture_is_stdout(const char *path)
{
    return strcmp(path, "-") == 0;
}

static bool is_png_name(const char *path)
{
    const char *ending = strrchr(path, '.');
    return ending != NULL && strcasecmp(ending, ".png") == 0;
}

static bool is_no_file(const char *path)
{
    struct stat info;
    return stat(path, &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode);
}

glint_status glint_picture_check(const char *option, const char *path, bool force, glint_error *err)
{
    if (glint_picture_is_stdout(path)) {
        return isatty(STDOUT_FILENO) != 1 ? GLINT_OK
                                          : glint_fail(err, GLINT_BAD_ARGUMENT,
                                                       "--%s -: standard output is a terminal, "
                                                       "which cannot show a picture: redirect it",
                                                       option);
    }
    if (is_no_file(path))
        return GLINT_OK;
    if (!is_png_name(path)) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "--%s: %.400s: pictures are written as PNG: use a name ending in .png",
                          option, path);
    }
    glint_error why;
    return force || glint_file_replaceable(path, &why) == GLINT_OK
               ? GLINT_OK
               : glint_fail(err, GLINT_BAD_ARGUMENT, "--%s: %s", option, why.text);
}

static void show(void *context, uint64_t rows, uint64_t height)
{
    glint_progress_update(context, rows, height);
}

glint_status glint_picture_write(const char *command, const glint_image *image, const char *path,
                                 glint_error *err)
{
    glint_progress progress;
    const glint_image_control control = {glint_stop_flag(), show, &progress};
    glint_progress_begin(&progress, command, "rows of the picture");
    const glint_status status =
        glint_picture_is_stdout(path)
            ? glint_image_print_png(image, stdout, "standard output", &control, err)
            : glint_image_write_png_until(image, path, &control, err);
    glint_progress_end(&progress);
    return status;
}

FILE *glint_picture_talk(const char *path)
{
    return path != NULL && glint_picture_is_stdout(path) ? stderr : stdout;
}
