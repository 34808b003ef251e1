/* Deliberately broken circuits: copies of rtl/ with one edit, which the Makefile creates under
 * build/wrong. */
#ifndef GLINT_TESTS_WRONG_H
#define GLINT_TESTS_WRONG_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The directory of the fault of that name; stays. */
static inline const char *wrong_rtl(const char *fault)
{
    enum { MOST = 32, LENGTH = 512 };
    static char directory[MOST][LENGTH];
    static int count;
    const char *build = getenv("GLINT_BUILD");
    char wanted[LENGTH];
    int i = 0;
    (void)snprintf(wanted, sizeof wanted, "%s/wrong/%s", build != NULL ? build : "build", fault);
    while (i < count && strcmp(directory[i], wanted) != 0)
        i++;
    if (i == count && count < MOST)
        memcpy(directory[count++], wanted, sizeof wanted);
    return directory[i];
}

#endif
