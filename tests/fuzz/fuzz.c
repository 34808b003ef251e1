/* What the fuzz targets share; see fuzz.h. */
#define _XOPEN_SOURCE 700

#include "fuzz.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define WORDS_MAX 32
#define NAMES_MAX 32

static char directory[256];
static char removed_later[NAMES_MAX][320];
static int removed_count;

void fuzz_expect(int condition, const char *text, const char *file, int line)
{
    if (!condition) {
        fprintf(stderr, "%s:%d: does not hold: %s\n", file, line, text);
        abort();
    }
}

static void remove_scratch(void)
{
    for (int i = 0; i < removed_count; i++)
        (void)unlink(removed_later[i]);
    (void)rmdir(directory);
}

const char *fuzz_scratch(const char *name)
{
    static char path[320];
    if (directory[0] == '\0') {
        const char *base = getenv("TMPDIR");
        snprintf(directory, sizeof directory, "%s/glint-fuzz-XXXXXX", base != NULL ? base : "/tmp");
        FUZZ_EXPECT(mkdtemp(directory) != NULL);
        FUZZ_EXPECT(atexit(remove_scratch) == 0);
    }
    snprintf(path, sizeof path, "%s/%s", directory, name);
    for (int i = 0; i < removed_count; i++)
        if (strcmp(removed_later[i], path) == 0)
            return path;
    FUZZ_EXPECT(removed_count < NAMES_MAX);
    strcpy(removed_later[removed_count++], path);
    return path;
}

const char *fuzz_write(const char *name, const uint8_t *bytes, size_t count)
{
    const char *path = fuzz_scratch(name);
    FILE *file = fopen(path, "wb");
    FUZZ_EXPECT(file != NULL);
    FUZZ_EXPECT(fwrite(bytes, 1, count, file) == count);
    FUZZ_EXPECT(fclose(file) == 0);
    return path;
}

size_t fuzz_first_line(const uint8_t *bytes, size_t count, char *line, size_t size)
{
    const uint8_t *end = count > 0 ? memchr(bytes, '\n', count) : NULL;
    const size_t length = end != NULL ? (size_t)(end - bytes) : count;
    const size_t kept = length < size ? length : size - 1;
    if (kept > 0)
        memcpy(line, bytes, kept);
    line[kept] = '\0';
    return end != NULL ? length + 1 : length;
}

uint8_t fuzz_take(const uint8_t **bytes, size_t *count)
{
    if (*count == 0)
        return 0;
    (*count)--;
    return *(*bytes)++;
}

static int split(char *options, char **argv)
{
    int argc = 1;
    char *rest = NULL;
    for (char *word = strtok_r(options, " ", &rest); word != NULL && argc < WORDS_MAX;
         word = strtok_r(NULL, " ", &rest))
        argv[argc++] = word;
    return argc;
}

/* glibc lets the three streams be others for a while. */
fuzz_run fuzz_command(int (*command)(int argc, char **argv), const char *name, char *options,
                      const uint8_t *bytes, size_t count)
{
    char *argv[WORDS_MAX + 1] = {(char *)(uintptr_t)name};
    const int argc = split(options, argv);
    FILE *const before[] = {stdin, stdout, stderr};
    fuzz_run done = {0};
    size_t out_size, err_size;
    stdin = fmemopen((void *)(uintptr_t)(count > 0 ? (const void *)bytes : ""),
                     count > 0 ? count : 1, "r");
    stdout = open_memstream(&done.out, &out_size);
    stderr = open_memstream(&done.err, &err_size);
    const bool opened = stdin != NULL && stdout != NULL && stderr != NULL;
    if (opened && count == 0)
        (void)getc(stdin); /* fmemopen() wants at least one byte */
    done.status = opened ? command(argc, argv) : 0;
    if (opened) {
        (void)fclose(stdin);
        (void)fclose(stdout);
        (void)fclose(stderr);
    }
    stdin = before[0];
    stdout = before[1];
    stderr = before[2];
    FUZZ_EXPECT(opened);
    return done;
}

void fuzz_forget(fuzz_run *done)
{
    free(done->out);
    free(done->err);
}

void fuzz_expect_outcome(const fuzz_run *done, const char *name)
{
    char begin[64];
    snprintf(begin, sizeof begin, "glint %s: ", name);
    FUZZ_EXPECT(done->status == 0 || done->status == 2);
    FUZZ_EXPECT((done->err[0] == '\0') == (done->status == 0));
    if (done->status == 2) {
        const char *end = strchr(done->err, '\n');
        FUZZ_EXPECT(strncmp(done->err, begin, strlen(begin)) == 0);
        FUZZ_EXPECT(end != NULL && end[1] == '\0');
        for (const char *c = done->err; c < end; c++)
            FUZZ_EXPECT((unsigned char)*c >= 0x20 && *c != 0x7f);
    }
}
