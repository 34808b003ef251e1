/* Polygons into triangles, by assimp. */
#ifndef GLINT_SIM_RENDER_TRIANGULATE_H
#define GLINT_SIM_RENDER_TRIANGULATE_H

#include <assimp/scene.h>

/* assimp's step, which cuts polygons in single precision, with all coordinates centred and scaled:
 * an object is cut in the same way whatever its size. They are restored afterwards. NULL when out
 * of memory; the scene is then lost. */
const struct aiScene *glint_triangulate(const struct aiScene *scene);

#endif
