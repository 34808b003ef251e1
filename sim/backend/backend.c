/* The three backends behind one interface. */
#include "backend/backend.h"

#include <math.h>
#include <stdlib.h>

#include "rtl/rtl.h"

struct glint_backend {
    glint_backend_config config;
    glint_rtl *rtl; /* kind rtl only */
};

/* The fastest lane count in the bench. */
#define FAST_LANES 16

static glint_status create_circuit(glint_backend *backend, glint_error *err)
{
    const glint_specular_config config = {backend->config.gate, backend->config.pipeline,
                                          backend->config.lanes != 0 ? backend->config.lanes
                                                                     : FAST_LANES};
    return glint_rtl_create_fast(&config, &backend->rtl, err);
}

glint_status glint_backend_create(const glint_backend_config *config, glint_backend **backend,
                                  glint_error *err)
{
    *backend = NULL;
    if ((unsigned)config->kind >= GLINT_BACKEND_COUNT ||
        (unsigned)config->gate >= GLINT_GATE_COUNT ||
        (unsigned)config->pipeline >= GLINT_PIPELINE_COUNT)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "no such backend, gate or pipeline");
    glint_backend *created = calloc(1, sizeof *created);
    if (created == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for a backend");
    created->config = *config;
    glint_status status =
        config->kind == GLINT_BACKEND_RTL ? create_circuit(created, err) : GLINT_OK;
    if (status != GLINT_OK) {
        free(created);
        return status;
    }
    *backend = created;
    return GLINT_OK;
}

void glint_backend_destroy(glint_backend *backend)
{
    if (backend == NULL)
        return;
    glint_rtl_destroy(backend->rtl);
    free(backend);
}

static uint32_t round_half_up(double value)
{
    return (uint32_t)floor(value + 0.5);
}

static void shade_real(glint_gate gate, const glint_material *material, const uint32_t *cos_code,
                       size_t count, uint32_t *w_code, uint8_t *r, uint8_t *g, uint8_t *b)
{
    for (size_t i = 0; i < count; i++) {
        double w = glint_specular_real(gate, material->n, cos_code[i]);
        if (w_code != NULL)
            w_code[i] = round_half_up(w * GLINT_W_ONE);
        r[i] = (uint8_t)round_half_up(w * material->r);
        g[i] = (uint8_t)round_half_up(w * material->g);
        b[i] = (uint8_t)round_half_up(w * material->b);
    }
}

glint_status glint_backend_shade(glint_backend *backend, const glint_material *material,
                                 const uint32_t *cos_code, size_t count, uint32_t *w_code,
                                 uint8_t *r, uint8_t *g, uint8_t *b, glint_error *err)
{
    const glint_gate gate = backend->config.gate;
    if (material->n > GLINT_N_MAX)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "n = %u is not in 0…%u", material->n,
                          GLINT_N_MAX);
    switch (backend->config.kind) {
    case GLINT_BACKEND_RTL:
        return glint_rtl_batch(backend->rtl, material, cos_code, count, w_code, r, g, b, err);
    case GLINT_BACKEND_REAL:
        shade_real(gate, material, cos_code, count, w_code, r, g, b);
        return GLINT_OK;
    default:
        return glint_specular_batch(gate, material, cos_code, count, w_code, r, g, b);
    }
}

uint64_t glint_backend_clocks(const glint_backend *backend)
{
    return backend->rtl != NULL ? glint_rtl_clocks(backend->rtl) : 0;
}
