/* One frame from scene to picture, in three phases that all threads share: vertices, triangles,
 * bands of rows. Each phase is split into pieces of a fixed size, which go to whichever thread is
 * free; a piece's result depends only on the scene, and so does the picture. */
#define _POSIX_C_SOURCE 200809L

#include "render/render.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "render/approximate.h"
#include "render/listing.h"
#include "render/paint.h"
#include "render/quadratic_band.h"
#include "render/renderer.h"
#include "render/scene.h"
#include "render/shadings.h"
#include "render/show.h"

#define VERTEX_RUN   GLINT_POINTS_RUN
#define TRIANGLE_RUN 256

/* A frame in the making. */
typedef struct frame {
    glint_renderer *renderer;
    const glint_mesh *mesh;
    glint_shading shading;
    int shifts; /* GLINT_SHIFTS_EXACT with backend real */
    int fraction;
    unsigned slips;
    bool sheen; /* triangles are told apart by their highlight */
    uint8_t color[3];
    glint_camera camera;
    glint_lighting lighting;
    glint_image *image;
    const volatile bool *stop;
    atomic_size_t next; /* piece of the current phase to be taken */
    atomic_bool failed;
} frame;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Of this thread alone: what others do meanwhile does not count. */
static double processor_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void fail_worker(frame *f, glint_render_worker *w, glint_status status, const char *why)
{
    w->status = glint_fail(&w->error, status, "%s", why);
    atomic_store(&f->failed, true);
}

/* Keeps a failure whose text is in the worker already. */
static void note(frame *f, glint_render_worker *w, glint_status status)
{
    if (status != GLINT_OK) {
        w->status = status;
        atomic_store(&f->failed, true);
    }
}

static glint_point_light point_light(const frame *f)
{
    return (glint_point_light){f->mesh, &f->camera, &f->lighting};
}

static bool colors_of_triangles(const frame *f)
{
    return f->shading == GLINT_SHADING_FLAT || f->shading == GLINT_SHADING_QUADRATIC ||
           f->shading == GLINT_SHADING_QUADRATIC_LISTING;
}

/* Takes the next of count pieces; false if none are left or the frame is abandoned. */
static bool take(frame *f, glint_render_worker *w, size_t count, size_t *piece)
{
    if (atomic_load_explicit(&f->failed, memory_order_relaxed))
        return false;
    if (f->stop != NULL && *f->stop) {
        fail_worker(f, w, GLINT_INTERRUPTED, "frame abandoned: interrupted");
        return false;
    }
    *piece = atomic_fetch_add_explicit(&f->next, 1, memory_order_relaxed);
    return *piece < count;
}

static size_t pieces(size_t items, size_t a_piece)
{
    return (items + a_piece - 1) / a_piece;
}

static size_t end_of(size_t start, size_t run, size_t items)
{
    return items - start < run ? items : start + run;
}

static void light_vertices(frame *f, glint_render_worker *w, size_t start, size_t end)
{
    const double begin = processor_seconds();
    const glint_point_light light = point_light(f);
    note(f, w,
         glint_light_vertices(&w->points, &light, start, end, w->backend, f->renderer->screen,
                              &w->error));
    w->highlights += end - start;
    w->shading_seconds += processor_seconds() - begin;
}

static void vertex_phase(void *context, int worker_index)
{
    frame *f = context;
    glint_render_worker *w = &f->renderer->workers[worker_index];
    const size_t items = f->mesh->vertex_count;
    size_t piece;
    while (take(f, w, pieces(items, VERTEX_RUN), &piece)) {
        const size_t start = piece * VERTEX_RUN;
        const size_t end = end_of(start, VERTEX_RUN, items);
        glint_setup_vertices(&f->camera, f->mesh, start, end, f->renderer->screen);
        if (glint_shading_lights_vertices(f->shading))
            light_vertices(f, w, start, end);
    }
}

static void light_triangles(frame *f, glint_render_worker *w, glint_triangle_list *list)
{
    const glint_point_light light = point_light(f);
    uint64_t count = 0;
    note(f, w,
         f->shading == GLINT_SHADING_FLAT
             ? glint_light_triangles(&w->points, &light, w->backend, list, &count, &w->error)
             : glint_light_six_points(&w->points, &light, w->backend, list, &count, &w->error));
    w->highlights += count;
}

static void setup_triangles(frame *f, glint_render_worker *w, size_t start, size_t end,
                            glint_triangle_list *list)
{
    glint_renderer *r = f->renderer;
    if (f->shading == GLINT_SHADING_GOURAUD_4) {
        const double begin = processor_seconds();
        const glint_point_light light = point_light(f);
        note(f, w,
             glint_split_triangles(w->split, &light, r->extent, r->screen, start, end, &w->points,
                                   w->backend, list, &w->highlights, &w->error));
        w->shading_seconds += processor_seconds() - begin;
    } else if (!glint_setup_triangles(&f->camera, f->mesh, r->extent, r->screen, start, end, list))
        fail_worker(f, w, GLINT_NO_MEMORY, "not enough memory for the frame's triangles");
}

/* What a shading does with triangles once they are on the frame. */
static void prepare_triangles(frame *f, glint_render_worker *w, glint_triangle_list *list)
{
    const double begin = processor_seconds();
    if (colors_of_triangles(f))
        light_triangles(f, w, list);
    if (f->sheen)
        w->sheen += glint_sheen_mark(&f->renderer->tables.sheen, &f->lighting, list);
    if (f->lighting.cosines != GLINT_COSINES_EXACT)
        glint_approximate_corners(&f->lighting, list);
    w->shading_seconds += processor_seconds() - begin;
}

static void triangle_phase(void *context, int worker_index)
{
    frame *f = context;
    glint_renderer *r = f->renderer;
    glint_render_worker *w = &r->workers[worker_index];
    const size_t items = f->mesh->triangle_count;
    size_t piece;
    while (take(f, w, r->list_count, &piece)) {
        const size_t start = piece * TRIANGLE_RUN;
        setup_triangles(f, w, start, end_of(start, TRIANGLE_RUN, items), &r->lists[piece]);
        if (w->status != GLINT_OK)
            continue;
        w->drawn += glint_setup_sources(&r->lists[piece]);
        prepare_triangles(f, w, &r->lists[piece]);
    }
}

/* Rows of the reflection map, before the bands. */
static void map_phase(void *context, int worker_index)
{
    frame *f = context;
    glint_render_worker *w = &f->renderer->workers[worker_index];
    glint_reflection_map *map = &f->renderer->tables.map;
    const double begin = processor_seconds();
    size_t row;
    while (take(f, w, (size_t)map->size, &row)) {
        note(f, w,
             glint_reflection_map_fill(map, (int)row, &w->points, &f->lighting, w->backend,
                                       &w->error));
        w->highlights += (uint64_t)map->size;
    }
    w->shading_seconds += processor_seconds() - begin;
}

static uint16_t *columns_of_band(const frame *f, const glint_render_worker *w)
{
    const glint_renderer *r = f->renderer;
    return &r->record.x[(size_t)w->band.first_y * (size_t)r->extent.width];
}

static glint_status gouraud_band(frame *f, glint_render_worker *w, const glint_visibility *band,
                                 uint64_t *fragments)
{
    return glint_gouraud_band(w->gouraud, band, f->shifts == GLINT_SHIFTS_EXACT ? NULL : w->divider,
                              f->shifts, f->image, fragments, &w->operations, &w->error);
}

static glint_status phong_band(frame *f, glint_render_worker *w, const glint_visibility *band,
                               uint64_t *fragments)
{
    uint64_t shaded = 0;
    const glint_status status =
        glint_shade_band(&w->shader, &f->lighting, band, w->backend, &f->renderer->record, f->image,
                         &shaded, &w->error);
    w->highlights += shaded;
    *fragments += shaded;
    return status;
}

/* The dull triangles' pixels are done first: the record is of the others. */
static glint_status band_in_parts(frame *f, glint_render_worker *w, uint64_t *fragments)
{
    const int32_t width = f->renderer->extent.width;
    glint_status status = GLINT_OK;
    glint_sheen_part(&w->band, width, true, &w->part);
    if (f->shading == GLINT_SHADING_MIXED)
        status = gouraud_band(f, w, &w->part, fragments);
    else
        glint_dull_band(&w->shader, &f->lighting, &w->part, columns_of_band(f, w), f->image,
                        fragments);
    glint_sheen_part(&w->band, width, false, &w->part);
    return status == GLINT_OK ? phong_band(f, w, &w->part, fragments) : status;
}

static glint_status shade_band(frame *f, glint_render_worker *w)
{
    uint64_t fragments = 0;
    glint_status status = GLINT_OK;
    switch (f->shading) {
    case GLINT_SHADING_FLAT:
        glint_flat_band(&w->band, f->image, &fragments);
        break;
    case GLINT_SHADING_GOURAUD:
    case GLINT_SHADING_GOURAUD_4:
        status = gouraud_band(f, w, &w->band, &fragments);
        break;
    case GLINT_SHADING_GOURAUD_PERSPECTIVE:
        glint_perspective_band(&w->band, f->image, &fragments);
        break;
    case GLINT_SHADING_QUADRATIC:
        status = glint_quadratic_band(w->quadratic, &w->band, f->image, &fragments, &w->error);
        break;
    case GLINT_SHADING_QUADRATIC_LISTING:
        glint_listing_band(&w->band, f->slips, f->image, &fragments);
        break;
    case GLINT_SHADING_REFLECTION_MAP:
        glint_reflection_map_band(&f->renderer->tables.map, &w->shader, &w->band,
                                  columns_of_band(f, w), f->image, &fragments);
        break;
    case GLINT_SHADING_WIRES:
        glint_wires_band(&w->band, f->color, f->image, &fragments);
        break;
    case GLINT_SHADING_NORMALS:
        glint_normals_band(&w->shader, &w->band, columns_of_band(f, w), f->image, &fragments);
        break;
    default:
        status =
            f->sheen ? band_in_parts(f, w, &fragments) : phong_band(f, w, &w->band, &fragments);
    }
    w->fragments += fragments;
    return status;
}

static void draw_band(frame *f, glint_render_worker *w, size_t band)
{
    glint_renderer *r = f->renderer;
    const int32_t first_y = (int32_t)band * GLINT_BAND_ROWS;
    const int32_t after = first_y + GLINT_BAND_ROWS;
    const int32_t last_y = (after < r->extent.height ? after : r->extent.height) - 1;
    glint_visibility_begin(&w->band, r->extent, first_y, last_y);
    for (size_t i = 0; i < r->list_count; i++) {
        if (f->stop != NULL && *f->stop)
            return; /* take() sees it too */
        glint_visibility_draw(&w->band, r->extent, &r->lists[i]);
    }
    const double begin = processor_seconds();
    for (int32_t y = first_y; y <= last_y; y++)
        glint_paint_begin_row(f->image, y);
    note(f, w, shade_band(f, w));
    w->shading_seconds += processor_seconds() - begin;
}

static void band_phase(void *context, int worker_index)
{
    frame *f = context;
    glint_render_worker *w = &f->renderer->workers[worker_index];
    const size_t bands = pieces((size_t)f->renderer->extent.height, GLINT_BAND_ROWS);
    size_t band;
    while (take(f, w, bands, &band)) {
        if (worker_index == 0 && f->renderer->progress != NULL) /* the caller's own thread */
            f->renderer->progress(f->renderer->progress_context, band, bands);
        draw_band(f, w, band);
    }
}

/* Runs one phase on all threads and returns the first worker's failure, if any. */
static glint_status run_phase(frame *f, glint_crew_task *phase, glint_error *err)
{
    glint_renderer *r = f->renderer;
    atomic_store(&f->next, 0);
    glint_crew_run(r->crew, phase, f);
    for (int i = 0; i < r->threads; i++)
        if (r->workers[i].status != GLINT_OK)
            return glint_fail(err, r->workers[i].status, "%s", r->workers[i].error.text);
    return GLINT_OK;
}

static glint_status make_room(glint_renderer *r, const glint_mesh *mesh, glint_error *err)
{
    if (r->screen_capacity < mesh->vertex_count) {
        free(r->screen);
        r->screen = malloc(mesh->vertex_count * sizeof *r->screen);
        r->screen_capacity = r->screen != NULL ? mesh->vertex_count : 0;
        if (r->screen == NULL) {
            return glint_fail(err, GLINT_NO_MEMORY,
                              "not enough memory for the frame's %zu vertices", mesh->vertex_count);
        }
    }
    const size_t lists = pieces(mesh->triangle_count, TRIANGLE_RUN);
    if (r->list_capacity < lists) {
        glint_triangle_list *more = realloc(r->lists, lists * sizeof *more);
        if (more == NULL) {
            return glint_fail(err, GLINT_NO_MEMORY,
                              "not enough memory for the frame's %zu triangles",
                              mesh->triangle_count);
        }
        for (size_t i = r->list_capacity; i < lists; i++)
            more[i] = (glint_triangle_list){0};
        r->lists = more;
        r->list_capacity = lists;
    }
    r->list_count = lists;
    return GLINT_OK;
}

/* What Gouraud's shading needs of a worker: room, and a divider with the frame's shifts. */
static glint_status prepare_gouraud(const frame *f, glint_render_worker *w, glint_error *err)
{
    if (w->gouraud == NULL) {
        w->gouraud = glint_gouraud_create(f->renderer->extent.width);
        if (w->gouraud == NULL) {
            return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a band %d pixels wide",
                              f->renderer->extent.width);
        }
    }
    if (f->shifts == GLINT_SHIFTS_EXACT || (w->divider != NULL && w->divider_shifts == f->shifts))
        return GLINT_OK;
    const glint_divider_config config = {
        .kind = f->renderer->config.kind,
        .form = GLINT_DIVIDER_PIPELINED,
        .shifts = f->shifts,
        .verilog = f->renderer->config.verilog,
    };
    glint_divider_backend_destroy(w->divider);
    w->divider_shifts = f->shifts;
    const glint_status status = glint_divider_backend_create(&config, &w->divider, err);
    if (status == GLINT_OK)
        glint_divider_backend_set_watch(w->divider, f->renderer->watch);
    return status;
}

static glint_status prepare_quadratic(const frame *f, glint_render_worker *w, glint_error *err)
{
    const glint_renderer *r = f->renderer;
    const glint_quadratic_config config = {
        .kind = r->config.kind, .fraction = f->fraction, .verilog = r->config.verilog};
    return glint_quadratic_shader_prepare(&w->quadratic, r->extent.width, &config, r->watch, err);
}

/* The model of the scene's highlights, kept from frame to frame because some take long to prepare.
 * *specular is NULL if the backend computes them. */
static glint_status prepare_specular(glint_renderer *r, const glint_scene *scene,
                                     const glint_reflectance **specular, glint_error *err)
{
    *specular = NULL;
    if (!scene->by_model)
        return GLINT_OK;
    if (r->config.kind != GLINT_BACKEND_REAL) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "highlights from a reflectance model need backend real: the other two "
                          "are the device itself");
    }
    *specular = &r->specular;
    if (r->prepared && r->specular.model == scene->specular && r->specular.n == scene->n &&
        r->f0 == scene->f0)
        return GLINT_OK;
    const glint_reflectance_parameters parameters = {.n = scene->n, .f0 = (double)scene->f0};
    glint_status status = glint_scene_check_exponent(scene->specular, scene->n, err);
    if (status == GLINT_OK)
        status = glint_reflectance_prepare(scene->specular, &parameters, &r->specular, err);
    r->prepared = status == GLINT_OK;
    r->f0 = scene->f0;
    return status;
}

/* The second view of a band that parts of it are drawn through. */
static glint_status prepare_part(const frame *f, glint_render_worker *w, glint_error *err)
{
    if (w->part.triangle == NULL) {
        glint_visibility_destroy(&w->part);
        glint_visibility_create(&w->part, f->renderer->extent.width);
    }
    return w->part.triangle != NULL
               ? GLINT_OK
               : glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a band %d pixels wide",
                            f->renderer->extent.width);
}

static glint_status prepare_split(glint_render_worker *w, glint_error *err)
{
    if (w->split == NULL)
        w->split = glint_split_create();
    return w->split != NULL ? GLINT_OK
                            : glint_fail(err, GLINT_NO_MEMORY, "not enough memory for triangles");
}

static glint_status prepare_workers(const frame *f, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int i = 0; status == GLINT_OK && i < f->renderer->threads; i++) {
        glint_render_worker *w = &f->renderer->workers[i];
        w->status = GLINT_OK;
        w->fragments = 0;
        w->highlights = 0;
        w->drawn = 0;
        w->sheen = 0;
        w->shading_seconds = 0.0;
        w->operations = (glint_span_operations){0};
        if (glint_shading_divides(f->shading))
            status = prepare_gouraud(f, w, err);
        if (status == GLINT_OK && f->sheen)
            status = prepare_part(f, w, err);
        if (status == GLINT_OK && f->shading == GLINT_SHADING_GOURAUD_4)
            status = prepare_split(w, err);
        if (status == GLINT_OK && f->shading == GLINT_SHADING_QUADRATIC)
            status = prepare_quadratic(f, w, err);
        w->clocks_before = w->divider != NULL ? glint_divider_backend_clocks(w->divider) : 0;
    }
    return status;
}

static glint_status run_phases(frame *f, glint_error *err)
{
    glint_status status = run_phase(f, vertex_phase, err);
    if (status == GLINT_OK)
        status = run_phase(f, triangle_phase, err);
    if (status == GLINT_OK)
        status = run_phase(f, band_phase, err);
    return status;
}

static void add_operations(glint_span_operations *sum, const glint_span_operations *more)
{
    for (int i = 0; i < GLINT_SPAN_STAGE_COUNT; i++) {
        sum->stage[i].additions += more->stage[i].additions;
        sum->stage[i].divisions += more->stage[i].divisions;
    }
}

static void collect_stats(const frame *f, double seconds, glint_render_stats *stats)
{
    const glint_renderer *r = f->renderer;
    *stats = (glint_render_stats){.triangles = f->mesh->triangle_count, .seconds = seconds};
    for (int i = 0; i < r->threads; i++) {
        const glint_render_worker *w = &r->workers[i];
        stats->fragments += w->fragments;
        stats->highlights += w->highlights;
        stats->drawn += w->drawn;
        stats->sheen += w->sheen;
        stats->shading_seconds += w->shading_seconds / r->threads;
        add_operations(&stats->operations, &w->operations);
        if (w->divider != NULL)
            stats->divider_clocks += glint_divider_backend_clocks(w->divider) - w->clocks_before;
        if (f->shading == GLINT_SHADING_QUADRATIC) {
            stats->spans += glint_quadratic_shader_spans(w->quadratic);
            stats->span_clocks += glint_quadratic_shader_clocks(w->quadratic);
        }
    }
    stats->divisions = (stats->operations.stage[GLINT_SPAN_EDGE_INCREMENTS].divisions +
                        stats->operations.stage[GLINT_SPAN_ROW_INCREMENTS].divisions) /
                       GLINT_DIVIDER_COMPONENTS;
}

static glint_status prepare_map(frame *f, const glint_scene *scene, glint_error *err)
{
    bool fill;
    glint_status status = glint_tables_map(&f->renderer->tables, scene, &f->lighting, &fill, err);
    if (status != GLINT_OK || !fill)
        return status;
    status = run_phase(f, map_phase, err);
    if (status == GLINT_OK)
        glint_tables_map_filled(&f->renderer->tables);
    return status;
}

static glint_status run_frame(glint_renderer *renderer, const glint_scene *scene, frame *f,
                              glint_error *err)
{
    glint_status status = glint_scene_check(scene, err);
    const glint_reflectance *specular = NULL;
    if (status == GLINT_OK)
        status = prepare_specular(renderer, scene, &specular, err);
    if (status == GLINT_OK)
        status = glint_shading_check(scene, renderer->config.kind, err);
    if (status == GLINT_OK)
        status = make_room(renderer, scene->mesh, err);
    if (status != GLINT_OK)
        return status;
    f->renderer = renderer;
    f->mesh = scene->mesh;
    f->shading = scene->shading;
    f->shifts = renderer->config.kind == GLINT_BACKEND_REAL ? GLINT_SHIFTS_EXACT : scene->shifts;
    f->fraction = scene->fraction;
    f->slips = scene->slips;
    atomic_init(&f->next, 0);
    atomic_init(&f->failed, false);
    f->camera = glint_camera_of(scene, renderer->extent.width, renderer->extent.height);
    f->lighting = glint_lighting_of(scene, &f->camera, specular);
    f->lighting.cosines = glint_shading_cosines(scene->shading);
    f->sheen = scene->isc || scene->shading == GLINT_SHADING_MIXED;
    memcpy(f->color, scene->color, sizeof f->color);
    status = prepare_workers(f, err);
    if (status == GLINT_OK && f->sheen)
        status = glint_tables_sheen(&renderer->tables, &renderer->config, scene, &f->lighting, err);
    if (status == GLINT_OK && scene->shading == GLINT_SHADING_REFLECTION_MAP)
        status = prepare_map(f, scene, err);
    return status == GLINT_OK ? run_phases(f, err) : status;
}

void glint_renderer_show(glint_renderer *renderer, glint_render_progress *progress, void *context)
{
    renderer->progress = progress;
    renderer->progress_context = context;
}

glint_status glint_render(glint_renderer *renderer, const glint_scene *scene, glint_image *image,
                          const volatile bool *stop, glint_render_stats *stats, glint_error *err)
{
    const double start = now();
    if (image->width != renderer->extent.width || image->height != renderer->extent.height) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "the image is %dx%d but the renderer's frame is %dx%d", image->width,
                          image->height, renderer->extent.width, renderer->extent.height);
    }
    renderer->recorded = false;
    frame f = {.image = image, .stop = stop};
    const glint_status status = run_frame(renderer, scene, &f, err);
    if (status != GLINT_OK)
        return status;
    renderer->material = f.lighting.material;
    renderer->recorded =
        !scene->by_model && (f.lighting.cosines != GLINT_COSINES_EXACT ||
                             f.shading == GLINT_SHADING_PHONG || f.shading == GLINT_SHADING_MIXED);
    if (stats != NULL)
        collect_stats(&f, now() - start, stats);
    return GLINT_OK;
}

static glint_status create_worker(glint_render_worker *w, int32_t width,
                                  const glint_backend_config *config, glint_error *err)
{
    glint_visibility_create(&w->band, width);
    const bool shader = glint_shader_create(&w->shader, width);
    if (!shader || w->band.depth == NULL || w->band.triangle == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a band %d pixels wide",
                          width);
    return glint_backend_create(config, &w->backend, err);
}

static glint_status create_parts(glint_renderer *r, const glint_backend_config *config,
                                 glint_error *err)
{
    const size_t pixels = (size_t)r->extent.width * (size_t)r->extent.height;
    r->workers = calloc((size_t)r->threads, sizeof *r->workers);
    r->record.cos_code = malloc(pixels * sizeof *r->record.cos_code);
    r->record.x = malloc(pixels * sizeof *r->record.x);
    r->record.in_row = malloc((size_t)r->extent.height * sizeof *r->record.in_row);
    if (r->workers == NULL || r->record.cos_code == NULL || r->record.x == NULL ||
        r->record.in_row == NULL) {
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a frame of %dx%d",
                          r->extent.width, r->extent.height);
    }
    for (int i = 0; i < r->threads; i++) {
        const glint_status status = create_worker(&r->workers[i], r->extent.width, config, err);
        if (status != GLINT_OK)
            return status;
    }
    return glint_crew_create(r->threads, &r->crew, err);
}

glint_status glint_renderer_create(int width, int height, int threads,
                                   const glint_backend_config *config, glint_renderer **renderer,
                                   glint_error *err)
{
    if (width < 1 || width > GLINT_IMAGE_SIDE_MAX || height < 1 || height > GLINT_IMAGE_SIDE_MAX) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "frame size %dx%d: each side must be from 1 to %d", width, height,
                          GLINT_IMAGE_SIDE_MAX);
    }
    if (threads < 1 || threads > GLINT_THREADS_MAX) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "threads is %d, not from 1 to %d", threads,
                          GLINT_THREADS_MAX);
    }
    glint_renderer *r = calloc(1, sizeof *r);
    if (r == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a renderer");
    r->extent = (glint_extent){width, height};
    r->threads = threads;
    r->config = *config;
    const glint_status status = create_parts(r, config, err);
    if (status != GLINT_OK) {
        glint_renderer_destroy(r);
        return status;
    }
    *renderer = r;
    return GLINT_OK;
}

void glint_renderer_destroy(glint_renderer *renderer)
{
    if (renderer == NULL)
        return;
    glint_crew_destroy(renderer->crew);
    for (int i = 0; renderer->workers != NULL && i < renderer->threads; i++) {
        glint_backend_destroy(renderer->workers[i].backend);
        glint_divider_backend_destroy(renderer->workers[i].divider);
        glint_quadratic_shader_destroy(renderer->workers[i].quadratic);
        glint_gouraud_destroy(renderer->workers[i].gouraud);
        glint_visibility_destroy(&renderer->workers[i].band);
        glint_visibility_destroy(&renderer->workers[i].part);
        glint_split_destroy(renderer->workers[i].split);
        glint_shader_destroy(&renderer->workers[i].shader);
    }
    for (size_t i = 0; i < renderer->list_capacity; i++)
        free(renderer->lists[i].triangle);
    free(renderer->lists);
    free(renderer->screen);
    glint_tables_free(&renderer->tables);
    free(renderer->record.cos_code);
    free(renderer->record.x);
    free(renderer->record.in_row);
    free(renderer->workers);
    free(renderer);
}

glint_status glint_renderer_watch(glint_renderer *renderer, glint_backend_watch *watch,
                                  glint_error *err)
{
    glint_render_worker *only = &renderer->workers[0];
    if (renderer->threads != 1) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "%d threads cannot share one watch",
                          renderer->threads);
    }
    renderer->watch = watch;
    glint_backend_set_watch(only->backend, watch);
    if (only->divider != NULL)
        glint_divider_backend_set_watch(only->divider, watch);
    glint_quadratic_shader_watch(only->quadratic, watch);
    return GLINT_OK;
}
