/* Normals that a mesh file does not give, or not so that they can be used: the same cube, the same
 * sphere and a rock, in every format there is a writer for, against normals by a formula of the
 * test's own (solids.h). */
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
#include "solids.h"

#include "formats.h"
#include "studio.h"

#define WIDTH  160
#define HEIGHT 120

/* Rounding of a normal or a place; far below what is seen (1e-4). */
#define SAME_NMSE 1e-7

static glint_mesh *load(const char *path)
{
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    const glint_status status = glint_mesh_load(path, NULL, &mesh, &err);
    assert_string_equal(err.text, "");
    assert_int_equal(status, GLINT_OK);
    return mesh;
}

/* A picture of the mesh, which is given away. */
static studio picture_of(glint_mesh *mesh)
{
    studio s = open_studio(WIDTH, HEIGHT, 1, GLINT_BACKEND_C);
    glint_scene scene = {.mesh = mesh};
    glint_scene_defaults(&scene);
    shoot(&s, &scene);
    assert_true(s.stats.fragments > WIDTH * HEIGHT / 4);
    glint_mesh_destroy(mesh);
    return s;
}

static double difference(const studio *a, const studio *b)
{
    glint_image_difference d;
    assert_int_equal(glint_image_compare(a->image, b->image, &d, NULL), GLINT_OK);
    return d.nmse;
}

/* The picture of what has been put down under the name. */
static studio picture_of_page(const char *name)
{
    return picture_of(load(put_down(name)));
}

static void expect_page(const char *name, const studio *expected, double nmse)
{
    studio s = picture_of_page(name);
    const double found = difference(expected, &s);
    if (!(found <= nmse))
        fail_msg("%s: NMSE %g", name, found);
    close_studio(&s);
}

typedef struct format {
    const char *name;
    void (*put)(const solid *s);
    solid_rule rule;
} format;

static const format formats[] = {
    {"a.obj", put_obj, SOLID_CREASED},       {"materials.obj", put_obj_materials, SOLID_CREASED},
    {"ascii.ply", put_ply, SOLID_CREASED},   {"little.ply", put_ply_little, SOLID_CREASED},
    {"big.ply", put_ply_big, SOLID_CREASED}, {"a.off", put_off, SOLID_CREASED},
    {"a.amf", put_amf, SOLID_CREASED},       {"a.3mf", put_3mf, SOLID_CREASED},
    {"a.dae", put_dae, SOLID_CREASED},       {"a.x", put_x, SOLID_CREASED},
    {"a.ac", put_ac, SOLID_CREASED},         {"a.x3d", put_x3d, SOLID_CREASED},
    {"a.raw", put_raw, SOLID_CREASED},       {"a.dxf", put_dxf, SOLID_CREASED},
    {"ascii.stl", put_stl, SOLID_FLAT},      {"binary.stl", put_stl_binary, SOLID_FLAT},
    {"a.gltf", put_gltf, SOLID_FLAT},        {"a.glb", put_glb, SOLID_FLAT},
};

#define FORMATS (sizeof formats / sizeof formats[0])

static void expect_in_every_format(const solid *s)
{
    solid shuffled = *s;
    solid_shuffle(&shuffled);
    for (size_t i = 0; i < FORMATS; i++) {
        studio expected = picture_of(solid_mesh(s, formats[i].rule));
        formats[i].put(s);
        expect_page(formats[i].name, &expected, SAME_NMSE);
        formats[i].put(&shuffled);
        expect_page(formats[i].name, &expected, SAME_NMSE);
        close_studio(&expected);
    }
}

static solid made; /* of some size: not on the stack */

/* All its edges are sharp: flat sides by any rule, and one picture. */
static void one_cube_in_every_format(void **state)
{
    (void)state;
    solid_cube(&made);
    studio creased = picture_of(solid_mesh(&made, SOLID_CREASED));
    studio flat = picture_of(solid_mesh(&made, SOLID_FLAT));
    assert_true(difference(&creased, &flat) == 0.0);
    close_studio(&creased);
    close_studio(&flat);
    expect_in_every_format(&made);
}

static void one_sphere_in_every_format(void **state)
{
    (void)state;
    solid_ball(&made, 24, 0.0);
    studio creased = picture_of(solid_mesh(&made, SOLID_CREASED));
    studio flat = picture_of(solid_mesh(&made, SOLID_FLAT));
    assert_true(difference(&creased, &flat) > 0.001);
    close_studio(&creased);
    close_studio(&flat);
    expect_in_every_format(&made);
}

/* Edges of all angles, some above 66 degrees and some below. */
static void one_rock_in_every_format(void **state)
{
    (void)state;
    solid_ball(&made, 16, 0.5);
    studio creased = picture_of(solid_mesh(&made, SOLID_CREASED));
    studio flat = picture_of(solid_mesh(&made, SOLID_FLAT));
    assert_true(difference(&creased, &flat) > 0.01);
    close_studio(&creased);
    close_studio(&flat);
    expect_in_every_format(&made);
}

/* Corner by corner, the triangles in the file's order. */
static void expect_normals(const glint_mesh *mesh, const solid *s, solid_rule rule)
{
    assert_int_equal(mesh->triangle_count, s->triangles);
    for (size_t i = 0; i < s->triangles; i++) {
        for (size_t k = 0; k < 3; k++) {
            const float *n = &mesh->normal[3 * (size_t)mesh->index[3 * i + k]];
            const glint_vec3 expected = solid_normal(s, i, k, rule);
            const glint_vec3 off = glint_vec3_sub(glint_vec3_of(n), expected);
            assert_true(glint_vec3_length(off) < 1e-6);
        }
    }
}

static void normals_are_those_of_the_formula(void **state)
{
    (void)state;
    solid_ball(&made, 16, 0.5);
    for (int turn = 0; turn < 2; turn++) {
        put_ply(&made);
        glint_mesh *mesh = load(put_down("rock.ply"));
        expect_normals(mesh, &made, SOLID_CREASED);
        glint_mesh_destroy(mesh);
        put_stl(&made);
        mesh = load(put_down("rock.stl"));
        expect_normals(mesh, &made, SOLID_FLAT);
        glint_mesh_destroy(mesh);
        solid_shuffle(&made);
    }
}

/* The same triangles in another order are the same picture to the bit. */
static void order_changes_no_bit(void **state)
{
    (void)state;
    solid_ball(&made, 16, 0.5);
    put_ply(&made);
    studio before = picture_of_page("rock.ply");
    solid_shuffle(&made);
    put_ply(&made);
    expect_page("shuffled.ply", &before, 0.0);
    close_studio(&before);
}

/* ---- Smoothing groups --------------------------------------------------------------------------
 */

static void expect_groups(const solid *s, bool groups, bool materials)
{
    studio expected = picture_of(solid_mesh(s, SOLID_GROUPED));
    put_3ds(&s, 1, groups, materials);
    expect_page("groups.3ds", &expected, SAME_NMSE);
    put_ase(s, groups, materials);
    expect_page("groups.ase", &expected, SAME_NMSE);
    for (int big = 0; big < 2; big++) {
        put_ase(s, groups, materials);
        widen_page(big != 0);
        expect_page("wide.ase", &expected, SAME_NMSE);
    }
    close_studio(&expected);
}

static void set_groups(solid *s, uint32_t (*group)(size_t triangle))
{
    for (size_t i = 0; i < s->triangles; i++)
        s->group[i] = group(i);
}

static uint32_t none(size_t triangle)
{
    (void)triangle;
    return 0;
}

static uint32_t one_for_all(size_t triangle)
{
    (void)triangle;
    return 1u << 31;
}

static uint32_t one_for_each_side(size_t triangle)
{
    return 1u << triangle / 2 % 32;
}

/* 1, 3 and 2: what is smooth over the second need not be over each other. */
static uint32_t overlapping(size_t triangle)
{
    static const uint32_t groups[] = {1, 3, 2};
    return groups[triangle % 3];
}

/* Some triangles of no group among the others. */
static uint32_t some_without(size_t triangle)
{
    return triangle % 4 == 0 ? 0 : 5;
}

static void smoothing_groups_are_obeyed(void **state)
{
    (void)state;
    uint32_t (*const groups[])(size_t) = {none, one_for_all, one_for_each_side, overlapping,
                                          some_without};
    for (int i = 0; i < 2; i++) {
        if (i == 0)
            solid_cube(&made);
        else
            solid_ball(&made, 16, 0.3);
        set_groups(&made, none);
        expect_groups(&made, false, false);
        expect_groups(&made, false, true);
        for (size_t k = 0; k < sizeof groups / sizeof groups[0]; k++) {
            set_groups(&made, groups[k]);
            expect_groups(&made, true, false);
            expect_groups(&made, true, true);
            solid_shuffle(&made);
        }
    }
}

/* A cube without a group is the cube of every other format. */
static void no_group_is_a_hard_edge(void **state)
{
    (void)state;
    const solid *one = &made;
    solid_cube(&made);
    studio expected = picture_of(solid_mesh(&made, SOLID_FLAT));
    put_3ds(&one, 1, false, false);
    expect_page("none.3ds", &expected, SAME_NMSE);
    set_groups(&made, one_for_each_side);
    put_3ds(&one, 1, true, false);
    expect_page("sides.3ds", &expected, SAME_NMSE);
    set_groups(&made, one_for_all);
    put_3ds(&one, 1, true, false);
    studio round = picture_of_page("round.3ds");
    assert_true(difference(&expected, &round) > 0.1);
    close_studio(&round);
    close_studio(&expected);
}

/* A group is of its object: the same number in another one, in the same place, is another. */
static void groups_are_of_one_object(void **state)
{
    (void)state;
    static solid other;
    const solid *both[] = {&made, &other};
    solid_cube(&made);
    set_groups(&made, one_for_all);
    other = made;
    made.triangles = 6; /* half the cube each */
    for (size_t i = 0; i < 6; i++)
        memcpy(other.corner[i], other.corner[i + 6], sizeof other.corner[i]);
    other.triangles = 6;
    put_3ds(both, 2, true, false);
    glint_mesh *mesh = load(put_down("objects.3ds"));
    assert_int_equal(mesh->triangle_count, 12);
    for (size_t i = 0; i < 12; i++) {
        const solid *s = both[i / 6];
        for (size_t k = 0; k < 3; k++) {
            const glint_vec3 n = glint_vec3_of(&mesh->normal[3 * (size_t)mesh->index[3 * i + k]]);
            const glint_vec3 off = glint_vec3_sub(n, solid_normal(s, i % 6, k, SOLID_GROUPED));
            assert_true(glint_vec3_length(off) < 1e-6);
        }
    }
    glint_mesh_destroy(mesh);
}

/* ---- Normals that are there and of no use ------------------------------------------------------
 */

static void put_obj_with(const solid *s, const char *normal)
{
    put_vertices(s, "v %.10g %.10g %.10g\n");
    put("vn %s\n", normal);
    for (size_t i = 0; i < s->triangles; i++)
        put("f %u//1 %u//1 %u//1\n", s->corner[i][0] + 1, s->corner[i][1] + 1, s->corner[i][2] + 1);
}

/* All vertices with the normal n. */
static void put_ply_with(const solid *s, const double n[3])
{
    put("ply\nformat binary_little_endian 1.0\nelement vertex %zu\nproperty float x\n"
        "property float y\nproperty float z\nproperty float nx\nproperty float ny\n"
        "property float nz\nelement face %zu\nproperty list uchar int vertex_indices\n"
        "end_header\n",
        s->vertices, s->triangles);
    for (size_t i = 0; i < s->vertices; i++) {
        put_point(s->at[i]);
        put_point(n);
    }
    for (size_t i = 0; i < s->triangles; i++) {
        put_number(3, 1);
        for (int k = 0; k < 3; k++)
            put_number(s->corner[i][k], 4);
    }
}

static const double useless[][3] = {
    {0.0, 0.0, 0.0},
    {-0.0, 0.0, -0.0},
    {(double)NAN, 0.0, 1.0},
    {0.0, (double)INFINITY, 0.0},
    {1.0, 0.0, -(double)INFINITY},
};

static void expect_without_use_of(const solid *s)
{
    static const char *const words[] = {"0 0 0", "nan 0 1", "0 inf 0"};
    studio creased = picture_of(solid_mesh(s, SOLID_CREASED));
    studio flat = picture_of(solid_mesh(s, SOLID_FLAT));
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        put_obj_with(s, words[i]);
        expect_page("useless.obj", &creased, SAME_NMSE);
    }
    put_stl_with(s, "0 0 0");
    expect_page("useless.stl", &flat, SAME_NMSE);
    for (size_t i = 0; i < sizeof useless / sizeof useless[0]; i++) {
        put_ply_with(s, useless[i]);
        expect_page("useless.ply", &creased, SAME_NMSE);
        put_stl_binary_with(s, useless[i]);
        expect_page("useless.stl", &flat, SAME_NMSE);
    }
    put_gltf_with(s, true, 0.0);
    expect_page("useless.gltf", &creased, SAME_NMSE);
    close_studio(&creased);
    close_studio(&flat);
}

static void useless_normals_are_made_anew(void **state)
{
    (void)state;
    solid_cube(&made);
    expect_without_use_of(&made);
    solid_ball(&made, 16, 0.0);
    expect_without_use_of(&made);
}

/* One corner of each triangle lacks its normal; the others keep what the file says. */
static void given_normals_stay(void **state)
{
    (void)state;
    solid_cube(&made);
    put_vertices(&made, "v %.10g %.10g %.10g\n");
    put("vn 0 0 0\nvn 1 2 2\n");
    for (size_t i = 0; i < made.triangles; i++) {
        put("f %u//2 %u//1 %u//2\n", made.corner[i][0] + 1, made.corner[i][1] + 1,
            made.corner[i][2] + 1);
    }
    glint_mesh *mesh = load(put_down("some.obj"));
    for (size_t i = 0; i < made.triangles; i++) {
        for (size_t k = 0; k < 3; k++) {
            const float *n = &mesh->normal[3 * (size_t)mesh->index[3 * i + k]];
            const glint_vec3 given = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
            const glint_vec3 expected = k == 1 ? solid_plane(&made, i) : given;
            assert_true(glint_vec3_length(glint_vec3_sub(glint_vec3_of(n), expected)) < 1e-6);
        }
    }
    glint_mesh_destroy(mesh);
}

/* Sums of faces weighted by area are as short as the object is small, or as long as it is large. */
static void the_length_of_a_normal_says_nothing(void **state)
{
    (void)state;
    static const char *const lengths[] = {"1", "4e-6", "1e-12", "1e-30", "1e-42", "1e12", "1e30"};
    solid_cube(&made);
    studio expected = picture_of(solid_mesh(&made, SOLID_FLAT));
    for (size_t k = 0; k < sizeof lengths / sizeof lengths[0]; k++) {
        put_vertices(&made, "v %.10g %.10g %.10g\n");
        for (size_t i = 0; i < made.triangles; i++) {
            const glint_vec3 n = solid_plane(&made, i);
            const char *l = lengths[k];
            put("vn %s%s %s%s %s%s\n", n.x < 0.0 ? "-" : "", n.x != 0.0 ? l : "0",
                n.y < 0.0 ? "-" : "", n.y != 0.0 ? l : "0", n.z < 0.0 ? "-" : "",
                n.z != 0.0 ? l : "0");
            put("f %u//%zu %u//%zu %u//%zu\n", made.corner[i][0] + 1, i + 1, made.corner[i][1] + 1,
                i + 1, made.corner[i][2] + 1, i + 1);
        }
        expect_page("lengths.obj", &expected, SAME_NMSE);
    }
    close_studio(&expected);
    solid_ball(&made, 16, 0.0); /* its places, as long as it likes, are its normals */
    put_gltf_with(&made, true, 1.0);
    studio sphere = picture_of_page("long.gltf");
    put_gltf_with(&made, true, 1e-20);
    expect_page("short.gltf", &sphere, SAME_NMSE);
    close_studio(&sphere);
}

/* ---- Size and place ----------------------------------------------------------------------------
 */

static void change(solid *s, double scale, double x, double y, double z)
{
    for (size_t i = 0; i < s->vertices; i++) {
        s->at[i][0] = scale * s->at[i][0] + x;
        s->at[i][1] = scale * s->at[i][1] + y;
        s->at[i][2] = scale * s->at[i][2] + z;
    }
}

static void expect_of_any_size(const solid *s)
{
    static solid sized;
    static const double sizes[] = {1e-3, 1e-6, 1e-8, 1e-12, 1e-20, 1e-30, 1e-36, 1e6, 1e17};
    studio expected = picture_of(solid_mesh(s, SOLID_CREASED));
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        sized = *s;
        change(&sized, sizes[i], 0.0, 0.0, 0.0);
        put_obj(&sized);
        expect_page("sized.obj", &expected, SAME_NMSE);
        put_ply(&sized);
        expect_page("sized.ply", &expected, SAME_NMSE);
        put_ply_little(&sized);
        expect_page("binary.ply", &expected, SAME_NMSE);
    }
    close_studio(&expected);
}

static void size_says_nothing(void **state)
{
    (void)state;
    solid_cube(&made);
    expect_of_any_size(&made);
    solid_ball(&made, 16, 0.5);
    expect_of_any_size(&made);
}

/* A star of a polygon, which assimp cuts by tests of areas: these must not vanish. */
static void a_tiny_polygon_is_cut_like_a_large_one(void **state)
{
    (void)state;
    static const double sizes[] = {1.0, 1e-9, 1e-25, 1e15};
    studio s[4];
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 10; k++) {
            const double r = sizes[i] * (k % 2 == 0 ? 1.0 : 0.6), a = 0.628318530717958648 * k;
            put("v %.9g %.9g 0\n", r * cos(a), r * sin(a));
        }
        put("f 1 2 3 4 5 6 7 8 9 10\n");
        s[i] = picture_of_page("star.obj");
    }
    for (int i = 1; i < 4; i++) {
        assert_true(difference(&s[0], &s[i]) < SAME_NMSE);
        close_studio(&s[i]);
    }
    close_studio(&s[0]);
}

static void expect_refused(const char *path)
{
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    assert_int_equal(glint_mesh_load(path, NULL, &mesh, &err), GLINT_BAD_INPUT);
    print_message("%s\n", err.text);
    assert_non_null(strstr(err.text, "single precision is not enough"));
    assert_null(strchr(err.text, '\n'));
}

/* What is drawn does not differ visibly, by the thesis's own measure; what would is refused. */
static void what_floats_cannot_hold_is_refused(void **state)
{
    (void)state;
    static solid moved;
    static const struct {
        double place;
        bool drawn;
    } places[] = {{100.0, true},    {1000.0, true},    {3000.0, true}, {10000.0, false},
                  {30000.0, false}, {100000.0, false}, {5e6, false},   {1e9, false}};
    solid_ball(&made, 44, 0.0);
    studio expected = picture_of(solid_mesh(&made, SOLID_CREASED));
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        for (int axes = 1; axes <= 7; axes++) {
            const double p = places[i].place;
            moved = made;
            change(&moved, 1.0, axes & 1 ? p : 0.0, axes & 2 ? -p : 0.0, axes & 4 ? p : 0.0);
            if (axes % 2 == 0)
                put_obj(&moved);
            else
                put_ply_little(&moved);
            const char *name = axes % 2 == 0 ? "moved.obj" : "moved.ply";
            if (places[i].drawn)
                expect_page(name, &expected, 1e-4);
            else
                expect_refused(put_down(name));
        }
    }
    close_studio(&expected);
}

/* A cube, and behind it a triangle of no size that its maker left somewhere.
 * What `expected` says is remarked, and the cube is drawn, with `drawn` triangles more. */
static void expect_aside(const char *more, size_t drawn, const char *expected)
{
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    solid_cube(&made);
    put_obj(&made);
    put("o aside\n%s", more);
    const char *path = put_down("aside.obj");
    if (glint_mesh_load(path, NULL, &mesh, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    assert_string_equal(mesh->remarks, expected);
    assert_int_equal(mesh->triangle_count, made.triangles + drawn);
    glint_mesh_destroy(mesh);
}

/* A stray speck next to the object gets a remark, not a rejection. A file entirely at the origin is
 * not rejected for its position. */
static void a_trifle_beside_the_object_refuses_nothing(void **state)
{
    (void)state;
    expect_aside("v 0 0 0\nv 0 0 0\nv 0 0 0\nf -1 -2 -3\n", 0, "");
    expect_aside("f 1 1 1\n", 0, "1 mesh is too fine for single precision at its position");
    expect_aside("v 9 9 9\nv 9 9 9.00001\nv 9 9.00001 9\nf -1 -2 -3\n", 1,
                 "1 mesh is too fine for single precision at its position");
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    put("v 0 0 0\nv 1e-46 0 0\nv 0 1e-46 0\nf 1 2 3\n");
    assert_int_equal(glint_mesh_load(put_down("nothing.obj"), NULL, &mesh, &err), GLINT_BAD_INPUT);
    assert_non_null(strstr(err.text, "two corners that coincide in single precision"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_cube_in_every_format),
        cmocka_unit_test(one_sphere_in_every_format),
        cmocka_unit_test(one_rock_in_every_format),
        cmocka_unit_test(normals_are_those_of_the_formula),
        cmocka_unit_test(order_changes_no_bit),
        cmocka_unit_test(smoothing_groups_are_obeyed),
        cmocka_unit_test(no_group_is_a_hard_edge),
        cmocka_unit_test(groups_are_of_one_object),
        cmocka_unit_test(useless_normals_are_made_anew),
        cmocka_unit_test(given_normals_stay),
        cmocka_unit_test(the_length_of_a_normal_says_nothing),
        cmocka_unit_test(size_says_nothing),
        cmocka_unit_test(a_tiny_polygon_is_cut_like_a_large_one),
        cmocka_unit_test(what_floats_cannot_hold_is_refused),
        cmocka_unit_test(a_trifle_beside_the_object_refuses_nothing),
    };
    return cmocka_run_group_tests_name("normals", tests, scratch_make, scratch_remove);
}
