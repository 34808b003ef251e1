/* The files of a study, renamed into place together, so a directory never mixes two studies.
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

/* Starts a file under a temporary name and ends the previous one. */
glint_status glint_study_files_add(glint_study_files *files, const char *name, FILE **stream,
                                   glint_error *err);

/* Closes the file started last; reports whether all of it was written. */
glint_status glint_study_files_end(glint_study_files *files, glint_error *err);

/* Gives all files their names, and removes those an earlier study wrote and this one did not:
 * n-NNNN.png and times.csv, no others. If a rename or a removal fails halfway, what was done so far
 * stays; that is unlikely once the files could be created and the directory read, except for
 * someone else's files in a sticky directory. */
glint_status glint_study_files_commit(glint_study_files *files, glint_error *err);

#endif
