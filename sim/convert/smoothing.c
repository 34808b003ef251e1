/* Smoothing groups from normals; see smoothing.h.
 *
 * Corners of one place with one normal form a cluster. Triangles that smooth edges join form a
 * region. A region takes one group for all of its triangles, the lowest that no region has which it
 * touches at another normal; only where a region touches itself so (a crease that ends within it)
 * are there more, each given to both triangles of an edge that still lacks one. */
#include "convert/smoothing.h"

#include <stdlib.h>

#include "reflectance/vec3.h"

#define SAME_COSINE 0.99984769515639124 /* 1 degree: one normal */
#define NEAR_COSINE 0.86602540378443865 /* 30 degrees */

/* With more normals than this at one place, a corner is compared with the latest ones only. */
#define CLUSTERS_COMPARED 64

typedef struct work {
    const glint_mesh *mesh;
    const glint_places *places;
    const volatile bool *stop;
    uint32_t *cluster; /* of each corner */
    uint32_t *parent;  /* of each cluster: what it has been joined with; itself at the end */
    uint32_t *normal;  /* of each cluster: a vertex that has it */
    size_t clusters;
    uint32_t *has;         /* of each cluster: the groups of its triangles */
    uint32_t *once, *more; /* of each place: groups that one cluster has, that several have */
    uint32_t *queue;       /* triangles of a region */
    size_t queued;
    bool *seen; /* of each triangle */
    glint_smoothing_groups *result;
} work;

static double cosine(const work *w, uint32_t vertex, uint32_t other)
{
    return glint_vec3_dot(glint_vec3_of(&w->mesh->normal[3 * (size_t)vertex]),
                          glint_vec3_of(&w->mesh->normal[3 * (size_t)other]));
}

static uint32_t place_of(const work *w, uint32_t corner)
{
    return w->places->of_vertex[w->mesh->index[corner]];
}

/* ---- Clusters -------------------------------------------------------------------------------- */

/* The cluster of a vertex among those of its place, first and later; a new one if there is none. */
static uint32_t cluster_for(work *w, size_t first, uint32_t vertex)
{
    const size_t from =
        w->clusters > first + CLUSTERS_COMPARED ? w->clusters - CLUSTERS_COMPARED : first;
    for (size_t i = w->clusters; i-- > from;)
        if (w->normal[i] == vertex || cosine(w, w->normal[i], vertex) >= SAME_COSINE)
            return (uint32_t)i;
    w->normal[w->clusters] = vertex;
    w->parent[w->clusters] = (uint32_t)w->clusters;
    return (uint32_t)w->clusters++;
}

static void find_clusters(work *w)
{
    for (size_t place = 0; place < w->places->count; place++) {
        const size_t first = w->clusters;
        for (size_t i = w->places->start[place]; i < w->places->start[place + 1]; i++) {
            const uint32_t corner = w->places->corner[i];
            w->cluster[corner] = cluster_for(w, first, w->mesh->index[corner]);
        }
    }
}

static uint32_t root_of(work *w, uint32_t cluster)
{
    while (w->parent[cluster] != cluster) {
        w->parent[cluster] = w->parent[w->parent[cluster]];
        cluster = w->parent[cluster];
    }
    return cluster;
}

static uint32_t cluster_at(work *w, uint32_t corner)
{
    return root_of(w, w->cluster[corner]);
}

/* ---- Edges ----------------------------------------------------------------------------------- */

static uint32_t next_corner(uint32_t corner, uint32_t steps)
{
    return corner - corner % 3 + (corner % 3 + steps) % 3;
}

/* An edge from corners a and b of one triangle, and the other triangle's corners at its ends. */
typedef struct edge {
    uint32_t a, b;
    uint32_t other_a, other_b;
} edge;

typedef void visit(work *w, const edge *e);

/* Visits every other triangle along the edge that begins at the corner. It is sought at that end
 * where fewer corners meet. */
static void visit_edge(work *w, uint32_t corner, visit *f)
{
    if (w->stop != NULL && *w->stop) /* any number of triangles may meet at one edge */
        return;
    const uint32_t *start = w->places->start;
    edge e = {.a = corner, .b = next_corner(corner, 1)};
    uint32_t here = place_of(w, e.a), there = place_of(w, e.b);
    const bool turned = start[here + 1] - start[here] > start[there + 1] - start[there];
    if (turned) {
        const uint32_t kept = here;
        here = there;
        there = kept;
    }
    for (uint32_t i = start[here]; i < start[here + 1]; i++) {
        const uint32_t at = w->places->corner[i];
        for (uint32_t steps = 1; at / 3 != corner / 3 && steps <= 2; steps++) {
            const uint32_t end = next_corner(at, steps);
            if (place_of(w, end) != there)
                continue;
            e.other_a = turned ? end : at;
            e.other_b = turned ? at : end;
            f(w, &e);
        }
    }
}

static void visit_triangle(work *w, uint32_t triangle, visit *f)
{
    for (uint32_t k = 0; k < 3; k++)
        visit_edge(w, 3 * triangle + k, f);
}

static bool same_at_a(work *w, const edge *e)
{
    return cluster_at(w, e->a) == cluster_at(w, e->other_a);
}

static bool same_at_b(work *w, const edge *e)
{
    return cluster_at(w, e->b) == cluster_at(w, e->other_b);
}

/* Joins two clusters that an edge which is smooth at its other end brings together. */
static void join_if_near(work *w, uint32_t corner, uint32_t other)
{
    if (cosine(w, w->mesh->index[corner], w->mesh->index[other]) >= NEAR_COSINE)
        w->parent[cluster_at(w, corner)] = cluster_at(w, other);
}

static void join_ends(work *w, const edge *e)
{
    const bool a = same_at_a(w, e), b = same_at_b(w, e);
    if (a && !b)
        join_if_near(w, e->b, e->other_b);
    else if (b && !a)
        join_if_near(w, e->a, e->other_a);
}

/* ---- Groups ---------------------------------------------------------------------------------- */

/* Groups of triangles that meet this one at another normal. */
static uint32_t forbidden(work *w, uint32_t triangle)
{
    uint32_t bits = 0;
    for (uint32_t corner = 3 * triangle; corner < 3 * triangle + 3; corner++) {
        const uint32_t place = place_of(w, corner);
        bits |= w->more[place] | (w->once[place] & ~w->has[cluster_at(w, corner)]);
    }
    return bits;
}

static void give(work *w, uint32_t triangle, uint32_t bit)
{
    w->result->group[triangle] |= bit;
    for (uint32_t corner = 3 * triangle; corner < 3 * triangle + 3; corner++) {
        const uint32_t place = place_of(w, corner);
        uint32_t *has = &w->has[cluster_at(w, corner)];
        if ((*has & bit) != 0)
            continue;
        *has |= bit;
        w->more[place] |= w->once[place] & bit;
        w->once[place] |= bit;
    }
}

static uint32_t lowest(uint32_t bits)
{
    return bits & (0u - bits);
}

/* Appends the triangle across a smooth edge to the region being gathered. */
static void grow(work *w, const edge *e)
{
    const uint32_t other = e->other_a / 3;
    if (w->seen[other] || !same_at_a(w, e) || !same_at_b(w, e))
        return;
    w->seen[other] = true;
    w->queue[w->queued++] = other;
}

/* All that smooth edges join to the triangle, itself first. */
static void gather(work *w, uint32_t triangle)
{
    w->queued = 0;
    w->seen[triangle] = true;
    w->queue[w->queued++] = triangle;
    for (size_t i = 0; i < w->queued; i++)
        visit_triangle(w, w->queue[i], grow);
}

static void mark(work *w, const edge *e)
{
    const uint32_t triangle = e->a / 3, other = e->other_a / 3;
    uint32_t *group = w->result->group;
    if (other < triangle || !same_at_a(w, e) || !same_at_b(w, e))
        return;
    w->result->smooth++;
    if ((group[triangle] & group[other]) != 0)
        return;
    const uint32_t allowed = ~(forbidden(w, triangle) | forbidden(w, other));
    const uint32_t known = allowed & (group[triangle] | group[other]);
    const uint32_t bit = lowest(known != 0 ? known : allowed);
    if (bit == 0) {
        w->result->unmarked++;
        return;
    }
    give(w, triangle, bit);
    give(w, other, bit);
}

/* A triangle alone needs no group: it is flat. */
static void mark_region(work *w)
{
    uint32_t taken = 0;
    if (w->queued == 1)
        return;
    for (size_t i = 0; i < w->queued; i++)
        taken |= forbidden(w, w->queue[i]);
    const uint32_t common = ~taken != 0 ? ~taken : ~forbidden(w, w->queue[0]);
    const uint32_t bit = lowest(common);
    for (size_t i = 0; bit != 0 && i < w->queued; i++)
        if ((forbidden(w, w->queue[i]) & bit) == 0)
            give(w, w->queue[i], bit);
    for (size_t i = 0; i < w->queued; i++)
        visit_triangle(w, w->queue[i], mark);
}

static void mark_all(work *w)
{
    uint32_t all = 0;
    for (size_t i = 0; i < w->mesh->triangle_count; i++) {
        if (!w->seen[i]) {
            gather(w, (uint32_t)i);
            mark_region(w);
        }
    }
    for (size_t i = 0; i < w->mesh->triangle_count; i++)
        all |= w->result->group[i];
    for (; all != 0; all &= all - 1)
        w->result->count++;
}

static bool make_room(work *w)
{
    const size_t triangles = w->mesh->triangle_count, places = w->places->count;
    w->cluster = malloc(3 * triangles * sizeof *w->cluster);
    w->parent = malloc(3 * triangles * sizeof *w->parent);
    w->normal = malloc(3 * triangles * sizeof *w->normal);
    w->has = calloc(3 * triangles, sizeof *w->has);
    w->once = calloc(places, sizeof *w->once);
    w->more = calloc(places, sizeof *w->more);
    w->queue = malloc(triangles * sizeof *w->queue);
    w->seen = calloc(triangles, sizeof *w->seen);
    w->result->group = calloc(triangles, sizeof *w->result->group);
    return w->cluster != NULL && w->parent != NULL && w->normal != NULL && w->has != NULL &&
           w->once != NULL && w->more != NULL && w->queue != NULL && w->seen != NULL &&
           w->result->group != NULL;
}

static void free_room(work *w)
{
    free(w->cluster);
    free(w->parent);
    free(w->normal);
    free(w->has);
    free(w->once);
    free(w->more);
    free(w->queue);
    free(w->seen);
}

glint_status glint_smoothing_groups_find(const glint_mesh *mesh, const glint_places *places,
                                         const volatile bool *stop, glint_smoothing_groups *groups,
                                         glint_error *err)
{
    *groups = (glint_smoothing_groups){.group = NULL};
    work w = {.mesh = mesh, .places = places, .stop = stop, .result = groups};
    if (!make_room(&w)) {
        free_room(&w);
        glint_smoothing_groups_clear(groups);
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for smoothing groups");
    }
    find_clusters(&w);
    for (size_t i = 0; i < mesh->triangle_count; i++)
        visit_triangle(&w, (uint32_t)i, join_ends);
    mark_all(&w);
    free_room(&w);
    if (stop != NULL && *stop) {
        glint_smoothing_groups_clear(groups);
        return glint_fail(err, GLINT_INTERRUPTED, "interrupted");
    }
    return GLINT_OK;
}

void glint_smoothing_groups_clear(glint_smoothing_groups *groups)
{
    free(groups->group);
    groups->group = NULL;
}
