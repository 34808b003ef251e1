/* A scene rendered by two methods side by side, as in the program of the thesis's section 3.3: how
 * the pictures differ, how long a frame takes, and which triangles the highlight touches.
 *
 *     glint_study_setup setup = {.scene = …, .width = 640, .height = 480, .threads = 2};
 *     glint_study_method_parse("blinn", &setup.method[0], err);
 *     glint_study_method_parse("cosine-quadratic", &setup.method[1], err);
 *     glint_study_create(&setup, &study, err);
 *     glint_study_run(study, 50, 0, NULL, &row, err);      → row.difference.nmse
 *     glint_study_destroy(study); */
#ifndef GLINT_SIM_STUDY_STUDY_H
#define GLINT_SIM_STUDY_STUDY_H

#include "render/render.h"

/* What computes the highlights, and where. */
typedef struct glint_study_method {
    bool by_model;                 /* a reflectance model with backend real; else the backend */
    glint_reflectance_model model; /* by_model */
    glint_backend_kind backend;    /* not by_model; real: the device's formula */
    glint_shading shading;
} glint_study_method;

/* "MODEL", "c", "rtl" or "real", then, if it is not to be Phong's shading, ":flat", ":gouraud" or
 * ":gouraud-perspective". GLINT_BAD_ARGUMENT for anything else. */
glint_status glint_study_method_parse(const char *text, glint_study_method *method,
                                      glint_error *err);

/* The text again, in its shortest form: "cosine-quadratic", "rtl:gouraud". Returns name->text. */
typedef struct glint_study_name {
    char text[64];
} glint_study_name;

const char *glint_study_method_name(const glint_study_method *method, glint_study_name *name);

typedef struct glint_study_setup {
    glint_scene scene;            /* n, shading and model are the study's to set */
    glint_study_method method[2]; /* A, the reference, and B */
    int width, height, threads;
    const char *model;   /* what the mesh is called, for the tables alone: "sphere", a path */
    int density;         /* the same; 0: it has none */
    const char *verilog; /* of backend rtl: the directory with it; NULL: Glint's own */
} glint_study_setup;

typedef struct glint_study glint_study;

/* The setup's mesh must outlive the study. Fails as glint_renderer_create() does. */
glint_status glint_study_create(const glint_study_setup *setup, glint_study **study,
                                glint_error *err);
void glint_study_destroy(glint_study *study); /* NULL is allowed */

/* Frames timed of each method. */
#define GLINT_STUDY_FRAMES_MAX 1000

/* Of one n. All but the times is the same on every run and for any number of threads. */
typedef struct glint_study_row {
    int n;
    glint_image_difference difference; /* from A to B */
    uint64_t triangles;                /* of the mesh */
    uint64_t drawn;                    /* as in glint_render_stats; the more of A's and B's */
    uint64_t seen;                     /* of the mesh's, in at least one pixel */
    uint64_t highlit[2]; /* of these, with a pixel in which the highlight is seen: where the frame
                            is at least one level brighter, in any component, than with Ks = 0 */
    int frames;          /* timed of each; 0: none, and the times are 0 */
    double seconds[2];   /* of a frame, from mesh to picture: the median */
    double ratio;        /* B's time to A's: the median of the pairs' ratios */
} glint_study_row;

/* Renders both and compares them, then `frames` (0…GLINT_STUDY_FRAMES_MAX) pairs more for their
 * times, A and B in turn. GLINT_BAD_ARGUMENT for an n outside a model's domain, GLINT_BAD_INPUT if
 * the object is outside the frame, GLINT_INTERRUPTED when *stop (may be NULL) becomes true. */
glint_status glint_study_run(glint_study *study, int n, int frames, const volatile bool *stop,
                             glint_study_row *row, glint_error *err);

/* Only compares the pictures: half the work of a run without times. Fails likewise. */
glint_status glint_study_compare(glint_study *study, int n, const volatile bool *stop,
                                 glint_image_difference *difference, glint_error *err);

/* The picture of method 0 or 1 in the last run or comparison. */
const glint_image *glint_study_picture(const glint_study *study, int method);

#endif
