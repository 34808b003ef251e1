/* A list of numbers on the command line: "1,3,10", "1..1000", "0..80:10,89". */
#ifndef GLINT_SIM_CLI_NUMBER_LIST_H
#define GLINT_SIM_CLI_NUMBER_LIST_H

#include <stdbool.h>

#define GLINT_NUMBER_LIST_MAX 100000

typedef struct glint_number_list {
    double *value; /* ascending, none twice; to be freed */
    int count;     /* at least 1 */
} glint_number_list;

/* Comma-separated items: a number, A..B for the integers from A to B, or A..B:STEP for every
 * STEP-th of them. Returns false and leaves *list alone if the text is anything else, a number is
 * outside min…max, they do not ascend, there are more than GLINT_NUMBER_LIST_MAX, or memory runs
 * out. */
bool glint_number_list_parse(const char *text, double min, double max, glint_number_list *list);

#endif
