/* Light at vertices, on whole triangles, at six points of each, and at points of a caller. */
#include "render/points.h"

#include "render/quadratic.h"

/* Is lost in any sum but that of a vector without length, whose cosine it makes 0 instead of 0/0.
 */
#define TINY 1e-300

void glint_lit_points_add(glint_lit_points *points, const glint_lighting *lighting, glint_vec3 back,
                          glint_vec3 n)
{
    const glint_vec3 l = glint_vec3_of(lighting->light);
    const glint_vec3 v = glint_vec3_scale(back, 1.0 / sqrt(glint_vec3_dot(back, back) + TINY));
    const glint_vec3 h = glint_vec3_add(l, v);
    const double nn = glint_vec3_dot(n, n);
    const double nl = glint_vec3_dot(n, l);
    const double cosine =
        glint_vec3_dot(n, h) / (sqrt(nn + TINY) * sqrt(glint_vec3_dot(h, h) + TINY));
    const float diffuse = nl > 0.0 ? (float)(nl / sqrt(nn + TINY)) : 0.0f;
    const size_t at = points->count++;
    points->cos_code[at] = glint_cos_code_of((float)cosine);
    if (lighting->specular != NULL) {
        const double nv = glint_vec3_dot(n, v);
        const double inv_n = 1.0 / sqrt(nn + TINY);
        const glint_geometry geometry = {
            .nl = nl * inv_n,
            .nv = nv * inv_n,
            .nh = cosine,
            .rv = 2.0 * nl * nv / (nn + TINY) - glint_vec3_dot(l, v),
            .vh = 0.5 * glint_vec3_length(h),
        };
        points->value[at] = (float)glint_specular_value(lighting->specular, &geometry);
    }
    points->lit[at] = nl > 0.0 ? 255 : 0;
    for (int c = 0; c < 3; c++) {
        points->base[c][at] =
            glint_intensity_of(lighting->ambient[c] + lighting->lambert[c] * diffuse);
    }
}

void glint_lit_points_shadow(glint_lit_points *points, const glint_lighting *lighting)
{
    const size_t at = points->count - 1;
    points->lit[at] = 0;
    for (int c = 0; c < 3; c++)
        points->base[c][at] = glint_intensity_of(lighting->ambient[c]);
}

static glint_status find_highlights(glint_lit_points *points, const glint_lighting *lighting,
                                    glint_backend *backend, glint_error *err)
{
    const glint_material *material = &lighting->material;
    if (lighting->specular == NULL) {
        const glint_points run = {.cos = points->cos_code,
                                  .count = points->count,
                                  .r = points->highlight[0],
                                  .g = points->highlight[1],
                                  .b = points->highlight[2]};
        return glint_backend_shade(backend, material, &run, err);
    }
    const uint8_t color[3] = {material->r, material->g, material->b};
    for (int c = 0; c < 3; c++)
        glint_specular_color(points->count, points->value, color[c], points->highlight[c]);
    return GLINT_OK;
}

glint_status glint_lit_points_light(glint_lit_points *points, const glint_lighting *lighting,
                                    glint_backend *backend, glint_error *err)
{
    if (points->count == 0)
        return GLINT_OK;
    const glint_status status = find_highlights(points, lighting, backend, err);
    for (int c = 0; status == GLINT_OK && c < 3; c++)
        glint_add_highlight(points->count, points->highlight[c], points->lit, points->base[c]);
    return status;
}

/* The point p with a normal n of any length, seen from the eye. */
static void add_point(glint_lit_points *points, const glint_lighting *lighting, glint_view_point p,
                      glint_vec3 n)
{
    glint_lit_points_add(points, lighting, (glint_vec3){-p.x, -p.y, p.w}, n);
}

glint_status glint_light_vertices(glint_lit_points *points, const glint_point_light *light,
                                  size_t first, size_t last, glint_backend *backend,
                                  glint_screen_vertex *screen, glint_error *err)
{
    points->count = 0;
    for (size_t i = first; i < last; i++) {
        add_point(points, light->lighting,
                  glint_camera_view(light->camera, &light->mesh->position[3 * i]),
                  glint_camera_rotate(light->camera, glint_vec3_of(&light->mesh->normal[3 * i])));
    }
    const glint_status status = glint_lit_points_light(points, light->lighting, backend, err);
    for (size_t i = first; status == GLINT_OK && i < last; i++)
        for (int c = 0; c < 3; c++)
            screen[i].color[c] = points->base[c][i - first];
    return status;
}

static void add_triangle_point(glint_lit_points *points, const glint_point_light *light,
                               uint32_t triangle)
{
    const uint32_t *corner = &light->mesh->index[3 * (size_t)triangle];
    glint_view_point p[3];
    for (int i = 0; i < 3; i++)
        p[i] = glint_camera_view(light->camera, &light->mesh->position[3 * (size_t)corner[i]]);
    const glint_vec3 ab = {p[1].x - p[0].x, p[1].y - p[0].y, p[0].w - p[1].w};
    const glint_vec3 ac = {p[2].x - p[0].x, p[2].y - p[0].y, p[0].w - p[2].w};
    const glint_view_point centroid = {(p[0].x + p[1].x + p[2].x) / 3.0,
                                       (p[0].y + p[1].y + p[2].y) / 3.0,
                                       (p[0].w + p[1].w + p[2].w) / 3.0};
    add_point(points, light->lighting, centroid, glint_vec3_cross(ab, ac));
}

static void give_color(const glint_lit_points *points, size_t at, glint_triangle *t)
{
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 3; c++)
            t->color[i][c] = points->base[c][at];
}

glint_status glint_light_triangles(glint_lit_points *points, const glint_point_light *light,
                                   glint_backend *backend, glint_triangle_list *list,
                                   uint64_t *count, glint_error *err)
{
    points->count = 0;
    for (size_t i = 0; i < list->count; i++) /* parts of one triangle lie together */
        if (i == 0 || list->triangle[i].source != list->triangle[i - 1].source)
            add_triangle_point(points, light, list->triangle[i].source);
    *count = points->count;
    const glint_status status = glint_lit_points_light(points, light->lighting, backend, err);
    size_t at = 0;
    for (size_t i = 0; status == GLINT_OK && i < list->count; i++) {
        at += i > 0 && list->triangle[i].source != list->triangle[i - 1].source;
        give_color(points, at, &list->triangle[i]);
    }
    return status;
}

/* The point on the frame at (x, y), in subpixels, with the normal n there. Its way to the eye is
 * that of a fragment. */
static void add_screen_point(glint_lit_points *points, const glint_point_light *light, double x,
                             double y, const double n[3])
{
    const glint_camera *camera = light->camera;
    const glint_view_point p = {
        (x / GLINT_SUBPIXEL_ONE - camera->half_width) / camera->focal,
        (camera->half_height - y / GLINT_SUBPIXEL_ONE) / camera->focal,
        1.0,
    };
    add_point(points, light->lighting, p, (glint_vec3){n[0], n[1], n[2]});
}

enum { POINTS_OF_TRIANGLE = 6 };

/* N/w is linear on the screen, so a middle's has the direction of the sum of its ends'. */
static void add_six_points(glint_lit_points *points, const glint_point_light *light,
                           const glint_triangle *t)
{
    double n[3];
    for (int i = 0; i < 3; i++) {
        for (int axis = 0; axis < 3; axis++)
            n[axis] = (double)t->n[i][axis];
        add_screen_point(points, light, t->x[i], t->y[i], n);
    }
    for (int i = 0; i < 3; i++) {
        const int a = glint_edge_ends[i][0];
        const int b = glint_edge_ends[i][1];
        for (int axis = 0; axis < 3; axis++)
            n[axis] = (double)t->n[a][axis] + (double)t->n[b][axis];
        add_screen_point(points, light, 0.5 * ((double)t->x[a] + t->x[b]),
                         0.5 * ((double)t->y[a] + t->y[b]), n);
    }
}

static void give_six_colors(const glint_lit_points *points, size_t at, glint_triangle *t)
{
    for (size_t i = 0; i < 3; i++)
        for (int c = 0; c < 3; c++) {
            t->color[i][c] = points->base[c][at + i];
            t->middle[i][c] = points->base[c][at + 3 + i];
        }
}

glint_status glint_light_six_points(glint_lit_points *points, const glint_point_light *light,
                                    glint_backend *backend, glint_triangle_list *list,
                                    uint64_t *count, glint_error *err)
{
    const size_t in_a_run = GLINT_POINTS_RUN / POINTS_OF_TRIANGLE;
    glint_status status = GLINT_OK;
    for (size_t first = 0; status == GLINT_OK && first < list->count; first += in_a_run) {
        const size_t left = list->count - first;
        const size_t triangles = left < in_a_run ? left : in_a_run;
        points->count = 0;
        for (size_t i = 0; i < triangles; i++)
            add_six_points(points, light, &list->triangle[first + i]);
        *count += points->count;
        status = glint_lit_points_light(points, light->lighting, backend, err);
        for (size_t i = 0; status == GLINT_OK && i < triangles; i++)
            give_six_colors(points, POINTS_OF_TRIANGLE * i, &list->triangle[first + i]);
    }
    return status;
}
