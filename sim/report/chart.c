/* Writes the data and a script, and has gnuplot draw them. */
#include "report/chart.h"

#include "report/plot.h"

/* Each curve has its own dashes, to be distinguishable in black and white. */
static const char *const colors[GLINT_CHART_CURVES_MAX] = {
    "#1f618d", "#c0392b", "#1e8449", "#d68910", "#6c3483", "#148f77", "#7b7d7d", "#a04000"};

static glint_status write_data(const glint_report *report, const glint_chart *chart,
                               const double *values, int rows, glint_error *err)
{
    char name[128];
    glint_new_file *file;
    snprintf(name, sizeof name, "%s.dat", chart->name);
    const glint_status status = glint_report_open(report, name, &file, err);
    if (status != GLINT_OK)
        return status;
    FILE *out = glint_new_file_stream(file);
    fprintf(out, "# %s\n# %s", chart->title, chart->x_label);
    for (int i = 0; i < chart->curves; i++)
        fprintf(out, " | %s", chart->curve[i]);
    fputc('\n', out);
    for (int row = 0; row < rows; row++)
        for (int i = 0; i <= chart->curves; i++)
            fprintf(out, "%.9g%c", values[row * (chart->curves + 1) + i],
                    i < chart->curves ? ' ' : '\n');
    return glint_new_file_commit(file, err);
}

static glint_status write_script(const glint_report *report, const glint_chart *chart,
                                 glint_error *err)
{
    char name[128];
    glint_new_file *file;
    snprintf(name, sizeof name, "%s.gnuplot", chart->name);
    const glint_status status = glint_report_open(report, name, &file, err);
    if (status != GLINT_OK)
        return status;
    FILE *out = glint_new_file_stream(file);
    fprintf(out,
            "# gnuplot -e \"set terminal svg; set output '%s.svg'\" %s.gnuplot\n"
            "set title \"%s\"\nset xlabel \"%s\"\nset ylabel \"%s\"\n"
            "set grid linecolor '#d0d0d0'\nset key top right\n%s"
            "plot",
            chart->name, chart->name, chart->title, chart->x_label, chart->y_label,
            chart->settings != NULL ? chart->settings : "");
    for (int i = 0; i < chart->curves; i++)
        fprintf(out,
                "%s \\\n  '%s.dat' using 1:%d title \"%s\" with %s linewidth 2 dashtype %d "
                "linecolor '%s'",
                i > 0 ? "," : "", chart->name, i + 2, chart->curve[i],
                chart->style != NULL ? chart->style : "lines", i % 5 + 1, colors[i]);
    fputc('\n', out);
    return glint_new_file_commit(file, err);
}

glint_status glint_chart_draw(glint_report *report, const glint_chart *chart, const double *values,
                              int rows, glint_error *err)
{
    const glint_plot_limits limits = {report->stop, GLINT_PLOT_SECONDS};
    bool plotted = false;
    glint_status status = write_data(report, chart, values, rows, err);
    if (status == GLINT_OK)
        status = write_script(report, chart, err);
    if (status == GLINT_OK)
        status = glint_report_go_on(report, err);
    if (status == GLINT_OK)
        status = glint_plot(report->directory, chart->name, &limits, &plotted, err);
    report->plotted = report->plotted && plotted;
    return status;
}
