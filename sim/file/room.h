/* Whether a file could be written, asked beforehand: for writers that do not tell afterwards. */
#ifndef GLINT_SIM_FILE_ROOM_H
#define GLINT_SIM_FILE_ROOM_H

#include "glint_status.h"

/* Tries whether path can be written and has room for so many bytes, and the directory of temporary
 * files, too; nothing is left at path, an old file neither. GLINT_IO_ERROR says what is missing. */
glint_status glint_file_room(const char *path, long bytes, glint_error *err);

#endif
