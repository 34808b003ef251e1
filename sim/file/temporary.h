/* Temporary names next to an output file, and the removal of what killed processes left under them.
 *
 * A name is .glint-HOST-PID-N.tmp in the directory of the target: HOST stands for the machine and
 * its process numbers (a container's are its own), so a name tells whether its process is still
 * alive. */
#ifndef GLINT_SIM_FILE_TEMPORARY_H
#define GLINT_SIM_FILE_TEMPORARY_H

/* Below it the numbers of new_file.h, each tried until one is free; the others are for who makes
 * something else beside a target. */
enum { GLINT_TEMPORARY_FILES = 1000, GLINT_TEMPORARY_WAVE, GLINT_TEMPORARY_PACKET };

/* The name beside target with the number N = attempt, to be freed; NULL without memory. */
char *glint_temporary_name(const char *target, int attempt);

/* Removes files, and directories with their files, next to target whose names follow or start like
 * this scheme and whose processes, of this user on this machine, are gone. Anything that cannot be
 * removed stays and does no harm. */
void glint_temporary_sweep(const char *target);

#endif
