/* libglint: the bit-exact fixed-point models of all circuits. Include this one.
 *
 *   glint_formats.h           widths, binary points, latencies of the specular device
 *   glint_specular.h          the specular device as a pure function, one point or many
 *   glint_specular_device.h   the same clock by clock, every register visible
 *   glint_power.h             the power device, accurate against the power, as a pure function
 *   glint_unit.h              highlight units clock by clock, the power device among them
 *   glint_divider.h           the shift-accumulate divider as a pure function
 *   glint_divider_device.h    the same clock by clock, in its two forms
 *   glint_quadratic_span.h    the span unit of quadratic interpolation, as a function and clock by
 *                             clock
 *   glint_signal.h            a signal, described for comparison and waveforms
 *   glint_status.h            what functions that can fail return */
#ifndef GLINT_CMODEL_GLINT_H
#define GLINT_CMODEL_GLINT_H

#include "glint_divider.h"
#include "glint_divider_device.h"
#include "glint_formats.h"
#include "glint_power.h"
#include "glint_quadratic_span.h"
#include "glint_signal.h"
#include "glint_specular.h"
#include "glint_specular_device.h"
#include "glint_status.h"
#include "glint_unit.h"

#endif
