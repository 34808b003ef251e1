/* Shaders as arrays of lines: the Makefile makes NAME.inc of each file of sim/shader. */
#include "gl/texts.h"

#include <stddef.h>

static const char *const model_lambert[] = {
#include "sim/shader/lambert.glsl.inc"
    NULL};

static const char *const model_phong[] = {
#include "sim/shader/phong.glsl.inc"
    NULL};

static const char *const model_blinn[] = {
#include "sim/shader/blinn.glsl.inc"
    NULL};

static const char *const model_blinn_normalized[] = {
#include "sim/shader/blinn-normalized.glsl.inc"
    NULL};

static const char *const model_torrance_sparrow[] = {
#include "sim/shader/torrance-sparrow.glsl.inc"
    NULL};

static const char *const model_cook_torrance[] = {
#include "sim/shader/cook-torrance.glsl.inc"
    NULL};

static const char *const model_schlick[] = {
#include "sim/shader/schlick.glsl.inc"
    NULL};

static const char *const model_schlick_modified[] = {
#include "sim/shader/schlick-modified.glsl.inc"
    NULL};

static const char *const model_schlick_modified_angle[] = {
#include "sim/shader/schlick-modified-angle.glsl.inc"
    NULL};

static const char *const model_schlick_modified_linear[] = {
#include "sim/shader/schlick-modified-linear.glsl.inc"
    NULL};

static const char *const model_schlick_modified_squared[] = {
#include "sim/shader/schlick-modified-squared.glsl.inc"
    NULL};

static const char *const model_schlick_modified_power[] = {
#include "sim/shader/schlick-modified-power.glsl.inc"
    NULL};

static const char *const model_quadratic[] = {
#include "sim/shader/quadratic.glsl.inc"
    NULL};

static const char *const model_cosine_quadratic[] = {
#include "sim/shader/cosine-quadratic.glsl.inc"
    NULL};

static const char *const model_energy_conserving[] = {
#include "sim/shader/energy-conserving.glsl.inc"
    NULL};

static const char *const model_lyon_2_minimax[] = {
#include "sim/shader/lyon-2-minimax.glsl.inc"
    NULL};

static const char *const model_lyon_4[] = {
#include "sim/shader/lyon-4.glsl.inc"
    NULL};

static const char *const model_lyon_4_minimax[] = {
#include "sim/shader/lyon-4-minimax.glsl.inc"
    NULL};

static const char *const model_lyon_8[] = {
#include "sim/shader/lyon-8.glsl.inc"
    NULL};

static const char *const model_lyon_8_minimax[] = {
#include "sim/shader/lyon-8-minimax.glsl.inc"
    NULL};

static const char *const model_lyon_16[] = {
#include "sim/shader/lyon-16.glsl.inc"
    NULL};

static const char *const model_lyon_16_minimax[] = {
#include "sim/shader/lyon-16-minimax.glsl.inc"
    NULL};

static const char *const model_log2_n[] = {
#include "sim/shader/log2-n.glsl.inc"
    NULL};

static const char *const model_device[] = {
#include "sim/shader/device.glsl.inc"
    NULL};

const char *const *const glint_shader_models[] = {
#define MODEL(id, definition, name) [GLINT_REFLECTANCE_##id] = model_##definition,
    GLINT_REFLECTANCE_MODELS(MODEL)
#undef MODEL
};

const char *const glint_shader_surface[] = {
#include "sim/shader/surface.glsl.inc"
    NULL};

const char *const glint_shader_light[] = {
#include "sim/shader/light.glsl.inc"
    NULL};

const char *const glint_shader_camera[] = {
#include "sim/shader/camera.glsl.inc"
    NULL};

const char *const glint_shader_frame[] = {
#include "sim/shader/frame.glsl.inc"
    NULL};

const char *const glint_shader_phong_vert[] = {
#include "sim/shader/phong.vert.inc"
    NULL};

const char *const glint_shader_phong_frag[] = {
#include "sim/shader/phong.frag.inc"
    NULL};

const char *const glint_shader_gouraud_vert[] = {
#include "sim/shader/gouraud.vert.inc"
    NULL};

const char *const glint_shader_gouraud_frag[] = {
#include "sim/shader/gouraud.frag.inc"
    NULL};

const char *const glint_shader_flat_vert[] = {
#include "sim/shader/flat.vert.inc"
    NULL};

const char *const glint_shader_flat_geom[] = {
#include "sim/shader/flat.geom.inc"
    NULL};

const char *const glint_shader_flat_frag[] = {
#include "sim/shader/flat.frag.inc"
    NULL};

const char *const glint_shader_gold_vert[] = {
#include "sim/shader/gold.vert.inc"
    NULL};

const char *const glint_shader_gold_frag[] = {
#include "sim/shader/gold.frag.inc"
    NULL};
