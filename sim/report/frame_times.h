/* How long a frame takes with each formula and with the device: figure 3.13. */
#ifndef GLINT_SIM_REPORT_FRAME_TIMES_H
#define GLINT_SIM_REPORT_FRAME_TIMES_H

#include "report/frame_errors.h"

/* Puts the numbers frames.time.… and draws figure 3.13, one for each test figure. The same frames
 * with --quick, but fewer. */
glint_status glint_frame_times_measure(glint_report *report, glint_error *err);

#endif
