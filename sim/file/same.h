/* Whether two paths lead to one file. */
#ifndef GLINT_SIM_FILE_SAME_H
#define GLINT_SIM_FILE_SAME_H

#include <stdbool.h>

/* True when both paths name one existing regular file, however each is spelt. */
bool glint_file_same(const char *a, const char *b);

#endif
