/* A user's directory of C files becomes a shared object, built once per content and kept in the
 * cache; see own.h. */
#define _GNU_SOURCE /* asprintf */

#include "circuit/own.h"

#include <dlfcn.h>
#include <errno.h>
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "circuit/circuits.h"
#include "circuit/validate.h"
#include "rtl/cache.h"
#include "rtl/place.h"
#include "rtl/sources.h"
#include "rtl/tools.h"

#define SYMBOL    "glint_my_circuit"
#define TWICE     "multiple definition of `" SYMBOL
#define MADE      "circuit.so"
#define FLAGS_MAX 8
#define KEPT      64 /* objects, of all directories; loaded ones stay */

/* A user's directory on its way to a shared object. */
typedef struct own {
    const char *directory;
    char *full; /* the same from / on */
    char *headers, *cache;
    glint_sources sources; /* the directory's own */
    glint_sources all;     /* and Glint's headers: what the object's name is a hash of */
    glint_tool compiler;   /* $CC, else cc */
    glint_cache_entry entry;
    char *object; /* its path in the cache */
} own;

/* What the object depends on besides its sources. */
static const char *const flags[FLAGS_MAX] = {"-std=gnu17", "-O2",         "-g", "-fPIC",
                                             "-shared",    "-Wl,-z,defs", NULL};

static glint_status no_memory(glint_error *err)
{
    return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the user's circuit");
}

/* ---- What it is made of -----------------------------------------------------------------------
 */

static glint_status read_sources(own *o, glint_error *err)
{
    static const char *const code[] = {".c", NULL}, *const headers[] = {".h", NULL};
    static const char *const either[] = {".c", ".h", NULL};
    glint_sources code_alone = {0};
    glint_status status = glint_sources_read(&code_alone, o->directory, code, err);
    glint_sources_free(&code_alone);
    if (status == GLINT_OK)
        status = glint_sources_read(&o->sources, o->directory, either, err);
    if (status == GLINT_OK)
        status = glint_sources_read(&o->all, o->directory, either, err);
    if (status == GLINT_OK)
        status = glint_sources_read(&o->all, o->headers, headers, err);
    return status;
}

static glint_status choose_compiler(own *o, glint_error *err)
{
    const char *told = getenv("CC");
    glint_status status = GLINT_OK;
    if (told != NULL && told[0] != '\0')
        status = glint_tool_find("CC", told, &o->compiler, err);
    else if (glint_tool_find("CC", "cc", &o->compiler, NULL) != GLINT_OK)
        status = glint_fail(err, GLINT_IO_ERROR,
                            "no C compiler was found: install one (Debian: apt-get install gcc) or "
                            "set CC");
    for (int i = 0; status == GLINT_OK && o->compiler.word[i] != NULL; i++)
        status = glint_sources_add(&o->all, "compiler", o->compiler.word[i],
                                   strlen(o->compiler.word[i]), err);
    for (int i = 0; flags[i] != NULL && status == GLINT_OK; i++)
        status = glint_sources_add(&o->all, "flag", flags[i], strlen(flags[i]), err);
    return status;
}

static glint_status find_all(own *o, glint_error *err)
{
    o->full = realpath(o->directory, NULL);
    if (o->full == NULL)
        return glint_fail(err, GLINT_IO_ERROR, "%s: %s", o->directory, strerror(errno));
    glint_status status = glint_place_headers(&o->headers, err);
    if (status == GLINT_OK)
        status = glint_place_cache(&o->cache, err);
    if (status == GLINT_OK)
        status = read_sources(o, err);
    return status == GLINT_OK ? choose_compiler(o, err) : status;
}

/* ---- Compiling --------------------------------------------------------------------------------
 */

/* The first line of a compiler's or a linker's output that gives the reason. */
static const char *reason_in(const char *said)
{
    static const char *const reasons[] = {"multiple definition of", "undefined reference to",
                                          "error: "};
    const char *found = NULL;
    for (size_t i = 0; i < sizeof reasons / sizeof reasons[0] && found == NULL; i++)
        found = strstr(said, reasons[i]);
    if (found == NULL)
        return said;
    while (found > said && found[-1] != '\n')
        found--;
    return found;
}

static void add_files(const own *o, glint_arguments *line)
{
    for (int i = 0; i < o->sources.count; i++)
        if (o->sources.file[i].name[strlen(o->sources.file[i].name) - 1] == 'c')
            glint_arguments_add(line, o->sources.file[i].name);
}

static glint_status refuse(const own *o, const char *said, glint_error *err)
{
    const char *reason = reason_in(said);
    if (said[0] == '\0')
        return glint_fail(err, GLINT_BAD_INPUT,
                          "%s: the C files do not compile: %s gives no reason; is it a C compiler?",
                          o->directory, o->compiler.word[0]);
    return glint_fail(err, GLINT_BAD_INPUT, "%s: the C files do not compile: %.*s", o->directory,
                      (int)strcspn(reason, "\n"), reason);
}

static glint_status run_compiler(own *o, const char *include, const char *map, glint_error *err)
{
    bool success = false;
    char *said = NULL;
    glint_arguments line = {.count = 0};
    glint_tool_add(&o->compiler, &line);
    glint_arguments_add_all(&line, flags);
    glint_arguments_add_all(&line, (const char *const[]){include, map, "-o", MADE, NULL});
    add_files(o, &line);
    glint_arguments_add(&line, "-lm");
    glint_status status = glint_command_run(line.word, o->entry.work, &success, &said, err);
    if (status == GLINT_OK && !success && strstr(said, TWICE) != NULL) {
        status = glint_fail(err, GLINT_BAD_INPUT,
                            "%s: two C files define " SYMBOL ", but a directory holds one circuit",
                            o->directory);
    } else if (status == GLINT_OK && !success) {
        status = refuse(o, said, err);
    }
    free(said);
    return status;
}

/* "-I/a/b", "-ffile-prefix-map=/a=/b"; NULL: no memory. To be freed. */
static char *option(const char *name, const char *first, const char *second)
{
    char *text;
    return asprintf(&text, "%s%s%s", name, first, second) < 0 ? NULL : text;
}

/* In the cache's work directory, from what was read and hashed; a debugger finds the files where
 * they are. */
static glint_status compile(own *o, glint_error *err)
{
    glint_status status = glint_sources_write(&o->sources, o->entry.work, err);
    if (status != GLINT_OK)
        return status;
    char *include = option("-I", o->headers, "");
    char *from = option("-ffile-prefix-map=", o->entry.work, "=");
    char *map = from != NULL ? option("", from, o->full) : NULL;
    status = include != NULL && map != NULL ? run_compiler(o, include, map, err) : no_memory(err);
    if (status == GLINT_OK)
        status = glint_cache_commit(&o->entry, MADE, err);
    if (status == GLINT_OK)
        glint_cache_prune(o->cache, "own-", ".so", KEPT, 0);
    free(include);
    free(from);
    free(map);
    return status;
}

/* ---- Loading ----------------------------------------------------------------------------------
 */

/* The lock is given back before any of the user's code runs, as that may end the program. */
static glint_status make_object(own *o, glint_error *err)
{
    char hash[GLINT_HASH_TEXT], name[GLINT_HASH_TEXT + 16];
    glint_sources_hash(&o->all, hash);
    (void)snprintf(name, sizeof name, "own-%s.so", hash);
    glint_status status = glint_cache_open(o->cache, name, &o->entry, err);
    if (status == GLINT_OK && o->entry.work != NULL)
        status = compile(o, err);
    if (status == GLINT_OK && (o->object = strdup(o->entry.path)) == NULL)
        status = no_memory(err);
    glint_cache_close(&o->entry);
    return status;
}

/* It stays loaded: settings point into it. */
static glint_status load_object(const own *o, const glint_circuit **circuit, glint_error *err)
{
    glint_error found;
    void *object = dlopen(o->object, RTLD_NOW | RTLD_LOCAL);
    if (object == NULL)
        return glint_fail(err, GLINT_BAD_INPUT, "%s: %s", o->directory, dlerror());
    *circuit = dlsym(object, SYMBOL);
    if (*circuit == NULL)
        return glint_fail(
            err, GLINT_BAD_INPUT,
            "%s: none of the *.c files defines the circuit, const glint_circuit " SYMBOL,
            o->directory);
    const glint_status status = glint_circuit_check(*circuit, &found);
    if (status != GLINT_OK)
        return glint_fail(err, status, "%s: %s", o->directory, found.text);
    glint_circuit_add(*circuit);
    return GLINT_OK;
}

glint_status glint_circuit_load(const char *directory, const glint_circuit **circuit,
                                glint_error *err)
{
    own o = {.directory = directory, .entry = {.lock = -1}};
    glint_status status = find_all(&o, err);
    if (status == GLINT_OK)
        status = make_object(&o, err);
    if (status == GLINT_OK)
        status = load_object(&o, circuit, err);
    glint_tool_free(&o.compiler);
    glint_sources_free(&o.sources);
    glint_sources_free(&o.all);
    free(o.full);
    free(o.headers);
    free(o.cache);
    free(o.object);
    return status;
}
