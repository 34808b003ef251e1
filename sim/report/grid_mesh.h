/* A lattice of thin bars: what pixel segments lose. */
#ifndef GLINT_SIM_REPORT_GRID_MESH_H
#define GLINT_SIM_REPORT_GRID_MESH_H

#include "render/mesh.h"

/* So many bars in each direction across a square of side 2; a bar's width is that share of the
 * distance between two. Each bar has four flat sides and no ends. */
glint_status glint_grid_mesh(int bars, double width, glint_mesh **mesh, glint_error *err);

#endif
