/* The smoothing groups of a .3ds file; see groups.h.
 *
 * A chunk: its kind in 2 bytes, its size with these 6 bytes in 4, its content. */
#include "render/groups.h"

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

static unsigned word_at(const glint_groups *file, size_t at)
{
    return (unsigned)file->bytes[at] | (unsigned)file->bytes[at + 1] << 8;
}

static uint32_t long_at(const glint_groups *file, size_t at)
{
    return (uint32_t)word_at(file, at) | (uint32_t)word_at(file, at + 2) << 16;
}

/* Removes the next chunk from `from`; false if there is none. */
static bool next_chunk(const glint_groups *file, range *from, unsigned *kind, range *content)
{
    if (from->end < from->next + HEADER)
        return false;
    const size_t size = long_at(file, from->next + 2);
    const size_t left = from->end - from->next;
    *kind = word_at(file, from->next);
    content->next = from->next + HEADER;
    content->end = from->next + (size > left ? left : size < HEADER ? HEADER : size);
    from->next = content->end;
    return true;
}

static void read_groups(const glint_groups *file, range in, glint_groups_object *object)
{
    for (size_t i = 0; i < object->faces && in.next + 4 <= in.end; i++, in.next += 4)
        object->group[i] = long_at(file, in.next);
}

/* What follows the faces in their chunk. */
static void read_face_lists(glint_groups *file, range in, glint_groups_object *object)
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

static bool read_faces(glint_groups *file, range in, glint_groups_object *object)
{
    if (in.end < in.next + 2)
        return true;
    const size_t faces = word_at(file, in.next);
    in.next += 2;
    if ((in.end - in.next) / FACE_BYTES < faces)
        return true; /* damaged: assimp refuses it */
    in.next += faces * FACE_BYTES;
    if (!glint_groups_add_faces(object, faces))
        return false;
    read_face_lists(file, in, object);
    return true;
}

static bool read_mesh(glint_groups *file, range in)
{
    glint_groups_object *object = glint_groups_add_object(file);
    if (object == NULL)
        return false;
    range content;
    unsigned kind;
    while (next_chunk(file, &in, &kind, &content))
        if (kind == FACES && !read_faces(file, content, object))
            return false;
    return true;
}

/* A name, then chunks. */
static bool read_object(glint_groups *file, range in)
{
    while (in.next < in.end && file->bytes[in.next] != 0)
        in.next++;
    in.next++;
    range content;
    unsigned kind;
    while (next_chunk(file, &in, &kind, &content))
        if (kind == MESH && !read_mesh(file, content))
            return false;
    return true;
}

static bool read_editor(glint_groups *file, range in)
{
    range content;
    unsigned kind;
    while (next_chunk(file, &in, &kind, &content))
        if (kind == OBJECT && !read_object(file, content))
            return false;
    return true;
}

static bool read_main(glint_groups *file, range in)
{
    range content;
    unsigned kind;
    while (next_chunk(file, &in, &kind, &content))
        if (kind == EDITOR && !read_editor(file, content))
            return false;
    return true;
}

bool glint_groups_read_3ds(glint_groups *file)
{
    range in = {0, file->count}, content;
    unsigned kind;
    while (next_chunk(file, &in, &kind, &content))
        if (kind == MAIN && !read_main(file, content))
            return false;
    return true;
}

bool glint_groups_are_3ds(const glint_groups *file)
{
    return file->count >= HEADER && word_at(file, 0) == MAIN;
}
