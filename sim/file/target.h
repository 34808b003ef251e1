/* Where a path for output leads. */
#ifndef GLINT_SIM_FILE_TARGET_H
#define GLINT_SIM_FILE_TARGET_H

/* The path at the end of a chain of symbolic links (path itself if it is not a link), whether it
 * exists or not. Returns 0 with *target for the caller to free, or an errno: ELOOP for a loop. */
int glint_target_follow(const char *path, char **target);

#endif
