#include "wave/waveform.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gtkwave/fstapi.h> /* comes with Verilator */

#include "file/new_file.h"
#include "rtl/rtl.h"

static glint_status record_fst(const glint_specular_config *config, int first, int last,
                               const char *path, glint_error *err)
{
    glint_rtl *rtl;
    glint_specular_inputs inputs;
    glint_status status = glint_rtl_create(config, &rtl, err);
    for (int clock = 1; status == GLINT_OK && clock <= last; clock++) {
        if (clock == first)
            status = glint_rtl_trace_open(rtl, path, err);
        glint_wave_scene(clock, config->lanes, &inputs);
        glint_rtl_clock(rtl, &inputs);
    }
    glint_rtl_destroy(rtl);
    return status;
}

static glint_status rename_file(const char *from, const char *to, glint_error *err)
{
    if (rename(from, to) != 0)
        return glint_fail(err, GLINT_IO_ERROR, "%s: %s", to, strerror(errno));
    return GLINT_OK;
}

glint_status glint_wave_record(const glint_specular_config *config, glint_wave_format format,
                               int first, int last, const char *path, glint_error *err)
{
    char part[4096];
    int length = snprintf(part, sizeof part, "%s.part", path);
    if (length < 0 || (size_t)length >= sizeof part)
        return glint_fail(err, GLINT_IO_ERROR, "%s: the name is too long", path);
    glint_status status = record_fst(config, first, last, part, err);
    glint_wave_info info;
    if (status == GLINT_OK) /* a full disk shows here: Verilator's writer does not tell */
        status = glint_wave_read_info(part, &info, err);
    if (status == GLINT_OK)
        status = format == GLINT_WAVE_VCD ? glint_wave_fst_to_vcd(part, path, err)
                                          : rename_file(part, path, err);
    (void)remove(part);
    return status;
}

static void *open_fst(const char *path, glint_error *err)
{
    void *reader = fstReaderOpen(path);
    if (reader == NULL)
        (void)glint_fail(err, GLINT_BAD_INPUT, "%s: no readable FST waveform", path);
    return reader;
}

glint_status glint_wave_read_info(const char *fst, glint_wave_info *info, glint_error *err)
{
    void *reader = open_fst(fst, err);
    if (reader == NULL)
        return GLINT_BAD_INPUT;
    info->first_time = fstReaderGetStartTime(reader);
    info->last_time = fstReaderGetEndTime(reader);
    info->signals = fstReaderGetVarCount(reader);
    fstReaderClose(reader);
    return GLINT_OK;
}

glint_status glint_wave_fst_to_vcd(const char *fst, const char *vcd, glint_error *err)
{
    glint_new_file *file;
    void *reader = open_fst(fst, err);
    if (reader == NULL)
        return GLINT_BAD_INPUT;
    glint_status status = glint_new_file_open(vcd, &file, err);
    if (status == GLINT_OK) {
        FILE *out = glint_new_file_stream(file);
        fstReaderProcessHier(reader, out);
        fstReaderSetFacProcessMaskAll(reader);
        int read = fstReaderIterBlocks(reader, NULL, NULL, out);
        if (read)
            status = glint_new_file_commit(file, err);
        else {
            glint_new_file_discard(file);
            status = glint_fail(err, GLINT_BAD_INPUT, "%s: the waveform is damaged", fst);
        }
    }
    fstReaderClose(reader);
    return status;
}
