/* Vertices sorted into places by hashing, corners by counting; see places.h. */
#include "render/places.h"

#include <stdlib.h>
#include <string.h>

#define NOWHERE UINT32_MAX

static uint32_t hash_of(const float p[3])
{
    uint32_t hash = 2166136261u;
    for (int i = 0; i < 3; i++) {
        const float value = p[i] + 0.0f; /* −0 is 0 */
        uint32_t bits;
        memcpy(&bits, &value, sizeof bits);
        hash = (hash ^ bits) * 2654435761u;
        hash ^= hash >> 15;
    }
    return hash;
}

/* The slot of the vertex's place: empty, or with the first vertex that was there. */
static size_t find_slot(const glint_mesh *mesh, const uint32_t *table, size_t mask, size_t vertex)
{
    const float *p = &mesh->position[3 * vertex];
    size_t slot = hash_of(p) & mask;
    while (table[slot] != NOWHERE && !glint_same_place(&mesh->position[3 * (size_t)table[slot]], p))
        slot = (slot + 1) & mask;
    return slot;
}

static bool number_places(const glint_mesh *mesh, glint_places *places)
{
    size_t size = 16;
    while (size < 2 * mesh->vertex_count)
        size *= 2;
    uint32_t *table = malloc(size * sizeof *table);
    if (table == NULL)
        return false;
    memset(table, 0xff, size * sizeof *table);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const size_t slot = find_slot(mesh, table, size - 1, i);
        if (table[slot] == NOWHERE) {
            table[slot] = (uint32_t)i;
            places->of_vertex[i] = (uint32_t)places->count++;
        } else {
            places->of_vertex[i] = places->of_vertex[table[slot]];
        }
    }
    free(table);
    return true;
}

static bool sort_corners(const glint_mesh *mesh, glint_places *places)
{
    const size_t corners = 3 * mesh->triangle_count;
    places->start = calloc(places->count + 2, sizeof *places->start);
    places->corner = malloc(corners * sizeof *places->corner);
    if (places->start == NULL || places->corner == NULL)
        return false;
    uint32_t *next = places->start + 1; /* moves on to where the following place begins */
    for (size_t i = 0; i < corners; i++)
        next[places->of_vertex[mesh->index[i]] + 1]++;
    for (size_t i = 1; i <= places->count; i++) {
        places->most = next[i] > places->most ? next[i] : places->most;
        next[i] += next[i - 1];
    }
    for (size_t i = 0; i < corners; i++)
        places->corner[next[places->of_vertex[mesh->index[i]]]++] = (uint32_t)i;
    return true;
}

bool glint_places_find(const glint_mesh *mesh, glint_places *places)
{
    *places = (glint_places){.count = 0};
    places->of_vertex = malloc((mesh->vertex_count + 1) * sizeof *places->of_vertex);
    return places->of_vertex != NULL && number_places(mesh, places) && sort_corners(mesh, places);
}

void glint_places_clear(glint_places *places)
{
    free(places->of_vertex);
    free(places->start);
    free(places->corner);
    *places = (glint_places){.count = 0};
}
