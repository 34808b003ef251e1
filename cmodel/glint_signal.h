/* A signal of a circuit, as comparisons, waveforms and documents need it. */
#ifndef GLINT_CMODEL_SIGNAL_H
#define GLINT_CMODEL_SIGNAL_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The kinds of signal that the figure distinguishes. */
typedef enum glint_signal_kind {
    GLINT_SIGNAL_REGISTER, /* a numbered register of the figure */
    GLINT_SIGNAL_BLOCK,    /* the output of a numbered combinational block */
    GLINT_SIGNAL_STAGE,    /* a pipeline register, or a wire in its place */
    GLINT_SIGNAL_OUTPUT,   /* an output port: what it is after the edge */
    GLINT_SIGNAL_MEALY,    /* one that follows a pin with no register between: what it is before the
                              edge, when the clock's pins are there and the state is the old one */
} glint_signal_kind;

static inline int glint_signal_is_port(glint_signal_kind kind)
{
    return kind == GLINT_SIGNAL_OUTPUT || kind == GLINT_SIGNAL_MEALY;
}

/* A signal as a comparer, a waveform or a document needs it. */
typedef struct glint_signal_info {
    const char *name;
    int block; /* number in figure 3.1; 0: none */
    glint_signal_kind kind;
    int int_bits, frac_bits;
    int is_signed;
    int lane; /* that of a device with lanes, or the stage of a pipeline; −1: of all of it */
    const char *meaning;
    size_t offset;       /* of its int64_t, or its uint64_t words, in the model's signals */
    size_t size;         /* of those, bytes; 0: enough, as the circuit's own tables have it */
    const char *path;    /* below the top, or the lane's scope: "u.acc"; NULL: its name */
    const char *heading; /* its heading in a waveform; NULL: none, or only its lane's */
    int is_copy;         /* duplicates another signal in this setting: waveforms omit it */
} glint_signal_info;

#ifdef __cplusplus
}
#endif

#endif
