/* A test's own directory: created by the group's setup, removed with its contents by the teardown.
 * Include it after cmocka.h; the file that does defines _XOPEN_SOURCE 700 first. */
#ifndef GLINT_TESTS_SCRATCH_H
#define GLINT_TESTS_SCRATCH_H

#include <dirent.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char scratch_directory[512];

static inline int scratch_make(void **state)
{
    (void)state;
    const char *base = getenv("TMPDIR");
    snprintf(scratch_directory, sizeof scratch_directory, "%s/glint-test-XXXXXX",
             base != NULL ? base : P_tmpdir);
    return mkdtemp(scratch_directory) != NULL ? 0 : -1;
}

static inline int scratch_remove_entry(const char *path, const struct stat *info, int type,
                                       struct FTW *place)
{
    (void)info;
    (void)type;
    (void)place;
    return remove(path);
}

static inline int scratch_remove(void **state)
{
    (void)state;
    return nftw(scratch_directory, scratch_remove_entry, 8, FTW_DEPTH | FTW_PHYS);
}

/* The path of a name in the directory; the last four results stay valid. */
static inline const char *scratch_path(const char *name)
{
    static char path[4][1024];
    static int next;
    next = (next + 1) % 4;
    snprintf(path[next], sizeof path[next], "%s/%s", scratch_directory, name);
    return path[next];
}

/* How many entries the directory holds, hidden ones too. */
static inline int scratch_count(void)
{
    int count = -2; /* "." and ".." */
    DIR *directory = opendir(scratch_directory);
    assert_non_null(directory);
    while (readdir(directory) != NULL)
        count++;
    closedir(directory);
    return count;
}

static inline void scratch_write(const char *path, const void *bytes, size_t count)
{
    FILE *stream = fopen(path, "wb");
    assert_non_null(stream);
    assert_int_equal(fwrite(bytes, 1, count, stream), count);
    assert_int_equal(fclose(stream), 0);
}

/* The file's bytes with a NUL after them, to be freed; *count (may be NULL) without it. */
static inline char *scratch_read(const char *path, size_t *count)
{
    FILE *stream = fopen(path, "rb");
    assert_non_null(stream);
    assert_int_equal(fseek(stream, 0, SEEK_END), 0);
    const long size = ftell(stream);
    assert_true(size >= 0);
    rewind(stream);
    char *bytes = malloc((size_t)size + 1);
    assert_non_null(bytes);
    assert_int_equal(fread(bytes, 1, (size_t)size, stream), size);
    bytes[size] = '\0';
    fclose(stream);
    if (count != NULL)
        *count = (size_t)size;
    return bytes;
}

#endif
