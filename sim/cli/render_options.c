/* The command line of `glint render`; see render_options.h. */
#define _POSIX_C_SOURCE 200809L

#include "cli/render_options.h"

#include <unistd.h>

#include "cli/options.h"
#include "cli/output.h"

/* The option table's variables, which are wider than the fields they end up in. */
typedef struct raw_options {
    const char *model, *out;
    int64_t density, threads, n, shifts;
    int shading, backend, gate, pipeline, lanes;
    int width, height;
    double light[3];
    uint8_t color[3], highlight[3];
    double ia, ie, ka, kd, ks;
    double yaw, pitch, fov, distance;
    bool json;
} raw_options;

static const char *const backend_names[] = {"c", "rtl", "real", "both", NULL};
static const glint_backend_kind backend_kinds[] = {GLINT_BACKEND_C, GLINT_BACKEND_RTL,
                                                   GLINT_BACKEND_REAL};
#define BACKEND_BOTH 3

static const char *const shading_names[] = {
    [GLINT_SHADING_FLAT] = "flat",
    [GLINT_SHADING_GOURAUD] = "gouraud",
    [GLINT_SHADING_GOURAUD_PERSPECTIVE] = "gouraud-perspective",
    [GLINT_SHADING_PHONG] = "phong",
    [GLINT_SHADING_COUNT] = NULL,
};

static const char *const lane_names[] = {"auto", "1", "2", "4", "8", "16", NULL};
static const int lane_counts[] = {0, 1, 2, 4, 8, 16};

#define LIGHT_MAX 1e6

static int online_cores(void)
{
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    return cores < 1 ? 1 : cores > GLINT_THREADS_MAX ? GLINT_THREADS_MAX : (int)cores;
}

static raw_options defaults(void)
{
    glint_scene scene = {0};
    glint_scene_defaults(&scene);
    raw_options raw = {
        .model = "teapot",
        .threads = online_cores(),
        .n = scene.n,
        .shifts = scene.shifts,
        .shading = (int)scene.shading,
        .pipeline = GLINT_PIPELINE_PIPELINED,
        .width = 640,
        .height = 480,
        .ia = (double)scene.ia,
        .ie = (double)scene.ie,
        .ka = (double)scene.ka,
        .kd = (double)scene.kd,
        .ks = (double)scene.ks,
        .yaw = (double)scene.yaw,
        .pitch = (double)scene.pitch,
        .fov = (double)scene.fov,
        .distance = (double)scene.distance,
    };
    for (int i = 0; i < 3; i++) {
        raw.light[i] = (double)scene.light[i];
        raw.color[i] = scene.color[i];
        raw.highlight[i] = scene.highlight[i];
    }
    return raw;
}

static const char details[] =
    "A pixel is C(Ka Ia + Kd Ie N.L) + Ie Ks W(N.H) S: ambient light, Lambert's, and\n"
    "the device's highlight, saturated to 8 bits; alpha is 255 on the object. Axes: x\n"
    "right, y up, z towards the viewer. --shading flat computes that once for each\n"
    "triangle, gouraud at the vertices and interpolates on the screen, with increments\n"
    "by the divider (--backend real: exactly), gouraud-perspective interpolates on the\n"
    "object, phong computes it for each pixel.\n"
    "\n"
    "A COLOR is R,G,B or rgb:R,G,B, each 0 to 255; #rrggbb; hsv:H,S,V, degrees and\n"
    "percents; cmyk:C,M,Y,K, percents.\n"
    "\n"
    "--backend both renders by c and by rtl and compares. Where they differ, FILE.png\n"
    "is the frame of rtl, FILE-c.png that of c, FILE-diff.png shows the difference,\n"
    "FILE-failure is a packet for glint replay, and the exit status is 1.";

#define INTEGER(NAME, HELP, FIELD, MIN, MAX)                                                       \
    {                                                                                              \
        .name = NAME, .help = HELP, .kind = GLINT_OPTION_INTEGER, .integer = {                     \
            &raw->FIELD,                                                                           \
            MIN,                                                                                   \
            MAX                                                                                    \
        }                                                                                          \
    }
#define REAL(NAME, HELP, FIELD, MIN, MAX)                                                          \
    {                                                                                              \
        .name = NAME, .help = HELP, .kind = GLINT_OPTION_REAL, .real = { &raw->FIELD, MIN, MAX }   \
    }
#define CHOICE(NAME, HELP, FIELD, NAMES)                                                           \
    {                                                                                              \
        .name = NAME, .help = HELP, .kind = GLINT_OPTION_CHOICE, .choice = { &raw->FIELD, NAMES }  \
    }
#define COLOR(NAME, HELP, FIELD)                                                                   \
    {                                                                                              \
        .name = NAME, .help = HELP, .kind = GLINT_OPTION_COLOR, .color = raw->FIELD                \
    }

static int parse_raw(int argc, char **argv, raw_options *raw)
{
    const glint_option options[] = {
        {.name = "out",
         .placeholder = "FILE.png",
         .help = "the picture",
         .required = true,
         .kind = GLINT_OPTION_STRING,
         .string = &raw->out},
        {.name = "model",
         .placeholder = "teapot|sphere|quad|FILE",
         .help = "a built-in model, or a mesh file: .3ds, .obj, .ply, .stl and more",
         .kind = GLINT_OPTION_STRING,
         .string = &raw->model},
        INTEGER("density",
                "how finely the teapot (1 to 256) or the sphere (4 to 4096, even) is divided; 0: "
                "the model's own",
                density, 0, GLINT_SPHERE_DENSITY_MAX),
        CHOICE("shading", "where the light is computed: for each triangle, vertex or pixel",
               shading, shading_names),
        CHOICE("backend", "who computes the highlights, and divides for --shading gouraud", backend,
               backend_names),
        INTEGER("shifts", "shifts of the divider, for --shading gouraud", shifts,
                GLINT_DIVIDER_SHIFTS_MIN, GLINT_DIVIDER_SHIFTS_MAX),
        CHOICE("gate", "what decides that a point lies outside the highlight", gate,
               glint_gate_names),
        CHOICE("pipeline", "where the Verilog's registers are", pipeline, glint_pipeline_names),
        CHOICE("lanes", "cosines a clock in the Verilog", lanes, lane_names),
        INTEGER("threads", "threads, each with a circuit of its own; the picture is the same",
                threads, 1, GLINT_THREADS_MAX),
        {.name = "size",
         .help = "the frame, in pixels",
         .kind = GLINT_OPTION_SIZE,
         .size = {&raw->width, &raw->height, GLINT_IMAGE_SIDE_MAX}},
        INTEGER("n", "exponent of the highlight", n, 0, GLINT_N_MAX),
        COLOR("color", "C, the object's colour", color),
        COLOR("highlight", "S, the highlight's colour", highlight),
        {.name = "light",
         .help = "direction from the object to the light",
         .kind = GLINT_OPTION_REALS,
         .reals = {raw->light, -LIGHT_MAX, LIGHT_MAX}},
        REAL("ia", "Ia, intensity of the ambient light", ia, 0, 1),
        REAL("ie", "Ie, intensity of the light source", ie, 0, 1),
        REAL("ka", "Ka, ambient coefficient", ka, 0, 1),
        REAL("kd", "Kd, diffuse coefficient", kd, 0, 1),
        REAL("ks", "Ks, specular coefficient", ks, 0, 1),
        REAL("yaw", "camera's turn around the object, degrees", yaw, -(double)GLINT_ANGLE_MAX,
             (double)GLINT_ANGLE_MAX),
        REAL("pitch", "camera's rise above the object, degrees", pitch, -(double)GLINT_ANGLE_MAX,
             (double)GLINT_ANGLE_MAX),
        REAL("fov", "vertical field of view, degrees", fov, (double)GLINT_FOV_MIN,
             (double)GLINT_FOV_MAX),
        REAL("distance",
             "of the camera from the object's centre, in radii of the object; 0: the object fills "
             "the frame",
             distance, 0, (double)GLINT_DISTANCE_MAX),
        {.name = "json",
         .help = "the figures as JSON",
         .kind = GLINT_OPTION_FLAG,
         .flag = &raw->json},
    };
    const glint_command_line line = {
        .command = "render",
        .summary = "Renders a lit mesh into a PNG; every highlight is computed by the backend.",
        .details = details,
        .options = options,
        .option_count = sizeof options / sizeof options[0],
    };
    return glint_options_parse(&line, argc, argv);
}

static glint_scene scene_of(const raw_options *raw)
{
    glint_scene scene = {
        .ia = (float)raw->ia,
        .ie = (float)raw->ie,
        .ka = (float)raw->ka,
        .kd = (float)raw->kd,
        .ks = (float)raw->ks,
        .n = (uint16_t)raw->n,
        .yaw = (float)raw->yaw,
        .pitch = (float)raw->pitch,
        .fov = (float)raw->fov,
        .distance = (float)raw->distance,
        .shading = (glint_shading)raw->shading,
        .shifts = (int)raw->shifts,
    };
    for (int i = 0; i < 3; i++) {
        scene.light[i] = (float)raw->light[i];
        scene.color[i] = raw->color[i];
        scene.highlight[i] = raw->highlight[i];
    }
    return scene;
}

int glint_render_options_parse(int argc, char **argv, glint_render_options *chosen)
{
    raw_options raw = defaults();
    const int status = parse_raw(argc, argv, &raw);
    if (status != GLINT_OPTIONS_RUN) {
        return status;
    }
    const bool both = raw.backend == BACKEND_BOTH;
    *chosen = (glint_render_options){
        .model = raw.model,
        .density = (int)raw.density,
        .shading = shading_names[raw.shading],
        .both = both,
        .backend = {.kind = both ? GLINT_BACKEND_RTL : backend_kinds[raw.backend],
                    .gate = (glint_gate)raw.gate,
                    .pipeline = (glint_pipeline)raw.pipeline,
                    .lanes = lane_counts[raw.lanes]},
        .width = raw.width,
        .height = raw.height,
        .threads = (int)raw.threads,
        .scene = scene_of(&raw),
        .out = raw.out,
        .json = raw.json,
    };
    return GLINT_OPTIONS_RUN;
}
