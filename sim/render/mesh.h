/* Triangle meshes: the built-in teapot, sphere and quad, and files through assimp. */
#ifndef GLINT_SIM_RENDER_MESH_H
#define GLINT_SIM_RENDER_MESH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "glint_status.h"

#define GLINT_MESH_REMARKS 256

typedef struct glint_mesh {
    size_t vertex_count;
    float *position; /* vertex_count × 3, finite */
    float *normal;   /* vertex_count × 3, unit length */
    size_t triangle_count;
    uint32_t *index; /* triangle_count × 3, each < vertex_count, counter-clockwise from outside */
    char remarks[GLINT_MESH_REMARKS]; /* what its file has and it has not: one line, or "" */
} glint_mesh;

void glint_mesh_destroy(glint_mesh *mesh); /* NULL is allowed */

/* Densities at which the outline is within half a pixel of the true one at 1920×1080 and the frame
 * rate does not suffer: 25,440 and 16,128 triangles. */
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

/* A long rectangle on the ground, of two triangles, that recedes from the default camera: from
 * z = 8 back to z = −8. Its normals lean differently at its four corners, so that the light falls
 * on them very differently. It shows what Gouraud's shading on the screen does to perspective. */
glint_status glint_mesh_quad(glint_mesh **mesh, glint_error *err);

/* More triangles than this are refused rather than tried: of an .stl, 5 million take 1.0 GB. */
#define GLINT_MESH_TRIANGLES_MAX ((size_t)32 << 20)

/* Reads a mesh file through assimp (.3ds .obj .ply .stl …): all meshes under their node
 * transforms, triangulated. The middle of the whole is moved to the origin, and half its largest
 * extent is 1. What is left out is in the mesh's remarks: points, lines, curves, meshes that no
 * node shows, statements, elements and extensions of a format that are not read. What cannot be
 * left out is refused.
 *
 * Normals are the file's, made as long as 1. Where it has none, or 0 0 0 or what is not a number, a
 * corner gets the mean of the triangles about its place that lie within 66 degrees of its own:
 * smooth but for sharp edges, whatever the format, the order of triangles and the sharing of
 * vertices. Exceptions are .stl (the facet's own) and glTF meshes without normals (flat, as its
 * specification says). Of a .3ds or .ase file the smoothing groups count: triangles that share one
 * are smooth over each other at any angle, one of no group is flat.
 *
 * GLINT_IO_ERROR for a path that cannot be read; GLINT_BAD_INPUT for what is no mesh file, has no
 * triangles, more than 32 million of them, a coordinate that is not a number or beyond 1e18, or an
 * index of a vertex that is not there, and for what lies so far from the origin that single
 * precision cannot hold it.
 *
 * assimp works in a process of its own, with as much time and memory as the size of the file
 * justifies: when it crashes or does not come to an end, that is GLINT_BAD_INPUT too, or
 * GLINT_NO_MEMORY. GLINT_INTERRUPTED soon after *stop becomes true; stop may be NULL. The process
 * is made with fork(): no other thread of the caller's may be at work meanwhile. Those of a
 * renderer are not, between frames. */
glint_status glint_mesh_load(const char *path, const volatile bool *stop, glint_mesh **mesh,
                             glint_error *err);

#endif
