/* Sheen and reflection map kept by a renderer; see tables.h. */
#include "render/tables.h"

#include <stdlib.h>
#include <string.h>

glint_table_key glint_table_key_of(const glint_scene *scene, const glint_lighting *lighting,
                                   int extra)
{
    glint_table_key key = {.model = -1};
    memcpy(key.light, lighting->light, sizeof key.light);
    memcpy(key.ambient, lighting->ambient, sizeof key.ambient);
    memcpy(key.lambert, lighting->lambert, sizeof key.lambert);
    key.f0 = scene->f0;
    key.n = scene->n;
    if (scene->by_model)
        key.model = (int32_t)scene->specular;
    key.r = lighting->material.r;
    key.g = lighting->material.g;
    key.b = lighting->material.b;
    key.extra = extra;
    return key;
}

static bool same(const glint_table_key *a, const glint_table_key *b)
{
    bool same = a->f0 == b->f0 && a->n == b->n && a->model == b->model && a->r == b->r &&
                a->g == b->g && a->b == b->b && a->extra == b->extra;
    for (int i = 0; i < 3; i++)
        same &= a->light[i] == b->light[i] && a->ambient[i] == b->ambient[i] &&
                a->lambert[i] == b->lambert[i];
    return same;
}

glint_status glint_tables_sheen(glint_tables *tables, const glint_backend_config *config,
                                const glint_scene *scene, const glint_lighting *lighting,
                                glint_error *err)
{
    const int level = scene->shading == GLINT_SHADING_MIXED ? scene->delta : 0;
    const glint_table_key key = glint_table_key_of(scene, lighting, level);
    glint_backend_config own = *config;
    glint_backend *backend = NULL;
    glint_status status = GLINT_OK;
    if (tables->has_sheen && same(&key, &tables->sheen_key))
        return GLINT_OK;
    tables->has_sheen = false;
    if (own.kind == GLINT_BACKEND_RTL)
        own.kind = GLINT_BACKEND_C;
    if (!scene->by_model)
        status = glint_backend_create(&own, &backend, err);
    if (status == GLINT_OK)
        status = glint_sheen_find(lighting, backend, level, &tables->sheen, err);
    glint_backend_destroy(backend);
    tables->sheen_key = key;
    tables->has_sheen = status == GLINT_OK;
    return status;
}

glint_status glint_tables_map(glint_tables *tables, const glint_scene *scene,
                              const glint_lighting *lighting, bool *fill, glint_error *err)
{
    const glint_table_key key = glint_table_key_of(scene, lighting, scene->map_size);
    *fill = !tables->has_map || !same(&key, &tables->map_key);
    if (!*fill)
        return GLINT_OK;
    const size_t entries = (size_t)scene->map_size * (size_t)scene->map_size;
    tables->has_map = false;
    free(tables->map.rgb);
    tables->map = (glint_reflection_map){scene->map_size, malloc(3 * entries)};
    if (tables->map.rgb == NULL) {
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a map of %d x %d normals",
                          scene->map_size, scene->map_size);
    }
    tables->map_key = key;
    return GLINT_OK;
}

void glint_tables_map_filled(glint_tables *tables)
{
    tables->has_map = true;
}

void glint_tables_free(glint_tables *tables)
{
    free(tables->map.rgb);
}
