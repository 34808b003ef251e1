/* What a scene that assimp has read does not give to its mesh. */
#ifndef GLINT_SIM_RENDER_LEFT_OUT_H
#define GLINT_SIM_RENDER_LEFT_OUT_H

#include <assimp/scene.h>

#include "render/remarks.h"

/* Remarks on faces of one corner or two, and on meshes that no node shows. */
void glint_left_out(const struct aiScene *scene, glint_remarks *remarks);

#endif
