/* The output of `glint render` about its frames; see render_report.h. */
#include "cli/render_report.h"

#include <inttypes.h>
#include <stdio.h>

#include "circuit/circuits.h"
#include "circuit/units.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/trace_frame.h"
#include "render/shadings.h"

bool glint_render_differs(const glint_render_result *result)
{
    return result->frame_count == 2 &&
           (result->difference.differing_pixels > 0 || result->difference.mask_pixels > 0);
}

static double per_second(double count, const glint_render_stats *stats)
{
    return stats->seconds > 0.0 ? count / stats->seconds : 0.0;
}

static void print_frame(FILE *out, const glint_render_frame *frame)
{
    const glint_render_stats *stats = &frame->stats;
    fprintf(out, "%-5s%10.6f s, %8.1f frames/s, %8.2f million fragments/s", frame->backend,
            stats->seconds, per_second(1.0, stats),
            1e-6 * per_second((double)stats->fragments, stats));
    if (stats->shading_seconds > 0.0) /* OpenGL does not say */
        fprintf(out, "; shading %.6f s", stats->shading_seconds);
    fputc('\n', out);
}

static bool divider_works(const glint_render_options *chosen)
{
    return glint_shading_divides(chosen->scene.shading) &&
           chosen->backend.kind != GLINT_BACKEND_REAL;
}

static bool tells_triangles_apart(const glint_render_options *chosen)
{
    return chosen->scene.isc || chosen->scene.shading == GLINT_SHADING_MIXED;
}

static void print_isc(FILE *out, const glint_render_isc *isc)
{
    fprintf(out, "ISC: shading %.6f s, without %.6f s (%+.0f %%), ", isc->seconds_with,
            isc->seconds_without, 100.0 * (isc->seconds_with / isc->seconds_without - 1.0));
    glint_print_verdict(out, isc->difference.differing_pixels == 0, "%" PRIu64 " differing pixels",
                        isc->difference.differing_pixels);
    fprintf(out, " of %" PRIu64 "\n", isc->difference.pixels);
}

static bool span_unit_works(const glint_render_options *chosen)
{
    return chosen->scene.shading == GLINT_SHADING_QUADRATIC &&
           chosen->backend.kind != GLINT_BACKEND_REAL;
}

void glint_render_report_text(FILE *out, const glint_render_options *chosen,
                              const glint_render_result *result)
{
    const glint_render_stats *stats = &result->frame[0].stats;
    fprintf(out, "%s, %dx%d: %" PRIu64 " triangles", chosen->what.model, chosen->what.width,
            chosen->what.height, stats->triangles);
    if (!chosen->gl && !chosen->trace.traced) /* OpenGL does not say, rays draw none */
        fprintf(out, ", %" PRIu64 " drawn", stats->drawn);
    fprintf(out, ", %" PRIu64 " fragments\n", stats->fragments);
    fprintf(out, "%s: %" PRIu64 " highlights", glint_shading_names[chosen->scene.shading],
            stats->highlights);
    if (chosen->backend.device != &glint_circuit_specular)
        fprintf(out, " by device %s", chosen->backend.device->name);
    if (chosen->gold)
        fputs(" of gold", out);
    else if (chosen->scene.by_model)
        fprintf(out, " by %s", glint_reflectance_names[chosen->scene.specular]);
    if (divider_works(chosen)) {
        fprintf(out, ", %" PRIu64 " divisions with %d shifts", stats->divisions,
                chosen->scene.shifts);
    }
    if (span_unit_works(chosen)) {
        fprintf(out, ", %" PRIu64 " spans with %d fraction bits", stats->spans,
                chosen->scene.fraction);
    }
    if (chosen->gl)
        fprintf(out, ", drawn by %s", result->frame[0].driver);
    fputc('\n', out);
    if (chosen->trace.traced)
        glint_trace_frame_print(out, chosen, &result->frame[0]);
    if (tells_triangles_apart(chosen)) {
        fprintf(out, "%" PRIu64 " / %" PRIu64 " triangles drawn / with a highlight\n", stats->drawn,
                stats->sheen);
    }
    for (int i = 0; i < result->frame_count; i++)
        print_frame(out, &result->frame[i]);
    if (result->isc.measured)
        print_isc(out, &result->isc);
    if (result->frame_count == 2) {
        glint_print_verdict(out, !glint_render_differs(result), "%" PRIu64 " differing pixels",
                            result->difference.differing_pixels);
        fprintf(out, " of %" PRIu64 "\n", result->difference.pixels);
    }
}

static void add_frame(json_t *frames, const glint_render_options *chosen,
                      const glint_render_frame *frame)
{
    const glint_render_stats *stats = &frame->stats;
    json_t *json = json_object();
    glint_json_add_text(json, "backend", frame->backend);
    if (frame->driver[0] != '\0')
        glint_json_add_text(json, "driver", frame->driver);
    glint_json_add_number(json, "seconds", stats->seconds);
    if (stats->shading_seconds > 0.0)
        glint_json_add_number(json, "shading_seconds", stats->shading_seconds);
    glint_json_add_number(json, "frames_per_second", per_second(1.0, stats));
    glint_json_add_number(json, "fragments_per_second",
                          per_second((double)stats->fragments, stats));
    if (stats->divider_clocks > 0)
        glint_json_add_number(json, "divider_clocks", (double)stats->divider_clocks);
    if (stats->span_clocks > 0)
        glint_json_add_number(json, "span_clocks", (double)stats->span_clocks);
    if (chosen->trace.traced)
        glint_trace_frame_json(glint_json_add(json, "trace", json_object()), chosen, frame);
    json_array_append_new(frames, json);
}

static void add_comparison(json_t *json, const glint_image_difference *difference)
{
    json_t *compared = glint_json_add(json, "comparison", json_object());
    glint_json_add_number(compared, "pixels", (double)difference->pixels);
    glint_json_add_number(compared, "differing_pixels", (double)difference->differing_pixels);
    glint_json_add_number(compared, "mask_pixels", (double)difference->mask_pixels);
    glint_json_add_number(compared, "largest", difference->largest);
    glint_json_add_number(compared, "first_x", difference->first_x);
    glint_json_add_number(compared, "first_y", difference->first_y);
}

static void add_isc(json_t *json, const glint_render_isc *isc)
{
    json_t *added = glint_json_add(json, "isc", json_object());
    glint_json_add_number(added, "shading_seconds", isc->seconds_with);
    glint_json_add_number(added, "shading_seconds_without", isc->seconds_without);
    glint_json_add_number(added, "differing_pixels", (double)isc->difference.differing_pixels);
}

/* With its own parameter: the gate of the specular device. */
static void add_device(json_t *json, const glint_backend_config *backend)
{
    glint_json_add_text(json, "device", backend->device->name);
    const glint_parameter *own = glint_highlight_parameter(backend->device);
    if (backend->device == &glint_circuit_specular)
        glint_json_add_text(json, "gate", glint_gate_names[backend->gate]);
    if (own != NULL)
        glint_json_add_text(json, own->name, own->choices[backend->variant]);
    glint_json_add_text(json, "pipeline", glint_pipeline_names[backend->pipeline]);
}

bool glint_render_report_json(const glint_render_options *chosen, const glint_render_result *result,
                              const char *packet)
{
    const glint_render_stats *stats = &result->frame[0].stats;
    json_t *json = json_object();
    glint_json_add_text(json, "model", chosen->what.model);
    glint_json_add_text(json, "out", chosen->out);
    glint_json_add_number(json, "width", chosen->what.width);
    glint_json_add_number(json, "height", chosen->what.height);
    if (!chosen->scene.by_model)
        add_device(json, &chosen->backend);
    glint_json_add_text(json, "shading", glint_shading_names[chosen->scene.shading]);
    glint_json_add_text(json, "method", chosen->trace.traced ? "trace" : "raster");
    if (chosen->gold)
        glint_json_add_text(json, "shader", "gold");
    else if (chosen->scene.by_model)
        glint_json_add_text(json, "specular", glint_reflectance_names[chosen->scene.specular]);
    if (divider_works(chosen))
        glint_json_add_number(json, "shifts", chosen->scene.shifts);
    if (span_unit_works(chosen)) {
        glint_json_add_number(json, "fraction", chosen->scene.fraction);
        glint_json_add_number(json, "spans", (double)stats->spans);
    }
    glint_json_add_number(json, "threads", (double)chosen->what.threads);
    glint_json_add_number(json, "triangles", (double)stats->triangles);
    if (!chosen->gl && !chosen->trace.traced)
        glint_json_add_number(json, "drawn", (double)stats->drawn);
    glint_json_add_number(json, "fragments", (double)stats->fragments);
    glint_json_add_number(json, "highlights", (double)stats->highlights);
    if (tells_triangles_apart(chosen))
        glint_json_add_number(json, "with_highlight", (double)stats->sheen);
    glint_json_add_number(json, "divisions", (double)stats->divisions);
    json_t *frames = glint_json_add(json, "frames", json_array());
    for (int i = 0; i < result->frame_count; i++)
        add_frame(frames, chosen, &result->frame[i]);
    if (result->frame_count == 2)
        add_comparison(json, &result->difference);
    if (result->isc.measured)
        add_isc(json, &result->isc);
    if (packet != NULL)
        glint_json_add_text(json, "packet", packet);
    return glint_output_json(json);
}
