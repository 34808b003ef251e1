/* .3ds, chunk by chunk: its kind in 2 bytes, its size with these 6 bytes in 4, its content, all
 * with the lowest byte first. */
#include <stdlib.h>
#include <string.h>

#include "convert/formats.h"
#include "convert/smoothing.h"

enum {
    MAIN = 0x4d4d,
    VERSION = 0x0002,
    EDITOR = 0x3d3d,
    EDITOR_VERSION = 0x3d3e,
    OBJECT = 0x4000,
    MESH = 0x4100,
    VERTICES = 0x4110,
    FACES = 0x4120,
    GROUPS = 0x4150,
    AXES = 0x4160,
};

#define HEADER       6u
#define VERTEX_BYTES 12u
#define FACE_BYTES   8u
#define GROUP_BYTES  4u
#define AXES_BYTES   48u
#define NAME_ROOM    16

/* Triangles first … last−1 that are one object, and how many vertices they have. */
typedef struct part {
    size_t first, last;
    size_t triangles; /* but for those without three different places */
    size_t vertices;
} part;

typedef struct writing {
    const glint_mesh *mesh;
    const glint_places *places;
    const uint32_t *group;
    FILE *out;
    const volatile bool *stop;
    uint32_t *number; /* of each place: that in the object it was last met in */
    uint32_t *object; /* of each place: that object, counted from 1 */
    part *parts;
    size_t count, room;
} writing;

/* ---- Parts ----------------------------------------------------------------------------------- */

static uint32_t place_of(const writing *w, size_t corner)
{
    return w->places->of_vertex[w->mesh->index[corner]];
}

static bool has_area(const writing *w, size_t triangle)
{
    const uint32_t a = place_of(w, 3 * triangle), b = place_of(w, 3 * triangle + 1),
                   c = place_of(w, 3 * triangle + 2);
    return a != b && b != c && c != a;
}

/* Numbers the triangle's places in the object, those that are new to it; returns how many were. */
static size_t number_places(writing *w, size_t triangle, uint32_t object, size_t from)
{
    size_t added = 0;
    for (size_t corner = 3 * triangle; corner < 3 * triangle + 3; corner++) {
        const uint32_t place = place_of(w, corner);
        if (w->object[place] != object) {
            w->object[place] = object;
            w->number[place] = (uint32_t)(from + added++);
        }
    }
    return added;
}

static bool is_full(const writing *w, const part *p, size_t triangle, size_t most)
{
    size_t added = 0;
    for (size_t corner = 3 * triangle; corner < 3 * triangle + 3; corner++)
        added += w->object[place_of(w, corner)] != (uint32_t)w->count;
    return p->triangles == most || p->vertices + added > most;
}

static part *begin_part(writing *w, size_t triangle)
{
    if (w->count == w->room) {
        const size_t room = 2 * w->room + 4;
        part *more = realloc(w->parts, room * sizeof *more);
        if (more == NULL)
            return NULL;
        w->parts = more;
        w->room = room;
    }
    w->parts[w->count] = (part){.first = triangle};
    return &w->parts[w->count++];
}

/* false: no memory. Triangles stay in their order, so that neighbours stay together. */
static bool find_parts(writing *w, size_t most)
{
    part *p = begin_part(w, 0);
    for (size_t i = 0; p != NULL && i < w->mesh->triangle_count; i++) {
        if (has_area(w, i)) {
            if (is_full(w, p, i, most))
                p = begin_part(w, i);
            if (p == NULL)
                return false;
            p->vertices += number_places(w, i, (uint32_t)w->count, p->vertices);
            p->triangles++;
        }
        p->last = i + 1;
    }
    return p != NULL;
}

/* ---- Sizes ----------------------------------------------------------------------------------- */

static void name_of(size_t object, char name[NAME_ROOM])
{
    (void)snprintf(name, NAME_ROOM, "object%zu", object + 1);
}

static uint32_t vertices_size(const part *p)
{
    return (uint32_t)(HEADER + 2 + p->vertices * VERTEX_BYTES);
}

static uint32_t groups_size(const part *p)
{
    return (uint32_t)(HEADER + p->triangles * GROUP_BYTES);
}

static uint32_t faces_size(const part *p)
{
    return (uint32_t)(HEADER + 2 + p->triangles * FACE_BYTES) + groups_size(p);
}

static uint32_t mesh_size(const part *p)
{
    return HEADER + vertices_size(p) + faces_size(p) + HEADER + AXES_BYTES;
}

static uint32_t object_size(const part *p, size_t object)
{
    char name[NAME_ROOM];
    name_of(object, name);
    return (uint32_t)(HEADER + strlen(name) + 1) + mesh_size(p);
}

/* At most 20 bytes a triangle and 12 a vertex of it: below 2^32 for every mesh (mesh.h). */
static uint32_t editor_size(const writing *w)
{
    uint32_t size = HEADER + HEADER + 4;
    for (size_t i = 0; i < w->count; i++)
        size += object_size(&w->parts[i], i);
    return size;
}

/* ---- Chunks ---------------------------------------------------------------------------------- */

static void put16(FILE *out, uint32_t value)
{
    (void)putc((int)(value & 0xff), out);
    (void)putc((int)(value >> 8 & 0xff), out);
}

static void put32(FILE *out, uint32_t value)
{
    put16(out, value & 0xffff);
    put16(out, value >> 16);
}

static void put_float(FILE *out, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    put32(out, bits);
}

static void begin_chunk(FILE *out, uint32_t kind, uint32_t size)
{
    put16(out, kind);
    put32(out, size);
}

/* The z axis points up in these files: (x, y, z) is (x, −z, y) there. */
static void put_vertex(FILE *out, const float *p)
{
    put_float(out, p[0]);
    put_float(out, 0.0f - p[2]);
    put_float(out, p[1]);
}

/* In the order in which number_places() counts them. */
static void write_vertices(writing *w, const part *p, uint32_t object)
{
    size_t count = 0;
    begin_chunk(w->out, VERTICES, vertices_size(p));
    put16(w->out, (uint32_t)p->vertices);
    for (size_t i = p->first; i < p->last; i++) {
        if (!has_area(w, i))
            continue;
        const size_t before = count;
        count += number_places(w, i, object, count);
        for (size_t k = 3 * i, next = before; k < 3 * i + 3; k++)
            if (w->number[place_of(w, k)] == next && next < count) {
                put_vertex(w->out, &w->mesh->position[3 * (size_t)w->mesh->index[k]]);
                next++;
            }
    }
}

#define ALL_EDGES 7u /* are drawn where wires are */

static void write_faces(const writing *w, const part *p)
{
    begin_chunk(w->out, FACES, faces_size(p));
    put16(w->out, (uint32_t)p->triangles);
    for (size_t i = p->first; i < p->last; i++) {
        if (!has_area(w, i))
            continue;
        for (size_t corner = 3 * i; corner < 3 * i + 3; corner++)
            put16(w->out, w->number[place_of(w, corner)]);
        put16(w->out, ALL_EDGES);
    }
    begin_chunk(w->out, GROUPS, groups_size(p));
    for (size_t i = p->first; i < p->last; i++)
        if (has_area(w, i))
            put32(w->out, w->group[i]);
}

/* The object's own axes are the file's. */
static void write_axes(FILE *out)
{
    begin_chunk(out, AXES, HEADER + AXES_BYTES);
    for (int i = 0; i < 12; i++)
        put_float(out, i % 4 == 0 && i < 9 ? 1.0f : 0.0f);
}

static void write_object(writing *w, size_t at)
{
    const part *p = &w->parts[at];
    char name[NAME_ROOM];
    name_of(at, name);
    begin_chunk(w->out, OBJECT, object_size(p, at));
    (void)fwrite(name, 1, strlen(name) + 1, w->out);
    begin_chunk(w->out, MESH, mesh_size(p));
    write_vertices(w, p, (uint32_t)(w->count + 1 + at)); /* numbered anew */
    write_faces(w, p);
    write_axes(w->out);
}

static glint_status write_file(writing *w, glint_error *err)
{
    const uint32_t editor = editor_size(w);
    begin_chunk(w->out, MAIN, HEADER + HEADER + 4 + editor);
    begin_chunk(w->out, VERSION, HEADER + 4);
    put32(w->out, 3);
    begin_chunk(w->out, EDITOR, editor);
    begin_chunk(w->out, EDITOR_VERSION, HEADER + 4);
    put32(w->out, 3);
    for (size_t i = 0; i < w->count; i++) {
        if (w->stop != NULL && *w->stop)
            return glint_fail(err, GLINT_INTERRUPTED, "interrupted: nothing was written");
        write_object(w, i);
    }
    return GLINT_OK;
}

static void sum_up(const writing *w, const glint_smoothing_groups *groups,
                   glint_converted *converted)
{
    converted->objects = w->count;
    converted->groups = groups->count;
    converted->unmarked = groups->unmarked;
    for (size_t i = 0; i < w->count; i++) {
        converted->vertices += w->parts[i].vertices;
        converted->triangles += w->parts[i].triangles;
    }
}

static glint_status write_places(const glint_mesh *mesh, const glint_places *places,
                                 const glint_smoothing_groups *groups, size_t most, FILE *out,
                                 const volatile bool *stop, glint_converted *converted,
                                 glint_error *err)
{
    writing w = {.mesh = mesh, .places = places, .group = groups->group, .out = out, .stop = stop};
    w.number = malloc(places->count * sizeof *w.number);
    w.object = calloc(places->count, sizeof *w.object);
    glint_status status = GLINT_OK;
    if (w.number == NULL || w.object == NULL || !find_parts(&w, most))
        status = glint_fail(err, GLINT_NO_MEMORY, "not enough memory for %zu triangles",
                            mesh->triangle_count);
    if (status == GLINT_OK)
        status = write_file(&w, err);
    if (status == GLINT_OK)
        sum_up(&w, groups, converted);
    free(w.number);
    free(w.object);
    free(w.parts);
    return status;
}

glint_status glint_write_3ds(const glint_mesh *mesh, size_t most, FILE *out,
                             const volatile bool *stop, glint_converted *converted,
                             glint_error *err)
{
    glint_places places;
    glint_smoothing_groups groups = {.group = NULL};
    glint_status status = GLINT_OK;
    if (!glint_places_find(mesh, &places))
        status = glint_fail(err, GLINT_NO_MEMORY, "not enough memory for %zu vertices",
                            mesh->vertex_count);
    if (status == GLINT_OK)
        status = glint_smoothing_groups_find(mesh, &places, stop, &groups, err);
    if (status == GLINT_OK)
        status = write_places(mesh, &places, &groups, most, out, stop, converted, err);
    glint_smoothing_groups_clear(&groups);
    glint_places_clear(&places);
    return status;
}
