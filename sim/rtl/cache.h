/* A directory of things built once. Each is one file, made in a work directory next to it and
 * renamed when complete; any other thread or process that wants it meanwhile waits for its builder.
 * The next builder removes what a killed one left. */
#ifndef GLINT_SIM_RTL_CACHE_H
#define GLINT_SIM_RTL_CACHE_H

#include "glint_status.h"

typedef struct glint_cache_entry {
    char *path; /* of the file */
    char *work; /* the work directory, absolute; NULL: the file is there */
    char *lock_path;
    int lock;
} glint_cache_entry;

/* The file `name` of the cache directory: if it is missing, this caller must build it in
 * entry->work and then commit or discard. */
glint_status glint_cache_open(const char *cache, const char *name, glint_cache_entry *entry,
                              glint_error *err);

/* Takes the file `made` of the work directory as the entry's. */
glint_status glint_cache_commit(glint_cache_entry *entry, const char *made, glint_error *err);

/* Removes the work directory, if one is left, and frees; after a commit, too. */
void glint_cache_close(glint_cache_entry *entry);

/* An exclusive lock by the name of a file, which goes with it; −1 with errno. */
int glint_cache_lock(const char *path);
int glint_cache_try_lock(const char *path); /* the same; EWOULDBLOCK where another has it */
void glint_cache_unlock(const char *path, int lock);

/* Marks a file as used: the least recently used of its kind are removed first. */
void glint_cache_touch(const char *path);

/* Keeps so many of the files, or directories of files, whose names begin and end so, and all that
 * were used less than so many seconds ago. A directory goes whole or not at all. */
void glint_cache_prune(const char *cache, const char *begin, const char *end, int keep,
                       int seconds);

/* The newest file of the directory whose name begins and ends so; NULL: there is none. To be
 * freed. */
char *glint_cache_newest(const char *cache, const char *begin, const char *end);

#endif
