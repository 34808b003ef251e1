/* See lobe_errors.h. Exponents are shared out among threads; results do not depend on how. */
#include "report/lobe_errors.h"

#include <math.h>
#include <stdatomic.h>
#include <stdio.h>

#include "render/render.h"
#include "thread/crew.h"

static const double few[] = {1, 2, 3, 5, 8, 13, 20, 35, 50, 80, 100, 200, 500, 1000};

void glint_exponents_of(bool quick, glint_exponents *exponents)
{
    exponents->count = quick ? (int)(sizeof few / sizeof few[0]) : 1000;
    for (int i = 0; i < exponents->count; i++)
        exponents->n[i] = quick ? few[i] : i + 1;
}

bool glint_lobe_is_measured(glint_reflectance_model model)
{
    return glint_reflectance_describe(model)->cosine == GLINT_REFLECTANCE_OF_NH &&
           model != GLINT_REFLECTANCE_BLINN && model != GLINT_REFLECTANCE_BLINN_NORMALIZED &&
           model != GLINT_REFLECTANCE_ENERGY_CONSERVING && model != GLINT_REFLECTANCE_DEVICE;
}

const glint_n_range glint_n_all = {0.0, INFINITY};

static bool is_in(glint_n_range range, double n)
{
    return n >= range.from && n <= range.to;
}

void glint_exponents_say(const glint_exponents *exponents, glint_n_range range, char *text,
                         size_t room)
{
    int count = 0;
    double least = INFINITY, most = -INFINITY;
    for (int i = 0; i < exponents->count; i++)
        if (is_in(range, exponents->n[i])) {
            count++;
            least = fmin(least, exponents->n[i]);
            most = fmax(most, exponents->n[i]);
        }
    if (count == 0)
        snprintf(text, room, "no exponent");
    else if (count == 1)
        snprintf(text, room, "n = %g", least);
    else
        snprintf(text, room, "%d exponents n = %g…%g", count, least, most);
}

typedef struct sweep {
    const glint_report *report;
    glint_reflectance_model model;
    double level;
    const glint_exponents *exponents;
    glint_accuracy *by_n;
    _Atomic int next;
    _Atomic int failed; /* a glint_status */
    glint_error err[GLINT_THREADS_MAX];
} sweep;

static glint_status measure_one(sweep *sweep, int i, glint_error *err)
{
    const glint_reflectance_parameters parameters = {.n = sweep->exponents->n[i],
                                                     .f0 = GLINT_F0_DEFAULT};
    glint_reflectance prepared;
    glint_status status = glint_report_go_on(sweep->report, err);
    if (status == GLINT_OK)
        status = glint_reflectance_prepare(sweep->model, &parameters, &prepared, err);
    if (status == GLINT_OK)
        status = glint_accuracy_measure(&prepared, sweep->level, &sweep->by_n[i], err);
    return status;
}

static void measure_some(void *context, int worker)
{
    sweep *sweep = context;
    for (int i = sweep->next++; i < sweep->exponents->count && sweep->failed == 0;
         i = sweep->next++) {
        const glint_status status = measure_one(sweep, i, &sweep->err[worker]);
        if (status != GLINT_OK)
            sweep->failed = (int)status;
    }
}

glint_status glint_lobe_errors(const glint_report *report, glint_reflectance_model model,
                               double level, const glint_exponents *exponents, glint_accuracy *by_n,
                               glint_error *err)
{
    sweep sweep = {
        .report = report, .model = model, .level = level, .exponents = exponents, .by_n = by_n};
    glint_crew *crew;
    const glint_status status = glint_crew_create(report->threads, &crew, err);
    if (status != GLINT_OK)
        return status;
    glint_crew_run(crew, measure_some, &sweep);
    glint_crew_destroy(crew);
    for (int i = 0; sweep.failed != 0 && i < GLINT_THREADS_MAX; i++)
        if (sweep.err[i].text[0] != '\0')
            return glint_fail(err, (glint_status)sweep.failed, "%s", sweep.err[i].text);
    return (glint_status)sweep.failed;
}

static void keep(glint_worst *worst, double error, double n, double cosine)
{
    if (!(error <= worst->error))
        *worst = (glint_worst){error, n, cosine};
}

glint_lobe_worst glint_lobe_worst_of(const glint_exponents *exponents, const glint_accuracy *by_n,
                                     glint_n_range range)
{
    static const glint_worst none = {NAN, NAN, NAN};
    glint_lobe_worst worst = {none, none, none};
    for (int i = 0; i < exponents->count; i++) {
        const double n = exponents->n[i];
        const glint_accuracy *a = &by_n[i];
        if (!is_in(range, n))
            continue;
        keep(&worst.absolute, a->absolute.error, n, a->absolute.cosine);
        keep(&worst.epicentre_absolute, a->epicentre_absolute.error, n,
             a->epicentre_absolute.cosine);
        keep(&worst.epicentre_relative, a->epicentre_relative.error, n,
             a->epicentre_relative.cosine);
    }
    return worst;
}
