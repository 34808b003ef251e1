/* `glint render`: a lit mesh as a PNG, with every highlight computed by the backend. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "circuit/circuits.h"
#include "cli/build_first.h"
#include "cli/commands.h"
#include "cli/failure_output.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/picture.h"
#include "cli/render_gl.h"
#include "cli/render_isc.h"
#include "cli/render_options.h"
#include "cli/render_report.h"
#include "cli/trace_frame.h"
#include "failure/frame.h"
#include "file/new_file.h"
#include "file/same.h"
#include "render/shadings.h"

/* The files that a run may write; all allocated. */
typedef struct outputs {
    char *frame, *frame_c, *diff;
    char *failure; /* a directory */
} outputs;

/* FILE.png with an ending in place of the suffix: FILE-c.png. Returns NULL without memory. */
static char *beside(const char *path, const char *ending)
{
    size_t stem = strlen(path);
    if (stem >= 4 && strcasecmp(path + stem - 4, ".png") == 0)
        stem -= 4;
    const size_t size = stem + strlen(ending) + 1;
    char *name = malloc(size);
    if (name != NULL)
        snprintf(name, size, "%.*s%s", (int)stem, path, ending);
    return name;
}

static void free_outputs(outputs *files)
{
    free(files->frame);
    free(files->frame_c);
    free(files->diff);
    free(files->failure);
}

static glint_status name_outputs(const char *out, outputs *files, glint_error *err)
{
    files->frame = malloc(strlen(out) + 1);
    files->frame_c = beside(out, "-c.png");
    files->diff = beside(out, "-diff.png");
    files->failure = beside(out, "-failure");
    if (files->frame == NULL || files->frame_c == NULL || files->diff == NULL ||
        files->failure == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "out of memory");
    strcpy(files->frame, out);
    return GLINT_OK;
}

static void show(void *context, uint64_t done, uint64_t total)
{
    glint_progress_update(context, done, total);
}

static glint_status draw_frame(const glint_scene *scene, glint_render_frame *frame,
                               glint_error *err)
{
    glint_progress progress;
    glint_progress_begin(&progress, "render", "bands of the frame");
    glint_renderer_show(frame->renderer, show, &progress);
    const glint_status status =
        glint_render(frame->renderer, scene, frame->image, glint_stop_flag(), &frame->stats, err);
    glint_renderer_show(frame->renderer, NULL, NULL);
    glint_progress_end(&progress);
    return status;
}

static glint_status render_frame(const glint_render_options *chosen, glint_backend_kind kind,
                                 const glint_scene *scene, glint_render_frame *frame,
                                 glint_error *err)
{
    glint_backend_config config = chosen->backend;
    config.kind = kind;
    frame->backend = glint_backend_names[kind];
    if (chosen->trace.traced)
        return glint_trace_frame(chosen, &config, scene, frame, err);
    glint_status status =
        glint_renderer_create(chosen->what.width, chosen->what.height, (int)chosen->what.threads,
                              &config, &frame->renderer, err);
    if (status == GLINT_OK)
        status = glint_image_create(chosen->what.width, chosen->what.height, &frame->image, err);
    return status == GLINT_OK ? draw_frame(scene, frame, err) : status;
}

static bool shows_nothing(const glint_render_frame *frame)
{
    return frame->stats.fragments == 0;
}

/* The full trace, where there is one, knows better than a picture joined from a few pixels. */
static bool is_outside(const glint_render_frame *frame)
{
    return shows_nothing(frame) && frame->trace.full.hits == 0;
}

/* Two empty frames are equal, which proves nothing. */
static glint_status compare_frames(glint_render_result *result, glint_error *err)
{
    if (is_outside(&result->frame[0])) {
        return glint_fail(err, GLINT_BAD_INPUT,
                          "nothing to compare: the object is outside the frame");
    }
    return glint_image_compare(result->frame[0].image, result->frame[1].image, &result->difference,
                               err);
}

/* The circuits of a frame by the Verilog. */
static glint_status build(const glint_render_options *chosen, glint_error *err)
{
    glint_setting settings[2] = {glint_backend_setting(&chosen->backend)};
    const bool two = glint_scene_circuit(&chosen->scene, &settings[1]);
    settings[1].verilog = chosen->backend.verilog;
    if (chosen->backend.kind != GLINT_BACKEND_RTL)
        return GLINT_OK;
    return glint_build_first("render", settings, two ? 2 : 1, GLINT_RTL_FAST, 0, err);
}

static glint_status render_all(const glint_render_options *chosen, const glint_mesh *mesh,
                               glint_render_result *result, glint_error *err)
{
    glint_scene scene = chosen->scene;
    scene.mesh = mesh;
    const glint_backend_kind first = chosen->both ? GLINT_BACKEND_C : chosen->backend.kind;
    result->frame_count = chosen->both ? 2 : 1;
    if (chosen->gl)
        return glint_render_by_gl(chosen, &scene, &result->frame[0], err);
    glint_status status = build(chosen, err);
    if (status == GLINT_OK)
        status = render_frame(chosen, first, &scene, &result->frame[0], err);
    if (status == GLINT_OK && scene.isc)
        status = glint_render_measure_isc(&scene, result, err);
    if (status != GLINT_OK || !chosen->both)
        return status;
    status = render_frame(chosen, GLINT_BACKEND_RTL, &scene, &result->frame[1], err);
    return status == GLINT_OK ? compare_frames(result, err) : status;
}

static glint_status write_difference(const glint_render_result *result, const outputs *files,
                                     glint_error *err)
{
    glint_image *picture;
    glint_status status = glint_image_difference_picture(result->frame[0].image,
                                                         result->frame[1].image, &picture, err);
    if (status == GLINT_OK)
        status = glint_picture_write("render", picture, files->diff, err);
    glint_image_destroy(picture);
    return status == GLINT_OK
               ? glint_picture_write("render", result->frame[0].image, files->frame_c, err)
               : status;
}

static glint_status write_all(const glint_render_result *result, const outputs *files,
                              glint_error *err)
{
    const glint_render_frame *last = &result->frame[result->frame_count - 1];
    const glint_status status = glint_picture_write("render", last->image, files->frame, err);
    return status == GLINT_OK && glint_render_differs(result) ? write_difference(result, files, err)
                                                              : status;
}

/* Finds an unwritable target before the work. */
static glint_status check_outputs(const glint_render_options *chosen, const outputs *files,
                                  glint_error *err)
{
    if (glint_file_same(chosen->what.model, files->frame))
        return glint_fail(err, GLINT_BAD_ARGUMENT, "--out: %s is the model file itself",
                          files->frame);
    const char *const pictures[] = {files->frame, files->frame_c, files->diff};
    const int count = chosen->both ? 3 : 1;
    glint_status status = GLINT_OK;
    for (int i = 0; i < count && status == GLINT_OK; i++) {
        status = glint_picture_check("out", pictures[i], chosen->force, err);
        if (status == GLINT_OK && !glint_picture_is_stdout(pictures[i]))
            status = glint_new_file_check(pictures[i], err);
    }
    return status;
}

static glint_status run(const glint_render_options *chosen, const outputs *files, glint_mesh **mesh,
                        glint_render_result *result, glint_error *err)
{
    glint_status status = check_outputs(chosen, files, err);
    if (status == GLINT_OK)
        status = glint_scene_options_mesh(&chosen->what, mesh, err);
    if (status == GLINT_OK) {
        glint_tell_remarks("render", chosen->what.model, (*mesh)->remarks);
        status = render_all(chosen, *mesh, result, err);
    }
    if (status == GLINT_OK)
        status = write_all(result, files, err);
    return status;
}

/* The packet for two differing frames, or for a circuit that failed to answer. The report is for
 * people; with --json it must not mix with the result. Returns whether there is a packet. */
static bool explain(const glint_render_options *chosen, const char *command, const glint_mesh *mesh,
                    const outputs *files, const glint_render_result *result)
{
    glint_scene scene = chosen->scene;
    scene.mesh = mesh;
    const bool differs = glint_render_differs(result);
    glint_trace_again again = {chosen, &scene};
    const glint_packet_frames frames = {result->frame[0].image, result->frame[1].image};
    const glint_frame_pair pair = {.scene = &scene,
                                   .backend = &chosen->backend,
                                   .model = frames.model,
                                   .rtl = frames.rtl,
                                   .difference = differs ? &result->difference : NULL,
                                   .ask = chosen->trace.traced ? glint_trace_frame_again : NULL,
                                   .context = &again};
    glint_failure *failure;
    glint_error err;
    if (glint_failure_of_frame(&pair, glint_stop_flag(), &failure, &err) != GLINT_OK) {
        (void)glint_complain_error("render", &err);
        return false;
    }
    failure->program = glint_failure_program();
    (void)snprintf(failure->command, sizeof failure->command, "%s", command);
    bool written = false;
    if (differs || glint_failure_playable(failure))
        written = glint_failure_output("render", failure, differs ? &frames : NULL, files->failure,
                                       GLINT_FAILURE_REPORT, chosen->json ? stderr : stdout);
    glint_failure_destroy(failure);
    return written;
}

/* The frames are now equal, but an old packet claims that they differ. */
static void tell_of_earlier(const outputs *files)
{
    if (access(files->failure, F_OK) == 0)
        printf("%s is left over from an earlier run\n", files->failure);
}

/* People get a failure's report last; with --json it goes first, to standard error. */
static int report(const glint_render_options *chosen, const char *command, const glint_mesh *mesh,
                  const outputs *files, const glint_render_result *result)
{
    const bool differs = glint_render_differs(result);
    bool explained = false;
    if (shows_nothing(&result->frame[0])) {
        (void)glint_complain("render", GLINT_EXIT_OK, "the frame is empty: the object %s",
                             is_outside(&result->frame[0]) ? "is outside it"
                                                           : "lies wholly between traced pixels");
    }
    if (!chosen->json) {
        FILE *out = glint_picture_talk(files->frame);
        glint_render_report_text(out, chosen, result);
        if (!glint_picture_is_stdout(files->frame))
            fprintf(out, "wrote %s\n", files->frame);
        if (!differs && chosen->both)
            tell_of_earlier(files);
    }
    if (differs)
        explained = explain(chosen, command, mesh, files, result);
    if (chosen->json &&
        !glint_render_report_json(chosen, result, explained ? files->failure : NULL))
        return glint_complain("render", GLINT_EXIT_TROUBLE, "out of memory");
    int status = glint_output_finish("render", GLINT_EXIT_OK);
    if (status == GLINT_EXIT_OK && result->isc.difference.differing_pixels > 0)
        status = glint_complain("render", GLINT_EXIT_DIFFERENT, "--isc on changes the picture");
    if (status == GLINT_EXIT_TROUBLE || !differs)
        return status;
    if (!explained) {
        return glint_complain("render", GLINT_EXIT_DIFFERENT, "c and rtl differ: see %s, %s and %s",
                              files->frame, files->frame_c, files->diff);
    }
    return glint_complain("render", GLINT_EXIT_DIFFERENT, "c and rtl differ: see %s, %s, %s and %s",
                          files->frame, files->frame_c, files->diff, files->failure);
}

static void free_result(glint_render_result *result)
{
    for (int i = 0; i < 2; i++) {
        glint_renderer_destroy(result->frame[i].renderer);
        glint_image_destroy(result->frame[i].image);
    }
}

int glint_cmd_render(int argc, char **argv)
{
    glint_render_options chosen;
    const int parsed = glint_render_options_parse(argc, argv, &chosen);
    if (parsed != GLINT_OPTIONS_RUN)
        return parsed;
    if (chosen.trace.traced && glint_trace_frame == NULL)
        return glint_subcommand_is_not_here("render --method trace");
    char command[GLINT_FAILURE_COMMAND];
    glint_failure_command(argc, argv, command, sizeof command);
    if (chosen.gl && glint_render_by_gl == NULL)
        return glint_subcommand_is_not_here("render --backend gl");
    glint_error err;
    glint_mesh *mesh = NULL;
    outputs files = {0};
    glint_render_result result = {0};
    glint_status status = name_outputs(chosen.out, &files, &err);
    if (status == GLINT_OK)
        status = run(&chosen, &files, &mesh, &result, &err);
    /* The C model has answered where the circuit did not: a difference as well. */
    const bool silent =
        status == GLINT_DEVICE_FAULT && chosen.both && result.frame[1].image != NULL;
    if (silent)
        (void)explain(&chosen, command, mesh, &files, &result);
    const int exit_status =
        status == GLINT_OK
            ? report(&chosen, command, mesh, &files, &result)
            : glint_complain("render", silent ? GLINT_EXIT_DIFFERENT : GLINT_EXIT_TROUBLE, "%s",
                             err.text);
    free_result(&result);
    glint_mesh_destroy(mesh);
    free_outputs(&files);
    return exit_status;
}
