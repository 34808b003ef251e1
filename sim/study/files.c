/* See files.h. */
#define _POSIX_C_SOURCE 200809L

#include "study/files.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "file/directory.h"
#include "file/kind.h"
#include "file/new_file.h"
#include "study/make.h"

#define NAME_SIZE 32
#define FILES_MAX (GLINT_STUDY_ROWS_MAX + 4) /* a picture for each n, sheet.png and the tables */

struct glint_study_files {
    const char *directory;
    int count;
    struct {
        char name[NAME_SIZE];
        glint_new_file *file; /* NULL: has its name */
    } entry[FILES_MAX];
};

glint_status glint_study_files_create(const char *directory, glint_study_files **files,
                                      glint_error *err)
{
    *files = NULL;
    const glint_status status = glint_directory_make(directory, err);
    if (status != GLINT_OK)
        return status;
    *files = calloc(1, sizeof **files);
    if (*files == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the files of a study");
    (*files)->directory = directory;
    return GLINT_OK;
}

void glint_study_files_destroy(glint_study_files *files)
{
    if (files == NULL)
        return;
    for (int i = 0; i < files->count; i++)
        glint_new_file_discard(files->entry[i].file);
    free(files);
}

static glint_status path_of(const glint_study_files *files, const char *name, char path[4096],
                            glint_error *err)
{
    const int length = snprintf(path, 4096, "%s/%s", files->directory, name);
    return length < 4096 ? GLINT_OK
                         : glint_fail(err, GLINT_BAD_ARGUMENT, "the directory's name is too long");
}

glint_status glint_study_files_add(glint_study_files *files, const char *name, FILE **stream,
                                   glint_error *err)
{
    char path[4096];
    glint_new_file *file;
    glint_status status = files->count < FILES_MAX
                              ? path_of(files, name, path, err)
                              : glint_fail(err, GLINT_BAD_ARGUMENT, "too many files in a study");
    if (status == GLINT_OK)
        status = glint_new_file_open(path, &file, err);
    if (status != GLINT_OK)
        return status;
    snprintf(files->entry[files->count].name, NAME_SIZE, "%s", name);
    files->entry[files->count++].file = file;
    *stream = glint_new_file_stream(file);
    return GLINT_OK;
}

glint_status glint_study_files_end(glint_study_files *files, glint_error *err)
{
    glint_new_file **file = &files->entry[files->count - 1].file;
    const glint_status status = glint_new_file_close(*file, err);
    if (status != GLINT_OK)
        *file = NULL; /* it is gone */
    return status;
}

/* A file name that only studies use, though not every study. */
static bool is_of_some_studies(const char *name)
{
    bool picture = strlen(name) == strlen("n-NNNN.png") && strncmp(name, "n-", 2) == 0 &&
                   strcmp(name + 6, ".png") == 0;
    for (int i = 2; picture && i < 6; i++)
        picture = isdigit((unsigned char)name[i]);
    return picture || strcmp(name, "times.csv") == 0;
}

static bool is_of_this_study(const glint_study_files *files, const char *name)
{
    for (int i = 0; i < files->count; i++)
        if (strcmp(files->entry[i].name, name) == 0)
            return true;
    return false;
}

static glint_status remove_file(const glint_study_files *files, const char *name, glint_error *err)
{
    char path[4096];
    struct stat info;
    const glint_status status = path_of(files, name, path, err);
    if (status != GLINT_OK || lstat(path, &info) != 0 || S_ISDIR(info.st_mode) ||
        glint_file_replaceable(path, NULL) != GLINT_OK || unlink(path) == 0)
        return status;
    return glint_fail(err, GLINT_IO_ERROR,
                      "cannot remove %.400s, left over from an earlier study: %s", path,
                      strerror(errno));
}

static glint_status remove_earlier(const glint_study_files *files, DIR *directory, glint_error *err)
{
    glint_status status = GLINT_OK;
    const struct dirent *found;
    while (status == GLINT_OK && (found = readdir(directory)) != NULL)
        if (is_of_some_studies(found->d_name) && !is_of_this_study(files, found->d_name))
            status = remove_file(files, found->d_name, err);
    return status;
}

glint_status glint_study_files_commit(glint_study_files *files, glint_error *err)
{
    glint_status status = GLINT_OK;
    DIR *directory = opendir(files->directory); /* that it can be read is sure before a rename */
    if (directory == NULL) {
        return glint_fail(err, GLINT_IO_ERROR, "cannot read %.400s: %s", files->directory,
                          strerror(errno));
    }
    for (int i = 0; i < files->count && status == GLINT_OK; i++) {
        glint_new_file *file = files->entry[i].file;
        files->entry[i].file = NULL; /* gone, well or not */
        status = glint_new_file_commit(file, err);
    }
    if (status == GLINT_OK)
        status = remove_earlier(files, directory, err);
    closedir(directory);
    return status;
}
