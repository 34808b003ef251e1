/* Waveforms as files. */
#ifndef GLINT_SIM_WAVE_WAVEFORM_H
#define GLINT_SIM_WAVE_WAVEFORM_H

#include <stdbool.h>

#include "wave/scene.h"

typedef enum glint_wave_format {
    GLINT_WAVE_FST,
    GLINT_WAVE_VCD,
    GLINT_WAVE_FORMAT_COUNT
} glint_wave_format;

/* Writes a waveform by `record`, which runs a circuit with its trace open on the path it is given:
 * beside, looked through whether all of it arrived, then renamed. */
typedef glint_status glint_wave_recorder(const void *context, const char *path, glint_error *err);
glint_status glint_wave_write(const char *path, glint_wave_format format,
                              glint_wave_recorder *record, const void *context, glint_error *err);

/* Runs the scene on the circuit and writes the waveform of the clocks first…last (1 ≤ first ≤ last
 * ≤ scene->clocks) to path, beside and then renamed. */
glint_status glint_wave_record(const glint_setting *setting, const glint_wave_scene *scene,
                               glint_wave_format format, int first, int last, const char *path,
                               glint_error *err);

/* Room to be there, with glint_file_room(), before a waveform is opened: the FST writer maps its
 * temporary files into memory, and on a full disk touching them would end the program. Some ten
 * times what the windows written here take. */
#define GLINT_WAVE_ROOM (1L << 20)

/* Whether a file is a complete FST: one that was closed, and is not cut short. What is in it is for
 * others to read. */
bool glint_wave_is_whole(const char *fst);

#endif
