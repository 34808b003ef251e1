/* Records a scene into an FST or VCD file and checks that the file is complete. */
#define _POSIX_C_SOURCE 200809L

#include "wave/waveform.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "file/new_file.h"
#include "file/room.h"
#include "file/temporary.h"
#include "rtl/rtl.h"

/* What record_scene() is to run. */
typedef struct recording {
    const glint_setting *setting;
    const glint_wave_scene *scene;
    glint_rtl_kind kind;
    int first, last;
} recording;

static glint_status record_scene(const void *context, const char *path, glint_error *err)
{
    const recording *of = context;
    glint_rtl *rtl = NULL;
    glint_status status = glint_rtl_open(of->setting, of->kind, &rtl, err);
    for (int clock = 1; status == GLINT_OK && clock <= of->last; clock++) {
        if (clock == of->first)
            status = glint_file_room(path, GLINT_WAVE_ROOM, err);
        if (clock == of->first && status == GLINT_OK)
            status = glint_rtl_trace_open(rtl, path, err);
        if (status == GLINT_OK)
            glint_rtl_clock(rtl, &of->scene->pins[clock - 1]);
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

/* Errors about the temporary file are reported with the requested name. */
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

/* An FST file is a sequence of blocks: a type byte, a length, the content. They fill the file
 * exactly, and a writer that finished has left these. */
enum {
    HEADER = 0,
    GEOMETRY = 3,
    HIERARCHY = 4, /* or, packed otherwise: */
    HIERARCHY_LZ4 = 6,
    HIERARCHY_LZ4_TWICE = 7,
    UNFINISHED = 255, /* being written */
};

/* The eight bytes of a block's length, the highest first. */
static uint64_t read_length(FILE *file)
{
    uint64_t length = 0;
    for (int i = 0; i < 8; i++)
        length = length << 8 | (uint64_t)(fgetc(file) & 0xff);
    return length;
}

static bool has_whole_blocks(FILE *file)
{
    bool header = false, geometry = false, hierarchy = false;
    if (fseeko(file, 0, SEEK_END) != 0)
        return false;
    const int64_t size = ftello(file);
    int64_t at = 0;
    while (at < size) {
        const int kind = fseeko(file, at, SEEK_SET) == 0 ? fgetc(file) : EOF;
        const uint64_t length = read_length(file);
        if (kind == EOF || kind == UNFINISHED || length < 8 || length > (uint64_t)(size - at - 1))
            return false;
        header |= at == 0 && kind == HEADER;
        geometry |= kind == GEOMETRY;
        hierarchy |= kind == HIERARCHY || kind == HIERARCHY_LZ4 || kind == HIERARCHY_LZ4_TWICE;
        at += 1 + (int64_t)length;
    }
    return header && geometry && hierarchy;
}

bool glint_wave_is_whole(const char *fst)
{
    FILE *file = fopen(fst, "rb");
    const bool whole = file != NULL && has_whole_blocks(file);
    if (file != NULL)
        (void)fclose(file);
    return whole;
}

/* A file system that ran out of space leaves it empty. */
static bool is_whole_vcd(const char *path)
{
    struct stat found;
    return stat(path, &found) == 0 && found.st_size > 0;
}

/* A full disk shows here: Verilator's writers do not tell. */
static glint_status check_whole(const char *path, glint_wave_format format, glint_error *err)
{
    const bool whole = format == GLINT_WAVE_FST ? glint_wave_is_whole(path) : is_whole_vcd(path);
    return whole ? GLINT_OK
                 : glint_fail(err, GLINT_IO_ERROR, "%s: the waveform is incomplete", path);
}

glint_status glint_wave_write(const char *path, glint_wave_format format,
                              glint_wave_recorder *record, const void *context, glint_error *err)
{
    char *part = glint_temporary_name(path, GLINT_TEMPORARY_WAVE);
    if (part == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a path");
    glint_temporary_sweep(path);
    glint_status status = record(context, part, err);
    if (status == GLINT_OK)
        status = check_whole(part, format, err);
    if (status == GLINT_OK)
        status = copy_file(part, path, err);
    if (status != GLINT_OK)
        name_target(part, path, err);
    (void)remove(part);
    free(part);
    return status;
}

glint_status glint_wave_record(const glint_setting *setting, const glint_wave_scene *scene,
                               glint_wave_format format, int first, int last, const char *path,
                               glint_error *err)
{
    const recording recording = {
        setting, scene, format == GLINT_WAVE_VCD ? GLINT_RTL_VCD : GLINT_RTL_FST, first, last};
    return glint_wave_write(path, format, record_scene, &recording, err);
}
