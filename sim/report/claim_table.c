/* The claims, in the order of the report's chapters and in each of the thesis: chapter, where, what
 * it says; the rule, the stated number, its decimals and kind; the measured number's name and the
 * line that shows it. What all numbers of a chapter are of, the exponents say, its text says. */
#include "report/claims.h"

#define MODIFIED_READINGS                                                                          \
    "{lobes.schlick-modified.relative:.1%} as printed; {lobes.schlick-modified-angle.relative:"    \
    ".1%} with cos(γ²), {lobes.schlick-modified-linear.relative:.1%} with (1 − c)², "         \
    "{lobes.schlick-modified-squared.relative:.1%} with (n(1 − c))², which from n = 2 on has "  \
    "{lobes.schlick-modified-squared.relative-from-2:.1%}"

#define QUADRATIC_GAIN                                                                             \
    "than Schlick's function {lobes.quadratic.gain.relative:.1f} times by the relative, "          \
    "{lobes.quadratic.gain.absolute:.1f} times by the absolute error; than all that it may be "    \
    "compared with {lobes.quadratic.gain:.1f} times: the thesis does not say than what"

#define EPICENTRE_GAIN                                                                             \
    "{lobes.gain.epicentre:.2f} times: {lobes.cosine-quadratic.epicentre:.4f} against Schlick's "  \
    "{lobes.schlick.epicentre:.4f}; over the whole lobe {lobes.gain.whole:.2f} times"

/* Over the four scenes; then the worst frame of all. */
#define FRAMES(METHOD, WHAT)                                                                       \
    "{frames." METHOD "." WHAT ":.2g} by scene; the worst at n = {frames." METHOD "." WHAT         \
    ".worst.n}, {frames." METHOD "." WHAT ".worst.figure}, {frames." METHOD "." WHAT               \
    ".worst.scene}"

#define UNSEEN "no visible difference, NMSE below 0.0001"

#define FRAME_GAIN                                                                                 \
    "{frames.time.gain:.1%} more frames a second at best, {frames.time.less:.1%} less time "       \
    "(+20 % is 16.7 % less); by n {frames.time.sphere.cosine-quadratic.gain:.0%} more (sphere), "  \
    "{frames.time.teapot.cosine-quadratic.gain:.0%} (teapot)"

#define SPEED(KIND)                                                                                \
    "{speed.cosine-quadratic." KIND ".ratio:.2f} times, the median of "                            \
    "{speed.cosine-quadratic." KIND ".ratios:.2f}"

#define NOT_BUILT "not built yet: nothing was measured"

const glint_claim glint_claim_table[] = {
    /* ---- The device ---- */
    {"device", "3.1, figure 3.1",
     "Comparator 11, by the limit of W in ROM 9, zeroes what lies outside the highlight: as the "
     "picture's NMSE, at most 0.0001",
     GLINT_AT_MOST, 0.0001, 4, GLINT_PLAIN, "device.drawn.nmse",
     "{device.drawn.nmse:.2f}, sphere, n = {device.n}: the error has more energy than the picture; "
     "{device.drawn.share:.0%} of all outputs are wrong"},
    {"device", "3.1, figure 3.1",
     "Adders 6 and 8 form cos γ − 1 and t + 1 by an operand of ones and a carry-in: every output "
     "is "
     "within 0.52 of an 8-bit step of (2.15)",
     GLINT_AT_MOST, 0.52, 2, GLINT_PLAIN, "device.output",
     "{device.output:.3f} of a step, at n = {device.output.n}, with adders that span the integer "
     "digits alone: over the whole word each would add one unit in the last place"},

    /* ---- 2.1: Schlick's function and its modification ---- */
    {"lobes", "2.1",
     "Schlick's function (2.1): largest relative error in the epicentre at most 3.2 %",
     GLINT_AT_MOST, 3.2, 1, GLINT_PER_CENT, "lobes.schlick.relative",
     "{lobes.schlick.relative:.2%}"},
    {"lobes", "2.7, 3.4, Conclusions",
     "Schlick's function (2.1): largest relative error in the epicentre 10 %", GLINT_ROUNDS_TO,
     10.0, 0, GLINT_PER_CENT, "lobes.schlick.relative", "{lobes.schlick.relative:.2%}"},
    {"lobes", "2.1",
     "Schlick's function falls too slowly: at the end of the zone of decay, where cosⁿ is 0.01, "
     "it is above that",
     GLINT_ABOVE, 0.01, 2, GLINT_PLAIN, "lobes.schlick.at-end-of-decay",
     "up to {lobes.schlick.at-end-of-decay:.3f}"},
    {"lobes", "2.1",
     "Modified Schlick (2.2): largest relative error 6.8 % from Schlick's own 10 %, so at most "
     "3.2 %",
     GLINT_AT_MOST, 3.2, 1, GLINT_PER_CENT, "lobes.modified.relative", MODIFIED_READINGS},
    {"lobes", "2.7, Conclusions", "Modified Schlick (2.2): largest relative error at most 3.2 %",
     GLINT_AT_MOST, 3.2, 1, GLINT_PER_CENT, "lobes.modified.relative", "the same numbers"},
    {"lobes", "3.4", "Modified Schlick: largest relative error at most 0.4 %", GLINT_AT_MOST, 0.4,
     1, GLINT_PER_CENT, "lobes.modified.relative", "the same numbers"},
    {"lobes", "Table 3.2, 3.4", "Modified Schlick as cos^a/(n − n cos + cos): at most 0.4 %",
     GLINT_AT_MOST, 0.4, 1, GLINT_PER_CENT, "lobes.table-form.relative",
     "{lobes.schlick-modified-power.relative:.2%} with the best a for each n, as the thesis gives "
     "none; {lobes.schlick.relative:.2%} with a = 1, which is Schlick's function"},
    {"lobes", "2.7, 3.4",
     "Modified Schlick renders the zone of decay better than Schlick's function: an absolute error "
     "smaller by more than 1 time",
     GLINT_ABOVE, 1.0, 0, GLINT_PLAIN, "lobes.decay.gain",
     "{lobes.decay.gain:.2f} times smaller: Schlick {lobes.schlick.decay-absolute:.3f}, (2.2) as "
     "printed {lobes.schlick-modified.decay-absolute:.3f}, with (n(1 − c))² "
     "{lobes.schlick-modified-squared.decay-absolute:.3f}"},

    /* ---- 2.2: the quadratic ---- */
    {"lobes", "2.2", "Quadratic (2.3): relative error at levels of 0.56 and above at most 3 %",
     GLINT_AT_MOST, 3.0, 0, GLINT_PER_CENT, "lobes.quadratic.from-0.56",
     "{lobes.quadratic.from-0.56:.2%} at n = {lobes.quadratic.from-0.56.n}; up to n = 512, where "
     "figure 2.7 ends, {lobes.quadratic.from-0.56-to-512:.2%}"},
    {"lobes", "Conclusions", "Quadratic (2.3): relative error in the epicentre at most 2 %",
     GLINT_AT_MOST, 2.0, 0, GLINT_PER_CENT, "lobes.quadratic.relative",
     "{lobes.quadratic.relative:.2%} at n = {lobes.quadratic.relative.n}; up to n = 512 "
     "{lobes.quadratic.relative-to-512:.2%}"},
    {"lobes", "2.2", "Quadratic: the same 3 % in the zone of decay", GLINT_AT_MOST, 3.0, 0,
     GLINT_PER_CENT, "lobes.quadratic.decay",
     "{lobes.quadratic.decay:.0%} at n = {lobes.quadratic.decay.n}; the largest absolute error is "
     "{lobes.quadratic.absolute:.3f}"},
    {"lobes", "2.2", "Quadratic: its error is spread evenly over the epicentre", GLINT_AT_MOST, 0.0,
     0, GLINT_NO_NUMBER, NULL,
     "it says no measure of even: the quadratic is up to {lobes.quadratic.above:.1%} above cosⁿ "
     "and {lobes.quadratic.below:.1%} below"},
    {"lobes", "2.2",
     "Quadratic: it falls too sharply in the zone of blooming: it is zero where cosⁿ is still "
     "above 0.01",
     GLINT_ABOVE, 0.01, 2, GLINT_PLAIN, "lobes.quadratic.end-level",
     "it reaches zero where cosⁿ is {lobes.quadratic.end-level:.3f}, from n = 3 on; for n = 1 and "
     "2 it is cosⁿ itself"},
    {"lobes", "(2.8)", "a can be tabulated for n = 1…1000 by (2.8)", GLINT_AT_MOST, 0.0, 0,
     GLINT_PLAIN, "lobes.a.undefined",
     "{lobes.a.undefined} of {lobes.a.count} divides by zero, the first at n = "
     "{lobes.a.undefined.first}; the limit there, {lobes.a.limit}, makes the quadratic c itself; "
     "double precision loses {lobes.a.lost:.0e} of a by (2.8), rewritten it does not"},

    /* ---- 2.3: the cosine-quadratic ---- */
    {"lobes", "(2.13), (2.14)",
     "With σ = (n+1)/3 the integral of W over its lobe is that of cosⁿ, 1/(n+1)", GLINT_AT_MOST,
     1e-9, 9, GLINT_PLAIN, "lobes.integral.apart",
     "equal to within {lobes.integral.apart:.1e}, by Simpson's rule to the zero of W; what of the "
     "lobe is in front of the surface has up to {lobes.integral.in-front-short:.1%} less, at n = "
     "{lobes.integral.in-front-short.n}"},
    {"lobes", "2.3", "Cosine-quadratic (2.15): absolute error at most 0.1, n = 2…1000",
     GLINT_AT_MOST, 0.1, 1, GLINT_PLAIN, "lobes.cosine-quadratic.absolute-from-2",
     "{lobes.cosine-quadratic.absolute-from-2:.4f} at n = "
     "{lobes.cosine-quadratic.absolute-from-2.n}, c = "
     "{lobes.cosine-quadratic.absolute-from-2.cosine:.6g}, where cosⁿ is "
     "{lobes.cosine-quadratic.absolute-from-2.level:.4f} and W "
     "{lobes.cosine-quadratic.absolute-from-2.w:.4f}"},
    {"lobes", "2.3", "Cosine-quadratic (2.15): absolute error at most 0.1, n = 1", GLINT_AT_MOST,
     0.1, 1, GLINT_PLAIN, "lobes.cosine-quadratic.absolute-at-1",
     "{lobes.cosine-quadratic.absolute-at-1:.4f} at c = "
     "{lobes.cosine-quadratic.absolute-at-1.cosine:.6g}, where cosⁿ is "
     "{lobes.cosine-quadratic.absolute-at-1.level:.4f} and W "
     "{lobes.cosine-quadratic.absolute-at-1.w:.4f}"},
    {"lobes", "2.7, 3.1, Conclusions",
     "Cosine-quadratic: relative error at most 3 % in the epicentre", GLINT_AT_MOST, 3.0, 0,
     GLINT_PER_CENT, "lobes.cosine-quadratic.relative",
     "{lobes.cosine-quadratic.relative:.1%} at n = {lobes.cosine-quadratic.relative.n}; the device "
     "{lobes.device.relative:.1%}"},
    {"lobes", "2.7, 3.1, Conclusions", "Cosine-quadratic: the same 3 % in the zone of decay",
     GLINT_AT_MOST, 3.0, 0, GLINT_PER_CENT, "lobes.cosine-quadratic.decay",
     "{lobes.cosine-quadratic.decay:.0%} at n = {lobes.cosine-quadratic.decay.n}; from n = 2 on "
     "{lobes.cosine-quadratic.decay-from-2:.0%}: W reaches zero where cosⁿ is still "
     "{lobes.place.end-level:.3f}"},
    {"lobes", "2.3",
     "The relative error W/cosⁿ − 1 has its maximum at tan γ = √(1+2n)/n, n = 3…1000",
     GLINT_AT_MOST, 1e-4, 4, GLINT_PLAIN, "lobes.place.apart",
     "the maximum is at most {lobes.place.apart:.1e} of the lobe's width 1/(n+1) from it; at n = 1 "
     "the error there is {lobes.place.there-at-1:.1%}, the least; at n = 2 W is cosⁿ itself"},
    {"lobes", "2.3", "tan γ = √(1+2n)/n is at a level of 0.2 or more", GLINT_REACHES, 0.2, 1,
     GLINT_PLAIN, "lobes.place.level", "cosⁿ = {lobes.place.level:.3f}, n from 3 on"},
    {"lobes", "2.3", "tan γ = √(1+2n)/n is at a level of 0.4 or less, so below 0.45", GLINT_BELOW,
     0.45, 1, GLINT_PLAIN, "lobes.place.level",
     "cosⁿ = {lobes.place.level:.3f}, n from 3 on; {lobes.place.level-at-1:.2f} at n = 1"},
    {"lobes", "2.3", "That is the largest relative error of all", GLINT_AT_MOST, 1.0, 0,
     GLINT_PLAIN, "lobes.place.end-to-there",
     "there it is up to {lobes.place.there:.1%}; where W is zero and cosⁿ is not, "
     "{lobes.place.at-end:.0%}: {lobes.place.end-to-there:.2f} times that"},
    {"lobes", "2.3", "The absolute error is largest at tan γ = √(6n−3)/(n−2)", GLINT_ROUNDS_TO, 1.0,
     2, GLINT_PLAIN, "lobes.place.absolute-to-end",
     "there W is zero and the error {lobes.place.end-level:.3f}; the largest is "
     "{lobes.place.absolute-to-end:.2f} times that, n from 3 on"},
    {"lobes", "3.1", "Cosine-quadratic: absolute error in the epicentre 4 times below Schlick's",
     GLINT_REACHES, 4.0, 0, GLINT_PLAIN, "lobes.gain.epicentre", EPICENTRE_GAIN},
    {"lobes", "3.4", "Cosine-quadratic: absolute error in the epicentre 3 times below Schlick's",
     GLINT_REACHES, 3.0, 0, GLINT_PLAIN, "lobes.gain.epicentre", "the same numbers"},
    {"lobes", "3.4", "Quadratic: the epicentre more than 10 times as accurate", GLINT_ABOVE, 10.0,
     0, GLINT_PLAIN, "lobes.quadratic.gain", QUADRATIC_GAIN},

    /* ---- 2.4: the divider ---- */
    {"divider", "(2.19)", "1/7 with 6 shifts is 1/8 + 1/64, so 9 of 64ths", GLINT_ROUNDS_TO, 9.0, 0,
     GLINT_PLAIN, "divider.example.bits", "{divider.example.bits}"},
    {"divider", "2.4", "The exact increment 255/7 is 36.4286 levels", GLINT_ROUNDS_TO, 36.4286, 4,
     GLINT_PLAIN, "divider.example.exact", "{divider.example.exact:.8g}"},
    {"divider", "2.4", "By the sum it is 35.8594 levels", GLINT_ROUNDS_TO, 35.8594, 4, GLINT_PLAIN,
     "divider.example.sum", "{divider.example.sum:.8g}"},
    {"divider", "2.4", "Its absolute error is 0.5692 of a level", GLINT_ROUNDS_TO, 0.5692, 4,
     GLINT_PLAIN, "divider.example.error", "{divider.example.error:.8g}"},
    {"divider", "2.4", "The same difference, a line below, is 0.5693", GLINT_ROUNDS_TO, 0.5693, 4,
     GLINT_PLAIN, "divider.example.error", "{divider.example.error:.8g}"},
    {"divider", "2.4", "Its relative error is 1.56 %", GLINT_ROUNDS_TO, 1.56, 2, GLINT_PER_CENT,
     "divider.example.relative", "{divider.example.relative:.4%}, the same for every difference"},
    {"divider", "2.4, 3.4",
     "6 shifts: the picture is visually not worse, as the largest NMSE of the frames at most "
     "0.0001",
     GLINT_AT_MOST, 0.0001, 4, GLINT_PLAIN, "divider.worst-nmse",
     "{divider.worst-nmse:.3g}; the last pixel of one span may be {divider.rounded.6.shown} levels "
     "off"},
    {"divider", "2.4", "8 shifts: the largest absolute error of an increment is 0.4427 of a level",
     GLINT_ROUNDS_TO, 0.4427, 4, GLINT_PLAIN, "divider.rounded.8.absolute",
     "{divider.rounded.8.absolute:.8g} at k = {divider.rounded.8.absolute.k}"},
    {"divider", "2.4", "8 shifts: the mean relative error is 0.81 %", GLINT_ROUNDS_TO, 0.81, 2,
     GLINT_PER_CENT, "divider.rounded.8.relative.mean",
     "{divider.rounded.8.relative.mean:.4%}, each k once"},
    {"divider", "2.4", "The spans of an average triangle, of 100 pixels, are of 16 steps at most",
     GLINT_AT_MOST, 16.0, 0, GLINT_PLAIN, "divider.average.longest",
     "{divider.average.longest} steps; {divider.average.with-longer} of "
     "{divider.average.triangles} triangles of 90 to 110 pixels have a longer span"},
    {"divider", "Table 2.1", "The average triangle has 100 pixels", GLINT_ROUNDS_TO, 100.0, 0,
     GLINT_PLAIN, "divider.drawn.pixels",
     "{divider.drawn.pixels} are drawn; its area is {divider.drawn.area}"},
    {"divider", "Table 2.1", "18 additions for the increments along edges", GLINT_ROUNDS_TO, 18.0,
     0, GLINT_PLAIN, "divider.described.edge-increments.additions",
     "{divider.described.edge-increments.additions}"},
    {"divider", "Table 2.1", "9 divisions for the increments along edges", GLINT_ROUNDS_TO, 9.0, 0,
     GLINT_PLAIN, "divider.described.edge-increments.divisions",
     "{divider.described.edge-increments.divisions}"},
    {"divider", "Table 2.1", "99 additions for the points of edges", GLINT_ROUNDS_TO, 99.0, 0,
     GLINT_PLAIN, "divider.described.edge-points.additions",
     "{divider.described.edge-points.additions}"},
    {"divider", "Table 2.1", "66 additions for the increments along rows", GLINT_ROUNDS_TO, 66.0, 0,
     GLINT_PLAIN, "divider.described.row-increments.additions",
     "{divider.described.row-increments.additions}"},
    {"divider", "Table 2.1", "33 divisions for the increments along rows", GLINT_ROUNDS_TO, 33.0, 0,
     GLINT_PLAIN, "divider.described.row-increments.divisions",
     "{divider.described.row-increments.divisions}"},
    {"divider", "Table 2.1", "225 additions for the points of rows", GLINT_ROUNDS_TO, 225.0, 0,
     GLINT_PLAIN, "divider.described.row-points.additions",
     "{divider.described.row-points.additions}"},
    {"divider", "Table 2.1", "408 additions in all", GLINT_ROUNDS_TO, 408.0, 0, GLINT_PLAIN,
     "divider.described.all.additions", "{divider.described.all.additions}"},
    {"divider", "Table 2.1", "42 divisions in all", GLINT_ROUNDS_TO, 42.0, 0, GLINT_PLAIN,
     "divider.described.all.divisions", "{divider.described.all.divisions}"},
    {"divider", "Table 2.1", "2946 clocks with division", GLINT_ROUNDS_TO, 2946.0, 0,
     GLINT_CIRCULAR, "divider.described.clocks",
     "{divider.described.clocks}, with clocks of an operation inferred from this number"},
    {"divider", "Table 2.1", "2064 clocks with the sum instead", GLINT_ROUNDS_TO, 2064.0, 0,
     GLINT_CIRCULAR, "divider.described.clocks-by-shifts",
     "{divider.described.clocks-by-shifts}, inferred likewise"},
    {"divider", "2.4", "1.43 times faster", GLINT_ROUNDS_TO, 1.43, 2, GLINT_CIRCULAR,
     "divider.described.faster",
     "{divider.described.faster:.8g}, the quotient of those two; no time was measured"},

    /* ---- 2.5: energy ---- */
    {"energy", "(2.20)", "The reflectance function is reciprocal: f_r(L,V) = f_r(V,L)",
     GLINT_AT_MOST, 1e-12, 12, GLINT_PLAIN, "energy.asymmetry",
     "largest relative difference {energy.asymmetry:.3g}, over all {energy.model-count} models"},
    {"energy", "2.5",
     "By the law of conservation the incident energy is at most the reflected, R ≥ 1, so for all "
     "1000 exponents of what conserves",
     GLINT_AT_LEAST, 1000.0, 0, GLINT_PLAIN, "energy.blinn-with-factor.full",
     "R ≥ 1 for {energy.blinn-with-factor.full} exponents of Blinn's with (n+6)/(8π), which by "
     "figure 2.16 conserves, and for {energy.w.full} of W, which there does not; (2.22) has R ≤ 1"},
    {"energy", "(2.24)", "At normal incidence, L = N, (2.23) becomes (2.24), with (cos θ₀)/2",
     GLINT_AT_MOST, 1e-3, 3, GLINT_PLAIN, "energy.half-angle.apart",
     "as printed the highlight's centre is {energy.half-angle.centre:.0f} at n = 1000 instead of 1 "
     "and R = {energy.half-angle.at-1000:.0f} instead of {energy.w.at-1000:.4f}; the integrals "
     "differ by up to {energy.half-angle.apart:.3g} times"},
    {"energy", "(2.25)", "R is the integral of W cos θ₀ sin θ₀ over dω₀", GLINT_AT_MOST, 1e-3, 3,
     GLINT_PLAIN, "energy.solid-angle.apart",
     "with dω₀ = sin θ₀ dθ₀ R = {energy.solid-angle.at-17:.4f} at n = 17 and "
     "{energy.solid-angle.at-1000:.6f} at 1000, above 1 only for n = "
     "{energy.solid-angle.above.first}…{energy.solid-angle.above.last}; with dθ₀ "
     "{energy.held.at-17:.4f} and {energy.held.at-1000:.6f}"},
    {"energy", "2.5, figure 2.15", "W without a factor does not conserve energy for n = 1…17",
     GLINT_AT_MOST, 0.0, 0, GLINT_PLAIN, "energy.w.otherwise",
     "R > 1 for n = {energy.w.above.first}…{energy.w.above.last}, so otherwise for "
     "{energy.w.otherwise}: R = {energy.w.at-18:.4f} at 18, {energy.w.at-19:.4f} at 19, "
     "{energy.w.at-20:.4f} at 20. By (2.25) with dθ₀, to 5.8/√n, n = "
     "{energy.with-limit.above.first}…{energy.with-limit.above.last}"},
    {"energy", "2.5", "Normal incidence is the worst case: no R(L) is larger than for L = N",
     GLINT_AT_MOST, 0.0, 0, GLINT_PLAIN, "energy.w.above-normal",
     "{energy.w.above-normal} cells of the cosine-quadratic have a larger R than normal incidence"},
    {"energy", "(2.25)", "The limit 5.8/√n takes in the first lobe of W only", GLINT_AT_LEAST, 5.8,
     1, GLINT_PLAIN, "energy.zero",
     "W is zero at √n · θ₀ = {energy.zero:.4f}; R by (2.25) with dθ₀ is off by up to "
     "{energy.with-limit.apart:.1%}, at n = {energy.with-limit.apart.n}"},
    {"energy", "(2.26), figure 2.16", "(n+6)/24.55 · W conserves energy for n = 1…1000",
     GLINT_AT_MOST, 0.0, 0, GLINT_PLAIN, "energy.claimed.above",
     "R > 1 for {energy.claimed.above} exponents, n = "
     "{energy.claimed.above.first}…{energy.claimed.above.last}: {energy.claimed.largest:.4f} at n "
     "= {energy.claimed.largest.n}, {energy.claimed.at-1000:.4f} at 1000. With A = 6, B must be "
     "{energy.smallest-b.up:.6g} or more"},
    {"energy", "figure 2.16", "Blinn's with (n+6)/(8π) conserves energy for n = 1…1000",
     GLINT_AT_MOST, 0.0, 0, GLINT_PLAIN, "energy.blinn-normalized.grid-above",
     "R is at most {energy.blinn-normalized.grid-largest:.6f}, at n = "
     "{energy.blinn-normalized.grid-largest.n} and "
     "{energy.blinn-normalized.grid-largest.angle}°"},

    /* ---- 3.4: pictures ---- */
    {"frames", "Table 3.2", "Modified Schlick, (2.2) as printed: NMSE at most 0.00011",
     GLINT_AT_MOST, 0.00011, 5, GLINT_PLAIN, "frames.schlick-modified.nmse",
     FRAMES("schlick-modified", "nmse")},
    {"frames", "Table 3.2", "Modified Schlick, (2.2) read as 0.5(n(1 − c))²: NMSE at most 0.00011",
     GLINT_AT_MOST, 0.00011, 5, GLINT_PLAIN, "frames.schlick-modified-squared.nmse",
     FRAMES("schlick-modified-squared", "nmse")},
    {"frames", "Table 3.2",
     "Modified Schlick, as Table 3.2 prints it, with the best a: NMSE at most 0.00011",
     GLINT_AT_MOST, 0.00011, 5, GLINT_PLAIN, "frames.schlick-modified-power.nmse",
     FRAMES("schlick-modified-power", "nmse")},
    {"frames", "Table 3.2", "Quadratic, n < 170: NMSE at most 0.00026", GLINT_AT_MOST, 0.00026, 5,
     GLINT_PLAIN, "frames.quadratic.nmse-below-170", FRAMES("quadratic", "nmse-below-170")},
    {"frames", "Table 3.2", "Quadratic, the other n: NMSE below 0.0002", GLINT_BELOW, 0.0002, 4,
     GLINT_PLAIN, "frames.quadratic.nmse-from-170", FRAMES("quadratic", "nmse-from-170")},
    {"frames", "Table 3.2", "Cosine-quadratic: NMSE at most 0.00008", GLINT_AT_MOST, 0.00008, 5,
     GLINT_PLAIN, "frames.cosine-quadratic.nmse", FRAMES("cosine-quadratic", "nmse")},
    {"frames", "3.1, 3.4", "Cosine-quadratic: " UNSEEN, GLINT_BELOW, 0.0001, 4, GLINT_PLAIN,
     "frames.cosine-quadratic.nmse", "the same numbers"},
    {"frames", "3.1", "The device: " UNSEEN, GLINT_BELOW, 0.0001, 4, GLINT_PLAIN, "frames.rtl.nmse",
     FRAMES("rtl", "nmse")},
    {"frames", "3.4", "All the functions: visually identical to cosⁿ, NMSE below 0.0001",
     GLINT_BELOW, 0.0001, 4, GLINT_PLAIN, "frames.all.nmse",
     "{frames.all.nmse:.2g} by scene, the worst of the functions of Table 3.2 and Schlick's"},
    {"frames", "3.4, figure 3.13", "Productivity up to 20 % higher than with cosⁿ", GLINT_REACHES,
     20.0, 0, GLINT_PER_CENT, "frames.time.gain", FRAME_GAIN},
    {"frames", "2.7", "Perspective-correct Gouraud shading raises realism", GLINT_AT_MOST, 0.0, 0,
     GLINT_NO_NUMBER, NULL,
     "realism has no number; the NMSE against Phong's shading is "
     "{frames.perspective.sphere.screen:.3g} on the screen and "
     "{frames.perspective.sphere.object:.3g} on the object (coarse sphere)"},

    /* ---- 3.1, 3.4: speed ---- */
    {"speed", "3.1, 3.4",
     "Cosine-quadratic computed 1.7 times as fast as Schlick's function in software: one point "
     "after the other",
     GLINT_REACHES, 1.7, 1, GLINT_PLAIN, "speed.cosine-quadratic.scalar.ratios", SPEED("scalar")},
    {"speed", "3.1, 3.4",
     "Cosine-quadratic computed 1.7 times as fast as Schlick's function in software: vectorised",
     GLINT_REACHES, 1.7, 1, GLINT_PLAIN, "speed.cosine-quadratic.vectorised.ratios",
     SPEED("vectorised")},

    /* ---- 2.6 and 1.3: the rest ---- */
    {"rest", "(2.28)",
     "A row of 640 pixels takes ⌈640/(L+1) + 1⌉ traced ones: for none of L = 1…64 another number",
     GLINT_AT_MOST, 0.0, 0, GLINT_PLAIN, "rest.differing",
     "{rest.by-2-28} at L = {rest.segment}, as it is; {rest.differing.by} too many for "
     "{rest.differing} of the {rest.lengths} lengths, where L + 1 divides 639"},
    {"rest", "(2.31)",
     "Segments of varying lengths take ⌈640/(ΣL + 1)⌉ + 1 traced pixels: for 80 of 7, 81",
     GLINT_ROUNDS_TO, 81.0, 0, GLINT_PLAIN, "rest.by-2-31",
     "{rest.by-2-31}; {rest.traced} are traced"},
    {"rest", "2.6", "Pixel segments save traced rays at no visible difference", GLINT_AT_MOST, 0.0,
     0, GLINT_NO_NUMBER, NULL, NOT_BUILT},
    {"rest", "(2.30)", "Colours that differ by K ≤ 2.3 may be interpolated", GLINT_AT_MOST, 0.0, 0,
     GLINT_NO_NUMBER, NULL, NOT_BUILT "; neither K nor its unit is defined"},
    {"rest", "2.6",
     "Cubic interpolation is sharper than bilinear, without the artefacts of the nearest neighbour",
     GLINT_AT_MOST, 0.0, 0, GLINT_NO_NUMBER, NULL, NOT_BUILT},
    {"rest", "1.3",
     "Gouraud's shading has six drawbacks: linear where light is not, lost highlights, normals at "
     "vertices alone, flicker from frame to frame, star-shaped highlights, no perspective",
     GLINT_AT_MOST, 0.0, 0, GLINT_NO_NUMBER, NULL,
     NOT_BUILT "; of the sixth see the claim of section 2.7"},
    {"rest", "1.3", "Its error is least on right triangles with legs along the axes", GLINT_AT_MOST,
     0.0, 0, GLINT_NO_NUMBER, NULL, NOT_BUILT},
};
const int glint_claim_count = sizeof glint_claim_table / sizeof glint_claim_table[0];
