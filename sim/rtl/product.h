/* One shared object to build: everything that goes into it, and its name in the cache. */
#ifndef GLINT_SIM_RTL_PRODUCT_H
#define GLINT_SIM_RTL_PRODUCT_H

#include "rtl/ports.h"
#include "rtl/probe.h"
#include "rtl/rtl.h"
#include "rtl/sources.h"
#include "rtl/tools.h"

/* What Verilator calls its class. */
#define GLINT_CLASS "Vcircuit"

#define GLINT_SHADE_FILE "specular_batch.cpp"

typedef struct glint_product {
    const glint_setting *setting;
    glint_rtl_kind kind;
    char *cache;
    char *verilog; /* the directory, as it is called in messages */
    glint_ports ports;
    glint_probe probe;
    glint_sources sources; /* Verilog and its data, probe, shim */
    const char *top_file;  /* of them, the top's */
    char *stem;            /* NAME-KIND-SOURCES */
    glint_tools tools;
    glint_status tools_status; /* not GLINT_OK: there are no tools … */
    glint_error tools_error;   /* … for this reason */
    char *file;                /* its name in the cache; NULL: not known without tools */
} glint_product;

/* To be ended, whatever it returns. */
glint_status glint_product_begin(glint_product *product, const glint_setting *setting,
                                 glint_rtl_kind kind, glint_error *err);
void glint_product_end(glint_product *product);

/* Whether the loop over points is compiled into it, GLINT_SHADE_FILE: a fast highlight unit. */
bool glint_product_shades(const glint_product *product);

/* The path in the cache when it is there, else NULL. To be freed. */
char *glint_product_find(const glint_product *product);

/* Removes all but the latest builds of the same setting from the cache. */
void glint_product_prune(const glint_product *product);

#endif
