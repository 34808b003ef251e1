/* What a renderer holds between frames; private to render.c, which draws them, and to pick.c, which
 * looks at the last one. */
#ifndef GLINT_SIM_RENDER_RENDERER_H
#define GLINT_SIM_RENDER_RENDERER_H

#include "render/gouraud.h"
#include "render/points.h"
#include "render/quadratic_band.h"
#include "render/raster.h"
#include "render/render.h"
#include "render/setup.h"
#include "render/shade.h"
#include "render/split.h"
#include "render/tables.h"
#include "thread/crew.h"

/* One thread's own things. */
typedef struct glint_render_worker {
    glint_backend *backend;
    glint_visibility band;
    glint_visibility part; /* of it, dull or not; made for the first frame that needs it */
    glint_split *split;    /* likewise */
    glint_shader shader;
    glint_lit_points points;
    glint_gouraud *gouraud; /* made, with the divider, for the first frame that needs it */
    glint_divider_backend *divider;
    int divider_shifts;
    glint_quadratic_shader *quadratic; /* likewise */
    uint64_t fragments, highlights;    /* of this frame, like the next five */
    uint64_t drawn, sheen;
    double shading_seconds;
    glint_span_operations operations;
    uint64_t clocks_before; /* of the divider */
    glint_status status;
    glint_error error;
} glint_render_worker;

struct glint_renderer {
    glint_extent extent;
    int threads;
    glint_backend_config config;     /* of the backends */
    glint_backend_watch *watch;      /* of one thread, or NULL */
    glint_render_progress *progress; /* or NULL */
    void *progress_context;
    glint_crew *crew;
    glint_render_worker *workers;
    glint_record record;
    glint_material material; /* of the last frame */
    bool recorded;           /* the record holds a frame */
    bool prepared;           /* specular is of some frame, with f0 its parameter */
    glint_reflectance specular;
    float f0;
    glint_tables tables;
    glint_screen_vertex *screen;
    size_t screen_capacity;
    glint_triangle_list *lists; /* one for each run of the mesh's triangles */
    size_t list_count, list_capacity;
};

#endif
