/* What every lobe must have: its ends, no rise with the angle, the same values in all its forms;
 * and what defines the members of the families. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <math.h>

#include "glint_specular.h"
#include "lobes.h"

static const double exponents[] = {0, 1, 1.5, 2, 3, 4, 8, 16, 17, 50, 80, 170, 512, 1000, 1023};
#define EXPONENTS (sizeof exponents / sizeof exponents[0])

/* Dense near 1, where highlights are: c = 1 − (i/STEPS)³. */
#define STEPS 20000

static double dense_cosine(int i)
{
    const double s = (double)i / STEPS;
    return 1.0 - s * s * s;
}

static void every_model_is_found_by_its_name(void **state)
{
    (void)state;
    glint_reflectance_model model = GLINT_REFLECTANCE_DEVICE;
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++) {
        assert_true(glint_reflectance_find(glint_reflectance_names[i], &model));
        assert_int_equal(model, i);
        const glint_reflectance_info *info = glint_reflectance_describe(model);
        assert_true(strlen(info->title) > 0 && strlen(info->formula) > 0);
        assert_true(strlen(info->edges) > 0 && info->equation != NULL);
        assert_true(info->n_min <= 1 && info->n_max >= 1000);
    }
    assert_null(glint_reflectance_names[GLINT_REFLECTANCE_COUNT]);
    assert_false(glint_reflectance_find("Blinn", &model));
    assert_false(glint_reflectance_find("", &model));
    assert_int_equal(model, GLINT_REFLECTANCE_COUNT - 1);
    assert_null(glint_reflectance_describe(GLINT_REFLECTANCE_COUNT));
}

static void arguments_outside_the_domain_are_refused(void **state)
{
    (void)state;
    static const struct {
        glint_reflectance_model model;
        double n, cosine;
        const char *message;
    } refusals[] = {
        {GLINT_REFLECTANCE_SCHLICK, 0.5, 0.5, "model schlick: n = 0.5 is outside 1…1e+06"},
        {GLINT_REFLECTANCE_QUADRATIC, 0, 0.5, "model quadratic: n = 0 is outside 1…1e+06"},
        {GLINT_REFLECTANCE_LOG2_N, 0.9, 0.5, "model log2-n: n = 0.9 is outside 1…1e+06"},
        {GLINT_REFLECTANCE_BLINN, -1, 0.5, "model blinn: n = -1 is outside 0…1e+06"},
        {GLINT_REFLECTANCE_BLINN, NAN, 0.5, "model blinn: n = nan is outside 0…1e+06"},
        {GLINT_REFLECTANCE_LYON_8, 2e6, 0.5, "model lyon-8: n = 2e+06 is outside 0…1e+06"},
        {GLINT_REFLECTANCE_DEVICE, 1024, 0.5, "model device: n = 1024 is outside 0…1023"},
        {GLINT_REFLECTANCE_DEVICE, 2.5, 0.5, "model device: n = 2.5 is not an integer"},
        {GLINT_REFLECTANCE_BLINN, 5, 1.01, "model blinn: the cosine 1.01 is outside 0…1"},
        {GLINT_REFLECTANCE_BLINN, 5, -0.01, "model blinn: the cosine -0.01 is outside 0…1"},
        {GLINT_REFLECTANCE_BLINN, 5, NAN, "model blinn: the cosine nan is outside 0…1"},
        {GLINT_REFLECTANCE_COOK_TORRANCE, 5, 0.5,
         "model cook-torrance is not a function of one cosine: it needs directions"},
        {GLINT_REFLECTANCE_COUNT, 5, 0.5, "unknown reflectance model number 24"},
    };
    for (size_t i = 0; i < sizeof refusals / sizeof refusals[0]; i++) {
        double value = 7;
        glint_error err;
        assert_int_equal(glint_reflectance_eval(refusals[i].model, refusals[i].n,
                                                refusals[i].cosine, &value, &err),
                         GLINT_BAD_ARGUMENT);
        assert_string_equal(err.text, refusals[i].message);
        assert_true(value == 7);
    }
    glint_reflectance r;
    glint_error err;
    const glint_reflectance_parameters bright = {.n = 5, .f0 = 1.5};
    assert_int_equal(
        glint_reflectance_prepare(GLINT_REFLECTANCE_TORRANCE_SPARROW, &bright, &r, &err),
        GLINT_BAD_ARGUMENT);
    assert_string_equal(err.text, "model torrance-sparrow: F0 = 1.5 is outside 0…1");
}

static void a_lobe_is_one_at_its_centre_and_never_rises_with_the_angle(void **state)
{
    (void)state;
    int lobes = 0;
    for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++) {
        for (size_t i = 0; is_plain_lobe(model) && i < EXPONENTS; i++) {
            if (!takes(model, exponents[i]))
                continue;
            const glint_reflectance r = prepared((glint_reflectance_model)model, exponents[i]);
            double before = glint_reflectance_of_cosine(&r, 1.0);
            assert_true(before == 1.0);
            for (int j = 1; j <= STEPS; j++) {
                const double value = glint_reflectance_of_cosine(&r, dense_cosine(j));
                if (!(value <= before + 1e-15 && value >= 0.0)) {
                    fail_msg("%s, n = %g: rises at cosine %.17g", glint_reflectance_names[model],
                             exponents[i], dense_cosine(j));
                }
                before = value;
            }
            lobes++;
        }
    }
    assert_true(lobes > 18 * 13);
}

static void a_cosine_beyond_the_ends_counts_as_the_end(void **state)
{
    (void)state;
    for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++) {
        const glint_reflectance r = prepared((glint_reflectance_model)model, 3);
        if (!is_lobe(model)) {
            assert_true(isnan(glint_reflectance_of_cosine(&r, 0.5)));
            continue;
        }
        const float cosine[] = {-0.5f, 0.0f, 1.0f, 1.5f};
        float value[4];
        glint_reflectance_batch(&r, cosine, 4, value);
        for (int i = 0; i < 4; i += 2) {
            assert_true(value[i] == value[i + 1]);
            assert_true(glint_reflectance_of_cosine(&r, (double)cosine[i]) ==
                        glint_reflectance_of_cosine(&r, (double)cosine[i + 1]));
        }
    }
}

/* Where the thesis divides by zero, or the formula turns negative or rises again. */
static void edges_are_as_described(void **state)
{
    (void)state;
    static const glint_reflectance_model itself[] = {
        GLINT_REFLECTANCE_PHONG, GLINT_REFLECTANCE_BLINN, GLINT_REFLECTANCE_SCHLICK,
        GLINT_REFLECTANCE_SCHLICK_MODIFIED_POWER, GLINT_REFLECTANCE_QUADRATIC};
    for (int i = 0; i <= 100; i++) {
        const double c = i / 100.0;
        for (size_t j = 0; j < sizeof itself / sizeof itself[0]; j++) {
            const glint_reflectance r = prepared(itself[j], 1);
            assert_true(fabs(glint_reflectance_of_cosine(&r, c) - c) < 1e-15);
        }
        const glint_reflectance quadratic = prepared(GLINT_REFLECTANCE_QUADRATIC, 2);
        const glint_reflectance cosine_quadratic = prepared(GLINT_REFLECTANCE_COSINE_QUADRATIC, 2);
        const glint_reflectance minimax = prepared(GLINT_REFLECTANCE_LYON_2_MINIMAX, 2);
        assert_true(fabs(glint_reflectance_of_cosine(&quadratic, c) - c * c) < 1e-15);
        assert_true(fabs(glint_reflectance_of_cosine(&cosine_quadratic, c) - c * c) < 1e-15);
        assert_true(fabs(glint_reflectance_of_cosine(&minimax, c) - c * c) < 1e-12);
    }
    for (int n = 3; n <= 1000; n++) {
        const glint_reflectance quadratic = prepared(GLINT_REFLECTANCE_QUADRATIC, n);
        const glint_reflectance cosine_quadratic = prepared(GLINT_REFLECTANCE_COSINE_QUADRATIC, n);
        const double a = glint_quadratic_a(n);
        const double zero[] = {(a - 1.0) / a, (n - 2.0) / (n + 1.0)};
        const glint_reflectance *lobe[] = {&quadratic, &cosine_quadratic};
        for (int i = 0; i < 2; i++) {
            assert_true(glint_reflectance_of_cosine(lobe[i], zero[i] - 1e-9) == 0.0);
            assert_true(glint_reflectance_of_cosine(lobe[i], 0.0) == 0.0);
            assert_true(glint_reflectance_of_cosine(lobe[i], zero[i] + 1e-6) > 0.0);
        }
    }
    const glint_reflectance wide = prepared(GLINT_REFLECTANCE_COSINE_QUADRATIC, 1);
    assert_true(fabs(glint_reflectance_of_cosine(&wide, 0.0) - 1.0 / 9.0) < 1e-15);
}

enum { COUNT = 2 * 1031 };

/* Over all cosines, and where a lobe of n is: c = 1 − t/n, t = 0…20. */
static void fill_cosines(double n, float cosine[COUNT])
{
    for (int j = 0; j < COUNT / 2; j++) {
        const double s = (double)j / (COUNT / 2 - 1);
        cosine[j] = (float)(1.0 - s * s * s);
        cosine[COUNT / 2 + j] = (float)fmax(0.0, 1.0 - 20.0 * s / fmax(1.0, n));
    }
}

static void assert_forms_agree(glint_reflectance_model model, double n)
{
    float cosine[COUNT], value[COUNT];
    const glint_reflectance r = prepared(model, n);
    const double height = fmax(1.0, glint_reflectance_of_cosine(&r, 1.0));
    fill_cosines(n, cosine);
    glint_reflectance_batch(&r, cosine, COUNT, value);
    for (int j = 0; j < COUNT; j++) {
        const double exact = glint_reflectance_of_cosine(&r, (double)cosine[j]);
        if (!(fabs((double)value[j] - exact) <= 1e-6 * height)) {
            fail_msg("%s, n = %g, cosine %.9g: batch %.9g, one by one %.9g",
                     glint_reflectance_names[model], n, (double)cosine[j], (double)value[j], exact);
        }
    }
    double once = -1.0;
    assert_int_equal(glint_reflectance_eval(model, n, (double)cosine[500], &once, NULL), GLINT_OK);
    assert_true(once == glint_reflectance_of_cosine(&r, (double)cosine[500]));
}

static void all_forms_of_a_model_agree(void **state)
{
    (void)state;
    static const double large[] = {1e4, 1e5, 123456.7, 1e6};
    for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++) {
        for (size_t i = 0; is_lobe(model) && i < EXPONENTS + 4; i++) {
            const double n = i < EXPONENTS ? exponents[i] : large[i - EXPONENTS];
            if (takes(model, n))
                assert_forms_agree((glint_reflectance_model)model, n);
        }
    }
}

static void the_device_is_the_circuit(void **state)
{
    (void)state;
    for (uint32_t n = 0; n < GLINT_N_COUNT; n += 31) {
        const glint_reflectance r = prepared(GLINT_REFLECTANCE_DEVICE, n);
        for (uint32_t code = 0; code <= GLINT_COS_ONE; code += 257) {
            const glint_material white = {.n = (uint16_t)n, .r = 255, .g = 255, .b = 255};
            const double cosine = (double)code / GLINT_COS_ONE;
            uint32_t w;
            uint8_t red, green, blue;
            assert_int_equal(
                glint_specular_batch(GLINT_GATE_COSINE, &white, &code, 1, &w, &red, &green, &blue),
                GLINT_OK);
            assert_true(glint_reflectance_of_cosine(&r, cosine) == (double)w / GLINT_W_ONE);
        }
    }
}

static double integral(const glint_reflectance *r, double from)
{
    /* Simpson's rule is exact only up to cubics: with this many steps it is for k = 16 too. */
    enum { INTERVALS = 4000 };
    const double step = (1.0 - from) / INTERVALS;
    double sum = 0.0;
    for (int i = 0; i <= INTERVALS; i++) {
        const double weight = i == 0 || i == INTERVALS ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        sum += weight * glint_reflectance_of_cosine(r, from + i * step);
    }
    return sum * step / 3.0;
}

/* (2.13), (2.14): ∫ W sin γ dγ = ∫ W dc = 1/(n+1), that of cosⁿ. */
static void equal_widths_have_the_integral_of_the_power(void **state)
{
    (void)state;
    static const struct {
        glint_reflectance_model model;
        int k;
    } members[] = {{GLINT_REFLECTANCE_COSINE_QUADRATIC, 2},
                   {GLINT_REFLECTANCE_LYON_4, 4},
                   {GLINT_REFLECTANCE_LYON_8, 8},
                   {GLINT_REFLECTANCE_LYON_16, 16}};
    for (size_t i = 0; i < sizeof members / sizeof members[0]; i++) {
        for (int n = members[i].k; n <= 1000; n++) { /* from k on the lobe ends within 0…1 */
            const glint_reflectance r = prepared(members[i].model, n);
            const double zero = 1.0 - 1.0 / r.lyon.slope;
            assert_true(fabs((n + 1) * integral(&r, zero) - 1.0) < 1e-9);
        }
    }
    assert_true(glint_lyon_slope_equal(2, 100) == 101.0 / 3.0); /* σ */
}

/* The largest differences from cosⁿ upwards and downwards, by a search of the test's own. */
static void largest_differences(int k, double slope, double n, double *above, double *below)
{
    *above = *below = 0.0;
    for (int i = 0; i <= STEPS; i++) {
        const double c = dense_cosine(i);
        const double line = slope * (c - 1.0) + 1.0;
        const double difference = (line > 0.0 ? pow(line, k) : 0.0) - pow(c, n);
        *above = fmax(*above, difference);
        *below = fmax(*below, -difference);
    }
}

static void minimax_widths_are_the_best(void **state)
{
    (void)state;
    for (int k = 2; k <= 16; k *= 2) {
        for (size_t i = 1; i < EXPONENTS; i++) {
            const double n = exponents[i];
            const double slope = glint_lyon_slope_minimax(k, n);
            double above, below, other_above, other_below;
            largest_differences(k, slope, n, &above, &below);
            assert_true(fabs(above - below) < 2e-6);
            for (int sign = -1; sign <= 1; sign += 2) {
                largest_differences(k, slope * (1.0 + 1e-3 * sign), n, &other_above, &other_below);
                assert_true(fmax(other_above, other_below) >= fmax(above, below));
            }
            largest_differences(k, glint_lyon_slope_equal(k, n), n, &other_above, &other_below);
            assert_true(fmax(other_above, other_below) >= fmax(above, below) - 2e-6);
        }
        assert_true(fabs(glint_lyon_slope_minimax(k, k) - 1.0) < 1e-6); /* c^k itself */
    }
}

/* x = n(1−c): cosⁿ → e^-x, and with equal integrals (1 − x/(k+1))^k, which goes there with k. */
static void the_family_goes_to_the_power_as_k_grows(void **state)
{
    (void)state;
    double before = 1.0;
    for (int k = 2; k <= 1 << 20; k *= 2) {
        double largest = 0.0;
        for (int i = 0; i <= 4000; i++) {
            const double x = i / 200.0;
            const double line = 1.0 - x / (k + 1.0);
            const double value = line > 0.0 ? pow(line, k) : 0.0;
            largest = fmax(largest, fabs(value - exp(-x)));
        }
        if (k <= 16) {
            /* A lobe so narrow that it is its own limit. */
            static const glint_reflectance_model of[] = {[1] = GLINT_REFLECTANCE_COSINE_QUADRATIC,
                                                         [2] = GLINT_REFLECTANCE_LYON_4,
                                                         [3] = GLINT_REFLECTANCE_LYON_8,
                                                         [4] = GLINT_REFLECTANCE_LYON_16};
            const int log2_k = k == 2 ? 1 : k == 4 ? 2 : k == 8 ? 3 : 4;
            const glint_reflectance r = prepared(of[log2_k], 1e6);
            for (int i = 0; i <= 4000; i++) {
                const double x = i / 200.0;
                const double line = 1.0 - x / (k + 1.0);
                assert_true(fabs(glint_reflectance_of_cosine(&r, 1.0 - x / 1e6) -
                                 (line > 0.0 ? pow(line, k) : 0.0)) < 2e-6);
            }
        }
        assert_true(largest < 0.57 * before);
        before = largest;
    }
    assert_true(before < 1e-6);
}

static void the_power_of_table_3_2_is_the_best(void **state)
{
    (void)state;
    static const double tried[] = {0.999, 1.0, 1.001};
    assert_true(glint_schlick_power_a(1) == 1.0);
    for (size_t i = 3; i < EXPONENTS; i++) {
        double largest[3] = {0, 0, 0};
        const double n = exponents[i], best = glint_schlick_power_a(n);
        const double end = pow(GLINT_EPICENTRE_LEVEL, 1.0 / n);
        for (int j = 0; j < 3; j++) {
            for (int s = 0; s <= STEPS; s++) {
                const double c = 1.0 - (1.0 - end) * s / STEPS;
                const double value = pow(c, best * tried[j]) / (n - n * c + c);
                largest[j] = fmax(largest[j], fabs(value / pow(c, n) - 1.0));
            }
        }
        assert_true(largest[1] < largest[0] && largest[1] < largest[2]);
    }
}

/* k is log2 n rounded where 2^(2k − 1) ≤ n² < 2^(2k + 1): in integers, by no logarithm. */
static void squarings_are_of_the_nearest_power_of_two(void **state)
{
    (void)state;
    for (uint64_t n = 1; n <= 1023; n++) {
        int k = 0;
        while (n * n >= (uint64_t)2 << (2 * k))
            k++;
        const glint_reflectance r = prepared(GLINT_REFLECTANCE_LOG2_N, (double)n);
        for (int i = 0; i <= 100; i++) {
            const double c = 1.0 - i / 200.0 / (double)n;
            const double expected = pow(c, (double)(1 << k));
            assert_true(fabs(glint_reflectance_of_cosine(&r, c) - expected) < 1e-12);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_model_is_found_by_its_name),
        cmocka_unit_test(arguments_outside_the_domain_are_refused),
        cmocka_unit_test(a_lobe_is_one_at_its_centre_and_never_rises_with_the_angle),
        cmocka_unit_test(a_cosine_beyond_the_ends_counts_as_the_end),
        cmocka_unit_test(edges_are_as_described),
        cmocka_unit_test(all_forms_of_a_model_agree),
        cmocka_unit_test(the_device_is_the_circuit),
        cmocka_unit_test(equal_widths_have_the_integral_of_the_power),
        cmocka_unit_test(minimax_widths_are_the_best),
        cmocka_unit_test(the_family_goes_to_the_power_as_k_grows),
        cmocka_unit_test(the_power_of_table_3_2_is_the_best),
        cmocka_unit_test(squarings_are_of_the_nearest_power_of_two),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
