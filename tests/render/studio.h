/* A renderer and its picture, for tests of whole frames. Include it after cmocka.h. */
#ifndef GLINT_TESTS_RENDER_STUDIO_H
#define GLINT_TESTS_RENDER_STUDIO_H

#include "render/render.h"

typedef struct studio {
    glint_renderer *renderer;
    glint_image *image;
    glint_render_stats stats;
} studio;

static inline studio open_studio(int width, int height, int threads, glint_backend_kind kind)
{
    const glint_backend_config config = {.kind = kind, .pipeline = GLINT_PIPELINE_PIPELINED};
    studio s = {0};
    glint_error err = {""};
    assert_int_equal(glint_renderer_create(width, height, threads, &config, &s.renderer, &err),
                     GLINT_OK);
    assert_int_equal(glint_image_create(width, height, &s.image, &err), GLINT_OK);
    return s;
}

static inline void close_studio(studio *s)
{
    glint_renderer_destroy(s->renderer);
    glint_image_destroy(s->image);
}

/* Renders into the picture; fails the test, with the reason, when it cannot. */
static inline void shoot(studio *s, const glint_scene *scene)
{
    glint_error err = {""};
    const glint_status status = glint_render(s->renderer, scene, s->image, NULL, &s->stats, &err);
    assert_string_equal(err.text, "");
    assert_int_equal(status, GLINT_OK);
}

#endif
