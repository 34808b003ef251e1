/* The writers behind convert.h. Each fills the summary but for its format. */
#ifndef GLINT_SIM_CONVERT_FORMATS_H
#define GLINT_SIM_CONVERT_FORMATS_H

#include <stdio.h>

#include "convert/convert.h"

/* Most vertices, and most triangles, of one object of a .3ds file: its counts have 16 bits. */
#define GLINT_3DS_MAX 65535

/* .3ds: vertices of one place merged, smoothing groups from the normals, split into objects of at
 * most `most` (3…GLINT_3DS_MAX) vertices and triangles. Its z axis points up, so the mesh's y
 * becomes z. Write errors are left in the stream. */
glint_status glint_write_3ds(const glint_mesh *mesh, size_t most, FILE *out,
                             const volatile bool *stop, glint_converted *converted,
                             glint_error *err);

/* By assimp's exporter of that name. */
glint_status glint_write_by_assimp(const glint_mesh *mesh, const char *exporter, FILE *out,
                                   glint_converted *converted, glint_error *err);

#endif
