/* The options that say what is rendered: the mesh, the light, the colours, the camera, the frame's
 * size and the threads. The same for every subcommand that renders. */
#ifndef GLINT_SIM_CLI_SCENE_OPTIONS_H
#define GLINT_SIM_CLI_SCENE_OPTIONS_H

#include "cli/options.h"
#include "render/render.h"

/* Which of the values that a preset has were given. */
typedef struct glint_scene_given {
    bool ia, ie, ka, kd, ks, color, highlight;
} glint_scene_given;

/* What the options fill; wider than the fields they end up in. */
typedef struct glint_scene_options {
    const char *model; /* "teapot", "sphere", "quad", or a path */
    const char *mesh;  /* the same without --model before it; NULL: not given so */
    bool model_given;
    int64_t density; /* of teapot or sphere; 0: its own default */
    int64_t threads;
    int width, height;
    double light[3];
    uint8_t color[3], highlight[3];
    double ia[3], ie[3]; /* R, G, B, each 0…1 */
    double ka, kd, ks, f0;
    double yaw, pitch, fov, distance;
    bool f0_given;
    glint_transform transform; /* of the object */
    int preset;                /* preset.h */
    glint_scene_given given;
} glint_scene_options;

/* The scene's defaults, the teapot, 640×480, a thread for each processor. */
glint_scene_options glint_scene_options_default(void);

/* For the details of --help: what a COLOR may be. */
#define GLINT_COLOR_DETAILS                                                                        \
    "A COLOR is R,G,B or rgb:R,G,B, each 0 to 255; #rrggbb; hsv:H,S,V in degrees and\n"            \
    "percent; or cmyk:C,M,Y,K in percent.\n"

/* Rows of a subcommand's option table. */
#define GLINT_SCENE_OPTIONS 21
void glint_scene_options_add(glint_scene_options *chosen, glint_option rows[GLINT_SCENE_OPTIONS]);

/* The argument that stands for --model: render mesh.obj. */
#define GLINT_SCENE_POSITIONAL(chosen)                                                             \
    {                                                                                              \
        .name = "MODEL", .value = &(chosen).mesh, .optional = true                                 \
    }

/* After the command line is read: the model, however it was given, and the preset's values where
 * none were given. Returns GLINT_OPTIONS_RUN, or
 * the exit status when it was given both ways. */
int glint_scene_options_settle(const char *command, glint_scene_options *chosen);

/* The scene without its mesh; n, shading and what computes the highlights are its defaults. */
glint_scene glint_scene_options_scene(const glint_scene_options *chosen);

/* Of the model chosen, its own where none was given; 0: it has none. */
int glint_scene_options_density(const glint_scene_options *chosen);

/* The model: built in, or read from its file. */
glint_status glint_scene_options_mesh(const glint_scene_options *chosen, glint_mesh **mesh,
                                      glint_error *err);

/* " lambert phong blinn …" */
#define GLINT_SPECULAR_NAME(id, definition, name) " " name
#define GLINT_SPECULAR_NAMES                      GLINT_REFLECTANCE_MODELS(GLINT_SPECULAR_NAME)

/* --f0 says something only with a microfacet model. Returns whether the model is one. */
bool glint_specular_takes_f0(glint_reflectance_model model);

#endif
