/* Puts the files of a program together and has the driver compile them; see program.h. */
#include "gl/program.h"

#include <string.h>

#include "gl/texts.h"

/* A file's lines, as in texts.h. */
typedef const char *const *lines;

/* The stages of a shading. Each has what it needs of the shared files and the model before it. */
typedef struct stages {
    const char *interpolation; /* what the word INTERPOLATION stands for; NULL: it does not occur */
    lines vertex, geometry, fragment;
    bool lit_vertex, lit_geometry, lit_fragment; /* the stage that calls light() */
} stages;

static const stages of_shading[GLINT_SHADING_COUNT] = {
    [GLINT_SHADING_FLAT] = {.vertex = glint_shader_flat_vert,
                            .geometry = glint_shader_flat_geom,
                            .fragment = glint_shader_flat_frag,
                            .lit_geometry = true},
    [GLINT_SHADING_GOURAUD] = {.interpolation = "noperspective",
                               .vertex = glint_shader_gouraud_vert,
                               .fragment = glint_shader_gouraud_frag,
                               .lit_vertex = true},
    [GLINT_SHADING_GOURAUD_PERSPECTIVE] = {.interpolation = "smooth",
                                           .vertex = glint_shader_gouraud_vert,
                                           .fragment = glint_shader_gouraud_frag,
                                           .lit_vertex = true},
    [GLINT_SHADING_PHONG] = {.vertex = glint_shader_phong_vert,
                             .fragment = glint_shader_phong_frag,
                             .lit_fragment = true},
};

bool glint_gl_has_shading(glint_shading shading)
{
    return (unsigned)shading < GLINT_SHADING_COUNT && of_shading[shading].vertex != NULL;
}

/* Strings of one shader, as glShaderSource() takes them. */
#define STRINGS_MAX 1024

typedef struct source {
    const char *string[STRINGS_MAX];
    GLsizei count;
} source;

static void add(source *s, const char *text)
{
    if (s->count < STRINGS_MAX)
        s->string[s->count++] = text;
}

static void add_lines(source *s, lines text)
{
    for (; *text != NULL; text++) {
        add(s, *text);
        add(s, "\n");
    }
}

/* The order in which tests/shader/lint.sh puts the files together as well. */
static source source_of(const stages *of, glint_reflectance_model model, lines shared, bool is_lit,
                        lines stage)
{
    source s = {.count = 0};
    add(&s, "#version 330 core\n");
    if (of->interpolation != NULL) {
        add(&s, "#define INTERPOLATION ");
        add(&s, of->interpolation);
        add(&s, "\n");
    }
    if (is_lit) {
        add_lines(&s, glint_shader_surface);
        add_lines(&s, glint_shader_models[model]);
        add_lines(&s, glint_shader_light);
    }
    if (shared != NULL)
        add_lines(&s, shared);
    add_lines(&s, stage);
    return s;
}

static glint_status refuse(const char *what, char *log, glint_error *err)
{
    log[strcspn(log, "\n")] = '\0';
    return glint_fail(err, GLINT_BAD_INPUT, "backend gl: the driver does not %s: %.300s", what,
                      log);
}

static glint_status attach(const glint_gl *gl, GLuint program, GLenum kind, const source *s,
                           glint_error *err)
{
    GLint good = GL_FALSE;
    char log[512] = "";
    if (s->count == STRINGS_MAX)
        return glint_fail(err, GLINT_BAD_INPUT, "backend gl: a shader has too many lines");
    const GLuint shader = gl->CreateShader(kind);
    gl->ShaderSource(shader, s->count, s->string, NULL);
    gl->CompileShader(shader);
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &good);
    gl->GetShaderInfoLog(shader, sizeof log, NULL, log);
    gl->AttachShader(program, shader);
    gl->DeleteShader(shader); /* goes with the program */
    return good ? GLINT_OK : refuse("compile a shader", log, err);
}

static glint_status attach_all(const glint_gl *gl, GLuint program, const stages *of,
                               glint_reflectance_model model, glint_error *err)
{
    source s = source_of(of, model, glint_shader_camera, of->lit_vertex, of->vertex);
    glint_status status = attach(gl, program, GL_VERTEX_SHADER, &s, err);
    if (status == GLINT_OK && of->geometry != NULL) {
        s = source_of(of, model, NULL, of->lit_geometry, of->geometry);
        status = attach(gl, program, GL_GEOMETRY_SHADER, &s, err);
    }
    if (status != GLINT_OK)
        return status;
    s = source_of(of, model, glint_shader_frame, of->lit_fragment, of->fragment);
    return attach(gl, program, GL_FRAGMENT_SHADER, &s, err);
}

static glint_status link_program(const glint_gl *gl, GLuint program, glint_error *err)
{
    GLint good = GL_FALSE;
    char log[512] = "";
    gl->LinkProgram(program);
    gl->GetProgramiv(program, GL_LINK_STATUS, &good);
    gl->GetProgramInfoLog(program, sizeof log, NULL, log);
    return good ? GLINT_OK : refuse("link the shaders", log, err);
}

static glint_status make_program(const glint_gl *gl, const stages *of,
                                 glint_reflectance_model model, GLuint *program, glint_error *err)
{
    const GLuint made = gl->CreateProgram();
    glint_status status = attach_all(gl, made, of, model, err);
    if (status == GLINT_OK)
        status = link_program(gl, made, err);
    if (status != GLINT_OK) {
        gl->DeleteProgram(made);
        return status;
    }
    *program = made;
    return GLINT_OK;
}

glint_status glint_gl_program(const glint_gl *gl, glint_shading shading,
                              glint_reflectance_model model, GLuint *program, glint_error *err)
{
    return glint_gl_has_shading(shading)
               ? make_program(gl, &of_shading[shading], model, program, err)
               : glint_fail(err, GLINT_BAD_ARGUMENT, "backend gl has no shaders for this shading");
}

glint_status glint_gl_gold_program(const glint_gl *gl, GLuint *program, glint_error *err)
{
    static const stages gold = {.vertex = glint_shader_gold_vert,
                                .fragment = glint_shader_gold_frag};
    return make_program(gl, &gold, GLINT_REFLECTANCE_LAMBERT, program, err); /* not in it */
}
