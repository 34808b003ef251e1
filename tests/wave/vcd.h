/* Reads a waveform in VCD, for tests: which signals it has and what they are at a time. */
#ifndef GLINT_TESTS_WAVE_VCD_H
#define GLINT_TESTS_WAVE_VCD_H

#include <stdint.h>

typedef struct vcd_signal {
    char name[112]; /* with its scopes: "TOP.specular_device.lane[0].u.reg1" */
    char code[8];   /* what stands for it in the file */
    int width;      /* 0: a text */
} vcd_signal;

typedef struct vcd {
    char *text;
    const char *changes; /* what follows the definitions */
    vcd_signal *signals;
    int signal_count;
    uint64_t first_time, last_time;
} vcd;

/* Fails the test if the file is not a complete VCD. To be freed by vcd_free(). */
vcd vcd_read(const char *path);
void vcd_free(vcd *vcd);

/* The same of an FST, through GTKWave's fst2vcd, which leaves nothing behind. */
vcd vcd_read_fst(const char *path);

/* Fails the test unless two waveforms have the same signals, with the same widths and the same
 * changes at the same times. */
void vcd_assert_same(const vcd *a, const vcd *b);

/* The signal of this full name; NULL: there is none. */
const vcd_signal *vcd_find(const vcd *vcd, const char *name);

/* The 64 low bits of a signal at a time, changes at that time included. Fails the test when the
 * signal has no value yet or one that is not 0 or 1. */
uint64_t vcd_value(const vcd *vcd, const char *name, uint64_t time);

/* What a variable holds at a time as it stands in the file, "x" and texts included. */
void vcd_text(const vcd *vcd, const char *name, uint64_t time, char *text, int size);

#endif
