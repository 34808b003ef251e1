/* Reads a GTKWave save file, for tests. */
#ifndef GLINT_TESTS_WAVE_SAVED_H
#define GLINT_TESTS_WAVE_SAVED_H

#include <stdbool.h>
#include <stdint.h>

#include "glint_specular_device.h"

/* Bits of a trace's flags. */
#define SAVED_HEX         0x2u
#define SAVED_DECIMAL     0x4u
#define SAVED_BINARY      0x8u
#define SAVED_SIGNED      0x400u
#define SAVED_FIXED_POINT 0x40000000u

typedef struct saved_trace {
    char name[112]; /* without its bits */
    char label[64]; /* what GTKWave shows */
    int row;        /* from 0 on, as long as no group is folded above it */
    bool is_folded; /* in a group that is */
    int width;
    unsigned flags;
    int fraction; /* [fpshift_count]; 0: none */
} saved_trace;

typedef struct saved {
    saved_trace trace[1024];
    int count;
    int headings;
    int longest_heading; /* characters; of groups too */
    char dumpfile[128];
    uint64_t first_time; /* [timestart] */
    double zoom;
    int64_t marker;
    int window_width, window_height; /* [size] */
    int signals_width;
} saved;

/* Fails the test on an unknown line or an unclosed group. */
void saved_read(const char *path, saved *saved);

/* Index of the signal that a trace shows; −1: it is a pin or no signal of the device. */
int saved_signal(const glint_specular_config *config, const saved_trace *trace);

/* The time that a wave area of so many pixels shows. */
double saved_view(const saved *saved, double pixels);

/* The full name of a signal in a waveform. */
void saved_name(const glint_signal_info *signal, char *name, int size);

#endif
