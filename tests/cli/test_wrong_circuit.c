/* What the command does when C and Verilog differ: $GLINT_BUILD/wrong/truncating has the Verilog of
 * tests/lockstep/wrong/truncating, whose multipliers 13, 14, 15 cut off where the C model rounds.
 */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "file/json.h"

#include "../child.h"
#include "../wave/vcd.h"
#include "image/image.h"
#include "run.h"

static char wrong[1024]; /* the directory */

static int choose_wrong_verilog(void **state)
{
    const char *build = getenv("GLINT_BUILD");
    (void)snprintf(wrong, sizeof wrong, "%s/wrong/truncating", build != NULL ? build : "build");
    return scratch_make(state);
}

static outcome run_wrong(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* With the wrong Verilog. */
static outcome run_wrong(const char *format, ...)
{
    char line[4096];
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    assert_true(length > 0 && (size_t)length < sizeof line);
    (void)snprintf(line + length, sizeof line - (size_t)length, " --rtl %s", wrong);
    return run(line, "");
}

static glint_image *read_picture(const char *path)
{
    glint_error err;
    glint_image *image;
    if (glint_image_read_png(path, &image, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    return image;
}

static void a_frame_that_differs_is_a_failure(void **state)
{
    (void)state;
    char command_line[2048];
    glint_error err;
    glint_image_difference difference;
    outcome done = run_wrong("render --model sphere --size 64x48 --lanes 1 --backend both --out %s",
                             scratch_path("frame.png"));
    assert_int_equal(done.status, 1);
    glint_image *rtl = read_picture(scratch_path("frame.png"));
    glint_image *c = read_picture(scratch_path("frame-c.png"));
    glint_image *picture = read_picture(scratch_path("frame-diff.png"));
    assert_int_equal(glint_image_compare(c, rtl, &difference, &err), GLINT_OK);
    assert_true(difference.differing_pixels > 0);
    assert_int_equal(difference.largest, 1); /* cut off instead of rounded */
    (void)snprintf(command_line, sizeof command_line, "%" PRIu64 " differing pixels of %d",
                   difference.differing_pixels, 64 * 48);
    assert_says(done.out, command_line);
    glint_image_destroy(rtl);
    glint_image_destroy(c);
    glint_image_destroy(picture);
    forget(&done);
}

/* The words behind "NAME: " up to the end of the line; false when there is no such line. */
static bool find_line(const char *text, const char *name, char *line, size_t size)
{
    const char *at = strstr(text, name);
    if (at == NULL)
        return false;
    at += strlen(name);
    at += strspn(at, " ");
    (void)snprintf(line, size, "%.*s", (int)strcspn(at, "\n"), at);
    return true;
}

/* The beginning of a line with a command: of the program as it was called. */
static const char *own_line(const char *name, const char *command)
{
    static char line[1024];
    (void)snprintf(line, sizeof line, "\n%s%s %s", name, glint_under_test(), command);
    return line;
}

static void assert_packet(const char *directory, int files)
{
    char path[256];
    int found = -2; /* "." and ".." */
    DIR *listing = opendir(scratch_path(directory));
    assert_non_null(listing);
    while (readdir(listing) != NULL)
        found++;
    closedir(listing);
    assert_int_equal(found, files);
    (void)snprintf(path, sizeof path, "%s/wave.vcd", directory);
    vcd wave = vcd_read(scratch_path(path));
    assert_true(wave.signal_count > 0);
    vcd_free(&wave);
    (void)snprintf(path, sizeof path, "%s/wave.gtkw", directory);
    assert_int_equal(access(scratch_path(path), R_OK), 0);
}

/* The command that a report prints, without the name of the program, finds the same mismatch
 * first; the right circuit does not have it. Returns its first line. */
static void assert_replayed(const char *said, char *first, size_t size)
{
    char replay[1024];
    char again[1024];
    char command_line[2048];
    assert_true(find_line(said, "\n  clock ", first, size));
    assert_true(find_line(said, own_line("replay: ", ""), replay, sizeof replay));
    outcome replayed = run(replay, "");
    assert_outcome(&replayed, 1, "");
    assert_says(replayed.out, ": the same mismatch; ");
    assert_true(find_line(replayed.out, "\n  clock ", again, sizeof again));
    assert_string_equal(again, first);
    forget(&replayed);

    (void)snprintf(command_line, sizeof command_line, "%s --json --out %s", replay,
                   scratch_path("fresh/packet"));
    replayed = run(command_line, "");
    assert_outcome(&replayed, 1, "");
    json_t *json = json_loads(replayed.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_true(json_is_true(json_object_get(json, "mismatch")));
    assert_true(json_is_true(json_object_get(json, "same")));
    json_decref(json);
    forget(&replayed);
    assert_packet("fresh/packet", 4);

    char *directory = strstr(replay, " --rtl ");
    assert_non_null(directory);
    (void)snprintf(command_line, sizeof command_line, "%.*s --rtl rtl", (int)(directory - replay),
                   replay);
    replayed = run(command_line, "");
    assert_outcome(&replayed, 0, "");
    assert_says(replayed.out, ": gone: the C model and the Verilog agree; ");
    forget(&replayed);
}

static void a_mismatch_of_a_random_run_leaves_a_packet(void **state)
{
    (void)state;
    char first[1024];
    outcome done = run_wrong("verify --circuit specular --clocks 3000 --seed 5 --out %s",
                             scratch_path("failure"));
    assert_int_equal(done.status, 1);
    assert_says(done.out, " mismatches of ");
    assert_packet("failure/specular_cosine_pipelined_1", 4);
    assert_replayed(done.out, first, sizeof first);
    assert_true(strstr(first, "block 13") != NULL || strstr(first, "block 14") != NULL ||
                strstr(first, "block 15") != NULL);
    /* The file says what was printed. */
    char *report =
        scratch_read(scratch_path("failure/specular_cosine_pipelined_1/report.txt"), NULL);
    assert_int_equal(strncmp(done.out, "first verdict: ", strlen("first verdict: ")), 0);
    assert_int_equal(strncmp(strchr(done.out, '\n') + 1, report, strlen(report)), 0);
    free(report);
    forget(&done);
}

static void a_mismatch_of_the_exhaustive_run_leaves_a_packet(void **state)
{
    (void)state;
    char first[1024];
    char whole[2048];
    outcome done =
        run_wrong("verify --exhaustive --lanes 1 --shard 61/1024 --stride 97 --seed 4 --out %s",
                  scratch_path("failure"));
    assert_int_equal(done.status, 1);
    assert_says(done.out, ": a mismatch (exhaustive)\n");
    (void)snprintf(whole, sizeof whole,
                   "verify --exhaustive --gate cosine --pipeline pipelined --lanes 1 --shard "
                   "61/1024 --stride 97 --seed 4 --rtl %s\n",
                   wrong);
    assert_says(done.out, own_line("whole:  ", whole));
    assert_packet("failure/specular_cosine_pipelined_1_exhaustive", 4);
    assert_replayed(done.out, first, sizeof first);
    assert_non_null(strstr(first, "mul1"));
    forget(&done);
}

/* A square of the frame about the pixel, each pixel as 4 × 4. */
static void assert_crop(const char *crop_path, const char *frame_path, int x, int y)
{
    glint_image *crop = read_picture(scratch_path(crop_path));
    glint_image *frame = read_picture(scratch_path(frame_path));
    const int top = y < 32 ? 0 : y > frame->height - 32 ? frame->height - 64 : y - 32;
    const int left = x < 32 ? 0 : x > frame->width - 32 ? frame->width - 64 : x - 32;
    assert_int_equal(crop->width, 256);
    assert_int_equal(crop->height, 256);
    for (int row = 0; row < 256; row++) {
        for (int column = 0; column < 256; column++) {
            assert_memory_equal(
                &crop->rgb[3 * (row * 256 + column)],
                &frame->rgb[3 * ((top + row / 4) * frame->width + left + column / 4)], 3);
        }
    }
    glint_image_destroy(crop);
    glint_image_destroy(frame);
}

static void a_frame_that_differs_leaves_a_packet(void **state)
{
    (void)state;
    char first[1024];
    int x, y;
    unsigned c[3], rtl[3];
    outcome done = run_wrong("render --model sphere --size 96x80 --lanes 1 --backend both --out %s",
                             scratch_path("whole.png"));
    assert_int_equal(done.status, 1);
    assert_packet("whole-failure", 7);
    const char *at = strstr(done.out, "frame of 96x80, first at ");
    assert_non_null(at);
    assert_int_equal(sscanf(at, "frame of 96x80, first at x=%d y=%d: model %u,%u,%u, rtl %u,%u,%u",
                            &x, &y, &c[0], &c[1], &c[2], &rtl[0], &rtl[1], &rtl[2]),
                     8);
    assert_says(done.out, "\ntriangle ");
    assert_says(done.out, "the highlight there: n 80, cosine 0x");
    assert_says(done.out, own_line("whole:  ", "render --model sphere --size 96x80"));
    glint_image *frame = read_picture(scratch_path("whole-c.png"));
    for (int i = 0; i < 3; i++)
        assert_int_equal(frame->rgb[3 * (y * 96 + x) + i], c[i]);
    glint_image_destroy(frame);
    assert_crop("whole-failure/model.png", "whole-c.png", x, y);
    assert_crop("whole-failure/rtl.png", "whole.png", x, y);
    assert_replayed(done.out, first, sizeof first);
    assert_non_null(strstr(first, "mul1"));
    forget(&done);
}

/* Flat and Gouraud's shading ask the circuit at other places than pixels. */
static void other_shadings_leave_packets_too(void **state)
{
    (void)state;
    static const char *const shadings[] = {"flat", "gouraud", "gouraud-perspective"};
    for (size_t i = 0; i < 3; i++) {
        char first[1024];
        outcome done =
            run_wrong("render --model sphere --shading %s --size 96x80 --lanes 1 --backend both "
                      "--out %s",
                      shadings[i], scratch_path("other.png"));
        assert_int_equal(done.status, 1);
        assert_says(done.out, "\ntriangle ");
        assert_null(strstr(done.out, "the highlight there"));
        assert_packet("other-failure", 7);
        assert_replayed(done.out, first, sizeof first);
        forget(&done);
    }
}

/* It would lose its pictures. */
static void a_packet_does_not_replace_itself(void **state)
{
    (void)state;
    char command_line[2048];
    outcome done = run_wrong("render --model sphere --size 96x80 --lanes 1 --backend both --out %s",
                             scratch_path("kept.png"));
    assert_int_equal(done.status, 1);
    forget(&done);
    (void)snprintf(command_line, sizeof command_line, "replay %s/ --out %s",
                   scratch_path("kept-failure"), scratch_path("./kept-failure"));
    done = run(command_line, "");
    assert_int_equal(done.status, 2);
    assert_says(done.err, "kept-failure is the packet itself");
    forget(&done);
    assert_packet("kept-failure", 7);
}

/* What has no packet is not named as one. */
static void a_frame_without_a_packet_names_none(void **state)
{
    (void)state;
    scratch_write(scratch_path("bare-failure"), "", 0);
    outcome done = run_wrong("render --model sphere --size 96x80 --lanes 1 --backend both --out %s",
                             scratch_path("bare.png"));
    assert_int_equal(done.status, 1);
    assert_says(done.err, "bare-diff.png\n");
    forget(&done);
}

/* What a command that ends with status 1 prints; to be freed. */
static char *run_in_shell(const char *command_line)
{
    const char *const argv[] = {"sh", "-c", command_line, NULL};
    assert_int_equal(child_run(argv, 60.0), 1);
    return scratch_read(scratch_path("child.out"), NULL);
}

/* The replay command works when pasted into a shell: the program as it was called, with quotes
 * where needed. */
static void the_replay_command_can_be_pasted(void **state)
{
    (void)state;
    char command_line[4096];
    char replay[2048];
    (void)snprintf(command_line, sizeof command_line,
                   "%s verify --circuit specular --clocks 3000 --seed 5 --rtl %s --out \"%s\"",
                   glint_under_test(), wrong, scratch_path("it's a \\$HOME packet"));
    char *said = run_in_shell(command_line);
    assert_true(find_line(said, "\nreplay: ", replay, sizeof replay));
    free(said);
    said = run_in_shell(replay);
    assert_says(said, ": the same mismatch; ");
    free(said);
}

/* A directory without the circuit's Verilog is rejected, naming it and the missing file. */
static void a_circuit_that_is_not_there_is_told(void **state)
{
    (void)state;
    static const char *const lines[] = {"eval --backend rtl --rtl %s",
                                        "verify --rtl %s",
                                        "render --backend both --out a.png --rtl %s",
                                        "wave --rtl %s",
                                        "bench --rtl %s",
                                        "study --b rtl --out a --rtl %s"};
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        char line[2048];
        const char *rest = strstr(lines[i], "%s");
        (void)snprintf(line, sizeof line, "%.*s%s", (int)(rest - lines[i]), lines[i],
                       scratch_directory);
        outcome done = run(line, "");
        assert_int_equal(done.status, 2);
        assert_says(done.err, scratch_directory);
        assert_says(done.err, "has no specular_device.v");
        forget(&done);
    }
    outcome done = run("verify --rtl nowhere", "");
    assert_outcome(&done, 2, "glint verify: --rtl: nowhere: No such file or directory\n");
    forget(&done);
    done = run("verify --rtl Makefile", "");
    assert_outcome(&done, 2, "glint verify: --rtl: Makefile is not a directory\n");
    forget(&done);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_frame_that_differs_is_a_failure),
        cmocka_unit_test(a_mismatch_of_a_random_run_leaves_a_packet),
        cmocka_unit_test(a_mismatch_of_the_exhaustive_run_leaves_a_packet),
        cmocka_unit_test(a_frame_that_differs_leaves_a_packet),
        cmocka_unit_test(other_shadings_leave_packets_too),
        cmocka_unit_test(a_packet_does_not_replace_itself),
        cmocka_unit_test(a_frame_without_a_packet_names_none),
        cmocka_unit_test(the_replay_command_can_be_pasted),
        cmocka_unit_test(a_circuit_that_is_not_there_is_told),
    };
    return cmocka_run_group_tests(tests, choose_wrong_verilog, scratch_remove);
}
