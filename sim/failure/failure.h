/* A mismatch as a case: what was run, what differed, and what it takes to reproduce it.
 *
 * It is made from a finding of lockstep, of an exhaustive run or of two frames, or read from a
 * packet (packet.h). glint_failure_play() replays it. */
#ifndef GLINT_SIM_FAILURE_FAILURE_H
#define GLINT_SIM_FAILURE_FAILURE_H

#include "failure/capture.h"
#include "lockstep/answer.h"
#include "lockstep/domain.h"
#include "lockstep/history.h"
#include "lockstep/lockstep.h"

typedef enum glint_failure_kind {
    GLINT_FAILURE_RANDOM,
    GLINT_FAILURE_EXHAUSTIVE,
    GLINT_FAILURE_FRAME,
    GLINT_FAILURE_KINDS
} glint_failure_kind;

/* "random", "exhaustive", "frame". */
extern const char *const glint_failure_kind_names[GLINT_FAILURE_KINDS];

/* Where a frame differs. */
typedef struct glint_failure_frame {
    int width, height;
    bool has_pixel;           /* false if the circuit failed to answer; the rest is then unset */
    int x, y;                 /* the first pixel, row by row, that differs */
    uint8_t model[3], rtl[3]; /* its colour in both frames */
    bool has_triangle;        /* the mesh's triangle that is seen there */
    uint32_t triangle;
    float corner[3][3]; /* x, y, z of its corners in the mesh's own axes */
    bool has_fragment;  /* with Phong shading: the circuit's inputs for the pixel */
    uint32_t cos_code;
    glint_material material;
} glint_failure_frame;

/* What a replay found. */
typedef struct glint_failure_finding {
    bool answer_differs; /* a run of points or divisions, asked as a frame asks */
    int32_t model, rtl;  /* the two answers */
    bool alone_differs;  /* and so does the point or division without the others. Not in a packet */
    bool lockstep_differs; /* clock by clock, in the circuit whose signals can be read */
    uint64_t clock;        /* of an answer: the one after which it is out, if anything differs there
                            * or nowhere; else the first that differs */
    int count;             /* mismatches of that clock, the first of them */
    glint_mismatch mismatch[GLINT_MISMATCHES_KEPT];
} glint_failure_finding;

#define GLINT_FAILURE_COMMAND   2048
#define GLINT_FAILURE_DIRECTORY 4096

typedef struct glint_failure {
    glint_failure_kind kind;
    glint_setting setting;
    char command[GLINT_FAILURE_COMMAND]; /* that found it, whole */
    const char *program; /* for the commands of the report; NULL: build/glint. Not in a packet */

    /* What is not Glint's own, for the commands of the report; "": nothing. */
    char circuit_dir[GLINT_FAILURE_DIRECTORY]; /* that describes the circuit (--circuit-dir) */
    char rtl[GLINT_FAILURE_DIRECTORY];         /* that has its Verilog (--rtl) */

    /* pins[0] belong to clock first_clock, starting from reset state. Random failures without pins
     * replay the whole run from seed. Others without pins ask for the answer; they have pins if
     * asking is not enough, or if there was no answer. */
    uint64_t seed, first_clock;
    size_t pin_count;
    glint_pins *pins;
    glint_lockstep_result run; /* the run that found it; not stored in packets: run.comparisons is
                                * then 0 */

    bool has_answer; /* exhaustive, frame: the question and answer; a frame may differ without
                      * one */
    glint_answer answer;
    glint_failure_frame frame;

    glint_failure_finding finding;
    glint_capture *capture; /* that the play which found it gave. Not in a packet: NULL */
    bool interrupted;       /* interrupted before the replay: no capture */
} glint_failure;

/* From a lockstep run with mismatches: replays it once up to the first one, finds the fewest
 * preceding clocks that bring the C model to the same state and the Verilog to the same mismatch,
 * and keeps their pins. options->stop and progress apply to this. If stopped, also returns
 * GLINT_OK: the failure is then marked interrupted and holds only what the run found. */
glint_status glint_failure_of_lockstep(const glint_lockstep_options *options,
                                       const glint_lockstep_result *result, glint_failure **failure,
                                       glint_error *err);

/* From a differing answer: asks again, and also clock by clock. answer may be NULL if none was
 * found. */
glint_status glint_failure_of_answer(glint_failure_kind kind, const glint_setting *setting,
                                     const glint_answer *answer, glint_failure **failure,
                                     glint_error *err);

/* The same, for a circuit whose history is known, which then need not have answered. If asking
 * again shows no difference, the history is replayed; if that shows one, the failure keeps the pins
 * of the fewest last clocks that reproduce it. history, stop: may be NULL. GLINT_INTERRUPTED when
 * stopped. */
glint_status glint_failure_of_history(glint_failure_kind kind, const glint_setting *setting,
                                      const glint_answer *answer, const glint_history *history,
                                      const volatile bool *stop, glint_failure **failure,
                                      glint_error *err);

/* Of an output that glint_domain_run() with these options found to differ: plays its block again up
 * to there, and keeps the pins of the fewest of its last clocks that show the same.
 * GLINT_INTERRUPTED when stopped; GLINT_DEVICE_FAULT when nothing differs this time. */
glint_status glint_failure_of_domain(const glint_domain_options *options,
                                     const glint_domain_mismatch *mismatch, glint_failure **failure,
                                     glint_error *err);

/* Takes setting.verilog for failure->rtl, as what makes a failure does. */
void glint_failure_name_verilog(glint_failure *failure);

/* The Verilog's directory, unless implied by the circuit's; "": nothing to add. */
static inline const char *glint_failure_rtl(const glint_failure *failure)
{
    return strcmp(failure->rtl, failure->circuit_dir) != 0 ? failure->rtl : "";
}

void glint_failure_destroy(glint_failure *failure); /* NULL is allowed */

/* Whether there is anything to replay: a frame may differ without a differing answer. */
static inline bool glint_failure_playable(const glint_failure *failure)
{
    return failure->kind == GLINT_FAILURE_RANDOM || failure->has_answer || failure->pins != NULL;
}

/* Plays it. control: may be NULL. capture: the clocks around, to be freed with free(); may be NULL.
 * GLINT_BAD_INPUT when there is nothing to play, GLINT_INTERRUPTED when stopped. */
glint_status glint_failure_play(const glint_failure *failure, const glint_capture_control *control,
                                glint_failure_finding *finding, glint_capture **capture,
                                glint_error *err);

/* Whether two replays found the same clock, signals, and values on both sides. */
bool glint_failure_same(const glint_failure_finding *a, const glint_failure_finding *b);

static inline bool glint_failure_differs(const glint_failure_finding *finding)
{
    return finding->answer_differs || finding->lockstep_differs;
}

#endif
