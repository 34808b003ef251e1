/* The chapter on rasterizers: the methods, and how one of them renders. */
#ifndef GLINT_SIM_REPORT_RASTERIZERS_H
#define GLINT_SIM_REPORT_RASTERIZERS_H

#include "render/render.h"
#include "report/chapter.h"

/* Compared with the first, Phong's shading. */
#define GLINT_RASTERIZERS 11

typedef struct glint_rasterizer {
    const char *name;
    glint_shading shading;
    glint_reflectance_model model; /* of the highlight */
} glint_rasterizer;

extern const glint_rasterizer glint_rasterizers[GLINT_RASTERIZERS];
#define GLINT_RASTERIZER_PHONG   0
#define GLINT_RASTERIZER_GOURAUD 1

/* A renderer with its picture, backend real, one thread. */
typedef struct glint_easel {
    const glint_report *report;
    glint_renderer *renderer;
    glint_image *image;
    glint_render_stats stats; /* of the last frame */
} glint_easel;

/* Destroyed also after a failure. */
glint_status glint_easel_create(const glint_report *report, int width, int height,
                                glint_easel *easel, glint_error *err);
void glint_easel_destroy(glint_easel *easel);

/* The scene by a rasterizer. */
glint_status glint_easel_paint(glint_easel *easel, const glint_scene *scene, int rasterizer,
                               glint_error *err);

/* Gouraud's six drawbacks of section 1.3, each as a figure that is 0 at best. */
#define GLINT_DRAWBACKS 6
extern const char *const glint_drawback_names[GLINT_DRAWBACKS];

glint_status glint_drawbacks_measure(const glint_report *report,
                                     double found[GLINT_RASTERIZERS][GLINT_DRAWBACKS],
                                     glint_error *err);

/* Gouraud's error on right triangles with legs along the axes over the least of those on the same
 * ones turned and on equilateral ones of the same area. */
glint_status glint_right_triangles_measure(const glint_report *report, double *ratio,
                                           glint_error *err);

/* The thesis's figures that are pictures: 2.1, 2.8, 2.11, 2.14; and the curves of 2.9. */
glint_status glint_rasterizer_figures(glint_report *report, glint_error *err);

#endif
