/* The claims on formulas, one after the other as the thesis has them. */
#include <math.h>
#include <stdarg.h>

#include "report/lobe_parts.h"

#define SAY(text, ...) snprintf(text, sizeof text, __VA_ARGS__)

static const glint_n_range n_is_1 = {1.0, 1.0}, from_2 = {2.0, INFINITY},
                           with_end = {GLINT_LOBE_ENDS_FROM, INFINITY};

/* Figure 2.7's. */
static const glint_n_range figure_27 = {1.0, 512.0};

/* Integrals that differ by less are one and the same, relatively: what Simpson's rule leaves. */
#define SAME_INTEGRAL 1e-9

/* Places that are less apart are one and the same, in widths of the lobe: what a search leaves. */
#define SAME_PLACE 1e-4

/* The exponents that were measured in the range, then where. */
static void say(glint_finding *finding, const glint_lobes *lobes, glint_n_range range,
                const char *where, ...)
{
    char exponents[64], rest[400];
    va_list values;
    glint_exponents_say(&lobes->exponents, range, exponents, sizeof exponents);
    va_start(values, where);
    vsnprintf(rest, sizeof rest, where, values);
    va_end(values);
    SAY(finding->conditions, "%s, %s", exponents, rest);
}

/* In per cent. */
static double relative_of(const glint_lobes *lobes, glint_reflectance_model model,
                          glint_n_range range)
{
    return 100.0 * glint_lobes_worst(lobes, model, range).epicentre_relative.error;
}

static void widen(glint_judged *judged, double measured)
{
    judged->lowest = fmin(judged->lowest, measured);
    judged->highest = fmax(judged->highest, measured);
}

/* ---- 2.1: Schlick's function and its modification -------------------------------------------- */

static void find_schlick(const glint_lobes *lobes, glint_findings *findings)
{
    static const struct {
        const char *where;
        glint_rule rule;
        double stated;
        int decimals;
    } claims[] = {{"2.1", GLINT_AT_MOST, 3.2, 1},
                  {"2.7, 3.4, Conclusions", GLINT_ROUNDS_TO, 10.0, 0}};
    const double relative = relative_of(lobes, GLINT_REFLECTANCE_SCHLICK, glint_n_all);
    for (size_t i = 0; i < sizeof claims / sizeof claims[0]; i++) {
        const glint_judged judged =
            glint_judged_number(claims[i].rule, claims[i].stated, claims[i].decimals, relative);
        glint_finding *finding = glint_findings_add(findings, claims[i].where, &judged);
        SAY(finding->claim,
            "Schlick's function (2.1): largest relative error in the epicentre %s%.*f %%",
            claims[i].rule == GLINT_AT_MOST ? "at most " : "", judged.decimals, judged.stated);
        SAY(finding->measured, "%.2f %%", relative);
        say(finding, lobes, glint_n_all, "where cos^n ≥ %g, the epicentre by section 2.1",
            GLINT_EPICENTRE_LEVEL);
    }
}

/* (2.2) as printed and as it can be read. */
static const glint_reflectance_model readings[] = {
    GLINT_REFLECTANCE_SCHLICK_MODIFIED, GLINT_REFLECTANCE_SCHLICK_MODIFIED_ANGLE,
    GLINT_REFLECTANCE_SCHLICK_MODIFIED_LINEAR, GLINT_REFLECTANCE_SCHLICK_MODIFIED_SQUARED};

#define READINGS ((int)(sizeof readings / sizeof readings[0]))

static void find_modified(const glint_lobes *lobes, glint_findings *findings)
{
    static const struct {
        const char *where, *claim;
        double stated;
    } claims[] = {
        {"2.1",
         "Modified Schlick (2.2): largest relative error 6.8 % from Schlick's own 10 %, so at most",
         3.2},
        {"2.7, Conclusions", "Modified Schlick (2.2): largest relative error at most", 3.2},
        {"3.4", "Modified Schlick: largest relative error at most", 0.4}};
    double relative[READINGS];
    glint_judged judged = {.rule = GLINT_AT_MOST, .decimals = 1, .lowest = NAN, .highest = NAN};
    for (int i = 0; i < READINGS; i++) {
        relative[i] = relative_of(lobes, readings[i], glint_n_all);
        widen(&judged, relative[i]);
    }
    const double squared_from_2 =
        relative_of(lobes, GLINT_REFLECTANCE_SCHLICK_MODIFIED_SQUARED, from_2);
    for (size_t i = 0; i < sizeof claims / sizeof claims[0]; i++) {
        judged.stated = claims[i].stated;
        glint_finding *finding = glint_findings_add(findings, claims[i].where, &judged);
        SAY(finding->claim, "%s %.1f %%", claims[i].claim, judged.stated);
        SAY(finding->measured,
            "%.1f %% as printed; %.1f %% with cos(γ²), %.1f %% with (1 − c)², %.1f %% with "
            "(n(1 − c))², which from n = %g on has %.1f %%",
            relative[0], relative[1], relative[2], relative[3], from_2.from, squared_from_2);
        say(finding, lobes, glint_n_all,
            "where cos^n ≥ %g; (2.2) as printed and %d other readings, one verdict on all of them",
            GLINT_EPICENTRE_LEVEL, READINGS - 1);
    }
}

/* Its a is not given: the best makes the error least, and a = 1 makes it Schlick's function. */
static void find_table_32_form(const glint_lobes *lobes, glint_findings *findings)
{
    const double best = relative_of(lobes, GLINT_REFLECTANCE_SCHLICK_MODIFIED_POWER, glint_n_all);
    const double plain = relative_of(lobes, GLINT_REFLECTANCE_SCHLICK, glint_n_all);
    glint_judged judged = glint_judged_number(GLINT_AT_MOST, 0.4, 1, best);
    widen(&judged, plain);
    glint_finding *finding = glint_findings_add(findings, "Table 3.2, 3.4", &judged);
    SAY(finding->claim, "Modified Schlick as cos^a/(n − n cos + cos): at most %.1f %%",
        judged.stated);
    SAY(finding->measured,
        "%.2f %% with the best a for each n; %.2f %% with a = 1, which is Schlick's function", best,
        plain);
    say(finding, lobes, glint_n_all,
        "largest relative error where cos^n ≥ %g; the thesis gives no a, so for each n the one was "
        "searched that makes this error smallest",
        GLINT_EPICENTRE_LEVEL);
}

/* ---- 2.2: the quadratic ---------------------------------------------------------------------- */

static void find_quadratic_decay(const glint_lobes *lobes, glint_findings *findings)
{
    const glint_worst decay =
        glint_lobe_worst_of(&lobes->exponents, lobes->quadratic_decay, glint_n_all)
            .epicentre_relative;
    const glint_judged judged = glint_judged_number(GLINT_AT_MOST, 3.0, 0, 100.0 * decay.error);
    glint_finding *finding = glint_findings_add(findings, "2.2", &judged);
    SAY(finding->claim, "Quadratic: the same %.0f %% in the zone of decay", judged.stated);
    SAY(finding->measured, "%.0f %% at n = %g; the largest absolute error is %.3f", judged.lowest,
        decay.n, glint_lobes_worst(lobes, GLINT_REFLECTANCE_QUADRATIC, glint_n_all).absolute.error);
    say(finding, lobes, glint_n_all, "where cos^n ≥ %g; negative values clamped to 0",
        GLINT_DECAY_LEVEL);
}

static void find_quadratic(const glint_lobes *lobes, glint_findings *findings)
{
    const struct {
        const char *where, *claim;
        double stated, level;
        const glint_accuracy *by_n;
    } claims[] = {{"2.2", "Quadratic (2.3): relative error at levels of 0.56 and above at most",
                   3.0, GLINT_QUADRATIC_LEVEL, lobes->quadratic},
                  {"Conclusions", "Quadratic (2.3): relative error in the epicentre at most", 2.0,
                   GLINT_EPICENTRE_LEVEL, lobes->by_n[GLINT_REFLECTANCE_QUADRATIC]}};
    for (size_t i = 0; i < sizeof claims / sizeof claims[0]; i++) {
        const glint_worst worst =
            glint_lobe_worst_of(&lobes->exponents, claims[i].by_n, glint_n_all).epicentre_relative;
        const glint_worst of_figure =
            glint_lobe_worst_of(&lobes->exponents, claims[i].by_n, figure_27).epicentre_relative;
        const glint_judged judged =
            glint_judged_number(GLINT_AT_MOST, claims[i].stated, 0, 100.0 * worst.error);
        glint_finding *finding = glint_findings_add(findings, claims[i].where, &judged);
        SAY(finding->claim, "%s %.0f %%", claims[i].claim, judged.stated);
        SAY(finding->measured, "%.2f %% at n = %g; up to n = %g, where figure 2.7 ends, %.2f %%",
            judged.lowest, worst.n, figure_27.to, 100.0 * of_figure.error);
        say(finding, lobes, glint_n_all, "where cos^n ≥ %g", claims[i].level);
    }
    find_quadratic_decay(lobes, findings);
}

static void find_table_of_a(const glint_derivations *derived, glint_findings *findings)
{
    const glint_judged judged = glint_judged_number(GLINT_AT_MOST, 0.0, 0, derived->a_undefined);
    glint_finding *finding = glint_findings_add(findings, "(2.8)", &judged);
    SAY(finding->claim, "a can be tabulated for n = 1…%d by (2.8)", derived->a_count);
    if (derived->a_undefined == 0)
        SAY(finding->measured, "none of %d divides by zero", derived->a_count);
    else
        SAY(finding->measured,
            "%d of %d divides by zero, the first at n = %d; the limit at n = 1, %g, makes the "
            "quadratic c itself",
            derived->a_undefined, derived->a_count, derived->a_first_undefined, derived->a_limit);
    SAY(finding->conditions,
        "n = 1…%d; double precision loses %.0e of a by (2.8), rewritten it does not",
        derived->a_count, derived->a_lost);
}

/* ---- 2.3: the cosine-quadratic --------------------------------------------------------------- */

static void find_integral(const glint_lobes *lobes, glint_findings *findings)
{
    const glint_derivations *derived = &lobes->derived;
    const glint_judged judged =
        glint_judged_number(GLINT_AT_MOST, SAME_INTEGRAL, 9, derived->integral_apart);
    glint_finding *finding = glint_findings_add(findings, "(2.13), (2.14)", &judged);
    SAY(finding->claim,
        "With σ = (n+1)/3 the integral of W over its lobe is that of cos^n, 1/(n+1)");
    SAY(finding->measured,
        "equal to within %.1e of it; what of the lobe is in front of the surface has up to %.1f %% "
        "less, at n = %g",
        derived->integral_apart, 100.0 * derived->in_front_short, derived->in_front_short_n);
    say(finding, lobes, glint_n_all,
        "Simpson's rule, from 0 to the zero of W wherever that is; equal is to within %g",
        SAME_INTEGRAL);
}

static void find_absolute(const glint_lobes *lobes, glint_findings *findings)
{
    const glint_n_range ranges[] = {from_2, n_is_1};
    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        const glint_worst worst =
            glint_lobes_worst(lobes, GLINT_REFLECTANCE_COSINE_QUADRATIC, ranges[i]).absolute;
        const glint_judged judged = glint_judged_number(GLINT_AT_MOST, 0.1, 1, worst.error);
        glint_finding *finding = glint_findings_add(findings, "2.3", &judged);
        SAY(finding->claim, "Cosine-quadratic (2.15): absolute error at most %g, %s", judged.stated,
            ranges[i].to > ranges[i].from ? "n = 2…1000" : "n = 1");
        if (isnan(worst.error))
            SAY(finding->measured, "nothing was measured");
        else
            SAY(finding->measured, "%.4f at n = %g, c = %.6g, where cos^n is %.4f and W %.4f",
                worst.error, worst.n, worst.cosine, pow(worst.cosine, worst.n),
                glint_formula_w(worst.n, worst.cosine));
        say(finding, lobes, ranges[i],
            "the whole lobe, of which the thesis's zone of blooming is a part");
    }
}

static void find_relative(const glint_lobes *lobes, glint_findings *findings)
{
    const glint_derivations *derived = &lobes->derived;
    const glint_worst worst =
        glint_lobes_worst(lobes, GLINT_REFLECTANCE_COSINE_QUADRATIC, glint_n_all)
            .epicentre_relative;
    glint_judged judged = glint_judged_number(GLINT_AT_MOST, 3.0, 0, 100.0 * worst.error);
    glint_finding *finding = glint_findings_add(findings, "2.7, 3.1, Conclusions", &judged);
    SAY(finding->claim, "Cosine-quadratic: relative error at most %.0f %% in the epicentre",
        judged.stated);
    SAY(finding->measured, "%.1f %% at n = %g; the device %.1f %% at n = %g", judged.lowest,
        worst.n, 100.0 * lobes->device.model.epicentre_relative.error,
        lobes->device.model.epicentre_relative.n);
    say(finding, lobes, glint_n_all, "where cos^n ≥ %g", GLINT_EPICENTRE_LEVEL);

    const glint_worst decay =
        glint_lobe_worst_of(&lobes->exponents, lobes->cosine_quadratic_decay, glint_n_all)
            .epicentre_relative;
    const glint_worst decay_from_2 =
        glint_lobe_worst_of(&lobes->exponents, lobes->cosine_quadratic_decay, from_2)
            .epicentre_relative;
    judged = glint_judged_number(GLINT_AT_MOST, 3.0, 0, 100.0 * decay.error);
    finding = glint_findings_add(findings, "2.7, 3.1, Conclusions", &judged);
    SAY(finding->claim, "Cosine-quadratic: the same %.0f %% in the zone of decay", judged.stated);
    SAY(finding->measured, "%.0f %% at n = %g; from n = %g on %.0f %%, at n = %g", judged.lowest,
        decay.n, from_2.from, 100.0 * decay_from_2.error, decay_from_2.n);
    say(finding, lobes, glint_n_all,
        "where cos^n ≥ %g; from n = %g on W reaches zero where cos^n is still %.3f to %.3f",
        GLINT_DECAY_LEVEL, GLINT_LOBE_ENDS_FROM, derived->level_at_end.least,
        derived->level_at_end.largest);
}

/* "0.2 to 0.4", to the one decimal that the thesis gives. */
static void find_level(const glint_lobes *lobes, glint_findings *findings)
{
    static const struct {
        const char *claim;
        glint_rule rule;
        double stated;
    } claims[] = {{"at a level of 0.2 or more", GLINT_REACHES, 0.2},
                  {"at a level of 0.4 or less", GLINT_BELOW, 0.45}};
    const glint_span_of_n level = lobes->derived.relative_level;
    for (size_t i = 0; i < sizeof claims / sizeof claims[0]; i++) {
        const glint_judged judged = {.rule = claims[i].rule,
                                     .stated = claims[i].stated,
                                     .decimals = 1,
                                     .lowest = level.least,
                                     .highest = level.largest};
        glint_finding *finding = glint_findings_add(findings, "2.3", &judged);
        SAY(finding->claim, "tan γ = √(1+2n)/n is %s", claims[i].claim);
        SAY(finding->measured, "cos^n = %.3f to %.3f", level.least, level.largest);
        say(finding, lobes, with_end,
            "the level to one decimal%s; at n = 1 it is %.2f, at n = 2 W is cos^n itself",
            claims[i].rule == GLINT_BELOW ? ", so below 0.45" : "", lobes->derived.level_at_1);
    }
}

static void find_relative_place(const glint_lobes *lobes, glint_findings *findings)
{
    const glint_derivations *derived = &lobes->derived;
    glint_judged judged =
        glint_judged_number(GLINT_AT_MOST, SAME_PLACE, 4, derived->relative_apart.largest);
    glint_finding *finding = glint_findings_add(findings, "2.3", &judged);
    SAY(finding->claim,
        "The relative error W/cos^n − 1 has its maximum at tan γ = √(1+2n)/n, n = 3…1000");
    SAY(finding->measured,
        "the maximum is at most %.1e of the lobe's width 1/(n+1) from it; at n = 1 the error there "
        "is %.1f %%, the least",
        derived->relative_apart.largest, 100.0 * derived->relative_at_1);
    say(finding, lobes, with_end,
        "before the zero of W; searched, not solved; the same place is to within %g; at n = 2 W is "
        "cos^n itself",
        SAME_PLACE);
    find_level(lobes, findings);

    judged = glint_judged_number(
        GLINT_AT_MOST, 1.0, 0, derived->relative_at_end.largest / derived->relative_there.largest);
    finding = glint_findings_add(findings, "2.3", &judged);
    SAY(finding->claim, "That is the largest relative error of all");
    SAY(finding->measured,
        "there it is up to %.1f %%; where W is zero and cos^n is not, %.0f %%: %.2f times that",
        100.0 * derived->relative_there.largest, 100.0 * derived->relative_at_end.largest,
        judged.lowest);
    say(finding, lobes, with_end,
        "cosines 0 to 1, the error without its sign; it holds when the latter is at most %g times "
        "the former",
        judged.stated);
}

static void find_absolute_place(const glint_lobes *lobes, glint_findings *findings)
{
    const glint_span_of_n ratio = lobes->derived.absolute_to_end;
    const glint_judged judged = {.rule = GLINT_ROUNDS_TO,
                                 .stated = 1.0,
                                 .decimals = 2,
                                 .lowest = ratio.least,
                                 .highest = ratio.largest};
    glint_finding *finding = glint_findings_add(findings, "2.3", &judged);
    SAY(finding->claim, "The absolute error is largest at tan γ = √(6n−3)/(n−2)");
    SAY(finding->measured,
        "there W is zero, and the error %.3f to %.3f; the largest is %.2f to %.2f times that",
        lobes->derived.level_at_end.least, lobes->derived.level_at_end.largest, ratio.least,
        ratio.largest);
    say(finding, lobes, with_end,
        "the place is c = (n−2)/(n+1); it holds when the quotient rounds to %.2f", judged.stated);
}

/* ---- 3.1, 3.4: compared with Schlick's ------------------------------------------------------- */

static void find_ratio_to_schlick(const glint_lobes *lobes, glint_findings *findings)
{
    static const struct {
        const char *where;
        double stated;
    } claims[] = {{"3.1", 4.0}, {"3.4", 3.0}};
    const glint_lobe_worst schlick =
        glint_lobes_worst(lobes, GLINT_REFLECTANCE_SCHLICK, glint_n_all);
    const glint_lobe_worst own =
        glint_lobes_worst(lobes, GLINT_REFLECTANCE_COSINE_QUADRATIC, glint_n_all);
    for (size_t i = 0; i < sizeof claims / sizeof claims[0]; i++) {
        const glint_judged judged =
            glint_judged_number(GLINT_REACHES, claims[i].stated, 0,
                                schlick.epicentre_absolute.error / own.epicentre_absolute.error);
        glint_finding *finding = glint_findings_add(findings, claims[i].where, &judged);
        SAY(finding->claim,
            "Cosine-quadratic: absolute error in the epicentre %g times below Schlick's",
            judged.stated);
        SAY(finding->measured,
            "%.2f times: %.4f against Schlick's %.4f; over the whole lobe %.2f times",
            judged.lowest, own.epicentre_absolute.error, schlick.epicentre_absolute.error,
            schlick.absolute.error / own.absolute.error);
        say(finding, lobes, glint_n_all, "where cos^n ≥ %g", GLINT_EPICENTRE_LEVEL);
    }
}

/* More accurate than what, by which error? Every function of the thesis that stands for cosⁿ. */
static void find_quadratic_gain(const glint_lobes *lobes, glint_findings *findings)
{
    static const glint_reflectance_model others[] = {GLINT_REFLECTANCE_SCHLICK,
                                                     GLINT_REFLECTANCE_SCHLICK_MODIFIED,
                                                     GLINT_REFLECTANCE_SCHLICK_MODIFIED_ANGLE,
                                                     GLINT_REFLECTANCE_SCHLICK_MODIFIED_LINEAR,
                                                     GLINT_REFLECTANCE_SCHLICK_MODIFIED_SQUARED,
                                                     GLINT_REFLECTANCE_SCHLICK_MODIFIED_POWER,
                                                     GLINT_REFLECTANCE_COSINE_QUADRATIC};
    enum { OTHERS = sizeof others / sizeof others[0] };
    const glint_lobe_worst own = glint_lobes_worst(lobes, GLINT_REFLECTANCE_QUADRATIC, glint_n_all);
    glint_judged judged = {.rule = GLINT_ABOVE, .stated = 10.0, .lowest = NAN, .highest = NAN};
    double relative[OTHERS], absolute[OTHERS];
    for (int i = 0; i < OTHERS; i++) {
        const glint_lobe_worst other = glint_lobes_worst(lobes, others[i], glint_n_all);
        relative[i] = other.epicentre_relative.error / own.epicentre_relative.error;
        absolute[i] = other.epicentre_absolute.error / own.epicentre_absolute.error;
        widen(&judged, relative[i]);
        widen(&judged, absolute[i]);
    }
    glint_finding *finding = glint_findings_add(findings, "3.4", &judged);
    SAY(finding->claim, "Quadratic: the epicentre more than %g times as accurate", judged.stated);
    SAY(finding->measured,
        "than Schlick's function %.1f times by the relative, %.1f times by the absolute error; "
        "than all that it may be compared with %.1f to %.1f times",
        relative[0], absolute[0], judged.lowest, judged.highest);
    say(finding, lobes, glint_n_all,
        "largest errors where cos^n ≥ %g; the thesis does not say than what: Schlick's function, "
        "its modification in %d forms and the cosine-quadratic, each by both errors",
        GLINT_EPICENTRE_LEVEL, OTHERS - 2);
}

void glint_lobes_find(const glint_lobes *lobes, glint_findings *findings)
{
    find_schlick(lobes, findings);
    find_modified(lobes, findings);
    find_table_32_form(lobes, findings);
    find_quadratic(lobes, findings);
    find_table_of_a(&lobes->derived, findings);
    find_integral(lobes, findings);
    find_absolute(lobes, findings);
    find_relative(lobes, findings);
    find_relative_place(lobes, findings);
    find_absolute_place(lobes, findings);
    find_ratio_to_schlick(lobes, findings);
    find_quadratic_gain(lobes, findings);
}
