/* Waveforms as files: the specular device's demonstration scene, and FST made into VCD. */
#ifndef GLINT_SIM_WAVEFORM_H
#define GLINT_SIM_WAVEFORM_H

#include <stdbool.h>

#include "glint_specular_device.h"

typedef enum glint_wave_format {
    GLINT_WAVE_FST,
    GLINT_WAVE_VCD,
    GLINT_WAVE_FORMAT_COUNT
} glint_wave_format;

/* The demonstration scene: a scan line across a highlight, from outside over its edge and its
 * centre and out again, with a stall in its middle; then another material with the very next point,
 * a gap, a code above 1.0, and a third material between points. */
#define GLINT_WAVE_SCENE_CLOCKS 48

/* The pins of clock `clock` (1…GLINT_WAVE_SCENE_CLOCKS) for a device of `lanes` lanes. */
void glint_wave_scene(int clock, int lanes, glint_specular_inputs *inputs);

/* Clock of the scene at whose edge the centre of the highlight enters register 1. */
int glint_wave_scene_centre(int lanes);

/* Writes a waveform by `record`, which runs a circuit with its trace open on the path it is given:
 * beside, looked through whether all of it arrived, made into VCD if asked for, then renamed. */
typedef glint_status glint_wave_recorder(const void *context, const char *path, glint_error *err);
glint_status glint_wave_write(const char *path, glint_wave_format format,
                              glint_wave_recorder *record, const void *context, glint_error *err);

/* Runs the scene on the circuit and writes the waveform of the clocks first…last (1 ≤ first ≤ last
 * ≤ GLINT_WAVE_SCENE_CLOCKS) to path, beside and then renamed. */
glint_status glint_wave_record(const glint_specular_config *config, glint_wave_format format,
                               int first, int last, const char *path, glint_error *err);

/* Room to be there, with glint_file_room(), before a waveform is opened: the FST writer maps its
 * temporary files into memory, and on a full disk touching them would end the program. Some ten
 * times what the windows written here take. */
#define GLINT_WAVE_ROOM (1L << 20)

/* Writes the FST file `fst` as VCD. GLINT_BAD_INPUT when it is no readable FST. */
glint_status glint_wave_fst_to_vcd(const char *fst, const char *vcd, glint_error *err);

/* What a complete FST file holds; GLINT_BAD_INPUT when it cannot be read: one that was not closed,
 * or cut short. */
typedef struct glint_wave_info {
    uint64_t first_time, last_time; /* ns */
    uint64_t signals;
} glint_wave_info;
glint_status glint_wave_read_info(const char *fst, glint_wave_info *info, glint_error *err);

#endif
