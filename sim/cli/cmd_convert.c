/* `glint convert`: a mesh, built in or from a file, written as a file of another format. */
#include <stdio.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/picture.h"
#include "cli/scene_options.h"
#include "convert/convert.h"
#include "file/kind.h"
#include "file/new_file.h"
#include "file/same.h"

typedef struct convert_options {
    const char *in, *out;
    int64_t density;
    bool json, force;
} convert_options;

static const char details[] =
    "The ending of OUT says how: .3ds, .obj, .ply, .stl or .glb. IN is the teapot, the\n"
    "sphere, the quad or a mesh file, as for render. An existing file of another kind is\n"
    "not overwritten without --force.\n"
    "\n"
    "A .3ds file has no normals: smoothing groups keep what is smooth and what is an edge.\n"
    "Vertices at one place become one; more than 65535 of them, or of triangles, are split\n"
    "into several objects. A .stl file has neither: all of it is flat.";

static int parse(int argc, char **argv, convert_options *chosen)
{
    const glint_option options[] = {
        {.name = "density",
         .help = "tessellation of the teapot (1 to 256) or the sphere (4 to 4096, even); 0: the "
                 "model's default",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->density, 0, GLINT_SPHERE_DENSITY_MAX}},
        GLINT_FORCE_OPTION(&chosen->force),
        {.name = "json",
         .help = "print what was written as JSON",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    const glint_positional positionals[] = {{.name = "IN", .value = &chosen->in},
                                            {.name = "OUT", .value = &chosen->out}};
    static const glint_example examples[] = {
        {"the teapot, for other programs", "glint convert teapot teapot.3ds"},
        {"a mesh of yours", "glint convert mesh.obj mesh.3ds"},
        {"a coarse sphere, as glTF", "glint convert sphere sphere.glb --density 16"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "convert",
        .summary = "Writes a mesh as a file of the format that its name ends in.",
        .details = details,
        .examples = examples,
        .options = options,
        .option_count = sizeof options / sizeof options[0],
        .positionals = positionals,
        .positional_count = sizeof positionals / sizeof positionals[0],
    };
    return glint_options_parse(&line, argc, argv);
}

/* Finds an unwritable target before the work. */
static glint_status check_target(const convert_options *chosen, glint_error *err)
{
    glint_status status = glint_convert_check(chosen->out, err);
    if (status != GLINT_OK)
        return status;
    if (glint_file_same(chosen->in, chosen->out))
        return glint_fail(err, GLINT_BAD_ARGUMENT, "%.400s is the model file itself", chosen->out);
    if (!chosen->force)
        status = glint_file_replaceable(chosen->out, err);
    return status == GLINT_OK ? glint_new_file_check(chosen->out, err) : status;
}

static glint_status convert(const convert_options *chosen, glint_converted *converted,
                            glint_error *err)
{
    glint_scene_options what = glint_scene_options_default();
    glint_mesh *mesh = NULL;
    what.model = chosen->in;
    what.density = chosen->density;
    glint_status status = check_target(chosen, err);
    if (status == GLINT_OK)
        status = glint_scene_options_mesh(&what, &mesh, err);
    if (status != GLINT_OK)
        return status;
    glint_tell_remarks("convert", chosen->in, mesh->remarks);
    status = glint_convert(mesh, chosen->out, glint_stop_flag(), converted, err);
    glint_mesh_destroy(mesh);
    return status;
}

static bool has_groups(const glint_converted *converted)
{
    return converted->groups > 0 || converted->unmarked > 0;
}

static void print_text(const convert_options *chosen, const glint_converted *converted)
{
    printf("%s: %zu triangles, %zu vertices, %zu object%s", chosen->in, converted->triangles,
           converted->vertices, converted->objects, converted->objects == 1 ? "" : "s");
    if (has_groups(converted))
        printf(", %d smoothing group%s", converted->groups, converted->groups == 1 ? "" : "s");
    if (converted->unmarked > 0)
        printf(", %zu smooth edges left without one", converted->unmarked);
    printf("\nwrote %s\n", chosen->out);
}

static bool print_json(const convert_options *chosen, const glint_converted *converted)
{
    json_t *json = json_object();
    glint_json_add_text(json, "model", chosen->in);
    glint_json_add_text(json, "out", chosen->out);
    glint_json_add_text(json, "format", converted->format + 1); /* without its dot */
    glint_json_add_number(json, "triangles", (double)converted->triangles);
    glint_json_add_number(json, "vertices", (double)converted->vertices);
    glint_json_add_number(json, "objects", (double)converted->objects);
    glint_json_add_number(json, "groups", converted->groups);
    glint_json_add_number(json, "edges_without_group", (double)converted->unmarked);
    return glint_output_json(json);
}

int glint_cmd_convert(int argc, char **argv)
{
    convert_options chosen = {0};
    const int parsed = parse(argc, argv, &chosen);
    if (parsed != GLINT_OPTIONS_RUN)
        return parsed;
    glint_error err;
    glint_converted converted;
    if (convert(&chosen, &converted, &err) != GLINT_OK)
        return glint_complain_error("convert", &err);
    if (!chosen.json)
        print_text(&chosen, &converted);
    else if (!print_json(&chosen, &converted))
        return glint_complain("convert", GLINT_EXIT_TROUBLE, "out of memory");
    return glint_output_finish("convert", GLINT_EXIT_OK);
}
