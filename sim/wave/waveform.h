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

/* Writes a waveform with `record`, which runs a circuit tracing to the given temporary path; then
 * checks that the file is complete and renames it. */
typedef glint_status glint_wave_recorder(const void *context, const char *path, glint_error *err);
glint_status glint_wave_write(const char *path, glint_wave_format format,
                              glint_wave_recorder *record, const void *context, glint_error *err);

/* Runs the scene on the circuit and writes the waveform of the clocks first…last (1 ≤ first ≤ last
 * ≤ scene->clocks) to path, beside and then renamed. */
glint_status glint_wave_record(const glint_setting *setting, const glint_wave_scene *scene,
                               glint_wave_format format, int first, int last, const char *path,
                               glint_error *err);

/* Space to require, with glint_file_room(), before a waveform is opened: the FST writer maps its
 * temporary files into memory, and on a full disk touching them would kill the program. About ten
 * times what the scenes here need. */
#define GLINT_WAVE_ROOM (1L << 20)

/* Whether a file is a complete FST: closed properly and not truncated. Its content is not
 * checked. */
bool glint_wave_is_whole(const char *fst);

#endif
