/* From the rasterizer's own camera and lighting to uniforms, by their names in sim/shader. */
#include "gl/uniforms.h"

#include "gl/gold_maps.h"
#include "glint_specular.h"

/* With it the listing's map, 0.0065 of it in a unit, covers the object once. */
#define LISTING_RADIUS 70.0

/* The program being filled. A uniform that it lacks has location -1, which sets nothing. */
typedef struct target {
    const glint_gl *gl;
    GLuint program;
} target;

static GLint at(const target *t, const char *name)
{
    return t->gl->GetUniformLocation(t->program, name);
}

static void set(const target *t, const char *name, double value)
{
    t->gl->Uniform1f(at(t, name), (float)value);
}

static void set3(const target *t, const char *name, const float value[3])
{
    t->gl->Uniform3fv(at(t, name), 1, value);
}

static void store(float to[3], glint_view_point p)
{
    to[0] = (float)p.x;
    to[1] = (float)p.y;
    to[2] = (float)-p.w;
}

/* glint_camera_view() and glint_camera_rotate() as a matrix and an offset: where they send the
 * origin and the three axes. */
static void set_camera(const target *t, const glint_camera *camera)
{
    static const float origin[3] = {0.0f, 0.0f, 0.0f};
    const glint_view_point o = glint_camera_view(camera, origin);
    float place[3], view[9], turn[9];
    store(place, o);
    for (int i = 0; i < 3; i++) {
        const float axis[3] = {i == 0 ? 1.0f : 0.0f, i == 1 ? 1.0f : 0.0f, i == 2 ? 1.0f : 0.0f};
        const glint_view_point p = glint_camera_view(camera, axis);
        store(&view[3 * i], (glint_view_point){p.x - o.x, p.y - o.y, p.w - o.w});
        glint_vec3_store(glint_camera_rotate(camera, glint_vec3_of(axis)), &turn[3 * i]);
    }
    set3(t, "place", place);
    t->gl->UniformMatrix3fv(at(t, "view"), 1, GL_FALSE, view);
    t->gl->UniformMatrix3fv(at(t, "turn"), 1, GL_FALSE, turn);
    t->gl->Uniform2f(at(t, "lens"), (float)(camera->focal / camera->half_width),
                     (float)(camera->focal / camera->half_height));
    set(t, "near", GLINT_NEAR);
    /* Of gold.vert: the object's radius is LISTING_RADIUS of the listing's units. */
    float middle[3];
    glint_vec3_store(camera->centre, middle);
    set3(t, "middle", middle);
    set(t, "units", LISTING_RADIUS * camera->scale);
}

static void set_light(const target *t, const glint_lighting *lighting)
{
    const float registers[3] = {lighting->material.r, lighting->material.g, lighting->material.b};
    set3(t, "light_direction", lighting->light);
    set3(t, "ambient", lighting->ambient);
    set3(t, "lambert", lighting->lambert);
    set3(t, "registers", registers);
    t->gl->Uniform2f(at(t, "half_frame"), lighting->half_width, lighting->half_height);
    set(t, "inv_focal", (double)lighting->inv_focal);
}

static int minimax_k(glint_reflectance_model model)
{
    switch (model) {
    case GLINT_REFLECTANCE_LYON_2_MINIMAX:
        return 2;
    case GLINT_REFLECTANCE_LYON_4_MINIMAX:
        return 4;
    case GLINT_REFLECTANCE_LYON_8_MINIMAX:
        return 8;
    case GLINT_REFLECTANCE_LYON_16_MINIMAX:
        return 16;
    default:
        return 0;
    }
}

/* What a model's file declares besides n. */
static void set_model(const target *t, const glint_scene *scene, glint_reflectance_model model)
{
    const double n = scene->n;
    set(t, "n", n);
    switch (model) {
    case GLINT_REFLECTANCE_SCHLICK_MODIFIED_POWER:
        set(t, "a", glint_schlick_power_a(n));
        break;
    case GLINT_REFLECTANCE_QUADRATIC:
        set(t, "a", glint_quadratic_a(n));
        break;
    case GLINT_REFLECTANCE_COOK_TORRANCE:
        set(t, "f0", (double)scene->f0);
        break;
    case GLINT_REFLECTANCE_TORRANCE_SPARROW:
        set(t, "f0", (double)scene->f0);
        set(t, "facets", glint_gaussian_facets(glint_roughness_of_exponent(n)));
        break;
    case GLINT_REFLECTANCE_DEVICE:
        t->gl->Uniform1ui(at(t, "sigma"), glint_rom33((uint32_t)n));
        t->gl->Uniform1ui(at(t, "limit"), glint_rom9(GLINT_GATE_COSINE, (uint32_t)n));
        break;
    default:
        if (minimax_k(model) != 0)
            set(t, "slope", glint_lyon_slope_minimax(minimax_k(model), n));
    }
}

void glint_gl_set_uniforms(const glint_gl *gl, GLuint program, const glint_scene *scene,
                           const glint_camera *camera, const glint_lighting *lighting,
                           glint_reflectance_model model)
{
    const target t = {gl, program};
    set_camera(&t, camera);
    set_light(&t, lighting);
    gl->Uniform1i(at(&t, "base_map"), GLINT_GOLD_BASE);
    gl->Uniform1i(at(&t, "bump_map"), GLINT_GOLD_BUMP);
    set_model(&t, scene, model);
}
