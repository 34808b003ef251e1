/* Two renderers, one scene; see study.h. */
#include "study/study.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "render/pick.h"

static const char *const backends[] = {
    [GLINT_BACKEND_C] = "c",
    [GLINT_BACKEND_RTL] = "rtl",
    [GLINT_BACKEND_REAL] = "real",
};

static bool find(const char *const *names, int count, const char *name, int *index)
{
    for (int i = 0; i < count; i++) {
        if (strcmp(names[i], name) == 0) {
            *index = i;
            return true;
        }
    }
    return false;
}

static glint_status refuse_shading(const char *text, glint_error *err)
{
    char names[256] = "";
    for (int i = 0; i < GLINT_SHADING_COUNT; i++) {
        const size_t used = strlen(names);
        (void)snprintf(names + used, sizeof names - used, "%s%s", i > 0 ? ", " : "",
                       glint_shading_names[i]);
    }
    return glint_fail(err, GLINT_BAD_ARGUMENT, "\"%.60s\" is not a shading: use one of %s", text,
                      names);
}

glint_status glint_study_method_parse(const char *text, glint_study_method *method,
                                      glint_error *err)
{
    glint_study_method parsed = {.backend = GLINT_BACKEND_REAL, .shading = GLINT_SHADING_PHONG};
    char who[64];
    const char *colon = strchr(text, ':');
    const size_t length = colon != NULL ? (size_t)(colon - text) : strlen(text);
    snprintf(who, sizeof who, "%.*s", (int)(length < sizeof who ? length : 0), text);
    int index;
    if (find(backends, GLINT_BACKEND_COUNT, who, &index)) {
        parsed.backend = (glint_backend_kind)index;
    } else if (glint_reflectance_find(who, &parsed.model)) {
        parsed.by_model = true;
    } else {
        return glint_fail(
            err, GLINT_BAD_ARGUMENT,
            "\"%.60s\" is not a method: use c, rtl, real or one that glint models lists", who);
    }
    if (colon != NULL) {
        if (!find(glint_shading_names, GLINT_SHADING_COUNT, colon + 1, &index))
            return refuse_shading(colon + 1, err);
        parsed.shading = (glint_shading)index;
    }
    *method = parsed;
    return GLINT_OK;
}

const char *glint_study_method_name(const glint_study_method *method, glint_study_name *name)
{
    const bool phong = method->shading == GLINT_SHADING_PHONG;
    snprintf(name->text, sizeof name->text, "%s%s%s",
             method->by_model ? glint_reflectance_names[method->model] : backends[method->backend],
             phong ? "" : ":", phong ? "" : glint_shading_names[method->shading]);
    return name->text;
}

/* One method at work. */
typedef struct side {
    glint_renderer *renderer;
    glint_image *image;
} side;

struct glint_study {
    glint_study_setup setup;
    side side[2];
    glint_image *dull; /* a frame without its highlight */
    uint32_t *seen;    /* the triangle of each pixel */
    uint8_t *mark;     /* for each triangle of the mesh */
};

static glint_status create_side(const glint_study_setup *setup, const glint_study_method *method,
                                side *created, glint_error *err)
{
    const glint_backend_config config = {
        .kind = method->by_model ? GLINT_BACKEND_REAL : method->backend,
        .gate = GLINT_GATE_COSINE,
        .pipeline = GLINT_PIPELINE_PIPELINED,
        .verilog = setup->verilog,
    };
    const glint_status status = glint_renderer_create(setup->width, setup->height, setup->threads,
                                                      &config, &created->renderer, err);
    return status == GLINT_OK
               ? glint_image_create(setup->width, setup->height, &created->image, err)
               : status;
}

static glint_status create_parts(glint_study *study, glint_error *err)
{
    const glint_study_setup *setup = &study->setup;
    glint_status status = GLINT_OK;
    for (int i = 0; status == GLINT_OK && i < 2; i++)
        status = create_side(setup, &setup->method[i], &study->side[i], err);
    if (status == GLINT_OK)
        status = glint_image_create(setup->width, setup->height, &study->dull, err);
    if (status != GLINT_OK)
        return status;
    study->seen = malloc((size_t)setup->width * (size_t)setup->height * sizeof *study->seen);
    study->mark = malloc(setup->scene.mesh->triangle_count);
    return study->seen != NULL && study->mark != NULL
               ? GLINT_OK
               : glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a study");
}

glint_status glint_study_create(const glint_study_setup *setup, glint_study **study,
                                glint_error *err)
{
    *study = NULL;
    glint_study *created = calloc(1, sizeof *created);
    if (created == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a study");
    created->setup = *setup;
    const glint_status status = create_parts(created, err);
    if (status != GLINT_OK) {
        glint_study_destroy(created);
        return status;
    }
    *study = created;
    return GLINT_OK;
}

void glint_study_destroy(glint_study *study)
{
    if (study == NULL)
        return;
    for (int i = 0; i < 2; i++) {
        glint_renderer_destroy(study->side[i].renderer);
        glint_image_destroy(study->side[i].image);
    }
    glint_image_destroy(study->dull);
    free(study->seen);
    free(study->mark);
    free(study);
}

static glint_scene scene_of(const glint_study *study, int which, int n)
{
    const glint_study_method *method = &study->setup.method[which];
    glint_scene scene = study->setup.scene;
    scene.n = n;
    scene.by_model = method->by_model;
    scene.specular = method->model;
    scene.shading = method->shading;
    return scene;
}

static glint_status shoot(glint_study *study, int which, const glint_scene *scene,
                          glint_image *image, const volatile bool *stop, glint_render_stats *stats,
                          glint_error *err)
{
    return glint_render(study->side[which].renderer, scene, image, stop, stats, err);
}

static bool is_brighter(const uint8_t *lit, const uint8_t *dull)
{
    return lit[0] > dull[0] || lit[1] > dull[1] || lit[2] > dull[2];
}

/* How many triangles are seen; with lit, how many in a pixel that is brighter there than in dull.
 */
static uint64_t count_triangles(glint_study *study, const glint_image *lit, const glint_image *dull)
{
    const size_t pixels = (size_t)study->setup.width * (size_t)study->setup.height;
    const size_t triangles = study->setup.scene.mesh->triangle_count;
    memset(study->mark, 0, triangles);
    uint64_t count = 0;
    for (size_t i = 0; i < pixels; i++) {
        const uint32_t triangle = study->seen[i];
        if (triangle != GLINT_NO_TRIANGLE && !study->mark[triangle] &&
            (lit == NULL || is_brighter(&lit->rgb[3 * i], &dull->rgb[3 * i]))) {
            study->mark[triangle] = 1;
            count++;
        }
    }
    return count;
}

static glint_status count_highlit(glint_study *study, int which, int n, const volatile bool *stop,
                                  glint_study_row *row, glint_error *err)
{
    glint_scene scene = scene_of(study, which, n);
    scene.ks = 0.0f;
    const glint_status status = shoot(study, which, &scene, study->dull, stop, NULL, err);
    if (status == GLINT_OK)
        row->highlit[which] = count_triangles(study, study->side[which].image, study->dull);
    return status;
}

/* Renders both and compares them. */
static glint_status compare_pictures(glint_study *study, int n, const volatile bool *stop,
                                     glint_study_row *row, glint_error *err)
{
    glint_status status = GLINT_OK;
    row->drawn = 0;
    for (int i = 0; status == GLINT_OK && i < 2; i++) {
        const glint_scene scene = scene_of(study, i, n);
        glint_render_stats stats = {0};
        status = shoot(study, i, &scene, study->side[i].image, stop, &stats, err);
        row->triangles = stats.triangles;
        row->drawn = stats.drawn > row->drawn ? stats.drawn : row->drawn;
    }
    if (status == GLINT_OK) {
        status =
            glint_image_compare(study->side[0].image, study->side[1].image, &row->difference, err);
    }
    if (status != GLINT_OK)
        return status;
    if (row->difference.object_pixels == 0) {
        return glint_fail(err, GLINT_BAD_INPUT,
                          "nothing to compare: the object is outside the frame");
    }
    return GLINT_OK;
}

static glint_status compare(glint_study *study, int n, const volatile bool *stop,
                            glint_study_row *row, glint_error *err)
{
    glint_status status = compare_pictures(study, n, stop, row, err);
    if (status != GLINT_OK)
        return status;
    glint_renderer_triangles(study->side[0].renderer, study->seen);
    row->seen = count_triangles(study, NULL, NULL);
    for (int i = 0; status == GLINT_OK && i < 2; i++)
        status = count_highlit(study, i, n, stop, row, err);
    return status;
}

static int compare_doubles(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Sorts the values. */
static double median(double *values, int count)
{
    qsort(values, (size_t)count, sizeof *values, compare_doubles);
    return 0.5 * (values[(count - 1) / 2] + values[count / 2]);
}

static glint_status time_frames(glint_study *study, int n, int frames, const volatile bool *stop,
                                glint_study_row *row, glint_error *err)
{
    double seconds[2][GLINT_STUDY_FRAMES_MAX];
    double ratio[GLINT_STUDY_FRAMES_MAX];
    for (int frame = 0; frame < frames; frame++) {
        for (int i = 0; i < 2; i++) {
            const glint_scene scene = scene_of(study, i, n);
            glint_render_stats stats = {0};
            const glint_status status =
                shoot(study, i, &scene, study->side[i].image, stop, &stats, err);
            if (status != GLINT_OK)
                return status;
            seconds[i][frame] = stats.seconds;
        }
        ratio[frame] = seconds[1][frame] / seconds[0][frame];
    }
    row->frames = frames;
    row->seconds[0] = median(seconds[0], frames);
    row->seconds[1] = median(seconds[1], frames);
    row->ratio = median(ratio, frames);
    return GLINT_OK;
}

static glint_status check_n(int n, glint_error *err)
{
    return n >= 0 && n <= (int)GLINT_N_MAX
               ? GLINT_OK
               : glint_fail(err, GLINT_BAD_ARGUMENT, "n = %d is not from 0 to %u", n, GLINT_N_MAX);
}

glint_status glint_study_compare(glint_study *study, int n, const volatile bool *stop,
                                 glint_image_difference *difference, glint_error *err)
{
    glint_study_row row;
    glint_status status = check_n(n, err);
    if (status == GLINT_OK)
        status = compare_pictures(study, n, stop, &row, err);
    if (status == GLINT_OK)
        *difference = row.difference;
    return status;
}

glint_status glint_study_run(glint_study *study, int n, int frames, const volatile bool *stop,
                             glint_study_row *row, glint_error *err)
{
    if (check_n(n, err) != GLINT_OK)
        return GLINT_BAD_ARGUMENT;
    if (frames < 0 || frames > GLINT_STUDY_FRAMES_MAX) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "%d frames: not from 0 to %d", frames,
                          GLINT_STUDY_FRAMES_MAX);
    }
    *row = (glint_study_row){.n = n};
    const glint_status status = compare(study, n, stop, row, err);
    return status == GLINT_OK && frames > 0 ? time_frames(study, n, frames, stop, row, err)
                                            : status;
}

const glint_image *glint_study_picture(const glint_study *study, int method)
{
    return study->side[method].image;
}
