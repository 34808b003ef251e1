/* Gouraud's drawbacks (section 1.3) as figures. Letters are the thesis's:
 *
 *   a linear     light is not linear: NMSE of Lambert's light alone against Phong's shading
 *   b lost       highlights off the vertices are lost: the share of Phong's brightest level that is
 *                missing in the worst frame of a turning sphere, highlight alone
 *   c curvature  the surface between vertices is not seen: one triangle whose corners are lit
 * alike; the share of Phong's range of levels that is missing in it d flicker    the highlight's
 * energy over a turn by one facet: its deviation over its mean e star       highlights are stars,
 * not ellipses: by how much the area above half the peak falls short of that of the ellipse with
 * the same second moments, the worst frame f perspective  NMSE against Phong's shading of a quad
 * that recedes, Lambert's light alone */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "render/mesh_build.h"
#include "render/transform.h"
#include "report/rasterizers.h"

const char *const glint_drawback_names[GLINT_DRAWBACKS] = {"linear",  "lost", "curvature",
                                                           "flicker", "star", "perspective"};

#define WIDTH  320
#define HEIGHT 240

#define FACETS 16 /* of the turning sphere, round its axis */
#define TURN   12 /* frames of a turn by one facet */

typedef struct measuring {
    glint_easel easel;
    glint_image *phong;
    double (*found)[GLINT_DRAWBACKS];
} measuring;

static void keep(const glint_image *from, glint_image *to)
{
    const size_t pixels = (size_t)from->width * (size_t)from->height;
    memcpy(to->rgb, from->rgb, 3 * pixels);
    memcpy(to->object, from->object, pixels);
}

/* NMSE of every rasterizer against Phong's shading. */
static glint_status measure_nmse(measuring *m, const glint_scene *scene, int drawback,
                                 glint_error *err)
{
    glint_status status = glint_easel_paint(&m->easel, scene, GLINT_RASTERIZER_PHONG, err);
    keep(m->easel.image, m->phong);
    for (int i = 0; i < GLINT_RASTERIZERS && status == GLINT_OK; i++) {
        glint_image_difference difference;
        status = glint_easel_paint(&m->easel, scene, i, err);
        if (status == GLINT_OK)
            status = glint_image_compare(m->phong, m->easel.image, &difference, err);
        if (status == GLINT_OK)
            m->found[i][drawback] = difference.nmse;
    }
    return status;
}

/* ---- The highlight of a turning sphere ------------------------------------------------------- */

typedef struct highlight {
    double peak, energy, star;
} highlight;

static highlight highlight_of(const glint_image *image)
{
    highlight found = {0};
    double area = 0, x1 = 0, y1 = 0, xx = 0, yy = 0, xy = 0;
    const size_t pixels = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < pixels; i++) {
        found.peak = fmax(found.peak, image->rgb[3 * i]);
        found.energy += image->rgb[3 * i];
    }
    for (int y = 0; y < image->height; y++) {
        for (int x = 0; x < image->width; x++) {
            if (2 * image->rgb[3 * ((size_t)y * (size_t)image->width + (size_t)x)] <= found.peak)
                continue;
            area++;
            x1 += x;
            y1 += y;
            xx += (double)x * x;
            yy += (double)y * y;
            xy += (double)x * y;
        }
    }
    xx = xx / area - x1 * x1 / (area * area) + 1.0 / 12.0; /* a pixel's own */
    yy = yy / area - y1 * y1 / (area * area) + 1.0 / 12.0;
    xy = xy / area - x1 * y1 / (area * area);
    const double ellipse = 4.0 * 3.14159265358979323846 * sqrt(xx * yy - xy * xy);
    found.star = found.peak > 0.0 ? fmax(1.0 - area / ellipse, 0.0) : 1.0;
    return found;
}

static glint_status turned_sphere(int frame, glint_mesh **mesh, glint_error *err)
{
    const glint_transform turn = {.scale = {1, 1, 1},
                                  .rotate = {0, 360.0 / FACETS * frame / TURN, 0}};
    const glint_status status = glint_mesh_sphere(FACETS, mesh, err);
    return status == GLINT_OK ? glint_mesh_transform(*mesh, &turn, err) : status;
}

static glint_status shoot_turn(measuring *m, int frame, highlight found[GLINT_RASTERIZERS][TURN],
                               glint_error *err)
{
    glint_scene scene;
    glint_mesh *mesh = NULL;
    glint_status status = turned_sphere(frame, &mesh, err);
    glint_scene_defaults(&scene);
    scene.mesh = mesh;
    scene.ka = scene.kd = 0.0f;
    scene.ks = 1.0f;
    scene.n = 60;
    for (int i = 0; i < GLINT_RASTERIZERS && status == GLINT_OK; i++) {
        status = glint_easel_paint(&m->easel, &scene, i, err);
        found[i][frame] = highlight_of(m->easel.image);
    }
    glint_mesh_destroy(mesh);
    return status;
}

static void judge_turn(measuring *m, highlight found[GLINT_RASTERIZERS][TURN])
{
    for (int i = 0; i < GLINT_RASTERIZERS; i++) {
        double lost = 0, star = 0, sum = 0, squares = 0;
        for (int k = 0; k < TURN; k++) {
            lost = fmax(lost, 1.0 - found[i][k].peak / found[GLINT_RASTERIZER_PHONG][k].peak);
            star = fmax(star, found[i][k].star);
            sum += found[i][k].energy / TURN;
            squares += found[i][k].energy * found[i][k].energy / TURN;
        }
        m->found[i][1] = lost;
        m->found[i][3] = sqrt(fmax(squares - sum * sum, 0.0)) / sum;
        m->found[i][4] = star;
    }
}

static glint_status measure_turn(measuring *m, glint_error *err)
{
    highlight found[GLINT_RASTERIZERS][TURN];
    glint_status status = GLINT_OK;
    for (int frame = 0; frame < TURN && status == GLINT_OK; frame++)
        status = shoot_turn(m, frame, found, err);
    if (status == GLINT_OK)
        judge_turn(m, found);
    return status;
}

/* ---- One triangle lit alike at its corners --------------------------------------------------- */

static glint_status symmetric_triangle(glint_mesh **mesh, glint_error *err)
{
    const glint_status status = glint_mesh_new("triangle", 3, 1, mesh, err);
    for (int i = 0; i < 3 && status == GLINT_OK; i++) {
        const double angle = 2.0 * 3.14159265358979323846 / 3.0 * i;
        const glint_vec3 place = {sin(angle), cos(angle), 0.0};
        const glint_vec3 n = {0.7 * place.x, 0.7 * place.y, sqrt(1.0 - 0.49)};
        glint_mesh_add_vertex(*mesh, place, n);
    }
    if (status == GLINT_OK)
        glint_mesh_add_triangle(*mesh, 0, 2, 1);
    return status;
}

static double range_of(const glint_image *image)
{
    int low = 255, high = 0;
    const size_t pixels = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < pixels; i++) {
        const int level = image->rgb[3 * i];
        if (!image->object[i])
            continue;
        low = level < low ? level : low;
        high = level > high ? level : high;
    }
    return high - low;
}

static glint_status measure_curvature(measuring *m, glint_error *err)
{
    static const float ahead[3] = {0, 0, 1};
    glint_scene scene;
    glint_mesh *mesh = NULL;
    double range = NAN;
    glint_status status = symmetric_triangle(&mesh, err);
    glint_scene_defaults(&scene);
    scene.mesh = mesh;
    scene.yaw = scene.pitch = 0.0f;
    scene.fov = GLINT_FOV_MIN;
    scene.ks = 0.0f;
    memcpy(scene.light, ahead, sizeof ahead);
    for (int i = 0; i < GLINT_RASTERIZERS && status == GLINT_OK; i++) {
        status = glint_easel_paint(&m->easel, &scene, i, err);
        range = i == GLINT_RASTERIZER_PHONG ? range_of(m->easel.image) : range;
        m->found[i][2] = fabs(1.0 - range_of(m->easel.image) / range);
    }
    glint_mesh_destroy(mesh);
    return status;
}

static glint_status measure_lambert(measuring *m, int drawback, glint_mesh *mesh, glint_error *err)
{
    glint_scene scene;
    glint_scene_defaults(&scene);
    scene.mesh = mesh;
    scene.ks = 0.0f;
    return measure_nmse(m, &scene, drawback, err);
}

static glint_status measure_all(measuring *m, glint_error *err)
{
    glint_mesh *sphere = NULL, *quad = NULL;
    glint_status status = glint_mesh_sphere(FACETS, &sphere, err);
    if (status == GLINT_OK)
        status = glint_mesh_quad(&quad, err);
    if (status == GLINT_OK)
        status = measure_lambert(m, 0, sphere, err);
    if (status == GLINT_OK)
        status = measure_lambert(m, 5, quad, err);
    if (status == GLINT_OK)
        status = measure_turn(m, err);
    if (status == GLINT_OK)
        status = measure_curvature(m, err);
    glint_mesh_destroy(sphere);
    glint_mesh_destroy(quad);
    return status;
}

glint_status glint_drawbacks_measure(const glint_report *report,
                                     double found[GLINT_RASTERIZERS][GLINT_DRAWBACKS],
                                     glint_error *err)
{
    measuring m = {.found = found};
    glint_status status = glint_easel_create(report, WIDTH, HEIGHT, &m.easel, err);
    if (status == GLINT_OK)
        status = glint_image_create(WIDTH, HEIGHT, &m.phong, err);
    if (status == GLINT_OK)
        status = measure_all(&m, err);
    glint_image_destroy(m.phong);
    glint_easel_destroy(&m.easel);
    return status;
}

/* ---- Right triangles ------------------------------------------------------------------------- */

#define CELLS 12

static void add_patch_vertex(glint_mesh *mesh, double x, double y)
{
    const glint_vec3 n = {0.9 * x, 0.9 * y, 1.0};
    glint_mesh_add_vertex(mesh, (glint_vec3){x, y, -0.45 * (x * x + y * y)},
                          glint_vec3_scale(n, 1.0 / glint_vec3_length(n)));
}

/* A paraboloid over a square, in right triangles with legs along the axes; skewed: over a
 * parallelogram of the same area, in equilateral ones. */
static glint_status make_patch(bool skewed, glint_mesh **mesh, glint_error *err)
{
    const double height = skewed ? sqrt(sqrt(3.0) / 2.0) : 1.0;
    const double width = 1.0 / height, skew = skewed ? width / 2.0 : 0.0;
    const glint_status status =
        glint_mesh_new("patch", (CELLS + 1) * (CELLS + 1), 2 * CELLS * CELLS, mesh, err);
    if (status != GLINT_OK)
        return status;
    for (int row = 0; row <= CELLS; row++)
        for (int column = 0; column <= CELLS; column++) {
            const double x = 2.0 * column / CELLS - 1.0, y = 2.0 * row / CELLS - 1.0;
            add_patch_vertex(*mesh, x * width + y * skew, y * height);
        }
    for (uint32_t row = 0; row < CELLS; row++)
        for (uint32_t column = 0; column < CELLS; column++) {
            const uint32_t at = row * (CELLS + 1) + column;
            glint_mesh_add_triangle(*mesh, at, at + 1, at + CELLS + 1);
            glint_mesh_add_triangle(*mesh, at + 1, at + CELLS + 2, at + CELLS + 1);
        }
    return status;
}

/* Gouraud's NMSE against Phong's, the patch and the light turned together about the line of sight.
 */
static glint_status measure_patch(measuring *m, bool skewed, double degrees, double *nmse,
                                  glint_error *err)
{
    const glint_transform turn = {.scale = {1, 1, 1}, .rotate = {0, 0, degrees}};
    const double angle = degrees * 3.14159265358979323846 / 180.0;
    double found[GLINT_RASTERIZERS][GLINT_DRAWBACKS];
    glint_mesh *mesh = NULL;
    glint_scene scene;
    glint_status status = make_patch(skewed, &mesh, err);
    if (status == GLINT_OK)
        status = glint_mesh_transform(mesh, &turn, err);
    glint_scene_defaults(&scene);
    scene.mesh = mesh;
    scene.yaw = scene.pitch = 0.0f;
    scene.fov = GLINT_FOV_MIN;
    scene.distance = 140.0f;
    scene.n = 20;
    scene.light[0] = (float)(-0.6 * cos(angle) - 0.8 * sin(angle));
    scene.light[1] = (float)(-0.6 * sin(angle) + 0.8 * cos(angle));
    scene.light[2] = 1.6f;
    m->found = found;
    if (status == GLINT_OK)
        status = measure_nmse(m, &scene, 0, err);
    *nmse = found[GLINT_RASTERIZER_GOURAUD][0];
    glint_mesh_destroy(mesh);
    return status;
}

static glint_status measure_patches(measuring *m, double *ratio, glint_error *err)
{
    static const double angles[] = {7.5, 15, 22.5, 30, 37.5, 45, 52.5, 60, 67.5, 75, 82.5};
    double right, least;
    glint_status status = measure_patch(m, false, 0.0, &right, err);
    if (status == GLINT_OK)
        status = measure_patch(m, true, 0.0, &least, err);
    for (size_t i = 0; i < sizeof angles / sizeof angles[0] && status == GLINT_OK; i++) {
        double turned;
        status = measure_patch(m, false, angles[i], &turned, err);
        least = fmin(least, turned);
    }
    *ratio = status == GLINT_OK ? right / least : NAN;
    return status;
}

glint_status glint_right_triangles_measure(const glint_report *report, double *ratio,
                                           glint_error *err)
{
    measuring m = {0};
    glint_status status = glint_easel_create(report, WIDTH, HEIGHT, &m.easel, err);
    if (status == GLINT_OK)
        status = glint_image_create(WIDTH, HEIGHT, &m.phong, err);
    if (status == GLINT_OK)
        status = measure_patches(&m, ratio, err);
    glint_image_destroy(m.phong);
    glint_easel_destroy(&m.easel);
    return status;
}
