/* The effect of the divider's errors on whole frames: Gouraud shading with various numbers of
 * shifts, against the same frames with exact values along edges and spans. */
#ifndef GLINT_SIM_REPORT_DIVIDER_FRAMES_H
#define GLINT_SIM_REPORT_DIVIDER_FRAMES_H

#include "render/render.h"
#include "report/chapter.h"

#define GLINT_DIVIDER_FRAME_WIDTH  640
#define GLINT_DIVIDER_FRAME_HEIGHT 480

/* Of the thesis, 6, 7 and 8; the default; and the most that there can be. */
#define GLINT_DIVIDER_FRAMES 5
extern const int glint_divider_frame_shifts[GLINT_DIVIDER_FRAMES];

/* Teapot and sphere, each at its default density and with larger triangles. */
#define GLINT_DIVIDER_SCENES 4

typedef struct glint_divider_frame {
    int shifts;
    glint_image_difference difference; /* from the exact frame */
    uint64_t verilog_pixels;           /* of the frame by the Verilog that differ from it */
} glint_divider_frame;

/* Of the triangles of about 100 pixels, the thesis's average: the pixels of their rows. */
typedef struct glint_divider_rows {
    uint64_t triangles, with_longer; /* such; those with a row of more steps than the table has */
    int longest;                     /* steps of the longest row */
} glint_divider_rows;

typedef struct glint_divider_scene {
    const char *model;
    int density;
    uint64_t drawn;     /* triangles */
    uint64_t divisions; /* of a frame, each of three components */
    glint_divider_rows rows;
    glint_divider_frame frames[GLINT_DIVIDER_FRAMES];
} glint_divider_scene;

/* Renders all of it (640x480, the default scene, highlights and quotients by the C model, then by
 * the Verilog). Of the first scene by the fewest shifts it writes divider-exact.png,
 * divider-frame.png and divider-difference.png. */
glint_status glint_divider_render_scenes(const glint_report *report,
                                         glint_divider_scene scenes[GLINT_DIVIDER_SCENES],
                                         glint_error *err);

#endif
