/* Vectors of three doubles, for the work that is done once a frame or once a mesh. */
#ifndef GLINT_SIM_REFLECTANCE_VEC3_H
#define GLINT_SIM_REFLECTANCE_VEC3_H

#include <math.h>

typedef struct glint_vec3 {
    double x, y, z;
} glint_vec3;

static inline glint_vec3 glint_vec3_of(const float v[3])
{
    return (glint_vec3){(double)v[0], (double)v[1], (double)v[2]};
}

static inline void glint_vec3_store(glint_vec3 a, float v[3])
{
    v[0] = (float)a.x;
    v[1] = (float)a.y;
    v[2] = (float)a.z;
}

static inline glint_vec3 glint_vec3_add(glint_vec3 a, glint_vec3 b)
{
    return (glint_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline glint_vec3 glint_vec3_sub(glint_vec3 a, glint_vec3 b)
{
    return (glint_vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline glint_vec3 glint_vec3_scale(glint_vec3 a, double k)
{
    return (glint_vec3){a.x * k, a.y * k, a.z * k};
}

static inline double glint_vec3_dot(glint_vec3 a, glint_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline glint_vec3 glint_vec3_cross(glint_vec3 a, glint_vec3 b)
{
    return (glint_vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline double glint_vec3_length(glint_vec3 a)
{
    return sqrt(glint_vec3_dot(a, a));
}

#endif
