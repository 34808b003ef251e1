/* The lobes against exact cosⁿ: sections 2.1 to 2.3. */
#include "report/sections.h"

#include <inttypes.h>
#include <stdlib.h>

#include "glint_formats.h"
#include "report/lobe_parts.h"

bool glint_lobe_is_measured(glint_reflectance_model model)
{
    return glint_reflectance_describe(model)->cosine == GLINT_REFLECTANCE_OF_NH &&
           model != GLINT_REFLECTANCE_BLINN && model != GLINT_REFLECTANCE_BLINN_NORMALIZED &&
           model != GLINT_REFLECTANCE_ENERGY_CONSERVING && model != GLINT_REFLECTANCE_DEVICE;
}

glint_lobe_worst glint_lobes_worst(const glint_lobes *lobes, glint_reflectance_model model,
                                   glint_n_range range)
{
    return glint_lobe_worst_of(&lobes->exponents, lobes->by_n[model], range);
}

static glint_status measure(glint_report *report, glint_lobes *lobes, glint_error *err)
{
    glint_status status = GLINT_OK;
    glint_exponents_of(report->quick, &lobes->exponents);
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT && status == GLINT_OK; i++) {
        const glint_reflectance_model model = (glint_reflectance_model)i;
        if (glint_lobe_is_measured(model))
            status = glint_lobe_errors(report, model, GLINT_EPICENTRE_LEVEL, &lobes->exponents,
                                       lobes->by_n[model], err);
    }
    if (status == GLINT_OK)
        status = glint_lobe_errors(report, GLINT_REFLECTANCE_QUADRATIC, GLINT_QUADRATIC_LEVEL,
                                   &lobes->exponents, lobes->quadratic, err);
    if (status == GLINT_OK)
        status = glint_lobe_errors(report, GLINT_REFLECTANCE_QUADRATIC, GLINT_DECAY_LEVEL,
                                   &lobes->exponents, lobes->quadratic_decay, err);
    if (status == GLINT_OK)
        status = glint_lobe_errors(report, GLINT_REFLECTANCE_COSINE_QUADRATIC, GLINT_DECAY_LEVEL,
                                   &lobes->exponents, lobes->cosine_quadratic_decay, err);
    if (status == GLINT_OK)
        status = glint_device_errors_measure(report, GLINT_EPICENTRE_LEVEL, &lobes->exponents,
                                             &lobes->device, err);
    if (status == GLINT_OK)
        glint_derivations_measure(lobes, &lobes->derived);
    return status;
}

static void write_row(FILE *out, const char *name, const char *formula,
                      const glint_lobe_worst *worst, double at_last)
{
    fprintf(out, "| %s | `%s` | %.4f | %.4f | %g | %.4f | %g | %.2f | %g |\n", name, formula,
            at_last, worst->absolute.error, worst->absolute.n, worst->epicentre_absolute.error,
            worst->epicentre_absolute.n, 100.0 * worst->epicentre_relative.error,
            worst->epicentre_relative.n);
}

static void write_table(FILE *out, const glint_lobes *lobes)
{
    char exponents[64];
    const int last = lobes->exponents.count - 1;
    glint_exponents_say(&lobes->exponents, glint_n_all, exponents, sizeof exponents);
    fprintf(out,
            "Each lobe against exact cos^n of the same cosine, the largest error over %s\n(double "
            "precision; c is the cosine). The *epicentre* is where cos^n ≥ "
            "%g. The last two rows are the\nfixed-point circuit at every one of its %u cosine "
            "codes.\n\n"
            "| model | formula | absolute, n = %g | absolute | at n | epicentre absolute | at n "
            "| epicentre relative, "
            "%% | at n |\n|---|---|--:|--:|--:|--:|--:|--:|--:|\n",
            exponents, GLINT_EPICENTRE_LEVEL, GLINT_COS_ONE + 1u, lobes->exponents.n[last]);
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++) {
        const glint_reflectance_model model = (glint_reflectance_model)i;
        const glint_lobe_worst worst = glint_lobes_worst(lobes, model, glint_n_all);
        if (glint_lobe_is_measured(model))
            write_row(out, glint_reflectance_names[i], glint_reflectance_describe(model)->formula,
                      &worst, lobes->by_n[i][last].absolute.error);
    }
    write_row(out, "*device*, C model", "(2.15) in fixed point", &lobes->device.model,
              lobes->device.model_last);
    write_row(out, "*device*, Verilog", "the same, simulated", &lobes->device.verilog,
              lobes->device.verilog_last);
}

static void write_device(FILE *out, const glint_device_errors *device)
{
    fprintf(out,
            "\nThe circuit's own error, from (2.15) in double precision, is at most %.3g (n = %g); "
            "its error from cos^n is\n%.0f times that. %" PRIu64 " of %" PRIu64
            " values of W differ between the C model and the Verilog.\n",
            device->rounding.error, device->rounding.n,
            device->model.absolute.error / device->rounding.error, device->differing,
            device->points);
}

static bool add_numbers(cJSON *numbers, const char *name, const glint_lobe_worst *worst)
{
    cJSON *object = cJSON_AddObjectToObject(numbers, name);
    return object != NULL &&
           cJSON_AddNumberToObject(object, "absolute", worst->absolute.error) != NULL &&
           cJSON_AddNumberToObject(object, "absolute_n", worst->absolute.n) != NULL &&
           cJSON_AddNumberToObject(object, "epicentre_absolute", worst->epicentre_absolute.error) !=
               NULL &&
           cJSON_AddNumberToObject(object, "epicentre_relative", worst->epicentre_relative.error) !=
               NULL;
}

static glint_status write_numbers(glint_report *report, const glint_lobes *lobes, glint_error *err)
{
    bool whole = true;
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++) {
        const glint_lobe_worst worst =
            glint_lobes_worst(lobes, (glint_reflectance_model)i, glint_n_all);
        if (glint_lobe_is_measured((glint_reflectance_model)i))
            whole = whole && add_numbers(report->numbers, glint_reflectance_names[i], &worst);
    }
    whole = whole && add_numbers(report->numbers, "device", &lobes->device.model) &&
            add_numbers(report->numbers, "device-verilog", &lobes->device.verilog);
    return whole ? GLINT_OK : glint_fail(err, GLINT_NO_MEMORY, "no memory for the lobes' numbers");
}

static glint_status write_section(glint_report *report, glint_lobes *lobes, glint_error *err)
{
    glint_status status = measure(report, lobes, err);
    if (status != GLINT_OK)
        return status;
    write_table(report->markdown, lobes);
    write_device(report->markdown, &lobes->device);
    status = glint_lobes_draw(report, lobes, err);
    if (status != GLINT_OK)
        return status;
    glint_lobes_find(lobes, report->findings);
    return write_numbers(report, lobes, err);
}

glint_status glint_section_lobes(glint_report *report, glint_error *err)
{
    glint_lobes *lobes = calloc(1, sizeof *lobes);
    if (lobes == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the lobes");
    const glint_status status = write_section(report, lobes, err);
    free(lobes);
    return status;
}
