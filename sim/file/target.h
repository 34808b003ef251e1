/* Where a path for output leads. */
#ifndef GLINT_SIM_FILE_TARGET_H
#define GLINT_SIM_FILE_TARGET_H

/* The path at the end of the symbolic links that path is, itself where it is none: what is to be
 * written, whether it is there or not. Returns 0 with *target to be freed, or an errno: ELOOP for
 * links that go in a circle. */
int glint_target_follow(const char *path, char **target);

#endif
