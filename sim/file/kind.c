/* Recognises a file by its first bytes, so that only output of the same kind is overwritten. */
#define _POSIX_C_SOURCE 200809L

#include "file/kind.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#define LONGEST 16

typedef struct kind {
    const char *ending, *name;
    const char *begins;
    size_t length;
} kind;

#define BEGINS(text) text, sizeof text - 1

/* An FST file's first block is its header, of 329 bytes. */
static const kind kinds[] = {
    {".png", "PNG picture", BEGINS("\x89PNG\r\n\x1a\n")},
    {".fst", "FST waveform", BEGINS("\0\0\0\0\0\0\0\x01\x49")},
    {".vcd", "VCD waveform", BEGINS("$")},
    {".gtkw", "GTKWave save file", BEGINS("[")},
    {".csv", "table by n", BEGINS("n,")},
    {".json", "JSON object", BEGINS("{")},
    {".md", "Markdown document", BEGINS("#")},
    {".svg", "drawing", BEGINS("<svg")},
    {".dot", "graph", BEGINS("digraph ")},
    {".3ds", "3DS mesh", BEGINS("MM")},
    {".glb", "binary glTF mesh", BEGINS("glTF")},
    {".ply", "PLY mesh", BEGINS("ply")},
    {".obj", "OBJ mesh of assimp's", BEGINS("# File produced ")},
    {".stl", "STL mesh of assimp's", BEGINS("AssimpScene")},
    {".html", "HTML document", BEGINS("<!DOCTYPE html>")},
};

static const kind *kind_of(const char *path)
{
    const char *ending = strrchr(path, '.');
    for (size_t i = 0; ending != NULL && i < sizeof kinds / sizeof kinds[0]; i++)
        if (strcasecmp(ending, kinds[i].ending) == 0)
            return &kinds[i];
    return NULL;
}

/* Also true when it cannot be read. */
static bool begins_as(const char *path, const kind *kind)
{
    char found[LONGEST];
    FILE *file = kind != NULL ? fopen(path, "rb") : NULL;
    if (file == NULL)
        return kind != NULL;
    const size_t count = fread(found, 1, kind->length, file);
    (void)fclose(file);
    return count == kind->length && memcmp(found, kind->begins, count) == 0;
}

glint_status glint_file_replaceable(const char *path, glint_error *err)
{
    struct stat info;
    const kind *kind = kind_of(path);
    if (stat(path, &info) != 0 || !S_ISREG(info.st_mode) || info.st_size == 0 ||
        begins_as(path, kind))
        return GLINT_OK;
    return glint_fail(err, GLINT_BAD_ARGUMENT,
                      "%.400s exists and is not a %s: use another name or --force", path,
                      kind != NULL ? kind->name : "file of this kind");
}
