/* Rows as CSV and JSON; see table.h. */
#include "study/table.h"

#include <inttypes.h>
#include <string.h>

/* In quotes where it holds what would end it. */
static void write_text(FILE *to, const char *text)
{
    if (text[strcspn(text, "\",\r\n")] == '\0') {
        fputs(text, to);
        return;
    }
    fputc('"', to);
    for (; *text != '\0'; text++)
        fprintf(to, *text == '"' ? "\"\"" : "%c", *text);
    fputc('"', to);
}

#define SOURCE_NAMES "a,b,model,density\n"

/* The end of a row: from what it is. */
static void write_source(FILE *to, const glint_study_setup *setup)
{
    glint_study_name a, b;
    fprintf(to, ",%s,%s,", glint_study_method_name(&setup->method[0], &a),
            glint_study_method_name(&setup->method[1], &b));
    write_text(to, setup->model);
    if (setup->density > 0)
        fprintf(to, ",%d\n", setup->density);
    else
        fputs(",\n", to);
}

void glint_study_write_differences(FILE *to, const glint_study_setup *setup,
                                   const glint_study_row *rows, int count)
{
    fprintf(to, "n,nmse,psnr_db,largest,largest_x,largest_y,differing_pixels,object_pixels,"
                "triangles,drawn,seen,highlit_a,highlit_b,reading," SOURCE_NAMES);
    for (int i = 0; i < count; i++) {
        const glint_study_row *r = &rows[i];
        const glint_image_difference *d = &r->difference;
        fprintf(to, "%d,%.9g,", r->n, d->nmse);
        if (d->largest_x >= 0)
            fprintf(to, "%.9g,%d,%d,%d,", d->psnr, d->largest, d->largest_x, d->largest_y);
        else
            fputs("inf,0,,,", to); /* equal: there is no such pixel */
        fprintf(to,
                "%" PRIu64 ",%" PRIu64 ",%" PRIu64 ",%" PRIu64 ",%" PRIu64 ",%" PRIu64 ",%" PRIu64
                ",%s",
                d->differing_pixels, d->object_pixels, r->triangles, r->drawn, r->seen,
                r->highlit[0], r->highlit[1], glint_image_reading(d->nmse));
        write_source(to, setup);
    }
}

static double per_second(double seconds)
{
    return seconds > 0.0 ? 1.0 / seconds : 0.0;
}

void glint_study_write_times(FILE *to, const glint_study_setup *setup, const glint_study_row *rows,
                             int count)
{
    fprintf(to, "n,frames,seconds_a,seconds_b,fps_a,fps_b,b_to_a," SOURCE_NAMES);
    for (int i = 0; i < count; i++) {
        const glint_study_row *r = &rows[i];
        fprintf(to, "%d,%d,%.6g,%.6g,%.5g,%.5g,%.4g", r->n, r->frames, r->seconds[0], r->seconds[1],
                per_second(r->seconds[0]), per_second(r->seconds[1]), r->ratio);
        write_source(to, setup);
    }
}

static void add_numbers(json_t *json, const char *name, const double *value, int count)
{
    json_object_set_new(json, name, glint_json_numbers_of(value, count));
}

static void add_color(json_t *json, const char *name, const uint8_t rgb[3])
{
    add_numbers(json, name, (const double[]){rgb[0], rgb[1], rgb[2]}, 3);
}

/* As the floats were written by whoever set them: 0.2, not 0.200000003. */
static double plain(float value)
{
    char text[32];
    double back = 0.0;
    snprintf(text, sizeof text, "%.6g", (double)value);
    return sscanf(text, "%lf", &back) == 1 ? back : (double)value;
}

/* One number for white light, else three. */
static void add_intensity(json_t *json, const char *name, const float rgb[3])
{
    if (rgb[0] == rgb[1] && rgb[0] == rgb[2])
        glint_json_add_number(json, name, plain(rgb[0]));
    else
        add_numbers(json, name, (const double[]){plain(rgb[0]), plain(rgb[1]), plain(rgb[2])}, 3);
}

static void add_scene(json_t *json, const glint_study_setup *setup)
{
    const glint_scene *s = &setup->scene;
    json_t *scene = glint_json_add(json, "scene", json_object());
    glint_json_add_text(scene, "model", setup->model);
    if (setup->density > 0)
        glint_json_add_number(scene, "density", setup->density);
    else
        json_object_set_new(scene, "density", json_null());
    glint_json_add_number(scene, "width", setup->width);
    glint_json_add_number(scene, "height", setup->height);
    add_color(scene, "color", s->color);
    add_color(scene, "highlight", s->highlight);
    add_numbers(scene, "light",
                (const double[]){plain(s->light[0]), plain(s->light[1]), plain(s->light[2])}, 3);
    const struct {
        const char *name;
        float value;
    } reals[] = {{"ka", s->ka},   {"kd", s->kd},       {"ks", s->ks},   {"f0", s->f0},
                 {"yaw", s->yaw}, {"pitch", s->pitch}, {"fov", s->fov}, {"distance", s->distance}};
    add_intensity(scene, "ia", s->ia);
    add_intensity(scene, "ie", s->ie);
    for (size_t i = 0; i < sizeof reals / sizeof reals[0]; i++)
        glint_json_add_number(scene, reals[i].name, plain(reals[i].value));
    if (s->mesh->rest != NULL) {
        add_numbers(scene, "rotate", s->mesh->transform.rotate, 3);
        add_numbers(scene, "scale", s->mesh->transform.scale, 3);
        add_numbers(scene, "move", s->mesh->transform.move, 3);
    }
}

static json_t *row_json(const glint_study_row *r)
{
    const glint_image_difference *d = &r->difference;
    json_t *json = json_object();
    glint_json_add_number(json, "n", r->n);
    glint_json_add_number(json, "nmse", d->nmse);
    glint_json_add_number(json, "psnr", d->psnr);
    glint_json_add_text(json, "reading", glint_image_reading(d->nmse));
    glint_json_add_number(json, "largest", d->largest);
    if (d->largest_x >= 0) {
        glint_json_add_number(json, "largest_x", d->largest_x);
        glint_json_add_number(json, "largest_y", d->largest_y);
    } else {
        json_object_set_new(json, "largest_x", json_null());
        json_object_set_new(json, "largest_y", json_null());
    }
    glint_json_add_number(json, "differing_pixels", (double)d->differing_pixels);
    glint_json_add_number(json, "object_pixels", (double)d->object_pixels);
    glint_json_add_number(json, "triangles", (double)r->triangles);
    glint_json_add_number(json, "drawn", (double)r->drawn);
    glint_json_add_number(json, "seen", (double)r->seen);
    glint_json_add_number(json, "highlit_a", (double)r->highlit[0]);
    glint_json_add_number(json, "highlit_b", (double)r->highlit[1]);
    return json;
}

json_t *glint_study_json(const glint_study_setup *setup, const glint_study_row *rows, int count)
{
    glint_study_name name;
    json_t *json = json_object();
    glint_json_add_text(json, "a", glint_study_method_name(&setup->method[0], &name));
    glint_json_add_text(json, "b", glint_study_method_name(&setup->method[1], &name));
    add_scene(json, setup);
    json_t *array = glint_json_add(json, "rows", json_array());
    for (int i = 0; i < count; i++)
        json_array_append_new(array, row_json(&rows[i]));
    return json;
}

json_t *glint_study_times_json(const glint_study_row *rows, int count)
{
    json_t *array = json_array();
    for (int i = 0; i < count; i++) {
        json_t *json = json_object();
        glint_json_add_number(json, "n", rows[i].n);
        glint_json_add_number(json, "frames", rows[i].frames);
        glint_json_add_number(json, "seconds_a", rows[i].seconds[0]);
        glint_json_add_number(json, "seconds_b", rows[i].seconds[1]);
        glint_json_add_number(json, "fps_a", per_second(rows[i].seconds[0]));
        glint_json_add_number(json, "fps_b", per_second(rows[i].seconds[1]));
        glint_json_add_number(json, "b_to_a", rows[i].ratio);
        json_array_append_new(array, json);
    }
    return array;
}
