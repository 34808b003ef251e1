/* Sutherland and Hodgman's clipping, one plane after the other.
 *
 * A new corner is always computed from the end inside towards the end outside. Two triangles that
 * share an edge run along it in opposite directions, but so they cut it at the same point to the
 * last bit, and no crack opens where it is cut. */
#include "render/clip.h"

#include "render/setup.h"

/* How far inside a plane the point is, negative outside; linear in the point. */
static double inside(const glint_camera *camera, int plane, glint_view_point p)
{
    const double reach = GLINT_GUARD / camera->focal;
    switch (plane) {
    case 0:
        return p.w - GLINT_NEAR;
    case 1:
        return reach * p.w + p.x;
    case 2:
        return reach * p.w - p.x;
    case 3:
        return reach * p.w + p.y;
    default:
        return reach * p.w - p.y;
    }
}

uint32_t glint_clip_outside(const glint_camera *camera, glint_view_point p)
{
    uint32_t outside = 0;
    for (int plane = 0; plane < GLINT_CLIP_PLANES; plane++)
        if (inside(camera, plane, p) < 0.0)
            outside |= 1u << plane;
    return outside;
}

static double between(double a, double b, double t)
{
    return a + (b - a) * t;
}

static glint_clip_corner cut(const glint_clip_corner *in, double d_in, const glint_clip_corner *out,
                             double d_out)
{
    const double t = d_in / (d_in - d_out);
    return (glint_clip_corner){
        .p = {between(in->p.x, out->p.x, t), between(in->p.y, out->p.y, t),
              between(in->p.w, out->p.w, t)},
        .n = {between(in->n.x, out->n.x, t), between(in->n.y, out->n.y, t),
              between(in->n.z, out->n.z, t)},
        .color = {between(in->color[0], out->color[0], t), between(in->color[1], out->color[1], t),
                  between(in->color[2], out->color[2], t)},
    };
}

static int clip_plane(const glint_camera *camera, int plane, const glint_clip_corner *from,
                      int count, glint_clip_corner *to)
{
    int kept = 0;
    for (int i = 0; i < count; i++) {
        const glint_clip_corner *a = &from[i];
        const glint_clip_corner *b = &from[i + 1 < count ? i + 1 : 0];
        const double da = inside(camera, plane, a->p);
        const double db = inside(camera, plane, b->p);
        if (da >= 0.0) {
            to[kept++] = *a;
            if (db < 0.0)
                to[kept++] = cut(a, da, b, db);
        } else if (db >= 0.0) {
            to[kept++] = cut(b, db, a, da);
        }
    }
    return kept;
}

int glint_clip(const glint_camera *camera, uint32_t planes, glint_clip_corner *polygon)
{
    int count = 3;
    for (int plane = 0; plane < GLINT_CLIP_PLANES; plane++) {
        if ((planes & (1u << plane)) == 0)
            continue;
        glint_clip_corner from[GLINT_CLIP_CORNERS_MAX];
        for (int i = 0; i < count; i++)
            from[i] = polygon[i];
        count = clip_plane(camera, plane, from, count, polygon);
    }
    return count >= 3 ? count : 0;
}
