/* Writes a packet under a temporary name and renames it when complete; reads one back. See
 * packet.h. */
#define _POSIX_C_SOURCE 200809L

#include "failure/packet.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "failure/json.h"
#include "failure/report.h"
#include "failure/wave.h"
#include "file/directory.h"
#include "file/new_file.h"
#include "file/temporary.h"

#define PATH      4096
#define DATA_MAX  (32L << 20) /* bytes of failure.json: twice the longest, of the widest pins */
#define CROP_SIDE 64
#define CROP_ZOOM 4

static const char *const file_names[] = {
    GLINT_PACKET_REPORT, GLINT_PACKET_DATA, GLINT_PACKET_WAVE,       GLINT_PACKET_SAVE_FILE,
    GLINT_PACKET_MODEL,  GLINT_PACKET_RTL,  GLINT_PACKET_DIFFERENCE, GLINT_PACKET_OLD_WAVE,
};
#define FILE_COUNT (sizeof file_names / sizeof file_names[0])

/* A packet in the making. */
typedef struct maker {
    const glint_failure *failure;
    const glint_packet_frames *frames;
    const char *directory; /* its name in the end */
    char beside[PATH];     /* and until then */
    const glint_capture *capture;
} maker;

static glint_status path_of(const char *directory, const char *name, char path[PATH],
                            glint_error *err)
{
    const int length = snprintf(path, PATH, "%s/%s", directory, name);
    if (length < 0 || length >= PATH)
        return glint_fail(err, GLINT_IO_ERROR, "the path is too long: %.200s…", directory);
    return GLINT_OK;
}

/* ---- The directory ------------------------------------------------------------------------------
 */

/* Removes a packet's files and the directory. */
static void remove_packet(const char *directory)
{
    char path[PATH];
    for (size_t i = 0; i < FILE_COUNT; i++)
        if (path_of(directory, file_names[i], path, NULL) == GLINT_OK)
            (void)unlink(path);
    (void)rmdir(directory);
}

static bool is_file_of_packet(const char *name)
{
    for (size_t i = 0; i < FILE_COUNT; i++)
        if (strcmp(file_names[i], name) == 0)
            return true;
    return strcmp(name, ".") == 0 || strcmp(name, "..") == 0;
}

/* Only an older packet may be replaced, and not through a link: its target would lose its files,
 * and a directory cannot be renamed over a link. */
static glint_status check_old(const char *directory, glint_error *err)
{
    struct stat found;
    if (lstat(directory, &found) == 0 && S_ISLNK(found.st_mode))
        return glint_fail(err, GLINT_IO_ERROR, "%s: not replaced, because it is a link", directory);
    DIR *old = opendir(directory);
    const struct dirent *entry;
    glint_status status = GLINT_OK;
    if (old == NULL && errno == ENOENT)
        return GLINT_OK;
    if (old == NULL)
        return glint_fail(err, GLINT_IO_ERROR, "%s: %s", directory, strerror(errno));
    while (status == GLINT_OK && (entry = readdir(old)) != NULL)
        if (!is_file_of_packet(entry->d_name))
            status = glint_fail(
                err, GLINT_IO_ERROR,
                "%s: not replaced, because it contains %.200s, which is not part of a packet",
                directory, entry->d_name);
    (void)closedir(old);
    return status;
}

/* Creates the temporary directory next to its final place. The name may exist: an earlier process
 * may have had the same number. */
static glint_status make_beside(maker *m, const char *bare, glint_error *err)
{
    for (int attempt = GLINT_TEMPORARY_PACKET; attempt < GLINT_TEMPORARY_PACKET + 100; attempt++) {
        char *beside = glint_temporary_name(bare, attempt);
        if (beside == NULL)
            return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a path");
        const int written = snprintf(m->beside, sizeof m->beside, "%s", beside);
        free(beside);
        if (written < 0 || (size_t)written >= sizeof m->beside)
            return glint_fail(err, GLINT_IO_ERROR, "the path is too long: %.200s…", m->directory);
        if (mkdir(m->beside, 0777) == 0)
            return GLINT_OK;
        if (errno != EEXIST)
            break;
    }
    return glint_fail(err, GLINT_IO_ERROR, "%s: cannot create this directory: %s", m->directory,
                      strerror(errno));
}

static glint_status begin(maker *m, glint_error *err)
{
    char bare[PATH], above[PATH];
    const int written = snprintf(bare, sizeof bare, "%s", m->directory);
    if (written < 0 || (size_t)written >= sizeof bare)
        return glint_fail(err, GLINT_IO_ERROR, "the path is too long: %.200s…", m->directory);
    for (size_t length = strlen(bare); length > 1 && bare[length - 1] == '/'; length--)
        bare[length - 1] = '\0';
    const char *slash = strrchr(bare, '/');
    /* Without the slash, unless that is all there is. */
    const int start = slash == NULL ? 0 : slash == bare ? 1 : (int)(slash - bare);
    (void)snprintf(above, sizeof above, "%.*s", start, bare);
    glint_status status = check_old(m->directory, err);
    if (status == GLINT_OK && start > 0)
        status = glint_directory_make(above, err);
    if (status != GLINT_OK)
        return status;
    glint_temporary_sweep(bare);
    return make_beside(m, bare, err);
}

static glint_status finish(const maker *m, glint_error *err)
{
    remove_packet(m->directory);
    if (rename(m->beside, m->directory) == 0)
        return GLINT_OK;
    return glint_fail(err, GLINT_IO_ERROR, "%s: cannot rename the packet to this: %s", m->directory,
                      strerror(errno));
}

/* ---- Its files ----------------------------------------------------------------------------------
 */

static glint_status write_report(const maker *m, glint_error *err)
{
    char path[PATH];
    glint_new_file *file;
    glint_status status = path_of(m->beside, GLINT_PACKET_REPORT, path, err);
    if (status == GLINT_OK)
        status = glint_new_file_open(path, &file, err);
    if (status != GLINT_OK)
        return status;
    glint_failure_report(glint_new_file_stream(file), m->failure, m->capture, m->directory);
    return glint_new_file_commit(file, err);
}

static glint_status write_data(const maker *m, glint_error *err)
{
    char path[PATH];
    glint_new_file *file;
    char *text = glint_failure_to_json(m->failure);
    if (text == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the text of a packet");
    glint_status status = path_of(m->beside, GLINT_PACKET_DATA, path, err);
    if (status == GLINT_OK)
        status = glint_new_file_open(path, &file, err);
    if (status == GLINT_OK) {
        fprintf(glint_new_file_stream(file), "%s\n", text);
        status = glint_new_file_commit(file, err);
    }
    free(text);
    return status;
}

static glint_status write_wave(const maker *m, glint_error *err)
{
    char wave[PATH], save_file[PATH];
    glint_status status = path_of(m->beside, GLINT_PACKET_WAVE, wave, err);
    if (status == GLINT_OK)
        status = path_of(m->beside, GLINT_PACKET_SAVE_FILE, save_file, err);
    if (status == GLINT_OK)
        status = glint_failure_write_wave(m->capture, wave, err);
    if (status == GLINT_OK)
        status = glint_failure_write_save_file(m->capture, wave, save_file, err);
    return status;
}

static glint_status write_picture(const maker *m, const glint_image *image, const char *name,
                                  glint_error *err)
{
    char path[PATH];
    const glint_status status = path_of(m->beside, name, path, err);
    return status == GLINT_OK ? glint_image_write_png(image, path, err) : status;
}

static glint_status write_crops(const maker *m, const glint_image *model, const glint_image *rtl,
                                glint_error *err)
{
    glint_image *difference = NULL;
    glint_status status = glint_image_difference_picture(model, rtl, &difference, err);
    if (status == GLINT_OK)
        status = write_picture(m, model, GLINT_PACKET_MODEL, err);
    if (status == GLINT_OK)
        status = write_picture(m, rtl, GLINT_PACKET_RTL, err);
    if (status == GLINT_OK)
        status = write_picture(m, difference, GLINT_PACKET_DIFFERENCE, err);
    glint_image_destroy(difference);
    return status;
}

static glint_status write_pictures(const maker *m, glint_error *err)
{
    const glint_failure_frame *frame = &m->failure->frame;
    glint_image *model = NULL, *rtl = NULL;
    glint_status status =
        glint_image_crop(m->frames->model, frame->x, frame->y, CROP_SIDE, CROP_ZOOM, &model, err);
    if (status == GLINT_OK)
        status =
            glint_image_crop(m->frames->rtl, frame->x, frame->y, CROP_SIDE, CROP_ZOOM, &rtl, err);
    if (status == GLINT_OK)
        status = write_crops(m, model, rtl, err);
    glint_image_destroy(model);
    glint_image_destroy(rtl);
    return status;
}

static glint_status write_files(const maker *m, glint_error *err)
{
    glint_status status = write_report(m, err);
    if (status == GLINT_OK)
        status = write_data(m, err);
    if (status == GLINT_OK && m->capture != NULL)
        status = write_wave(m, err);
    if (status == GLINT_OK && m->frames != NULL)
        status = write_pictures(m, err);
    return status;
}

glint_status glint_packet_write(const glint_failure *failure, const glint_packet_frames *frames,
                                const char *directory, glint_error *err)
{
    maker m = {
        .failure = failure, .frames = frames, .directory = directory, .capture = failure->capture};
    glint_failure_finding finding;
    glint_capture *played = NULL;
    glint_status status = GLINT_OK;
    if (m.capture == NULL && glint_failure_playable(failure)) {
        status = glint_failure_play(failure, NULL, &finding, &played, err);
        m.capture = played;
    }
    if (status == GLINT_OK)
        status = begin(&m, err);
    if (status == GLINT_OK) {
        status = write_files(&m, err);
        if (status == GLINT_OK)
            status = finish(&m, err);
        if (status != GLINT_OK)
            remove_packet(m.beside);
    }
    free(played);
    return status;
}

/* ---- Reading it ---------------------------------------------------------------------------------
 */

static glint_status read_text(FILE *file, const char *path, char **text, glint_error *err)
{
    char *read = malloc((size_t)DATA_MAX + 1);
    if (read == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the text of a packet");
    const size_t length = fread(read, 1, (size_t)DATA_MAX + 1, file);
    glint_status status = GLINT_OK;
    if (ferror(file))
        status = glint_fail(err, GLINT_IO_ERROR, "%s: %s", path, strerror(errno));
    else if (length > (size_t)DATA_MAX || memchr(read, '\0', length) != NULL)
        status = glint_fail(err, GLINT_BAD_INPUT, "%s: not the text of a packet", path);
    if (status != GLINT_OK) {
        free(read);
        return status;
    }
    read[length] = '\0';
    *text = read;
    return GLINT_OK;
}

/* A pipe or a device cannot belong to a packet and might block its reader, so it is opened without
 * blocking and rejected. */
static glint_status open_data(const char *path, FILE **file, glint_error *err)
{
    struct stat found;
    const int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    *file = NULL;
    if (descriptor < 0)
        return glint_fail(err, GLINT_IO_ERROR, "%s: %s", path, strerror(errno));
    const bool is_regular = fstat(descriptor, &found) == 0 && S_ISREG(found.st_mode);
    if (is_regular)
        *file = fdopen(descriptor, "rb");
    if (*file != NULL)
        return GLINT_OK;
    (void)close(descriptor);
    return glint_fail(err, GLINT_IO_ERROR, "%s: %s", path,
                      is_regular ? "cannot be opened" : "not a regular file");
}

glint_status glint_packet_read(const char *directory, const glint_circuit *extra,
                               glint_failure **failure, glint_error *err)
{
    char path[PATH];
    char *text = NULL;
    glint_error why;
    *failure = NULL;
    glint_status status = path_of(directory, GLINT_PACKET_DATA, path, err);
    if (status != GLINT_OK)
        return status;
    FILE *file;
    status = open_data(path, &file, err);
    if (status != GLINT_OK)
        return status;
    status = read_text(file, path, &text, err);
    (void)fclose(file);
    if (status != GLINT_OK)
        return status;
    status = glint_failure_from_json(text, extra, failure, &why);
    free(text);
    return status == GLINT_OK ? GLINT_OK : glint_fail(err, status, "%s: %s", path, why.text);
}
