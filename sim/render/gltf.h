/* What assimp does not report about a glTF 2.0 file. */
#ifndef GLINT_SIM_RENDER_GLTF_H
#define GLINT_SIM_RENDER_GLTF_H

#include "render/plain.h"

/* Examines the JSON of a .gltf or .glb file. GLINT_BAD_INPUT for a required extension that is not
 * supported, since the mesh would be wrong without it. Remarks on unsupported optional extensions
 * and morph targets. Invalid JSON is left for assimp to reject. `plain` stays empty. */
glint_status glint_gltf_check(const glint_text *text, glint_bytes *plain, glint_remarks *remarks,
                              glint_error *err);

#endif
