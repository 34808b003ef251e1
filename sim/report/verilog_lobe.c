/* Runs of neighbouring cosine codes go through the circuit when the first of them is asked for: a
 * narrow lobe needs few of them. */
#include "report/verilog_lobe.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/circuits.h"
#include "rtl/batch.h"

#define CODES (GLINT_COS_ONE + 1u)
#define RUN   2048u
#define RUNS  ((CODES + RUN - 1u) / RUN)

static const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 16};

struct glint_verilog_lobe {
    glint_reflectance reflectance; /* the first: its address is the lobe's */
    glint_rtl *rtl;
    glint_status status;
    glint_error err;
    bool known[RUNS];
    uint32_t code[CODES], w[CODES];
    uint8_t rgb[3 * RUN]; /* not looked at */
};

static void run(glint_verilog_lobe *lobe, uint32_t index)
{
    const glint_material white = {(uint16_t)lobe->reflectance.n, GLINT_COLOR_MAX, GLINT_COLOR_MAX,
                                  GLINT_COLOR_MAX};
    const uint32_t first = index * RUN;
    const uint32_t count = CODES - first < RUN ? CODES - first : RUN;
    const glint_points points = {lobe->code + first, count,           lobe->w + first,
                                 lobe->rgb,          lobe->rgb + RUN, lobe->rgb + 2 * RUN};
    if (lobe->status == GLINT_OK)
        lobe->status = glint_rtl_shade(lobe->rtl, &white, &points, &lobe->err);
    if (lobe->status != GLINT_OK)
        memset(lobe->w + first, 0, count * sizeof *lobe->w);
    lobe->known[index] = true;
}

static double of_cosine(const glint_reflectance *prepared, double cosine)
{
    glint_verilog_lobe *lobe = (glint_verilog_lobe *)(uintptr_t)prepared;
    const uint32_t code = glint_cos_code(cosine);
    if (!lobe->known[code / RUN])
        run(lobe, code / RUN);
    return (double)lobe->w[code] / GLINT_W_ONE;
}

glint_status glint_verilog_lobe_create(glint_verilog_lobe **lobe, glint_error *err)
{
    glint_verilog_lobe *made = calloc(1, sizeof *made);
    if (made == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the Verilog's lobe");
    for (uint32_t code = 0; code < CODES; code++)
        made->code[code] = code;
    const glint_setting setting = glint_setting_specular(&config);
    const glint_status status = glint_rtl_open(&setting, GLINT_RTL_FAST, &made->rtl, err);
    if (status == GLINT_OK)
        *lobe = made;
    else
        free(made);
    return status;
}

void glint_verilog_lobe_destroy(glint_verilog_lobe *lobe)
{
    if (lobe != NULL)
        glint_rtl_destroy(lobe->rtl);
    free(lobe);
}

glint_status glint_verilog_lobe_prepare(glint_verilog_lobe *lobe, double n,
                                        const glint_reflectance **reflectance, glint_error *err)
{
    const glint_reflectance_parameters parameters = {.n = n};
    const glint_status status =
        glint_reflectance_prepare(GLINT_REFLECTANCE_DEVICE, &parameters, &lobe->reflectance, err);
    if (status != GLINT_OK)
        return status;
    lobe->reflectance.of_cosine = of_cosine;
    memset(lobe->known, 0, sizeof lobe->known);
    *reflectance = &lobe->reflectance;
    return GLINT_OK;
}

glint_status glint_verilog_lobe_check(const glint_verilog_lobe *lobe, glint_error *err)
{
    return lobe->status == GLINT_OK ? GLINT_OK
                                    : glint_fail(err, lobe->status, "%s", lobe->err.text);
}
