/* The report on the divider: the thesis's section 2.4 in numbers of our own. */
#ifndef GLINT_SIM_REPORT_DIVIDER_REPORT_H
#define GLINT_SIM_REPORT_DIVIDER_REPORT_H

#include <cjson/cJSON.h>

#include "report/claims.h"
#include "report/divider_error.h"

#define GLINT_REPORT_SHIFTS (GLINT_DIVIDER_SHIFTS_MAX - GLINT_DIVIDER_SHIFTS_MIN + 1)

typedef struct glint_divider_report {
    glint_divider_error error[GLINT_BITS_RULE_COUNT][GLINT_REPORT_SHIFTS]; /* from SHIFTS_MIN on */
    int first_within_half[GLINT_BITS_RULE_COUNT];
    glint_table_21 table;
    glint_divider_scene scenes[GLINT_DIVIDER_SCENES];
    glint_claims claims;
    bool plotted; /* false: there is no gnuplot, so figure-2.12.svg and .png were not made */
} glint_divider_report;

/* Measures everything, on so many threads, and writes divider.md, divider.json, figure-2.12.svg and
 * .png with what gnuplot makes them from (.dat, .gnuplot), and the pictures of the frames into the
 * directory, made if missing. */
glint_status glint_divider_report_make(const char *directory, int threads,
                                       const volatile bool *stop, glint_divider_report *report,
                                       glint_error *err);

/* What divider.json holds; NULL: no memory. */
cJSON *glint_divider_report_json(const glint_divider_report *report);

#endif
