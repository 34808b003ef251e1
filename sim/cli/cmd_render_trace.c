/* `glint render --method trace`: the frame by rays, the full trace beside it, and what is said of
 * both. */
#include <inttypes.h>
#include <math.h>

#include "cli/output.h"
#include "cli/trace_frame.h"
#include "trace/count.h"

static void show(void *context, uint64_t done, uint64_t total)
{
    glint_progress_update(context, done, total);
}

static glint_tracer_config config_of(const glint_render_options *chosen,
                                     const glint_backend_config *backend, const glint_scene *scene)
{
    return (glint_tracer_config){
        .width = chosen->what.width,
        .height = chosen->what.height,
        .threads = (int)chosen->what.threads,
        .backend = *backend,
        .scene = *scene,
        .shadows = chosen->trace.shadows,
        .reflect = chosen->trace.reflect,
        .stop = glint_stop_flag(),
    };
}

/* Traces an image once more; its time is the least so far. */
static glint_status trace_again(glint_tracer *tracer, const glint_join *how, glint_image *image,
                                glint_trace_stats *stats, glint_error *err)
{
    glint_trace_stats found;
    const glint_status status = glint_trace(tracer, how, image, &found, err);
    if (status != GLINT_OK)
        return status;
    found.seconds = fmin(found.seconds, stats->seconds);
    *stats = found;
    return GLINT_OK;
}

/* The full trace; then the frame and it once more, as memory and caches were cold at first. */
static glint_status trace_full(glint_tracer *tracer, const glint_join *how,
                               glint_render_frame *frame, glint_image *full, glint_error *err)
{
    const glint_join every = {.centre = -1};
    glint_trace_result *trace = &frame->trace;
    glint_status status = glint_trace(tracer, &every, full, &trace->full, err);
    if (status == GLINT_OK)
        status = trace_again(tracer, how, frame->image, &trace->joined, err);
    return status == GLINT_OK ? trace_again(tracer, &every, full, &trace->full, err) : status;
}

/* With the full trace, unless the frame is one. */
static glint_status compare(glint_tracer *tracer, const glint_join *how, glint_render_frame *frame,
                            glint_error *err)
{
    glint_image *full = NULL;
    glint_trace_result *trace = &frame->trace;
    trace->full = trace->joined;
    if (trace->joined.join.filled == 0)
        return glint_image_compare(frame->image, frame->image, &trace->error, err);
    glint_status status = glint_image_create(frame->image->width, frame->image->height, &full, err);
    if (status == GLINT_OK)
        status = trace_full(tracer, how, frame, full, err);
    if (status == GLINT_OK)
        status = glint_image_compare(full, frame->image, &trace->error, err);
    glint_image_destroy(full);
    return status;
}

static uint64_t object_pixels(const glint_image *image)
{
    uint64_t count = 0;
    for (size_t i = 0; i < (size_t)image->width * (size_t)image->height; i++)
        count += image->object[i];
    return count;
}

static glint_status trace(const glint_render_options *chosen, const glint_tracer_config *config,
                          glint_render_frame *frame, glint_error *err)
{
    glint_tracer *tracer;
    glint_status status = glint_tracer_create(config, &tracer, err);
    if (status != GLINT_OK)
        return status;
    frame->trace.build_seconds = glint_tracer_build_seconds(tracer);
    status = glint_trace(tracer, &chosen->trace.join, frame->image, &frame->trace.joined, err);
    if (status == GLINT_OK)
        status = compare(tracer, &chosen->trace.join, frame, err);
    glint_tracer_destroy(tracer);
    return status;
}

glint_status glint_trace_frame(const glint_render_options *chosen,
                               const glint_backend_config *backend, const glint_scene *scene,
                               glint_render_frame *frame, glint_error *err)
{
    glint_progress progress;
    glint_tracer_config config = config_of(chosen, backend, scene);
    config.progress = show;
    config.context = &progress;
    glint_status status =
        glint_image_create(chosen->what.width, chosen->what.height, &frame->image, err);
    if (status != GLINT_OK)
        return status;
    glint_progress_begin(&progress, "render", "pixels traced");
    status = trace(chosen, &config, frame, err);
    glint_progress_end(&progress);
    frame->stats = (glint_render_stats){
        .triangles = scene->mesh->triangle_count,
        .fragments = object_pixels(frame->image),
        .highlights = frame->trace.joined.highlights,
        .seconds = frame->trace.joined.seconds,
    };
    return status;
}

glint_status glint_trace_frame_again(void *context, glint_backend_watch *watch, glint_error *err)
{
    const glint_trace_again *again = context;
    glint_tracer_config config = config_of(again->chosen, &again->chosen->backend, again->scene);
    glint_tracer *tracer = NULL;
    glint_image *image = NULL;
    config.threads = 1;
    config.watch = watch;
    glint_status status = glint_tracer_create(&config, &tracer, err);
    if (status == GLINT_OK)
        status = glint_image_create(config.width, config.height, &image, err);
    if (status == GLINT_OK)
        status = glint_trace(tracer, &again->chosen->trace.join, image, NULL, err);
    glint_image_destroy(image);
    glint_tracer_destroy(tracer);
    return status;
}

/* ---- What is printed ------------------------------------------------------------------------- */

/* What the grid alone has: a row's count for each row, with blocks for each row of the grid. */
static uint64_t grid_of(const glint_render_options *chosen)
{
    const glint_join *how = &chosen->trace.join;
    const uint64_t rows = glint_fill_is_of_blocks(how->fill)
                              ? glint_count_row(chosen->what.height, how->segment)
                              : (uint64_t)chosen->what.height;
    return glint_count_row(chosen->what.width, how->segment) * rows;
}

/* (2.29): (2.28) for each row. It is about segments of one length. */
static bool formula_applies(const glint_join *how)
{
    return how->segment > 0 && how->centre < 0 && !glint_fill_is_of_blocks(how->fill);
}

static uint64_t by_formula(const glint_render_options *chosen)
{
    return glint_count_by_2_28(chosen->what.width, chosen->trace.join.segment) *
           (uint64_t)chosen->what.height;
}

static double saved(const glint_trace_result *trace)
{
    return trace->full.seconds > 0.0 ? 1.0 - trace->joined.seconds / trace->full.seconds : 0.0;
}

static void print_join(FILE *out, const glint_render_options *chosen,
                       const glint_render_frame *frame)
{
    const glint_join *how = &chosen->trace.join;
    const glint_trace_result *trace = &frame->trace;
    fprintf(out, "%s %d, %s, ", glint_fill_is_of_blocks(how->fill) ? "blocks" : "segments",
            how->segment, glint_fill_names[how->fill]);
    if (how->centre >= 0)
        fprintf(out, "%d in the centre, ", how->centre);
    if (isinf(how->limit))
        fprintf(out, "no limit");
    else
        fprintf(out, "limit %g %s", how->limit, glint_measure_names[how->measure]);
    fprintf(out, ": %" PRIu64 " interpolated, %d level%s of halving\n", trace->joined.join.segments,
            trace->joined.join.levels, trace->joined.join.levels == 1 ? "" : "s");
    if (formula_applies(how)) {
        fprintf(out, "without halving: %" PRIu64 " by (2.28), exactly %" PRIu64 "\n",
                by_formula(chosen), grid_of(chosen));
    }
    fprintf(out,
            "against the full trace: NMSE %.3g (%s), largest difference %d, %" PRIu64
            " pixels differ\n",
            trace->error.nmse, glint_image_reading(trace->error.nmse), trace->error.largest,
            trace->error.differing_pixels);
    fprintf(out, "time: %.6f s for %.6f s in full, %.1f %% saved\n", trace->joined.seconds,
            trace->full.seconds, 100.0 * saved(trace));
}

void glint_trace_frame_print(FILE *out, const glint_render_options *chosen,
                             const glint_render_frame *frame)
{
    const glint_trace_stats *joined = &frame->trace.joined;
    const uint64_t pixels = joined->join.traced + joined->join.filled;
    fprintf(out, "trace: %" PRIu64 " of %" PRIu64 " pixels traced (%.2f %%)", joined->join.traced,
            pixels, 100.0 * (double)joined->join.traced / (double)pixels);
    if (chosen->trace.shadows)
        fprintf(out, ", %" PRIu64 " shadow rays", joined->shadow_rays);
    if (chosen->trace.reflect > 0.0)
        fprintf(out, ", %" PRIu64 " mirror rays", joined->mirror_rays);
    fprintf(out, "; tree built in %.6f s\n", frame->trace.build_seconds);
    if (chosen->trace.join.segment > 0)
        print_join(out, chosen, frame);
}

static void add_join(json_t *json, const glint_render_options *chosen)
{
    const glint_join *how = &chosen->trace.join;
    glint_json_add_text(json, "fill", glint_fill_names[how->fill]);
    if (how->centre >= 0)
        glint_json_add_number(json, "segment_centre", how->centre);
    if (!isinf(how->limit)) {
        glint_json_add_number(json, "limit", how->limit);
        glint_json_add_text(json, "measure", glint_measure_names[how->measure]);
    }
    if (formula_applies(how))
        glint_json_add_number(json, "grid_by_2_28", (double)by_formula(chosen));
    if (how->centre < 0)
        glint_json_add_number(json, "grid", (double)grid_of(chosen));
}

void glint_trace_frame_json(json_t *json, const glint_render_options *chosen,
                            const glint_render_frame *frame)
{
    const glint_trace_result *trace = &frame->trace;
    const glint_trace_stats *joined = &trace->joined;
    glint_json_add_number(json, "segment", chosen->trace.join.segment);
    if (chosen->trace.join.segment > 0)
        add_join(json, chosen);
    glint_json_add_number(json, "pixels", (double)(joined->join.traced + joined->join.filled));
    glint_json_add_number(json, "traced", (double)joined->join.traced);
    glint_json_add_number(json, "segments", (double)joined->join.segments);
    glint_json_add_number(json, "levels", joined->join.levels);
    glint_json_add_number(json, "shadow_rays", (double)joined->shadow_rays);
    glint_json_add_number(json, "mirror_rays", (double)joined->mirror_rays);
    glint_json_add_number(json, "nmse", trace->error.nmse);
    glint_json_add_number(json, "largest", trace->error.largest);
    glint_json_add_number(json, "differing_pixels", (double)trace->error.differing_pixels);
    glint_json_add_number(json, "build_seconds", trace->build_seconds);
    glint_json_add_number(json, "full_seconds", trace->full.seconds);
    glint_json_add_number(json, "time_saved", saved(trace));
}
