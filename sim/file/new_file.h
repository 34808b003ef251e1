/* A file that appears whole or not at all: it is written without a name, where the file system has
 * such files (O_TMPFILE), else under another name in the same directory, and takes its own name
 * only when everything has arrived. What a killed process left in that directory goes when the next
 * file is opened there (temporary.h).
 *
 *     glint_new_file *file;
 *     status = glint_new_file_open(path, &file, err);
 *     …fprintf(glint_new_file_stream(file), …) …
 *     return good ? glint_new_file_commit(file, err) : (glint_new_file_discard(file), status);
 *
 * An existing file keeps its permissions; a symbolic link is followed and stays: the file that it
 * leads to is replaced, or made if missing. A path that names no regular file (a device, a pipe) is
 * written to directly; a pipe once somebody reads it. */
#ifndef GLINT_SIM_FILE_NEW_FILE_H
#define GLINT_SIM_FILE_NEW_FILE_H

#include <stdbool.h>
#include <stdio.h>

#include "glint_status.h"

typedef struct glint_new_file glint_new_file;

/* How long a pipe may be without a reader before GLINT_IO_ERROR says so, seconds. */
#define GLINT_NEW_FILE_PATIENCE 5

glint_status glint_new_file_open(const char *path, glint_new_file **file, glint_error *err);

/* The same, given up with GLINT_INTERRUPTED when *stop becomes true; stop may be NULL. */
glint_status glint_new_file_open_until(const char *path, const volatile bool *stop,
                                       glint_new_file **file, glint_error *err);

/* Binary, fully buffered. Writers need not check each write: commit does. */
FILE *glint_new_file_stream(const glint_new_file *file);

/* Closes the stream before the file is given its name, which commit does: for several files that
 * are to appear together. Where anything was not written, removes the file, which is gone as an
 * object, and returns GLINT_IO_ERROR. */
glint_status glint_new_file_close(glint_new_file *file, glint_error *err);

/* Closes the file and gives it its name; where anything was not written, removes it instead and
 * returns GLINT_IO_ERROR. The file is gone as an object either way. */
glint_status glint_new_file_commit(glint_new_file *file, glint_error *err);

/* Closes and removes what was written. NULL is allowed. */
void glint_new_file_discard(glint_new_file *file);

/* Tells, before long work, whether path could be written; leaves nothing behind. */
glint_status glint_new_file_check(const char *path, glint_error *err);

#endif
