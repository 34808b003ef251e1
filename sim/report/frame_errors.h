/* Whole frames by each formula against frames by exact cosⁿ: Table 3.2. */
#ifndef GLINT_SIM_REPORT_FRAME_ERRORS_H
#define GLINT_SIM_REPORT_FRAME_ERRORS_H

#include "report/section.h"
#include "study/study.h"

#define GLINT_FRAME_EXPONENTS_MAX 24

/* The thesis's test figures. */
typedef enum glint_test_figure {
    GLINT_FIGURE_SPHERE,
    GLINT_FIGURE_TEAPOT,
    GLINT_FIGURE_COUNT
} glint_test_figure;

extern const char *const glint_test_figure_names[GLINT_FIGURE_COUNT];

/* What of the scene Table 3.2 leaves open. The brighter the ambient light makes the picture, the
 * smaller the NMSE. */
typedef enum glint_frame_light {
    GLINT_LIGHT_WHITE,           /* the highlight white, Ka = 0.2 */
    GLINT_LIGHT_COLORED,         /* the highlight of the object's colour, Ka = 0.2 */
    GLINT_LIGHT_WHITE_AMBIENT,   /* white, with all of the ambient light: Ka = 1 */
    GLINT_LIGHT_COLORED_AMBIENT, /* of the object's colour, Ka = 1 */
    GLINT_LIGHT_COUNT
} glint_frame_light;

/* "highlight white, Ka = 0.2": what differs from light to light, as its scene has it. */
void glint_frame_light_say(glint_frame_light light, char *text, size_t room);

/* All of it but the mesh and n. */
void glint_frame_scene_say(const glint_scene *scene, char *text, size_t room);

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

/* What stands in for cosⁿ, and what it is compared with: methods of study.h. */
extern const char *const glint_frame_names[GLINT_FRAME_COUNT][2];

typedef struct glint_frame_errors {
    int width, height;
    int count; /* exponents */
    int n[GLINT_FRAME_EXPONENTS_MAX];
    double nmse[GLINT_FIGURE_COUNT][GLINT_LIGHT_COUNT][GLINT_FRAME_COUNT]
               [GLINT_FRAME_EXPONENTS_MAX];
} glint_frame_errors;

/* A scene of the report, all but its mesh. */
void glint_frame_scene(glint_frame_light light, glint_scene *scene);

glint_status glint_frame_mesh(glint_test_figure figure, glint_mesh **mesh, glint_error *err);

/* The exponents of the frames; returns how many. */
int glint_frame_exponents(bool quick, int n[GLINT_FRAME_EXPONENTS_MAX]);

/* Two methods of study.h, the reference first. The scene's mesh must outlive the study. */
glint_status glint_frame_study_create(const glint_report *report, const glint_scene *scene,
                                      int width, int height, const char *reference,
                                      const char *method, glint_study **study, glint_error *err);

glint_status glint_frame_errors_measure(const glint_report *report, glint_frame_errors *errors,
                                        glint_error *err);

/* Table 3.2, its figure, its claims and its numbers. */
glint_status glint_frame_errors_write(glint_report *report, const glint_frame_errors *errors,
                                      glint_error *err);

typedef struct glint_worst_frame {
    double nmse;
    int n;
} glint_worst_frame;

/* Which of the exponents are in a range: "18 exponents n = 1…169". */
void glint_frame_exponents_say(const int *n, int count, int n_from, int n_to, char *text,
                               size_t room);

/* The claims of Table 3.2, and of 3.1 and 3.4 on NMSE, from these numbers alone: each once for
 * every light. */
void glint_frame_errors_find(const glint_frame_errors *errors, glint_findings *findings);

/* The largest over exponents from n_from to n_to; not a number over none. */
glint_worst_frame glint_worst_frame_of(const glint_frame_errors *errors, glint_test_figure figure,
                                       glint_frame_light light, glint_frame_method method,
                                       int n_from, int n_to);

#endif
