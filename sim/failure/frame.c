/* Renders the frame again while watching the circuit, to find the answer behind the first differing
 * pixel. */
#include "failure/frame.h"

#include <string.h>

#include "render/pick.h"

/* The frame rendered again. */
typedef struct again {
    glint_renderer *renderer; /* NULL if something else asked the circuit */
    glint_image *image;
    glint_backend_watch watch;
} again;

static glint_status render_again(const glint_frame_pair *pair, const volatile bool *stop,
                                 again *again, glint_error *err)
{
    if (pair->ask != NULL)
        return pair->ask(pair->context, &again->watch, err);
    glint_status status = glint_renderer_create(pair->rtl->width, pair->rtl->height, 1,
                                                pair->backend, &again->renderer, err);
    if (status == GLINT_OK)
        status = glint_renderer_watch(again->renderer, &again->watch, err);
    if (status == GLINT_OK)
        status = glint_image_create(pair->rtl->width, pair->rtl->height, &again->image, err);
    if (status == GLINT_OK)
        status = glint_render(again->renderer, pair->scene, again->image, stop, NULL, err);
    return status;
}

static void find_triangle(const glint_frame_pair *pair, const again *again,
                          glint_failure_frame *frame)
{
    const glint_mesh *mesh = pair->scene->mesh;
    frame->has_triangle =
        glint_renderer_triangle(again->renderer, frame->x, frame->y, &frame->triangle);
    for (size_t i = 0; frame->has_triangle && i < 3; i++)
        memcpy(frame->corner[i],
               &mesh->position[3 * (size_t)mesh->index[3 * (size_t)frame->triangle + i]],
               sizeof frame->corner[i]);
}

static void describe_frame(const glint_frame_pair *pair, const again *again,
                           glint_failure_frame *frame)
{
    const int width = pair->rtl->width;
    frame->width = width;
    frame->height = pair->rtl->height;
    frame->has_pixel = pair->difference != NULL;
    if (!frame->has_pixel)
        return;
    frame->x = pair->difference->first_x;
    frame->y = pair->difference->first_y;
    const size_t at = (size_t)frame->y * (size_t)width + (size_t)frame->x;
    memcpy(frame->model, &pair->model->rgb[3 * at], sizeof frame->model);
    memcpy(frame->rtl, &pair->rtl->rgb[3 * at], sizeof frame->rtl);
    if (again->renderer == NULL)
        return;
    frame->has_fragment = glint_renderer_fragment(again->renderer, frame->x, frame->y,
                                                  &frame->cos_code, &frame->material);
    find_triangle(pair, again, frame);
}

/* Without a differing answer, the report is about the specular device. */
static glint_setting setting_of(const glint_frame_pair *pair, const glint_backend_watch *watch)
{
    if (watch->found)
        return watch->setting;
    if (watch->history != NULL)
        return *glint_history_setting(watch->history);
    return glint_backend_setting(pair->backend);
}

glint_status glint_failure_of_frame(const glint_frame_pair *pair, const volatile bool *stop,
                                    glint_failure **failure, glint_error *err)
{
    again again = {0};
    *failure = NULL;
    glint_status status = render_again(pair, stop, &again, err);
    /* A circuit that keeps an answer back ends the frame, and may yet be found out. */
    if (status == GLINT_OK || (status == GLINT_DEVICE_FAULT && again.watch.history != NULL)) {
        const glint_setting setting = setting_of(pair, &again.watch);
        status = glint_failure_of_history(GLINT_FAILURE_FRAME, &setting,
                                          again.watch.found ? &again.watch.answer : NULL,
                                          again.watch.history, stop, failure, err);
    }
    if (status == GLINT_OK)
        describe_frame(pair, &again, &(*failure)->frame);
    glint_history_destroy(again.watch.history);
    glint_renderer_destroy(again.renderer);
    glint_image_destroy(again.image);
    return status;
}
