/* Reads the parts of a glTF 2.0 file that assimp drops without a word; see gltf.h. */
#include "render/gltf.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "file/json.h"

/* Extensions that change how a surface looks, or what else is in the scene, but not a triangle; and
 * the one that Debian's assimp reads. */
static const char *const understood[] = {
    "EXT_lights_ies",
    "EXT_lights_image_based",
    "EXT_texture_webp",
    "EXT_texture_avif",
    "FB_ngon_encoding",
    "KHR_animation_pointer",
    "KHR_audio",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_common",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_materials_volume",
    "KHR_technique_webgl",
    "KHR_techniques_webgl",
    "KHR_texture_basisu",
    "KHR_texture_transform",
    "KHR_xmp",
    "KHR_xmp_json_ld",
    "MSFT_texture_dds",
};

static bool is_understood(const char *name)
{
    for (size_t i = 0; i < sizeof understood / sizeof understood[0]; i++)
        if (strcmp(name, understood[i]) == 0)
            return true;
    return false;
}

/* The first name in the list that is not understood, and not in the other list; NULL: none. */
static const char *first_unread(const json_t *list, const json_t *other)
{
    const json_t *entry;
    glint_json_each(entry, list)
    {
        const char *name = json_string_value(entry);
        bool found = name == NULL || is_understood(name);
        const json_t *second;
        glint_json_each(second, other)
        {
            found =
                found || (json_is_string(second) && strcmp(name, json_string_value(second)) == 0);
        }
        if (!found)
            return name;
    }
    return NULL;
}

static glint_status check_extensions(const glint_text *text, const json_t *json,
                                     glint_remarks *remarks, glint_error *err)
{
    const json_t *required = json_object_get(json, "extensionsRequired");
    const json_t *used = json_object_get(json, "extensionsUsed");
    const char *name = first_unread(required, NULL);
    if (name != NULL) {
        return glint_fail(err, GLINT_BAD_INPUT,
                          "%.300s: requires the unsupported glTF extension %s: export it without",
                          text->path, glint_word_of(name, strlen(name)).text);
    }
    name = first_unread(used, required);
    if (name != NULL) {
        glint_remark(remarks, "glTF extension %s is not supported",
                     glint_word_of(name, strlen(name)).text);
    }
    return GLINT_OK;
}

static bool has_weight(const json_t *owner)
{
    const json_t *weight;
    glint_json_each(weight, json_object_get(owner, "weights"))
    {
        if (json_is_number(weight) && json_number_value(weight) != 0.0)
            return true;
    }
    return false;
}

/* Morph targets that are blended in from the start: by their mesh, or by its node. */
static void look_for_weights(const json_t *json, glint_remarks *remarks)
{
    static const char *const owners[] = {"meshes", "nodes"};
    for (size_t i = 0; i < sizeof owners / sizeof owners[0]; i++) {
        const json_t *owner;
        glint_json_each(owner, json_object_get(json, owners[i]))
        {
            if (has_weight(owner)) {
                glint_remark(remarks, "morph targets are ignored");
                return;
            }
        }
    }
}

/* A second set of joints for each vertex, which assimp 5.2 does not read. */
static void look_for_joints(const json_t *json, glint_remarks *remarks)
{
    const json_t *mesh;
    glint_json_each(mesh, json_object_get(json, "meshes"))
    {
        const json_t *primitive;
        glint_json_each(primitive, json_object_get(mesh, "primitives"))
        {
            if ((json_object_get(json_object_get(primitive, "attributes"), "JOINTS_1") != NULL)) {
                glint_remark(remarks, "only four joints per vertex are used");
                return;
            }
        }
    }
}

/* What inverseBindMatrices left out means, assimp 5.2 does not know: it crashes. */
static glint_status check_skins(const glint_text *text, const json_t *json, glint_error *err)
{
    int at = 0;
    const json_t *skin;
    glint_json_each(skin, json_object_get(json, "skins"))
    {
        if (json_object_get(skin, "inverseBindMatrices") == NULL) {
            return glint_fail(
                err, GLINT_BAD_INPUT,
                "%.300s: skin %d has no inverseBindMatrices, which are required: export them",
                text->path, at);
        }
        at++;
    }
    return GLINT_OK;
}

/* ---- What the scene shows -----------------------------------------------------------------------
 */

#define DEPTH_MAX 256 /* of nodes; those below are refused later */

typedef struct all_nodes {
    size_t count;
    const json_t **at;
    bool *shown;
} all_nodes;

static bool list_nodes(const json_t *json, all_nodes *nodes)
{
    const json_t *list = json_object_get(json, "nodes");
    const size_t count = (size_t)(int)json_array_size(list);
    nodes->at = calloc(count + 1, sizeof(const json_t *));
    nodes->shown = calloc(count + 1, sizeof *nodes->shown);
    const json_t *node;
    glint_json_each(node, list)
    {
        if (nodes->at != NULL)
            nodes->at[nodes->count++] = node;
    }
    return nodes->at != NULL && nodes->shown != NULL;
}

/* Marks these nodes and all below them. */
static void mark_shown(all_nodes *nodes, const json_t *indices, int depth)
{
    const json_t *index;
    glint_json_each(index, indices)
    {
        const double at = json_is_number(index) ? json_number_value(index) : -1.0;
        if (depth < DEPTH_MAX && at >= 0.0 && at < (double)nodes->count &&
            !nodes->shown[(size_t)at]) {
            nodes->shown[(size_t)at] = true;
            mark_shown(nodes, json_object_get(nodes->at[(size_t)at], "children"), depth + 1);
        }
    }
}

/* The scene that assimp reads: the one that is named, else the first. */
static const json_t *scene_of(const json_t *json)
{
    const json_t *scenes = json_object_get(json, "scenes");
    const json_t *chosen = json_object_get(json, "scene");
    return json_array_get(scenes,
                          (size_t)(json_is_number(chosen) ? json_integer_value(chosen) : 0));
}

static void look_for_hidden(const json_t *json, glint_remarks *remarks)
{
    all_nodes nodes = {0};
    const json_t *scene = scene_of(json);
    size_t hidden = 0;
    if (scene != NULL && list_nodes(json, &nodes)) {
        mark_shown(&nodes, json_object_get(scene, "nodes"), 0);
        for (size_t i = 0; i < nodes.count; i++)
            hidden +=
                (json_object_get(nodes.at[i], "mesh") != NULL) != 0 && !nodes.shown[i] ? 1 : 0;
    }
    glint_remark_count(remarks, hidden, "mesh outside the scene", "meshes outside the scene");
    free(nodes.at);
    free(nodes.shown);
}

/* The JSON of a binary file is its first chunk, after a twelve-byte header. */
static json_t *parse(const glint_text *text)
{
    if (text->length < 20 || memcmp(text->at, "glTF", 4) != 0)
        return json_loadb(text->at, text->length, 0, NULL);
    uint32_t length = 0;
    for (int i = 3; i >= 0; i--)
        length = length << 8 | (unsigned char)text->at[12 + i];
    return length <= text->length - 20 ? json_loadb(text->at + 20, length, 0, NULL) : NULL;
}

glint_status glint_gltf_check(const glint_text *text, glint_bytes *plain, glint_remarks *remarks,
                              glint_error *err)
{
    (void)plain;
    json_t *json = parse(text);
    glint_status status = GLINT_OK;
    if (json != NULL) {
        status = check_extensions(text, json, remarks, err);
        look_for_weights(json, remarks);
        look_for_hidden(json, remarks);
        look_for_joints(json, remarks);
    }
    if (json != NULL && status == GLINT_OK)
        status = check_skins(text, json, err);
    json_decref(json);
    return status;
}
