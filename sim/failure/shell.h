/* Command lines ready to paste into a shell. */
#ifndef GLINT_SIM_FAILURE_SHELL_H
#define GLINT_SIM_FAILURE_SHELL_H

#include <stddef.h>

/* Appends the word to text, a string in a buffer of `size`, as a shell reads it back: quoted if it
 * contains special characters. Text that does not fit is cut. */
#define GLINT_SHELL_WORD(size) (4 * (size) + 3) /* room for any word of a buffer of that size */
void glint_shell_append(char *text, size_t size, const char *word);

#endif
