/* The command line of `glint render`; see render_options.h. */
#include "cli/render_options.h"

#include <math.h>
#include <string.h>

#include "circuit/circuits.h"
#include "circuit/units.h"
#include "cli/circuit_options.h"
#include "cli/device_options.h"
#include "cli/model_names.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/parse.h"
#include "cli/picture.h"
#include "cli/preset.h"
#include "cli/shading_options.h"
#include "cli/slips.h"
#include "glint_quadratic_span.h"
#include "render/shadings.h"

/* What the option table fills besides the scene. */
typedef struct raw_options {
    glint_scene_options scene;
    glint_device_options device;
    glint_trace_options trace;
    glint_shading_options shadings;
    const char *out, *specular, *slips, *verilog;
    double n;
    int64_t shifts, fraction;
    int shading, backend, shader;
    bool json, force, n_given, shifts_given, fraction_given;
} raw_options;

static const char *const backend_names[] = {"c", "rtl", "real", "both", "gl", NULL};
static const glint_backend_kind backend_kinds[] = {GLINT_BACKEND_C, GLINT_BACKEND_RTL,
                                                   GLINT_BACKEND_REAL};
#define BACKEND_BOTH 3
#define BACKEND_GL   4

static const char *const shader_names[] = {"model", "gold", NULL};
#define SHADER_GOLD 1

static raw_options defaults(void)
{
    glint_scene scene = {0};
    glint_scene_defaults(&scene);
    return (raw_options){
        .scene = glint_scene_options_default(),
        .shadings = glint_shading_options_default(),
        .n = scene.n,
        .shifts = scene.shifts,
        .fraction = scene.fraction,
        .shading = (int)scene.shading,
    };
}

static const char details[] =
    "A pixel is C(Ka Ia + Kd Ie N.L) + Ie Ks W(N.H) S: ambient light, Lambert's diffuse\n"
    "light and the device's highlight, saturated to 8 bits; alpha is 255 on the object.\n"
    "Axes: x right, y up, z towards the viewer. --shading flat evaluates this once per\n"
    "triangle; gouraud at the vertices, interpolating on the screen with increments from\n"
    "the divider (--backend real: exactly); gouraud-perspective interpolates on the\n"
    "object; phong evaluates it at every pixel. quadratic evaluates it at the corners of\n"
    "each triangle and the middles of its edges; the span unit walks the quadratic through\n"
    "these six values, by second differences (--backend real: exactly); quadratic-listing\n"
    "interpolates as the thesis's listing does, with its slips.\n"
    "\n"
    "More shadings, after the thesis's appendix A: mixed is gouraud in triangles without\n"
    "a highlight and phong in the others; gouraud-4 cuts each triangle through the lit\n"
    "middles of its edges; cosine-linear interpolates N.L and N.H themselves;\n"
    "phong-unnormalised and phong-newton save normalising the normal, the latter with one\n"
    "Newton step; reflection-map looks the light up in a table over normals. wires and\n"
    "normals show the triangulation and the normals, with --backend real.\n"
    "\n" GLINT_TRACE_DETAILS "\n"
    "--specular replaces W with a model's value, computed from unrounded cosines: N.H,\n"
    "or R.V for phong; cook-torrance and torrance-sparrow give Rs of (1.4) with\n"
    "roughness sqrt(2/(n+2)); lambert gives diffuse light only, no highlight.\n"
    "\n" GLINT_COLOR_DETAILS "\n" GLINT_PICTURE_DETAILS "\n"
    "--backend both renders with c and with rtl and compares. If they differ, FILE.png is\n"
    "rtl's frame, FILE-c.png c's, FILE-diff.png the difference, and FILE-failure a packet\n"
    "for glint replay.\n"
    "\n"
    "--backend gl draws the whole frame with OpenGL, by Mesa in software: shaders for\n"
    "every model; without --specular the device's formula. It needs libegl1 and\n"
    "libgl1-mesa-dri.";

#define OWN_ROWS 12
#define TABLE_ROWS                                                                                 \
    (OWN_ROWS + GLINT_SHADING_OPTIONS + GLINT_TRACE_OPTIONS + GLINT_DEVICE_OPTIONS +               \
     GLINT_SCENE_OPTIONS)

static size_t fill_table(raw_options *raw, glint_option table[TABLE_ROWS])
{
    const glint_option own[OWN_ROWS] = {
        {.name = "out",
         .placeholder = "FILE.png",
         .help = "the picture; - is standard output",
         .required = true,
         .kind = GLINT_OPTION_STRING,
         .string = &raw->out},
        {.name = "shading",
         .placeholder = "SHADING",
         .help = "where the light is computed: flat, gouraud, gouraud-perspective, phong, or "
                 "another that is named below",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&raw->shading, glint_shading_names}},
        {.name = "backend",
         .help = "what computes the highlights, divides for --shading gouraud, gouraud-4 and "
                 "mixed, and walks spans for quadratic",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&raw->backend, backend_names}},
        {.name = "specular",
         .placeholder = "MODEL",
         .help = "with --backend real or gl: highlights from a reflectance model, one "
                 "of" GLINT_SPECULAR_NAMES,
         .kind = GLINT_OPTION_STRING,
         .string = &raw->specular},
        {.name = "n",
         .placeholder = "N",
         .given = &raw->n_given,
         .help = "exponent of the highlight; a fraction needs --specular",
         .kind = GLINT_OPTION_REAL,
         .real = {&raw->n, 0, GLINT_N_MAX}},
        {.name = "shifts",
         .given = &raw->shifts_given,
         .help = "the divider's shifts, for --shading gouraud, gouraud-4 and mixed",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&raw->shifts, GLINT_DIVIDER_SHIFTS_MIN, GLINT_DIVIDER_SHIFTS_MAX}},
        {.name = "fraction",
         .given = &raw->fraction_given,
         .help = "fraction bits of the span unit's numbers, for --shading quadratic",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&raw->fraction, GLINT_QUADRATIC_SPAN_FRACTION_MIN,
                     GLINT_QUADRATIC_SPAN_FRACTION_MAX}},
        {.name = "slips",
         .placeholder = "LIST",
         .help = "for --shading quadratic-listing: all, none, or some of" GLINT_SLIP_NAMES,
         .usually = "all",
         .kind = GLINT_OPTION_STRING,
         .string = &raw->slips},
        {.name = "shader",
         .help = "with --backend gl: the model's, or the thesis's bump-mapped gold, on which "
                 "--light, --n, --color, --highlight, --ia, --ie, --ka, --kd and --ks have no "
                 "effect",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&raw->shader, shader_names}},
        GLINT_RTL_OPTION(&raw->verilog),
        GLINT_FORCE_OPTION(&raw->force),
        {.name = "json",
         .help = "print the figures as JSON",
         .kind = GLINT_OPTION_FLAG,
         .flag = &raw->json},
    };
    memcpy(table, own, sizeof own);
    size_t count = OWN_ROWS;
    glint_shading_options_add(&raw->shadings, table + count);
    count += GLINT_SHADING_OPTIONS;
    glint_trace_options_add(&raw->trace, table + count);
    count += GLINT_TRACE_OPTIONS;
    count += glint_device_options_add(&raw->device, table + count);
    glint_scene_options_add(&raw->scene, table + count);
    return count + GLINT_SCENE_OPTIONS;
}

static int parse_raw(int argc, char **argv, raw_options *raw)
{
    glint_option options[TABLE_ROWS];
    const size_t count = fill_table(raw, options);
    static const glint_example examples[] = {
        {"a teapot, every highlight computed in Verilog", "glint render --backend rtl --out a.png"},
        {"C against Verilog", "glint render --backend both --n 50 --out b.png"},
        {"by the accurate power device", "glint render --device power --n 50 --out p.png"},
        {"your own mesh", "glint render mesh.obj --color '#3060a0' --out c.png"},
        {"by rays, seven pixels of eight interpolated where they may be",
         "glint render --method trace --segment 7 --shadows --out t.png"},
        {"to standard output", "glint render --size 320x240 --out - > d.png"},
        {"by OpenGL, in software", "glint render --backend gl --specular blinn --out e.png"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "render",
        .summary = "Renders a lit mesh to a PNG; the backend computes every highlight.",
        .details = details,
        .different = "--backend both: c and rtl differ; --isc on: it changes the picture",
        .examples = examples,
        .options = options,
        .option_count = count,
        .positionals = &(glint_positional)GLINT_SCENE_POSITIONAL(raw->scene),
        .positional_count = 1,
    };
    return glint_options_parse(&line, argc, argv);
}

/* The model by its name, into the scene. Returns the exit status, GLINT_OPTIONS_RUN when all is
 * well. */
static int choose_specular(const raw_options *raw, glint_render_options *chosen)
{
    glint_scene *scene = &chosen->scene;
    if (raw->specular != NULL) {
        if (!glint_reflectance_find(raw->specular, &scene->specular))
            return glint_refuse_model("render", "specular", raw->specular);
        if (chosen->backend.kind != GLINT_BACKEND_REAL) {
            return glint_complain(
                "render", GLINT_EXIT_TROUBLE,
                "--specular needs --backend real or gl: the other backends are the device itself");
        }
        if (chosen->backend.device != &glint_circuit_specular) {
            return glint_complain("render", GLINT_EXIT_TROUBLE,
                                  "--specular and --device both name what computes the highlights: "
                                  "give one of them");
        }
        if (!glint_shading_uses_circuit(scene->shading)) {
            return glint_complain("render", GLINT_EXIT_TROUBLE,
                                  "--shading %s has no highlight: leave --specular out",
                                  glint_shading_names[scene->shading]);
        }
        scene->by_model = true;
    }
    if (raw->scene.f0_given && !(scene->by_model && glint_specular_takes_f0(scene->specular))) {
        return glint_complain("render", GLINT_EXIT_TROUBLE,
                              "--f0 needs --specular cook-torrance or torrance-sparrow");
    }
    return GLINT_OPTIONS_RUN;
}

static int choose_slips(const raw_options *raw, glint_scene *scene)
{
    if (raw->slips == NULL)
        return GLINT_OPTIONS_RUN;
    if (scene->shading != GLINT_SHADING_QUADRATIC_LISTING) {
        return glint_complain("render", GLINT_EXIT_TROUBLE,
                              "--slips needs --shading quadratic-listing: no other has any");
    }
    return glint_slips_parse("render", raw->slips, &scene->slips);
}

/* Options of a circuit that has nothing to do in this frame. */
static int check_needless(const raw_options *raw, const glint_render_options *chosen)
{
    const glint_shading shading = chosen->scene.shading;
    const bool real = chosen->backend.kind == GLINT_BACKEND_REAL;
    const char *needless = glint_device_options_needless(&raw->device);
    if (raw->shifts_given && (real || !glint_shading_divides(shading))) {
        return glint_complain("render", GLINT_EXIT_TROUBLE,
                              "--shifts needs the divider: --shading gouraud, gouraud-4 or mixed, "
                              "with --backend c, rtl or both");
    }
    if (raw->fraction_given && (real || shading != GLINT_SHADING_QUADRATIC)) {
        return glint_complain("render", GLINT_EXIT_TROUBLE,
                              "--fraction needs the span unit: --shading quadratic, with --backend "
                              "c, rtl or both");
    }
    if (chosen->scene.by_model && needless != NULL) {
        return glint_complain("render", GLINT_EXIT_TROUBLE,
                              "--%s is of the device: leave it out with --backend gl and "
                              "--specular, which have none",
                              needless);
    }
    return GLINT_OPTIONS_RUN;
}

/* Of the device, and of what the shading needs besides. */
static int check_verilog(const glint_render_options *chosen)
{
    const bool is_used = chosen->backend.kind == GLINT_BACKEND_RTL;
    const glint_setting device = glint_backend_setting(&chosen->backend);
    glint_setting other;
    int status = glint_rtl_option_settle("render", &device, is_used);
    if (status != GLINT_OPTIONS_RUN || !glint_scene_circuit(&chosen->scene, &other))
        return status;
    other.verilog = chosen->backend.verilog;
    return glint_rtl_option_settle("render", &other, is_used);
}

/* What computes the highlights there is a shader, by default of the device's formula. */
/* A unit that is made for one n draws that one, and no other is asked for in vain. */
static int choose_n(const raw_options *raw, glint_render_options *chosen)
{
    const glint_backend_config *backend = &chosen->backend;
    const int only = glint_highlight_only_n(backend->device, backend->variant);
    if (only != 0 && raw->n_given && raw->n != only)
        return glint_complain("render", GLINT_EXIT_TROUBLE,
                              "--n %g: --device %s with --exponent %d is for that n alone", raw->n,
                              backend->device->name, only);
    if (only != 0)
        chosen->scene.n = only;
    return GLINT_OPTIONS_RUN;
}

static int check_isc(const raw_options *raw, const glint_render_options *chosen)
{
    if (!raw->trace.traced || !chosen->scene.isc)
        return GLINT_OPTIONS_RUN;
    return glint_complain("render", GLINT_EXIT_TROUBLE,
                          "--isc is for triangles on the screen: leave --method trace out");
}

/* Models take any n. */
static int check_fraction_of_n(const glint_render_options *chosen)
{
    const double n = chosen->scene.n;
    if (chosen->scene.by_model || n == floor(n))
        return GLINT_OPTIONS_RUN;
    return glint_complain("render", GLINT_EXIT_TROUBLE,
                          "--n: the device's n is a whole number, not %g; fractions need "
                          "--backend real --specular MODEL",
                          n);
}

static int settle_gl(const raw_options *raw, glint_render_options *chosen)
{
    if (chosen->backend.device != &glint_circuit_specular) {
        return glint_complain("render", GLINT_EXIT_TROUBLE,
                              "--device needs another backend: --backend gl has a shader for each "
                              "model of --specular");
    }
    if (raw->shadings.isc != 0) {
        return glint_complain("render", GLINT_EXIT_TROUBLE,
                              "--isc needs another backend: --backend gl draws every pixel alike");
    }
    if (chosen->gold && chosen->scene.by_model) {
        return glint_complain("render", GLINT_EXIT_TROUBLE,
                              "--shader gold has a highlight of its own: leave --specular out");
    }
    if (chosen->gold && chosen->scene.shading != GLINT_SHADING_PHONG) {
        return glint_complain("render", GLINT_EXIT_TROUBLE,
                              "--shader gold is evaluated at every pixel: it needs --shading "
                              "phong");
    }
    if (!chosen->scene.by_model) {
        chosen->scene.by_model = true;
        chosen->scene.specular = GLINT_REFLECTANCE_COSINE_QUADRATIC;
    }
    return GLINT_OPTIONS_RUN;
}

int glint_render_options_parse(int argc, char **argv, glint_render_options *chosen)
{
    raw_options raw = defaults();
    glint_device_options_begin(&raw.device);
    glint_trace_options_begin(&raw.trace);
    int status = parse_raw(argc, argv, &raw);
    if (status == GLINT_OPTIONS_RUN)
        status = glint_scene_options_settle("render", &raw.scene);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    if (glint_picture_is_stdout(raw.out) && (raw.json || raw.backend == BACKEND_BOTH)) {
        return glint_complain(
            "render", GLINT_EXIT_TROUBLE, "%s",
            raw.json ? "--json cannot be used with --out -: both write to standard output"
                     : "--backend both may write several pictures: give --out a file name, not -");
    }
    if (!raw.n_given)
        raw.n = glint_preset_n(&raw.scene);
    if (raw.shader == SHADER_GOLD && raw.backend != BACKEND_GL)
        return glint_complain("render", GLINT_EXIT_TROUBLE, "--shader gold needs --backend gl");
    const bool both = raw.backend == BACKEND_BOTH;
    const bool gl = raw.backend == BACKEND_GL;
    *chosen = (glint_render_options){
        .what = raw.scene,
        .both = both,
        .gl = gl,
        .gold = raw.shader == SHADER_GOLD,
        .backend = {.kind = both ? GLINT_BACKEND_RTL
                            : gl ? GLINT_BACKEND_REAL
                                 : backend_kinds[raw.backend],
                    .verilog = raw.verilog},
        .scene = glint_scene_options_scene(&raw.scene),
        .out = raw.out,
        .force = raw.force,
        .json = raw.json,
    };
    chosen->scene.n = raw.n;
    chosen->scene.shading = (glint_shading)raw.shading;
    chosen->scene.shifts = (int)raw.shifts;
    chosen->scene.fraction = (int)raw.fraction;
    status = glint_device_options_settle("render", &raw.device, &chosen->backend);
    if (status == GLINT_OPTIONS_RUN)
        status = choose_n(&raw, chosen);
    if (status == GLINT_OPTIONS_RUN)
        status = choose_specular(&raw, chosen);
    if (status == GLINT_OPTIONS_RUN && gl)
        status = settle_gl(&raw, chosen);
    if (status == GLINT_OPTIONS_RUN)
        status = glint_shading_options_settle("render", &raw.shadings, &chosen->scene);
    if (status == GLINT_OPTIONS_RUN)
        status = check_fraction_of_n(chosen);
    if (status == GLINT_OPTIONS_RUN)
        status = choose_slips(&raw, &chosen->scene);
    if (status == GLINT_OPTIONS_RUN)
        status = glint_trace_options_settle("render", &chosen->scene, gl, &raw.trace);
    chosen->trace = raw.trace;
    if (status == GLINT_OPTIONS_RUN)
        status = check_needless(&raw, chosen);
    if (status == GLINT_OPTIONS_RUN)
        status = check_isc(&raw, chosen);
    return status == GLINT_OPTIONS_RUN ? check_verilog(chosen) : status;
}
