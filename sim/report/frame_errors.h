/* Whole frames with each formula, compared with frames using exact cosⁿ: Table 3.2. */
#ifndef GLINT_SIM_REPORT_FRAME_ERRORS_H
#define GLINT_SIM_REPORT_FRAME_ERRORS_H

#include "report/chapter.h"
#include "study/study.h"

#define GLINT_FRAME_EXPONENTS_MAX 24

/* The thesis's test figures, of figure 3.12. */
typedef enum glint_test_figure {
    GLINT_FIGURE_SPHERE,
    GLINT_FIGURE_TEAPOT,
    GLINT_FIGURE_COUNT
} glint_test_figure;

extern const char *const glint_test_figure_names[GLINT_FIGURE_COUNT];

glint_status glint_frame_mesh(glint_test_figure figure, glint_mesh **mesh, glint_error *err);

/* The scenes of the thesis's program: Ia = 0, light 238,138,32. Table 3.2 does not say which one it
 * used, nor whether the highlight is white, as in the listing, or has the light's colour. */
typedef enum glint_frame_light {
    GLINT_LIGHT_39_WHITE, /* figure 3.9: Kd = Ks = 0.5 */
    GLINT_LIGHT_39_OWN,
    GLINT_LIGHT_LISTING_WHITE, /* the listing: Kd = Ks = 1 */
    GLINT_LIGHT_LISTING_OWN,
    GLINT_LIGHT_COUNT
} glint_frame_light;

/* "3.9-white" and so on. */
extern const char *const glint_frame_light_names[GLINT_LIGHT_COUNT];

/* All of it but the mesh and n. */
void glint_frame_scene(glint_frame_light light, glint_scene *scene);

/* Each compared with cosⁿ (blinn, in single precision), but for the last two. */
typedef enum glint_frame_method {
    GLINT_FRAME_SCHLICK,
    GLINT_FRAME_SCHLICK_MODIFIED,
    GLINT_FRAME_SCHLICK_POWER,
    GLINT_FRAME_SCHLICK_SQUARED,
    GLINT_FRAME_QUADRATIC,
    GLINT_FRAME_COSINE_QUADRATIC,
    GLINT_FRAME_LYON_4,
    GLINT_FRAME_DEVICE,
    GLINT_FRAME_VERILOG,
    GLINT_FRAME_ROUNDING, /* the device against the cosine-quadratic: the circuit's own part */
    GLINT_FRAME_IMPLEMENTATION, /* the Verilog against the C model */
    GLINT_FRAME_COUNT
} glint_frame_method;

/* The replacement for cosⁿ, and its reference: methods of study.h. */
extern const char *const glint_frame_names[GLINT_FRAME_COUNT][2];

typedef struct glint_frame_errors {
    int width, height;
    int count; /* exponents */
    int n[GLINT_FRAME_EXPONENTS_MAX];
    double nmse[GLINT_FIGURE_COUNT][GLINT_LIGHT_COUNT][GLINT_FRAME_COUNT]
               [GLINT_FRAME_EXPONENTS_MAX];
} glint_frame_errors;

glint_status glint_frame_errors_measure(const glint_report *report, glint_frame_errors *errors,
                                        glint_error *err);

typedef struct glint_worst_frame {
    double nmse;
    int n;
    glint_test_figure figure;
} glint_worst_frame;

/* The largest over both figures and exponents from n_from to n_to; NaN if there are none. */
glint_worst_frame glint_worst_frame_of(const glint_frame_errors *errors, glint_frame_light light,
                                       glint_frame_method method, int n_from, int n_to);

/* NMSE of two methods of study.h, the reference first, for one scene (its mesh set) and n. */
glint_status glint_frame_nmse(const glint_report *report, const glint_scene *scene, int width,
                              int height, const char *reference, const char *method, int n,
                              double *nmse, glint_error *err);

#endif
