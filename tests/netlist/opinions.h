/* Alternative builds of circuits, as listed by tests/circuits.mk. */
#ifndef GLINT_TESTS_NETLIST_OPINIONS_H
#define GLINT_TESTS_NETLIST_OPINIONS_H

#include <stdbool.h>

#include "circuit/setting.h"

#define OPINIONS_MAX 128

typedef struct opinion {
    char name[128];      /* BUILD[-FAULT]/SETTING, as in tests/circuit.sh */
    char directory[512]; /* where that put it */
    char verilog[520];   /* below it, of the setting */
    glint_setting setting;
} opinion;

/* The list in the file that GLINT_OPINIONS names, or $GLINT_BUILD/`otherwise`: a line is a
 * directory …/BUILD[-FAULT]/SETTING. Returns their number; −1 after reporting an error. */
int opinions_read(const char *otherwise, opinion opinions[OPINIONS_MAX]);

/* From now on circuits are built with its tools. */
bool opinion_choose(const opinion *opinion);

#endif
