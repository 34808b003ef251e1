/* `glint study`: the files it writes, that they are the same on every run but for the times, and
 * what it refuses. What the numbers must be is tested elsewhere. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "file/json.h"

#include "../child.h"
#include "image/image.h"
#include "run.h"

static outcome study(const char *directory, const char *options)
{
    char command_line[2048];
    snprintf(command_line, sizeof command_line, "study --out %s --size 120x90 %s",
             scratch_path(directory), options);
    return run(command_line, "");
}

static char *read_from(const char *directory, const char *name, size_t *count)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s", directory, name);
    return scratch_read(scratch_path(path), count);
}

static bool is_there(const char *directory, const char *name)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s", directory, name);
    return access(scratch_path(path), F_OK) == 0;
}

static int lines_of(const char *text)
{
    int count = 0;
    for (; *text != '\0'; text++)
        count += *text == '\n';
    return count;
}

static void the_files_and_the_table(void **state)
{
    (void)state;
    outcome done = study("first", "--model sphere --n 10,200 --frames 2");
    assert_outcome(&done, 0, "");
    assert_says(done.out, "A blinn, B cosine-quadratic");
    assert_says(done.out, "16128 triangles");
    assert_says(done.out, "B/A");
    assert_says(done.out, "substantially different");
    char *csv = read_from("first", "study.csv", NULL);
    assert_int_equal(lines_of(csv), 3);
    assert_says(csv, "n,nmse,psnr_db,");
    assert_says(csv, "\n10,0.00");
    assert_says(csv, "\n200,0.00");
    char *times = read_from("first", "times.csv", NULL);
    assert_int_equal(lines_of(times), 3);
    assert_says(times, "\n200,2,");
    char *text = read_from("first", "study.json", NULL);
    json_t *json = json_loads(text, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    assert_string_equal(json_string_value(json_object_get(json, "b")), "cosine-quadratic");
    const json_t *rows = json_object_get(json, "rows");
    assert_int_equal(json_array_size(rows), 2);
    const json_t *row = json_array_get(rows, 1);
    assert_int_equal(json_integer_value(json_object_get(row, "n")), 200);
    assert_true(json_integer_value(json_object_get(row, "highlit_a")) > 10);
    assert_null(json_object_get(json, "times"));
    glint_image *sheet = NULL;
    assert_int_equal(glint_image_read_png(scratch_path("first/sheet.png"), &sheet, NULL), GLINT_OK);
    assert_true(sheet->width > 360 && sheet->height > 180);
    glint_image_destroy(sheet);
    assert_true(is_there("first", "n-0010.png") && is_there("first", "n-0200.png"));
    json_decref(json);
    free(text);
    free(times);
    free(csv);
    forget(&done);
}

static void every_run_writes_the_same_but_for_times(void **state)
{
    (void)state;
    static const char *const names[] = {"study.csv", "study.json", "sheet.png", "n-0030.png"};
    outcome one = study("one", "--a rtl --b phong:gouraud --n 30,5 --frames 0 --threads 1");
    outcome two = study("two", "--a rtl --b phong:gouraud --n 30,5 --frames 0 --threads 4");
    assert_outcome(&one, 0, "");
    assert_outcome(&two, 0, "");
    assert_false(is_there("one", "times.csv"));
    assert_null(strstr(one.out, "B/A"));
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        size_t count[2];
        char *a = read_from("one", names[i], &count[0]);
        char *b = read_from("two", names[i], &count[1]);
        assert_int_equal(count[0], count[1]);
        assert_memory_equal(a, b, count[0]);
        free(a);
        free(b);
    }
    forget(&one);
    forget(&two);
}

/* The same frames by `glint render`, compared by `glint compare`. */
static void the_numbers_are_those_of_compare(void **state)
{
    (void)state;
    char command_line[1024];
    outcome done = study("numbers", "--b schlick --n 25 --frames 0 --json --yaw 60");
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    const json_t *row = json_array_get(json_object_get(json, "rows"), 0);
    static const char *const models[] = {"blinn", "schlick"};
    for (int i = 0; i < 2; i++) {
        snprintf(command_line, sizeof command_line,
                 "render --backend real --specular %s --n 25 --yaw 60 --size 120x90 --out %s.png",
                 models[i], scratch_path(models[i]));
        outcome rendered = run(command_line, "");
        assert_outcome(&rendered, 0, "");
        forget(&rendered);
    }
    snprintf(command_line, sizeof command_line, "compare --json %s.png %s.png",
             scratch_path("blinn"), scratch_path("schlick"));
    outcome compared = run(command_line, "");
    assert_outcome(&compared, 1, "");
    json_t *expected = json_loads(compared.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(expected);
    static const char *const names[] = {"nmse", "psnr", "largest", "differing_pixels",
                                        "object_pixels"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        assert_true(json_number_value(json_object_get(row, names[i])) ==
                    json_number_value(json_object_get(expected, names[i])));
    }
    json_decref(expected);
    json_decref(json);
    forget(&compared);
    forget(&done);
}

/* The JSON contains frame times only if frames were timed. */
static void times_are_in_the_json_when_asked_for(void **state)
{
    (void)state;
    outcome done = study("timed", "--b schlick --n 10,25 --frames 1 --json");
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    const json_t *times = json_object_get(json, "times");
    assert_int_equal(json_array_size(times), 2);
    json_decref(json);
    forget(&done);
}

/* Each table identifies its subject: the mesh, its density, the methods. */
static void the_tables_say_what_they_are_of(void **state)
{
    (void)state;
    outcome done = study("named", "--model sphere --density 20 --n 10,20 --frames 1 --json");
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    const json_t *scene = json_object_get(json, "scene");
    assert_string_equal(json_string_value(json_object_get(scene, "model")), "sphere");
    assert_int_equal(json_integer_value(json_object_get(scene, "density")), 20);
    json_decref(json);
    forget(&done);
    static const char *const names[] = {"study.csv", "times.csv"};
    for (int i = 0; i < 2; i++) {
        char *csv = read_from("named", names[i], NULL);
        assert_says(csv, ",a,b,model,density\n");
        assert_says(csv, ",blinn,cosine-quadratic,sphere,20\n20,");
        free(csv);
    }
    done = study("named", "--model sphere --n 10 --frames 0 --b rtl:gouraud");
    assert_says(done.out, "sphere, density 128, 120x90: 16128 triangles");
    forget(&done);
    char *csv = read_from("named", "study.csv", NULL);
    assert_says(csv, ",blinn,rtl:gouraud,sphere,128\n");
    free(csv);
}

/* A path may hold what would end a column; a file has no density. */
static void a_file_is_named_in_quotes_where_it_must_be(void **state)
{
    (void)state;
    static const char triangle[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    char options[1200], expected[1200];
    snprintf(options, sizeof options, "--n 10 --frames 0 --json --model %s",
             scratch_path("one,\"two\".obj"));
    snprintf(expected, sizeof expected, ",blinn,cosine-quadratic,\"%s/one,\"\"two\"\".obj\",\n",
             scratch_directory);
    scratch_write(scratch_path("one,\"two\".obj"), triangle, sizeof triangle - 1);
    outcome done = study("quoted", options);
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    const json_t *scene = json_object_get(json, "scene");
    assert_string_equal(json_string_value(json_object_get(scene, "model")),
                        scratch_path("one,\"two\".obj"));
    assert_true(json_is_null(json_object_get(scene, "density")));
    json_decref(json);
    char *csv = read_from("quoted", "study.csv", NULL);
    assert_says(csv, expected);
    free(csv);
    forget(&done);
}

/* There is no largest difference, and so no pixel that has it. */
static void equal_pictures_have_no_largest_difference(void **state)
{
    (void)state;
    outcome done = study("equal", "--n 10 --frames 0 --ks 0 --kd 0 --ia 0 --json");
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    const json_t *row = json_array_get(json_object_get(json, "rows"), 0);
    assert_int_equal(json_integer_value(json_object_get(row, "largest")), 0);
    assert_true(json_is_null(json_object_get(row, "largest_x")));
    assert_true(json_is_null(json_object_get(row, "largest_y")));
    assert_true(json_is_null(json_object_get(row, "psnr")));
    json_decref(json);
    char *csv = read_from("equal", "study.csv", NULL);
    assert_says(csv, "\n10,0,inf,0,,,0,");
    free(csv);
    forget(&done);
    done = study("equal", "--n 10 --frames 0 --ks 0 --kd 0 --ia 0");
    assert_null(strstr(done.out, "-1,")); /* "-1" alone may be in the name of the directory */
    forget(&done);
}

static const char *const of_a_study[] = {"n-0001.png", "n-0002.png", "sheet.png",
                                         "study.csv",  "study.json", "times.csv"};
enum { OF_A_STUDY = sizeof of_a_study / sizeof of_a_study[0] };

static int entries_of(const char *directory)
{
    int count = -2; /* "." and ".." */
    DIR *opened = opendir(scratch_path(directory));
    assert_non_null(opened);
    while (readdir(opened) != NULL)
        count++;
    closedir(opened);
    return count;
}

/* Files of the directory that the process holds open, the nameless ones too. */
static int open_in(pid_t process, const char *directory)
{
    char path[64];
    int count = 0;
    (void)snprintf(path, sizeof path, "/proc/%d/fd", (int)process);
    DIR *opened = opendir(path);
    const struct dirent *entry;
    while (opened != NULL && (entry = readdir(opened)) != NULL) {
        char target[1024];
        const ssize_t length = readlinkat(dirfd(opened), entry->d_name, target, sizeof target - 1);
        target[length > 0 ? length : 0] = '\0';
        count += strncmp(target, directory, strlen(directory)) == 0;
    }
    if (opened != NULL)
        closedir(opened);
    return count;
}

/* A directory holds one study: the one before, until the next is whole. */
static void an_interrupted_study_leaves_the_one_before(void **state)
{
    (void)state;
    char *before[OF_A_STUDY], out[1024];
    size_t size[OF_A_STUDY];
    snprintf(out, sizeof out, "%s", scratch_path("mixed"));
    outcome done = study("mixed", "--n 1,2 --frames 1");
    assert_outcome(&done, 0, "");
    forget(&done);
    for (int i = 0; i < OF_A_STUDY; i++)
        before[i] = read_from("mixed", of_a_study[i], &size[i]);
    const char *const argv[] = {
        glint_under_test(), "study", "--size", "320x240", "--b",       "schlick", "--n", "1,2,3,4",
        "--frames",         "200",   "--out",  out,       "--threads", "1",       NULL};
    const pid_t child = child_start(argv, scratch_path("child.out"), scratch_path("child.err"));
    const double start = child_seconds();
    while (open_in(child, out) < 2 && !child_has_ended(child) &&
           child_seconds() - start < child_patience)
        child_pause(); /* until a sheet is made, and held */
    assert_true(open_in(child, out) >= 2);
    kill(child, SIGINT);
    assert_int_equal(child_wait(child, 60), 2);
    assert_int_equal(entries_of("mixed"), OF_A_STUDY);
    for (int i = 0; i < OF_A_STUDY; i++) {
        size_t count;
        char *after = read_from("mixed", of_a_study[i], &count);
        assert_int_equal(count, size[i]);
        assert_memory_equal(after, before[i], count);
        free(after);
        free(before[i]);
    }
}

static void a_study_removes_what_the_one_before_left_and_nothing_else(void **state)
{
    (void)state;
    static const char *const kept[] = {"again/notes.txt", "again/n-12.png", "again/n-000a.png",
                                       "again/n-0001.png.txt"};
    outcome done = study("again", "--n 1,2,1000 --frames 1");
    assert_outcome(&done, 0, "");
    forget(&done);
    for (size_t i = 0; i < sizeof kept / sizeof kept[0]; i++)
        scratch_write(scratch_path(kept[i]), "x", 1);
    assert_int_equal(mkdir(scratch_path("again/n-0099.png"), 0777), 0);
    done = study("again", "--n 2,3 --frames 0");
    assert_outcome(&done, 0, "");
    forget(&done);
    for (size_t i = 0; i < sizeof kept / sizeof kept[0]; i++)
        assert_int_equal(access(scratch_path(kept[i]), F_OK), 0);
    assert_true(is_there("again", "n-0099.png") && is_there("again", "n-0002.png") &&
                is_there("again", "n-0003.png"));
    assert_false(is_there("again", "n-0001.png") || is_there("again", "n-1000.png") ||
                 is_there("again", "times.csv"));
    assert_int_equal(entries_of("again"), 4 + 1 + 2 + 3);
}

static void what_cannot_be_studied_is_named(void **state)
{
    (void)state;
    static const struct {
        const char *options;
        int status;
        const char *says;
    } refused[] = {
        {"--n 10,10", 2, "--n: 10 is given twice"},
        {"--n 10,", 2, "--n: a comma in \"10,\" is not followed by an integer from 0 to 1023"},
        {"--n 10,,20", 2, "--n: a comma in \"10,,20\""},
        {"--n ,10", 2, "--n: \"\" is not an integer from 0 to 1023"},
        {"--n 5,1024", 2, "--n: \"1024\" is not an integer from 0 to 1023"},
        {"--a glass", 2, "--a: \"glass\" is not a method"},
        {"--b blinn:smooth", 2, "--b: \"smooth\" is not a shading"},
        {"--f0 0.5", 2, "--f0 is for cook-torrance and torrance-sparrow"},
        {"--b quadratic --n 5,0 --frames 0", 2,
         "model quadratic takes n from 1 to 1023 here, not 0"},
        {"--model /nonexistent.obj", 2, "/nonexistent.obj"},
        {"--model sphere --distance 0.5", 2, "nothing to compare"},
    };
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        outcome done = study("refused", refused[i].options);
        assert_outcome(&done, refused[i].status, NULL);
        assert_says(done.err, "glint study: ");
        assert_says(done.err, refused[i].says);
        assert_int_equal(lines_of(done.err), 1);
        assert_string_equal(done.out, "");
        assert_false(is_there("refused", "study.csv") || is_there("refused", "n-0005.png"));
        forget(&done);
    }
    scratch_write(scratch_path("file"), "x", 1);
    outcome done = study("file", "--frames 0");
    assert_outcome(&done, 2, NULL);
    assert_says(done.err, "glint study: ");
    forget(&done);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_files_and_the_table),
        cmocka_unit_test(every_run_writes_the_same_but_for_times),
        cmocka_unit_test(the_numbers_are_those_of_compare),
        cmocka_unit_test(times_are_in_the_json_when_asked_for),
        cmocka_unit_test(the_tables_say_what_they_are_of),
        cmocka_unit_test(a_file_is_named_in_quotes_where_it_must_be),
        cmocka_unit_test(equal_pictures_have_no_largest_difference),
        cmocka_unit_test(an_interrupted_study_leaves_the_one_before),
        cmocka_unit_test(a_study_removes_what_the_one_before_left_and_nothing_else),
        cmocka_unit_test(what_cannot_be_studied_is_named),
    };
    return cmocka_run_group_tests_name("study", tests, scratch_make, scratch_remove);
}
