/* The smoothing groups of a .3ds file; see groups3ds.h.
 *
 * A chunk: its kind in 2 bytes, its size with these 6 bytes in 4, its content. */
#include "render/groups3ds.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MAIN = 0x4d4d,
    EDITOR = 0x3d3d,
    OBJECT = 0x4000,
    MESH = 0x4100,
    FACES = 0x4120,
    MATERIAL = 0x4130, /* of faces */
    GROUPS = 0x4150,
    UNKNOWN = 0x0fff, /* of no meaning in any version of the format */
};

#define HEADER     6
#define FACE_BYTES 8

/* Content of a chunk. */
typedef struct range {
    size_t next, end;
} range;

static unsigned word_at(const glint_groups3ds *file, size_t at)
{
    return (unsigned)file->bytes[at] | (unsigned)file->bytes[at + 1] << 8;
}

static uint32_t long_at(const glint_groups3ds *file, size_t at)
{
    return (uint32_t)word_at(file, at) | (uint32_t)word_at(file, at + 2) << 16;
}

/* Takes the next chunk off `from`; false when there is none. */
static bool next_chunk(const glint_groups3ds *file, range *from, unsigned *kind, range *content)
{
    if (from->end < from->next + HEADER) {
        return false;
    }
    const size_t size = long_at(file, from->next + 2);
    const size_t left = from->end - from->next;
    *kind = word_at(file, from->next);
    content->next = from->next + HEADER;
    content->end = from->next + (size > left ? left : size < HEADER ? HEADER : size);
    from->next = content->end;
    return true;
}

static void read_groups(const glint_groups3ds *file, range in, glint_groups3ds_object *object)
{
    for (size_t i = 0; i < object->faces && in.next + 4 <= in.end; i++, in.next += 4) {
        object->group[i] = long_at(file, in.next);
    }
}

/* What follows the faces in their chunk. */
static void read_face_lists(glint_groups3ds *file, range in, glint_groups3ds_object *object)
{
    range content;
    unsigned kind;
    for (size_t at = in.next; next_chunk(file, &in, &kind, &content); at = in.next) {
        if (kind == GROUPS) {
            read_groups(file, content, object);
        } else if (kind == MATERIAL) {
            file->bytes[at] = UNKNOWN & 0xff;
            file->bytes[at + 1] = UNKNOWN >> 8;
        }
    }
}

/* Adds faces of no group to the object. */
static bool add_faces(glint_groups3ds_object *object, size_t faces)
{
    uint32_t *group = realloc(object->group, (object->faces + faces + 1) * sizeof *group);
    if (group == NULL) {
        return false;
    }
    memset(group + object->faces, 0, faces * sizeof *group);
    object->group = group;
    object->faces += faces;
    return true;
}

static bool read_faces(glint_groups3ds *file, range in, glint_groups3ds_object *object)
{
    if (in.end < in.next + 2) {
        return true;
    }
    const size_t faces = word_at(file, in.next);
    in.next += 2;
    if ((in.end - in.next) / FACE_BYTES < faces) {
        return true; /* damaged: assimp refuses it */
    }
    in.next += faces * FACE_BYTES;
    if (!add_faces(object, faces)) {
        return false;
    }
    read_face_lists(file, in, object);
    return true;
}

static bool read_mesh(glint_groups3ds *file, range in)
{
    glint_groups3ds_object *object =
        realloc(file->object, (file->objects + 1) * sizeof *file->object);
    if (object == NULL) {
        return false;
    }
    file->object = object;
    object += file->objects;
    *object = (glint_groups3ds_object){0, NULL};
    file->objects++;
    range content;
    unsigned kind;
    while (next_chunk(file, &in, &kind, &content)) {
        if (kind == FACES && !read_faces(file, content, object)) {
            return false;
        }
    }
    if (object->faces == 0) {
        free(object->group);
        file->objects--;
    }
    return true;
}

/* A name, then chunks. */
static bool read_object(glint_groups3ds *file, range in)
{
    while (in.next < in.end && file->bytes[in.next] != 0) {
        in.next++;
    }
    in.next++;
    range content;
    unsigned kind;
    while (next_chunk(file, &in, &kind, &content)) {
        if (kind == MESH && !read_mesh(file, content)) {
            return false;
        }
    }
    return true;
}

static bool read_editor(glint_groups3ds *file, range in)
{
    range content;
    unsigned kind;
    while (next_chunk(file, &in, &kind, &content)) {
        if (kind == OBJECT && !read_object(file, content)) {
            return false;
        }
    }
    return true;
}

static bool read_main(glint_groups3ds *file, range in)
{
    range content;
    unsigned kind;
    while (next_chunk(file, &in, &kind, &content)) {
        if (kind == EDITOR && !read_editor(file, content)) {
            return false;
        }
    }
    return true;
}

static bool read_chunks(glint_groups3ds *file)
{
    range in = {0, file->count}, content;
    unsigned kind;
    while (next_chunk(file, &in, &kind, &content)) {
        if (kind == MAIN && !read_main(file, content)) {
            return false;
        }
    }
    return true;
}

/* The whole stream, from its begin. */
static glint_status read_bytes(const char *path, FILE *stream, glint_groups3ds *file,
                               glint_error *err)
{
    long size = -1;
    if (fseek(stream, 0, SEEK_END) == 0) {
        size = ftell(stream);
        rewind(stream);
    }
    if (size < 0) {
        return glint_fail(err, GLINT_IO_ERROR, "%.400s: %s", path, strerror(errno));
    }
    file->bytes = malloc((size_t)size + 1);
    if (file->bytes == NULL) {
        return glint_fail(err, GLINT_NO_MEMORY, "%.400s: no memory for its %ld bytes", path, size);
    }
    file->count = fread(file->bytes, 1, (size_t)size, stream);
    return file->count == (size_t)size
               ? GLINT_OK
               : glint_fail(err, GLINT_IO_ERROR, "%.400s: cannot be read to its end", path);
}

static bool begins_as_3ds(FILE *stream)
{
    unsigned char kind[2];
    return fread(kind, 1, 2, stream) == 2 && kind[0] == (MAIN & 0xff) && kind[1] == MAIN >> 8;
}

static glint_status read_file(const char *path, FILE *stream, glint_groups3ds *file,
                              glint_error *err)
{
    const glint_status status = read_bytes(path, stream, file, err);
    if (status == GLINT_OK && !read_chunks(file)) {
        return glint_fail(err, GLINT_NO_MEMORY, "%.400s: no memory for its smoothing groups", path);
    }
    return status;
}

glint_status glint_groups3ds_read(const char *path, glint_groups3ds **file, glint_error *err)
{
    *file = NULL;
    FILE *stream = fopen(path, "rb");
    if (stream == NULL) {
        return glint_fail(err, GLINT_IO_ERROR, "%.400s: %s", path, strerror(errno));
    }
    glint_status status = GLINT_OK;
    if (begins_as_3ds(stream)) {
        *file = calloc(1, sizeof **file);
        status = *file != NULL ? read_file(path, stream, *file, err)
                               : glint_fail(err, GLINT_NO_MEMORY, "%.400s: no memory", path);
    }
    (void)fclose(stream);
    if (status != GLINT_OK) {
        glint_groups3ds_destroy(*file);
        *file = NULL;
    }
    return status;
}

void glint_groups3ds_destroy(glint_groups3ds *file)
{
    if (file == NULL) {
        return;
    }
    for (size_t i = 0; i < file->objects; i++) {
        free(file->object[i].group);
    }
    free(file->object);
    free(file->bytes);
    free(file);
}
