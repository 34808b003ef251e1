/* What the cache of circuits lets go of: what was not used for longest, beyond what is kept, and
 * nothing else; a directory whole. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <fcntl.h>
#include <stdbool.h>
#include <time.h>

#include "../scratch.h"

#include "rtl/cache.h"

enum { HOUR = 60 * 60, DAY = 24 * HOUR };

static void used_before(const char *name, time_t seconds)
{
    const struct timespec then = {.tv_sec = time(NULL) - seconds};
    const struct timespec times[2] = {then, then};
    assert_int_equal(utimensat(AT_FDCWD, scratch_path(name), times, 0), 0);
}

static void make_file(const char *name, time_t age)
{
    scratch_write(scratch_path(name), "made", 4);
    used_before(name, age);
}

static void make_runtime(const char *name, time_t age)
{
    char path[100];
    assert_int_equal(mkdir(scratch_path(name), 0777), 0);
    (void)snprintf(path, sizeof path, "%s/verilated.o", name);
    make_file(path, age);
    (void)snprintf(path, sizeof path, "%s/fast.h.gch", name);
    make_file(path, age);
    used_before(name, age);
}

static bool is_there(const char *name)
{
    return access(scratch_path(name), F_OK) == 0;
}

static void files_beyond_those_kept_go(void **state)
{
    (void)state;
    make_file("a-1.so", 3 * HOUR);
    make_file("a-2.so", 1 * HOUR);
    make_file("a-3.so", 2 * HOUR);
    make_file("a-4.txt", 9 * HOUR);
    make_file("b-1.so", 9 * HOUR);
    glint_cache_prune(scratch_directory, "a-", ".so", 3, 0);
    assert_int_equal(scratch_count(), 5);
    glint_cache_prune(scratch_directory, "a-", ".so", 2, 0);
    assert_false(is_there("a-1.so"));
    glint_cache_touch(scratch_path("a-3.so"));
    glint_cache_prune(scratch_directory, "a-", ".so", 1, 0);
    assert_true(is_there("a-3.so"));
    assert_int_equal(scratch_count(), 3);
}

/* A process that has just found one is about to link with what is in it. */
static void runtimes_of_today_stay(void **state)
{
    (void)state;
    make_runtime("runtime-1.d", 3 * DAY);
    make_runtime("runtime-2.d", 1 * HOUR);
    make_runtime("runtime-3.d", 2 * DAY);
    make_runtime("runtime-4.d", 2 * HOUR);
    make_file("runtime-1.d.lock", 3 * DAY);
    glint_cache_prune(scratch_directory, "runtime-", ".d", 1, DAY);
    assert_false(is_there("runtime-1.d"));
    assert_true(is_there("runtime-2.d/verilated.o"));
    assert_false(is_there("runtime-3.d"));
    assert_true(is_there("runtime-4.d/fast.h.gch"));
    assert_true(is_there("runtime-1.d.lock")); /* somebody's */
    glint_cache_prune(scratch_directory, "runtime-", ".d", 1, 0);
    assert_true(is_there("runtime-2.d"));
    assert_false(is_there("runtime-4.d"));
    assert_int_equal(scratch_count(), 3 + 2);
}

/* What cannot be removed keeps nobody waiting. */
static void what_is_not_there_is_no_matter(void **state)
{
    (void)state;
    glint_cache_prune("/no/such/directory", "a-", ".so", 0, 0);
    glint_cache_prune("/proc/self", "stat", "", 0, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_beyond_those_kept_go),
        cmocka_unit_test(runtimes_of_today_stay),
        cmocka_unit_test(what_is_not_there_is_no_matter),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
