/* Runs the fuzz targets on the stored inputs (tests/fuzz/corpus, including those that once failed)
 * and on some thousands of mutations of them. `make fuzz` continues from here. */
#define _XOPEN_SOURCE 700

#include <dirent.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../seed.h"
#include "fuzz.h"

#define INPUTS_MAX 128
#define BYTES_MAX  8192

typedef struct input {
    char name[256];
    uint8_t bytes[BYTES_MAX];
    size_t count;
} input;

typedef struct corpus {
    input inputs[INPUTS_MAX];
    int count;
} corpus;

static uint64_t seed;

static uint64_t draw(uint64_t below)
{
    uint64_t z = seed += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return (z ^ z >> 31) % below;
}

static void read_input(const char *path, const char *name, input *to)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    to->count = fread(to->bytes, 1, sizeof to->bytes, file);
    assert_true(feof(file));
    (void)fclose(file);
    (void)snprintf(to->name, sizeof to->name, "%s", name);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const input *)a)->name, ((const input *)b)->name);
}

/* In the order of the names, so that a seed chooses the same everywhere. */
static corpus *read_corpus(const char *target)
{
    char directory[64], path[512];
    corpus *all = calloc(1, sizeof *all);
    assert_non_null(all);
    (void)snprintf(directory, sizeof directory, "tests/fuzz/corpus/%s", target);
    DIR *stream = opendir(directory);
    assert_non_null(stream);
    const struct dirent *entry;
    while ((entry = readdir(stream)) != NULL) {
        if (entry->d_name[0] == '.')
            continue;
        assert_true(all->count < INPUTS_MAX);
        (void)snprintf(path, sizeof path, "%s/%s", directory, entry->d_name);
        read_input(path, entry->d_name, &all->inputs[all->count++]);
    }
    (void)closedir(stream);
    assert_true(all->count > 0);
    qsort(all->inputs, (size_t)all->count, sizeof all->inputs[0], by_name);
    return all;
}

/* Bytes that mean something to one format or another. */
static void overwrite(input *it)
{
    static const char *const texts[] = {
        "nan", "inf", "-1", "1e39",  "4294967295", "0x7ffff", " ",
        ",",   "\n",  "--", "1e-46", "9999999999", "IEND",    "\xff\xff\xff\xff"};
    const char *text = texts[draw(sizeof texts / sizeof texts[0])];
    const size_t length = strlen(text);
    const size_t at = (size_t)draw(it->count + 1);
    if (at + length <= sizeof it->bytes) {
        memcpy(it->bytes + at, text, length);
        it->count = at + length > it->count ? at + length : it->count;
    }
}

/* Takes some bytes out, or doubles them. */
static void shift(input *it)
{
    const size_t at = (size_t)draw(it->count);
    const size_t length = 1 + (size_t)draw(it->count - at < 32 ? it->count - at : 32);
    const size_t behind = it->count - at - length;
    if (draw(2) == 0) {
        memmove(it->bytes + at, it->bytes + at + length, behind);
        it->count -= length;
    } else if (it->count + length <= sizeof it->bytes) {
        memmove(it->bytes + at + length, it->bytes + at, behind + length);
        it->count += length;
    }
}

static void mutate(input *it)
{
    for (uint64_t changes = 1 + draw(6); changes > 0; changes--) {
        const uint64_t kind = draw(it->count > 0 ? 5 : 1);
        if (kind == 0)
            overwrite(it);
        else if (kind == 1)
            shift(it);
        else if (kind == 2)
            it->bytes[draw(it->count)] = (uint8_t)draw(256);
        else if (kind == 3)
            it->bytes[draw(it->count)] ^= (uint8_t)(1u << draw(8));
        else if (draw(8) == 0)
            it->count = (size_t)draw(it->count + 1);
    }
}

/* Exact room, so that a sanitizer sees a read behind the end. */
static void try_input(fuzz_target *target, const input *it)
{
    uint8_t *bytes = malloc(it->count > 0 ? it->count : 1);
    assert_non_null(bytes);
    memcpy(bytes, it->bytes, it->count);
    (void)target(bytes, it->count);
    free(bytes);
}

static void try_target(const char *name, fuzz_target *target, int mutations)
{
    corpus *kept = read_corpus(name);
    for (int i = 0; i < kept->count; i++) {
        print_message("%s\n", kept->inputs[i].name);
        try_input(target, &kept->inputs[i]);
    }
    seed = seed_of_this_run();
    for (int i = 0; i < mutations; i++) {
        input it = kept->inputs[draw((uint64_t)kept->count)];
        mutate(&it);
        try_input(target, &it);
    }
    print_message("%s: %d kept inputs, %d mutations\n", name, kept->count, mutations);
    free(kept);
}

static void meshes(void **state)
{
    (void)state;
    try_target("mesh", fuzz_mesh, 100);
}

static void scenes(void **state)
{
    (void)state;
    try_target("scene", fuzz_scene, 3000);
}

static void points(void **state)
{
    (void)state;
    try_target("eval", fuzz_eval, 3000);
}

static void divisions(void **state)
{
    (void)state;
    try_target("divide", fuzz_divide, 3000);
}

static void render_options(void **state)
{
    (void)state;
    try_target("render", fuzz_render, 3000);
}

static void pictures(void **state)
{
    (void)state;
    try_target("png", fuzz_png, 1000);
}

static void packets(void **state)
{
    (void)state;
    try_target("packet", fuzz_packet, 3000);
}

/* libFuzzer would take these for no limit. */
static void no_time_to_fuzz_is_refused(void **state)
{
    (void)state;
    static const char *const seconds[] = {"0", "", "-1", "5s", "00"};
    for (size_t i = 0; i < sizeof seconds / sizeof seconds[0]; i++) {
        char command[128];
        (void)snprintf(command, sizeof command,
                       "tests/fuzz/run.sh /nonexistent '%s' png 2>&1 | grep -q SECONDS",
                       seconds[i]);
        assert_int_equal(system(command), 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(meshes),         cmocka_unit_test(scenes),
        cmocka_unit_test(points),         cmocka_unit_test(divisions),
        cmocka_unit_test(render_options), cmocka_unit_test(pictures),
        cmocka_unit_test(packets),        cmocka_unit_test(no_time_to_fuzz_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
