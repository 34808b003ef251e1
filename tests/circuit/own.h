/* Runs the command on a directory with a user's circuit, and on modified copies of it. Include it
 * after cmocka.h, ../scratch.h and ../cli/run.h. */
#ifndef GLINT_TESTS_CIRCUIT_OWN_H
#define GLINT_TESTS_CIRCUIT_OWN_H

#define OWN_PATH 1024

/* A directory of the scratch directory, made. */
static inline void own_make(const char *name, char path[OWN_PATH])
{
    assert_true(snprintf(path, OWN_PATH, "%s/%s", scratch_directory, name) < OWN_PATH);
    assert_int_equal(mkdir(path, 0777), 0);
}

/* A file of a directory, in an edited copy: the one place that has `from` gets `to`. */
static inline void own_edit(const char *directory, const char *file, const char *from,
                            const char *to)
{
    char path[OWN_PATH + 300];
    (void)snprintf(path, sizeof path, "%s/%s", directory, file);
    char *text = scratch_read(path, NULL);
    char *place = strstr(text, from);
    if (place == NULL || strstr(place + 1, from) != NULL)
        fail_msg("%s: \"%s\" is not there once", path, from);
    FILE *stream = fopen(path, "wb");
    assert_non_null(stream);
    assert_true(fprintf(stream, "%.*s%s%s", (int)(place - text), text, to, place + strlen(from)) >
                0);
    assert_int_equal(fclose(stream), 0);
    free(text);
}

/* A copy of a directory's files, in a directory of the scratch directory. */
static inline void own_copy(const char *from, const char *name, char path[OWN_PATH])
{
    char file[OWN_PATH + 300];
    size_t size;
    const struct dirent *entry;
    own_make(name, path);
    DIR *listing = opendir(from);
    assert_non_null(listing);
    while ((entry = readdir(listing)) != NULL) {
        if (entry->d_name[0] == '.')
            continue;
        (void)snprintf(file, sizeof file, "%s/%s", from, entry->d_name);
        char *text = scratch_read(file, &size);
        (void)snprintf(file, sizeof file, "%s/%s", path, entry->d_name);
        scratch_write(file, text, size);
        free(text);
    }
    closedir(listing);
}

/* glint --circuit-dir DIRECTORY, and the rest of its line. */
static inline outcome own_run(const char *directory, const char *input, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static inline outcome own_run(const char *directory, const char *input, const char *format, ...)
{
    char line[2048];
    const int length = snprintf(line, sizeof line, "--circuit-dir %s ", directory);
    va_list arguments;
    va_start(arguments, format);
    const int rest = vsnprintf(line + length, sizeof line - (size_t)length, format, arguments);
    va_end(arguments);
    assert_true(length + rest < (int)sizeof line);
    return run(line, input);
}

/* One line on standard error that has these words, nothing on standard output, exit status 2. */
static inline void assert_own_refused(const outcome *done, const char *words)
{
    const char *end = strchr(done->err, '\n');
    if (done->status != 2 || done->out[0] != '\0' || end == NULL || end[1] != '\0' ||
        strncmp(done->err, "glint", 5) != 0 || strstr(done->err, words) == NULL) {
        fail_msg("exit status %d, standard output \"%s\", standard error \"%s\"; expected one line "
                 "with \"%s\"",
                 done->status, done->out, done->err, words);
    }
}

/* The one entry of a directory: the packet in the directory for packets. */
static inline void own_only_entry(const char *directory, char path[OWN_PATH])
{
    int count = 0;
    const struct dirent *entry;
    DIR *listing = opendir(directory);
    assert_non_null(listing);
    while ((entry = readdir(listing)) != NULL) {
        if (entry->d_name[0] != '.') {
            (void)snprintf(path, OWN_PATH, "%.700s/%.300s", directory, entry->d_name);
            count++;
        }
    }
    closedir(listing);
    assert_int_equal(count, 1);
}

#endif
