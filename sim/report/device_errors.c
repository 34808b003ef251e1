/* Every cosine code goes through the C model, with each gate, and through the Verilog; see
 * device_errors.h. */
#include "report/device_errors.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "circuit/circuits.h"
#include "rtl/batch.h"
#include "thread/crew.h"

#define CODES (GLINT_COS_ONE + 1u)

static const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 16};

/* One thread's room. */
typedef struct worker {
    glint_rtl *rtl;
    uint32_t *code, *model, *verilog; /* CODES each: the cosine, W by C, W by Verilog */
    uint8_t *rgb;                     /* 5·CODES: R, not looked at twice; R of gate sign, drawn */
    glint_device_errors errors;
    glint_status status;
    glint_error err;
} worker;

typedef struct sweep {
    const glint_report *report;
    double level;
    const glint_exponents *exponents;
    _Atomic int next;
    _Atomic bool failed;
    worker *workers;
} sweep;

static void keep(glint_worst *worst, double error, double n, uint32_t code)
{
    if (error > worst->error)
        *worst = (glint_worst){error, n, (double)code / GLINT_COS_ONE};
}

static void keep_worse(glint_worst *worst, const glint_worst *other)
{
    /* The smaller n if two are equal, so the result does not depend on threads. */
    if (other->error > worst->error || (other->error == worst->error && other->n < worst->n))
        *worst = *other;
}

static void keep_worst_of_lobe(glint_lobe_worst *worst, const glint_lobe_worst *other)
{
    keep_worse(&worst->absolute, &other->absolute);
    keep_worse(&worst->epicentre_absolute, &other->epicentre_absolute);
    keep_worse(&worst->epicentre_relative, &other->epicentre_relative);
}

static void measure_point(glint_lobe_worst *worst, uint32_t w, double exact, double level, double n,
                          uint32_t code)
{
    const double error = fabs((double)w / GLINT_W_ONE - exact);
    keep(&worst->absolute, error, n, code);
    if (exact >= level) {
        keep(&worst->epicentre_absolute, error, n, code);
        keep(&worst->epicentre_relative, error / exact, n, code);
    }
}

static void measure_points(worker *own, double n, double level)
{
    glint_device_errors *errors = &own->errors;
    for (uint32_t code = 0; code < CODES; code++) {
        const double cosine = (double)code / GLINT_COS_ONE;
        const double exact = pow(cosine, n);
        const double w = (double)own->model[code] / GLINT_W_ONE;
        const double formula = glint_specular_real(GLINT_GATE_COSINE, (uint16_t)n, code);
        const uint8_t *r = own->rgb + code;
        errors->differing += own->model[code] != own->verilog[code];
        errors->sign_differing += r[3 * CODES] != *r;
        errors->drawn_differing += r[4 * CODES] != *r;
        keep(&errors->output, fabs(*r - GLINT_COLOR_MAX * formula), n, code);
        measure_point(&errors->model, own->model[code], exact, level, n, code);
        measure_point(&errors->verilog, own->verilog[code], exact, level, n, code);
        keep(&errors->rounding, fabs(w - formula), n, code);
    }
    errors->points += CODES;
}

static double largest_error(const uint32_t *w, double n)
{
    double largest = 0.0;
    for (uint32_t code = 0; code < CODES; code++)
        largest = fmax(largest,
                       fabs((double)w[code] / GLINT_W_ONE - pow((double)code / GLINT_COS_ONE, n)));
    return largest;
}

static glint_status measure_exponent(const sweep *sweep, worker *own, double n)
{
    const glint_material white = {(uint16_t)n, GLINT_COLOR_MAX, GLINT_COLOR_MAX, GLINT_COLOR_MAX};
    uint8_t *r = own->rgb, *g = r + CODES, *b = g + CODES, *sign = b + CODES, *drawn = sign + CODES;
    glint_status status = glint_report_go_on(sweep->report, &own->err);
    if (status == GLINT_OK)
        status = glint_specular_batch(GLINT_GATE_SIGN, &white, own->code, CODES, NULL, sign, g, b);
    if (status == GLINT_OK)
        status =
            glint_specular_batch(GLINT_GATE_DRAWN, &white, own->code, CODES, NULL, drawn, g, b);
    if (status == GLINT_OK)
        status = glint_specular_batch(config.gate, &white, own->code, CODES, own->model, r, g, b);
    if (status == GLINT_OK)
        status = glint_rtl_shade(
            own->rtl, &white, &(glint_points){own->code, CODES, own->verilog, r, g, b}, &own->err);
    if (status != GLINT_OK)
        return status;
    if (n == sweep->exponents->n[sweep->exponents->count - 1]) {
        own->errors.model_last = largest_error(own->model, n);
        own->errors.verilog_last = largest_error(own->verilog, n);
    }
    measure_points(own, n, sweep->level);
    return GLINT_OK;
}

static void measure_some(void *context, int index)
{
    sweep *sweep = context;
    worker *own = &sweep->workers[index];
    for (int i = sweep->next++; i < sweep->exponents->count && !sweep->failed; i = sweep->next++) {
        own->status = measure_exponent(sweep, own, sweep->exponents->n[i]);
        if (own->status != GLINT_OK)
            sweep->failed = true;
    }
}

static glint_status create_worker(worker *own, glint_error *err)
{
    own->code = malloc(CODES * sizeof *own->code);
    own->model = malloc(CODES * sizeof *own->model);
    own->verilog = malloc(CODES * sizeof *own->verilog);
    own->rgb = malloc(5 * (size_t)CODES);
    if (own->code == NULL || own->model == NULL || own->verilog == NULL || own->rgb == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for %u cosine codes", CODES);
    for (uint32_t code = 0; code < CODES; code++)
        own->code[code] = code;
    const glint_setting setting = glint_setting_specular(&config);
    return glint_rtl_open(&setting, GLINT_RTL_FAST, &own->rtl, err);
}

static void destroy_worker(worker *own)
{
    glint_rtl_destroy(own->rtl);
    free(own->code);
    free(own->model);
    free(own->verilog);
    free(own->rgb);
}

/* Adds up what the threads found. */
static glint_status collect(const sweep *sweep, int threads, glint_device_errors *errors,
                            glint_error *err)
{
    *errors = (glint_device_errors){0};
    for (int i = 0; i < threads; i++) {
        const worker *own = &sweep->workers[i];
        if (own->status != GLINT_OK)
            return glint_fail(err, own->status, "%s", own->err.text);
        errors->points += own->errors.points;
        errors->differing += own->errors.differing;
        errors->model_last = fmax(errors->model_last, own->errors.model_last);
        errors->verilog_last = fmax(errors->verilog_last, own->errors.verilog_last);
        keep_worst_of_lobe(&errors->model, &own->errors.model);
        keep_worst_of_lobe(&errors->verilog, &own->errors.verilog);
        keep_worse(&errors->rounding, &own->errors.rounding);
        keep_worse(&errors->output, &own->errors.output);
        errors->sign_differing += own->errors.sign_differing;
        errors->drawn_differing += own->errors.drawn_differing;
    }
    return GLINT_OK;
}

static glint_status run(sweep *sweep, int threads, glint_device_errors *errors, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int i = 0; i < threads && status == GLINT_OK; i++)
        status = create_worker(&sweep->workers[i], err);
    if (status != GLINT_OK)
        return status;
    glint_crew *crew;
    status = glint_crew_create(threads, &crew, err);
    if (status != GLINT_OK)
        return status;
    glint_crew_run(crew, measure_some, sweep);
    glint_crew_destroy(crew);
    return collect(sweep, threads, errors, err);
}

static glint_status measure(const glint_report *report, const glint_exponents *exponents,
                            glint_device_errors *errors, glint_error *err)
{
    const int threads = report->threads;
    sweep sweep = {.report = report,
                   .level = GLINT_EPICENTRE_LEVEL,
                   .exponents = exponents,
                   .workers = calloc((size_t)threads, sizeof *sweep.workers)};
    if (sweep.workers == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for %d threads", threads);
    const glint_status status = run(&sweep, threads, errors, err);
    for (int i = 0; i < threads; i++)
        destroy_worker(&sweep.workers[i]);
    free(sweep.workers);
    return status;
}

glint_status glint_device_errors_of(glint_report *report, const glint_device_errors **errors,
                                    glint_error *err)
{
    glint_status status = GLINT_OK;
    if (report->device == NULL) {
        glint_exponents exponents;
        glint_exponents_of(report->quick, &exponents);
        report->device = calloc(1, sizeof *report->device);
        status = report->device != NULL
                     ? measure(report, &exponents, report->device, err)
                     : glint_fail(err, GLINT_NO_MEMORY, "no memory for the device's errors");
    }
    *errors = report->device;
    return status;
}
