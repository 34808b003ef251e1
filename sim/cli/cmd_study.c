/* `glint study`: one scene by two methods, compared and timed for a list of exponents. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "circuit/circuits.h"
#include "cli/build_first.h"
#include "cli/circuit_options.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/parse.h"
#include "cli/picture.h"
#include "cli/scene_options.h"
#include "file/kind.h"
#include "render/shadings.h"
#include "study/make.h"
#include "study/table.h"

typedef struct study_options {
    glint_scene_options scene;
    const char *out, *n;
    const char *method[2];
    int64_t frames;
    bool json, force;
    const char *verilog;
} study_options;

static const char details[] =
    "A METHOD is c, rtl or real (the specular device: its C model, its Verilog, its\n"
    "formula in floating point) or a model of glint render --specular, optionally with\n"
    "a shading: blinn, rtl:gouraud, cook-torrance:flat. The default is Phong shading.\n"
    "\n"
    "NMSE (3.1) and PSNR are taken over the object's pixels, with A as the reference. A\n"
    "triangle is touched by the highlight if any of its pixels is at least one level\n"
    "brighter than with Ks = 0. Times are medians over whole frames, A and B\n"
    "alternating; B/A is the median of the pairs' ratios. NMSE reads as in the thesis:\n"
    "up to 0.0001 no visible difference, up to 0.00025 slight and up to 0.001 visible\n"
    "differences, above that substantially different.\n"
    "\n"
    "DIR receives sheet.png, a sheet n-NNNN.png for each n (A, B, difference), study.csv,\n"
    "study.json and times.csv, which is separate because no two runs agree on it. All are\n"
    "renamed into place at the end: an interrupted study leaves DIR unchanged. Leftover\n"
    "n-NNNN.png and times.csv of an earlier study are removed.\n"
    "\n" GLINT_COLOR_DETAILS;

#define OWN_ROWS   8
#define TABLE_ROWS (OWN_ROWS + GLINT_SCENE_OPTIONS)

static int parse(int argc, char **argv, study_options *chosen)
{
    glint_option options[TABLE_ROWS] = {
        {.name = "out",
         .placeholder = "DIR",
         .help = "directory for the files; created if missing",
         .required = true,
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->out},
        {.name = "a",
         .placeholder = "METHOD",
         .help = "the reference",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->method[0]},
        {.name = "b",
         .placeholder = "METHOD",
         .help = "the method compared with A",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->method[1]},
        {.name = "n",
         .placeholder = "N,N,...",
         .help = "comma-separated exponents",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->n},
        {.name = "frames",
         .help = "frames to time per method and n; 0: none",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->frames, 0, GLINT_STUDY_FRAMES_MAX}},
        GLINT_RTL_OPTION(&chosen->verilog),
        GLINT_FORCE_OPTION(&chosen->force),
        {.name = "json",
         .help = "print the content of study.json and times.csv as JSON",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    glint_scene_options_add(&chosen->scene, options + OWN_ROWS);
    static const glint_example examples[] = {
        {"Blinn's highlight against the device, for three exponents",
         "glint study --a blinn --b rtl --n 10,100,1000 --out study"},
        {"two shadings, without timing",
         "glint study --a c --b c:gouraud --frames 0 --out shadings"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "study",
        .summary = "Renders a scene by two methods for each of several exponents and reports how "
                   "the pictures differ, how long a frame takes, and how many triangles the "
                   "highlight touches.",
        .details = details,
        .examples = examples,
        .options = options,
        .option_count = TABLE_ROWS,
        .positionals = &(glint_positional)GLINT_SCENE_POSITIONAL(chosen->scene),
        .positional_count = 1,
    };
    const int status = glint_options_parse(&line, argc, argv);
    return status == GLINT_OPTIONS_RUN ? glint_scene_options_settle("study", &chosen->scene)
                                       : status;
}

static bool is_among(int n, const glint_study_options *study)
{
    for (int i = 0; i < study->count; i++)
        if (study->n[i] == n)
            return true;
    return false;
}

/* Returns the exit status, GLINT_OPTIONS_RUN when all is well; so do the next two. */
static int read_exponents(const char *chosen_text, glint_study_options *study)
{
    const char *text = chosen_text;
    char part[64];
    glint_quoted quoted;
    study->count = 0;
    while (text != NULL) {
        int64_t n;
        text = glint_next_part(text, ',', part);
        if (part[0] == '\0' && study->count > 0) {
            return glint_complain("study", GLINT_EXIT_TROUBLE,
                                  "--n: a comma in %s is not followed by an integer from 0 to %u",
                                  glint_quote(chosen_text, &quoted), GLINT_N_MAX);
        }
        if (!glint_parse_count(part, 0, GLINT_N_MAX, &n)) {
            return glint_complain("study", GLINT_EXIT_TROUBLE,
                                  "--n: %s is not an integer from 0 to %u",
                                  glint_quote(part, &quoted), GLINT_N_MAX);
        }
        if (is_among((int)n, study))
            return glint_complain("study", GLINT_EXIT_TROUBLE, "--n: %d is given twice", (int)n);
        if (study->count == GLINT_STUDY_ROWS_MAX) {
            return glint_complain("study", GLINT_EXIT_TROUBLE, "--n: more than %d exponents",
                                  GLINT_STUDY_ROWS_MAX);
        }
        study->n[study->count++] = (int)n;
    }
    return GLINT_OPTIONS_RUN;
}

static int read_methods(const study_options *chosen, glint_study_setup *setup)
{
    glint_error err;
    bool microfacets = false;
    for (int i = 0; i < 2; i++) {
        if (glint_study_method_parse(chosen->method[i], &setup->method[i], &err) != GLINT_OK) {
            return glint_complain("study", GLINT_EXIT_TROUBLE, "--%c: %s (see glint study --help)",
                                  "ab"[i], err.text);
        }
        microfacets = microfacets || (setup->method[i].by_model &&
                                      glint_specular_takes_f0(setup->method[i].model));
    }
    if (chosen->scene.f0_given && !microfacets) {
        return glint_complain("study", GLINT_EXIT_TROUBLE,
                              "--f0 is for cook-torrance and torrance-sparrow");
    }
    return GLINT_OPTIONS_RUN;
}

enum { CIRCUITS_MAX = 3 };

/* The circuits that the rtl methods need: the specular device and what their shadings need besides.
 * Returns how many. */
static int circuits_of(const glint_study_setup *setup, glint_setting settings[CIRCUITS_MAX])
{
    const glint_backend_config config = {
        .gate = GLINT_GATE_COSINE, .pipeline = GLINT_PIPELINE_PIPELINED, .verilog = setup->verilog};
    int count = 0;
    settings[0] = glint_backend_setting(&config);
    for (int i = 0; i < 2; i++) {
        const glint_study_method *method = &setup->method[i];
        const bool is_rtl = !method->by_model && method->backend == GLINT_BACKEND_RTL;
        glint_scene scene = setup->scene;
        scene.shading = method->shading;
        count = is_rtl && count == 0 ? 1 : count;
        if (is_rtl && glint_scene_circuit(&scene, &settings[count]))
            settings[count++].verilog = setup->verilog;
    }
    return count;
}

static glint_status build(const glint_study_setup *setup, glint_error *err)
{
    glint_setting settings[CIRCUITS_MAX];
    const int count = circuits_of(setup, settings);
    return glint_build_first("study", settings, count, GLINT_RTL_FAST, 0, err);
}

static int check_verilog(const glint_study_setup *setup)
{
    glint_setting settings[CIRCUITS_MAX];
    const int count = circuits_of(setup, settings);
    int status = GLINT_OPTIONS_RUN;
    if (setup->verilog != NULL && count == 0) {
        return glint_complain("study", GLINT_EXIT_TROUBLE,
                              "--rtl names the Verilog's directory: use it with the method rtl");
    }
    for (int i = 0; i < count && status == GLINT_OPTIONS_RUN; i++)
        status = glint_rtl_option_check("study", &settings[i]);
    return status;
}

static int read_study(const study_options *chosen, glint_study_options *study)
{
    *study = (glint_study_options){
        .setup = {.scene = glint_scene_options_scene(&chosen->scene),
                  .width = chosen->scene.width,
                  .height = chosen->scene.height,
                  .threads = (int)chosen->scene.threads,
                  .model = chosen->scene.model,
                  .density = glint_scene_options_density(&chosen->scene),
                  .verilog = chosen->verilog},
        .frames = (int)chosen->frames,
        .directory = chosen->out,
        .stop = glint_stop_flag(),
    };
    int status = read_exponents(chosen->n, study);
    if (status == GLINT_OPTIONS_RUN)
        status = read_methods(chosen, &study->setup);
    return status == GLINT_OPTIONS_RUN ? check_verilog(&study->setup) : status;
}

static void print_row(const glint_study_row *row)
{
    const glint_image_difference *d = &row->difference;
    printf("%5d  %10.4g %7.4g  %4d ", row->n, d->nmse, d->psnr, d->largest);
    if (d->largest_x >= 0)
        printf("%5d,%-5d", d->largest_x, d->largest_y);
    else
        printf("%5s %-5s", "-", "");
    printf(" %9" PRIu64 " %9" PRIu64, row->highlit[0], row->highlit[1]);
    if (row->frames > 0) {
        printf(" %8.3f %8.3f %6.1f %6.1f %6.3f", 1e3 * row->seconds[0], 1e3 * row->seconds[1],
               1.0 / row->seconds[0], 1.0 / row->seconds[1], row->ratio);
    }
    printf("  %s\n", glint_image_reading(d->nmse));
}

static void print_text(const glint_study_options *study, const glint_study_row *rows, bool words)
{
    glint_study_name a, b;
    printf("%s", study->setup.model);
    if (study->setup.density > 0)
        printf(", density %d", study->setup.density);
    printf(", %dx%d: %" PRIu64 " triangles, %" PRIu64 " drawn, %" PRIu64 " seen in %" PRIu64
           " pixels\n",
           study->setup.width, study->setup.height, rows[0].triangles, rows[0].drawn, rows[0].seen,
           rows[0].difference.object_pixels);
    printf("A %s, B %s\n\n", glint_study_method_name(&study->setup.method[0], &a),
           glint_study_method_name(&study->setup.method[1], &b));
    printf("%5s  %10s %7s  %-16s %-19s", "", "", "", "largest", "highlit triangles");
    if (study->frames > 0)
        printf(" %-17s %-13s", "ms a frame", "frames/s");
    printf("\n%5s  %10s %7s  %4s %5s %-5s %9s %9s", "n", "NMSE", "PSNR", "", "x,", "y", "A", "B");
    if (study->frames > 0)
        printf(" %8s %8s %6s %6s %6s", "A", "B", "A", "B", "B/A");
    putchar('\n');
    for (int i = 0; i < study->count; i++)
        print_row(&rows[i]);
    printf("wrote %s/sheet.png and the other files of the study\n", study->directory);
    if (!words)
        printf("the sheets have no labels: install the font package fonts-dejavu-core\n");
}

static bool print_json(const glint_study_options *study, const glint_study_row *rows)
{
    json_t *json = glint_study_json(&study->setup, rows, study->count);
    if (study->frames > 0)
        json_object_set_new(json, "times", glint_study_times_json(rows, study->count));
    return glint_output_json(json);
}

static void show_progress(void *context, int done, int count)
{
    glint_progress_update(context, (uint64_t)done, (uint64_t)count);
}

/* Before the long work: checks that existing files may be replaced. */
static glint_status check_files(const glint_study_options *study, glint_error *err)
{
    static const char *const fixed[] = {"sheet.png", "study.csv", "study.json", "times.csv"};
    glint_status status = GLINT_OK;
    for (int i = 0; i < study->count + 4 && status == GLINT_OK; i++) {
        char path[4096];
        const int length =
            i < 4 ? snprintf(path, sizeof path, "%s/%s", study->directory, fixed[i])
                  : snprintf(path, sizeof path, "%s/n-%04d.png", study->directory, study->n[i - 4]);
        if (length > 0 && (size_t)length < sizeof path) /* otherwise rejected when opened */
            status = glint_file_replaceable(path, err);
    }
    return status;
}

static glint_status work(const study_options *chosen, glint_study_options *study,
                         glint_study_row *rows, bool *words, glint_error *err)
{
    glint_mesh *mesh = NULL;
    glint_progress progress;
    glint_status status = chosen->force ? GLINT_OK : check_files(study, err);
    if (status == GLINT_OK)
        status = glint_scene_options_mesh(&chosen->scene, &mesh, err);
    if (status == GLINT_OK)
        status = build(&study->setup, err);
    if (status == GLINT_OK) {
        glint_tell_remarks("study", chosen->scene.model, mesh->remarks);
        study->setup.scene.mesh = mesh;
        study->progress = show_progress;
        study->context = &progress;
        glint_progress_begin(&progress, "study", "exponents");
        status = glint_study_make(study, rows, words, err);
        glint_progress_end(&progress);
    }
    glint_mesh_destroy(mesh);
    return status;
}

int glint_cmd_study(int argc, char **argv)
{
    study_options chosen = {
        .scene = glint_scene_options_default(),
        .method = {"blinn", "cosine-quadratic"},
        .n = "10,50,100,1000",
        .frames = 11,
    };
    glint_study_options study;
    int status = parse(argc, argv, &chosen);
    if (status == GLINT_OPTIONS_RUN)
        status = read_study(&chosen, &study);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    glint_error err;
    glint_study_row rows[GLINT_STUDY_ROWS_MAX];
    bool words = true;
    if (work(&chosen, &study, rows, &words, &err) != GLINT_OK)
        return glint_complain_error("study", &err);
    if (!chosen.json)
        print_text(&study, rows, words);
    else if (!print_json(&study, rows))
        return glint_complain("study", GLINT_EXIT_TROUBLE, "out of memory");
    return glint_output_finish("study", GLINT_EXIT_OK);
}
