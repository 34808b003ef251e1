/* What the code of a circuit of one's own may do to the command: crash, end it, or never come back.
 * Each ends the process with one line on standard error and the exit status for trouble. */
#ifndef GLINT_SIM_CIRCUIT_GUARD_H
#define GLINT_SIM_CIRCUIT_GUARD_H

#define GLINT_GUARD_EXIT_STATUS 2

/* From here on a crash, an exit() and a call of the C model that takes longer than
 * GLINT_GUARD_SECONDS are blamed on the code in this directory, unless a handler of a caller's own
 * is there. Once in a process. */
void glint_guard_begin(const char *directory);

/* The command is done: what ends the process now is main() that returns. */
void glint_guard_end(void);

/* Around each call into the C model; of a thread they do not nest. A time in which the process
 * waits, as at a debugger's breakpoint, does not count. */
#define GLINT_GUARD_SECONDS 10
void glint_guard_enter(void);
void glint_guard_leave(void);

#endif
