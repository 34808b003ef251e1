/* The claims on formulas, one after the other as the thesis has them. */
#include <math.h>

#include "reflectance/search.h"
#include "report/lobe_parts.h"

#define SAY(text, ...) snprintf(text, sizeof text, __VA_ARGS__)

static glint_verdict holds_if(bool held)
{
    return held ? GLINT_HOLDS : GLINT_DOES_NOT_HOLD;
}

static void say_exponents(glint_finding *finding, const glint_lobes *lobes, const char *where)
{
    SAY(finding->conditions, "%d exponents n = 1…1000, %s", lobes->exponents.count, where);
}

/* ---- 2.1: Schlick's function and its modification -------------------------------------------- */

static void find_schlick(const glint_lobes *lobes, glint_findings *findings)
{
    const double relative =
        100.0 * glint_lobes_worst(lobes, GLINT_REFLECTANCE_SCHLICK, 0).epicentre_relative.error;
    static const struct {
        const char *where;
        bool at_most;
        double stated;
        int decimals;
    } claims[] = {{"2.1", true, 3.2, 1}, {"2.7, 3.4, Conclusions", false, 10.0, 0}};
    for (size_t i = 0; i < sizeof claims / sizeof claims[0]; i++) {
        const double stated = claims[i].stated;
        const bool held = claims[i].at_most ? relative <= stated
                                            : glint_rounds_to(relative, stated, claims[i].decimals);
        glint_finding *finding = glint_findings_add(findings, holds_if(held), claims[i].where);
        SAY(finding->claim,
            "Schlick's function (2.1): largest relative error in the epicentre %s%.*f %%",
            claims[i].at_most ? "at most " : "", claims[i].decimals, stated);
        SAY(finding->measured, "%.2f %%", relative);
        say_exponents(finding, lobes, "where cos^n ≥ 0.6, the epicentre by section 2.1");
    }
}

static void find_modified(const glint_lobes *lobes, glint_findings *findings)
{
    static const glint_reflectance_model readings[] = {
        GLINT_REFLECTANCE_SCHLICK_MODIFIED, GLINT_REFLECTANCE_SCHLICK_MODIFIED_ANGLE,
        GLINT_REFLECTANCE_SCHLICK_MODIFIED_LINEAR, GLINT_REFLECTANCE_SCHLICK_MODIFIED_SQUARED};
    static const struct {
        const char *where, *claim;
        double stated;
    } claims[] = {
        {"2.1",
         "Modified Schlick (2.2): largest relative error 6.8 % from Schlick's own 10 %, "
         "so at most 3.2 %",
         3.2},
        {"2.7, Conclusions", "Modified Schlick (2.2): largest relative error at most 3.2 %", 3.2},
        {"3.4", "Modified Schlick: largest relative error at most 0.4 %", 0.4}};
    double relative[4], best = INFINITY;
    for (int i = 0; i < 4; i++) {
        relative[i] = 100.0 * glint_lobes_worst(lobes, readings[i], 0).epicentre_relative.error;
        best = fmin(best, relative[i]);
    }
    /* The one reading that would do, were it not for n = 1. */
    const double squared_from_2 =
        100.0 * glint_lobes_worst(lobes, GLINT_REFLECTANCE_SCHLICK_MODIFIED_SQUARED, 2)
                    .epicentre_relative.error;
    for (size_t i = 0; i < sizeof claims / sizeof claims[0]; i++) {
        glint_finding *finding =
            glint_findings_add(findings, holds_if(best <= claims[i].stated), claims[i].where);
        SAY(finding->claim, "%s", claims[i].claim);
        SAY(finding->measured,
            "%.1f %% as printed; %.1f %% with cos(γ²), %.1f %% with (1 − c)², %.1f %% with "
            "(n(1 − c))², which from n = 2 on has %.1f %%",
            relative[0], relative[1], relative[2], relative[3], squared_from_2);
        say_exponents(finding, lobes, "where cos^n ≥ 0.6; (2.2) as printed and three readings");
    }
}

static void find_table_32_form(const glint_lobes *lobes, glint_findings *findings)
{
    const double relative =
        100.0 * glint_lobes_worst(lobes, GLINT_REFLECTANCE_SCHLICK_MODIFIED_POWER, 0)
                    .epicentre_relative.error;
    glint_finding *finding =
        glint_findings_add(findings, GLINT_CANNOT_BE_DECIDED, "Table 3.2, 3.4");
    SAY(finding->claim, "Modified Schlick as cos^a/(n − n cos + cos): at most 0.4 %%");
    SAY(finding->measured, "%.2f %% with the best a for each n", relative);
    say_exponents(finding, lobes,
                  "where cos^n ≥ 0.6; the thesis gives no a, so the one was searched that makes "
                  "this error smallest");
}

/* ---- 2.2: the quadratic ---------------------------------------------------------------------- */

static void find_quadratic_decay(const glint_lobes *lobes, glint_findings *findings)
{
    const glint_worst decay =
        glint_lobe_worst_of(&lobes->exponents, lobes->quadratic_decay, 0).epicentre_relative;
    glint_finding *finding = glint_findings_add(findings, holds_if(decay.error <= 0.03), "2.2");
    SAY(finding->claim, "Quadratic: the same 3 %% in the zone of decay");
    SAY(finding->measured, "%.0f %% at n = %g; the largest absolute error is %.3f",
        100.0 * decay.error, decay.n,
        glint_lobes_worst(lobes, GLINT_REFLECTANCE_QUADRATIC, 0).absolute.error);
    say_exponents(finding, lobes, "where cos^n ≥ 0.01; negative values clamped to 0");
}

static void find_quadratic(const glint_lobes *lobes, glint_findings *findings)
{
    static const struct {
        const char *where, *claim;
        double at_most;
    } claims[] = {
        {"2.2", "Quadratic (2.3): relative error at most 3 % at levels of 0.56 and above", 3.0},
        {"Conclusions", "Quadratic (2.3): relative error at most 2 % in the epicentre", 2.0}};
    const glint_worst worst =
        glint_lobe_worst_of(&lobes->exponents, lobes->quadratic, 0).epicentre_relative;
    const glint_worst above_06 =
        glint_lobes_worst(lobes, GLINT_REFLECTANCE_QUADRATIC, 0).epicentre_relative;
    for (size_t i = 0; i < sizeof claims / sizeof claims[0]; i++) {
        const bool held = 100.0 * worst.error <= claims[i].at_most;
        glint_finding *finding = glint_findings_add(findings, holds_if(held), claims[i].where);
        SAY(finding->claim, "%s", claims[i].claim);
        SAY(finding->measured, "%.2f %% at n = %g; where cos^n ≥ 0.6 %.2f %%", 100.0 * worst.error,
            worst.n, 100.0 * above_06.error);
        say_exponents(finding, lobes, "where cos^n ≥ 0.56, as in figure 2.7");
    }
    find_quadratic_decay(lobes, findings);
}

/* (2.8) as it is printed. */
static double printed_a(double n)
{
    const double cosine = cos(atan(1.0 / sqrt(n - 1.0)));
    return (pow(cosine, n - 1.0) - 1.0) / (cosine - 1.0);
}

static void find_table_of_a(glint_findings *findings)
{
    int undefined = 0;
    double worst = 0.0;
    for (int n = 1; n <= 1000; n++) {
        const double a = printed_a(n);
        undefined += !isfinite(a) || n == 1;
        if (n > 1)
            worst = fmax(worst, fabs(a / glint_quadratic_a(n) - 1.0));
    }
    glint_finding *finding = glint_findings_add(findings, holds_if(undefined == 0), "(2.8)");
    SAY(finding->claim, "a can be tabulated for n = 1…1000 by (2.8)");
    SAY(finding->measured,
        "%d of 1000 cannot be computed: n = 1, 0/0; its limit, %g, makes the quadratic c itself",
        undefined, glint_quadratic_a(1.0));
    SAY(finding->conditions, "n = 1…1000; double precision loses %.0e of it, rewritten it does not",
        worst);
}

/* ---- 2.3: the cosine-quadratic --------------------------------------------------------------- */

/* ∫W sin γ dγ from 0 to the zero of W, by Simpson's rule in γ, times n + 1. */
static double integral_of_w(double n)
{
    enum { INTERVALS = 2000 };
    const double sigma = (n + 1.0) / 3.0;
    const double zero = acos((sigma - 1.0) / sigma);
    double sum = 0.0;
    for (int i = 0; i <= INTERVALS; i++) {
        const double angle = zero * i / INTERVALS;
        const double t = sigma * (cos(angle) - 1.0) + 1.0;
        const double weight = i == 0 || i == INTERVALS ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        sum += weight * t * t * sin(angle);
    }
    return (n + 1.0) * sum * zero / (3.0 * INTERVALS);
}

static void find_integral(const glint_lobes *lobes, glint_findings *findings)
{
    double worst = 0.0;
    for (int i = 0; i < lobes->exponents.count; i++)
        if (lobes->exponents.n[i] >= 2.0)
            worst = fmax(worst, fabs(integral_of_w(lobes->exponents.n[i]) - 1.0));
    glint_finding *finding = glint_findings_add(findings, holds_if(worst < 1e-9), "(2.13), (2.14)");
    SAY(finding->claim,
        "With σ = (n+1)/3 the integral of W over its lobe is that of cos^n, 1/(n+1)");
    SAY(finding->measured, "equal to within %.1e of it", worst);
    say_exponents(finding, lobes,
                  "from n = 2 on, Simpson's rule; at n = 1 W has its zero behind the surface");
}

static void find_absolute(const glint_lobes *lobes, glint_findings *findings)
{
    const glint_worst from_2 =
        glint_lobes_worst(lobes, GLINT_REFLECTANCE_COSINE_QUADRATIC, 2.0).absolute;
    const double at_1 = lobes->by_n[GLINT_REFLECTANCE_COSINE_QUADRATIC][0].absolute.error;
    glint_finding *finding = glint_findings_add(findings, holds_if(from_2.error <= 0.1), "2.3");
    SAY(finding->claim, "Cosine-quadratic (2.15): absolute error at most 0.1, n = 2…1000");
    SAY(finding->measured, "%.4f at n = %g", from_2.error, from_2.n);
    say_exponents(finding, lobes, "from n = 2 on, the whole lobe");
    finding = glint_findings_add(findings, holds_if(at_1 <= 0.1), "2.3");
    SAY(finding->claim, "Cosine-quadratic (2.15): absolute error at most 0.1, n = 1");
    SAY(finding->measured, "%.4f; the device %.4f", at_1, lobes->device.model.absolute.error);
    SAY(finding->conditions, "n = 1, the whole lobe, largest at c = 0, where W is 1/9");
}

static void find_relative(const glint_lobes *lobes, glint_findings *findings)
{
    const glint_worst worst =
        glint_lobes_worst(lobes, GLINT_REFLECTANCE_COSINE_QUADRATIC, 0).epicentre_relative;
    glint_finding *finding =
        glint_findings_add(findings, holds_if(worst.error <= 0.03), "2.7, 3.1, Conclusions");
    SAY(finding->claim, "Cosine-quadratic: relative error at most 3 %% in the epicentre");
    SAY(finding->measured, "%.1f %% at n = %g; the device %.1f %%", 100.0 * worst.error, worst.n,
        100.0 * lobes->device.model.epicentre_relative.error);
    say_exponents(finding, lobes, "where cos^n ≥ 0.6");
    const glint_worst decay =
        glint_lobe_worst_of(&lobes->exponents, lobes->cosine_quadratic_decay, 2).epicentre_relative;
    finding = glint_findings_add(findings, holds_if(decay.error <= 0.03), "2.7, 3.1, Conclusions");
    SAY(finding->claim, "Cosine-quadratic: the same 3 %% in the zone of decay");
    SAY(finding->measured, "%.0f %% at n = %g", 100.0 * decay.error, decay.n);
    say_exponents(
        finding, lobes,
        "from n = 2 on, where cos^n ≥ 0.01; W reaches zero where cos^n is still about 0.05");
}

/* W/cosⁿ − 1 at a cosine. */
static double excess(const void *context, double cosine)
{
    const double n = *(const double *)context;
    const double t = (n + 1.0) / 3.0 * (cosine - 1.0) + 1.0;
    return t * t / pow(cosine, n) - 1.0;
}

/* Rounded to the one decimal that the thesis gives, the level is 0.2 to 0.4. */
static bool is_stated_level(double lowest, double highest)
{
    return lowest >= 0.15 && highest < 0.45;
}

/* tan γ = √(1+2n)/n is c = n/(n+1). */
static void find_relative_place(const glint_lobes *lobes, glint_findings *findings)
{
    double apart = 0.0, lowest = 1.0, highest = 0.0, largest = 0.0, at_zero = 0.0;
    for (int i = 0; i < lobes->exponents.count; i++) {
        const double n = lobes->exponents.n[i];
        double cosine;
        if (n < 3.0)
            continue;
        largest = fmax(largest,
                       glint_search_maximum(excess, &n, (n - 2.0) / (n + 1.0), 1.0, 512, &cosine));
        at_zero = fmax(at_zero, -excess(&n, (n - 2.0) / (n + 1.0)));
        apart = fmax(apart, (n + 1.0) * fabs(cosine - n / (n + 1.0)));
        lowest = fmin(lowest, pow(n / (n + 1.0), n));
        highest = fmax(highest, pow(n / (n + 1.0), n));
    }
    glint_finding *finding = glint_findings_add(
        findings, holds_if(apart < 1e-4 && is_stated_level(lowest, highest)), "2.3");
    SAY(finding->claim, "The relative error W/cos^n − 1 has its maximum at tan γ = √(1+2n)/n, a "
                        "level of 0.2 to 0.4");
    SAY(finding->measured, "it is there, cos^n = %.3f to %.3f", lowest, highest);
    say_exponents(finding, lobes,
                  "from n = 3 on, before the zero of W; searched, not solved; the level to one "
                  "decimal");
    finding = glint_findings_add(findings, holds_if(largest >= at_zero), "2.3");
    SAY(finding->claim, "That is the largest relative error of all");
    SAY(finding->measured, "there it is up to %.1f %%; where W is zero and cos^n is not, %.0f %%",
        100.0 * largest, 100.0 * at_zero);
    say_exponents(finding, lobes, "from n = 3 on, cosines 0 to 1, the error without its sign");
}

/* tan γ = √(6n−3)/(n−2) is c = (n−2)/(n+1), where W is zero. */
static void find_absolute_place(const glint_lobes *lobes, glint_findings *findings)
{
    const int last = lobes->exponents.count - 1;
    const double n = lobes->exponents.n[last];
    const glint_largest_error worst =
        lobes->by_n[GLINT_REFLECTANCE_COSINE_QUADRATIC][last].absolute;
    const double there = pow((n - 2.0) / (n + 1.0), n);
    glint_finding *finding =
        glint_findings_add(findings, holds_if(fabs(there - worst.error) < 1e-3), "2.3");
    SAY(finding->claim, "The absolute error is largest at tan γ = √(6n−3)/(n−2)");
    SAY(finding->measured, "there W is zero and the error %.4f; the largest is %.4f, at c = %.6f",
        there, worst.error, worst.cosine);
    SAY(finding->conditions, "n = %g; the place is c = (n−2)/(n+1) = %.6f", n,
        (n - 2.0) / (n + 1.0));
}

/* ---- 3.1, 3.4: compared with Schlick's ------------------------------------------------------- */

static void find_ratio_to_schlick(const glint_lobes *lobes, glint_findings *findings)
{
    const glint_lobe_worst schlick = glint_lobes_worst(lobes, GLINT_REFLECTANCE_SCHLICK, 0);
    const glint_lobe_worst own = glint_lobes_worst(lobes, GLINT_REFLECTANCE_COSINE_QUADRATIC, 2);
    const double ratio = schlick.epicentre_absolute.error / own.epicentre_absolute.error;
    static const struct {
        const char *where;
        double stated;
    } claims[] = {{"3.1", 4.0}, {"3.4", 3.0}};
    for (size_t i = 0; i < sizeof claims / sizeof claims[0]; i++) {
        glint_finding *finding = glint_findings_add(
            findings, holds_if(glint_reaches(ratio, claims[i].stated, 0)), claims[i].where);
        SAY(finding->claim,
            "Cosine-quadratic: absolute error in the epicentre %g times below Schlick's",
            claims[i].stated);
        SAY(finding->measured,
            "%.2f times: %.4f against Schlick's %.4f; over the whole lobe %.2f times", ratio,
            own.epicentre_absolute.error, schlick.epicentre_absolute.error,
            schlick.absolute.error / own.absolute.error);
        say_exponents(finding, lobes, "where cos^n ≥ 0.6, cosine-quadratic from n = 2 on");
    }
}

static void find_quadratic_gain(const glint_lobes *lobes, glint_findings *findings)
{
    const glint_worst schlick =
        glint_lobes_worst(lobes, GLINT_REFLECTANCE_SCHLICK, 0).epicentre_relative;
    const glint_worst quadratic =
        glint_lobes_worst(lobes, GLINT_REFLECTANCE_QUADRATIC, 0).epicentre_relative;
    glint_finding *finding = glint_findings_add(findings, GLINT_CANNOT_BE_DECIDED, "3.4");
    SAY(finding->claim, "Quadratic: the epicentre more than 10 times as accurate");
    SAY(finding->measured, "%.1f times as accurate as Schlick's function",
        schlick.error / quadratic.error);
    say_exponents(finding, lobes,
                  "relative error where cos^n ≥ 0.6; the thesis does not say than "
                  "what");
}

void glint_lobes_find(const glint_lobes *lobes, glint_findings *findings)
{
    find_schlick(lobes, findings);
    find_modified(lobes, findings);
    find_table_32_form(lobes, findings);
    find_quadratic(lobes, findings);
    find_table_of_a(findings);
    find_integral(lobes, findings);
    find_absolute(lobes, findings);
    find_relative(lobes, findings);
    find_relative_place(lobes, findings);
    find_absolute_place(lobes, findings);
    find_ratio_to_schlick(lobes, findings);
    find_quadratic_gain(lobes, findings);
}
