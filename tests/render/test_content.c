/* What a mesh file holds, and in how many ways it can be written down: each way that is read gives
 * the same triangles, what is left out is said, and what is refused is refused by its cause. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../scratch.h"
#include "render/mesh.h"

static const char *write_bytes(const char *name, const void *bytes, size_t count)
{
    const char *path = scratch_path(name);
    scratch_write(path, bytes, count);
    return path;
}

static glint_mesh *load(const char *path)
{
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    const glint_status status = glint_mesh_load(path, NULL, &mesh, &err);
    if (status != GLINT_OK)
        fail_msg("refused: %s", err.text);
    return mesh;
}

/* The triangles' corners, each triangle from its least corner on, in the order of the file. */
typedef float triangle[3][3];

static void take_triangle(const glint_mesh *mesh, size_t at, triangle t)
{
    int first = 0;
    const float *corner[3];
    for (int k = 0; k < 3; k++) {
        corner[k] = &mesh->position[3 * (size_t)mesh->index[3 * at + (size_t)k]];
        const float *least = corner[first];
        const bool less =
            corner[k][0] < least[0] ||
            (corner[k][0] == least[0] &&
             (corner[k][1] < least[1] || (corner[k][1] == least[1] && corner[k][2] < least[2])));
        first = less ? k : first;
    }
    for (int k = 0; k < 3; k++)
        memcpy(t[k], corner[(first + k) % 3], sizeof t[k]);
}

static void expect_triangles(const char *name, const glint_mesh *mesh, const triangle *expected,
                             size_t count)
{
    assert_int_equal(mesh->triangle_count, count);
    for (size_t i = 0; i < count; i++) {
        triangle found;
        take_triangle(mesh, i, found);
        for (int k = 0; k < 9; k++) {
            if (found[k / 3][k % 3] != expected[i][k / 3][k % 3]) {
                fail_msg("%s: triangle %zu, corner %d, coordinate %d is %g, not %g", name, i, k / 3,
                         k % 3, (double)found[k / 3][k % 3], (double)expected[i][k / 3][k % 3]);
            }
        }
    }
}

/* The corners 0 0 0, 1 0 0, 0 1 0 and 1 1 0 of the files, the middle moved to the origin. */
static const triangle one[] = {{{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}}};
static const triangle two[] = {{{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}},
                               {{-1, 1, 0}, {1, -1, 0}, {1, 1, 0}}};

/* A file that is read: as one triangle, and with these remarks. */
typedef struct reading {
    const char *name, *text, *remarks;
} reading;

static void expect_read(const reading *files, size_t count, const triangle *expected,
                        size_t triangles)
{
    for (size_t i = 0; i < count; i++) {
        const char *path = write_bytes(files[i].name, files[i].text, strlen(files[i].text));
        print_message("%s\n", files[i].name);
        glint_mesh *mesh = load(path);
        expect_triangles(files[i].name, mesh, expected, triangles);
        assert_string_equal(mesh->remarks, files[i].remarks);
        glint_mesh_destroy(mesh);
    }
}

/* A file that is rejected, and the expected part of the message. */
static void expect_refused(const reading *files, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        glint_mesh *mesh = NULL;
        glint_error err = {""};
        const char *path = write_bytes(files[i].name, files[i].text, strlen(files[i].text));
        assert_int_equal(glint_mesh_load(path, NULL, &mesh, &err), GLINT_BAD_INPUT);
        assert_null(mesh);
        if (strstr(err.text, path) == NULL || strstr(err.text, files[i].remarks) == NULL)
            fail_msg("\"%s\" does not say \"%s\"", err.text, files[i].remarks);
    }
}

#define COUNT(list) (sizeof(list) / sizeof(list)[0])

/* ---- .obj ---------------------------------------------------------------------------------------
 */

#define V "v 0 0 0\nv 1 0 0\nv 0 1 0\n"

static void obj_is_read_however_it_is_written(void **state)
{
    (void)state;
    static const reading files[] = {
        {"plain.obj", V "f 1 2 3\n", ""},
        {"bom.obj", "\xef\xbb\xbf" V "f 1 2 3\n", ""},
        {"comment.obj", V "f 1 2 3 # the only one\n", ""},
        {"comment_close.obj", V "f 1 2 3# the only one\n", ""},
        {"comments.obj", "v 0 0 0 # 1\nv 1 0 0 # 2 3\nv 0 1 0 # a b c\nvn 0 0 1 # up\nf 1 2 3\n",
         ""},
        {"comment_on.obj", "# goes on \\\n" V "f 1 2 3\n", ""},
        {"blanks.obj", "  v 0 0 0\n  v 1 0 0\n  v 0 1 0\n  f 1 2 3\n", ""},
        {"tabs.obj", "\tv\t0\t0\t0\n\tv 1\t0 0\n\tv 0 1 0\t\n\tf\t1\t2\t3\t\n", ""},
        {"behind.obj", "v 0 0 0  \nv 1 0 0 \t\nv 0 1 0 \nf 1 2 3  \n", ""},
        {"crlf.obj", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\n f 1 2 3 # a\r\n", ""},
        {"cr.obj", "v 0 0 0\rv 1 0 0\rv 0 1 0\r f 1 2 3\r", ""},
        {"on.obj", V "f 1 \\\n2 \\\r\n3\n", ""},
        {"on_blank.obj", "v 0 0 \\ \n0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", ""},
        {"no_end.obj", V " f 1 2 3", ""},
        {"negative.obj", V " f -3 -2 -1\n", ""},
        {"no_normal.obj", V " f 1//1 2//1 3//1\n", ""},
        {"no_texture.obj", V "vn 0 0 1\nvt 0 0\n f 1/1/1 2//1 3/1\n", ""},
        {"slashes.obj", V " f 1/ 2// 3\n", ""},
        {"point.obj", "v .0 -.0 0.\nv 1. 0 .0\nv 0 .1e1 0\nf 1 2 3\n", ""},
        {"one_texture.obj", V "vt .5\nvt 0.5\nf 1/1 2/2 3/1\n", ""},
        {"colour.obj", "v 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\n f 1 2 3\n", ""},
        {"weight_colour.obj", "v 0 0 0 1 1 1 1\nv 1 0 0 1 1 1 1\nv 0 1 0 1 1 1 1\nf 1 2 3\n", ""},
        {"first.obj", " f 1 2 3\n" V, ""},
        {"names.obj", "mtllib a#b.mtl\no part#2\ng x # y\nusemtl #1\n" V " f 1 2 3\n", ""},
        {"line.obj", V "l 1 2 3 # c\nf 1 2 3\nl 1 2\n", "2 lines left out"},
        {"points.obj", V "p 1 2\nf 1 2 3\n", "2 points left out"},
        {"curve.obj", V "cstype bezier\ndeg 3\ncurv 0 1 1 2 3\nend\nf 1 2 3\n",
         "1 curve or surface left out"},
        {"call.obj", V "call other.obj\nf 1 2 3\n", "line 4: unknown keyword \"call\" ignored"},
        {"words.obj", "hello\n" V "f 1 2 3\nV 1 1 1\n",
         "line 1: unknown keyword \"hello\" ignored; as are 1 more like it"},
    };
    expect_read(files, COUNT(files), one, 1);
}

static void obj_is_refused_by_its_cause(void **state)
{
    (void)state;
    static const reading files[] = {
        {"utf16.obj", "\xff\xfev", "UTF-16 text"},
        {"capitals.obj", "V 0 0 0\nV 1 0 0\nV 0 1 0\nF 1 2 3\n",
         "contains no faces: line 1: unknown keyword \"V\""},
        {"cloud.obj", V "p 1 2 3\n", "contains no faces: 3 points left out"},
        {"corners.obj", V "f 1 2\nf 1 2 3\n", "line 4: a face needs three corners"},
        {"corners_on.obj", V "f 1 \\\n2\nf 1 2 3\n", "line 4: a face needs three corners"},
        {"flat.obj", "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n", "line 1: a vertex needs three coordinates"},
        {"normal.obj", V "vn 0 1\nf 1 2 3\n", "line 4: a normal needs three components"},
        {"texture.obj", V "vt\nf 1 2 3\n", "line 4: a texture coordinate has no number"},
        {"commas.obj", V "f 1,2,3\n", "line 4: \"1,2,3\" is not a face corner"},
        {"reals.obj", V "f 1.0 2.0 3.0\n", "line 4: \"1.0\" is not a face corner"},
        {"parts.obj", V "f 1/2/3/4 2 3\n", "line 4: \"1/2/3/4\" is not a face corner"},
        {"beyond.obj", V "f 1 2 3\r\nf 1 2 4\n",
         "line 5: a face refers to vertex 4, but there are only 3"},
        {"huge.obj", V "f 1 2 99999999999999999999999\n", "line 4: a face refers to vertex "},
        {"zero.obj", V "f 0 1 2\n", "line 4: \"0\" is not a vertex number: they start at 1"},
        {"too_negative.obj", V "f -1 -2 -4\n",
         "line 4: \"-4\" refers to a vertex that does not exist"},
    };
    expect_refused(files, COUNT(files));
}

/* ---- .stl ---------------------------------------------------------------------------------------
 */

#define FACET(normal)                                                                              \
    "facet " normal "\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
#define UP FACET("normal 0 0 1")

static void stl_is_read_however_it_is_written(void **state)
{
    (void)state;
    static const reading files[] = {
        {"plain.stl", "solid a\n" UP "endsolid a\n", ""},
        {"capitals.stl",
         "SOLID A\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\n"
         "ENDLOOP\nENDFACET\nENDSOLID A\n",
         ""},
        {"mixed.stl", "Solid a\n" UP "EndSolid a\n", ""},
        {"bom.stl", "\xef\xbb\xbfsolid a\n" UP "endsolid a\n", ""},
        {"lines.stl", "\n\n  solid a\n" UP "endsolid a\n", ""},
        {"nameless.stl", "solid\n" UP "endsolid\n", ""},
        {"name.stl", "solid facet vertex endsolid\n" UP "endsolid facet\n", ""},
        {"no_normal.stl", "solid a\n" FACET("") "endsolid a\n", ""},
        {"one_line.stl",
         "solid a facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop "
         "endfacet endsolid a",
         ""},
        {"point.stl",
         "solid a\rfacet normal .0 0 1.\router loop\rvertex .0 0 0\rvertex +1.0e0 0 0\r\tvertex 0 "
         "1.0E+00 -0\rendloop\rendfacet\rendsolid a\r",
         ""},
        {"comment.stl", "solid a\n; by hand\n" UP "color 1 0 0\nendsolid a\n",
         "line 2: unknown keyword \";\" ignored; as are 1 more like it"},
        {"open.stl", "solid a\n" UP, "ends without endsolid: truncated?"},
    };
    expect_read(files, COUNT(files), one, 1);
}

static void stl_is_refused_by_its_cause(void **state)
{
    (void)state;
    static const reading files[] = {
        {"four.stl",
         "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 "
         "0\nvertex "
         "0 1 0\nendloop\nendfacet\nendsolid a\n",
         "line 7: \"vertex\" where endloop should be"},
        {"cut.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0",
         "ends inside a facet, where a number should be: truncated?"},
        {"text.stl", "solid a\nfacet normal 0 0 up\n", "line 2: \"up\" where a number should be"},
        {"nothing.stl", "solid a\nendsolid a\n", "contains no facets"},
        {"short.stl", "good morning\n", "neither starts with \"solid\" nor is long enough"},
    };
    expect_refused(files, COUNT(files));
}

static void put_float(uint8_t *to, float value)
{
    memcpy(to, &value, sizeof value); /* as everywhere here: little-endian */
}

static void binary_stl_is_held_to_its_count(void **state)
{
    (void)state;
    uint8_t bytes[84 + 50 + 7] = "solid, says its header";
    bytes[80] = 1;
    put_float(bytes + 84 + 24, 1.0f);
    put_float(bytes + 84 + 40, 1.0f);
    for (size_t more = 0; more < 8; more += 7) {
        glint_mesh *mesh = load(write_bytes("binary.stl", bytes, 84 + 50 + more));
        expect_triangles("binary.stl", mesh, one, 1);
        assert_string_equal(mesh->remarks, more > 0 ? "7 bytes after the last facet left out" : "");
        glint_mesh_destroy(mesh);
    }
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    const char *path = write_bytes("cut_binary.stl", bytes, 84 + 49);
    assert_int_equal(glint_mesh_load(path, NULL, &mesh, &err), GLINT_BAD_INPUT);
    assert_non_null(strstr(err.text, "its header announces 1 facets, but there is room for 0"));
}

/* ---- .ply ---------------------------------------------------------------------------------------
 */

#define XYZ       "property float x\nproperty float y\nproperty float z\n"
#define LIST      "property list uchar int vertex_indices\n"
#define VERTEX(n) "element vertex " #n "\n" XYZ
#define FACE(n)   "element face " #n "\n" LIST
#define ASCII     "ply\nformat ascii 1.0\n"
#define P         "0 0 0\n1 0 0\n0 1 0\n"

static void ply_is_read_however_it_is_written(void **state)
{
    (void)state;
    static const reading files[] = {
        {"plain.ply", ASCII VERTEX(3) FACE(1) "end_header\n" P "3 0 1 2\n", ""},
        {"first.ply", ASCII FACE(1) VERTEX(3) "end_header\n3 0 1 2\n" P, ""},
        {"bom.ply", "\xef\xbb\xbf" ASCII VERTEX(3) FACE(1) "end_header\n" P "3 0 1 2\n", ""},
        {"capitals.ply",
         "PLY\nFORMAT ASCII 1.0\nELEMENT VERTEX 3\nPROPERTY FLOAT X\nPROPERTY FLOAT Y\nPROPERTY "
         "FLOAT Z\nELEMENT FACE 1\nPROPERTY LIST UCHAR INT VERTEX_INDICES\nEND_HEADER\n" P
         "3 0 1 2\n",
         ""},
        {"comment.ply",
         "ply\ncomment first\nformat ascii 1.0\nobj_info made by hand\n" VERTEX(3)
             FACE(1) "comment last\nend_header\n" P "3 0 1 2\n",
         ""},
        {"unsaid.ply", ASCII "Created by hand\n" VERTEX(3) FACE(1) "end_header\n" P "3 0 1 2\n",
         ""},
        {"crlf.ply",
         "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\n"
         "property float z\r\nelement face 1\r\nproperty list uchar int vertex_index\r\n"
         "end_header\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n",
         ""},
        {"cr.ply",
         "ply\rformat ascii 1.0\relement vertex 3\rproperty float x\rproperty float y\r"
         "property float z\relement face 1\rproperty list uchar int vertex_indices\r"
         "end_header\r0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r",
         ""},
        {"blanks.ply",
         "ply \nformat  ascii 1.0 \n" VERTEX(3) FACE(1) "end_header \n\n 0\t0 0\n\n1 0 0  \n 0 1 "
                                                        "0\n  3 0 1 2",
         ""},
        {"one_line.ply", ASCII VERTEX(3) FACE(1) "end_header\n0 0 0 1 0 0 0 1 0 3 0 1 2\n", ""},
        {"types.ply",
         ASCII "element vertex 3\nproperty uint8 flag\nproperty float64 y\nproperty double z\n"
               "property int16 x\nelement face 1\nproperty list uint8 float weight\nproperty list "
               "ushort uint32 vertex_index\nproperty short last\nend_header\n"
               "9 0 0 0\n9 0 0 1\n9 1 0 0\n2 0.5 0.5 3 0 1 2 7\n",
         ""},
        {"edge.ply",
         ASCII VERTEX(3)
             FACE(1) "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n" P
                     "3 0 1 2\n0 1\n",
         "element edge (1) left out"},
        {"other.ply",
         ASCII "element camera 1\nproperty list int float a\nproperty int b\n" VERTEX(3)
             FACE(1) "end_header\n2 0.1 0.2 7\n" P "3 0 1 2\n",
         "element camera (1) left out"},
        {"thin.ply", ASCII VERTEX(3) FACE(3) "end_header\n" P "2 0 1\n3 0 1 2\n0\n",
         "2 faces with fewer than three corners left out"},
        {"empty_element.ply",
         ASCII "element nothing 4294967295\n" VERTEX(3) FACE(1) "end_header\n" P "3 0 1 2\n", ""},
    };
    expect_read(files, COUNT(files), one, 1);
    /* The same under another name, known by its first line. */
    const char *text = files[1].text;
    glint_mesh *mesh = load(write_bytes("ply", text, strlen(text)));
    expect_triangles("ply", mesh, one, 1);
    glint_mesh_destroy(mesh);
}

/* Every other triangle of a strip is turned over; -1 begins a new one. */
static void ply_strips_are_triangles(void **state)
{
    (void)state;
#define STRIPS(n) "element tristrips " #n "\nproperty list int int vertex_indices\nend_header\n"
    static const reading files[] = {
        {"strip.ply", ASCII VERTEX(4) STRIPS(1) P "1 1 0\n4 0 1 2 3\n", ""},
        {"strips.ply", ASCII VERTEX(4) STRIPS(2) P "1 1 0\n3 0 1 2\n3 2 1 3\n", ""},
        {"restart.ply", ASCII VERTEX(4) STRIPS(1) P "1 1 0\n8 0 1 2 -1 2 1 3 -1\n", ""},
        {"both.ply", ASCII VERTEX(4) FACE(1) STRIPS(1) P "1 1 0\n3 0 1 2\n3 2 1 3\n", ""},
        {"strip_first.ply",
         ASCII "element tristrips 1\nproperty list int int vertex_indices\n" VERTEX(
             4) "end_header\n4 0 1 2 3\n" P "1 1 0\n",
         ""},
    };
    expect_read(files, COUNT(files), two, 2);
}

/* Text and both orders of bytes, with normals that belong to their vertices. */
static void binary_ply_is_the_same(void **state)
{
    (void)state;
    static const float value[3][6] = {{0, 0, 0, 0, 0, 1}, {1, 0, 0, 0, 1, 0}, {0, 1, 0, 1, 0, 0}};
    for (int big = 0; big < 2; big++) {
        char file[512];
        int length = snprintf(file, sizeof file,
                              "ply\nformat binary_%s_endian 1.0\n" FACE(
                                  1) "element vertex 3\n" XYZ "property float nx\nproperty float "
                                     "ny\nproperty float nz\nend_header\n",
                              big ? "big" : "little");
        file[length++] = 3;
        for (uint32_t i = 0; i < 3 + 18; i++) {
            uint32_t bits = i;
            if (i >= 3)
                memcpy(&bits, &value[(i - 3) / 6][(i - 3) % 6], sizeof bits);
            for (int k = 0; k < 4; k++)
                file[length++] = (char)(bits >> 8 * (big ? 3 - k : k));
        }
        glint_mesh *mesh = load(write_bytes("binary.ply", file, (size_t)length));
        expect_triangles("binary.ply", mesh, one, 1);
        for (size_t v = 0; v < 3; v++) {
            const float *p = &mesh->position[3 * v];
            const int which = p[0] == 1.0f ? 1 : p[1] == 1.0f ? 2 : 0;
            assert_memory_equal(&mesh->normal[3 * v], &value[which][3], 3 * sizeof(float));
        }
        glint_mesh_destroy(mesh);
    }
}

static void ply_is_refused_by_its_cause(void **state)
{
    (void)state;
    static const reading files[] = {
        {"cut_header.ply", "ply\nformat ascii 1", "its header does not end: truncated"},
        {"no_magic.ply", "format ascii 1.0\n", "does not start with the word ply"},
        {"word.ply", "ply\nformat ascii 1.0\ngood morning\n", "its header does not end: truncated"},
        {"format.ply", "ply\nformat text 1.0\n", "line 2: \"text\" is not a format"},
        {"no_format.ply", "ply\n" VERTEX(3) FACE(1) "end_header\n" P "3 0 1 2\n",
         "its header has no format line"},
        {"type.ply", ASCII "element vertex 3\nproperty real x\nend_header\n",
         "line 4: \"real\" is not a property type"},
        {"count.ply", ASCII "element vertex many\nend_header\n",
         "line 3: \"many\" is not a number of elements"},
        {"orphan.ply", ASCII "property float x\nend_header\n",
         "line 3: a property before the first element"},
        {"no_z.ply",
         ASCII "element vertex 3\nproperty float x\nproperty float y\n" FACE(1) "end_header\n",
         "its vertices have no z"},
        {"no_list.ply", ASCII VERTEX(3) "element face 1\nproperty int a\nend_header\n" P "1\n",
         "element face has no list named vertex_indices"},
        {"cut_text.ply", ASCII VERTEX(4) FACE(1) "end_header\n" P, "ends in element vertex 4 of 4"},
        {"cut_binary.ply",
         "ply\nformat binary_little_endian 1.0\n" VERTEX(3) FACE(1) "end_header\n0123456789",
         "ends in element vertex 1 of 3"},
        {"huge.ply", ASCII VERTEX(4294967295) FACE(1) "end_header\n" P "3 0 1 2\n",
         "ends in element vertex "},
        {"list.ply", ASCII VERTEX(3) FACE(1) "end_header\n" P "-1 0 1 2\n",
         "invalid list length -1"},
        {"number.ply", ASCII VERTEX(3) FACE(1) "end_header\n0 0 0\n1 0 0\n0 one 0\n3 0 1 2\n",
         "line 12: \"one\" is not a number"},
        {"beyond.ply", ASCII VERTEX(3) FACE(1) "end_header\n" P "3 0 1 3\n",
         "a face refers to vertex 3, but there are only 3, counted from 0"},
        {"negative.ply", ASCII VERTEX(3) FACE(1) "end_header\n" P "3 0 1 -2\n",
         "face 0 refers to vertex -2, which does not exist"},
        {"cloud.ply", ASCII VERTEX(3) "element edge 1\nproperty int a\nend_header\n" P "1\n",
         "contains no faces: element edge (1) left out"},
    };
    expect_refused(files, COUNT(files));
}

/* ---- .gltf --------------------------------------------------------------------------------------
 */

/* Four vertices 0 0 0, 1 0 0, 0 1 0, 1 1 0; behind them the indices 0 1 2 2 1 3. */
#define BUFFER                                                                                     \
    "\"buffers\":[{\"byteLength\":56,\"uri\":\"data:application/octet-stream;base64,"              \
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAACAPwAAgD8AAAAAAAECAgEDAAA=\"}]"
#define GLTF(more, nodes, primitive)                                                               \
    "{\"asset\":{\"version\":\"2.0\"}," more "\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"           \
    "\"nodes\":[" nodes "],\"meshes\":[{\"primitives\":[" primitive "]}],\"accessors\":["          \
    "{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\",\"min\":[0,0,0],"      \
    "\"max\":[1,1,0]},{\"bufferView\":1,\"componentType\":5121,\"count\":6,\"type\":\"SCALAR\"}]," \
    "\"bufferViews\":["                                                                            \
    "{\"buffer\":0,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":48,\"byteLength\":6}]," BUFFER  \
    "}"
#define PRIMITIVE(more) "{\"attributes\":{\"POSITION\":0}" more "}"
#define SHOWN           "{\"mesh\":0}"

static void gltf_modes_are_triangles(void **state)
{
    (void)state;
    static const reading files[] = {
        {"list.gltf", GLTF("", SHOWN, PRIMITIVE(",\"indices\":1")), ""},
        {"strip.gltf", GLTF("", SHOWN, PRIMITIVE(",\"mode\":5")), ""},
        {"lines.gltf",
         GLTF(
             "", SHOWN,
             PRIMITIVE(",\"indices\":1") "," PRIMITIVE(",\"mode\":1") "," PRIMITIVE(",\"mode\":0")),
         "4 points left out; 2 lines left out"},
        {"hidden.gltf", GLTF("", SHOWN ",{\"mesh\":0}", PRIMITIVE(",\"mode\":5")),
         "1 mesh outside the scene left out"},
        {"lit.gltf",
         GLTF("\"extensionsRequired\":[\"KHR_materials_unlit\"],\"extensionsUsed\":[\"KHR_"
              "materials_unlit\"],",
              SHOWN, PRIMITIVE(",\"mode\":5")),
         ""},
        {"used.gltf",
         GLTF("\"extensionsUsed\":[\"KHR_texture_transform\",\"EXT_mesh_gpu_instancing\"],", SHOWN,
              PRIMITIVE(",\"mode\":5")),
         "glTF extension EXT_mesh_gpu_instancing is not supported"},
        {"weights.gltf", GLTF("", "{\"mesh\":0,\"weights\":[0,0.5]}", PRIMITIVE(",\"mode\":5")),
         "morph targets are ignored"},
    };
    expect_read(files, COUNT(files), two, 2);
}

static void gltf_is_refused_by_its_cause(void **state)
{
    (void)state;
    static const reading files[] = {
        {"quantized.gltf",
         GLTF("\"extensionsRequired\":[\"KHR_materials_unlit\",\"KHR_mesh_quantization\"],", SHOWN,
              PRIMITIVE("")),
         "requires the unsupported glTF extension KHR_mesh_quantization"},
        {"meshopt.gltf",
         GLTF("\"extensionsRequired\":[\"EXT_meshopt_compression\"],", SHOWN, PRIMITIVE("")),
         "requires the unsupported glTF extension EXT_meshopt_compression"},
        {"unheard.gltf", GLTF("\"extensionsRequired\":[\"A\\nB\"],", SHOWN, PRIMITIVE("")),
         "requires the unsupported glTF extension A?B: export"},
        {"skin.gltf", GLTF("\"skins\":[{\"joints\":[0]}],", SHOWN, PRIMITIVE("")),
         "skin 0 has no inverseBindMatrices"},
    };
    expect_refused(files, COUNT(files));
}

#define SKIN(first, second)                                                                        \
    "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0,1,2]}],\"nodes\":["    \
    "{\"name\":\"m\",\"mesh\":0,\"skin\":0,\"scale\":[7,1,1],\"translation\":[0,0,5]},"            \
    "{" first "\"matrix\":[0,1,0,0,-1,0,0,0,0,0,1,0,0,0,0,1]},"                                    \
    "{" second "\"matrix\":[0,1,0,0,-1,0,0,0,0,0,1,0,0,4,0,1]}],"                                  \
    "\"skins\":[{\"joints\":[1,2],\"inverseBindMatrices\":3}],\"meshes\":[{\"primitives\":["       \
    "{\"attributes\":{\"POSITION\":0,\"JOINTS_0\":1,\"WEIGHTS_0\":2}}]}],\"accessors\":["          \
    "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"                     \
    "{\"bufferView\":1,\"componentType\":5121,\"count\":3,\"type\":\"VEC4\"},"                     \
    "{\"bufferView\":2,\"componentType\":5126,\"count\":3,\"type\":\"VEC4\"},"                     \
    "{\"bufferView\":3,\"componentType\":5126,\"count\":2,\"type\":\"MAT4\"}],\"bufferViews\":["   \
    "{\"buffer\":0,\"byteLength\":36},{\"buffer\":0,\"byteOffset\":36,\"byteLength\":12},"         \
    "{\"buffer\":0,\"byteOffset\":48,\"byteLength\":48},"                                          \
    "{\"buffer\":0,\"byteOffset\":96,\"byteLength\":128}],"                                        \
    "\"buffers\":[{\"byteLength\":224,\"uri\":\"skin.bin\"}]}"

/* Three vertices, their two joints, their weights, and the joints' inverse bind matrices, which
 * make x twice as large. The last vertex is half the second joint's. */
static void write_skin(void)
{
    static const float vertex[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    static const float weight[12] = {1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0};
    static const float inverse[16] = {2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    static const uint8_t joint[12] = {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0};
    uint8_t bytes[224];
    memcpy(bytes, vertex, 36);
    memcpy(bytes + 36, joint, 12);
    memcpy(bytes + 48, weight, 48);
    memcpy(bytes + 96, inverse, 64);
    memcpy(bytes + 160, inverse, 64);
    (void)write_bytes("skin.bin", bytes, sizeof bytes);
}

/* The joints turn x into y and lift the last vertex by half of 4; what the mesh's node says of its
 * place counts for nothing. */
static void a_skin_is_where_its_joints_are(void **state)
{
    (void)state;
    static const triangle posed[] = {{{-0.5f, 1, 0}, {0.5f, -1, 0}, {0.5f, 1, 0}}};
    write_skin();
    const reading skin = {"posed.gltf", SKIN("", ""), ""};
    expect_read(&skin, 1, posed, 1);
    const reading named = {"named.gltf", SKIN("\"name\":\"a\",", "\"name\":\"b\","), ""};
    expect_read(&named, 1, posed, 1);
    const reading twins = {"twins.gltf", SKIN("\"name\":\"m\",", ""),
                           "two nodes share the name of a joint: m"};
    expect_refused(&twins, 1);
}

/* The same in the binary container. */
static void glb_is_looked_through(void **state)
{
    (void)state;
    static const char json[] =
        "{\"asset\":{\"version\":\"2.0\"},\"extensionsRequired\":[\"KHR_mesh_quantization\"]}";
    char file[256] = "glTF\2\0\0";
    const uint32_t chunk = sizeof json - 1, whole = 20 + chunk;
    memcpy(file + 8, &whole, 4);
    memcpy(file + 12, &chunk, 4);
    memcpy(file + 16, "JSON", 4);
    memcpy(file + 20, json, chunk);
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    const char *path = write_bytes("a.glb", file, whole);
    assert_int_equal(glint_mesh_load(path, NULL, &mesh, &err), GLINT_BAD_INPUT);
    assert_non_null(
        strstr(err.text, "requires the unsupported glTF extension KHR_mesh_quantization"));
}

/* ---- Files beside the file ----------------------------------------------------------------------
 */

/* Who waited for the pipe would be stopped, and refuse the file for that. */
static void a_pipe_beside_it_is_not_waited_for(void **state)
{
    (void)state;
    assert_int_equal(mkfifo(scratch_path("pipe"), 0666), 0);
    const reading materials = {"materials.obj", "mtllib pipe\nusemtl a\n" V "f 1 2 3\n", ""};
    expect_read(&materials, 1, one, 1);
    const reading buffer = {
        "buffer.gltf",
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":"
        "[" SHOWN "],\"meshes\":[{\"primitives\":[" PRIMITIVE(
            "") "]}],\"accessors\":[{\"bufferView\":0,"
                "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"bufferViews\":[{"
                "\"buffer\":0,"
                "\"byteLength\":36}],\"buffers\":[{\"byteLength\":36,\"uri\":\"pipe\"}]}",
        "pipe, which is not a regular file"};
    expect_refused(&buffer, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(obj_is_read_however_it_is_written),
        cmocka_unit_test(obj_is_refused_by_its_cause),
        cmocka_unit_test(stl_is_read_however_it_is_written),
        cmocka_unit_test(stl_is_refused_by_its_cause),
        cmocka_unit_test(binary_stl_is_held_to_its_count),
        cmocka_unit_test(ply_is_read_however_it_is_written),
        cmocka_unit_test(ply_strips_are_triangles),
        cmocka_unit_test(binary_ply_is_the_same),
        cmocka_unit_test(ply_is_refused_by_its_cause),
        cmocka_unit_test(gltf_modes_are_triangles),
        cmocka_unit_test(gltf_is_refused_by_its_cause),
        cmocka_unit_test(a_skin_is_where_its_joints_are),
        cmocka_unit_test(glb_is_looked_through),
        cmocka_unit_test(a_pipe_beside_it_is_not_waited_for),
    };
    return cmocka_run_group_tests_name("content", tests, scratch_make, scratch_remove);
}
