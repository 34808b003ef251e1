/* From vertices and triangles of the mesh to triangles on the frame. */
#include "render/setup.h"

#include <stdlib.h>

#include "render/clip.h"

/* The nearest fixed-point coordinate; |pixels| is at most GLINT_GUARD and half a frame. */
static int32_t snap(double pixels)
{
    return (int32_t)floor(pixels * GLINT_SUBPIXEL_ONE + 0.5);
}

/* Projects a point inside all the clipping planes. Its colour is set later. */
static glint_screen_vertex project(const glint_camera *camera, glint_view_point p, glint_vec3 n)
{
    const double inv_w = 1.0 / p.w;
    return (glint_screen_vertex){
        .x = snap(camera->half_width + p.x * camera->focal * inv_w),
        .y = snap(camera->half_height - p.y * camera->focal * inv_w),
        .inv_w = (float)inv_w,
        .n = {(float)(n.x * inv_w), (float)(n.y * inv_w), (float)(n.z * inv_w)},
    };
}

void glint_setup_vertices(const glint_camera *camera, const glint_mesh *mesh, size_t first,
                          size_t last, glint_screen_vertex *screen)
{
    for (size_t i = first; i < last; i++) {
        const glint_view_point p = glint_camera_view(camera, &mesh->position[3 * i]);
        const uint32_t outside = glint_clip_outside(camera, p);
        if (outside != 0) {
            screen[i] = (glint_screen_vertex){.outside = outside};
        } else {
            screen[i] = project(camera, p,
                                glint_camera_rotate(camera, glint_vec3_of(&mesh->normal[3 * i])));
        }
    }
}

static int32_t lesser(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static int32_t greater(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

/* Finds the pixels of the frame whose samples lie in the triangle's box; false if there are
 * none. */
static bool find_box(glint_triangle *t, glint_extent extent)
{
    t->first_x = greater(glint_first_sample(lesser(lesser(t->x[0], t->x[1]), t->x[2])), 0);
    t->first_y = greater(glint_first_sample(lesser(lesser(t->y[0], t->y[1]), t->y[2])), 0);
    t->last_x =
        lesser(glint_last_sample(greater(greater(t->x[0], t->x[1]), t->x[2])), extent.width - 1);
    t->last_y =
        lesser(glint_last_sample(greater(greater(t->y[0], t->y[1]), t->y[2])), extent.height - 1);
    return t->first_x <= t->last_x && t->first_y <= t->last_y;
}

/* Twice the area, positive for corners that run clockwise as seen. */
static int64_t doubled_area(const glint_screen_vertex *a, const glint_screen_vertex *b,
                            const glint_screen_vertex *c)
{
    return (int64_t)(b->x - a->x) * (c->y - a->y) - (int64_t)(b->y - a->y) * (c->x - a->x);
}

static bool make_room(glint_triangle_list *list)
{
    if (list->count < list->capacity)
        return true;
    const size_t capacity = list->capacity > 0 ? 2 * list->capacity : 256;
    glint_triangle *bigger = realloc(list->triangle, capacity * sizeof *bigger);
    if (bigger == NULL)
        return false;
    list->triangle = bigger;
    list->capacity = capacity;
    return true;
}

/* Appends the triangle a, b, c, counter-clockwise from outside, unless it faces away or holds no
 * sample. false: no memory. */
static bool add_triangle(glint_triangle_list *list, glint_extent extent, uint32_t source,
                         const glint_screen_vertex *a, const glint_screen_vertex *b,
                         const glint_screen_vertex *c)
{
    const int64_t area = doubled_area(a, c, b);
    if (area <= 0)
        return true;
    glint_triangle t = {
        .x = {a->x, c->x, b->x},
        .y = {a->y, c->y, b->y},
        .inv_w = {a->inv_w, c->inv_w, b->inv_w},
        .n = {{a->n[0], a->n[1], a->n[2]},
              {c->n[0], c->n[1], c->n[2]},
              {b->n[0], b->n[1], b->n[2]}},
        .color = {{a->color[0], a->color[1], a->color[2]},
                  {c->color[0], c->color[1], c->color[2]},
                  {b->color[0], b->color[1], b->color[2]}},
        .source = source,
    };
    if (!find_box(&t, extent))
        return true;
    t.inv_area = 1.0 / (double)area;
    if (!make_room(list))
        return false;
    list->triangle[list->count++] = t;
    list->first_y = lesser(list->first_y, t.first_y);
    list->last_y = greater(list->last_y, t.last_y);
    return true;
}

/* The long way for a triangle that crosses a clipping plane: back to the camera's coordinates,
 * clip, project, and cut what is left into a fan. */
static bool add_clipped(const glint_camera *camera, const glint_mesh *mesh, glint_extent extent,
                        const glint_screen_vertex *vertices, uint32_t source, uint32_t planes,
                        glint_triangle_list *list)
{
    const uint32_t *corner = &mesh->index[3 * (size_t)source];
    glint_clip_corner polygon[GLINT_CLIP_CORNERS_MAX];
    for (int i = 0; i < 3; i++) {
        const size_t at = 3 * (size_t)corner[i];
        polygon[i].p = glint_camera_view(camera, &mesh->position[at]);
        polygon[i].n = glint_camera_rotate(camera, glint_vec3_of(&mesh->normal[at]));
        for (int c = 0; c < 3; c++)
            polygon[i].color[c] = vertices[corner[i]].color[c];
    }
    const int count = glint_clip(camera, planes, polygon);
    glint_screen_vertex screen[GLINT_CLIP_CORNERS_MAX];
    for (int i = 0; i < count; i++) {
        screen[i] = project(camera, polygon[i].p, polygon[i].n);
        for (int c = 0; c < 3; c++)
            screen[i].color[c] = (uint8_t)(polygon[i].color[c] + 0.5);
    }
    for (int i = 2; i < count; i++)
        if (!add_triangle(list, extent, source, &screen[0], &screen[i - 1], &screen[i]))
            return false;
    return true;
}

bool glint_setup_triangles(const glint_camera *camera, const glint_mesh *mesh, glint_extent extent,
                           const glint_screen_vertex *screen, size_t first, size_t last,
                           glint_triangle_list *list)
{
    list->count = 0;
    list->first_y = extent.height;
    list->last_y = -1;
    for (size_t i = first; i < last; i++) {
        const uint32_t *corner = &mesh->index[3 * i];
        const glint_screen_vertex *a = &screen[corner[0]];
        const glint_screen_vertex *b = &screen[corner[1]];
        const glint_screen_vertex *c = &screen[corner[2]];
        if ((a->outside & b->outside & c->outside) != 0)
            continue;
        const uint32_t planes = a->outside | b->outside | c->outside;
        const uint32_t source = (uint32_t)i;
        const bool added = planes == 0
                               ? add_triangle(list, extent, source, a, b, c)
                               : add_clipped(camera, mesh, extent, screen, source, planes, list);
        if (!added)
            return false;
    }
    return true;
}

uint64_t glint_setup_sources(const glint_triangle_list *list)
{
    uint64_t count = list->count > 0;
    for (size_t i = 1; i < list->count; i++)
        count += list->triangle[i].source != list->triangle[i - 1].source;
    return count;
}
