/* The chapters, and what they have in common. */
#include "report/chapter.h"

#include <string.h>

#include "report/place.h"
#include "report/texts.h"

const glint_chapter glint_chapters[] = {
    {"device", "The device (section 3.1, figure 3.1)", glint_chapter_device, glint_text_device},
    {"lobes", "The formulas (sections 2.1 to 2.3, figures 2.2 to 2.7 and 2.10)",
     glint_chapter_lobes, glint_text_lobes},
    {"divider", "Division by shifts (section 2.4, figures 2.12 and 2.13, Table 2.1)",
     glint_chapter_divider, glint_text_divider},
    {"energy", "Energy (section 2.5, figures 2.15 and 2.16)", glint_chapter_energy,
     glint_text_energy},
    {"frames", "Pictures (section 3.4, Table 3.2, figures 3.12 and 3.13)", glint_chapter_frames,
     glint_text_frames},
    {"rasterizers", "Rasterizers (section 1.3, appendix A, figures 2.1, 2.8, 2.9, 2.11 and 2.14)",
     glint_chapter_rasterizers, glint_text_rasterizers},
    {"speed", "Speed of the formulas (sections 3.1 and 3.4)", glint_chapter_speed,
     glint_text_speed},
    {"units", "Units for a highlight in hardware, side by side", glint_chapter_units,
     glint_text_units},
    {"trace", "Ray tracing with pixel segments (section 2.6, figures 2.17 to 2.19)",
     glint_chapter_trace, glint_text_trace},
};
const int glint_chapter_count = sizeof glint_chapters / sizeof glint_chapters[0];

const glint_chapter *glint_chapter_find(const char *name)
{
    for (int i = 0; i < glint_chapter_count; i++)
        if (strcmp(glint_chapters[i].name, name) == 0)
            return &glint_chapters[i];
    return NULL;
}

glint_status glint_report_go_on(const glint_report *report, glint_error *err)
{
    if (report->stop != NULL && *report->stop)
        return glint_fail(err, GLINT_INTERRUPTED, "interrupted");
    return GLINT_OK;
}

glint_status glint_report_open(const glint_report *report, const char *name, glint_new_file **file,
                               glint_error *err)
{
    glint_place place;
    const glint_status status = glint_place_in(report->directory, name, &place, err);
    return status == GLINT_OK ? glint_new_file_open(place.path, file, err) : status;
}

glint_status glint_report_write_png(const glint_report *report, const glint_image *image,
                                    const char *name, glint_error *err)
{
    glint_place place;
    const glint_status status = glint_place_in(report->directory, name, &place, err);
    return status == GLINT_OK ? glint_image_write_png(image, place.path, err) : status;
}

glint_status glint_report_write_lines(const glint_report *report, const char *const *lines,
                                      const char *name, glint_error *err)
{
    glint_new_file *file;
    const glint_status status = glint_report_open(report, name, &file, err);
    if (status != GLINT_OK)
        return status;
    for (; *lines != NULL; lines++)
        fprintf(glint_new_file_stream(file), "%s\n", *lines);
    return glint_new_file_commit(file, err);
}
