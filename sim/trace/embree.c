/* Opens Embree's library and finds its functions. */
#define _POSIX_C_SOURCE 200809L

#include "trace/embree.h"

#include <dlfcn.h>
#include <stdbool.h>

#define LIBRARY "libembree3.so.3"
#define PACKAGE "libembree3-3"

static bool find(void *library, const char *name, void *function)
{
    *(void **)function = dlsym(library, name);
    return *(void **)function != NULL;
}

/* It stays open: its own threads' data could not be unloaded safely. */
glint_status glint_embree_open(const glint_embree **embree, glint_error *err)
{
    static glint_embree opened;
    static bool complete;
    if (!complete) {
        void *library = dlopen(LIBRARY, RTLD_NOW | RTLD_LOCAL);
        if (library == NULL) {
            return glint_fail(err, GLINT_IO_ERROR,
                              "tracing rays needs Embree 3 (Debian's package " PACKAGE "): %s",
                              dlerror());
        }
        complete = true;
#define FIND(name) complete = complete && find(library, #name, (void *)&opened.name);
        GLINT_EMBREE_FUNCTIONS(FIND)
#undef FIND
        if (!complete) {
            return glint_fail(err, GLINT_IO_ERROR,
                              LIBRARY " lacks a function of Embree 3: install Debian's package "
                                      "" PACKAGE);
        }
    }
    *embree = &opened;
    return GLINT_OK;
}
