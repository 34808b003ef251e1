/* `glint render --backend gl`: the frame drawn by OpenGL. */
#include "cli/render_gl.h"

#include <stdio.h>

#include "cli/output.h"
#include "gl/program.h"
#include "gl/renderer.h"

static glint_status check_shading(glint_shading shading, glint_error *err)
{
    if (glint_gl_has_shading(shading))
        return GLINT_OK;
    char names[200] = "";
    size_t used = 0;
    for (int i = 0; i < GLINT_SHADING_COUNT; i++)
        if (glint_gl_has_shading((glint_shading)i))
            used += (size_t)snprintf(names + used, sizeof names - used, "%s%s",
                                     used > 0 ? ", " : "", glint_shading_names[i]);
    return glint_fail(err, GLINT_BAD_ARGUMENT,
                      "--backend gl has no shaders for --shading %s; it has them for %s",
                      glint_shading_names[shading], names);
}

static glint_status draw(const glint_render_options *chosen, glint_gl_renderer *renderer,
                         const glint_scene *scene, glint_render_frame *frame, glint_error *err)
{
    const glint_status status = chosen->gold ? glint_gl_renderer_gild(renderer, err) : GLINT_OK;
    if (status != GLINT_OK)
        return status;
    (void)snprintf(frame->driver, sizeof frame->driver, "%s", glint_gl_renderer_name(renderer));
    return glint_gl_render(renderer, scene, frame->image, glint_stop_flag(), &frame->stats, err);
}

glint_status glint_render_by_gl(const glint_render_options *chosen, const glint_scene *scene,
                                glint_render_frame *frame, glint_error *err)
{
    const int width = chosen->what.width, height = chosen->what.height;
    glint_gl_renderer *renderer = NULL;
    frame->backend = "gl";
    glint_status status = check_shading(scene->shading, err);
    if (status == GLINT_OK)
        status = glint_gl_renderer_create(scene->mesh, width, height, (int)chosen->what.threads,
                                          &renderer, err);
    if (status == GLINT_OK)
        status = glint_image_create(width, height, &frame->image, err);
    if (status == GLINT_OK)
        status = draw(chosen, renderer, scene, frame, err);
    glint_gl_renderer_destroy(renderer);
    return status;
}
