/* The lobes against exact cosⁿ: sections 2.1 to 2.3. */
#include <math.h>
#include <stdlib.h>

#include "glint_formats.h"
#include "report/lobes.h"

static const glint_n_range n_is_1 = {1.0, 1.0}, from_2 = {2.0, INFINITY};

/* Figure 2.7's. */
static const glint_n_range figure_27 = {1.0, 512.0};

/* (2.2) as printed and in its possible readings. */
static const glint_reflectance_model readings[] = {
    GLINT_REFLECTANCE_SCHLICK_MODIFIED, GLINT_REFLECTANCE_SCHLICK_MODIFIED_ANGLE,
    GLINT_REFLECTANCE_SCHLICK_MODIFIED_LINEAR, GLINT_REFLECTANCE_SCHLICK_MODIFIED_SQUARED};

/* The quadratic's possible rivals: every other approximation of cosⁿ. */
static const glint_reflectance_model others[] = {GLINT_REFLECTANCE_SCHLICK,
                                                 GLINT_REFLECTANCE_SCHLICK_MODIFIED,
                                                 GLINT_REFLECTANCE_SCHLICK_MODIFIED_ANGLE,
                                                 GLINT_REFLECTANCE_SCHLICK_MODIFIED_LINEAR,
                                                 GLINT_REFLECTANCE_SCHLICK_MODIFIED_SQUARED,
                                                 GLINT_REFLECTANCE_SCHLICK_MODIFIED_POWER,
                                                 GLINT_REFLECTANCE_COSINE_QUADRATIC};

#define COUNT(array) ((int)(sizeof(array) / sizeof(array)[0]))

static glint_lobe_worst worst_of(const glint_lobes *lobes, glint_reflectance_model model,
                                 glint_n_range range)
{
    return glint_lobe_worst_of(&lobes->exponents, lobes->by_n[model], range);
}

static glint_status measure(glint_report *report, glint_lobes *lobes, glint_error *err)
{
    const struct {
        glint_reflectance_model model;
        double level;
        glint_accuracy *by_n;
    } more[] = {
        {GLINT_REFLECTANCE_QUADRATIC, GLINT_QUADRATIC_LEVEL, lobes->quadratic},
        {GLINT_REFLECTANCE_QUADRATIC, GLINT_DECAY_LEVEL, lobes->quadratic_decay},
        {GLINT_REFLECTANCE_COSINE_QUADRATIC, GLINT_DECAY_LEVEL, lobes->cosine_quadratic_decay}};
    glint_status status = GLINT_OK;
    glint_exponents_of(report->quick, &lobes->exponents);
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT && status == GLINT_OK; i++)
        if (glint_lobe_is_measured((glint_reflectance_model)i))
            status = glint_lobe_errors(report, (glint_reflectance_model)i, GLINT_EPICENTRE_LEVEL,
                                       &lobes->exponents, lobes->by_n[i], err);
    for (int i = 0; i < COUNT(more) && status == GLINT_OK; i++)
        status = glint_lobe_errors(report, more[i].model, more[i].level, &lobes->exponents,
                                   more[i].by_n, err);
    return status;
}

/* ---- A row of the table for each lobe, and the circuit's ------------------------------------- */

static void put_row(glint_numbers *numbers, const char *name, const char *formula,
                    const glint_lobe_worst *worst, double at_last)
{
    glint_number_add_word(numbers, "lobes.models", name);
    glint_number_put_text(numbers, formula, "lobes.%s.formula", name);
    glint_number_put(numbers, at_last, "lobes.%s.last", name);
    glint_number_put(numbers, worst->absolute.error, "lobes.%s.absolute", name);
    glint_number_put(numbers, worst->absolute.n, "lobes.%s.absolute.n", name);
    glint_number_put(numbers, worst->epicentre_absolute.error, "lobes.%s.epicentre", name);
    glint_number_put(numbers, worst->epicentre_absolute.n, "lobes.%s.epicentre.n", name);
    glint_number_put(numbers, worst->epicentre_relative.error, "lobes.%s.relative", name);
    glint_number_put(numbers, worst->epicentre_relative.n, "lobes.%s.relative.n", name);
}

static void put_rows(glint_numbers *numbers, const glint_lobes *lobes,
                     const glint_device_errors *device)
{
    const int last = lobes->exponents.count - 1;
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++) {
        const glint_reflectance_model model = (glint_reflectance_model)i;
        const glint_lobe_worst worst = worst_of(lobes, model, glint_n_all);
        if (!glint_lobe_is_measured(model))
            continue;
        put_row(numbers, glint_reflectance_names[i], glint_reflectance_describe(model)->formula,
                &worst, lobes->by_n[i][last].absolute.error);
    }
    put_row(numbers, "device", "(2.15) in fixed point, C", &device->model, device->model_last);
    put_row(numbers, "device-verilog", "the same, Verilog", &device->verilog, device->verilog_last);
    glint_number_put(numbers, lobes->exponents.n[last], "lobes.last-n");
}

/* ---- What the claims need beside that -------------------------------------------------------- */

static void put_worst(glint_numbers *numbers, const glint_worst *worst, const char *name)
{
    glint_number_put(numbers, worst->error, "lobes.%s", name);
    glint_number_put(numbers, worst->n, "lobes.%s.n", name);
}

static void put_relative(glint_numbers *numbers, const glint_lobes *lobes,
                         const glint_accuracy *by_n, glint_n_range range, const char *name)
{
    const glint_worst worst =
        glint_lobe_worst_of(&lobes->exponents, by_n, range).epicentre_relative;
    put_worst(numbers, &worst, name);
}

static void put_absolute(glint_numbers *numbers, const glint_lobes *lobes, glint_n_range range,
                         const char *name)
{
    const glint_worst worst = worst_of(lobes, GLINT_REFLECTANCE_COSINE_QUADRATIC, range).absolute;
    put_worst(numbers, &worst, name);
    glint_number_put(numbers, worst.cosine, "lobes.%s.cosine", name);
    glint_number_put(numbers, pow(worst.cosine, worst.n), "lobes.%s.level", name);
    glint_number_put(numbers, glint_formula_w(worst.n, worst.cosine), "lobes.%s.w", name);
}

static void put_ranges(glint_numbers *numbers, const glint_lobes *lobes)
{
    double modified[2] = {NAN, NAN}, form[2] = {NAN, NAN};
    for (int i = 0; i < COUNT(readings); i++)
        glint_number_widen(modified,
                           worst_of(lobes, readings[i], glint_n_all).epicentre_relative.error);
    glint_number_put_range(numbers, modified[0], modified[1], "lobes.modified.relative");
    /* Its a is not given: the best makes the error least, and a = 1 makes it Schlick's function. */
    glint_number_widen(form, worst_of(lobes, GLINT_REFLECTANCE_SCHLICK_MODIFIED_POWER, glint_n_all)
                                 .epicentre_relative.error);
    glint_number_widen(
        form, worst_of(lobes, GLINT_REFLECTANCE_SCHLICK, glint_n_all).epicentre_relative.error);
    glint_number_put_range(numbers, form[0], form[1], "lobes.table-form.relative");
}

static void put_gains(glint_numbers *numbers, const glint_lobes *lobes)
{
    const glint_lobe_worst schlick = worst_of(lobes, GLINT_REFLECTANCE_SCHLICK, glint_n_all);
    const glint_lobe_worst own = worst_of(lobes, GLINT_REFLECTANCE_COSINE_QUADRATIC, glint_n_all);
    const glint_lobe_worst quadratic = worst_of(lobes, GLINT_REFLECTANCE_QUADRATIC, glint_n_all);
    double gain[2] = {NAN, NAN};
    glint_number_put(numbers, schlick.epicentre_absolute.error / own.epicentre_absolute.error,
                     "lobes.gain.epicentre");
    glint_number_put(numbers, schlick.absolute.error / own.absolute.error, "lobes.gain.whole");
    for (int i = 0; i < COUNT(others); i++) {
        const glint_lobe_worst other = worst_of(lobes, others[i], glint_n_all);
        const double relative = other.epicentre_relative.error / quadratic.epicentre_relative.error;
        const double absolute = other.epicentre_absolute.error / quadratic.epicentre_absolute.error;
        glint_number_widen(gain, relative);
        glint_number_widen(gain, absolute);
        if (others[i] == GLINT_REFLECTANCE_SCHLICK) {
            glint_number_put(numbers, relative, "lobes.quadratic.gain.relative");
            glint_number_put(numbers, absolute, "lobes.quadratic.gain.absolute");
        }
    }
    glint_number_put_range(numbers, gain[0], gain[1], "lobes.quadratic.gain");
}

static void put(glint_numbers *numbers, const glint_lobes *lobes, const glint_device_errors *device)
{
    char exponents[64];
    glint_exponents_say(&lobes->exponents, glint_n_all, exponents, sizeof exponents);
    glint_number_put_text(numbers, exponents, "lobes.exponents");
    glint_number_put(numbers, GLINT_COS_ONE + 1u, "lobes.codes");
    put_rows(numbers, lobes, device);
    put_ranges(numbers, lobes);
    put_gains(numbers, lobes);
    put_relative(numbers, lobes, lobes->by_n[GLINT_REFLECTANCE_SCHLICK_MODIFIED_SQUARED], from_2,
                 "schlick-modified-squared.relative-from-2");
    put_relative(numbers, lobes, lobes->quadratic, glint_n_all, "quadratic.from-0.56");
    put_relative(numbers, lobes, lobes->quadratic, figure_27, "quadratic.from-0.56-to-512");
    put_relative(numbers, lobes, lobes->by_n[GLINT_REFLECTANCE_QUADRATIC], figure_27,
                 "quadratic.relative-to-512");
    put_relative(numbers, lobes, lobes->quadratic_decay, glint_n_all, "quadratic.decay");
    put_relative(numbers, lobes, lobes->cosine_quadratic_decay, glint_n_all,
                 "cosine-quadratic.decay");
    put_relative(numbers, lobes, lobes->cosine_quadratic_decay, from_2,
                 "cosine-quadratic.decay-from-2");
    put_absolute(numbers, lobes, from_2, "cosine-quadratic.absolute-from-2");
    put_absolute(numbers, lobes, n_is_1, "cosine-quadratic.absolute-at-1");
    glint_derivations_put(lobes, numbers);
}

static glint_status make(glint_report *report, glint_lobes *lobes, glint_error *err)
{
    const glint_device_errors *device;
    glint_status status = measure(report, lobes, err);
    if (status == GLINT_OK)
        status = glint_device_errors_of(report, &device, err);
    if (status != GLINT_OK)
        return status;
    put(&report->numbers, lobes, device);
    status = glint_shapes_put(lobes, &report->numbers, err);
    return status == GLINT_OK ? glint_lobes_draw(report, lobes, err) : status;
}

glint_status glint_chapter_lobes(glint_report *report, glint_error *err)
{
    glint_lobes *lobes = calloc(1, sizeof *lobes);
    if (lobes == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the lobes");
    const glint_status status = make(report, lobes, err);
    free(lobes);
    return status;
}
