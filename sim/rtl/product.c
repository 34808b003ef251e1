/* Collects and hashes everything that goes into one shared object. */
#define _GNU_SOURCE /* asprintf */

#include "rtl/product.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "circuit/units.h"
#include "rtl/cache.h"
#include "rtl/data.h"
#include "rtl/needed.h"
#include "rtl/place.h"
#include "rtl/runtime.h"

enum {
    /* Part of every hash: increment it when build.c makes something different from the same
     * sources, for example with other Verilator options. */
    RECIPE = 4,
    KEPT_ALIKE = 64, /* edits of a setting's Verilog */
};

static glint_status no_memory(glint_error *err)
{
    return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for building a circuit");
}

static glint_status add_verilog(glint_product *product, glint_error *err)
{
    static const char *const endings[] = {".v", ".vh", ".sv", ".svh", NULL};
    const glint_setting *setting = product->setting;
    glint_status status = GLINT_OK;
    if (setting->verilog == NULL)
        status = glint_place_rtl(&product->verilog, err);
    else if ((product->verilog = strdup(setting->verilog)) == NULL)
        status = no_memory(err);
    if (status == GLINT_OK)
        status = glint_sources_read(&product->sources, product->verilog, endings, err);
    if (status == GLINT_OK)
        status = glint_sources_need(&product->sources, glint_setting_top(setting), product->verilog,
                                    &product->top_file, err);
    return status == GLINT_OK ? glint_data_read(&product->sources, product->verilog, err) : status;
}

bool glint_product_shades(const glint_product *product)
{
    return product->kind == GLINT_RTL_FAST && glint_is_highlight(product->setting->circuit);
}

static glint_status add_shim(glint_product *product, glint_error *err)
{
    static const char *const files[] = {"shim.cpp", "shim.h", GLINT_SHADE_FILE, "points.h",
                                        "bits.h"};
    const int count = glint_product_shades(product) ? 5 : 2;
    char *directory;
    glint_status status = glint_place_shim(&directory, err);
    if (status != GLINT_OK)
        return status;
    for (int i = 0; status == GLINT_OK && i < count; i++)
        status = glint_sources_read_file(&product->sources, directory, files[i], err);
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
    return status == GLINT_OK ? add_shim(product, err) : status;
}

/* The processor's features: a fast circuit is built for this processor only. */
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
    const glint_status status = glint_compilation_hash(&product->tools, product->kind, hash, err);
    if (status != GLINT_OK)
        return status;
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
        glint_cache_prune(product->cache, alike, ".so", KEPT_ALIKE, 0);
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
