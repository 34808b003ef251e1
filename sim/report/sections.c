#include "report/sections.h"

const glint_report_entry glint_report_sections[] = {
    {"The lobes (sections 2.1 to 2.3, figures 2.2 to 2.7 and 2.10)", "lobes", glint_section_lobes},
    {"Division by shifts (section 2.4, figure 2.12, Table 2.1)", "divider", glint_section_divider},
    {"Energy (section 2.5, figures 2.15 and 2.16)", "energy", glint_section_energy},
    {"Pictures (section 3.4, Table 3.2, figures 3.12 and 3.13)", "frames", glint_section_frames},
    {"Speed of the formulas (sections 3.1 and 3.4)", "speed", glint_section_speed},
};
const int glint_report_section_count =
    sizeof glint_report_sections / sizeof glint_report_sections[0];
