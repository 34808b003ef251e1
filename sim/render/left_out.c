/* Counts points, lines and meshes that no node uses, for the remark on what was left out. */
#include "render/left_out.h"

#include <stdbool.h>
#include <stdlib.h>

#define DEPTH_MAX 256 /* of nodes; those below are refused later */

/* shown: for each mesh, whether one of the nodes names it. */
static void mark_shown(const struct aiScene *scene, const struct aiNode *node, int depth,
                       bool *shown)
{
    for (unsigned i = 0; i < node->mNumMeshes; i++)
        if (node->mMeshes[i] < scene->mNumMeshes)
            shown[node->mMeshes[i]] = true;
    for (unsigned i = 0; depth < DEPTH_MAX && i < node->mNumChildren; i++)
        mark_shown(scene, node->mChildren[i], depth + 1, shown);
}

static void count_thin(const struct aiMesh *mesh, size_t count[3])
{
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        const unsigned corners = mesh->mFaces[i].mNumIndices;
        if (corners < 3)
            count[corners]++;
    }
}

void glint_left_out(const struct aiScene *scene, glint_remarks *remarks)
{
    size_t thin[3] = {0}, hidden = 0;
    bool *shown = calloc(scene->mNumMeshes + 1, sizeof *shown);
    if (shown == NULL)
        return; /* building the mesh will report it */
    if (scene->mRootNode != NULL)
        mark_shown(scene, scene->mRootNode, 0, shown);
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        hidden += !shown[i];
        if (shown[i])
            count_thin(scene->mMeshes[i], thin);
    }
    glint_remark_count(remarks, thin[1], "point", "points");
    glint_remark_count(remarks, thin[2], "line", "lines");
    glint_remark_count(remarks, hidden, "mesh that no node uses", "meshes that no node uses");
    free(shown);
}
