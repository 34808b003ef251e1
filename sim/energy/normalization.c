/* Equations (2.25) and (2.26), as printed and as corrected, each integrated numerically. */
#include "energy/normalization.h"

#include <math.h>

#include "energy/gauss.h"

#define PI 3.14159265358979323846

/* Enough for the five harmonics of the integrand over a whole turn. */
#define ORDER 32

double glint_printed_limit(double n)
{
    return 5.8 / sqrt(n);
}

static double printed(const void *context, double angle)
{
    const double n = *(const double *)context;
    const double line = (n + 1.0) / 3.0 * (cos(0.5 * angle) - 1.0) + 1.0;
    return 2.0 * PI * line * line * cos(angle) * sin(angle);
}

static double printed_by_solid_angle(const void *context, double angle)
{
    return printed(context, angle) * sin(angle);
}

static double integrate(glint_integrand *f, double n, double limit)
{
    glint_gauss rule;
    glint_gauss_make(ORDER, &rule);
    return glint_gauss_integrate(&rule, f, &n, 0.0, limit);
}

double glint_printed_albedo(double n, double limit)
{
    return integrate(printed, n, limit);
}

double glint_printed_albedo_by_solid_angle(double n, double limit)
{
    return integrate(printed_by_solid_angle, n, limit);
}

/* 2π ∫ (a + bc)² c dc from 0 to 1 */
double glint_misprinted_albedo(double n)
{
    const double sigma = (n + 1.0) / 3.0;
    const double a = 1.0 - sigma, b = 0.5 * sigma;
    return 2.0 * PI * (a * a / 2.0 + 2.0 * a * b / 3.0 + b * b / 4.0);
}

void glint_normalization_for(double a, const double *albedo, int count, glint_normalization *result)
{
    double least = INFINITY, sum = 0.0;
    *result = (glint_normalization){.a = a};
    for (int i = 0; i < count; i++) {
        const double line = (i + 1 + a) * albedo[i];
        sum += line;
        if (line > result->b) {
            result->b = line;
            result->tight_n = i + 1;
        }
        if (line < least) {
            least = line;
            result->largest_n = i + 1;
        }
    }
    result->mean_loss = 1.0 - sum / count / result->b;
    result->largest_loss = 1.0 - least / result->b;
}

static double loss_of(glint_loss loss, const glint_normalization *of)
{
    return loss == GLINT_LOSS_MEAN ? of->mean_loss : of->largest_loss;
}

/* Golden section from −1 to A_MAX leaves less than 1e-12 after as many steps. */
#define STEPS 75

void glint_normalization_best(glint_loss loss, const double *albedo, int count,
                              glint_normalization *result)
{
    const double golden = 0.5 * (sqrt(5.0) - 1.0);
    double low = -1.0, high = GLINT_NORMALIZATION_A_MAX;
    double left = high - golden * (high - low), right = low + golden * (high - low);
    glint_normalization at_left, at_right;
    glint_normalization_for(left, albedo, count, &at_left);
    glint_normalization_for(right, albedo, count, &at_right);
    for (int i = 0; i < STEPS; i++) {
        if (loss_of(loss, &at_left) < loss_of(loss, &at_right)) {
            high = right;
            right = left;
            at_right = at_left;
            left = high - golden * (high - low);
            glint_normalization_for(left, albedo, count, &at_left);
        } else {
            low = left;
            left = right;
            at_left = at_right;
            right = low + golden * (high - low);
            glint_normalization_for(right, albedo, count, &at_right);
        }
    }
    *result = at_left;
}
