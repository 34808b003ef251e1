/* Output pictures: one rule for every command that writes one under a user-chosen name.
 *
 * The name must end in .png, unless it is an existing non-file (a pipe, /dev/null). "-" is standard
 * output, rejected if that is a terminal; messages then go to standard error. An existing file that
 * is not a PNG is overwritten only with --force. A symbolic link is followed, and its target is
 * created if missing (file/new_file.h). */
#ifndef GLINT_SIM_CLI_PICTURE_H
#define GLINT_SIM_CLI_PICTURE_H

#include <stdbool.h>
#include <stdio.h>

#include "image/image.h"

bool glint_picture_is_stdout(const char *path);

/* Checks beforehand whether a picture may go there. option: the option's name, for messages. */
glint_status glint_picture_check(const char *option, const char *path, bool force,
                                 glint_error *err);

/* Writes it, unless the process is asked to stop, with progress on a terminal. */
glint_status glint_picture_write(const char *command, const glint_image *image, const char *path,
                                 glint_error *err);

/* The stream for the command's messages when it writes that picture. path NULL: no picture. */
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
