/* Figure 2.12: what gnuplot reads. */
#include "report/divider_parts.h"

static const int shifts_shown[] = {6, 7, 8};

#define SHOWN ((int)(sizeof shifts_shown / sizeof shifts_shown[0]))

void glint_divider_write_plot_data(FILE *out)
{
    fprintf(out, "# relative error of the increment, %%\n# k");
    for (int i = 0; i < SHOWN; i++)
        fprintf(out, " n=%d", shifts_shown[i]);
    fputc('\n', out);
    for (int k = GLINT_ERROR_K_MIN; k <= GLINT_DIVIDER_K_MAX; k++) {
        fprintf(out, "%d", k);
        for (int i = 0; i < SHOWN; i++)
            fprintf(out, " %.9g",
                    100.0 * glint_divider_relative_error(shifts_shown[i], GLINT_BITS_ROUNDED, k));
        fputc('\n', out);
    }
}

void glint_divider_write_plot_script(FILE *out)
{
    static const char *const colors[SHOWN] = {"#c0392b", "#d68910", "#1f618d"};
    static const int points[SHOWN] = {5, 7, 9};
    fprintf(out,
            "# gnuplot -e \"set terminal svg; set output 'figure-2.12.svg'\" figure-2.12.gnuplot\n"
            "set title 'Relative error of the increment by span length (figure 2.12)'\n"
            "set xlabel 'span length k'\n"
            "set ylabel 'relative error, %%'\n"
            "set xrange [%d - 0.5 : %d + 0.5]\n"
            "set yrange [0 : *]\n"
            "set xtics %d, 1\n"
            "set grid linecolor '#d0d0d0'\n"
            "set key top left\n"
            "plot",
            GLINT_ERROR_K_MIN, GLINT_DIVIDER_K_MAX, GLINT_ERROR_K_MIN);
    for (int i = 0; i < SHOWN; i++)
        fprintf(out,
                "%s \\\n  'figure-2.12.dat' using 1:%d title 'n = %d' with linespoints "
                "linewidth 2 pointtype %d linecolor '%s'",
                i > 0 ? "," : "", i + 2, shifts_shown[i], points[i], colors[i]);
    fputc('\n', out);
}
