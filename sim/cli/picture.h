/* Where a picture goes: one rule for every command that writes one under a name its user chose.
 *
 * Its name ends in .png, unless what is there is no file (a pipe, /dev/null). "-" is standard
 * output, refused when that is a terminal; what the command says goes to standard error then. A
 * file that is there and is no PNG is overwritten with --force only. A symbolic link is followed,
 * and what it names is made if missing (file/new_file.h). */
#ifndef GLINT_SIM_CLI_PICTURE_H
#define GLINT_SIM_CLI_PICTURE_H

#include <stdbool.h>
#include <stdio.h>

#include "image/image.h"

bool glint_picture_is_stdout(const char *path);

/* Before the work: whether a picture may go there. option: what named it, for messages. */
glint_status glint_picture_check(const char *option, const char *path, bool force,
                                 glint_error *err);

/* Writes it, until the process is asked to stop; tells a terminal how far it is. */
glint_status glint_picture_write(const char *command, const glint_image *image, const char *path,
                                 glint_error *err);

/* Where a command that writes that picture says what it has to say. path NULL: no picture. */
FILE *glint_picture_talk(const char *path);

/* A row of an option table, and lines for its details. */
#define GLINT_FORCE_OPTION(FLAG)                                                                   \
    {                                                                                              \
        .name = "force", .help = "overwrite an existing file of another kind",                     \
        .kind = GLINT_OPTION_FLAG, .flag = (FLAG)                                                  \
    }
#define GLINT_PICTURE_DETAILS                                                                      \
    "A picture's name ends in .png; - is standard output, and messages then go to\n"               \
    "standard error. Links are followed. An existing file that is not a PNG is not\n"              \
    "overwritten without --force.\n"

#endif
