/* The files of a study: together they take their names, so that a directory holds one study and
 * not two mixed.
 *
 *     glint_study_files *files;
 *     glint_study_files_create(directory, &files, err);
 *     glint_study_files_add(files, "study.csv", &stream, err); …fprintf(stream, …)…
 *     glint_study_files_end(files, err);                        → the next file
 *     glint_study_files_commit(files, err);
 *     glint_study_files_destroy(files); */
#ifndef GLINT_SIM_STUDY_FILES_H
#define GLINT_SIM_STUDY_FILES_H

#include <stdio.h>

#include "glint_status.h"

typedef struct glint_study_files glint_study_files;

/* The directory is made if missing; its name must outlive the files. */
glint_status glint_study_files_create(const char *directory, glint_study_files **files,
                                      glint_error *err);

/* Removes what was added and not committed. NULL is allowed. */
void glint_study_files_destroy(glint_study_files *files);

/* Begins a file, under another name for now. The one before it is ended. */
glint_status glint_study_files_add(glint_study_files *files, const char *name, FILE **stream,
                                   glint_error *err);

/* Closes the file begun last; tells whether all of it was written. */
glint_status glint_study_files_end(glint_study_files *files, glint_error *err);

/* Gives all files their names, and removes those an earlier study wrote and this one did not:
 * n-NNNN.png and times.csv, no others. Where the system refuses a name or a removal on the way,
 * which it does not where it let the files be begun and the directory be read, but for someone
 * else's files in a sticky directory, what is done by then stays. */
glint_status glint_study_files_commit(glint_study_files *files, glint_error *err);

#endif
