#define _POSIX_C_SOURCE 200809L

#include "wave/waveform.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gtkwave/fstapi.h> /* comes with Verilator */

#include "file/new_file.h"
#include "file/room.h"
#include "file/temporary.h"
#include "rtl/rtl.h"

/* What record_scene() is to run. */
typedef struct scene {
    const glint_specular_config *config;
    int first, last;
} scene;

static glint_status record_scene(const void *context, const char *path, glint_error *err)
{
    const scene *scene = context;
    glint_rtl *rtl;
    glint_specular_inputs inputs;
    glint_status status = glint_rtl_create(scene->config, &rtl, err);
    for (int clock = 1; status == GLINT_OK && clock <= scene->last; clock++) {
        if (clock == scene->first)
            status = glint_file_room(path, GLINT_WAVE_ROOM, err);
        if (clock == scene->first && status == GLINT_OK)
            status = glint_rtl_trace_open(rtl, path, err);
        glint_wave_scene(clock, scene->config->lanes, &inputs);
        glint_rtl_clock(rtl, &inputs);
    }
    glint_rtl_destroy(rtl);
    return status;
}

/* The bytes of a file as a new one: a name that is a link, or there already, is treated as any
 * output's is. */
static glint_status copy_file(const char *from, const char *to, glint_error *err)
{
    char bytes[1 << 16];
    size_t count;
    glint_new_file *file;
    FILE *in = fopen(from, "rb");
    if (in == NULL)
        return glint_fail(err, GLINT_IO_ERROR, "%s: %s", from, strerror(errno));
    glint_status status = glint_new_file_open(to, &file, err);
    if (status == GLINT_OK) {
        while ((count = fread(bytes, 1, sizeof bytes, in)) > 0)
            (void)fwrite(bytes, 1, count, glint_new_file_stream(file));
        if (!ferror(in))
            status = glint_new_file_commit(file, err);
        else {
            status = glint_fail(err, GLINT_IO_ERROR, "%s: %s", from, strerror(errno));
            glint_new_file_discard(file);
        }
    }
    (void)fclose(in);
    return status;
}

/* What went wrong with the file in the making is told of the one that was asked for. */
static void name_target(const char *part, const char *path, glint_error *err)
{
    glint_error told;
    const char *at = err != NULL ? strstr(err->text, part) : NULL;
    if (at == NULL)
        return;
    (void)glint_fail(&told, GLINT_IO_ERROR, "%.*s%.400s%s", (int)(at - err->text), err->text, path,
                     at + strlen(part));
    *err = told;
}

glint_status glint_wave_write(const char *path, glint_wave_format format,
                              glint_wave_recorder *record, const void *context, glint_error *err)
{
    char *part = glint_temporary_name(path, GLINT_TEMPORARY_WAVE);
    if (part == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for a path");
    glint_temporary_sweep(path);
    glint_status status = record(context, part, err);
    glint_wave_info info;
    if (status == GLINT_OK) /* a full disk shows here: Verilator's writer does not tell */
        status = glint_wave_read_info(part, &info, err);
    if (status == GLINT_OK)
        status = format == GLINT_WAVE_VCD ? glint_wave_fst_to_vcd(part, path, err)
                                          : copy_file(part, path, err);
    if (status != GLINT_OK)
        name_target(part, path, err);
    (void)remove(part);
    free(part);
    return status;
}

glint_status glint_wave_record(const glint_specular_config *config, glint_wave_format format,
                               int first, int last, const char *path, glint_error *err)
{
    const scene scene = {config, first, last};
    return glint_wave_write(path, format, record_scene, &scene, err);
}

/* The eight bytes of a block's length, the highest first. */
static uint64_t read_length(FILE *file)
{
    uint64_t length = 0;
    for (int i = 0; i < 8; i++)
        length = length << 8 | (uint64_t)(fgetc(file) & 0xff);
    return length;
}

/* An FST file is blocks, one after the other: a byte that says which, its length, its content. They
 * must fill the file exactly. fstapi does not look, and exits or worse on a file cut short. */
static bool has_whole_blocks(FILE *file)
{
    if (fseeko(file, 0, SEEK_END) != 0)
        return false;
    const int64_t size = ftello(file);
    int64_t at = 0;
    while (at < size) {
        if (fseeko(file, at, SEEK_SET) != 0 || fgetc(file) == FST_BL_SKIP)
            return false;
        const uint64_t length = read_length(file);
        if (length < 8 || length > (uint64_t)(size - at - 1))
            return false;
        at += 1 + (int64_t)length;
    }
    return size > 0;
}

static bool is_whole(const char *path)
{
    FILE *file = fopen(path, "rb");
    bool whole = file != NULL && has_whole_blocks(file);
    if (file != NULL)
        (void)fclose(file);
    return whole;
}

static void *open_fst(const char *path, glint_error *err)
{
    void *reader = is_whole(path) ? fstReaderOpen(path) : NULL;
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

typedef struct vcd_writer {
    FILE *out;
    uint64_t times; /* written so far */
    uint64_t time;  /* the last of them */
} vcd_writer;

/* A signal's name within the file, as fstReaderProcessHier() declares it: digits of base 94 that
 * count from 1. */
static const char *vcd_code(fstHandle signal, char *code)
{
    char *end = code;
    for (uint32_t rest = signal; rest != 0; rest /= 94) {
        rest--;
        *end++ = (char)('!' + rest % 94);
    }
    *end = '\0';
    return code;
}

/* The changes at the first time are the values that all signals begin with. */
static void write_time(vcd_writer *writer, uint64_t time)
{
    if (writer->times != 0 && writer->time == time)
        return;
    if (writer->times == 1)
        fprintf(writer->out, "$end\n");
    fprintf(writer->out, "#%" PRIu64 "\n", time);
    if (writer->times == 0)
        fprintf(writer->out, "$dumpvars\n");
    writer->times++;
    writer->time = time;
}

static void write_change(void *context, uint64_t time, fstHandle signal, const unsigned char *value)
{
    vcd_writer *writer = context;
    char code[8];
    write_time(writer, time);
    if (value[0] != '\0' && value[1] == '\0')
        fprintf(writer->out, "%s%s\n", (const char *)value, vcd_code(signal, code));
    else
        fprintf(writer->out, "b%s %s\n", (const char *)value, vcd_code(signal, code));
}

/* A variable that holds a text, as GTKWave writes it to VCD and reads it there. */
static void write_text(void *context, uint64_t time, fstHandle signal, const unsigned char *text,
                       uint32_t length)
{
    vcd_writer *writer = context;
    char code[8];
    write_time(writer, time);
    fprintf(writer->out, "s%.*s %s\n", (int)length, (const char *)text, vcd_code(signal, code));
}

/* fstReaderIterBlocks2() would write VCD itself, but past the stream, and does not tell whether it
 * all arrived. */
static bool write_changes(void *reader, FILE *out)
{
    vcd_writer writer = {.out = out};
    fstReaderSetFacProcessMaskAll(reader);
    if (!fstReaderIterBlocks2(reader, write_change, write_text, &writer, NULL) || writer.times == 0)
        return false;
    write_time(&writer, fstReaderGetEndTime(reader));
    return true;
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
        if (fstReaderProcessHier(reader, out) && write_changes(reader, out))
            status = glint_new_file_commit(file, err);
        else {
            glint_new_file_discard(file);
            status = glint_fail(err, GLINT_BAD_INPUT, "%s: the waveform is damaged", fst);
        }
    }
    fstReaderClose(reader);
    return status;
}
