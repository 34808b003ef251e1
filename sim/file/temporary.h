/* Names for what is in the making, beside what it will be, and the removal of what a process left
 * there that was killed.
 *
 * A name is .glint-HOST-PID-N.tmp in the directory of the target: HOST stands for the machine and
 * its process numbers (a container's are its own), so that a name tells whether who made it is
 * alive. */
#ifndef GLINT_SIM_FILE_TEMPORARY_H
#define GLINT_SIM_FILE_TEMPORARY_H

/* Below it the numbers of new_file.h, each tried until one is free; the others are for who makes
 * something else beside a target. */
enum { GLINT_TEMPORARY_FILES = 1000, GLINT_TEMPORARY_WAVE, GLINT_TEMPORARY_PACKET };

/* The name beside target with the number N = attempt, to be freed; NULL without memory. */
char *glint_temporary_name(const char *target, int attempt);

/* Removes what lies beside target under such a name, or under one that only begins so, and was made
 * by this user's processes on this machine that are no longer there: files, and directories with
 * the files in them. What cannot be removed stays: it is in nobody's way. */
void glint_temporary_sweep(const char *target);

#endif
