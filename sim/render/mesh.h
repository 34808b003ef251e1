/* Triangle meshes: the built-in teapot, sphere and quad, and files through assimp. */
#ifndef GLINT_SIM_RENDER_MESH_H
#define GLINT_SIM_RENDER_MESH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "glint_status.h"

#define GLINT_MESH_REMARKS 256

/* Of the object itself (transform.h). */
typedef struct glint_transform {
    double scale[3];  /* along its axes, not 0 */
    double rotate[3]; /* about x, y, z, degrees, anticlockwise seen from the axis's tip */
    double move[3];   /* in radii of its bounding sphere */
} glint_transform;

typedef struct glint_mesh {
    size_t vertex_count;
    float *position; /* vertex_count × 3, finite */
    float *normal;   /* vertex_count × 3, unit length */
    size_t triangle_count;
    uint32_t *index; /* triangle_count × 3, each < vertex_count, counter-clockwise from outside */
    float *rest; /* of a transformed mesh: its positions before, by which the camera is placed */
    glint_transform transform;        /* with rest: the last one */
    char remarks[GLINT_MESH_REMARKS]; /* what was left out of its file: one line, or "" */
} glint_mesh;

void glint_mesh_destroy(glint_mesh *mesh); /* NULL is allowed */

/* Densities at which the outline is within half a pixel of the true one at 1920×1080 without
 * hurting the frame rate: 25,440 and 16,128 triangles. */
#define GLINT_TEAPOT_DENSITY 20
#define GLINT_SPHERE_DENSITY 128

#define GLINT_TEAPOT_DENSITY_MAX 256
#define GLINT_SPHERE_DENSITY_MAX 4096

/* The Newell teapot from its 32 bicubic patches (306 control points), each patch divided into
 * density × density quads (1…256): 64·density² − 8·density triangles. y is up, the spout points
 * along +x, the foot stands on y = 0. Normals are exact, from the partial derivatives of the patch,
 * and their limit at the degenerate points of lid and bottom; triangles of zero area at those
 * points are left out. */
glint_status glint_mesh_teapot(int density, glint_mesh **mesh, glint_error *err);

/* Unit sphere about the origin of density meridian quads by density/2 parallels (density 4…4096,
 * even): density·(density − 2) triangles. The poles are on the y axis. */
glint_status glint_mesh_sphere(int density, glint_mesh **mesh, glint_error *err);

/* A long rectangle on the ground, of two triangles, that recedes from the default camera: from z =
 * 8 back to z = −8. Its normals lean differently at its four corners, so that the light falls on
 * them very differently. It shows how screen-space Gouraud shading distorts perspective. */
glint_status glint_mesh_quad(glint_mesh **mesh, glint_error *err);

/* More triangles than this are rejected outright: 5 million from an .stl take 1.0 GB. */
#define GLINT_MESH_TRIANGLES_MAX ((size_t)32 << 20)

/* Reads a mesh file through assimp (.3ds .obj .ply .stl …): all meshes under their node transforms,
 * triangulated. The whole is centred on the origin and scaled so that half its largest extent is 1.
 * Whatever is left out is listed in the mesh's remarks: points, lines, curves, meshes that no node
 * uses, unsupported statements, elements and extensions. Anything essential that is unsupported is
 * an error.
 *
 * Normals are the file's, normalised. Where it has none, or 0 0 0 or NaN, a corner gets the mean of
 * the triangles around its position that lie within 66 degrees of its own: smooth except at sharp
 * edges, independent of the format, the order of triangles and the sharing of vertices. Exceptions
 * are .stl (the facet's own) and glTF meshes without normals (flat, as its specification says). In
 * .3ds and .ase files smoothing groups apply: triangles sharing a group are smooth across any
 * angle, and one in no group is flat.
 *
 * GLINT_IO_ERROR for a path that cannot be read; GLINT_BAD_INPUT for a file that is not a mesh, has
 * no triangles or more than 32 million, has a coordinate that is NaN or beyond 1e18 or an invalid
 * vertex index, or lies too far from the origin for single precision.
 *
 * assimp runs in a separate process, with time and memory limits based on the file's size: if it
 * crashes or does not finish, the result is GLINT_BAD_INPUT or GLINT_NO_MEMORY. GLINT_INTERRUPTED
 * soon after *stop becomes true; stop may be NULL. The process is created with fork(), so no other
 * thread of the caller may be active meanwhile; a renderer's threads are idle between frames. */
glint_status glint_mesh_load(const char *path, const volatile bool *stop, glint_mesh **mesh,
                             glint_error *err);

#endif
