/* Files as arrays of lines: the Makefile makes NAME.inc of each. */
#include "report/texts.h"

#include <stddef.h>

const char *const glint_text_head[] = {
#include "sim/report/text/head.md.inc"
    NULL};

const char *const glint_text_summary[] = {
#include "sim/report/text/summary.md.inc"
    NULL};

const char *const glint_text_claims[] = {
#include "sim/report/text/claims.md.inc"
    NULL};

const char *const glint_text_device[] = {
#include "sim/report/text/device.md.inc"
    NULL};

const char *const glint_text_lobes[] = {
#include "sim/report/text/lobes.md.inc"
    NULL};

const char *const glint_text_divider[] = {
#include "sim/report/text/divider.md.inc"
    NULL};

const char *const glint_text_energy[] = {
#include "sim/report/text/energy.md.inc"
    NULL};

const char *const glint_text_frames[] = {
#include "sim/report/text/frames.md.inc"
    NULL};

const char *const glint_text_rasterizers[] = {
#include "sim/report/text/rasterizers.md.inc"
    NULL};

const char *const glint_text_speed[] = {
#include "sim/report/text/speed.md.inc"
    NULL};

const char *const glint_text_units[] = {
#include "sim/report/text/units.md.inc"
    NULL};

const char *const glint_text_compare[] = {
#include "docs/compare.csv.inc"
    NULL};

const char *const glint_text_trace[] = {
#include "sim/report/text/trace.md.inc"
    NULL};

const char *const glint_drawing_device_drawn[] = {
#include "docs/images/specular-drawn.svg.inc"
    NULL};

const char *const glint_drawing_device[] = {
#include "docs/images/specular.svg.inc"
    NULL};

const char *const glint_drawing_divider[] = {
#include "docs/images/divider-sequential.svg.inc"
    NULL};
