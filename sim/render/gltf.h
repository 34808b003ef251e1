/* What assimp does not tell of a glTF 2.0 file. */
#ifndef GLINT_SIM_RENDER_GLTF_H
#define GLINT_SIM_RENDER_GLTF_H

#include "render/plain.h"

/* Looks through the JSON of a .gltf or .glb. GLINT_BAD_INPUT where an extension is required that is
 * not read: without it the mesh would be another. Remarks on what is not: such extensions that are
 * only used, shapes blended in by weight. What is no JSON is left to assimp to refuse. `plain`
 * stays empty. */
glint_status glint_gltf_check(const glint_text *text, glint_bytes *plain, glint_remarks *remarks,
                              glint_error *err);

#endif
