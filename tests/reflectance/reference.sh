#!/bin/sh
# Writes reference.h: values of every model to 25 digits by bc (40 digits inside), from the thesis's
# formulas as they are printed, so by other means than sim/reflectance/.
#
#   tests/reflectance/reference.sh > tests/reflectance/reference.h
set -eu

command -v bc >/dev/null 2>&1 || {
    echo "tests/reflectance/reference.sh: no bc; sim/deps.sh test installs it" >&2
    exit 2
}

echo '/* Written by tests/reflectance/reference.sh. */'
echo '/* clang-format off */'
export BC_LINE_LENGTH=0
bc -l <<'END'
scale = 45
pi = 4 * a(1)

define p(x, y) { /* x^y */
    if (y == 0) return 1;
    if (x == 0) return 0;
    return e(y * l(x));
}
define k(x) { /* arccos x, x > 0 */
    return a(sqrt(1 - x * x) / x);
}
define g(x, n) { /* the argument squared, where it is not negative */
    auto t;
    t = (n + 1) / 3 * (x - 1) + 1;
    if (t < 0) return 0;
    return t * t;
}
define q(x, n) { /* (2.3) with (2.8) */
    auto t, b, v;
    b = 0;
    if (n > 1) {
        t = c(a(1 / sqrt(n - 1)));
        b = (p(t, n - 1) - 1) / (t - 1);
    }
    v = b * x * x + (1 - b) * x;
    if (v < 0) return 0;
    return v;
}
define f(x, n, j) { /* (1 − w(1−x)/j)^j, w = j(n+1)/(j+1) */
    auto b, v, i;
    b = 1 - (n + 1) / (j + 1) * (1 - x);
    if (b < 0) return 0;
    v = 1;
    for (i = 0; i < j; i++) v = v * b;
    return v;
}

/* One line: model, n, cosine, value. */
define z(v) {
    scale = 25;
    print (v / 1);
    scale = 45;
    print "},\n";
    return 0;
}
/* The power of two nearest to n, by its logarithm: 2^k with 2^(2k - 1) <= n^2 < 2^(2k + 1). */
define t(n) {
    auto k;
    k = 1;
    while (n * n >= 2 * k * k) k = 2 * k;
    return k;
}
define r(n, x) {
    auto y, d;
    y = k(x);
    d = n - n * x + x;
    print "{GLINT_REFLECTANCE_LAMBERT, ", n, ", ", x, ", "
    y0 = z(x);
    print "{GLINT_REFLECTANCE_PHONG, ", n, ", ", x, ", "
    y0 = z(p(x, n));
    print "{GLINT_REFLECTANCE_BLINN, ", n, ", ", x, ", "
    y0 = z(p(x, n));
    print "{GLINT_REFLECTANCE_BLINN_NORMALIZED, ", n, ", ", x, ", "
    y0 = z((n + 6) / (8 * pi) * p(x, n));
    print "{GLINT_REFLECTANCE_LOG2_N, ", n, ", ", x, ", "
    y0 = z(p(x, t(n)));
    print "{GLINT_REFLECTANCE_SCHLICK, ", n, ", ", x, ", "
    y0 = z(x / d);
    print "{GLINT_REFLECTANCE_SCHLICK_MODIFIED, ", n, ", ", x, ", "
    y0 = z(x / (0.5 * n * (1 - x * x) + d));
    print "{GLINT_REFLECTANCE_SCHLICK_MODIFIED_ANGLE, ", n, ", ", x, ", "
    y0 = z(x / (0.5 * n * (1 - c(y * y)) + d));
    print "{GLINT_REFLECTANCE_SCHLICK_MODIFIED_LINEAR, ", n, ", ", x, ", "
    y0 = z(x / (0.5 * n * (1 - x) ^ 2 + d));
    print "{GLINT_REFLECTANCE_SCHLICK_MODIFIED_SQUARED, ", n, ", ", x, ", "
    y0 = z(x / (0.5 * (n * (1 - x)) ^ 2 + d));
    print "{GLINT_REFLECTANCE_QUADRATIC, ", n, ", ", x, ", "
    y0 = z(q(x, n));
    print "{GLINT_REFLECTANCE_COSINE_QUADRATIC, ", n, ", ", x, ", "
    y0 = z(g(x, n));
    print "{GLINT_REFLECTANCE_ENERGY_CONSERVING, ", n, ", ", x, ", "
    y0 = z((n + 6) / 24.55 * g(x, n));
    print "{GLINT_REFLECTANCE_LYON_4, ", n, ", ", x, ", "
    y0 = z(f(x, n, 4));
    print "{GLINT_REFLECTANCE_LYON_8, ", n, ", ", x, ", "
    y0 = z(f(x, n, 8));
    print "{GLINT_REFLECTANCE_LYON_16, ", n, ", ", x, ", "
    y0 = z(f(x, n, 16));
    return 0;
}
define w(n) {
    y0 = r(n, 1); y0 = r(n, 0.9999); y0 = r(n, 0.9985); y0 = r(n, 0.99); y0 = r(n, 0.92);
    y0 = r(n, 0.7); y0 = r(n, 0.4); y0 = r(n, 0.05);
    return 0;
}

/* FDG/(4(N·L)(N·V)) of directions at angles x and y from the normal, o apart around it. h: of 1/m²
 * with m² = 2/(n+2). j: 0 the Gaussian, whose integral over all angles is (by Dawson's function)
 * π m ∑ (−2)^i m^(2i+1)/(2i+1)!!; the part beyond 90° is left in, so n is 80 at least. */
define h(n, f, x, y, o, j) {
    auto b, m, s, t, u, v, d, i, w, q, r, k;
    m = sqrt(2 / (n + 2));
    b = s(x) * s(y) * c(o) + c(x) * c(y); /* L·V */
    v = sqrt((1 + b) / 2);                /* V·H */
    u = (c(x) + c(y)) / sqrt(2 + 2 * b);  /* N·H */
    t = 1 / (u * u) - 1;                  /* tan² α */
    if (j == 0) {
        i = a(sqrt(t));
        d = e(-i * i / m ^ 2);
        s = 0; k = m; r = 1;
        for (i = 1; i < 80; i++) { s = s + k; r = r + 2; k = -2 * k * m * m / r; }
        d = d / (pi * m * s);
    } else {
        d = e(-t / m ^ 2) / (pi * m ^ 2 * u ^ 4);
    }
    w = 1;
    if (2 * u * c(x) / v < w) w = 2 * u * c(x) / v;
    if (2 * u * c(y) / v < w) w = 2 * u * c(y) / v;
    q = 1;
    if (f < 1) {
        r = (1 + sqrt(f)) / (1 - sqrt(f));
        /* Fresnel's equations themselves: s and p, refracted angle by Snell's law. */
        k = sqrt(1 - (1 - v * v) / r ^ 2);
        q = (((v - r * k) / (v + r * k)) ^ 2 + ((r * v - k) / (r * v + k)) ^ 2) / 2;
    }
    return q * d * w / (4 * c(x) * c(y));
}
define m(n, f, x, y, o) {
    print "{GLINT_REFLECTANCE_TORRANCE_SPARROW, ", n, ", ", f, ", ", x, ", ", y, ", ", o, ", "
    y0 = z(h(n, f, x, y, o, 0));
    print "{GLINT_REFLECTANCE_COOK_TORRANCE, ", n, ", ", f, ", ", x, ", ", y, ", ", o, ", "
    y0 = z(h(n, f, x, y, o, 1));
    return 0;
}
define u(n, f) {
    y0 = m(n, f, 0, 0, 0); y0 = m(n, f, 0.3, 0.3, 3.1); y0 = m(n, f, 0.5, 0.6, 3);
    y0 = m(n, f, 0.1, 0.2, 1); y0 = m(n, f, 1.2, 1.3, 3.1); y0 = m(n, f, 1.5, 1.55, 3.14);
    y0 = m(n, f, 1.2, 1.2, 3.0);
    return 0;
}

print "static const struct {\n"
print "    glint_reflectance_model model;\n    double n, cosine, value;\n} reference_lobes[] = {\n"
y0 = w(1); y0 = w(2); y0 = w(3); y0 = w(7.5); y0 = w(80); y0 = w(1000)
print "};\n\nstatic const struct {\n"
print "    glint_reflectance_model model;\n"
print "    double n, f0, light, viewer, around, brdf;\n} reference_facets[] = {\n"
y0 = u(80, 0.04); y0 = u(80, 1); y0 = u(200, 0.5); y0 = u(1000, 0.04)
print "};\n"
halt
END
