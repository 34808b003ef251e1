/* Records what a test has shown for the table in docs/verified.md, when `make verification` asks
 * for it (tests/verification/record.sh). Include it after cmocka.h; the file that does defines
 * _XOPEN_SOURCE 700 first. */
#ifndef GLINT_TESTS_RECORD_H
#define GLINT_TESTS_RECORD_H

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "scratch.h"

#include "child.h"

static inline void record(const char *name, const char *what, const char *method, uint64_t cases,
                          const char *unit, double seconds)
{
    char number[32], elapsed[32];
    snprintf(number, sizeof number, "%" PRIu64, cases);
    snprintf(elapsed, sizeof elapsed, "%.2f", seconds);
    const char *const argv[] = {"tests/verification/record.sh",
                                name,
                                what,
                                method,
                                number,
                                unit,
                                "0", /* not reached by a failing test */
                                elapsed,
                                "make test",
                                NULL};
    pid_t child;
    assert_int_equal(
        posix_spawn(&child, argv[0], NULL, NULL, (char *const *)(uintptr_t)argv, environ), 0);
    assert_int_equal(child_wait(child, 10.0), 0);
}

#endif
