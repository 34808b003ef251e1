/* From a setting to its shared object: Verilator, compiler, linker; see build.h. */
#define _GNU_SOURCE /* asprintf */

#include "rtl/build.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rtl/cache.h"
#include "rtl/data.h"
#include "rtl/diagnosis.h"
#include "rtl/place.h"
#include "rtl/product.h"
#include "rtl/runtime.h"
#include "rtl/table.h"

#define OBJECT    "circuit.so"
#define UNITY     "circuit.cpp"
#define PORT_FILE "glint_port.v"

/* A product being built, in a work directory that holds its sources. */
typedef struct build {
    const glint_product *product;
    const char *work;
    glint_runtime runtime;
    FILE *unity; /* includes everything that is compiled */
} build;

static glint_status no_memory(glint_error *err)
{
    return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for building a circuit");
}

/* Files that Verilator does not find by itself, or not in time. */
static void add_told_files(const glint_sources *sources, glint_arguments *line)
{
    int packages = 0;
    for (int i = 0; i < sources->count; i++) {
        packages += sources->file[i].package != 0;
        if (sources->file[i].is_library) {
            glint_arguments_add(line, "-v");
            glint_arguments_add(line, sources->file[i].name);
        }
    }
    for (int place = 1; place <= packages; place++)
        for (int i = 0; i < sources->count; i++)
            if (sources->file[i].package == place)
                glint_arguments_add(line, sources->file[i].name);
}

/* A command line of Verilator but for the last word, the file. Registers that nothing resets begin
 * with 0, as the C models do. */
static void begin_verilator(const build *b, glint_arguments *line, bool lint_only, const char *top)
{
    static const char *const make[] = {"--cc",   "--MMD", "--prefix", GLINT_CLASS,
                                       "--Mdir", ".",     NULL};
    static const char *const options[] = {"-O3", "--x-assign", "0",           "--x-initial",
                                          "0",   "--noassert", "--no-timing", "-Wno-fatal",
                                          "-I.", "--top",      NULL};
    *line = (glint_arguments){.count = 0};
    glint_tool_add(&b->product->tools.verilator, line);
    if (lint_only)
        glint_arguments_add(line, "--lint-only");
    else
        glint_arguments_add_all(line, make);
    glint_arguments_add_all(line, options);
    glint_arguments_add(line, top);
    add_told_files(&b->product->sources, line);
}

/* The probe with one more port of the instance, connected to a constant. */
static glint_status write_port_probe(const build *b, const char *port, glint_error *err)
{
    char *text;
    const char *begin = b->product->probe.text;
    const char *body = strstr(strstr(begin, " dut ("), "\n") + 1;
    const int size =
        asprintf(&text, "%.*s        .%s(1'b0),\n%s", (int)(body - begin), begin, port, body);
    if (size < 0)
        return no_memory(err);
    const glint_status status = glint_text_write(b->work, PORT_FILE, text, (size_t)size, err);
    free(text);
    return status;
}

/* Verilator refuses a constant at an output. */
static glint_status is_output(const build *b, const char *port, bool *output, glint_error *err)
{
    glint_arguments line;
    begin_verilator(b, &line, true, GLINT_PROBE_MODULE);
    glint_arguments_add(&line, PORT_FILE);
    bool success;
    char *said = NULL;
    glint_status status = write_port_probe(b, port, err);
    if (status == GLINT_OK)
        status = glint_command_run(line.word, b->work, &success, &said, err);
    *output = status == GLINT_OK && strstr(said, "PORTSHORT") != NULL;
    free(said);
    return status;
}

/* Every input must be a pin; outputs may be left out. */
static glint_status check_other_ports(const build *b, const char *said, glint_error *err)
{
    const glint_product *p = b->product;
    char port[GLINT_PORT_NAME];
    glint_status status = GLINT_OK;
    while (status == GLINT_OK &&
           (said = glint_diagnose_port(said, p->setting, &p->ports, port)) != NULL) {
        if (glint_sources_have_inout(&p->sources, port))
            return glint_fail(err, GLINT_DEVICE_FAULT,
                              "%s has an inout port %s: only inputs and outputs are supported",
                              glint_setting_top(p->setting), port);
        bool output;
        status = is_output(b, port, &output, err);
        if (status == GLINT_OK && !output)
            status = glint_fail(err, GLINT_DEVICE_FAULT,
                                "%s has an input %s that is missing from the description",
                                glint_setting_top(p->setting), port);
    }
    return status;
}

/* Runs Verilator over the probe or the top module and interprets its output. */
static glint_status run_verilator(const build *b, const glint_arguments *line, glint_error *err)
{
    const glint_product *p = b->product;
    bool success;
    char *said;
    glint_status status = glint_command_run(line->word, b->work, &success, &said, err);
    if (status == GLINT_OK)
        status = glint_diagnose_verilator(said, p->setting, &p->ports, &p->probe, p->verilog, err);
    if (status == GLINT_OK)
        status = check_other_ports(b, said, err);
    if (status == GLINT_OK && !success)
        status = glint_fail(err, GLINT_DEVICE_FAULT, "Verilator failed: %.*s",
                            (int)strcspn(said, "\n"), said);
    free(said);
    return status;
}

static glint_status verilate_probe(const build *b, bool lint_only, glint_error *err)
{
    glint_arguments line;
    begin_verilator(b, &line, lint_only, GLINT_PROBE_MODULE);
    glint_arguments_add(&line, GLINT_PROBE_FILE);
    return run_verilator(b, &line, err);
}

/* The top itself, once the probe has shown that it is the description's. */
static glint_status verilate_top(const build *b, glint_error *err)
{
    const glint_setting *setting = b->product->setting;
    const glint_circuit *circuit = setting->circuit;
    char parameter[GLINT_PARAMETERS_MAX][160]; /* "-GLANES=4" */
    glint_arguments line;
    begin_verilator(b, &line, false, glint_setting_top(setting));
    if (b->product->kind == GLINT_RTL_FST)
        glint_arguments_add(&line, "--trace-fst");
    if (b->product->kind == GLINT_RTL_VCD)
        glint_arguments_add(&line, "--trace");
    for (int i = 0; i < circuit->parameter_count; i++)
        if (circuit->parameters[i].verilog != NULL) {
            (void)snprintf(parameter[i], sizeof parameter[i], "-G%s=%d",
                           circuit->parameters[i].verilog, setting->values[i]);
            glint_arguments_add(&line, parameter[i]);
        }
    glint_arguments_add(&line, b->product->top_file);
    const glint_status status = verilate_probe(b, true, err);
    return status == GLINT_OK ? run_verilator(b, &line, err) : status;
}

/* The next word that a makefile's `variable += \` continues with, from *line on; false: no more. */
static bool next_word(const char **line, char word[256])
{
    while (**line == ' ' || **line == '\t') {
        const bool found = sscanf(*line, " %255[^ \t\n\\]", word) == 1;
        *line += strcspn(*line, "\n");
        *line += **line == '\n';
        if (found)
            return true;
    }
    return false;
}

static const char *words_of(const char *makefile, const char *variable)
{
    char start[64];
    (void)snprintf(start, sizeof start, "\n%s += \\\n", variable);
    const char *line = strstr(makefile, start);
    return line != NULL ? line + strlen(start) : "";
}

static void include_classes(const build *b, const char *makefile, const char *variable)
{
    char word[256];
    for (const char *line = words_of(makefile, variable); next_word(&line, word);)
        fprintf(b->unity, "#include \"%s.cpp\"\n", word);
}

/* Everything in one file for the compiler, the shim and the loop over points behind what is fast.
 * What runs once, half of the text of a large circuit, is not optimised. */
static void write_unity(const build *b, const char *makefile)
{
    include_classes(b, makefile, "VM_CLASSES_FAST");
    include_classes(b, makefile, "VM_SUPPORT_FAST");
    fputs("#include \"shim.cpp\"\n", b->unity);
    if (glint_product_shades(b->product))
        fputs("#include \"" GLINT_SHADE_FILE "\"\n", b->unity);
    fputs("#ifdef __clang__\n#pragma clang optimize off\n"
          "#else\n#pragma GCC optimize(\"O0\")\n#endif\n",
          b->unity);
    include_classes(b, makefile, "VM_CLASSES_SLOW");
    include_classes(b, makefile, "VM_SUPPORT_SLOW");
}

static glint_status add_runtime(build *b, const char *makefile, const char *variable,
                                glint_error *err)
{
    char word[256];
    glint_status status = GLINT_OK;
    for (const char *line = words_of(makefile, variable);
         status == GLINT_OK && next_word(&line, word);)
        status = glint_runtime_add(&b->runtime, word, err);
    return status;
}

/* What Verilator wrote, by its list of it. */
static glint_status list_classes(build *b, glint_error *err)
{
    char *makefile, *unity = NULL;
    size_t size;
    glint_status status =
        glint_text_read(b->work, GLINT_CLASS "_classes.mk", &makefile, &size, err);
    if (status == GLINT_OK)
        status = add_runtime(b, makefile, "VM_GLOBAL_FAST", err);
    if (status == GLINT_OK)
        status = add_runtime(b, makefile, "VM_GLOBAL_SLOW", err);
    b->unity = status == GLINT_OK ? open_memstream(&unity, &size) : NULL;
    if (b->unity != NULL)
        write_unity(b, makefile);
    const bool good = b->unity != NULL && fclose(b->unity) == 0;
    if (status == GLINT_OK)
        status = good ? glint_text_write(b->work, UNITY, unity, size, err) : no_memory(err);
    free(unity);
    free(makefile);
    return status;
}

/* Verilator's list of what it has read: nothing from elsewhere, as that would be in no hash. */
static glint_status check_read(const build *b, glint_error *err)
{
    const char *root = b->product->tools.root;
    char *list, *rest = NULL;
    size_t size;
    glint_status status = glint_text_read(b->work, GLINT_CLASS "__ver.d", &list, &size, err);
    char *word = status == GLINT_OK ? strtok_r(list, " \n", &rest) : NULL;
    for (; status == GLINT_OK && word != NULL; word = strtok_r(NULL, " \n", &rest))
        if (word[0] == '/' && strncmp(word, root, strlen(root)) != 0 &&
            strncmp(strrchr(word, '/'), "/verilat", 8) != 0) /* itself, its standard package */
            status = glint_fail(err, GLINT_DEVICE_FAULT,
                                "%s: its Verilog includes %s; what it includes must lie beside it",
                                b->product->verilog, word);
    free(list);
    return status;
}

static glint_status run_compiler(const build *b, const glint_arguments *line, glint_error *err)
{
    bool success;
    char *said;
    glint_status status = glint_command_run(line->word, b->work, &success, &said, err);
    if (status == GLINT_OK && !success)
        status = glint_diagnose_compiler(said, err);
    free(said);
    return status;
}

static glint_status compile(const build *b, glint_error *err)
{
    glint_arguments line;
    glint_compilation_begin(&line, &b->product->tools, b->product->kind);
    static const char *const head[] = {"-c", UNITY, "-o", "circuit.o", "-I.", "-include", NULL};
    glint_arguments_add_all(&line, head);
    glint_arguments_add(&line, b->runtime.header);
    glint_arguments_add(&line, "-isystem");
    glint_arguments_add(&line, b->runtime.include);
    glint_arguments_add(&line, "-isystem");
    glint_arguments_add(&line, b->runtime.standard_include);
    return run_compiler(b, &line, err);
}

/* Whether the runtime's writer of waveforms wants lz4: that of 5.04 and newer does. */
static bool wants_lz4(const build *b)
{
    char *rules;
    size_t size;
    const bool wants =
        glint_text_read(b->runtime.include, "verilated.mk", &rules, &size, NULL) == GLINT_OK &&
        strstr(rules, "-llz4") != NULL;
    free(rules);
    return wants;
}

/* What the Verilog opens is what was there when the circuit was built (shim.cpp). */
static void add_data(const build *b, glint_arguments *line)
{
    if (glint_data_count(&b->product->sources) > 0)
        glint_arguments_add(line, "-Wl,--wrap=fopen");
}

/* It stays loaded to the end of the process: Verilator's threads leave destructors in it. */
static glint_status link_object(const build *b, glint_error *err)
{
    static const char *const head[] = {
        "-shared", "-Wl,-z,nodelete", "-Wl,--gc-sections", "-o", OBJECT, "circuit.o", NULL};
    glint_arguments line;
    glint_compilation_begin(&line, &b->product->tools, b->product->kind);
    glint_arguments_add_all(&line, head);
    for (int i = 0; i < b->runtime.count; i++)
        glint_arguments_add(&line, b->runtime.file[i].path);
    glint_arguments_add(&line, "-pthread");
    add_data(b, &line);
    if (glint_tools_are_clang(&b->product->tools))
        glint_arguments_add(&line, "-latomic");
    if (b->product->kind == GLINT_RTL_FST) {
        if (wants_lz4(b))
            glint_arguments_add(&line, "-llz4");
        glint_arguments_add(&line, "-lz");
    }
    return run_compiler(b, &line, err);
}

/* The runtime is made while Verilator and the compiler work on the circuit. */
static glint_status make(build *b, glint_error *err)
{
    const glint_product *p = b->product;
    glint_status status = glint_sources_write(&p->sources, b->work, err);
    if (status == GLINT_OK)
        status = glint_data_write(&p->sources, b->work, err);
    if (status == GLINT_OK)
        status = glint_runtime_begin(&b->runtime, p->cache, &p->tools, p->kind, err);
    if (status == GLINT_OK)
        status =
            p->kind != GLINT_RTL_OBSERVED ? verilate_top(b, err) : verilate_probe(b, false, err);
    if (status == GLINT_OK)
        status = check_read(b, err);
    if (status == GLINT_OK)
        status = glint_table_write(p, b->work, err);
    if (status == GLINT_OK)
        status = list_classes(b, err);
    if (status == GLINT_OK)
        status = compile(b, err);
    if (status == GLINT_OK)
        status = glint_runtime_wait(&b->runtime, err);
    return status == GLINT_OK ? link_object(b, err) : status;
}

static glint_status make_entry(const glint_product *product, glint_cache_entry *entry,
                               glint_error *err)
{
    build b = {.product = product, .work = entry->work, .runtime.lock = -1};
    glint_status status = make(&b, err);
    glint_runtime_end(&b.runtime);
    if (status == GLINT_OK)
        status = glint_cache_commit(entry, OBJECT, err);
    if (status == GLINT_OK)
        glint_product_prune(product);
    return status;
}

static glint_status build_product(const glint_product *product, char **path, glint_error *err)
{
    glint_cache_entry entry;
    if (product->tools_status != GLINT_OK)
        return glint_fail(err, product->tools_status, "%s", product->tools_error.text);
    glint_status status = glint_cache_open(product->cache, product->file, &entry, err);
    if (status != GLINT_OK)
        return status;
    if (entry.work != NULL)
        status = make_entry(product, &entry, err);
    if (status == GLINT_OK && (*path = strdup(entry.path)) == NULL)
        status = no_memory(err);
    glint_cache_close(&entry);
    return status;
}

glint_status glint_rtl_build(const glint_setting *setting, glint_rtl_kind kind, char **path,
                             glint_error *err)
{
    glint_product product;
    *path = NULL;
    glint_status status = glint_product_begin(&product, setting, kind, err);
    if (status == GLINT_OK && (*path = glint_product_find(&product)) == NULL)
        status = build_product(&product, path, err);
    glint_product_end(&product);
    return status;
}

glint_status glint_rtl_is_built(const glint_setting *setting, glint_rtl_kind kind, bool *built,
                                glint_error *err)
{
    glint_product product;
    glint_status status = glint_product_begin(&product, setting, kind, err);
    char *path = status == GLINT_OK ? glint_product_find(&product) : NULL;
    *built = path != NULL;
    free(path);
    glint_product_end(&product);
    return status;
}

/* The cache and the tools, without a circuit. */
static glint_status find_tools(char **cache, glint_tools *tools, glint_error *err)
{
    glint_status status = glint_place_cache(cache, err);
    if (status != GLINT_OK)
        return status;
    status = glint_tools_find(*cache, tools, err);
    if (status != GLINT_OK)
        free(*cache);
    return status;
}

glint_status glint_rtl_precompile(glint_rtl_kind kind, glint_error *err)
{
    char *cache;
    glint_tools tools;
    glint_status status = find_tools(&cache, &tools, err);
    if (status != GLINT_OK)
        return status;
    status = glint_runtime_precompile(cache, &tools, kind, err);
    glint_tools_free(&tools);
    free(cache);
    return status;
}

glint_status glint_rtl_verilator_version(char **version, glint_error *err)
{
    char *cache;
    glint_tools tools;
    *version = NULL;
    const glint_status status = find_tools(&cache, &tools, err);
    if (status != GLINT_OK)
        return status;
    *version = strdup(tools.version);
    glint_tools_free(&tools);
    free(cache);
    return *version != NULL ? GLINT_OK : no_memory(err);
}
