/* What a scene read by assimp contains that its mesh does not. */
#ifndef GLINT_SIM_RENDER_LEFT_OUT_H
#define GLINT_SIM_RENDER_LEFT_OUT_H

#include <assimp/scene.h>

#include "render/remarks.h"

/* Remarks on faces with only one or two corners and on meshes that no node uses. */
void glint_left_out(const struct aiScene *scene, glint_remarks *remarks);

#endif
