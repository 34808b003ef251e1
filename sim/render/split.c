/* Triangles in quarters, lit at the middles of their edges; see split.h. */
#include "render/split.h"

#include <stdlib.h>
#include <string.h>

#define MIDDLES  (3 * GLINT_SPLIT_RUN)
#define VERTICES (2 * MIDDLES)

_Static_assert(MIDDLES <= GLINT_POINTS_RUN, "the middles are lit in one run");

/* A mesh of its own: the middles of all edges, then the triangles' corners. Middle i of a triangle
 * lies opposite its corner i. */
struct glint_split {
    float position[3 * VERTICES], normal[3 * VERTICES];
    uint32_t index[12 * GLINT_SPLIT_RUN];
    glint_screen_vertex screen[VERTICES];
};

glint_split *glint_split_create(void)
{
    return malloc(sizeof(glint_split));
}

void glint_split_destroy(glint_split *split)
{
    free(split);
}

/* The normal of a middle is the sum of its ends': its length does not matter to light, but to the
 * interpolation of normals it would, so it is made 1. */
static void set_middle(glint_split *s, size_t at, const glint_mesh *mesh, uint32_t a, uint32_t b)
{
    const float *pa = &mesh->position[3 * (size_t)a], *pb = &mesh->position[3 * (size_t)b];
    const glint_vec3 n = glint_vec3_add(glint_vec3_of(&mesh->normal[3 * (size_t)a]),
                                        glint_vec3_of(&mesh->normal[3 * (size_t)b]));
    const double length = glint_vec3_length(n);
    for (int axis = 0; axis < 3; axis++)
        s->position[3 * at + (size_t)axis] = 0.5f * (pa[axis] + pb[axis]);
    glint_vec3_store(glint_vec3_scale(n, length > 0.0 ? 1.0 / length : 0.0), &s->normal[3 * at]);
}

static void set_corner(glint_split *s, size_t at, const glint_mesh *mesh, uint32_t vertex)
{
    memcpy(&s->position[3 * at], &mesh->position[3 * (size_t)vertex], 3 * sizeof(float));
    memcpy(&s->normal[3 * at], &mesh->normal[3 * (size_t)vertex], 3 * sizeof(float));
}

static void set_quarters(uint32_t *index, uint32_t middle, uint32_t corner)
{
    const uint32_t quarters[12] = {
        corner,     middle + 2, middle + 1, /* at corner 0 */
        middle + 2, corner + 1, middle,     /* at corner 1 */
        middle + 1, middle,     corner + 2, /* at corner 2 */
        middle,     middle + 1, middle + 2, /* between them */
    };
    memcpy(index, quarters, sizeof quarters);
}

static void cut(glint_split *s, const glint_mesh *mesh, const glint_screen_vertex *screen,
                size_t first, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const uint32_t *corner = &mesh->index[3 * (first + i)];
        const size_t middle = 3 * i, own = 3 * (count + i);
        for (size_t k = 0; k < 3; k++) {
            set_middle(s, middle + k, mesh, corner[(k + 1) % 3], corner[(k + 2) % 3]);
            set_corner(s, own + k, mesh, corner[k]);
            s->screen[own + k] = screen[corner[k]];
        }
        set_quarters(&s->index[12 * i], (uint32_t)middle, (uint32_t)own);
    }
}

glint_status glint_split_triangles(glint_split *split, const glint_point_light *light,
                                   glint_extent extent, const glint_screen_vertex *screen,
                                   size_t first, size_t last, glint_lit_points *points,
                                   glint_backend *backend, glint_triangle_list *list,
                                   uint64_t *lights, glint_error *err)
{
    const size_t count = last - first, middles = 3 * count;
    const glint_mesh quarters = {.vertex_count = 2 * middles,
                                 .position = split->position,
                                 .normal = split->normal,
                                 .triangle_count = 4 * count,
                                 .index = split->index};
    const glint_point_light own = {&quarters, light->camera, light->lighting};
    cut(split, light->mesh, screen, first, count);
    glint_setup_vertices(light->camera, &quarters, 0, middles, split->screen);
    const glint_status status =
        glint_light_vertices(points, &own, 0, middles, backend, split->screen, err);
    if (status != GLINT_OK)
        return status;
    *lights += middles;
    if (!glint_setup_triangles(light->camera, &quarters, extent, split->screen, 0, 4 * count, list))
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the frame's triangles");
    for (size_t i = 0; i < list->count; i++)
        list->triangle[i].source = (uint32_t)(first + list->triangle[i].source / 4);
    return GLINT_OK;
}
