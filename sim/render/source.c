/* assimp's file interface over checked, in-memory files; see source.h. */
#define _DEFAULT_SOURCE

#include "render/source.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "render/gltf.h"
#include "render/plain.h"

struct glint_source {
    struct aiFileIO io; /* first: assimp hands its address back */
    const char *path;
    glint_bytes plain; /* what assimp gets in the file's place; empty: the file */
    char refused[256];
};

/* A file that assimp has open; its bytes are in memory, or else to be read. */
typedef struct open_file {
    struct aiFile file; /* first: assimp hands its address back */
    const char *bytes;
    int descriptor; /* where there are no bytes */
    size_t size, at;
} open_file;

/* ---- Files as assimp uses them ------------------------------------------------------------------
 */

static open_file *file_of(struct aiFile *file)
{
    return (open_file *)(void *)file;
}

/* Returns the number of bytes read. */
static size_t read_bytes(open_file *from, char *to, size_t count)
{
    if (from->bytes != NULL) {
        memcpy(to, from->bytes + from->at, count);
        return count;
    }
    size_t got = 0;
    while (got < count) {
        const ssize_t more =
            pread(from->descriptor, to + got, count - got, (off_t)(from->at + got));
        if (more == 0 || (more < 0 && errno != EINTR))
            break;
        got += more > 0 ? (size_t)more : 0;
    }
    return got;
}

/* Like fread(): returns the number of whole items. */
static size_t read_items(struct aiFile *file, char *to, size_t size, size_t count)
{
    open_file *from = file_of(file);
    const size_t left = size > 0 ? (from->size - from->at) / size : 0;
    const size_t items = count < left ? count : left;
    const size_t got = read_bytes(from, to, items * size);
    from->at += got;
    return size > 0 ? got / size : 0;
}

static size_t tell(struct aiFile *file)
{
    return file_of(file)->at;
}

static size_t tell_size(struct aiFile *file)
{
    return file_of(file)->size;
}

static enum aiReturn seek(struct aiFile *file, size_t offset, enum aiOrigin origin)
{
    open_file *in = file_of(file);
    const size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? in->at : in->size;
    const size_t to = base + offset; /* a negative one comes as its complement */
    if (to > in->size)
        return aiReturn_FAILURE;
    in->at = to;
    return aiReturn_SUCCESS;
}

static size_t write_nothing(struct aiFile *file, const char *from, size_t size, size_t count)
{
    (void)file;
    (void)from;
    (void)size;
    (void)count;
    return 0;
}

static void flush_nothing(struct aiFile *file)
{
    (void)file;
}

/* A regular file's descriptor, or -1. Opening never blocks. */
static int open_regular(const char *path, struct stat *info)
{
    const int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor >= 0 && (fstat(descriptor, info) != 0 || !S_ISREG(info->st_mode))) {
        (void)close(descriptor);
        return -1;
    }
    return descriptor;
}

static void note_refusal(glint_source *source, const char *path)
{
    struct stat info;
    if (source->refused[0] == '\0' && stat(path, &info) == 0 && !S_ISREG(info.st_mode) &&
        !S_ISDIR(info.st_mode))
        strncpy(source->refused, path, sizeof source->refused - 1);
}

static struct aiFile *open_for_assimp(struct aiFileIO *io, const char *path, const char *mode)
{
    glint_source *source = (glint_source *)(void *)io;
    struct stat info = {0};
    const bool plain = source->plain.at != NULL && strcmp(path, source->path) == 0;
    const int descriptor = plain || mode[0] != 'r' ? -1 : open_regular(path, &info);
    open_file *opened = plain || descriptor >= 0 ? calloc(1, sizeof *opened) : NULL;
    if (opened == NULL) {
        note_refusal(source, path);
        if (descriptor >= 0)
            (void)close(descriptor);
        return NULL;
    }
    opened->file =
        (struct aiFile){read_items, write_nothing, tell, tell_size, seek, flush_nothing, NULL};
    opened->bytes = plain ? source->plain.at : NULL;
    opened->descriptor = descriptor;
    opened->size = plain ? source->plain.count : (size_t)info.st_size;
    return &opened->file;
}

static void close_for_assimp(struct aiFileIO *io, struct aiFile *file)
{
    (void)io;
    open_file *closed = file_of(file);
    if (closed->descriptor >= 0)
        (void)close(closed->descriptor);
    free(closed);
}

/* ---- What is looked through first ---------------------------------------------------------------
 */

typedef glint_status looking(const glint_text *text, glint_bytes *plain, glint_remarks *remarks,
                             glint_error *err);

static bool begins_as_ply(const glint_text *text)
{
    return text->length > 3 && memcmp(text->at, "ply", 3) == 0 &&
           (text->at[3] == '\n' || text->at[3] == '\r');
}

/* NULL: a format passed to assimp unchanged. */
static looking *look_for(const glint_text *text)
{
    static const struct {
        const char *ending;
        looking *look;
    } by_ending[] = {{".obj", glint_plain_obj},  {".stl", glint_plain_stl},
                     {".ply", glint_plain_ply},  {".gltf", glint_gltf_check},
                     {".glb", glint_gltf_check}, {".vrm", glint_gltf_check}};
    const char *ending = strrchr(text->path, '.');
    for (size_t i = 0; ending != NULL && i < sizeof by_ending / sizeof by_ending[0]; i++)
        if (strcasecmp(ending, by_ending[i].ending) == 0)
            return by_ending[i].look;
    return begins_as_ply(text) ? glint_plain_ply : NULL;
}

static glint_status look_through(glint_source *source, const struct stat *info, int descriptor,
                                 glint_remarks *remarks, glint_error *err)
{
    const size_t length = (size_t)info->st_size;
    void *bytes = mmap(NULL, length, PROT_READ, MAP_PRIVATE, descriptor, 0);
    if (bytes == MAP_FAILED) {
        return errno == ENOMEM ? glint_fail(err, GLINT_NO_MEMORY,
                                            "%.300s: not enough memory to read it", source->path)
                               : glint_fail(err, GLINT_IO_ERROR, "%.300s: cannot read it: %s",
                                            source->path, strerror(errno));
    }
    const glint_text text = {source->path, bytes, length};
    looking *look = look_for(&text);
    const glint_status status = look != NULL ? look(&text, &source->plain, remarks, err) : GLINT_OK;
    (void)munmap(bytes, length);
    return status;
}

glint_status glint_source_open(const char *path, glint_source **source, glint_remarks *remarks,
                               glint_error *err)
{
    struct stat info;
    *source = NULL;
    const int descriptor = open_regular(path, &info);
    if (descriptor < 0)
        return glint_fail(err, GLINT_IO_ERROR, "%.300s: cannot read it", path);
    if (info.st_size == 0) {
        (void)close(descriptor);
        return glint_fail(err, GLINT_BAD_INPUT, "%.300s: empty file", path);
    }
    glint_source *made = calloc(1, sizeof *made);
    glint_status status = GLINT_NO_MEMORY;
    if (made != NULL) {
        made->io = (struct aiFileIO){open_for_assimp, close_for_assimp, NULL};
        made->path = path;
        status = look_through(made, &info, descriptor, remarks, err);
    } else {
        (void)glint_fail(err, status, "%.300s: no memory", path);
    }
    (void)close(descriptor);
    if (status != GLINT_OK) {
        glint_source_close(made);
        return status;
    }
    *source = made;
    return GLINT_OK;
}

struct aiFileIO *glint_source_io(glint_source *source)
{
    return &source->io;
}

const char *glint_source_refused(const glint_source *source)
{
    return source->refused;
}

void glint_source_close(glint_source *source)
{
    if (source != NULL) {
        glint_bytes_free(&source->plain);
        free(source);
    }
}
