/* What the readers of smoothing groups share; see groups.h. */
#include "render/groups.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A file's first bytes, enough to tell its format. */
#define BEGIN_BYTES 64

glint_groups_object *glint_groups_add_object(glint_groups *file)
{
    glint_groups_object *object = realloc(file->object, (file->objects + 1) * sizeof *file->object);
    if (object == NULL)
        return NULL;
    file->object = object;
    object[file->objects] = (glint_groups_object){0, NULL};
    return &object[file->objects++];
}

bool glint_groups_add_faces(glint_groups_object *object, size_t faces)
{
    uint32_t *group = realloc(object->group, (object->faces + faces + 1) * sizeof *group);
    if (group == NULL)
        return false;
    memset(group + object->faces, 0, faces * sizeof *group);
    object->group = group;
    object->faces += faces;
    return true;
}

/* Converts UTF-16 with a byte order mark to plain text; non-ASCII characters, which occur only in
 * names, become '?'. */
static void make_plain(glint_groups *file)
{
    const uint8_t *from = file->bytes;
    if (file->count < 2 || from[0] + from[1] != 0xff + 0xfe || from[0] < 0xfe)
        return;
    const size_t low = from[0] == 0xff ? 0 : 1, count = file->count / 2 - 1;
    for (size_t i = 0; i < count; i++) {
        const uint8_t *unit = &from[2 * i + 2];
        file->bytes[i] = unit[1 - low] == 0 && unit[low] < 0x80 ? unit[low] : '?';
    }
    file->count = count;
    file->bytes[count] = 0;
}

/* The first `most` bytes of the stream, or all of them. */
static bool read_bytes(FILE *stream, size_t most, glint_groups *file)
{
    rewind(stream);
    free(file->bytes);
    file->bytes = malloc(most + 1);
    if (file->bytes == NULL)
        return false;
    file->count = fread(file->bytes, 1, most, stream);
    file->bytes[file->count] = 0;
    make_plain(file);
    return true;
}

static size_t size_of(FILE *stream)
{
    const long size = fseek(stream, 0, SEEK_END) == 0 ? ftell(stream) : -1;
    return size > 0 ? (size_t)size : 0;
}

/* assimp makes no mesh of an object without faces. */
static void drop_empty_objects(glint_groups *file)
{
    size_t kept = 0;
    for (size_t i = 0; i < file->objects; i++)
        if (file->object[i].faces > 0)
            file->object[kept++] = file->object[i];
        else
            free(file->object[i].group);
    file->objects = kept;
}

/* False when out of memory. file->format stays NULL if it is neither format. */
static bool read_stream(FILE *stream, glint_groups *file)
{
    if (!read_bytes(stream, BEGIN_BYTES, file))
        return false;
    const bool is_3ds = glint_groups_are_3ds(file);
    if (!is_3ds && !glint_groups_are_ase(file))
        return true;
    file->format = is_3ds ? "3ds" : "ase";
    if (!read_bytes(stream, size_of(stream), file) ||
        !(is_3ds ? glint_groups_read_3ds(file) : glint_groups_read_ase(file)))
        return false;
    drop_empty_objects(file);
    return true;
}

glint_status glint_groups_read(const char *path, glint_groups **file, glint_error *err)
{
    *file = NULL;
    FILE *stream = fopen(path, "rb");
    if (stream == NULL)
        return glint_fail(err, GLINT_IO_ERROR, "%.400s: %s", path, strerror(errno));
    glint_groups *made = calloc(1, sizeof *made);
    const bool done = made != NULL && read_stream(stream, made);
    const bool failed = ferror(stream) != 0;
    (void)fclose(stream);
    if (done && !failed && made->format != NULL) {
        *file = made;
        return GLINT_OK;
    }
    glint_groups_destroy(made);
    if (failed)
        return glint_fail(err, GLINT_IO_ERROR, "%.400s: cannot be read to the end", path);
    return done ? GLINT_OK
                : glint_fail(err, GLINT_NO_MEMORY,
                             "%.400s: not enough memory for its smoothing groups", path);
}

void glint_groups_destroy(glint_groups *file)
{
    if (file == NULL)
        return;
    for (size_t i = 0; i < file->objects; i++)
        free(file->object[i].group);
    free(file->object);
    free(file->bytes);
    free(file);
}
