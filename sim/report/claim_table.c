/* The claims, in the order of the report's chapters and, within a chapter, of the thesis: chapter,
 * where, what it says; the rule, the stated number, its decimals and kind; the measured number's
 * name and the line that shows it. What is common to a chapter's numbers, such as the exponents,
 * is in its text. */
#include "report/claims.h"

#define MODIFIED_READINGS                                                                          \
    "{lobes.schlick-modified.relative:.1%} as printed; "                                           \
    "{lobes.schlick-modified-angle.relative:.1%} with cos(γ²); "                                 \
    "{lobes.schlick-modified-linear.relative:.1%} with (1 − c)²; "                              \
    "{lobes.schlick-modified-squared.relative:.1%} with (n(1 − c))², or "                       \
    "{lobes.schlick-modified-squared.relative-from-2:.1%} from n = 2 on"

#define QUADRATIC_GAIN                                                                             \
    "compared with Schlick's function, {lobes.quadratic.gain.relative:.1f} times by relative "     \
    "error and {lobes.quadratic.gain.absolute:.1f} times by absolute error; over everything it "   \
    "could be compared with, {lobes.quadratic.gain:.1f} times; the thesis does not say which is "  \
    "meant"

#define EPICENTRE_GAIN                                                                             \
    "{lobes.gain.epicentre:.2f} times: {lobes.cosine-quadratic.epicentre:.4f} against Schlick's "  \
    "{lobes.schlick.epicentre:.4f}; over the whole lobe {lobes.gain.whole:.2f} times"

/* Over the four scenes; then the worst frame of all. */
#define FRAMES(METHOD, WHAT)                                                                       \
    "{frames." METHOD "." WHAT ":.2g} depending on the scene; worst at n = {frames." METHOD        \
    "." WHAT ".worst.n}, {frames." METHOD "." WHAT ".worst.figure}, {frames." METHOD "." WHAT      \
    ".worst.scene}"

#define UNSEEN "no visible difference (NMSE below 0.0001)"

#define FRAME_GAIN                                                                                 \
    "{frames.time.gain:.1%} more frames per second at best, or {frames.time.less:.1%} less time "  \
    "(+20 % would be 16.7 % less); depending on n, "                                               \
    "{frames.time.sphere.cosine-quadratic.gain:.0%} more for the sphere and "                      \
    "{frames.time.teapot.cosine-quadratic.gain:.0%} for the teapot"

#define SPEED(KIND)                                                                                \
    "{speed.cosine-quadratic." KIND ".ratio:.2f} times, the median; over all runs "                \
    "{speed.cosine-quadratic." KIND ".ratios:.2f}"

const glint_claim glint_claim_table[] = {
    /* ---- The device ---- */
    {"device", "3.1, figure 3.1",
     "Comparator 11, with the limit of W in ROM 9, zeroes everything outside the highlight; taken "
     "to mean a picture NMSE of at most 0.0001",
     GLINT_AT_MOST, 0.0001, 4, GLINT_PLAIN, "device.drawn.nmse",
     "{device.drawn.nmse:.2f} on a sphere, n = {device.n}: the error has more energy than the "
     "picture; {device.drawn.share:.0%} of all outputs are wrong"},
    {"device", "3.1, figure 3.1",
     "Adders 6 and 8 form cos γ − 1 and t + 1 with an all-ones operand and a carry-in; taken to "
     "mean that every output is within 0.52 of an 8-bit step of (2.15)",
     GLINT_AT_MOST, 0.52, 2, GLINT_PLAIN, "device.output",
     "{device.output:.3f} of a step, at n = {device.output.n}, with adders on the integer digits "
     "only; across the whole word each would add one unit in the last place"},

    /* ---- 2.1: Schlick's function and its modification ---- */
    {"lobes", "2.1",
     "Schlick's function (2.1): largest relative error in the epicentre at most 3.2 %",
     GLINT_AT_MOST, 3.2, 1, GLINT_PER_CENT, "lobes.schlick.relative",
     "{lobes.schlick.relative:.2%}"},
    {"lobes", "2.7, 3.4, Conclusions",
     "Schlick's function (2.1): largest relative error in the epicentre 10 %", GLINT_ROUNDS_TO,
     10.0, 0, GLINT_PER_CENT, "lobes.schlick.relative", "{lobes.schlick.relative:.2%}"},
    {"lobes", "2.1",
     "Schlick's function falls too slowly: it is still above 0.01 at the end of the zone of decay, "
     "where cosⁿ is 0.01",
     GLINT_ABOVE, 0.01, 2, GLINT_PLAIN, "lobes.schlick.at-end-of-decay",
     "up to {lobes.schlick.at-end-of-decay:.3f}"},
    {"lobes", "2.1",
     "Modified Schlick (2.2): largest relative error 6.8 % below Schlick's 10 %, so at most 3.2 %",
     GLINT_AT_MOST, 3.2, 1, GLINT_PER_CENT, "lobes.modified.relative", MODIFIED_READINGS},
    {"lobes", "2.7, Conclusions", "Modified Schlick (2.2): largest relative error at most 3.2 %",
     GLINT_AT_MOST, 3.2, 1, GLINT_PER_CENT, "lobes.modified.relative", "as above"},
    {"lobes", "3.4", "Modified Schlick: largest relative error at most 0.4 %", GLINT_AT_MOST, 0.4,
     1, GLINT_PER_CENT, "lobes.modified.relative", "as above"},
    {"lobes", "Table 3.2, 3.4",
     "Modified Schlick as cos^a/(n − n cos + cos): largest relative error at most 0.4 %",
     GLINT_AT_MOST, 0.4, 1, GLINT_PER_CENT, "lobes.table-form.relative",
     "{lobes.schlick-modified-power.relative:.2%} with the best a for each n, since the thesis "
     "gives no a; {lobes.schlick.relative:.2%} with a = 1, which is Schlick's function"},
    {"lobes", "2.7, 3.4",
     "Modified Schlick renders the zone of decay better than Schlick's function: its absolute "
     "error is smaller, by a factor above 1",
     GLINT_ABOVE, 1.0, 0, GLINT_PLAIN, "lobes.decay.gain",
     "{lobes.decay.gain:.2f} times smaller: Schlick's is {lobes.schlick.decay-absolute:.3f}, (2.2) "
     "as printed {lobes.schlick-modified.decay-absolute:.3f}, with (n(1 − c))² "
     "{lobes.schlick-modified-squared.decay-absolute:.3f}"},

    /* ---- 2.2: the quadratic ---- */
    {"lobes", "2.2", "Quadratic (2.3): relative error at most 3 % at levels of 0.56 and above",
     GLINT_AT_MOST, 3.0, 0, GLINT_PER_CENT, "lobes.quadratic.from-0.56",
     "{lobes.quadratic.from-0.56:.2%} at n = {lobes.quadratic.from-0.56.n}; "
     "{lobes.quadratic.from-0.56-to-512:.2%} up to n = 512, where figure 2.7 ends"},
    {"lobes", "Conclusions", "Quadratic (2.3): relative error in the epicentre at most 2 %",
     GLINT_AT_MOST, 2.0, 0, GLINT_PER_CENT, "lobes.quadratic.relative",
     "{lobes.quadratic.relative:.2%} at n = {lobes.quadratic.relative.n}; "
     "{lobes.quadratic.relative-to-512:.2%} up to n = 512"},
    {"lobes", "2.2", "Quadratic: the same 3 % in the zone of decay", GLINT_AT_MOST, 3.0, 0,
     GLINT_PER_CENT, "lobes.quadratic.decay",
     "{lobes.quadratic.decay:.0%} at n = {lobes.quadratic.decay.n}; the largest absolute error is "
     "{lobes.quadratic.absolute:.3f}"},
    {"lobes", "2.2", "Quadratic: its error is spread evenly over the epicentre", GLINT_AT_MOST, 0.0,
     0, GLINT_NO_NUMBER, NULL,
     "the thesis gives no measure of evenness; the quadratic is up to {lobes.quadratic.above:.1%} "
     "above cosⁿ and up to {lobes.quadratic.below:.1%} below"},
    {"lobes", "2.2",
     "Quadratic: it falls too steeply in the zone of blooming, reaching zero where cosⁿ is still "
     "above 0.01",
     GLINT_ABOVE, 0.01, 2, GLINT_PLAIN, "lobes.quadratic.end-level",
     "from n = 3 on it reaches zero where cosⁿ is {lobes.quadratic.end-level:.3f}; for n = 1 and 2 "
     "it is cosⁿ itself"},
    {"lobes", "(2.8)", "a can be tabulated for n = 1…1000 by (2.8)", GLINT_AT_MOST, 0.0, 0,
     GLINT_PLAIN, "lobes.a.undefined",
     "(2.8) divides by zero for {lobes.a.undefined} of {lobes.a.count} n, first at n = "
     "{lobes.a.undefined.first}; with the limit there, a = {lobes.a.limit}, the quadratic is c "
     "itself; in double precision (2.8) loses {lobes.a.lost:.0e} of a, unless it is rewritten"},

    /* ---- 2.3: the cosine-quadratic ---- */
    {"lobes", "(2.13), (2.14)",
     "With σ = (n+1)/3 the integral of W over its lobe is that of cosⁿ, 1/(n+1)", GLINT_AT_MOST,
     1e-9, 9, GLINT_PLAIN, "lobes.integral.apart",
     "equal to within {lobes.integral.apart:.1e}, by Simpson's rule to the zero of W; the part of "
     "the lobe in front of the surface has up to {lobes.integral.in-front-short:.1%} less, at n = "
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
     "{lobes.cosine-quadratic.relative:.1%} at n = {lobes.cosine-quadratic.relative.n}; "
     "{lobes.device.relative:.1%} for the device"},
    {"lobes", "2.7, 3.1, Conclusions", "Cosine-quadratic: the same 3 % in the zone of decay",
     GLINT_AT_MOST, 3.0, 0, GLINT_PER_CENT, "lobes.cosine-quadratic.decay",
     "{lobes.cosine-quadratic.decay:.0%} at n = {lobes.cosine-quadratic.decay.n}; "
     "{lobes.cosine-quadratic.decay-from-2:.0%} from n = 2 on, as W reaches zero where cosⁿ is "
     "still {lobes.place.end-level:.3f}"},
    {"lobes", "2.3",
     "The relative error W/cosⁿ − 1 has its maximum at tan γ = √(1+2n)/n, n = 3…1000",
     GLINT_AT_MOST, 1e-4, 4, GLINT_PLAIN, "lobes.place.apart",
     "the maximum is off that point by at most {lobes.place.apart:.1e} of the lobe's width "
     "1/(n+1); at n = 1 the error there is {lobes.place.there-at-1:.1%}, the minimum; at n = 2 W "
     "is cosⁿ itself"},
    {"lobes", "2.3", "The point tan γ = √(1+2n)/n is at a level of 0.2 or more", GLINT_REACHES, 0.2,
     1, GLINT_PLAIN, "lobes.place.level", "cosⁿ = {lobes.place.level:.3f} from n = 3 on"},
    {"lobes", "2.3", "The point tan γ = √(1+2n)/n is at a level of 0.4 or less, so below 0.45",
     GLINT_BELOW, 0.45, 1, GLINT_PLAIN, "lobes.place.level",
     "cosⁿ = {lobes.place.level:.3f} from n = 3 on; {lobes.place.level-at-1:.2f} at n = 1"},
    {"lobes", "2.3", "That is the largest relative error of all", GLINT_AT_MOST, 1.0, 0,
     GLINT_PLAIN, "lobes.place.end-to-there",
     "up to {lobes.place.there:.1%} at that point; {lobes.place.at-end:.0%}, "
     "{lobes.place.end-to-there:.2f} times as much, where W is zero and cosⁿ is not"},
    {"lobes", "2.3", "The absolute error is largest at tan γ = √(6n−3)/(n−2)", GLINT_ROUNDS_TO, 1.0,
     2, GLINT_PLAIN, "lobes.place.absolute-to-end",
     "there W is zero and the error is {lobes.place.end-level:.3f}; the largest error is "
     "{lobes.place.absolute-to-end:.2f} times that, from n = 3 on"},
    {"lobes", "3.1",
     "Cosine-quadratic: absolute error in the epicentre 4 times smaller than Schlick's",
     GLINT_REACHES, 4.0, 0, GLINT_PLAIN, "lobes.gain.epicentre", EPICENTRE_GAIN},
    {"lobes", "3.4",
     "Cosine-quadratic: absolute error in the epicentre 3 times smaller than Schlick's",
     GLINT_REACHES, 3.0, 0, GLINT_PLAIN, "lobes.gain.epicentre", "as above"},
    {"lobes", "3.4", "Quadratic: more than 10 times as accurate in the epicentre", GLINT_ABOVE,
     10.0, 0, GLINT_PLAIN, "lobes.quadratic.gain", QUADRATIC_GAIN},

    /* ---- 2.4: the divider ---- */
    {"divider", "(2.19)", "With 6 shifts 1/7 is 1/8 + 1/64, that is 9/64", GLINT_ROUNDS_TO, 9.0, 0,
     GLINT_PLAIN, "divider.example.bits", "{divider.example.bits}"},
    {"divider", "2.4", "The exact increment 255/7 is 36.4286 levels", GLINT_ROUNDS_TO, 36.4286, 4,
     GLINT_PLAIN, "divider.example.exact", "{divider.example.exact:.8g}"},
    {"divider", "2.4", "With the sum it is 35.8594 levels", GLINT_ROUNDS_TO, 35.8594, 4,
     GLINT_PLAIN, "divider.example.sum", "{divider.example.sum:.8g}"},
    {"divider", "2.4", "Its absolute error is 0.5692 of a level", GLINT_ROUNDS_TO, 0.5692, 4,
     GLINT_PLAIN, "divider.example.error", "{divider.example.error:.8g}"},
    {"divider", "2.4", "The same error, one line further down, is 0.5693", GLINT_ROUNDS_TO, 0.5693,
     4, GLINT_PLAIN, "divider.example.error", "{divider.example.error:.8g}"},
    {"divider", "2.4", "Its relative error is 1.56 %", GLINT_ROUNDS_TO, 1.56, 2, GLINT_PER_CENT,
     "divider.example.relative", "{divider.example.relative:.4%}, the same for every difference"},
    {"divider", "2.4, 3.4",
     "6 shifts: the picture looks no worse; taken to mean that no frame has an NMSE above 0.0001",
     GLINT_AT_MOST, 0.0001, 4, GLINT_PLAIN, "divider.worst-nmse",
     "{divider.worst-nmse:.3g}; the last pixel of a span may be {divider.rounded.6.shown} levels "
     "off"},
    {"divider", "2.4", "8 shifts: the largest absolute error of an increment is 0.4427 of a level",
     GLINT_ROUNDS_TO, 0.4427, 4, GLINT_PLAIN, "divider.rounded.8.absolute",
     "{divider.rounded.8.absolute:.8g} at k = {divider.rounded.8.absolute.k}"},
    {"divider", "2.4", "8 shifts: the mean relative error is 0.81 %", GLINT_ROUNDS_TO, 0.81, 2,
     GLINT_PER_CENT, "divider.rounded.8.relative.mean",
     "{divider.rounded.8.relative.mean:.4%}, counting each k once"},
    {"divider", "2.4", "The spans of an average triangle, of 100 pixels, have at most 16 steps",
     GLINT_AT_MOST, 16.0, 0, GLINT_PLAIN, "divider.average.longest",
     "the longest has {divider.average.longest} steps; {divider.average.with-longer} of "
     "{divider.average.triangles} triangles of 90 to 110 pixels have a span of more than 16"},
    {"divider", "Table 2.1", "The average triangle has 100 pixels", GLINT_ROUNDS_TO, 100.0, 0,
     GLINT_PLAIN, "divider.drawn.pixels",
     "{divider.drawn.pixels} are drawn; its area is {divider.drawn.area}"},
    {"divider", "Table 2.1", "18 additions for the increments along edges", GLINT_ROUNDS_TO, 18.0,
     0, GLINT_PLAIN, "divider.described.edge-increments.additions",
     "{divider.described.edge-increments.additions}"},
    {"divider", "Table 2.1", "9 divisions for the increments along edges", GLINT_ROUNDS_TO, 9.0, 0,
     GLINT_PLAIN, "divider.described.edge-increments.divisions",
     "{divider.described.edge-increments.divisions}"},
    {"divider", "Table 2.1", "99 additions for the points along edges", GLINT_ROUNDS_TO, 99.0, 0,
     GLINT_PLAIN, "divider.described.edge-points.additions",
     "{divider.described.edge-points.additions}"},
    {"divider", "Table 2.1", "66 additions for the increments along rows", GLINT_ROUNDS_TO, 66.0, 0,
     GLINT_PLAIN, "divider.described.row-increments.additions",
     "{divider.described.row-increments.additions}"},
    {"divider", "Table 2.1", "33 divisions for the increments along rows", GLINT_ROUNDS_TO, 33.0, 0,
     GLINT_PLAIN, "divider.described.row-increments.divisions",
     "{divider.described.row-increments.divisions}"},
    {"divider", "Table 2.1", "225 additions for the points along rows", GLINT_ROUNDS_TO, 225.0, 0,
     GLINT_PLAIN, "divider.described.row-points.additions",
     "{divider.described.row-points.additions}"},
    {"divider", "Table 2.1", "408 additions in all", GLINT_ROUNDS_TO, 408.0, 0, GLINT_PLAIN,
     "divider.described.all.additions", "{divider.described.all.additions}"},
    {"divider", "Table 2.1", "42 divisions in all", GLINT_ROUNDS_TO, 42.0, 0, GLINT_PLAIN,
     "divider.described.all.divisions", "{divider.described.all.divisions}"},
    {"divider", "Table 2.1", "2946 clocks with division", GLINT_ROUNDS_TO, 2946.0, 0,
     GLINT_CIRCULAR, "divider.described.clocks",
     "{divider.described.clocks}, but the clocks per operation were inferred from this number"},
    {"divider", "Table 2.1", "2064 clocks with the sum instead", GLINT_ROUNDS_TO, 2064.0, 0,
     GLINT_CIRCULAR, "divider.described.clocks-by-shifts",
     "{divider.described.clocks-by-shifts}, inferred in the same way"},
    {"divider", "2.4", "1.43 times faster", GLINT_ROUNDS_TO, 1.43, 2, GLINT_CIRCULAR,
     "divider.described.faster",
     "{divider.described.faster:.8g}, the ratio of those two; no time was measured"},

    /* ---- 2.5: energy ---- */
    {"energy", "(2.20)", "The reflectance function is reciprocal: f_r(L,V) = f_r(V,L)",
     GLINT_AT_MOST, 1e-12, 12, GLINT_PLAIN, "energy.asymmetry",
     "largest relative difference {energy.asymmetry:.3g}, over all {energy.model-count} models"},
    {"energy", "2.5",
     "By conservation of energy the incident energy is at most the reflected, R ≥ 1; so R ≥ 1 for "
     "all 1000 exponents of a lobe that conserves energy",
     GLINT_AT_LEAST, 1000.0, 0, GLINT_PLAIN, "energy.blinn-with-factor.full",
     "R ≥ 1 for {energy.blinn-with-factor.full} exponents of Blinn's lobe with (n+6)/(8π), which "
     "conserves energy according to figure 2.16, and for {energy.w.full} of W, which according to "
     "it does not; (2.22) has R ≤ 1"},
    {"energy", "(2.24)", "At normal incidence, L = N, (2.23) becomes (2.24), with (cos θ₀)/2",
     GLINT_AT_MOST, 1e-3, 3, GLINT_PLAIN, "energy.half-angle.apart",
     "as printed, at n = 1000 the centre of the highlight is {energy.half-angle.centre:.0f} "
     "instead of 1, and R = {energy.half-angle.at-1000:.0f} instead of {energy.w.at-1000:.4f}; the "
     "integrals differ by a factor of up to {energy.half-angle.apart:.3g}"},
    {"energy", "(2.25)", "R is the integral of W cos θ₀ sin θ₀ over dω₀", GLINT_AT_MOST, 1e-3, 3,
     GLINT_PLAIN, "energy.solid-angle.apart",
     "with dω₀ = sin θ₀ dθ₀, R is {energy.solid-angle.at-17:.4f} at n = 17 and "
     "{energy.solid-angle.at-1000:.6f} at n = 1000, and above 1 only for n = "
     "{energy.solid-angle.above.first}…{energy.solid-angle.above.last}; with dθ₀ it is "
     "{energy.held.at-17:.4f} and {energy.held.at-1000:.6f}"},
    {"energy", "2.5, figure 2.15", "Without a factor W does not conserve energy for n = 1…17",
     GLINT_AT_MOST, 0.0, 0, GLINT_PLAIN, "energy.w.otherwise",
     "R > 1 for n = {energy.w.above.first}…{energy.w.above.last}, which differs from the claim for "
     "{energy.w.otherwise} n: R = {energy.w.at-18:.4f} at 18, {energy.w.at-19:.4f} at 19, "
     "{energy.w.at-20:.4f} at 20. By (2.25) with dθ₀, integrated to 5.8/√n, R > 1 for n = "
     "{energy.with-limit.above.first}…{energy.with-limit.above.last}"},
    {"energy", "2.5", "Normal incidence is the worst case: no R(L) is larger than for L = N",
     GLINT_AT_MOST, 0.0, 0, GLINT_PLAIN, "energy.w.above-normal",
     "{energy.w.above-normal} cells of the cosine-quadratic have a larger R than at normal "
     "incidence"},
    {"energy", "(2.25)", "The limit 5.8/√n covers only the first lobe of W", GLINT_AT_LEAST, 5.8, 1,
     GLINT_PLAIN, "energy.zero",
     "W is zero at √n · θ₀ = {energy.zero:.4f}; R by (2.25) with dθ₀ is off by up to "
     "{energy.with-limit.apart:.1%}, at n = {energy.with-limit.apart.n}"},
    {"energy", "(2.26), figure 2.16", "(n+6)/24.55 · W conserves energy for n = 1…1000",
     GLINT_AT_MOST, 0.0, 0, GLINT_PLAIN, "energy.claimed.above",
     "R > 1 for {energy.claimed.above} exponents, n = "
     "{energy.claimed.above.first}…{energy.claimed.above.last}: {energy.claimed.largest:.4f} at n "
     "= {energy.claimed.largest.n}, {energy.claimed.at-1000:.4f} at n = 1000. With A = 6, B must "
     "be at least {energy.smallest-b.up:.6g}"},
    {"energy", "figure 2.16", "Blinn's lobe with (n+6)/(8π) conserves energy for n = 1…1000",
     GLINT_AT_MOST, 0.0, 0, GLINT_PLAIN, "energy.blinn-normalized.grid-above",
     "R is at most {energy.blinn-normalized.grid-largest:.6f}, at n = "
     "{energy.blinn-normalized.grid-largest.n} and {energy.blinn-normalized.grid-largest.angle}°"},

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
    {"frames", "Table 3.2", "Quadratic, n ≥ 170: NMSE below 0.0002", GLINT_BELOW, 0.0002, 4,
     GLINT_PLAIN, "frames.quadratic.nmse-from-170", FRAMES("quadratic", "nmse-from-170")},
    {"frames", "Table 3.2", "Cosine-quadratic: NMSE at most 0.00008", GLINT_AT_MOST, 0.00008, 5,
     GLINT_PLAIN, "frames.cosine-quadratic.nmse", FRAMES("cosine-quadratic", "nmse")},
    {"frames", "3.1, 3.4", "Cosine-quadratic: " UNSEEN, GLINT_BELOW, 0.0001, 4, GLINT_PLAIN,
     "frames.cosine-quadratic.nmse", "as above"},
    {"frames", "3.1", "The device: " UNSEEN, GLINT_BELOW, 0.0001, 4, GLINT_PLAIN, "frames.rtl.nmse",
     FRAMES("rtl", "nmse")},
    {"frames", "3.4", "All the functions: visually identical to cosⁿ, NMSE below 0.0001",
     GLINT_BELOW, 0.0001, 4, GLINT_PLAIN, "frames.all.nmse",
     "{frames.all.nmse:.2g} depending on the scene, for the worst of Schlick's function and those "
     "in Table 3.2"},
    {"frames", "3.4, figure 3.13", "Productivity (frame rate) up to 20 % above cosⁿ", GLINT_REACHES,
     20.0, 0, GLINT_PER_CENT, "frames.time.gain", FRAME_GAIN},
    {"frames", "2.7", "Perspective-correct Gouraud shading raises realism", GLINT_AT_MOST, 0.0, 0,
     GLINT_NO_NUMBER, NULL,
     "realism has no measure; on a coarse sphere, the NMSE against Phong shading is "
     "{frames.perspective.sphere.screen:.3g} when interpolated on the screen and "
     "{frames.perspective.sphere.object:.3g} on the object"},

    /* ---- 1.3: rasterizers ---- */
    {"rasterizers", "1.3",
     "Gouraud shading has 6 drawbacks: it is linear where light is not, loses highlights, uses "
     "normals only at vertices, flickers from frame to frame, makes highlights star-shaped, and "
     "ignores perspective; taken to mean that by a figure for each it is more than twice as far "
     "from the best as Phong shading",
     GLINT_ROUNDS_TO, 6.0, 0, GLINT_PLAIN, "rasterizers.drawbacks",
     "{rasterizers.drawbacks} of the six; flicker {rasterizers.gouraud.flicker:.1%} against "
     "{rasterizers.phong.flicker:.1%}, lost highlight {rasterizers.gouraud.lost:.0%}"},
    {"rasterizers", "1.3",
     "The error of Gouraud shading is smallest on right triangles with legs along the axes; taken "
     "to mean an NMSE no larger than on the same ones turned, or on equilateral ones",
     GLINT_AT_MOST, 1.0, 0, GLINT_PLAIN, "rasterizers.right",
     "{rasterizers.right:.3f} times the smallest of those, on a paraboloid of 288 triangles, n = "
     "20"},

    /* ---- 3.1, 3.4: speed ---- */
    {"speed", "3.1, 3.4",
     "In software the cosine-quadratic is 1.7 times as fast as Schlick's function: one point at a "
     "time",
     GLINT_REACHES, 1.7, 1, GLINT_PLAIN, "speed.cosine-quadratic.scalar.ratios", SPEED("scalar")},
    {"speed", "3.1, 3.4",
     "In software the cosine-quadratic is 1.7 times as fast as Schlick's function: vectorised",
     GLINT_REACHES, 1.7, 1, GLINT_PLAIN, "speed.cosine-quadratic.vectorised.ratios",
     SPEED("vectorised")},

    /* ---- 2.6: ray tracing with pixel segments ---- */
    {"trace", "(2.28)",
     "A row of 640 pixels needs ⌈640/(L+1) + 1⌉ traced pixels; checked for L = 1…64", GLINT_AT_MOST,
     0.0, 0, GLINT_PLAIN, "trace.differing",
     "{trace.by-2-28} at L = {trace.segment}, which is right; {trace.differing.by} too many for "
     "{trace.differing} of the {trace.lengths-checked} lengths, those where L + 1 divides 639"},
    {"trace", "(2.31)",
     "Segments of varying lengths need ⌈640/(ΣL + 1)⌉ + 1 traced pixels: 81 for 80 segments of 7",
     GLINT_ROUNDS_TO, 81.0, 0, GLINT_PLAIN, "trace.by-2-31",
     "the formula gives {trace.by-2-31}; {trace.traced} are needed"},
    {"trace", "2.6",
     "Pixel segments save traced rays with no visible difference; taken to mean an NMSE of at most "
     "0.0001 on smooth objects",
     GLINT_AT_MOST, 0.0001, 4, GLINT_PLAIN, "trace.smooth.nmse",
     "{trace.smooth.nmse:.2g} over sphere and teapot, by (2.27) and linearly, at L = 7 and limit "
     "2.3; traced {trace.sphere.7.rays:.0%} and {trace.teapot.7.rays:.0%} of the pixels"},
    {"trace", "2.6, figure 2.19",
     "InterpolOK controls that the quality of the picture is kept; taken to mean an NMSE of at "
     "most 0.0001 whatever is drawn",
     GLINT_AT_MOST, 0.0001, 4, GLINT_PLAIN, "trace.thin.nmse",
     "{trace.thin.nmse:.2g} on a lattice of thin bars; {trace.grid.limit-0.nmse:.2g} with limit 0: "
     "what lies between two equal ends is lost"},
    {"trace", "(2.30)",
     "Between colours that differ by K ≤ 2.3 pixels may be interpolated; taken to mean that none "
     "is then off by more than that",
     GLINT_AT_MOST, 0.0, 0, GLINT_PER_CENT, "trace.beyond.most",
     "{trace.beyond:.2%} of the interpolated pixels are, depending on object and fill (K as ΔE; "
     "the thesis does not define it)"},
    {"trace", "2.6", "Bicubic interpolation is sharper than bilinear", GLINT_ABOVE, 1.0, 1,
     GLINT_PLAIN, "trace.sharper",
     "{trace.sharper:.2f} times, sphere and teapot, by the mean square of the differences between "
     "neighbours"},
    {"trace", "2.6",
     "Bicubic interpolation has none of the artefacts of nearest neighbour; taken to mean that "
     "where those have seams, steps are at most 1.5 times as large as elsewhere",
     GLINT_AT_MOST, 1.5, 1, GLINT_PLAIN, "trace.seams",
     "{trace.seams:.2f} times as large; of nearest neighbours there are no other steps"},
};
const int glint_claim_count = sizeof glint_claim_table / sizeof glint_claim_table[0];
