/* The options of single shadings; see shading_options.h. */
#include "cli/shading_options.h"

#include <string.h>

#include "cli/output.h"
#include "render/reflection_map.h"

static const char *const switch_names[] = {"off", "on", NULL};

glint_shading_options glint_shading_options_default(void)
{
    glint_scene scene = {0};
    glint_scene_defaults(&scene);
    return (glint_shading_options){.delta = scene.delta, .map = scene.map_size};
}

void glint_shading_options_add(glint_shading_options *chosen,
                               glint_option rows[GLINT_SHADING_OPTIONS])
{
    const glint_option options[] = {
        {.name = "isc",
         .help = "for --shading phong: no highlight is computed in triangles that have none; the "
                 "picture is the same",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->isc, switch_names}},
        {.name = "delta",
         .given = &chosen->delta_given,
         .help = "for --shading mixed: a highlight of so many levels counts as none",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->delta, 0, GLINT_DELTA_MAX}},
        {.name = "map",
         .given = &chosen->map_given,
         .help = "for --shading reflection-map: entries each way",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->map, GLINT_MAP_SIZE_MIN, GLINT_MAP_SIZE_MAX}},
    };
    _Static_assert(sizeof options == GLINT_SHADING_OPTIONS * sizeof options[0], "as many rows");
    memcpy(rows, options, sizeof options);
}

static int refuse(const char *command, const char *option, glint_shading shading)
{
    return glint_complain(command, GLINT_EXIT_TROUBLE, "--%s needs --shading %s", option,
                          glint_shading_names[shading]);
}

int glint_shading_options_settle(const char *command, const glint_shading_options *chosen,
                                 glint_scene *scene)
{
    if (chosen->isc != 0 && scene->shading != GLINT_SHADING_PHONG)
        return refuse(command, "isc", GLINT_SHADING_PHONG);
    if (chosen->delta_given && scene->shading != GLINT_SHADING_MIXED)
        return refuse(command, "delta", GLINT_SHADING_MIXED);
    if (chosen->map_given && scene->shading != GLINT_SHADING_REFLECTION_MAP)
        return refuse(command, "map", GLINT_SHADING_REFLECTION_MAP);
    scene->isc = chosen->isc != 0;
    scene->delta = (int)chosen->delta;
    scene->map_size = (int)chosen->map;
    return GLINT_OPTIONS_RUN;
}
