/* Geometry: vertices projected onto the frame, triangles culled, clipped and prepared for
 * rasterization.
 *
 * Screen coordinates are fixed-point, 1/4096 of a pixel, x to the right and y down from the frame's
 * upper left corner; the sample of a pixel is its centre. From here on coverage is decided in
 * integers, so every question has exactly one answer. */
#ifndef GLINT_SIM_RENDER_SETUP_H
#define GLINT_SIM_RENDER_SETUP_H

#include "render/camera.h"

#define GLINT_SUBPIXEL_BITS 12
#define GLINT_SUBPIXEL_ONE  (1 << GLINT_SUBPIXEL_BITS)
#define GLINT_SUBPIXEL_HALF (GLINT_SUBPIXEL_ONE / 2)

/* The first pixel whose sample is at or after coordinate c, and the last one at or before. */
static inline int32_t glint_first_sample(int32_t c)
{
    return (c - GLINT_SUBPIXEL_HALF + GLINT_SUBPIXEL_ONE - 1) >> GLINT_SUBPIXEL_BITS;
}

static inline int32_t glint_last_sample(int32_t c)
{
    return (c - GLINT_SUBPIXEL_HALF) >> GLINT_SUBPIXEL_BITS;
}

/* Half the side of the square about the frame's centre to which triangles are clipped, in pixels:
 * beyond every frame, and small enough for the products of two coordinates to fit in 64 bits. Most
 * triangles that reach out of the frame stay within it and need no clipping. */
#define GLINT_GUARD 32768

/* A vertex on the frame. */
typedef struct glint_screen_vertex {
    int32_t x, y;     /* 1/4096 pixel; meaningless unless outside is 0 */
    float inv_w;      /* 1/w, linear on the screen: the depth, larger is nearer */
    float n[3];       /* normal/w in camera axes, linear on the screen */
    uint8_t color[3]; /* its intensities, where the shading has any at vertices */
    uint32_t outside; /* a bit for each clipping plane that it is beyond */
} glint_screen_vertex;

/* A triangle that faces the camera and whose box holds a sample. Corners clockwise as seen (y
 * down), so that the edge functions are positive inside. */
typedef struct glint_triangle {
    int32_t x[3], y[3];
    int32_t first_x, last_x, first_y, last_y; /* pixels whose samples its box holds */
    float inv_w[3], n[3][3];                  /* of each corner, as in glint_screen_vertex */
    uint8_t color[3][3];                      /* likewise; with flat shading all three are equal */
    uint8_t middle[3][3]; /* at the middles of the edges 0-1, 0-2, 1-2, where the shading lights
                             them (quadratic.h) */
    bool dull;            /* has no highlight, where that is asked (sheen.h) */
    uint32_t source;      /* the mesh's triangle that it is, or is a part of */
    double inv_area;      /* 1 / twice the area, in units of the edge functions */
} glint_triangle;

/* The triangles of one run of the mesh, in its order. */
typedef struct glint_triangle_list {
    glint_triangle *triangle;
    size_t count, capacity;
    int32_t first_y, last_y; /* pixel rows that any of them may cover */
} glint_triangle_list;

/* Rows and columns of the frame. */
typedef struct glint_extent {
    int32_t width, height;
} glint_extent;

/* Vertices first … last−1 of the mesh to screen[first] … screen[last−1], their colour black. */
void glint_setup_vertices(const glint_camera *camera, const glint_mesh *mesh, size_t first,
                          size_t last, glint_screen_vertex *screen);

/* Triangles first … last−1 of the mesh into list, which is emptied before. false: no memory. */
bool glint_setup_triangles(const glint_camera *camera, const glint_mesh *mesh, glint_extent extent,
                           const glint_screen_vertex *screen, size_t first, size_t last,
                           glint_triangle_list *list);

/* How many of the mesh's triangles the list is of: a triangle's parts lie together and count once.
 */
uint64_t glint_setup_sources(const glint_triangle_list *list);

#endif
