/* The Verilog's rows of the chapter on energy; see energy.h. */
#include "report/energy.h"

#include <stdlib.h>

#include "energy/reciprocity.h"
#include "report/verilog_lobe.h"

static const glint_reflectance_model device = GLINT_REFLECTANCE_DEVICE;

static glint_status prepare(void *context, int worker,
                            const glint_reflectance_parameters *parameters,
                            const glint_reflectance **reflectance, glint_error *err)
{
    glint_verilog_lobe **lobes = context;
    return glint_verilog_lobe_prepare(lobes[worker], parameters->n, reflectance, err);
}

static glint_status make(const glint_energy_plan *plan, glint_verilog_lobe **lobes,
                         glint_energy_table **table, glint_error *err)
{
    glint_energy_plan of_verilog = *plan;
    glint_energy_table *made;
    of_verilog.model = &device;
    of_verilog.model_count = 1;
    of_verilog.prepare = prepare;
    of_verilog.prepare_context = lobes;
    glint_status status = GLINT_OK;
    for (int i = 0; i < plan->threads && status == GLINT_OK; i++)
        status = glint_verilog_lobe_create(&lobes[i], err);
    if (status == GLINT_OK)
        status = glint_energy_table_make(&of_verilog, &made, err);
    if (status != GLINT_OK)
        return status;
    for (int i = 0; i < plan->threads && status == GLINT_OK; i++)
        status = glint_verilog_lobe_check(lobes[i], err);
    if (status == GLINT_OK)
        *table = made;
    else
        glint_energy_table_destroy(made);
    return status;
}

glint_status glint_energy_verilog_table(const glint_energy_plan *plan, glint_energy_table **table,
                                        glint_error *err)
{
    glint_verilog_lobe **lobes = calloc((size_t)plan->threads, sizeof(glint_verilog_lobe *));
    if (lobes == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for %d threads", plan->threads);
    const glint_status status = make(plan, lobes, table, err);
    for (int i = 0; i < plan->threads; i++)
        glint_verilog_lobe_destroy(lobes[i]);
    free(lobes);
    return status;
}

glint_status glint_energy_verilog_normal(const glint_report *report,
                                         double albedo[GLINT_ENERGY_N_MAX], glint_error *err)
{
    static const double normal_incidence = 0.0;
    double n[GLINT_ENERGY_N_MAX];
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++)
        n[i] = i + 1;
    const glint_energy_plan plan = {.n = n,
                                    .n_count = GLINT_ENERGY_N_MAX,
                                    .angle = &normal_incidence,
                                    .angle_count = 1,
                                    .quadrature = true,
                                    .threads = report->threads,
                                    .stop = report->stop};
    glint_energy_table *table;
    const glint_status status = glint_energy_verilog_table(&plan, &table, err);
    if (status != GLINT_OK)
        return status;
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++)
        albedo[i] = glint_energy_at(table, 0, i, 0)->quadrature;
    glint_energy_table_destroy(table);
    return GLINT_OK;
}

glint_status glint_energy_verilog_asymmetry(const double *n, int count, uint64_t pairs,
                                            uint64_t seed, double *largest, glint_error *err)
{
    glint_verilog_lobe *lobe;
    glint_status status = glint_verilog_lobe_create(&lobe, err);
    if (status != GLINT_OK)
        return status;
    *largest = 0.0;
    for (int i = 0; i < count && status == GLINT_OK; i++) {
        const glint_reflectance *reflectance;
        glint_reciprocity found;
        status = glint_verilog_lobe_prepare(lobe, n[i], &reflectance, err);
        if (status != GLINT_OK)
            break;
        glint_reciprocity_measure(glint_reciprocity_of_model, reflectance, pairs, seed, &found);
        *largest = found.largest > *largest ? found.largest : *largest;
        status = glint_verilog_lobe_check(lobe, err);
    }
    glint_verilog_lobe_destroy(lobe);
    return status;
}
