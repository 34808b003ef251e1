/* Reads and hashes source files; see sources.h. */
#define _GNU_SOURCE /* asprintf */

#include "rtl/sources.h"

#include <dirent.h>
#include <errno.h>
#include <nettle/sha2.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Room for one more, with a copy of the name and of nothing else. */
static glint_status add_name(glint_sources *sources, const char *name, glint_source **added,
                             glint_error *err)
{
    const size_t count = (size_t)sources->count;
    glint_source *grown = realloc(sources->file, (count + 1) * sizeof *grown);
    if (grown != NULL)
        sources->file = grown;
    char *copy = grown != NULL ? strdup(name) : NULL;
    if (copy == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a circuit's sources");
    *added = &sources->file[sources->count++];
    **added = (glint_source){.name = copy};
    return GLINT_OK;
}

glint_status glint_sources_add(glint_sources *sources, const char *name, const char *text,
                               size_t size, glint_error *err)
{
    glint_source *added = NULL;
    glint_status status = add_name(sources, name, &added, err);
    if (status != GLINT_OK)
        return status;
    added->text = malloc(size + 1);
    if (added->text == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a circuit's sources");
    memcpy(added->text, text, size);
    added->text[size] = '\0';
    added->size = size;
    return GLINT_OK;
}

/* The rest of a stream; false with errno. */
static bool read_stream(FILE *in, char **text, size_t *size)
{
    char piece[16384];
    FILE *out = open_memstream(text, size);
    size_t got;
    if (out == NULL)
        return false;
    while ((got = fread(piece, 1, sizeof piece, in)) > 0)
        (void)fwrite(piece, 1, got, out);
    const bool failed = ferror(in) != 0 || ferror(out) != 0;
    return fclose(out) == 0 && !failed;
}

static glint_status open_file(const char *directory, const char *name, const char *mode,
                              char **path, FILE **file, glint_error *err)
{
    if (asprintf(path, "%s/%s", directory, name) < 0)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a path");
    *file = fopen(*path, mode);
    if (*file != NULL)
        return GLINT_OK;
    const glint_status status = glint_fail(err, GLINT_IO_ERROR, "%s: %s", *path, strerror(errno));
    free(*path);
    return status;
}

glint_status glint_text_read(const char *directory, const char *name, char **text, size_t *size,
                             glint_error *err)
{
    char *path;
    FILE *in;
    *text = NULL;
    glint_status status = open_file(directory, name, "rb", &path, &in, err);
    if (status != GLINT_OK)
        return status;
    if (!read_stream(in, text, size)) {
        status = glint_fail(err, GLINT_IO_ERROR, "%s: %s", path, strerror(errno));
        free(*text);
        *text = NULL;
    }
    (void)fclose(in);
    free(path);
    return status;
}

glint_status glint_text_write(const char *directory, const char *name, const char *text,
                              size_t size, glint_error *err)
{
    char *path;
    FILE *out;
    glint_status status = open_file(directory, name, "wb", &path, &out, err);
    if (status != GLINT_OK)
        return status;
    const bool written = fwrite(text, 1, size, out) == size;
    if (fclose(out) != 0 || !written)
        status = glint_fail(err, GLINT_IO_ERROR, "%s: %s", path, strerror(errno));
    free(path);
    return status;
}

glint_status glint_sources_read_file(glint_sources *sources, const char *directory,
                                     const char *name, glint_error *err)
{
    glint_source *added = NULL;
    const glint_status status = add_name(sources, name, &added, err);
    return status == GLINT_OK ? glint_text_read(directory, name, &added->text, &added->size, err)
                              : status;
}

static bool ends_so(const char *name, const char *const *endings)
{
    const size_t length = strlen(name);
    for (; *endings != NULL; endings++) {
        const size_t end = strlen(*endings);
        if (length > end && name[0] != '.' && strcmp(name + length - end, *endings) == 0)
            return true;
    }
    return false;
}

/* Not alphasort(): the same order in every language. */
static int by_name(const struct dirent **a, const struct dirent **b)
{
    return strcmp((*a)->d_name, (*b)->d_name);
}

glint_status glint_sources_read(glint_sources *sources, const char *directory,
                                const char *const *endings, glint_error *err)
{
    struct dirent **entry = NULL;
    glint_status status = GLINT_OK;
    const int before = sources->count;
    const int count = scandir(directory, &entry, NULL, by_name);
    if (count < 0)
        return glint_fail(err, GLINT_IO_ERROR, "%s: %s", directory, strerror(errno));
    for (int i = 0; i < count; i++) {
        if (status == GLINT_OK && ends_so(entry[i]->d_name, endings))
            status = glint_sources_read_file(sources, directory, entry[i]->d_name, err);
        free(entry[i]);
    }
    free(entry);
    if (status == GLINT_OK && sources->count == before)
        return glint_fail(err, GLINT_IO_ERROR, "%s: no %s file in this directory", directory,
                          endings[0]);
    return status;
}

glint_status glint_sources_write(const glint_sources *sources, const char *directory,
                                 glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int i = 0; status == GLINT_OK && i < sources->count; i++)
        if (!sources->file[i].is_data)
            status = glint_text_write(directory, sources->file[i].name, sources->file[i].text,
                                      sources->file[i].size, err);
    return status;
}

/* Where the word stands from `from` on, alone; NULL: nowhere before `end`. */
static const char *find_word(const char *from, const char *end, const char *word)
{
    static const char letters[] =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_$";
    const size_t length = strlen(word);
    while (from < end) {
        const size_t other = strcspn(from, letters);
        from += other;
        const size_t found = strspn(from, letters);
        if (found == 0 || from >= end)
            return NULL;
        if (found == length && memcmp(from, word, length) == 0)
            return from;
        from += found;
    }
    return NULL;
}

/* A declaration ends with the next direction, or with what ends them all. */
static const char *declaration_end(const char *from)
{
    static const char *const directions[] = {"input", "output", "inout"};
    const char *end = from + strcspn(from, ";)");
    for (size_t i = 0; i < sizeof directions / sizeof directions[0]; i++) {
        const char *next = find_word(from, end, directions[i]);
        end = next != NULL ? next : end;
    }
    return end;
}

bool glint_sources_have_inout(const glint_sources *sources, const char *port)
{
    static const char word[] = "inout";
    for (int i = 0; i < sources->count; i++) {
        const char *end = sources->file[i].text + strlen(sources->file[i].text);
        const char *at = find_word(sources->file[i].text, end, word);
        for (; at != NULL; at = find_word(at, end, word)) {
            at += sizeof word - 1;
            if (find_word(at, declaration_end(at), port) != NULL)
                return true;
        }
    }
    return false;
}

void glint_sources_free(glint_sources *sources)
{
    for (int i = 0; i < sources->count; i++) {
        free(sources->file[i].name);
        free(sources->file[i].text);
    }
    free(sources->file);
    *sources = (glint_sources){0};
}

static void finish(struct sha256_ctx *hash, char text[GLINT_HASH_TEXT])
{
    uint8_t digest[(GLINT_HASH_TEXT - 1) / 2];
    sha256_digest(hash, sizeof digest, digest);
    for (size_t i = 0; i < sizeof digest; i++)
        (void)snprintf(text + 2 * i, 3, "%02x", digest[i]);
}

void glint_sources_hash(const glint_sources *sources, char text[GLINT_HASH_TEXT])
{
    struct sha256_ctx hash;
    sha256_init(&hash);
    for (int i = 0; i < sources->count; i++) {
        const glint_source *source = &sources->file[i];
        const uint64_t size = source->size;
        sha256_update(&hash, strlen(source->name) + 1, (const uint8_t *)source->name);
        sha256_update(&hash, sizeof size, (const uint8_t *)&size);
        sha256_update(&hash, source->size, (const uint8_t *)source->text);
    }
    finish(&hash, text);
}

void glint_hash_bytes(const void *what, size_t size, char text[GLINT_HASH_TEXT])
{
    struct sha256_ctx hash;
    sha256_init(&hash);
    sha256_update(&hash, size, what);
    finish(&hash, text);
}
