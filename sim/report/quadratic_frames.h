/* Spheres of few and of many triangles by Gouraud's and by quadratic shading, against Phong's; and
 * what the slips of the thesis's listing do to the latter (appendix A; docs/quadratic-span.md). */
#ifndef GLINT_SIM_REPORT_QUADRATIC_FRAMES_H
#define GLINT_SIM_REPORT_QUADRATIC_FRAMES_H

#include "report/chapter.h"

/* Puts divider.quadratic.…: for each density the NMSE of both against Phong's frame, all by the C
 * model; pixels by the Verilog of the span unit that differ; the NMSE of each slip alone. Writes
 * quadratic-gouraud.png, quadratic.png and quadratic-phong.png of the sphere whose highlight lies
 * in two triangles. */
glint_status glint_quadratic_measure_frames(glint_report *report, glint_error *err);

#endif
