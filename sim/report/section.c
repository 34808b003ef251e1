#include "report/section.h"

#include "report/place.h"
#include "report/plot.h"

glint_status glint_report_open(const glint_report *report, const char *name, glint_new_file **file,
                               glint_error *err)
{
    glint_place place;
    const glint_status status = glint_place_in(report->directory, name, &place, err);
    return status == GLINT_OK ? glint_new_file_open(place.path, file, err) : status;
}

glint_status glint_report_figure(glint_report *report, const char *name, const char *caption,
                                 glint_error *err)
{
    const glint_plot_limits limits = {report->stop, GLINT_PLOT_SECONDS};
    bool plotted;
    glint_status status = glint_report_go_on(report, err);
    if (status == GLINT_OK)
        status = glint_plot(report->directory, name, &limits, &plotted, err);
    if (status != GLINT_OK)
        return status;
    report->plotted = report->plotted && plotted;
    if (plotted)
        fprintf(report->markdown, "\n![%s](%s.svg)\n\n*%s*\n\n", caption, name, caption);
    else
        fprintf(report->markdown,
                "\n*%s* (There was no gnuplot to draw it; the data is in %s.dat.)\n\n", caption,
                name);
    return GLINT_OK;
}

glint_status glint_report_go_on(const glint_report *report, glint_error *err)
{
    if (report->stop != NULL && *report->stop)
        return glint_fail(err, GLINT_INTERRUPTED, "interrupted");
    return GLINT_OK;
}
