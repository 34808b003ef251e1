/* The sections of the report, one file each, in the order of sections.c. */
#ifndef GLINT_SIM_REPORT_SECTIONS_H
#define GLINT_SIM_REPORT_SECTIONS_H

#include "report/section.h"

typedef struct glint_report_entry {
    const char *title; /* its heading, of level 2 */
    const char *name;  /* of its object in index.json */
    glint_report_section *write;
} glint_report_entry;

extern const glint_report_entry glint_report_sections[];
extern const int glint_report_section_count;

glint_report_section glint_section_lobes;
glint_report_section glint_section_divider;
glint_report_section glint_section_energy;
glint_report_section glint_section_frames;
glint_report_section glint_section_speed;

#endif
