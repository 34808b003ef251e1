/* Locates the Verilog, the shim, the headers and the cache; see place.h. */
#define _GNU_SOURCE /* asprintf */

#include "rtl/place.h"

#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "file/directory.h"

/* Of the link in a build directory, and of what make install makes, from bin/ on. */
#define TREE      "tree"
#define INSTALLED "../share/glint"

/* What each has where. */
typedef struct layout {
    const char *tree, *installed;
} layout;

static const layout rtl_layout = {TREE "/rtl", INSTALLED "/rtl"};
static const layout shim_layout = {TREE "/sim/rtl", INSTALLED "/sim"};
static const layout headers_layout = {TREE "/cmodel", "../include/glint"};

static glint_status no_memory(glint_error *err)
{
    return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a path");
}

/* base/name when that is there; NULL when not, or without memory. */
static char *existing(const char *base, const char *name)
{
    char *path;
    if (asprintf(&path, "%s/%s", base, name) < 0)
        return NULL;
    if (access(path, R_OK) == 0)
        return path;
    free(path);
    return NULL;
}

/* The directory of this program, without a slash at its end; false: unknown. */
static bool own_directory(char path[PATH_MAX])
{
    const ssize_t length = readlink("/proc/self/exe", path, PATH_MAX - 1);
    if (length <= 0)
        return false;
    path[length] = '\0';
    *strrchr(path, '/') = '\0';
    return true;
}

/* The build directory: the nearest above this program that has the link; false: there is none. */
static bool build_directory(char path[PATH_MAX])
{
    char *slash;
    if (!own_directory(path))
        return false;
    while (path[0] != '\0') {
        char *found = existing(path, shim_layout.tree);
        free(found);
        if (found != NULL)
            return true;
        if ((slash = strrchr(path, '/')) == NULL)
            return false;
        *slash = '\0';
    }
    return false;
}

static char *find(const layout *layout)
{
    char base[PATH_MAX];
    if (build_directory(base))
        return existing(base, layout->tree);
    return own_directory(base) ? existing(base, layout->installed) : NULL;
}

glint_status glint_place_rtl(char **directory, glint_error *err)
{
    const char *told = getenv("GLINT_RTL");
    *directory = told != NULL && told[0] != '\0' ? strdup(told) : find(&rtl_layout);
    return *directory != NULL
               ? GLINT_OK
               : glint_fail(
                     err, GLINT_IO_ERROR,
                     "cannot find Glint's own Verilog where this program expects it (" INSTALLED
                     "/rtl): set GLINT_RTL to its directory");
}

static glint_status find_or_fail(const layout *layout, char **directory, glint_error *err)
{
    *directory = find(layout);
    return *directory != NULL
               ? GLINT_OK
               : glint_fail(err, GLINT_IO_ERROR, "%s is missing: make install puts it there",
                            layout->installed);
}

glint_status glint_place_shim(char **directory, glint_error *err)
{
    return find_or_fail(&shim_layout, directory, err);
}

glint_status glint_place_headers(char **directory, glint_error *err)
{
    return find_or_fail(&headers_layout, directory, err);
}

/* The cache as it is named; NULL: nowhere, or no memory. */
static char *cache_named(void)
{
    char base[PATH_MAX];
    char *path = NULL;
    const char *told = getenv("GLINT_CACHE");
    const char *xdg = getenv("XDG_CACHE_HOME");
    const char *home = getenv("HOME");
    if (told != NULL && told[0] != '\0')
        return strdup(told);
    int length = -1;
    if (build_directory(base))
        length = asprintf(&path, "%s/circuits", base);
    else if (xdg != NULL && xdg[0] == '/')
        length = asprintf(&path, "%s/glint", xdg);
    else if (home != NULL && home[0] == '/')
        length = asprintf(&path, "%s/.cache/glint", home);
    return length >= 0 ? path : NULL;
}

glint_status glint_place_cache(char **directory, glint_error *err)
{
    char *named = cache_named();
    *directory = NULL;
    if (named == NULL)
        return glint_fail(err, GLINT_IO_ERROR,
                          "nowhere to keep circuits: set GLINT_CACHE to a directory");
    const glint_status status = glint_directory_make(named, err);
    if (status == GLINT_OK)
        *directory = realpath(named, NULL);
    free(named);
    return status == GLINT_OK && *directory == NULL ? no_memory(err) : status;
}
