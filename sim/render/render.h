/* The software rasterizer: a mesh, a camera and a light become fragments; a backend computes each
 * one's highlight; the result is a picture, identical for any number of threads
 * (docs/frames.md). */
#ifndef GLINT_SIM_RENDER_RENDER_H
#define GLINT_SIM_RENDER_RENDER_H

#include <stdbool.h>
#include <stdint.h>

#include "backend/backend.h"
#include "image/image.h"
#include "reflectance/reflectance.h"
#include "render/mesh.h"
#include "render/span.h"

/* Limits of a scene and of a renderer. */
#define GLINT_ANGLE_MAX    36000.0f /* of yaw and pitch, degrees either way */
#define GLINT_FOV_MIN      1.0f
#define GLINT_FOV_MAX      170.0f
#define GLINT_DISTANCE_MAX 1000.0f
#define GLINT_THREADS_MAX  64

/* Where the formula below is evaluated, and how colours are interpolated in between
 * (docs/frames.md). */
typedef enum glint_shading {
    GLINT_SHADING_FLAT,                /* once for each triangle */
    GLINT_SHADING_GOURAUD,             /* at vertices; between them by the divider, on the screen */
    GLINT_SHADING_GOURAUD_PERSPECTIVE, /* at vertices; between them on the object */
    GLINT_SHADING_QUADRATIC,           /* at six points of each triangle; a quadratic between */
    GLINT_SHADING_QUADRATIC_LISTING,   /* the same as the thesis's listing has it (listing.h) */
    GLINT_SHADING_PHONG,               /* for each pixel, with the interpolated normal */
    GLINT_SHADING_MIXED,         /* gouraud in triangles without a highlight, phong in others */
    GLINT_SHADING_GOURAUD_4,     /* gouraud in four quarters of each triangle (split.h) */
    GLINT_SHADING_COSINE_LINEAR, /* phong, N·L and N·H interpolated (approximate.h) */
    GLINT_SHADING_PHONG_UNNORMALISED, /* phong, the interpolated normal not normalised */
    GLINT_SHADING_PHONG_NEWTON,       /* phong, that after one of Newton's steps */
    GLINT_SHADING_REFLECTION_MAP,     /* looked up in a table over normals (reflection_map.h) */
    GLINT_SHADING_WIRES,              /* nowhere: the triangulation (show.h) */
    GLINT_SHADING_NORMALS,            /* nowhere: normals as colours; both with backend real only */
    GLINT_SHADING_COUNT
} glint_shading;

/* In the order of the enum; ends with NULL. */
extern const char *const glint_shading_names[];

#define GLINT_DELTA_MAX 255

/* In place of a number of shifts: values are exact and rounded half up, without the divider. */
#define GLINT_SHIFTS_EXACT 0

/* I = C·(Ka·Ia + Kd·Ie·(N·L)) + Ie·Ks·W(N·H)·S : ambient, Lambert (1.2) and the device's highlight.
 * Where N·L ≤ 0 both of the latter are 0. In brackets: what glint_scene_defaults() sets. */
typedef struct glint_scene {
    const glint_mesh *mesh;
    float light[3];       /* direction from the object to the light (at infinity), any length > 0,
                             in camera axes: x right, y up, z towards the viewer [-1, 1.2, 1.6] */
    uint8_t color[3];     /* C, the object's colour [200, 90, 40] */
    uint8_t highlight[3]; /* S, the highlight's colour [255, 255, 255] */
    float ia[3], ie[3];   /* R, G, B of the ambient light and of the source, 0…1 [1, 1] */
    float ka, kd, ks;     /* 0…1 [0.2, 0.8, 0.8] */
    double n;             /* exponent, 0…1023, a whole number unless by_model [80] */
    float yaw, pitch;     /* the camera's place around the object, degrees: yaw turns it from the +z
                             axis towards +x, pitch lifts it towards +y [25, 22] */
    float fov;            /* vertical field of view, degrees, 1…170 [35] */
    float distance; /* distance of the camera from the object's centre, in multiples of the radius
                     * of its bounding sphere (about the centre of its bounding box), up to 1000; it
                     * may stand inside. 0: the object fills the frame, its projection centred and 2
                     * % short of two opposite sides [0] */
    glint_shading shading; /* [phong] */
    int shifts; /* of the divider, for Gouraud's shading on the screen: GLINT_DIVIDER_SHIFTS_MIN…
                   MAX or GLINT_SHIFTS_EXACT. Backend real is always exact. [default] */
    int fraction;   /* bits of the span unit's numbers, for quadratic shading: GLINT_QUADRATIC_SPAN_
                       FRACTION_MIN…MAX or GLINT_FRACTION_EXACT. Backend real is always exact.
                       [default] */
    unsigned slips; /* of the listing, for its shading: a mask of glint_slip [GLINT_SLIPS_ALL] */
    int delta;      /* for mixed: a highlight of so many levels counts as none, 0…255 [0] */
    int map_size;   /* of the reflection map, 2…1024 entries each way [256] */
    bool isc;      /* for phong: the highlight is not computed in triangles that have none, with the
                      same picture; the thesis's ISC as read in sheen.h [false] */
    bool by_model; /* W by a reflectance model from cosines that no code rounds, instead of the
                      device's; backend real only [false] */
    glint_reflectance_model specular; /* that model, n its exponent; what replaces W(N·H) is a
                                         lobe's value or Rs (1.4). Lambert's: no highlight */
    float f0; /* of the microfacet models: F at normal incidence, 0…1 [GLINT_F0_DEFAULT] */
} glint_scene;

/* Sets everything but the mesh to the defaults in brackets above. */
void glint_scene_defaults(glint_scene *scene);

/* The circuit that the scene's shading needs besides the device: Gouraud's divider, the span unit.
 * false: none. */
bool glint_scene_circuit(const glint_scene *scene, glint_setting *setting);

/* GLINT_BAD_ARGUMENT for an n that the model or the scene does not accept. */
glint_status glint_scene_check_exponent(glint_reflectance_model model, double n, glint_error *err);

typedef struct glint_render_stats {
    uint64_t triangles;      /* of the mesh */
    uint64_t drawn;          /* of these: left after culling and clipping, in whole or in parts, and
                                spanning a pixel's centre */
    uint64_t fragments;      /* visible pixels of the object */
    uint64_t highlights;     /* points whose highlight was computed: with Phong's shading fragments,
                                with flat shading triangles, with the quadratic ones six for each
                                triangle drawn or part of one that was clipped, else vertices */
    uint64_t sheen;          /* of drawn: those that may have a highlight, with isc or mixed */
    uint64_t divisions;      /* done by the divider, each of three components */
    uint64_t divider_clocks; /* of its circuits; 0 for backends without a clock */
    uint64_t spans, span_clocks;      /* walked by the span unit, and the clocks of its circuits */
    glint_span_operations operations; /* of the span unit */
    double seconds;
    double shading_seconds; /* of the processor for light and colours: the mean of the threads */
} glint_render_stats;

typedef struct glint_renderer glint_renderer;

/* A renderer of width × height frames on `threads` threads (1…64), each with a backend of its own
 * made from config, and a pipelined divider of the same kind when a frame asks for one. */
glint_status glint_renderer_create(int width, int height, int threads,
                                   const glint_backend_config *config, glint_renderer **renderer,
                                   glint_error *err);
void glint_renderer_destroy(glint_renderer *renderer); /* NULL is allowed */

/* glint_backend_set_watch() for all circuits of a renderer; GLINT_BAD_ARGUMENT with more than one
 * thread. */
glint_status glint_renderer_watch(glint_renderer *renderer, glint_backend_watch *watch,
                                  glint_error *err);

/* Called by glint_render() on its own thread from time to time with the number of bands started;
 * NULL: never. */
typedef void glint_render_progress(void *context, uint64_t done, uint64_t total);
void glint_renderer_show(glint_renderer *renderer, glint_render_progress *progress, void *context);

/* Renders one frame into image (of the renderer's size; every pixel is written, the object mask
 * too; the background is 0). stop (may be NULL): when it becomes true, the frame is abandoned with
 * GLINT_INTERRUPTED. GLINT_BAD_ARGUMENT for a scene value out of range, naming it, for n outside
 * the model's domain, or for a model with a backend other than real. */
glint_status glint_render(glint_renderer *renderer, const glint_scene *scene, glint_image *image,
                          const volatile bool *stop, glint_render_stats *stats, glint_error *err);

#endif
