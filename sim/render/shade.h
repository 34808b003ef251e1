/* Deferred Phong shading of one band of rows: visible pixels become fragments, their cosines go to
 * the backend in one run, and the highlights are added to ambient and Lambert light in the
 * picture. */
#ifndef GLINT_SIM_RENDER_SHADE_H
#define GLINT_SIM_RENDER_SHADE_H

#include "reflectance/reflectance.h"
#include "render/camera.h"
#include "render/raster.h"
#include "render/scene.h"

/* Where the cosines of a fragment come from (approximate.h). */
typedef enum glint_cosines {
    GLINT_COSINES_EXACT,        /* of the interpolated normal, normalised */
    GLINT_COSINES_UNNORMALISED, /* of the interpolated normal as it is */
    GLINT_COSINES_NEWTON,       /* of that after one step towards unit length */
    GLINT_COSINES_LINEAR        /* themselves interpolated */
} glint_cosines;

/* What all fragments of a frame have in common. */
typedef struct glint_lighting {
    float light[3];                    /* L, unit length, camera axes */
    float ambient[3];                  /* C·Ka·Ia */
    float lambert[3];                  /* C·Kd·Ie */
    float inv_focal;                   /* 1 / distance of the frame from the eye in pixels */
    float half_width, half_height;     /* of the frame in pixels */
    glint_material material;           /* of the highlight */
    const glint_reflectance *specular; /* the model for the highlights; NULL: the backend */
    glint_cosines cosines;             /* [exact] */
} glint_lighting;

/* specular may be NULL; it must outlive the lighting. */
glint_lighting glint_lighting_of(const glint_scene *scene, const glint_camera *camera,
                                 const glint_reflectance *specular);

/* Rounded half up and saturated; value ≥ 0. */
static inline uint8_t glint_intensity_of(float value)
{
    const int32_t rounded = (int32_t)(value + 0.5f);
    return (uint8_t)(rounded < 255 ? rounded : 255);
}

_Static_assert(GLINT_COS_BITS + 1 <= 24, "a float holds a code of the cosine and its half");

/* The code of a cosine, rounded half up and clamped to 0 … 1. */
static inline uint32_t glint_cos_code_of(float cosine)
{
    const int32_t code = (int32_t)(cosine * (float)GLINT_COS_ONE + 0.5f);
    const int32_t above = code > 0 ? code : 0;
    const int32_t one = (int32_t)GLINT_COS_ONE;
    return (uint32_t)(above < one ? above : one);
}

/* The model's replacement for W at a lit point. */
double glint_specular_value(const glint_reflectance *specular, const glint_geometry *geometry);

/* One component of the highlights: value ≥ 0 times the component of the material, rounded half up
 * and saturated. */
void glint_specular_color(size_t count, const float *restrict value, uint8_t component,
                          uint8_t *restrict highlight);

/* base + highlight where lit (255, else 0), saturated to 8 bits. */
void glint_add_highlight(size_t count, const uint8_t *restrict highlight,
                         const uint8_t *restrict lit, uint8_t *restrict base);

/* The fragments of a frame as they went to the backend. Those of a band lie together, from the
 * place of the band's first pixel on, row after row and each row from left to right. */
typedef struct glint_record {
    uint32_t *cos_code; /* width·height */
    uint16_t *x;        /* width·height */
    uint32_t *in_row;   /* fragments of each row */
} glint_record;

/* N·L, N·V, N·H and V·H; a lobe has the first for its one cosine. */
#define GLINT_SHADER_COSINES 4

/* One thread's room for the fragments of a band. */
typedef struct glint_shader {
    float *n[3];                         /* of one row: the interpolated normals, any length */
    uint8_t *base[3];                    /* of the band: ambient and Lambert light, then the sum */
    uint8_t *highlight[3];               /* from the backend or the model */
    uint8_t *lit;                        /* 255 where the surface faces the light, else 0 */
    float *cosine[GLINT_SHADER_COSINES]; /* of one row, for a model */
    float *value;                        /* of one row, by a model */
    uint32_t *entry;                     /* of one row, of the reflection map */
} glint_shader;

/* Room for bands of that width; false when there is no memory (destroy is still due). */
bool glint_shader_create(glint_shader *shader, int32_t width);
void glint_shader_destroy(glint_shader *shader);

/* Collects the fragments of one row: columns and normals. Returns how many there are. */
size_t glint_shader_gather(glint_shader *shader, const glint_visibility *band, int32_t y,
                           int32_t width, uint16_t *columns);

/* The fragments first … first + count − 1 of the band into row y of the image. */
void glint_shader_write(const glint_shader *shader, const uint16_t *columns, size_t first,
                        size_t count, glint_image *image, int32_t y);

/* Shades the band into the image, whose rows are empty; *fragments is how many there were. */
glint_status glint_shade_band(glint_shader *shader, const glint_lighting *lighting,
                              const glint_visibility *band, glint_backend *backend,
                              glint_record *record, glint_image *image, uint64_t *fragments,
                              glint_error *err);

#endif
