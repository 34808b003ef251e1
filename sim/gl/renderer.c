/* A mesh in OpenGL's buffers, drawn into a framebuffer without a window and read back. */
#define _POSIX_C_SOURCE 200809L

#include "gl/renderer.h"

#include <stdlib.h>
#include <time.h>

#include "gl/context.h"
#include "gl/gold_maps.h"
#include "gl/program.h"
#include "gl/uniforms.h"
#include "render/scene.h"

/* Rows that are read back at once. */
#define ROWS 64

struct glint_gl_renderer {
    glint_gl_context *context;
    const glint_gl *gl;
    const glint_mesh *mesh;
    int width, height;
    uint8_t *rows;         /* ROWS of them, R G B A */
    GLuint program;        /* 0: none yet */
    bool gilded;           /* the program is gold's for good */
    glint_shading shading; /* of the program, like the model */
    glint_reflectance_model model;
};

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static glint_status no_room(const char *what, glint_error *err)
{
    return glint_fail(err, GLINT_NO_MEMORY, "backend gl: not enough memory for %s", what);
}

static void give_attribute(const glint_gl *gl, GLuint number, const float *value, size_t vertices)
{
    GLuint buffer;
    gl->GenBuffers(1, &buffer);
    gl->BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(vertices * 3 * sizeof *value), value,
                   GL_STATIC_DRAW);
    gl->EnableVertexAttribArray(number);
    gl->VertexAttribPointer(number, 3, GL_FLOAT, GL_FALSE, 0, NULL);
}

/* All of it goes with the context. */
static glint_status give_mesh(const glint_gl *gl, const glint_mesh *mesh, glint_error *err)
{
    GLuint array, indices;
    gl->GenVertexArrays(1, &array);
    gl->BindVertexArray(array);
    give_attribute(gl, 0, mesh->position, mesh->vertex_count);
    give_attribute(gl, 1, mesh->normal, mesh->vertex_count);
    gl->GenBuffers(1, &indices);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER,
                   (GLsizeiptr)(mesh->triangle_count * 3 * sizeof *mesh->index), mesh->index,
                   GL_STATIC_DRAW);
    return gl->GetError() == GL_NO_ERROR ? GLINT_OK : no_room("the mesh", err);
}

static void give_buffer(const glint_gl *gl, GLenum format, GLenum attachment, int width, int height)
{
    GLuint buffer;
    gl->GenRenderbuffers(1, &buffer);
    gl->BindRenderbuffer(GL_RENDERBUFFER, buffer);
    gl->RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

static glint_status give_frame(const glint_gl *gl, int width, int height, glint_error *err)
{
    GLuint frame;
    gl->GenFramebuffers(1, &frame);
    gl->BindFramebuffer(GL_FRAMEBUFFER, frame);
    give_buffer(gl, GL_RGBA8, GL_COLOR_ATTACHMENT0, width, height);
    give_buffer(gl, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT, width, height);
    if (gl->CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE ||
        gl->GetError() != GL_NO_ERROR)
        return no_room("the frame", err);
    gl->Viewport(0, 0, width, height);
    return GLINT_OK;
}

/* Faces are clockwise because rows run downwards (camera.glsl). */
static void set_state(const glint_gl *gl)
{
    gl->Disable(GL_DITHER);
    gl->Disable(GL_MULTISAMPLE);
    gl->Enable(GL_CULL_FACE);
    gl->FrontFace(GL_CW);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_GREATER);
    gl->ClearDepth(0.0);
    gl->ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
}

static glint_status check_size(const glint_gl *gl, int width, int height, glint_error *err)
{
    GLint most = 0;
    gl->GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    return width <= most && height <= most
               ? GLINT_OK
               : glint_fail(err, GLINT_BAD_ARGUMENT,
                            "frame size %dx%d: backend gl draws sides of up to %d", width, height,
                            most);
}

static glint_status set_up(glint_gl_renderer *r, int threads, glint_error *err)
{
    r->rows = malloc((size_t)r->width * ROWS * 4);
    if (r->rows == NULL)
        return no_room("the frame", err);
    glint_status status = glint_gl_context_create(threads, &r->context, err);
    if (status != GLINT_OK)
        return status;
    r->gl = glint_gl_of(r->context);
    status = check_size(r->gl, r->width, r->height, err);
    if (status == GLINT_OK)
        status = give_frame(r->gl, r->width, r->height, err);
    if (status == GLINT_OK)
        status = give_mesh(r->gl, r->mesh, err);
    if (status == GLINT_OK)
        set_state(r->gl);
    return status;
}

glint_status glint_gl_renderer_create(const glint_mesh *mesh, int width, int height, int threads,
                                      glint_gl_renderer **renderer, glint_error *err)
{
    glint_gl_renderer *r = calloc(1, sizeof *r);
    if (r == NULL)
        return no_room("a renderer", err);
    r->mesh = mesh;
    r->width = width;
    r->height = height;
    const glint_status status = set_up(r, threads, err);
    if (status != GLINT_OK) {
        glint_gl_renderer_destroy(r);
        return status;
    }
    *renderer = r;
    return GLINT_OK;
}

void glint_gl_renderer_destroy(glint_gl_renderer *renderer)
{
    if (renderer == NULL)
        return;
    glint_gl_context_destroy(renderer->context);
    free(renderer->rows);
    free(renderer);
}

const char *glint_gl_renderer_name(const glint_gl_renderer *renderer)
{
    const GLubyte *name = renderer->gl->GetString(GL_RENDERER);
    return name != NULL ? (const char *)name : "OpenGL";
}

/* Draws a triangle of a frame that no one reads: the driver makes machine code of the shaders when
 * something is first drawn. */
static void warm_up(const glint_gl_renderer *r)
{
    uint8_t pixel[4];
    r->gl->UseProgram(r->program);
    r->gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    r->gl->DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, NULL);
    r->gl->ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
}

static glint_status choose_program(glint_gl_renderer *r, glint_shading shading,
                                   glint_reflectance_model model, glint_error *err)
{
    if (r->gilded)
        return GLINT_OK;
    if (r->program != 0 && r->shading == shading && r->model == model)
        return GLINT_OK;
    if (r->program != 0)
        r->gl->DeleteProgram(r->program);
    r->program = 0;
    r->shading = shading;
    r->model = model;
    const glint_status status = glint_gl_program(r->gl, shading, model, &r->program, err);
    if (status == GLINT_OK)
        warm_up(r);
    return status;
}

static void give_map(const glint_gl *gl, GLenum unit, const uint8_t *rgb)
{
    GLuint texture;
    gl->GenTextures(1, &texture);
    gl->ActiveTexture(GL_TEXTURE0 + unit);
    gl->BindTexture(GL_TEXTURE_2D, texture);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, GLINT_GOLD_SIDE, GLINT_GOLD_SIDE, 0, GL_RGB,
                   GL_UNSIGNED_BYTE, rgb);
}

glint_status glint_gl_renderer_gild(glint_gl_renderer *renderer, glint_error *err)
{
    glint_gl_renderer *r = renderer;
    const size_t size = (size_t)GLINT_GOLD_SIDE * GLINT_GOLD_SIDE * 3;
    uint8_t *maps = malloc(2 * size);
    if (maps == NULL)
        return no_room("the maps of gold", err);
    glint_gold_maps(maps, maps + size);
    give_map(r->gl, GLINT_GOLD_BASE, maps);
    give_map(r->gl, GLINT_GOLD_BUMP, maps + size);
    free(maps);
    if (r->program != 0)
        r->gl->DeleteProgram(r->program);
    r->program = 0;
    const glint_status status = glint_gl_gold_program(r->gl, &r->program, err);
    r->gilded = status == GLINT_OK;
    if (r->gilded)
        warm_up(r);
    return status;
}

/* Returns how many pixels are the object's. */
static uint64_t take_row(const uint8_t *rgba, int width, uint8_t *rgb, uint8_t *object)
{
    uint64_t count = 0;
    for (int x = 0; x < width; x++) {
        for (int c = 0; c < 3; c++)
            rgb[3 * x + c] = rgba[4 * x + c];
        object[x] = rgba[4 * x + 3] != 0;
        count += object[x];
    }
    return count;
}

static glint_status read_frame(const glint_gl_renderer *r, glint_image *image,
                               const volatile bool *stop, uint64_t *fragments, glint_error *err)
{
    *fragments = 0;
    for (int first = 0; first < r->height; first += ROWS) {
        const int rows = r->height - first < ROWS ? r->height - first : ROWS;
        if (stop != NULL && *stop)
            return glint_fail(err, GLINT_INTERRUPTED, "frame abandoned: interrupted");
        r->gl->ReadPixels(0, first, r->width, rows, GL_RGBA, GL_UNSIGNED_BYTE, r->rows);
        for (int i = 0; i < rows; i++) {
            const size_t at = (size_t)(first + i) * (size_t)r->width;
            *fragments += take_row(&r->rows[4 * (size_t)i * (size_t)r->width], r->width,
                                   &image->rgb[3 * at], &image->object[at]);
        }
    }
    return r->gl->GetError() == GL_NO_ERROR ? GLINT_OK : no_room("the frame", err);
}

static glint_status draw(glint_gl_renderer *r, const glint_scene *scene, glint_image *image,
                         const volatile bool *stop, uint64_t *fragments, glint_error *err)
{
    const glint_gl *gl = r->gl;
    const glint_camera camera = glint_camera_of(scene, r->width, r->height);
    const glint_lighting lighting = glint_lighting_of(scene, &camera, NULL);
    gl->UseProgram(r->program);
    glint_gl_set_uniforms(gl, r->program, scene, &camera, &lighting, r->model);
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl->DrawElements(GL_TRIANGLES, (GLsizei)(3 * r->mesh->triangle_count), GL_UNSIGNED_INT, NULL);
    return read_frame(r, image, stop, fragments, err);
}

static uint64_t highlights_of(const glint_gl_renderer *r, uint64_t fragments)
{
    if (r->gilded)
        return fragments;
    switch (r->shading) {
    case GLINT_SHADING_PHONG:
        return fragments;
    case GLINT_SHADING_FLAT:
        return r->mesh->triangle_count;
    default:
        return r->mesh->vertex_count;
    }
}

/* As the rasterizer does when it prepares the model. */
static glint_status check_model(const glint_scene *scene, glint_reflectance_model model,
                                glint_error *err)
{
    glint_reflectance unused;
    const glint_reflectance_parameters parameters = {.n = scene->n, .f0 = (double)scene->f0};
    const glint_status status = glint_scene_check_exponent(model, scene->n, err);
    return status == GLINT_OK ? glint_reflectance_prepare(model, &parameters, &unused, err)
                              : status;
}

glint_status glint_gl_render(glint_gl_renderer *renderer, const glint_scene *scene,
                             glint_image *image, const volatile bool *stop,
                             glint_render_stats *stats, glint_error *err)
{
    glint_scene drawn = *scene;
    drawn.mesh = renderer->mesh;
    const glint_reflectance_model model =
        scene->by_model ? scene->specular : GLINT_REFLECTANCE_COSINE_QUADRATIC;
    if (image->width != renderer->width || image->height != renderer->height) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "the image is %dx%d but the renderer's frame is %dx%d", image->width,
                          image->height, renderer->width, renderer->height);
    }
    glint_status status = glint_scene_check(&drawn, err);
    if (status == GLINT_OK)
        status = check_model(&drawn, model, err);
    if (status == GLINT_OK)
        status = choose_program(renderer, drawn.shading, model, err);
    if (status != GLINT_OK)
        return status;
    const double start = now();
    uint64_t fragments;
    status = draw(renderer, &drawn, image, stop, &fragments, err);
    if (status == GLINT_OK && stats != NULL) {
        *stats = (glint_render_stats){.triangles = renderer->mesh->triangle_count,
                                      .fragments = fragments,
                                      .highlights = highlights_of(renderer, fragments),
                                      .seconds = now() - start};
    }
    return status;
}
