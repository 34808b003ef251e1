/* What a renderer works out once for a light and a material and keeps from frame to frame: the
 * sheen of the material (sheen.h) and the reflection map. */
#ifndef GLINT_SIM_RENDER_TABLES_H
#define GLINT_SIM_RENDER_TABLES_H

#include "render/reflection_map.h"
#include "render/sheen.h"

/* All that a table depends on. */
typedef struct glint_table_key {
    float light[3], ambient[3], lambert[3], f0;
    double n;
    int32_t model; /* −1: the backend */
    int32_t r, g, b;
    int32_t extra; /* the sheen's level, the map's size */
} glint_table_key;

glint_table_key glint_table_key_of(const glint_scene *scene, const glint_lighting *lighting,
                                   int extra);

typedef struct glint_tables {
    bool has_sheen, has_map;
    glint_table_key sheen_key, map_key;
    glint_sheen sheen;
    glint_reflection_map map;
} glint_tables;

/* The sheen for a scene. config: of the renderer's backends; Verilog is asked through its model. */
glint_status glint_tables_sheen(glint_tables *tables, const glint_backend_config *config,
                                const glint_scene *scene, const glint_lighting *lighting,
                                glint_error *err);

/* Room for the map of a scene; *fill: it is still to be filled, which the caller does before
 * glint_tables_map_filled(). */
glint_status glint_tables_map(glint_tables *tables, const glint_scene *scene,
                              const glint_lighting *lighting, bool *fill, glint_error *err);
void glint_tables_map_filled(glint_tables *tables);

void glint_tables_free(glint_tables *tables);

#endif
