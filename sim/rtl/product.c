/* Collects and hashes everything that goes into one shared object. */
#define _GNU_SOURCE /* asprintf */

#include "rtl/product.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "rtl/cache.h"
#include "rtl/place.h"
#include "rtl/runtime.h"

enum {
    /* Part of every hash: to be raised when build.c makes something else of the same sources, by
     * other options of Verilator, say. */
    RECIPE = 2,
    KEPT_ALIKE = 64, /* edits of a setting's Verilog */
};

static glint_status no_memory(glint_error *err)
{
    return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for building a circuit");
}

/* A port's member of Verilator's class: of two underlines in a row, the second is written as a
 * code. */
static void print_member(FILE *out, const char *name)
{
    for (; *name != '\0'; name++) {
        fputc(*name, out);
        if (name[0] == '_' && name[1] == '_') {
            fputs("__05F", out);
            name++;
        }
    }
}

static void print_probe_ports(FILE *out, const glint_product *product)
{
    const glint_setting *setting = product->setting;
    for (int i = 0; i < product->ports.count; i++)
        fprintf(out, " \\\n    X(\"%s\", glint_p%d)", product->ports.port[i].name, i);
    for (int i = 0; i < product->ports.signals; i++)
        if (setting->circuit->signal(setting->values, i).kind != GLINT_SIGNAL_OUTPUT)
            fprintf(out, " \\\n    X(\"glint_s%d\", glint_s%d)", i, i);
}

static void print_own_ports(FILE *out, const glint_product *product)
{
    for (int i = 0; i < product->ports.count; i++) {
        fprintf(out, " \\\n    X(\"%s\", ", product->ports.port[i].name);
        print_member(out, product->ports.port[i].name);
        fputc(')', out);
    }
}

/* glint_ports.h: see shim.cpp. */
static void print_table(FILE *out, const glint_product *product)
{
    const char *clock = product->setting->circuit->clock_port;
    fprintf(out, "#define GLINT_PORTS(X)");
    if (product->kind != GLINT_RTL_OBSERVED)
        print_own_ports(out, product);
    else
        print_probe_ports(out, product);
    fprintf(out, "\n");
    if (clock != NULL) {
        fprintf(out, "#define GLINT_CLOCK ");
        print_member(out, product->kind != GLINT_RTL_OBSERVED ? clock : GLINT_PROBE_CLOCK);
        fprintf(out, "\n");
    }
    if (product->kind == GLINT_RTL_FST || product->kind == GLINT_RTL_VCD)
        fprintf(out, "#define GLINT_%s\n", product->kind == GLINT_RTL_FST ? "FST" : "VCD");
}

static glint_status add_table(glint_product *product, glint_error *err)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        return no_memory(err);
    print_table(out, product);
    const int failed = ferror(out);
    glint_status status = fclose(out) != 0 || failed ? no_memory(err) : GLINT_OK;
    if (status == GLINT_OK)
        status = glint_sources_add(&product->sources, "glint_ports.h", text, size, err);
    free(text);
    return status;
}

static glint_status add_verilog(glint_product *product, glint_error *err)
{
    static const char *const endings[] = {".v", ".vh", NULL};
    const glint_setting *setting = product->setting;
    const char *top = glint_setting_top(setting);
    glint_status status = GLINT_OK;
    if (setting->verilog == NULL)
        status = glint_place_rtl(&product->verilog, err);
    else if ((product->verilog = strdup(setting->verilog)) == NULL)
        status = no_memory(err);
    if (status == GLINT_OK)
        status = glint_sources_read(&product->sources, product->verilog, endings, err);
    for (int i = 0; status == GLINT_OK && i < product->sources.count; i++) {
        const char *name = product->sources.file[i].name;
        if (strncmp(name, top, strlen(top)) == 0 && strcmp(name + strlen(top), ".v") == 0)
            return GLINT_OK;
    }
    return status != GLINT_OK
               ? status
               : glint_fail(err, GLINT_IO_ERROR, "%s has no %s.v", product->verilog, top);
}

static glint_status add_shim(glint_product *product, glint_error *err)
{
    char *directory;
    glint_status status = glint_place_shim(&directory, err);
    if (status != GLINT_OK)
        return status;
    status = glint_sources_read_file(&product->sources, directory, "shim.cpp", err);
    if (status == GLINT_OK)
        status = glint_sources_read_file(&product->sources, directory, "shim.h", err);
    free(directory);
    return status;
}

static glint_status add_sources(glint_product *product, glint_error *err)
{
    glint_status status = add_verilog(product, err);
    if (status == GLINT_OK)
        status = glint_ports_make(product->setting, &product->ports, err);
    if (status == GLINT_OK)
        status = glint_probe_make(product->setting, &product->ports, &product->probe, err);
    if (status == GLINT_OK)
        status = glint_sources_add(&product->sources, GLINT_PROBE_FILE, product->probe.text,
                                   product->probe.size, err);
    if (status == GLINT_OK)
        status = add_table(product, err);
    return status == GLINT_OK ? add_shim(product, err) : status;
}

/* What the processor can: a fast circuit is made for it alone. */
static void print_processor(FILE *out)
{
    char line[8192];
    FILE *in = fopen("/proc/cpuinfo", "r");
    while (in != NULL && fgets(line, sizeof line, in) != NULL)
        if (strncmp(line, "flags", 5) == 0 || strncmp(line, "Features", 8) == 0) {
            fputs(line, out);
            break;
        }
    if (in != NULL)
        (void)fclose(in);
}

static glint_status name_stem(glint_product *product, glint_error *err)
{
    char name[GLINT_SETTING_TEXT], sources[GLINT_HASH_TEXT], hash[GLINT_HASH_TEXT];
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        return no_memory(err);
    glint_sources_hash(&product->sources, sources);
    fprintf(out, "%d\n%s\n", RECIPE, sources);
    if (product->kind == GLINT_RTL_FAST)
        print_processor(out);
    if (fclose(out) != 0) {
        free(text);
        return no_memory(err);
    }
    glint_hash_bytes(text, size, hash);
    free(text);
    glint_setting_name(product->setting, name);
    if (asprintf(&product->stem, "%s-%s-%s", name, glint_rtl_kind_name(product->kind), hash) < 0) {
        product->stem = NULL;
        return no_memory(err);
    }
    return GLINT_OK;
}

static glint_status name_file(glint_product *product, glint_error *err)
{
    char hash[GLINT_HASH_TEXT];
    product->tools_status =
        glint_tools_find(product->cache, &product->tools, &product->tools_error);
    if (product->tools_status != GLINT_OK)
        return product->tools_status == GLINT_INTERRUPTED ? GLINT_INTERRUPTED : GLINT_OK;
    char *text = glint_compilation_text(&product->tools, product->kind);
    if (text == NULL)
        return no_memory(err);
    glint_hash_bytes(text, strlen(text), hash);
    free(text);
    if (asprintf(&product->file, "%s-%s.so", product->stem, hash) < 0) {
        product->file = NULL;
        return no_memory(err);
    }
    return GLINT_OK;
}

glint_status glint_product_begin(glint_product *product, const glint_setting *setting,
                                 glint_rtl_kind kind, glint_error *err)
{
    *product = (glint_product){.setting = setting, .kind = kind};
    glint_status status = glint_setting_check(setting, err);
    if (status == GLINT_OK)
        status = glint_place_cache(&product->cache, err);
    if (status == GLINT_OK)
        status = add_sources(product, err);
    if (status == GLINT_OK)
        status = name_stem(product, err);
    return status == GLINT_OK ? name_file(product, err) : status;
}

char *glint_product_find(const glint_product *product)
{
    char *path;
    if (product->file == NULL)
        return glint_cache_newest(product->cache, product->stem, ".so");
    if (asprintf(&path, "%s/%s", product->cache, product->file) < 0)
        return NULL;
    if (access(path, R_OK) == 0) {
        glint_cache_touch(path);
        return path;
    }
    free(path);
    return NULL;
}

void glint_product_prune(const glint_product *product)
{
    char *alike = strdup(product->stem);
    if (alike != NULL) {
        strrchr(alike, '-')[1] = '\0';
        glint_cache_prune(product->cache, alike, ".so", KEPT_ALIKE);
    }
    free(alike);
}

void glint_product_end(glint_product *product)
{
    free(product->cache);
    free(product->verilog);
    glint_ports_free(&product->ports);
    glint_probe_free(&product->probe);
    glint_sources_free(&product->sources);
    free(product->stem);
    glint_tools_free(&product->tools);
    free(product->file);
    *product = (glint_product){0};
}
