/* Finds the names of files in strings of Verilog, and puts the files where the compiler takes them
 * from; see data.h. */
#define _POSIX_C_SOURCE 200809L

#include "rtl/data.h"

#include <string.h>
#include <sys/stat.h>

#define NAME_SIZE 256

/* Verilog is included, not read. */
static bool is_verilog(const char *name)
{
    static const char *const endings[] = {".v", ".vh", ".sv", ".svh"};
    const char *end = strrchr(name, '.');
    for (size_t i = 0; end != NULL && i < sizeof endings / sizeof endings[0]; i++)
        if (strcmp(end, endings[i]) == 0)
            return true;
    return false;
}

static bool is_added(const glint_sources *sources, const char *name)
{
    for (int i = 0; i < sources->count; i++)
        if (sources->file[i].is_data && strcmp(sources->file[i].name, name) == 0)
            return true;
    return false;
}

static bool is_file(const char *directory, const char *name)
{
    struct stat found;
    char path[4096];
    const int length = snprintf(path, sizeof path, "%s/%s", directory, name);
    return length > 0 && (size_t)length < sizeof path && stat(path, &found) == 0 &&
           S_ISREG(found.st_mode);
}

/* Whether what stands between two quotes can be a name; *name: it. A backslash begins a code. */
static bool is_name(const char *from, char name[NAME_SIZE])
{
    const size_t length = strcspn(from, "\"\\\n");
    if (length == 0 || length >= NAME_SIZE || from[length] != '"' || from[0] == '/')
        return false;
    memcpy(name, from, length);
    name[length] = '\0';
    return !is_verilog(name);
}

/* A file that $fopen() empties, or makes, is no source: what an earlier run left in it must not
 * build the circuit anew. *at: behind the quote that begins the name. */
static bool is_written_by(const char *text, const char *at)
{
    static const char call[] = "$fopen";
    const size_t length = sizeof call - 1;
    const char *before = at - 1;
    while (before > text && strchr(" \t\n(", before[-1]) != NULL)
        before--;
    if ((size_t)(before - text) < length || memcmp(before - length, call, length) != 0)
        return false;
    const char *after = at + strcspn(at, "\"") + 1;
    after += strspn(after, " \t\n");
    if (*after == ')')
        return true; /* without a mode: as "w" */
    after += strspn(after, ", \t\n");
    return strncmp(after, "\"w", 2) == 0;
}

/* Behind each quote, as a comment may have a single one: what is no string is no file either. */
static glint_status read_named(glint_sources *sources, int by, const char *directory,
                               glint_error *err)
{
    char name[NAME_SIZE];
    glint_status status = GLINT_OK;
    const char *at = sources->file[by].text;
    while (status == GLINT_OK && (at = strchr(at, '"')) != NULL)
        if (is_name(++at, name) && !is_written_by(sources->file[by].text, at) &&
            !is_added(sources, name) && is_file(directory, name)) {
            status = glint_sources_read_file(sources, directory, name, err);
            sources->file[sources->count - 1].is_data = status == GLINT_OK;
        }
    return status;
}

glint_status glint_data_read(glint_sources *sources, const char *directory, glint_error *err)
{
    const int count = sources->count;
    glint_status status = GLINT_OK;
    for (int i = 0; status == GLINT_OK && i < count; i++)
        status = read_named(sources, i, directory, err);
    return status;
}

int glint_data_count(const glint_sources *sources)
{
    int count = 0;
    for (int i = 0; i < sources->count; i++)
        count += sources->file[i].is_data;
    return count;
}

glint_status glint_data_write(const glint_sources *sources, const char *directory, glint_error *err)
{
    int index = 0;
    glint_status status = GLINT_OK;
    for (int i = 0; status == GLINT_OK && i < sources->count; i++) {
        char name[32];
        if (!sources->file[i].is_data)
            continue;
        (void)snprintf(name, sizeof name, "glint_data_%d", index++);
        status =
            glint_text_write(directory, name, sources->file[i].text, sources->file[i].size, err);
    }
    return status;
}

void glint_data_print(const glint_sources *sources, FILE *out)
{
    int index = 0;
    for (int i = 0; i < sources->count; i++)
        if (sources->file[i].is_data) {
            fputs(index == 0 ? "#define GLINT_DATA(X)" : "", out);
            fprintf(out, " \\\n    X(%d, \"%s\")", index++, sources->file[i].name);
        }
    fputs(index > 0 ? "\n" : "", out);
}
