/* A file that appears complete or not at all: it is written as an unnamed file if the file system
 * has them (O_TMPFILE), else under a temporary name in the same directory, and gets its real name
 * only when complete. Leftovers of killed processes are removed when the next file is opened in
 * that directory (temporary.h).
 *
 *     glint_new_file *file;
 *     status = glint_new_file_open(path, &file, err);
 *     …fprintf(glint_new_file_stream(file), …) …
 *     return good ? glint_new_file_commit(file, err) : (glint_new_file_discard(file), status);
 *
 * An existing file keeps its permissions; a symbolic link is followed and kept: its target is
 * replaced, or created if missing. A path that is not a regular file (a device, a pipe) is written
 * to directly; a pipe as soon as it has a reader. */
#ifndef GLINT_SIM_FILE_NEW_FILE_H
#define GLINT_SIM_FILE_NEW_FILE_H

#include <stdbool.h>
#include <stdio.h>

#include "glint_status.h"

typedef struct glint_new_file glint_new_file;

/* Seconds to wait for a pipe's reader before GLINT_IO_ERROR. */
#define GLINT_NEW_FILE_PATIENCE 5

glint_status glint_new_file_open(const char *path, glint_new_file **file, glint_error *err);

/* The same, given up with GLINT_INTERRUPTED when *stop becomes true; stop may be NULL. */
glint_status glint_new_file_open_until(const char *path, const volatile bool *stop,
                                       glint_new_file **file, glint_error *err);

/* Binary, fully buffered. Writers need not check each write: commit does. */
FILE *glint_new_file_stream(const glint_new_file *file);

/* Closes the stream but leaves the renaming to commit, for several files that should appear
 * together. If any write failed, removes the file, destroys the object and returns
 * GLINT_IO_ERROR. */
glint_status glint_new_file_close(glint_new_file *file, glint_error *err);

/* Closes the file and gives it its name; if any write failed, removes it instead and returns
 * GLINT_IO_ERROR. Destroys the object either way. */
glint_status glint_new_file_commit(glint_new_file *file, glint_error *err);

/* Closes and removes what was written. NULL is allowed. */
void glint_new_file_discard(glint_new_file *file);

/* Checks, before long work, whether path could be written; leaves nothing behind. */
glint_status glint_new_file_check(const char *path, glint_error *err);

#endif
