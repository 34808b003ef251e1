/* The coefficients of a component; see quadratic.h. */
#include "render/quadratic.h"

const int glint_edge_ends[3][2] = {{0, 1}, {0, 2}, {1, 2}};

glint_quadratic glint_quadratic_of(const double corner[3], const double middle[3])
{
    return (glint_quadratic){
        .i1 = corner[0],
        .c2 = 4.0 * middle[0] - 3.0 * corner[0] - corner[1],
        .c3 = 4.0 * middle[1] - 3.0 * corner[0] - corner[2],
        .c12 = corner[0] + corner[1] - 2.0 * middle[0],
        .c13 = corner[0] + corner[2] - 2.0 * middle[1],
        .c23 = 4.0 * (corner[0] - middle[0] - middle[1] + middle[2]),
    };
}

glint_quadratic glint_quadratic_of_triangle(const glint_triangle *t, int component)
{
    double corner[3], middle[3];
    for (int i = 0; i < 3; i++) {
        corner[i] = t->color[i][component];
        middle[i] = t->middle[i][component];
    }
    return glint_quadratic_of(corner, middle);
}
