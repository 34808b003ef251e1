/* Solids for tests of mesh files, and their expected normals, computed independently: every corner
 * checks every triangle, with angles in degrees. Include it after cmocka.h. */
#ifndef GLINT_TESTS_RENDER_SOLIDS_H
#define GLINT_TESTS_RENDER_SOLIDS_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include "render/mesh_build.h"

#define SOLID_VERTICES_MAX  1024
#define SOLID_TRIANGLES_MAX 2048

typedef struct solid {
    size_t vertices, triangles;
    double at[SOLID_VERTICES_MAX][3];
    uint32_t corner[SOLID_TRIANGLES_MAX][3];
    uint32_t group[SOLID_TRIANGLES_MAX]; /* of smoothing, for rules that know them */
} solid;

static inline void solid_vertex(solid *s, double x, double y, double z)
{
    assert_true(s->vertices < SOLID_VERTICES_MAX);
    s->at[s->vertices][0] = x;
    s->at[s->vertices][1] = y;
    s->at[s->vertices++][2] = z;
}

static inline void solid_triangle(solid *s, uint32_t a, uint32_t b, uint32_t c)
{
    assert_true(s->triangles < SOLID_TRIANGLES_MAX);
    s->corner[s->triangles][0] = a;
    s->corner[s->triangles][1] = b;
    s->corner[s->triangles++][2] = c;
}

/* 8 vertices, 12 triangles; the two of each side after one another. */
static inline void solid_cube(solid *s)
{
    static const uint32_t side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                        {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    *s = (solid){.vertices = 0};
    for (int i = 0; i < 8; i++)
        solid_vertex(s, i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
    for (int i = 0; i < 6; i++) {
        solid_triangle(s, side[i][0], side[i][1], side[i][2]);
        solid_triangle(s, side[i][0], side[i][2], side[i][3]);
    }
}

/* A multiple of 1/1024: any format can say it, and any reader read it, without an error. */
static inline double solid_round(double v)
{
    return floor(v * 1024.0 + 0.5) / 1024.0;
}

/* A sphere of `around` by around/2 quads whose radii are 1 − rough … 1. */
static inline void solid_ball(solid *s, uint32_t around, double rough)
{
    const double pi = 3.14159265358979323846;
    const uint32_t rows = around / 2;
    uint32_t seed = 1;
    *s = (solid){.vertices = 0};
    solid_vertex(s, 0.0, 1.0, 0.0);
    for (uint32_t j = 1; j < rows; j++) {
        for (uint32_t i = 0; i < around; i++) {
            seed = seed * 1664525u + 1013904223u;
            const double r = 1.0 - rough * (double)(seed >> 8) / 16777216.0;
            const double t = pi * j / rows, p = 2.0 * pi * i / around;
            solid_vertex(s, solid_round(r * sin(t) * cos(p)), solid_round(r * cos(t)),
                         solid_round(-r * sin(t) * sin(p)));
        }
    }
    solid_vertex(s, 0.0, -1.0, 0.0);
    for (uint32_t i = 0; i < around; i++) {
        const uint32_t next = (i + 1) % around;
        solid_triangle(s, 0, 1 + i, 1 + next);
        for (uint32_t j = 0; j + 2 < rows; j++) {
            const uint32_t high = 1 + j * around, low = high + around;
            solid_triangle(s, high + i, low + i, low + next);
            solid_triangle(s, high + i, low + next, high + next);
        }
        const uint32_t last = 1 + (rows - 2) * around;
        solid_triangle(s, (uint32_t)s->vertices - 1, last + next, last + i);
    }
}

/* The triangles in another order, each of them with another corner first. */
static inline void solid_shuffle(solid *s)
{
    uint32_t seed = 7;
    for (size_t i = s->triangles; i > 1; i--) {
        seed = seed * 1664525u + 1013904223u;
        const size_t k = (size_t)(seed >> 8) % i;
        for (size_t c = 0; c < 3; c++) {
            const uint32_t kept = s->corner[i - 1][c];
            s->corner[i - 1][c] = s->corner[k][c];
            s->corner[k][c] = kept;
        }
        const uint32_t first = s->corner[i - 1][0];
        s->corner[i - 1][0] = s->corner[i - 1][1];
        s->corner[i - 1][1] = s->corner[i - 1][2];
        s->corner[i - 1][2] = first;
    }
}

typedef enum solid_rule { SOLID_CREASED, SOLID_FLAT, SOLID_GROUPED } solid_rule;

static inline glint_vec3 solid_at(const solid *s, size_t triangle, size_t corner)
{
    const double *p = s->at[s->corner[triangle][corner % 3]];
    return (glint_vec3){p[0], p[1], p[2]};
}

static inline double solid_degrees(glint_vec3 a, glint_vec3 b)
{
    const double c = glint_vec3_dot(a, b) / (glint_vec3_length(a) * glint_vec3_length(b));
    return acos(fmax(-1.0, fmin(1.0, c))) * 180.0 / 3.14159265358979323846;
}

static inline glint_vec3 solid_plane(const solid *s, size_t triangle)
{
    const glint_vec3 a = solid_at(s, triangle, 0);
    const glint_vec3 n = glint_vec3_cross(glint_vec3_sub(solid_at(s, triangle, 1), a),
                                          glint_vec3_sub(solid_at(s, triangle, 2), a));
    return glint_vec3_scale(n, 1.0 / glint_vec3_length(n));
}

static inline bool solid_smooth(const solid *s, size_t a, size_t b, solid_rule rule)
{
    return a == b || (rule == SOLID_GROUPED && (s->group[a] & s->group[b]) != 0) ||
           (rule == SOLID_CREASED && solid_degrees(solid_plane(s, a), solid_plane(s, b)) < 66.0);
}

/* The normal of one corner. */
static inline glint_vec3 solid_normal(const solid *s, size_t triangle, size_t corner,
                                      solid_rule rule)
{
    const uint32_t vertex = s->corner[triangle][corner];
    glint_vec3 sum = {0.0, 0.0, 0.0};
    for (size_t i = 0; i < s->triangles; i++) {
        for (size_t k = 0; k < 3; k++) {
            if (s->corner[i][k] == vertex && solid_smooth(s, triangle, i, rule)) {
                const glint_vec3 p = solid_at(s, i, k);
                const double angle = solid_degrees(glint_vec3_sub(solid_at(s, i, k + 1), p),
                                                   glint_vec3_sub(solid_at(s, i, k + 2), p));
                sum = glint_vec3_add(sum, glint_vec3_scale(solid_plane(s, i), angle));
            }
        }
    }
    return glint_vec3_scale(sum, 1.0 / glint_vec3_length(sum));
}

/* The expected mesh for a file of the solid. */
static inline glint_mesh *solid_mesh(const solid *s, solid_rule rule)
{
    glint_mesh *mesh = NULL;
    assert_int_equal(glint_mesh_new("solid", 3 * s->triangles, s->triangles, &mesh, NULL),
                     GLINT_OK);
    for (size_t i = 0; i < s->triangles; i++) {
        for (size_t k = 0; k < 3; k++)
            glint_mesh_add_vertex(mesh, solid_at(s, i, k), solid_normal(s, i, k, rule));
        const uint32_t first = (uint32_t)(3 * i);
        glint_mesh_add_triangle(mesh, first, first + 1, first + 2);
    }
    return mesh;
}

#endif
