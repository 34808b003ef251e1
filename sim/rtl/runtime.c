/* Compiles Verilator's runtime and precompiles its headers, once per toolchain; see runtime.h. */
#define _GNU_SOURCE /* asprintf */

#include "rtl/runtime.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "file/directory.h"
#include "file/new_file.h"
#include "file/temporary.h"
#include "rtl/cache.h"
#include "rtl/diagnosis.h"
#include "rtl/sources.h"

/* A build links what it needs from a runtime within minutes. */
enum { KEPT_RUNTIMES = 4, A_DAY = 24 * 60 * 60 };

/* What the Verilog prints ($display) must not come among a command's lines or its JSON. */
#define PRINT_BESIDE "-DVL_PRINTF(...)=fprintf(stderr, __VA_ARGS__)"

/* No warnings: Verilator's code is not ours to fix. By sections, so that the linker leaves out what
 * a circuit does not use: of 33 KB of thread-local data 128 bytes stay, which the loader can place
 * where they are accessed soonest. */
static const char *const common_flags[] = {
    "-std=gnu++17",        "-fPIC",
    "-fvisibility=hidden", "-w",
    "-ffunction-sections", "-fdata-sections",
    "-DVM_COVERAGE=0",     "-DVM_SC=0",
    "-DVM_TRACE=1",        "-DVM_TRACE_FST=1",
    "-DVM_TRACE_VCD=1",    "-DVL_USER_FATAL",
    "-DVL_USER_FINISH",    "-DVL_USER_WARN",
    PRINT_BESIDE,          NULL,
};
/* Only the part of the runtime that ends each evaluation affects a circuit's speed; optimising the
 * rest would double its compile time. */
static const char *const runtime_flags[] = {"-O0", NULL};
static const char timed_source[] = "/verilated.cpp";
static const char *const timed_flags[] = {"-O1", NULL};
/* A fast circuit is there for billions of clocks on this machine (-O3 gives nothing more, docs/ has
 * what was measured), any other for a first answer soon. */
static const char *const soon_flags[] = {"-O1", NULL};
static const char *const fast_flags[] = {"-O2", "-march=native", NULL};
/* Verilator's thread-local data is constant-initialised, so it can be accessed without a call to
 * initialise it, and by a descriptor instead of a call of __tls_get_addr: 7 % each of a clock at
 * one lane. clang does not have the flags; other processors have descriptors without being asked.
 */
static const char *const gcc_flags[] = {
    "-fno-extern-tls-init",
#ifdef __x86_64__
    "-mtls-dialect=gnu2",
#endif
    NULL,
};

const char *glint_rtl_kind_name(glint_rtl_kind kind)
{
    static const char *const names[] = {[GLINT_RTL_OBSERVED] = "observed",
                                        [GLINT_RTL_FAST] = "fast",
                                        [GLINT_RTL_FST] = "fst",
                                        [GLINT_RTL_VCD] = "vcd"};
    return names[kind];
}

static void begin_with(glint_arguments *line, const glint_tools *tools, const char *const *flags)
{
    *line = (glint_arguments){.count = 0};
    glint_tool_add(&tools->compiler, line);
    glint_arguments_add_all(line, common_flags);
    if (!glint_tools_are_clang(tools))
        glint_arguments_add_all(line, gcc_flags);
    glint_arguments_add_all(line, flags);
}

static const char *const *flags_of(glint_rtl_kind kind)
{
    return kind == GLINT_RTL_FAST ? fast_flags : soon_flags;
}

void glint_compilation_begin(glint_arguments *line, const glint_tools *tools, glint_rtl_kind kind)
{
    begin_with(line, tools, flags_of(kind));
}

static glint_status no_memory(glint_error *err)
{
    return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for building a circuit");
}

static void print_compilation(FILE *out, const glint_tools *tools, const char *const *flags)
{
    glint_arguments line;
    begin_with(&line, tools, flags);
    for (int i = 0; i < line.count; i++)
        fprintf(out, "%s\n", line.word[i]);
}

/* Over the tools and what they are told: each list of flags, the last NULL. */
static glint_status hash_flags(const glint_tools *tools, const char *const *const *flags,
                               char hash[GLINT_HASH_TEXT], glint_error *err)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        return no_memory(err);
    fprintf(out, "%s\n%s\n%s\n", tools->version, tools->root, tools->compiler_version);
    for (int i = 1; tools->verilator.word[i] != NULL; i++)
        fprintf(out, "%s\n", tools->verilator.word[i]);
    for (; *flags != NULL; flags++)
        print_compilation(out, tools, *flags);
    const bool good = fclose(out) == 0;
    if (good)
        glint_hash_bytes(text, size, hash);
    free(text);
    return good ? GLINT_OK : no_memory(err);
}

glint_status glint_compilation_hash(const glint_tools *tools, glint_rtl_kind kind,
                                    char hash[GLINT_HASH_TEXT], glint_error *err)
{
    return hash_flags(tools, (const char *const *const[]){flags_of(kind), NULL}, hash, err);
}

/* cache/runtime-HASH.d, with what it is of in the hash: objects, and headers for each kind. Who
 * makes one, after an upgrade of Verilator, say, is who clears away those that nobody uses. */
static glint_status make_directory(glint_runtime *runtime, const char *cache, glint_error *err)
{
    const char *const *const flags[] = {runtime_flags, timed_flags, soon_flags, fast_flags, NULL};
    char hash[GLINT_HASH_TEXT];
    glint_status status = hash_flags(runtime->tools, flags, hash, err);
    if (status != GLINT_OK)
        return status;
    if (asprintf(&runtime->directory, "%s/runtime-%s.d", cache, hash) < 0) {
        runtime->directory = NULL;
        return no_memory(err);
    }
    const bool is_new = access(runtime->directory, F_OK) != 0;
    status = glint_directory_make(runtime->directory, err);
    if (status != GLINT_OK)
        return status;
    glint_cache_touch(runtime->directory);
    if (is_new)
        glint_cache_prune(cache, "runtime-", ".d", KEPT_RUNTIMES, A_DAY);
    return GLINT_OK;
}

/* Does not wait for another process that is making the files, if it need not. */
static glint_status take_lock(glint_runtime *runtime, bool waits, glint_error *err)
{
    if (runtime->lock >= 0)
        return GLINT_OK;
    runtime->lock =
        waits ? glint_cache_lock(runtime->lock_path) : glint_cache_try_lock(runtime->lock_path);
    if (runtime->lock < 0 && errno == EWOULDBLOCK)
        return GLINT_OK;
    if (runtime->lock < 0)
        return glint_fail(err, GLINT_IO_ERROR, "%s: %s", runtime->lock_path, strerror(errno));
    glint_temporary_sweep(runtime->header);
    return GLINT_OK;
}

static void add_includes(glint_arguments *line, const glint_runtime *runtime)
{
    glint_arguments_add(line, "-isystem");
    glint_arguments_add(line, runtime->include);
    glint_arguments_add(line, "-isystem");
    glint_arguments_add(line, runtime->standard_include);
}

static bool is_timed(const char *source)
{
    const char *name = strrchr(source, '/');
    return name != NULL && strcmp(name, timed_source) == 0;
}

/* Starts compiling a file, unless another process has meanwhile or is about to. */
static glint_status start(glint_runtime *runtime, glint_runtime_file *file, bool waits,
                          glint_error *err)
{
    glint_arguments line;
    const int number = (int)(file - runtime->file);
    glint_status status = take_lock(runtime, waits, err);
    if (status != GLINT_OK || runtime->lock < 0 || access(file->path, R_OK) == 0)
        return status;
    file->temporary = glint_temporary_name(file->path, GLINT_TEMPORARY_FILES + 100 + number);
    if (file->temporary == NULL)
        return no_memory(err);
    begin_with(&line, runtime->tools, is_timed(file->source) ? timed_flags : runtime_flags);
    add_includes(&line, runtime);
    glint_arguments_add(&line, "-c");
    glint_arguments_add(&line, file->source);
    glint_arguments_add(&line, "-o");
    glint_arguments_add(&line, file->temporary);
    return glint_command_start(line.word, NULL, &file->command, err);
}

static bool is_added(const glint_runtime *runtime, const char *source)
{
    for (int i = 0; i < runtime->count; i++)
        if (strcmp(runtime->file[i].source, source) == 0)
            return true;
    return false;
}

/* The object of a source, which is taken over. */
static glint_status add_source(glint_runtime *runtime, const char *name, char *source,
                               glint_error *err)
{
    if (runtime->count == GLINT_RUNTIME_FILES_MAX || is_added(runtime, source)) {
        const bool is_known = is_added(runtime, source);
        free(source);
        return is_known ? GLINT_OK
                        : glint_fail(err, GLINT_DEVICE_FAULT,
                                     "Verilator's runtime has more files than expected");
    }
    glint_runtime_file *file = &runtime->file[runtime->count++];
    *file = (glint_runtime_file){.source = source, .command = {0, -1}};
    if (asprintf(&file->path, "%s/%s.o", runtime->directory, name) < 0) {
        file->path = NULL;
        return no_memory(err);
    }
    return access(file->path, R_OK) == 0 ? GLINT_OK : start(runtime, file, false, err);
}

glint_status glint_runtime_add(glint_runtime *runtime, const char *name, glint_error *err)
{
    char *source;
    if (asprintf(&source, "%s/%s.cpp", runtime->include, name) < 0)
        return no_memory(err);
    return add_source(runtime, name, source, err);
}

/* What a circuit will need, before Verilator says so; not every version has all of it. */
static glint_status add_expected(glint_runtime *runtime, glint_error *err)
{
    const char *const expected[] = {"verilated", "verilated_threads",
                                    runtime->kind == GLINT_RTL_FST   ? "verilated_fst_c"
                                    : runtime->kind == GLINT_RTL_VCD ? "verilated_vcd_c"
                                                                     : "verilated"};
    glint_status status = GLINT_OK;
    for (size_t i = 0; status == GLINT_OK && i < sizeof expected / sizeof expected[0]; i++) {
        char *source;
        if (asprintf(&source, "%s/%s.cpp", runtime->include, expected[i]) < 0)
            return no_memory(err);
        if (access(source, R_OK) == 0)
            status = add_source(runtime, expected[i], source, err);
        else
            free(source);
    }
    return status;
}

/* The text of the header: what a model and the shim include. */
static glint_status write_header(const glint_runtime *runtime, glint_error *err)
{
    glint_new_file *file;
    if (access(runtime->header, R_OK) == 0)
        return GLINT_OK;
    const glint_status status = glint_new_file_open(runtime->header, &file, err);
    if (status != GLINT_OK)
        return status;
    fputs("#include <exception>\n#include <memory>\n#include <verilated.h>\n",
          glint_new_file_stream(file));
    return glint_new_file_commit(file, err);
}

/* The header goes with the flags that it is compiled with. */
static bool name_paths(glint_runtime *runtime)
{
    if (asprintf(&runtime->include, "%s/include", runtime->tools->root) < 0)
        runtime->include = NULL;
    if (asprintf(&runtime->standard_include, "%s/include/vltstd", runtime->tools->root) < 0)
        runtime->standard_include = NULL;
    if (asprintf(&runtime->header, "%s/%s.h", runtime->directory,
                 runtime->kind == GLINT_RTL_FAST ? "fast" : "soon") < 0)
        runtime->header = NULL;
    if (asprintf(&runtime->lock_path, "%s.lock", runtime->directory) < 0)
        runtime->lock_path = NULL;
    return runtime->include != NULL && runtime->standard_include != NULL &&
           runtime->header != NULL && runtime->lock_path != NULL;
}

/* All but the objects. */
static glint_status prepare(glint_runtime *runtime, const char *cache, const glint_tools *tools,
                            glint_rtl_kind kind, glint_error *err)
{
    *runtime = (glint_runtime){.tools = tools, .kind = kind, .lock = -1};
    glint_status status = make_directory(runtime, cache, err);
    if (status == GLINT_OK && !name_paths(runtime))
        status = no_memory(err);
    return status == GLINT_OK ? write_header(runtime, err) : status;
}

glint_status glint_runtime_begin(glint_runtime *runtime, const char *cache,
                                 const glint_tools *tools, glint_rtl_kind kind, glint_error *err)
{
    const glint_status status = prepare(runtime, cache, tools, kind, err);
    return status == GLINT_OK ? add_expected(runtime, err) : status;
}

static glint_status finish(glint_runtime_file *file, glint_error *err)
{
    bool success;
    char *said;
    glint_status status = glint_command_wait(&file->command, &success, &said, err);
    if (status == GLINT_OK && !success)
        status = glint_diagnose_compiler(said, err);
    if (status == GLINT_OK && rename(file->temporary, file->path) != 0)
        status = glint_fail(err, GLINT_IO_ERROR, "%s: %s", file->path, strerror(errno));
    free(said);
    if (status != GLINT_OK)
        (void)unlink(file->temporary);
    free(file->temporary);
    file->temporary = NULL;
    return status;
}

/* What another process was making when this one began, and may have given up. */
static glint_status make_what_is_missing(glint_runtime *runtime, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int i = 0; status == GLINT_OK && i < runtime->count; i++) {
        glint_runtime_file *file = &runtime->file[i];
        if (access(file->path, R_OK) == 0)
            continue;
        status = start(runtime, file, true, err);
        if (status == GLINT_OK && file->temporary != NULL)
            status = finish(file, err);
    }
    return status;
}

glint_status glint_runtime_wait(glint_runtime *runtime, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int i = 0; status == GLINT_OK && i < runtime->count; i++)
        if (runtime->file[i].temporary != NULL)
            status = finish(&runtime->file[i], err);
    if (status == GLINT_OK)
        status = make_what_is_missing(runtime, err);
    if (status == GLINT_OK) {
        glint_cache_unlock(runtime->lock_path, runtime->lock);
        runtime->lock = -1;
    }
    return status;
}

void glint_runtime_end(glint_runtime *runtime)
{
    for (int i = 0; i < runtime->count; i++) {
        glint_runtime_file *file = &runtime->file[i];
        glint_command_kill(&file->command);
        if (file->temporary != NULL)
            (void)unlink(file->temporary);
        free(file->temporary);
        free(file->path);
        free(file->source);
    }
    if (runtime->lock_path != NULL)
        glint_cache_unlock(runtime->lock_path, runtime->lock);
    free(runtime->directory);
    free(runtime->include);
    free(runtime->standard_include);
    free(runtime->header);
    free(runtime->lock_path);
    *runtime = (glint_runtime){.lock = -1};
}

static glint_status precompile(const glint_runtime *runtime, const char *work, glint_error *err)
{
    glint_arguments line;
    bool success;
    char *said;
    glint_compilation_begin(&line, runtime->tools, runtime->kind);
    add_includes(&line, runtime);
    glint_arguments_add(&line, "-x");
    glint_arguments_add(&line, "c++-header");
    glint_arguments_add(&line, runtime->header);
    glint_arguments_add(&line, "-o");
    glint_arguments_add(&line, "made");
    glint_status status = glint_command_run(line.word, work, &success, &said, err);
    if (status == GLINT_OK && !success)
        status = glint_diagnose_compiler(said, err);
    free(said);
    return status;
}

/* header.h.gch, which gcc and clang look for next to header.h. */
static glint_status precompile_entry(const glint_runtime *runtime, glint_error *err)
{
    char *name;
    glint_cache_entry entry;
    if (asprintf(&name, "%s.gch", strrchr(runtime->header, '/') + 1) < 0)
        return no_memory(err);
    glint_status status = glint_cache_open(runtime->directory, name, &entry, err);
    free(name);
    if (status != GLINT_OK)
        return status;
    if (entry.work != NULL) {
        status = precompile(runtime, entry.work, err);
        if (status == GLINT_OK)
            status = glint_cache_commit(&entry, "made", err);
    }
    glint_cache_close(&entry);
    return status;
}

glint_status glint_runtime_precompile(const char *cache, const glint_tools *tools,
                                      glint_rtl_kind kind, glint_error *err)
{
    glint_runtime runtime;
    glint_status status = prepare(&runtime, cache, tools, kind, err);
    if (status == GLINT_OK)
        status = precompile_entry(&runtime, err);
    glint_runtime_end(&runtime);
    return status;
}
