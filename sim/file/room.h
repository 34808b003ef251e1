/* Checks beforehand whether a file can be written, for writers that do not report errors. */
#ifndef GLINT_SIM_FILE_ROOM_H
#define GLINT_SIM_FILE_ROOM_H

#include "glint_status.h"

/* Checks that path is writable with room for this many bytes, and likewise the temporary directory;
 * leaves nothing at path, not even an old file. GLINT_IO_ERROR says what is missing. */
glint_status glint_file_room(const char *path, long bytes, glint_error *err);

#endif
