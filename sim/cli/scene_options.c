/* What is rendered, from the command line; see scene_options.h. */
#define _POSIX_C_SOURCE 200809L

#include "cli/scene_options.h"

#include <errno.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/output.h"
#include "cli/parse.h"
#include "cli/preset.h"
#include "cli/suggest.h"
#include "render/transform.h"

#define LIGHT_MAX 1e6

static int online_cores(void)
{
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    return cores < 1 ? 1 : cores > GLINT_THREADS_MAX ? GLINT_THREADS_MAX : (int)cores;
}

glint_scene_options glint_scene_options_default(void)
{
    glint_scene scene = {0};
    glint_scene_defaults(&scene);
    glint_scene_options chosen = {
        .model = "teapot",
        .threads = online_cores(),
        .transform = {.scale = {1.0, 1.0, 1.0}},
        .width = 640,
        .height = 480,
        .ka = (double)scene.ka,
        .kd = (double)scene.kd,
        .ks = (double)scene.ks,
        .f0 = GLINT_F0_DEFAULT,
        .yaw = (double)scene.yaw,
        .pitch = (double)scene.pitch,
        .fov = (double)scene.fov,
        .distance = (double)scene.distance,
    };
    for (int i = 0; i < 3; i++) {
        chosen.light[i] = (double)scene.light[i];
        chosen.color[i] = scene.color[i];
        chosen.highlight[i] = scene.highlight[i];
        chosen.ia[i] = (double)scene.ia[i];
        chosen.ie[i] = (double)scene.ie[i];
    }
    return chosen;
}

#define INTEGER(NAME, HELP, FIELD, MIN, MAX)                                                       \
    {                                                                                              \
        .name = NAME, .help = HELP, .kind = GLINT_OPTION_INTEGER, .integer = {                     \
            &chosen->FIELD,                                                                        \
            MIN,                                                                                   \
            MAX                                                                                    \
        }                                                                                          \
    }
#define REAL(NAME, HELP, FIELD, MIN, MAX)                                                          \
    {                                                                                              \
        .name = NAME, .help = HELP, .kind = GLINT_OPTION_REAL, .real = {                           \
            &chosen->FIELD,                                                                        \
            MIN,                                                                                   \
            MAX                                                                                    \
        }                                                                                          \
    }
/* What a preset has is noted when it is given. */
#define COEFFICIENT(NAME, HELP, FIELD)                                                             \
    {                                                                                              \
        .name = NAME, .help = HELP, .given = &chosen->given.FIELD, .kind = GLINT_OPTION_REAL,      \
        .real = {                                                                                  \
            &chosen->FIELD,                                                                        \
            0,                                                                                     \
            1                                                                                      \
        }                                                                                          \
    }
#define COLOR(NAME, HELP, FIELD)                                                                   \
    {                                                                                              \
        .name = NAME, .help = HELP, .given = &chosen->given.FIELD, .kind = GLINT_OPTION_COLOR,     \
        .color = chosen->FIELD                                                                     \
    }

#define INTENSITY(NAME, HELP, FIELD)                                                               \
    {                                                                                              \
        .name = NAME, .help = HELP, .given = &chosen->given.FIELD, .kind = GLINT_OPTION_INTENSITY, \
        .intensity = chosen->FIELD                                                                 \
    }
#define TRIPLE(NAME, HELP, FIELD, LIMIT, ALIKE)                                                    \
    {                                                                                              \
        .name = NAME, .help = HELP, .kind = GLINT_OPTION_REALS, .reals = {                         \
            chosen->transform.FIELD,                                                               \
            -(double)(LIMIT),                                                                      \
            (double)(LIMIT),                                                                       \
            ALIKE                                                                                  \
        }                                                                                          \
    }

void glint_scene_options_add(glint_scene_options *chosen, glint_option rows[GLINT_SCENE_OPTIONS])
{
    const glint_option options[] = {
        {.name = "model",
         .placeholder = "teapot|sphere|quad|FILE",
         .given = &chosen->model_given,
         .help = "a built-in model, or a mesh file (.3ds, .obj, .ply, .stl and more), also as a "
                 "plain argument",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->model},
        INTEGER("density",
                "tessellation of the teapot (1 to 256) or the sphere (4 to 4096, even); 0: the "
                "model's default",
                density, 0, GLINT_SPHERE_DENSITY_MAX),
        {.name = "size",
         .help = "frame size, in pixels",
         .kind = GLINT_OPTION_SIZE,
         .size = {&chosen->width, &chosen->height, GLINT_IMAGE_SIDE_MAX}},
        {.name = "threads",
         .usually = "one per processor",
         .help = "threads, each with its own circuit; does not change the picture",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->threads, 1, GLINT_THREADS_MAX}},
        {.name = "scene",
         .help = "a scene of the thesis's program, its Ia, Ie, Ka, Kd, Ks, C, S and n where none "
                 "are given",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->preset, glint_preset_names}},
        TRIPLE("rotate", "turns the object about its x, y and z axes, in degrees", rotate,
               GLINT_ANGLE_MAX, false),
        TRIPLE("scale", "scales the object along its axes; a negative factor mirrors it", scale,
               GLINT_SCALE_MAX, true),
        TRIPLE("move", "moves the object, in radii of its bounding sphere", move, GLINT_MOVE_MAX,
               false),
        COLOR("color", "C, the object's colour", color),
        COLOR("highlight", "S, the highlight's colour", highlight),
        {.name = "light",
         .help = "direction from the object to the light",
         .kind = GLINT_OPTION_REALS,
         .reals = {chosen->light, -LIGHT_MAX, LIGHT_MAX, false}},
        INTENSITY("ia", "Ia, intensity of the ambient light: one number, or R,G,B from 0 to 255",
                  ia),
        INTENSITY("ie", "Ie, intensity of the light source, likewise", ie),
        COEFFICIENT("ka", "Ka, ambient coefficient", ka),
        COEFFICIENT("kd", "Kd, diffuse coefficient", kd),
        COEFFICIENT("ks", "Ks, specular coefficient", ks),
        {.name = "f0",
         .help = "reflectance at normal incidence, for cook-torrance and torrance-sparrow",
         .given = &chosen->f0_given,
         .kind = GLINT_OPTION_REAL,
         .real = {&chosen->f0, 0, 1}},
        REAL("yaw", "camera azimuth around the object, degrees", yaw, -(double)GLINT_ANGLE_MAX,
             (double)GLINT_ANGLE_MAX),
        REAL("pitch", "camera elevation above the object, degrees", pitch, -(double)GLINT_ANGLE_MAX,
             (double)GLINT_ANGLE_MAX),
        REAL("fov", "vertical field of view, degrees", fov, (double)GLINT_FOV_MIN,
             (double)GLINT_FOV_MAX),
        REAL("distance",
             "camera distance from the object's centre, in object radii; 0: the object fills the "
             "frame",
             distance, 0, (double)GLINT_DISTANCE_MAX),
    };
    _Static_assert(sizeof options == GLINT_SCENE_OPTIONS * sizeof options[0], "as many rows");
    memcpy(rows, options, sizeof options);
}

int glint_scene_options_settle(const char *command, glint_scene_options *chosen)
{
    if (chosen->mesh != NULL && chosen->model_given) {
        glint_quoted quoted;
        return glint_complain(command, GLINT_EXIT_TROUBLE,
                              "--model and %s: only one model can be drawn",
                              glint_quote(chosen->mesh, &quoted));
    }
    if (chosen->mesh != NULL)
        chosen->model = chosen->mesh;
    for (int axis = 0; axis < 3; axis++) {
        const double factor = chosen->transform.scale[axis];
        if (fabs(factor) < GLINT_SCALE_MIN) {
            return glint_complain(command, GLINT_EXIT_TROUBLE,
                                  "--scale: a factor of %g would flatten the object: give at least "
                                  "%g, or at most %g",
                                  factor, GLINT_SCALE_MIN, -GLINT_SCALE_MIN);
        }
    }
    glint_preset_apply(chosen);
    return GLINT_OPTIONS_RUN;
}

glint_scene glint_scene_options_scene(const glint_scene_options *chosen)
{
    glint_scene scene = {0};
    glint_scene_defaults(&scene);
    scene.ka = (float)chosen->ka;
    scene.kd = (float)chosen->kd;
    scene.ks = (float)chosen->ks;
    scene.f0 = (float)chosen->f0;
    scene.yaw = (float)chosen->yaw;
    scene.pitch = (float)chosen->pitch;
    scene.fov = (float)chosen->fov;
    scene.distance = (float)chosen->distance;
    for (int i = 0; i < 3; i++) {
        scene.light[i] = (float)chosen->light[i];
        scene.ia[i] = (float)chosen->ia[i];
        scene.ie[i] = (float)chosen->ie[i];
        scene.color[i] = chosen->color[i];
        scene.highlight[i] = chosen->highlight[i];
    }
    return scene;
}

int glint_scene_options_density(const glint_scene_options *chosen)
{
    return chosen->density != 0                   ? (int)chosen->density
           : strcmp(chosen->model, "teapot") == 0 ? GLINT_TEAPOT_DENSITY
           : strcmp(chosen->model, "sphere") == 0 ? GLINT_SPHERE_DENSITY
                                                  : 0;
}

static glint_status no_such_model(const char *name, glint_error *err)
{
    static const char *const built_in[] = {"teapot", "sphere", "quad", NULL};
    glint_suggestion suggestion;
    return glint_fail(err, GLINT_BAD_ARGUMENT,
                      "%.300s: No such file or directory; built-in models are teapot, sphere and "
                      "quad%s",
                      name, glint_did_you_mean(name, built_in, "", &suggestion));
}

static glint_status load_mesh(const glint_scene_options *chosen, glint_mesh **mesh,
                              glint_error *err)
{
    if (strcmp(chosen->model, "teapot") == 0)
        return glint_mesh_teapot(glint_scene_options_density(chosen), mesh, err);
    if (strcmp(chosen->model, "sphere") == 0)
        return glint_mesh_sphere(glint_scene_options_density(chosen), mesh, err);
    if (chosen->density != 0) {
        return glint_fail(
            err, GLINT_BAD_ARGUMENT,
            "--density needs the teapot or the sphere: other models have fixed triangles");
    }
    if (strcmp(chosen->model, "quad") == 0)
        return glint_mesh_quad(mesh, err);
    struct stat found;
    if (stat(chosen->model, &found) != 0 && errno == ENOENT)
        return no_such_model(chosen->model, err);
    return glint_mesh_load(chosen->model, glint_stop_flag(), mesh, err);
}

glint_status glint_scene_options_mesh(const glint_scene_options *chosen, glint_mesh **mesh,
                                      glint_error *err)
{
    glint_status status = load_mesh(chosen, mesh, err);
    if (status != GLINT_OK)
        return status;
    status = glint_mesh_transform(*mesh, &chosen->transform, err);
    if (status != GLINT_OK) {
        glint_mesh_destroy(*mesh);
        *mesh = NULL;
    }
    return status;
}

bool glint_specular_takes_f0(glint_reflectance_model model)
{
    return glint_reflectance_describe(model)->cosine == GLINT_REFLECTANCE_OF_GEOMETRY;
}
