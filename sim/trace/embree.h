/* Embree 3, the ray tracer that finds what a ray hits. Its library is opened when it is first used,
 * so that a command that traces nothing neither needs it nor waits for it. */
#ifndef GLINT_SIM_TRACE_EMBREE_H
#define GLINT_SIM_TRACE_EMBREE_H

#include <embree3/rtcore.h>

#include "glint_status.h"

#define GLINT_EMBREE_FUNCTIONS(X)                                                                  \
    X(rtcNewDevice)                                                                                \
    X(rtcReleaseDevice)                                                                            \
    X(rtcGetDeviceError)                                                                           \
    X(rtcNewScene)                                                                                 \
    X(rtcReleaseScene)                                                                             \
    X(rtcSetSceneFlags)                                                                            \
    X(rtcSetSceneProgressMonitorFunction)                                                          \
    X(rtcCommitScene)                                                                              \
    X(rtcNewGeometry)                                                                              \
    X(rtcReleaseGeometry)                                                                          \
    X(rtcSetNewGeometryBuffer)                                                                     \
    X(rtcSetGeometryIntersectFilterFunction)                                                       \
    X(rtcCommitGeometry)                                                                           \
    X(rtcAttachGeometry)                                                                           \
    X(rtcIntersect1)                                                                               \
    X(rtcOccluded1)

/* Its functions by their own names: embree->rtcNewScene(device). */
typedef struct glint_embree {
#define GLINT_EMBREE_FIELD(name) __typeof__(name) *name;
    GLINT_EMBREE_FUNCTIONS(GLINT_EMBREE_FIELD)
#undef GLINT_EMBREE_FIELD
} glint_embree;

/* GLINT_IO_ERROR says what to install. Not for two threads at once. */
glint_status glint_embree_open(const glint_embree **embree, glint_error *err);

#endif
