/* Bad meshes, pictures, lines and packets from outside, each given to the command as a user would:
 * refused with one line that names it, or drawn; and nothing is left in the output's place. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "abuse.h"

/* ---- Meshes -------------------------------------------------------------------------------------
 */

/* EITHER: assimp may make something of it, in its way. */
enum { EITHER = -1, DRAWN = 0, REFUSED = 2 };

typedef struct mesh_case {
    const char *name, *text;
    int expected;
} mesh_case;

#define OBJ(third)     "v 0 0 0\nv 1 0 0\nv " third "\nv 1 1 0\nf 1 2 3\nf 2 4 3\n"
#define OBJ_FACE(face) "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf " face "\n"
#define PLY(count, third, faces, face)                                                             \
    "ply\nformat ascii 1.0\nelement vertex " count "\nproperty float x\nproperty float y\n"        \
    "property float z\nelement face " faces "\nproperty list uchar int vertex_index\n"             \
    "end_header\n0 0 0\n1 0 0\n" third "\n" face "\n"
#define STL(third)                                                                                 \
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex " third           \
    "\nendloop\nendfacet\nendsolid a\n"
#define OFF(counts, face) "OFF\n" counts " 0\n0 0 0\n1 0 0\n0 1 0\n" face "\n"

static const mesh_case meshes[] = {
    {"nan.obj", OBJ("nan 1 0"), REFUSED},
    {"inf.obj", OBJ("0 inf 0"), REFUSED},
    {"minus_inf.obj", OBJ("0 -inf 0"), REFUSED},
    {"1e38.obj", OBJ("0 1e38 0"), REFUSED},
    {"1e39.obj", OBJ("0 1e39 0"), REFUSED},
    {"1e308.obj", OBJ("0 1e308 0"), REFUSED},
    {"1e999.obj", OBJ("0 1e999 0"), REFUSED},
    {"1.1e18.obj", OBJ("0 1.1e18 0"), REFUSED},
    {"1e18.obj", OBJ("0 9e17 0"), DRAWN},
    {"all_huge.obj", "v 0 0 0\nv 9e17 0 0\nv 0 9e17 0\nv 9e17 9e17 0\nf 1 2 3\nf 2 4 3\n", DRAWN},
    {"denormal.obj", "v 0 0 0\nv 1e-40 0 0\nv 0 1e-40 0\nf 1 2 3\n", DRAWN},
    {"tiny.obj", "v 0 0 0\nv 1e-5 0 0\nv 0 1e-5 0\nf 1 2 3\n", DRAWN},
    {"nothing.obj", "v 0 0 0\nv 1e-50 0 0\nv 0 1e-50 0\nf 1 2 3\n", REFUSED},
    {"coarse.obj", "v 0 0 0\nv 5e-45 0 0\nv 0 5e-45 0\nf 1 2 3\n", REFUSED},
    {"minus_zero.obj", OBJ("-0 1 -0"), DRAWN},
    {"far_away.obj", "v 1e9 1e9 1e9\nv 1000001000 1e9 1e9\nv 1e9 1000001000 1e9\nf 1 2 3\n",
     REFUSED},
    {"zero_area.obj", OBJ_FACE("1 1 2"), DRAWN},
    {"line_area.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n", DRAWN},
    {"only_zero_area.obj", "v 0 0 0\nv 1 0 0\nf 1 2 2\nf 1 1 1\n", REFUSED},
    {"one_point.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", REFUSED},
    {"index_beyond.obj", OBJ_FACE("1 2 5"), REFUSED},
    {"index_zero.obj", OBJ_FACE("0 1 2"), REFUSED},
    {"index_negative.obj", OBJ_FACE("-1 -2 -3"), DRAWN},
    {"index_too_negative.obj", OBJ_FACE("-1 -2 -9"), REFUSED},
    {"index_huge.obj", OBJ_FACE("1 2 4294967297"), REFUSED},
    {"index_text.obj", OBJ_FACE("a b c"), REFUSED},
    {"no_faces.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", REFUSED},
    {"no_vertices.obj", "f 1 2 3\nf 1 2 3\nf 1 2 3\n", REFUSED},
    {"empty.obj", "", REFUSED},
    {"blank.obj", "\n\n\n\n\n\n\n\n\n\n\n\n\n\n", REFUSED},
    {"text.obj", "good morning, this is no mesh\n", REFUSED},
    {"no_format.xyz", "good morning, this is no mesh\n", REFUSED},
    {"no_ending", "good morning, this is no mesh\n", REFUSED},
    {"nan.ply", PLY("3", "0 nan 0", "1", "3 0 1 2"), REFUSED},
    {"inf.ply", PLY("3", "0 inf 0", "1", "3 0 1 2"), REFUSED},
    {"1e38.ply", PLY("3", "0 1e38 0", "1", "3 0 1 2"), REFUSED},
    {"index_beyond.ply", PLY("3", "0 1 0", "1", "3 0 1 3"), REFUSED},
    {"index_negative.ply", PLY("3", "0 1 0", "1", "3 0 1 -1"), REFUSED},
    {"more_vertices.ply", PLY("4", "0 1 0", "1", "3 0 1 2"), EITHER},
    {"fewer_vertices.ply", PLY("2", "0 1 0", "1", "3 0 1 2"), EITHER},
    {"no_faces.ply", PLY("3", "0 1 0", "0", ""), REFUSED},
    {"2_32_vertices.ply", PLY("4294967295", "0 1 0", "1", "3 0 1 2"), REFUSED},
    {"2_32_faces.ply", PLY("3", "0 1 0", "4294967295", "3 0 1 2"), REFUSED},
    {"pipe_beside.obj", "mtllib pipe.obj\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n", DRAWN},
    {"device_beside.obj", "mtllib /dev/zero\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n",
     DRAWN},
    {"endless.smd", "version 1\nnodes\n", REFUSED},
    {"cut_header.ply", "ply\nformat ascii 1", REFUSED},
    {"cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n", REFUSED},
    {"good.stl", STL("0 1 0"), DRAWN},
    {"nan.stl", STL("0 nan 0"), REFUSED},
    {"1e39.stl", STL("0 1e39 0"), REFUSED},
    {"zero_area.stl", STL("1 0 0"), REFUSED},
    {"cut.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0", REFUSED},
    {"good.off", OFF("3 1", "3 0 1 2"), DRAWN},
    {"index_beyond.off", OFF("3 1", "3 0 1 7"), REFUSED},
    {"index_beyond.ac",
     "AC3Db\nMATERIAL \"\" rgb 1 1 1 amb 0 0 0 emis 0 0 0 spec 0 0 0 shi 0 trans 0\nOBJECT world\n"
     "kids 1\nOBJECT poly\nnumvert 3\n0 0 0\n1 0 0\n0 1 0\nnumsurf 1\nSURF 0x0\nmat 0\nrefs 3\n"
     "0 0 0\n1 0 0\n9 0 0\nkids 0\n",
     REFUSED},
    {"2_32.off", OFF("4294967295 4294967295", "3 0 1 2"), REFUSED},
    {"index_beyond.ase",
     "*3DSMAX_ASCIIEXPORT 200\n*GEOMOBJECT {\n*NODE_NAME \"a\"\n*MESH {\n*MESH_NUMVERTEX 3\n"
     "*MESH_NUMFACES 1\n*MESH_VERTEX_LIST {\n*MESH_VERTEX 0 0 0 0\n*MESH_VERTEX 1 1 0 0\n"
     "*MESH_VERTEX 2 0 1 0\n}\n*MESH_FACE_LIST {\n*MESH_FACE 0: A: 0 B: 1 C: 999999999 AB: 1\n}\n"
     "}\n}\n",
     REFUSED},
};

/* A path that stays valid. */
static void keep(char copy[1024], const char *path)
{
    assert_true(strlen(path) < 1024);
    strcpy(copy, path);
}

/* The picture is there when it was drawn, and nothing is when it was not. */
static void try_mesh(const char *name, int expected)
{
    const abuse plainly = {0};
    char line[4096], path[1024], out[1024];
    keep(path, name);
    keep(out, scratch_path("out/a.png"));
    (void)snprintf(line, sizeof line, "render --model %s --size 64x48 --out %s", path, out);
    outcome done = abuse_run("mesh files", line, &plainly);
    abuse_expect_sane(&done, line);
    if (expected == EITHER)
        expected = done.status;
    if (done.status != expected)
        fail_msg("%s: exit status %d, expected %d: %s", path, done.status, expected, done.err);
    assert_int_equal(abuse_expect_whole(scratch_path("out"), false), expected == DRAWN ? 1 : 0);
    if (expected == REFUSED && strstr(done.err, path) == NULL)
        fail_msg("\"%s\" does not name %s", done.err, path);
    (void)unlink(out);
    abuse_forget(&done);
}

static void bad_meshes(void **state)
{
    (void)state;
    assert_int_equal(mkdir(scratch_path("out"), 0777), 0);
    assert_int_equal(mkfifo(scratch_path("pipe.obj"), 0666), 0);
    for (size_t i = 0; i < sizeof meshes / sizeof meshes[0]; i++) {
        const char *path = scratch_path(meshes[i].name);
        scratch_write(path, meshes[i].text, strlen(meshes[i].text));
        try_mesh(path, meshes[i].expected);
    }
    abuse_all_tried();
}

/* A triangle whose corners are vertices 0, 1 and 65535 of three. */
static const uint8_t index_beyond_3ds[] =
    "MM\x56\0\0\0\x3d\x3d\x50\0\0\0\0\x40\x4a\0\0\0a\0\0\x41\x42\0\0\0\x10\x41\x2c\0\0\0\3\0"
    "\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\x20\x41\x10\0"
    "\0\0\1\0\0\0\1\0\xff\xff\7";

/* Counts of 2^32 - 1, and of what fits no memory, in binary headers. */
static void bad_binary_meshes(void **state)
{
    (void)state;
    static const uint8_t counts[][4] = {
        {0xff, 0xff, 0xff, 0xff}, {0xff, 0xff, 0xff, 0x7f}, {0, 0, 0, 0}, {2, 0, 0, 0}};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        uint8_t stl[134] = {0};
        memcpy(stl + 80, counts[i], 4);
        scratch_write(scratch_path("count.stl"), stl, sizeof stl);
        try_mesh(scratch_path("count.stl"), REFUSED);
        uint8_t three_ds[16] = {0x4d, 0x4d};
        memcpy(three_ds + 2, counts[i], 4);
        scratch_write(scratch_path("length.3ds"), three_ds, sizeof three_ds);
        try_mesh(scratch_path("length.3ds"), REFUSED);
    }
    scratch_write(scratch_path("index_beyond.3ds"), index_beyond_3ds, sizeof index_beyond_3ds);
    try_mesh(scratch_path("index_beyond.3ds"), REFUSED);
    uint8_t zeros[4096] = {0};
    static const char *const names[] = {"zeros.obj", "zeros.ply", "zeros.stl", "zeros.3ds",
                                        "zeros.fbx", "zeros.dae", "zeros.gltf"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        scratch_write(scratch_path(names[i]), zeros, sizeof zeros);
        try_mesh(scratch_path(names[i]), REFUSED);
    }
    abuse_all_tried();
}

static void what_is_no_mesh_file(void **state)
{
    (void)state;
    char longest[300];
    memset(longest, 'x', sizeof longest - 1);
    longest[sizeof longest - 1] = '\0';
    assert_int_equal(mkdir(scratch_path("directory.obj"), 0777), 0);
    assert_int_equal(symlink("loop.obj", scratch_path("loop.obj")), 0);
    assert_int_equal(symlink("nowhere", scratch_path("dangling.obj")), 0);
    const char *const paths[] = {"/dev/null", "/dev/zero", "/proc/self/mem", "/", longest};
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++)
        try_mesh(paths[i], REFUSED);
    static const char *const names[] = {"pipe.obj", "directory.obj", "loop.obj", "dangling.obj",
                                        "missing.obj"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        try_mesh(scratch_path(names[i]), REFUSED);
    abuse_all_tried();
}

/* ---- Pictures -----------------------------------------------------------------------------------
 */

static void compare_with(const char *path, int status, const char *part)
{
    const abuse plainly = {0};
    char line[2048];
    (void)snprintf(line, sizeof line, "compare %s tests/fuzz/corpus/png/rgba.png --diff %s", path,
                   scratch_path("out/d.png"));
    outcome done = abuse_run("pictures", line, &plainly);
    if (status != 0)
        abuse_expect_failure(&done, line, status, part);
    assert_int_equal(done.status, status);
    (void)abuse_expect_whole(scratch_path("out"), false);
    (void)unlink(scratch_path("out/d.png"));
    abuse_forget(&done);
}

/* 16384x16384 is allowed: what is refused is the end of the file, before the memory is used. */
static void bad_pictures(void **state)
{
    (void)state;
    static const char *const kept[] = {"cut", "crc", "wide", "huge", "palette", "rgb16", "bit"};
    char path[256];
    for (size_t i = 0; i < sizeof kept / sizeof kept[0]; i++) {
        (void)snprintf(path, sizeof path, "tests/fuzz/corpus/png/%s.png", kept[i]);
        compare_with(path, 2, ""); /* unreadable, or of another size */
    }
    compare_with("tests/fuzz/corpus/png/rgba.png", 0, "");
    compare_with(scratch_path("missing.png"), 2, "No such file or directory");
    compare_with(scratch_path("out"), 2, "Is a directory");
    compare_with("/dev/null", 2, "the file ends early");
    compare_with("/dev/zero", 2, "Not a PNG file");
    compare_with("README.md", 2, "Not a PNG file");
    size_t count;
    char *whole = scratch_read("tests/fuzz/corpus/png/rgba.png", &count);
    char bad[1024];
    keep(bad, scratch_path("bad.png"));
    for (size_t kept_bytes = 0; kept_bytes < count; kept_bytes += 7) {
        scratch_write(bad, whole, kept_bytes);
        compare_with(bad, 2, "bad.png");
    }
    for (size_t at = 0; at < count; at += 5) {
        whole[at] = (char)(whole[at] ^ 0x40);
        scratch_write(bad, whole, count);
        compare_with(bad, 2, "bad.png");
        whole[at] = (char)(whole[at] ^ 0x40);
    }
    static const uint8_t large[] = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x40\0\0\0\x40\0\x08\0\0\0\0";
    scratch_write(bad, large, sizeof large - 1);
    compare_with(bad, 2, "bad.png");
    free(whole);
    abuse_all_tried();
}

/* ---- Lines --------------------------------------------------------------------------------------
 */

typedef struct line_case {
    const char *text;
    size_t count; /* 0: as long as the text */
} line_case;

static void bad_lines(void **state)
{
    (void)state;
    static const line_case lines[] = {
        {"nan 1 1 1 1\n", 0},
        {"1 nan 1 1 1\n", 0},
        {"1 inf 1 1 1\n", 0},
        {"1 1e400 1 1 1\n", 0},
        {"1 0x1p3 1 1 1\n", 0},
        {"1 1 1 1\n", 0},
        {"1 1 1 1 1 1\n", 0},
        {"1,,1 1 1\n", 0},
        {"1 1 1 1 1,\n", 0},
        {"-1 1 1 1 1\n", 0},
        {"1024 1 1 1 1\n", 0},
        {"1 1.1 1 1 1\n", 0},
        {"1 1 256 1 1\n", 0},
        {"1 0x80000 1 1 1\n", 0},
        {"1 1 1 1 99999999999999999999\n", 0},
        {"\0", 1},
        {"1 1 1\0 1 1\n", 12},
        {"\xff\xfe\n", 0},
        {"\x1b[2J\n", 0},
        {"1 1 1 1 1\r1 1 1 1 1\n", 0},
        {"1 1 1 1 1\n\0\n", 12},
        {"%s%n%n%n%n\n", 0},
    };
    static const char *const commands[] = {"eval", "eval --backend rtl --json", "divide",
                                           "divide --backend rtl --json"};
    char lines_path[1024];
    keep(lines_path, scratch_path("lines"));
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        const size_t count = lines[i].count != 0 ? lines[i].count : strlen(lines[i].text);
        scratch_write(lines_path, lines[i].text, count);
        const abuse input = {.in = lines_path};
        for (size_t k = 0; k < sizeof commands / sizeof commands[0]; k++) {
            outcome done = abuse_run("lines of eval and divide", commands[k], &input);
            abuse_expect_failure(&done, commands[k], 2, "line ");
            abuse_forget(&done);
        }
    }
    abuse_all_tried();
}

/* A megabyte in one line, a binary file, and what cannot be read at all. */
static void unusual_streams(void **state)
{
    (void)state;
    char *longest = malloc(1 << 20);
    assert_non_null(longest);
    memset(longest, '1', 1 << 20);
    scratch_write(scratch_path("long"), longest, 1 << 20);
    free(longest);
    const char *program = getenv("GLINT");
    static const char *const commands[] = {"eval", "divide"};
    for (size_t i = 0; i < 2; i++) {
        const abuse inputs[] = {{.in = scratch_path("long")},
                                {.in = program != NULL ? program : "build/glint"},
                                {.in = scratch_path("")},
                                {.close_in = true},
                                {.in = "/dev/zero"}};
        static const struct {
            int status;
            const char *part;
        } expected[] = {{2, "line 1: "},
                        {2, "line 1: "},
                        {2, "cannot read standard input: Is a directory"},
                        {2, "cannot read standard input: Bad file descriptor"},
                        {2, "line 1: longer than 16 MB"}};
        for (size_t k = 0; k < sizeof inputs / sizeof inputs[0]; k++) {
            outcome done = abuse_run("lines of eval and divide", commands[i], &inputs[k]);
            abuse_expect_failure(&done, commands[i], expected[k].status, expected[k].part);
            abuse_forget(&done);
        }
    }
    abuse_all_tried();
}

/* ---- Packets ------------------------------------------------------------------------------------
 */

static void bad_packets(void **state)
{
    (void)state;
    char line[1200];
    const abuse plainly = {0};
    static const char *const kept[] = {"random", "exhaustive", "frame"};
    char directory[1024], nowhere[1024];
    keep(directory, scratch_path("packet"));
    keep(nowhere, scratch_path("nowhere"));
    assert_int_equal(mkdir(directory, 0777), 0);
    (void)snprintf(line, sizeof line, "replay %s", directory);
    for (size_t i = 0; i < sizeof kept / sizeof kept[0]; i++) {
        char path[256];
        size_t count;
        (void)snprintf(path, sizeof path, "tests/fuzz/corpus/packet/%s", kept[i]);
        char *whole = scratch_read(path, &count);
        for (size_t cut = 0; cut < count - 2; cut += 150) {
            scratch_write(scratch_path("packet/failure.json"), whole, cut);
            outcome done = abuse_run("failure packets", line, &plainly);
            abuse_expect_failure(&done, line, 2, "failure.json");
            abuse_forget(&done);
        }
        free(whole);
    }
    (void)unlink(scratch_path("packet/failure.json"));
    const char *const paths[] = {directory, "/dev/null", "/dev/zero", nowhere, "/"};
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++) {
        (void)snprintf(line, sizeof line, "replay %s", paths[i]);
        outcome done = abuse_run("failure packets", line, &plainly);
        abuse_expect_failure(&done, line, 2, paths[i]);
        abuse_forget(&done);
    }
    abuse_all_tried();
}

enum { TESTS = 7 };

/* The last: all others have been counted. */
static void the_counts_are_documented(void **state)
{
    (void)state;
    abuse_expect_documented(
        "inputs", "bad meshes, pictures, lines and packets are drawn, or refused in one line",
        TESTS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_meshes),
        cmocka_unit_test(bad_binary_meshes),
        cmocka_unit_test(what_is_no_mesh_file),
        cmocka_unit_test(bad_pictures),
        cmocka_unit_test(bad_lines),
        cmocka_unit_test(unusual_streams),
        cmocka_unit_test(bad_packets),
        cmocka_unit_test(the_counts_are_documented),
    };
    _Static_assert(sizeof tests / sizeof tests[0] == TESTS + 1, "the tests before the last");
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
