/* A circuit's answer that differs from the C model's, found by an exhaustive run or a frame in a
 * run of points or divisions: the question, and the questions around it, so that it can be asked
 * again. Only the highlight units (circuit/units.h), the divider and the span unit have answers:
 * points, divisions and pixels of spans are typed only here and in their batches. */
#ifndef GLINT_SIM_LOCKSTEP_ANSWER_H
#define GLINT_SIM_LOCKSTEP_ANSWER_H

#include <stdbool.h>

#include "circuit/setting.h"
#include "glint_divider_device.h"
#include "glint_specular_device.h"
#include "lockstep/batch_pins.h"

typedef enum glint_answer_value {
    GLINT_ANSWER_W,
    GLINT_ANSWER_R, /* of the highlight, or of the quotients */
    GLINT_ANSWER_G,
    GLINT_ANSWER_B,
    GLINT_ANSWER_VALUES
} glint_answer_value;

#define GLINT_ANSWER_CLOCKS_BEFORE 32 /* clocks of points that are kept */
#define GLINT_ANSWER_CLOCKS_AFTER  4
#define GLINT_ANSWER_POINTS                                                                        \
    ((GLINT_ANSWER_CLOCKS_BEFORE + 1 + GLINT_ANSWER_CLOCKS_AFTER) * GLINT_LANES_MAX)
#define GLINT_ANSWER_DIVISIONS (GLINT_ANSWER_CLOCKS_BEFORE + 1 + GLINT_ANSWER_CLOCKS_AFTER)
#define GLINT_ANSWER_STEPS     GLINT_ANSWER_DIVISIONS

typedef struct glint_answer {
    glint_material material; /* of a highlight unit, like cos_code */
    union {
        uint32_t cos_code[GLINT_ANSWER_POINTS];
        glint_division division[GLINT_ANSWER_DIVISIONS];
        glint_span_step step[GLINT_ANSWER_STEPS]; /* the first one loads */
    };
    int count;                /* points, divisions or pixels kept */
    int at;                   /* the one of them whose answer differs */
    glint_answer_value value; /* the first of its values that does */
    int32_t model, rtl;       /* both: a code of W or of a quotient, or an intensity */
} glint_answer;

/* Keeps point `at` of a run of `count` points through `lanes` lanes, with its neighbours. It stays
 * on its lane. */
void glint_answer_keep_points(glint_answer *answer, int lanes, const glint_material *material,
                              const uint32_t *cos_code, size_t count, size_t at);

/* The same for divisions. */
void glint_answer_keep_divisions(glint_answer *answer, const glint_division *divisions,
                                 size_t count, size_t at);

/* The same for pixels of spans. Where the first one kept is in the middle of a span, it becomes a
 * load of what the unit's registers held there. */
void glint_answer_keep_steps(glint_answer *answer, int fraction, const glint_span_step *steps,
                             size_t count, size_t at);

/* Pixel `at` of a run that begins with a load, as a load. */
glint_span_step glint_span_step_resumed(int fraction, const glint_span_step *steps, size_t at);

/* Reduces it to its point or division alone, in the same place of the circuit and in a form that
 * can be typed: copies of the point from lane 0 up to the answer's, or the differences up to the
 * answer's component. */
void glint_answer_alone(const glint_answer *answer, const glint_setting *setting,
                        glint_answer *alone);

/* Whether the circuit has answers. */
bool glint_answer_possible(const glint_circuit *circuit);

/* "W", "red", "green", "blue". */
const char *glint_answer_value_name(glint_answer_value value);

/* Asks the setting's circuit again, in its fast build as a frame would, and the C model; fills in
 * both values. */
glint_status glint_answer_ask(const glint_answer *answer, const glint_setting *setting,
                              int32_t *model, int32_t *rtl, glint_error *err);

/* The pins that ask it clock by clock, until everything has come out; free with free(). NULL: no
 * memory. *expected: the clock, from 1 on, after which the answer is out. */
glint_pins *glint_answer_pins(const glint_answer *answer, const glint_setting *setting,
                              size_t *count, uint64_t *expected);

#endif
