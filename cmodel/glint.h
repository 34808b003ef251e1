/* libglint: the bit-exact fixed-point model of the specular-colour device. Include this one.
 *
 *   glint_formats.h           widths, binary points, latencies
 *   glint_specular.h          the circuit as a pure function, one point or many
 *   glint_specular_device.h   the circuit clock by clock, every register visible
 *   glint_status.h            what functions that can fail return */
#ifndef GLINT_H
#define GLINT_H

#include "glint_formats.h"
#include "glint_specular.h"
#include "glint_specular_device.h"
#include "glint_status.h"

#endif
