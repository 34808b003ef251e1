/* The combinational form with all lanes is driven, since it gives that many W a clock; cosⁿ is made
 * from n to n by one multiplication, so n runs inside and the cosines outside. */
#include "compare/errors.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/model.h"
#include "compare/formula.h"
#include "glint_specular_device.h"

enum { LANES = GLINT_LANES_MAX, N_COUNT = GLINT_COMPARE_N_MAX + 1 };

typedef struct measuring {
    glint_setting setting;
    glint_compare_formula formula;
    void *model;
    size_t offset[LANES]; /* of out_w of each lane among the model's signals */
    double one;           /* code of W = 1 */
    double squares[N_COUNT], reference[N_COUNT];
    glint_compare_errors *errors;
} measuring;

/* The codes of one clock: those past the last repeat it, and are not counted. */
typedef struct batch {
    uint32_t code[LANES];
    int count;
    double cosine[LANES], power[LANES];
} batch;

static void set(glint_setting *setting, const char *name, int value)
{
    for (int i = 0; i < setting->circuit->parameter_count; i++)
        if (strcmp(setting->circuit->parameters[i].name, name) == 0)
            setting->values[i] = value;
}

static void find_outputs(measuring *m)
{
    const glint_circuit *circuit = m->setting.circuit;
    for (int i = 0; i < circuit->signal_count(m->setting.values); i++) {
        const glint_signal_info info = circuit->signal(m->setting.values, i);
        if (info.kind == GLINT_SIGNAL_OUTPUT && strcmp(info.name, "out_w") == 0) {
            m->offset[info.lane] = info.offset;
            m->one = ldexp(1, info.frac_bits);
        }
    }
}

static void note(glint_compare_worst *worst, double w, double reference, uint32_t n, uint32_t code)
{
    const double steps = fabs(w - reference) * GLINT_COLOR_MAX;
    if (steps > worst->steps)
        *worst = (glint_compare_worst){steps, n, code};
}

static void clock_once(measuring *m, const batch *points, uint32_t n, double w[LANES])
{
    glint_specular_inputs in = {.en = 1, .n_we = 1, .n = (uint16_t)n, .in_valid = UINT32_MAX};
    memcpy(in.cos, points->code, sizeof in.cos);
    glint_model_clock(&m->setting, m->model, &in);
    const char *signals = glint_model_signals(&m->setting, m->model);
    for (int i = 0; i < points->count; i++) {
        int64_t code;
        memcpy(&code, signals + m->offset[i], sizeof code);
        w[i] = (double)code / m->one;
    }
}

static void raise(batch *points)
{
    for (int i = 0; i < points->count; i++)
        points->power[i] *= points->cosine[i];
}

static void compare(measuring *m, const batch *points, uint32_t n)
{
    double w[LANES];
    clock_once(m, points, n, w);
    for (int i = 0; i < points->count; i++) {
        const double power = points->power[i];
        const double difference = w[i] - power;
        m->squares[n] += difference * difference;
        m->reference[n] += power * power;
        note(&m->errors->power, w[i], power, n, points->code[i]);
        note(&m->errors->own, w[i], glint_compare_formula_w(&m->formula, n, points->code[i]), n,
             points->code[i]);
    }
    m->errors->points += (uint64_t)points->count;
}

/* The codes from `first` on; returns the first of the next batch. */
static uint32_t fill(batch *points, uint32_t first, uint32_t stride)
{
    points->count = 0;
    for (int i = 0; i < LANES; i++) {
        points->code[i] = first < GLINT_COS_ONE ? first : GLINT_COS_ONE;
        points->cosine[i] = (double)points->code[i] / GLINT_COS_ONE;
        points->power[i] = 1;
        points->count += first < GLINT_COS_ONE + stride;
        first += stride;
    }
    return first;
}

static void measure(measuring *m, uint32_t stride)
{
    const uint32_t only = glint_compare_formula_n(&m->formula);
    batch points;
    for (uint32_t first = 0; first < GLINT_COS_ONE + stride;) {
        first = fill(&points, first, stride);
        for (uint32_t n = GLINT_COMPARE_N_MIN; n <= GLINT_COMPARE_N_MAX; n++) {
            raise(&points);
            if (only == 0 || n == only)
                compare(m, &points, n);
        }
    }
    for (uint32_t n = GLINT_COMPARE_N_MIN; n <= GLINT_COMPARE_N_MAX; n++)
        if (m->reference[n] > 0 && m->squares[n] / m->reference[n] > m->errors->nmse) {
            m->errors->nmse = m->squares[n] / m->reference[n];
            m->errors->nmse_n = n;
        }
}

glint_status glint_compare_measure(const glint_setting *setting, uint32_t stride,
                                   glint_compare_errors *errors, glint_error *err)
{
    *errors = (glint_compare_errors){.points = 0};
    measuring *m = calloc(1, sizeof *m);
    if (m == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory to measure with");
    m->setting = *setting;
    m->errors = errors;
    set(&m->setting, "pipeline", GLINT_PIPELINE_COMBINATIONAL);
    set(&m->setting, "lanes", LANES);
    glint_status status = glint_compare_formula_of(setting, &m->formula, err);
    if (status == GLINT_OK)
        status = glint_model_create(&m->setting, &m->model, err);
    if (status == GLINT_OK) {
        find_outputs(m);
        measure(m, stride);
    }
    glint_model_destroy(&m->setting, m->model);
    free(m);
    return status;
}
