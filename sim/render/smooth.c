/* Normals that no one gave; see smooth.h. */
#include "render/smooth.h"

#include <stdlib.h>
#include <string.h>

#include "render/mesh_build.h"
#include "render/places.h"

/* cos 66 degrees */
#define CREASE_COSINE 0.40673664307580015

#define NOWHERE UINT32_MAX

/* A corner of a triangle, seen from its point. */
typedef struct wedge {
    glint_vec3 plane; /* unit normal of the triangle; 0 when it has none */
    double angle;     /* of the triangle at the point, radians */
    uint32_t group, object;
    uint32_t corner; /* index into the mesh's */
} wedge;

/* A corner with its stored normal. */
typedef struct finished {
    float normal[3];
    uint32_t corner;
    uint32_t kind; /* its wedge, of those that are left when alike ones are merged */
} finished;

typedef struct work {
    const glint_smoothing *smoothing;
    const glint_mesh *from;
    glint_places points;
    wedge *wedges;      /* room for as many as corners of one point */
    finished *finished; /* likewise */
    glint_mesh *to;     /* its triangles, with room for their vertices */
    size_t room;        /* for so many */
} work;

/* ---- One point's normals -----------------------------------------------------------------------
 */

static int order_of(double a, double b)
{
    return (a > b) - (a < b);
}

static int order_of_places(glint_vec3 a, glint_vec3 b)
{
    const int x = order_of(a.x, b.x), y = order_of(a.y, b.y);
    return x != 0 ? x : y != 0 ? y : order_of(a.z, b.z);
}

/* The triangle's normal, of unit length or 0. It is rounded alike whichever corner is named
 * first. */
static glint_vec3 plane_of(const glint_vec3 p[3])
{
    int first = order_of_places(p[1], p[0]) < 0 ? 1 : 0;
    first = order_of_places(p[2], p[first]) < 0 ? 2 : first;
    const glint_vec3 o = p[first];
    const glint_vec3 n = glint_vec3_cross(glint_vec3_sub(p[(first + 1) % 3], o),
                                          glint_vec3_sub(p[(first + 2) % 3], o));
    const double length = glint_vec3_length(n);
    return length > 0.0 ? glint_vec3_scale(n, 1.0 / length) : (glint_vec3){0.0, 0.0, 0.0};
}

static wedge wedge_of(const work *w, uint32_t corner)
{
    const size_t triangle = corner / 3;
    glint_vec3 p[3];
    for (size_t k = 0; k < 3; k++)
        p[k] = glint_vec3_of(&w->from->position[3 * (size_t)w->from->index[3 * triangle + k]]);
    const glint_vec3 *o = &p[corner % 3];
    const glint_vec3 a = glint_vec3_sub(p[(corner + 1) % 3], *o);
    const glint_vec3 b = glint_vec3_sub(p[(corner + 2) % 3], *o);
    return (wedge){
        .plane = plane_of(p),
        .angle = atan2(glint_vec3_length(glint_vec3_cross(a, b)), glint_vec3_dot(a, b)),
        .group = w->smoothing->group[triangle],
        .object = w->smoothing->object != NULL ? w->smoothing->object[triangle] : 0,
        .corner = corner,
    };
}

/* Of equal ones all are alike: any order of them gives the same sum. */
static int order_of_wedges(const void *left, const void *right)
{
    const wedge *a = left, *b = right;
    const int plane = order_of_places(a->plane, b->plane);
    if (plane != 0)
        return plane;
    if (a->group != b->group)
        return a->group < b->group ? -1 : 1;
    if (a->object != b->object)
        return a->object < b->object ? -1 : 1;
    return order_of(a->angle, b->angle);
}

static bool alike(const wedge *a, const wedge *b)
{
    return order_of_places(a->plane, b->plane) == 0 && a->group == b->group &&
           a->object == b->object;
}

static bool smooth_over(const glint_smoothing *smoothing, const wedge *a, const wedge *b)
{
    return (a->group & b->group) != 0 && a->object == b->object &&
           (!smoothing->creased || glint_vec3_dot(a->plane, b->plane) >= CREASE_COSINE);
}

static bool is_zero(glint_vec3 v)
{
    return v.x == 0.0 && v.y == 0.0 && v.z == 0.0;
}

static glint_vec3 unit_or(glint_vec3 v, glint_vec3 otherwise)
{
    const double length = glint_vec3_length(v);
    return length > 0.0 ? glint_vec3_scale(v, 1.0 / length) : otherwise;
}

/* The mean for the wedge at `own`. A triangle without a plane uses whatever is around it. */
static glint_vec3 mean_for(const work *w, size_t count, size_t own)
{
    const wedge *mine = &w->wedges[own];
    const bool flat = is_zero(mine->plane);
    glint_vec3 sum = {0.0, 0.0, 0.0};
    for (size_t i = 0; i < count; i++)
        if (flat || smooth_over(w->smoothing, mine, &w->wedges[i]))
            sum = glint_vec3_add(sum, glint_vec3_scale(w->wedges[i].plane, w->wedges[i].angle));
    return unit_or(sum, flat ? (glint_vec3){0.0, 1.0, 0.0} : mine->plane);
}

static const float *given_normal(const work *w, uint32_t corner)
{
    return &w->from->normal[3 * (size_t)w->from->index[corner]];
}

static bool lacks_normal(const work *w, uint32_t corner)
{
    const float *n = given_normal(w, corner);
    return n[0] == 0.0f && n[1] == 0.0f && n[2] == 0.0f;
}

/* Merges wedges that differ only in their angle; returns how many are left. The corners in
 * w->finished come into the order of their wedges. */
static size_t merge(work *w, size_t count)
{
    qsort(w->wedges, count, sizeof *w->wedges, order_of_wedges);
    size_t kinds = 0;
    for (size_t i = 0; i < count; i++) {
        const wedge next = w->wedges[i];
        w->finished[i].corner = next.corner;
        w->finished[i].kind = (uint32_t)kinds;
        if (kinds > 0 && alike(&w->wedges[kinds - 1], &next)) {
            w->wedges[kinds - 1].angle += next.angle;
            w->finished[i].kind--;
        } else {
            w->wedges[kinds++] = next;
        }
    }
    return kinds;
}

/* The normals of a point's corners where some have none. */
static void make_normals(work *w, const uint32_t *corner, size_t count)
{
    for (size_t i = 0; i < count; i++)
        w->wedges[i] = wedge_of(w, corner[i]);
    const size_t kinds = merge(w, count);
    uint32_t kind = NOWHERE;
    glint_vec3 mean = {0.0, 0.0, 0.0};
    for (size_t i = 0; i < count; i++) {
        finished *f = &w->finished[i];
        if (f->kind != kind) {
            kind = f->kind;
            mean = mean_for(w, kinds, kind);
        }
        if (lacks_normal(w, f->corner))
            glint_vec3_store(mean, f->normal);
        else
            memcpy(f->normal, given_normal(w, f->corner), sizeof f->normal);
    }
}

/* Fills w->finished for one point. */
static void finish_corners(work *w, const uint32_t *corner, size_t count)
{
    bool lacking = false;
    for (size_t i = 0; i < count; i++) {
        lacking = lacking || lacks_normal(w, corner[i]);
        w->finished[i].corner = corner[i];
        memcpy(w->finished[i].normal, given_normal(w, corner[i]), sizeof w->finished[i].normal);
    }
    if (lacking)
        make_normals(w, corner, count);
}

/* ---- The new mesh ------------------------------------------------------------------------------
 */

static int order_of_finished(const void *left, const void *right)
{
    const finished *a = left, *b = right;
    for (int i = 0; i < 3; i++)
        if (a->normal[i] != b->normal[i])
            return a->normal[i] < b->normal[i] ? -1 : 1;
    return (a->corner > b->corner) - (a->corner < b->corner);
}

static bool grow(float **array, size_t room)
{
    float *larger = realloc(*array, room * 3 * sizeof **array);
    *array = larger != NULL ? larger : *array;
    return larger != NULL;
}

/* Room for so many more vertices. */
static bool make_room(work *w, size_t more)
{
    if (w->to->vertex_count + more <= w->room)
        return true;
    const size_t room = w->room + w->room / 2 + more;
    if (!grow(&w->to->position, room) || !grow(&w->to->normal, room))
        return false;
    w->room = room;
    return true;
}

/* Corners of one normal become one vertex. */
static bool join_corners(work *w, size_t count)
{
    qsort(w->finished, count, sizeof *w->finished, order_of_finished);
    if (!make_room(w, count))
        return false;
    for (size_t i = 0; i < count; i++) {
        const finished *f = &w->finished[i];
        if (i == 0 || !glint_same_place(f->normal, f[-1].normal)) {
            const uint32_t vertex = w->from->index[f->corner];
            glint_mesh_add_vertex(w->to, glint_vec3_of(&w->from->position[3 * (size_t)vertex]),
                                  glint_vec3_of(f->normal));
        }
        w->to->index[f->corner] = (uint32_t)(w->to->vertex_count - 1);
    }
    return true;
}

static bool find_all(work *w)
{
    if (!glint_places_find(w->from, &w->points))
        return false;
    w->wedges = malloc(w->points.most * sizeof *w->wedges);
    w->finished = malloc(w->points.most * sizeof *w->finished);
    return w->wedges != NULL && w->finished != NULL;
}

static bool finish_all(work *w)
{
    const glint_places *points = &w->points;
    for (size_t i = 0; i < points->count; i++) {
        const size_t count = points->start[i + 1] - points->start[i];
        finish_corners(w, &points->corner[points->start[i]], count);
        if (count > 0 && !join_corners(w, count))
            return false;
    }
    return true;
}

glint_status glint_smooth(const char *what, const glint_smoothing *smoothing, glint_mesh **mesh,
                          glint_error *err)
{
    work w = {.smoothing = smoothing, .from = *mesh};
    glint_status status = glint_mesh_new(what, 0, w.from->triangle_count, &w.to, err);
    if (status != GLINT_OK)
        return status;
    w.to->triangle_count = w.from->triangle_count;
    if (!find_all(&w) || !finish_all(&w))
        status = glint_fail(err, GLINT_NO_MEMORY, "%s: not enough memory for its normals", what);
    glint_places_clear(&w.points);
    free(w.wedges);
    free(w.finished);
    glint_mesh_destroy(status == GLINT_OK ? *mesh : w.to);
    *mesh = status == GLINT_OK ? w.to : *mesh;
    return status;
}
