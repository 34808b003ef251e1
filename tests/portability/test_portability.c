/* The C model gives the same bits here, with another C library, and on a machine that stores the
 * highest byte first: those that exact rationals give (tests/reference). */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../reference/reference.h"
#include "../scratch.h"
#include "digest.h"

#include "../child.h"

/* What the reference gives; of the real formula, which it does not have, what x86-64 gives. */
#define SPECULAR "4765a018cd67dcb9"
#define DIVIDER  "983eacbb5a71742e"
#define REAL     "8d8829a0f0472e51"

static const char expected[] = "specular " SPECULAR "\n"
                               "specular-batch " SPECULAR "\n"
                               "specular-device " SPECULAR "\n"
                               "divider " DIVIDER "\n"
                               "divider-batch " DIVIDER "\n"
                               "real " REAL "\n";

/* ---- The reference ------------------------------------------------------------------------------
 */

/* W by the definition in reference.h, every step of it rounded by the function that is there. */
static uint32_t w_of(uint32_t n, uint32_t code, bool drawn)
{
    const long one = REFERENCE_ONE, sigma = reference_nearest_of(n + 1, 3, REFERENCE_SIGMA_BITS);
    const long t = one + reference_nearest_of(sigma * ((long)code - one),
                                              1ul << (REFERENCE_SIGMA_BITS + REFERENCE_COS_BITS),
                                              REFERENCE_COS_BITS);
    const long w = reference_nearest_of(t * t, 1ul << 2 * REFERENCE_COS_BITS, REFERENCE_COS_BITS);
    if (!drawn)
        return t < 0 ? 0 : (uint32_t)w;
    return w < reference_nearest_of(1, 510, REFERENCE_COS_BITS) ? 0 : w > one ? one : (uint32_t)w;
}

static uint64_t take_points(uint32_t n, bool drawn, uint64_t digest)
{
    for (int i = 0; i < PORTABILITY_CODES; i++) {
        const uint32_t w = w_of(n, portability_code(i), drawn);
        uint8_t rgb[3];
        for (int c = 0; c < 3; c++) {
            rgb[c] =
                (uint8_t)reference_nearest_of((long)w * portability_color(n, c), REFERENCE_ONE, 0);
        }
        digest = portability_take_point(digest, w, rgb[0], rgb[1], rgb[2]);
    }
    return digest;
}

static void the_numbers_are_those_of_exact_rationals(void **state)
{
    (void)state;
    char digest[17];
    uint64_t points = PORTABILITY_DIGEST_START, divisions = PORTABILITY_DIGEST_START;
    for (int gate = 0; gate < 3; gate++)
        for (int i = 0; i < PORTABILITY_EXPONENTS; i++)
            points = take_points(portability_exponent(i), gate == 2, points);
    (void)snprintf(digest, sizeof digest, "%016" PRIx64, points);
    assert_string_equal(digest, SPECULAR);
    for (unsigned shifts = 6; shifts <= 16; shifts++) {
        for (unsigned long k = 1; k <= 16; k++) {
            const long bits = reference_reciprocal(shifts, k);
            for (int i = 0; i < PORTABILITY_DIFFERENCES; i++) {
                long code;
                assert_true(reference_quotient(shifts, i - 255, bits, &code));
                divisions = portability_take(divisions, (uint32_t)code, 4);
            }
        }
    }
    (void)snprintf(digest, sizeof digest, "%016" PRIx64, divisions);
    assert_string_equal(digest, DIVIDER);
}

/* ---- Machines -----------------------------------------------------------------------------------
 */

static void assert_digests(const char *path)
{
    char *text = scratch_read(path, NULL);
    assert_string_equal(text, expected);
    free(text);
}

static void this_machine_gives_them(void **state)
{
    (void)state;
    FILE *out = fopen(scratch_path("here"), "w");
    assert_non_null(out);
    portability_print(out);
    assert_int_equal(fclose(out), 0);
    assert_digests(scratch_path("here"));
}

static bool is_installed(const char *program)
{
    char line[256];
    (void)snprintf(line, sizeof line, "command -v %s", program);
    const char *const argv[] = {"sh", "-c", line, NULL};
    return child_run(argv, 60.0) == 0;
}

/* Compiles the model and the program of the digests, all into one file, and runs it. */
static void compile_and_run(const char *compiler, const char *emulator)
{
    char line[4096];
    (void)snprintf(
        line, sizeof line,
        "%s -std=c17 -O2 -Wall -Wextra -Werror -ffp-contract=off -fno-math-errno -static "
        "-Icmodel -o '%s' $(ls cmodel/*.c | grep -v /gen.c) tests/portability/main.c "
        "tests/portability/digest.c -lm && %s '%s'",
        compiler, scratch_path("digest"), emulator, scratch_path("digest"));
    const char *const argv[] = {"sh", "-c", line, NULL};
    const int status = child_run(argv, 300.0);
    if (status != 0) {
        char *err = scratch_read(scratch_path("child.err"), NULL);
        print_error("%s", err);
        free(err);
    }
    assert_int_equal(status, 0);
    assert_digests(scratch_path("child.out"));
}

static void so_does_a_static_program_with_musl(void **state)
{
    (void)state;
    compile_and_run("musl-gcc", "");
}

static void so_does_a_big_endian_machine(void **state)
{
    (void)state;
    if (!is_installed("s390x-linux-gnu-gcc") || !is_installed("qemu-s390x-static")) {
        print_message("make portability installs the compiler and the emulator\n");
        skip();
    }
    compile_and_run("s390x-linux-gnu-gcc", "qemu-s390x-static");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_numbers_are_those_of_exact_rationals),
        cmocka_unit_test(this_machine_gives_them),
        cmocka_unit_test(so_does_a_static_program_with_musl),
        cmocka_unit_test(so_does_a_big_endian_machine),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
