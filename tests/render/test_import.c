/* Mesh files: third-party ones (Debian's glmark2-data and assimp-testmodels), small ones written
 * here with exactly known results, and bad ones that must be rejected. */
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
#include "reflectance/vec3.h"
#include "render/load.h"
#include "render/mesh.h"
#include "render/render.h"

#define GLMARK "/usr/share/glmark2/models/"
#define ASSIMP "/usr/share/assimp/models/"

static glint_mesh *load(const char *path)
{
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    const glint_status status = glint_mesh_load(path, NULL, &mesh, &err);
    assert_string_equal(err.text, "");
    assert_int_equal(status, GLINT_OK);
    assert_non_null(mesh);
    return mesh;
}

/* What mesh.h promises of every mesh. */
static void expect_sound(const glint_mesh *mesh)
{
    assert_true(mesh->triangle_count > 0);
    for (size_t i = 0; i < 3 * mesh->vertex_count; i++)
        assert_true(isfinite(mesh->position[i]));
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        const glint_vec3 n = glint_vec3_of(&mesh->normal[3 * v]);
        assert_true(fabs(glint_vec3_length(n) - 1.0) < 1e-5);
    }
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++)
        assert_true(mesh->index[i] < mesh->vertex_count);
}

static glint_vec3 face_normal(const glint_mesh *mesh, size_t triangle)
{
    glint_vec3 p[3];
    for (size_t k = 0; k < 3; k++)
        p[k] = glint_vec3_of(&mesh->position[3 * (size_t)mesh->index[3 * triangle + k]]);
    return glint_vec3_cross(glint_vec3_sub(p[1], p[0]), glint_vec3_sub(p[2], p[0]));
}

/* The part of triangles whose winding agrees with the normals of their corners. */
static double agreement(const glint_mesh *mesh)
{
    size_t agree = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        glint_vec3 sum = {0.0, 0.0, 0.0};
        for (size_t k = 0; k < 3; k++) {
            sum = glint_vec3_add(sum,
                                 glint_vec3_of(&mesh->normal[3 * (size_t)mesh->index[3 * i + k]]));
        }
        agree += glint_vec3_dot(sum, face_normal(mesh, i)) > 0.0;
    }
    return (double)agree / (double)mesh->triangle_count;
}

static void real_meshes_are_sound(void **state)
{
    (void)state;
    const struct {
        const char *path;
        size_t triangles;
    } files[] = {
        {GLMARK "horse.3ds", 7172},     {GLMARK "cat.3ds", 14348},
        {GLMARK "cube.3ds", 12},        {GLMARK "asteroid-low.3ds", 480},
        {GLMARK "bunny.obj", 69666},    {ASSIMP "OBJ/WusonOBJ.obj", 3732},
        {ASSIMP "PLY/Wuson.ply", 3732}, {ASSIMP "STL/Wuson.stl", 3732},
        {ASSIMP "3DS/fels.3ds", 768},
    };
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        print_message("%s\n", files[i].path);
        glint_mesh *mesh = load(files[i].path);
        assert_int_equal(mesh->triangle_count, files[i].triangles);
        expect_sound(mesh);
        assert_true(agreement(mesh) > 0.97);
        glint_mesh_destroy(mesh);
    }
}

/* One animal in three formats is one animal: the same outline in the picture. */
static void one_mesh_in_three_formats(void **state)
{
    (void)state;
    const char *paths[] = {ASSIMP "OBJ/WusonOBJ.obj", ASSIMP "PLY/Wuson.ply",
                           ASSIMP "STL/Wuson.stl"};
    uint64_t fragments[3];
    const glint_backend_config config = {.kind = GLINT_BACKEND_C};
    glint_renderer *renderer = NULL;
    glint_image *image = NULL;
    assert_int_equal(glint_renderer_create(160, 120, 2, &config, &renderer, NULL), GLINT_OK);
    assert_int_equal(glint_image_create(160, 120, &image, NULL), GLINT_OK);
    for (int i = 0; i < 3; i++) {
        glint_mesh *mesh = load(paths[i]);
        glint_scene scene = {.mesh = mesh};
        glint_scene_defaults(&scene);
        glint_render_stats stats;
        assert_int_equal(glint_render(renderer, &scene, image, NULL, &stats, NULL), GLINT_OK);
        fragments[i] = stats.fragments;
        glint_mesh_destroy(mesh);
    }
    assert_true(fragments[0] > 1000);
    for (int i = 1; i < 3; i++)
        assert_true(llabs((long long)fragments[i] - (long long)fragments[0]) < 20);
    glint_image_destroy(image);
    glint_renderer_destroy(renderer);
}

static const char *write_file(const char *name, const char *text)
{
    const char *path = scratch_path(name);
    scratch_write(path, text, strlen(text));
    return path;
}

#define TRIANGLE_AND_SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\n"

static void polygons_are_cut_points_and_lines_dropped(void **state)
{
    (void)state;
    glint_mesh *mesh =
        load(write_file("mixed.obj", TRIANGLE_AND_SQUARE "f 1 2 3 4\nf 5 6 7\nl 1 5\np 2\n"));
    assert_int_equal(mesh->triangle_count, 3);
    expect_sound(mesh);
    for (size_t i = 0; i < 3; i++)
        assert_true(face_normal(mesh, i).z > 0.0);
    for (size_t v = 0; v < mesh->vertex_count; v++)
        assert_true(mesh->normal[3 * v + 2] > 0.999f);
    glint_mesh_destroy(mesh);
}

static void unusable_normals_are_mended(void **state)
{
    (void)state;
    const char *texts[] = {
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn nan 0 0\nvn 0 0 2\nf 1//1 2//1 3//2\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn inf 0 0\nf 1//1 2//1 3//1\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        glint_mesh *mesh = load(write_file("normals.obj", texts[i]));
        assert_int_equal(mesh->triangle_count, 1);
        expect_sound(mesh);
        for (size_t v = 0; v < mesh->vertex_count; v++)
            assert_true(mesh->normal[3 * v + 2] > 0.999f);
        glint_mesh_destroy(mesh);
    }
}

/* A cube without normals keeps its edges, its faces stay flat. */
static void sharp_edges_stay_sharp(void **state)
{
    (void)state;
    glint_mesh *mesh = load(write_file(
        "cube.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n"));
    assert_int_equal(mesh->triangle_count, 12);
    assert_int_equal(mesh->vertex_count, 24);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const glint_vec3 face = face_normal(mesh, i);
        for (size_t k = 0; k < 3; k++) {
            const float *n = &mesh->normal[3 * (size_t)mesh->index[3 * i + k]];
            assert_true(glint_vec3_dot(face, glint_vec3_of(n)) > 0.999);
        }
    }
    glint_mesh_destroy(mesh);
}

#define NODE(name, matrix)                                                                         \
    "<node id=\"" name "\"><matrix>" matrix "</matrix><instance_geometry url=\"#g\"/></node>"

#define COLLADA(nodes)                                                                             \
    "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "      \
    "version=\"1.4.1\"><asset><up_axis>Y_UP</up_axis></asset><library_geometries>"                 \
    "<geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"a\" count=\"9\">"                 \
    "0 0 0 1 0 0 0 1 0</float_array><technique_common><accessor source=\"#a\" count=\"3\" "        \
    "stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"            \
    "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>"                    \
    "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"                   \
    "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1 2</p>"   \
    "</triangles></mesh></geometry></library_geometries><library_visual_scenes>"                   \
    "<visual_scene id=\"s\">" nodes "</visual_scene></library_visual_scenes>"                      \
    "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>"

/* The nodes' transforms move, stretch and mirror; normals stay upright on the surface, and what is
 * mirrored is turned back to face outwards. */
static void transforms_are_applied(void **state)
{
    (void)state;
    glint_mesh *mesh =
        load(write_file("moved.dae", COLLADA(NODE("a", "3 0 0 10  0 1 0 20  0 0 1 30  0 0 0 1")
                                                 NODE("b", "1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1"))));
    expect_sound(mesh);
    assert_int_equal(mesh->triangle_count, 2);
    for (size_t i = 0; i < 6; i++) { /* 13 × 21 × 30 in all, of which 30 has become 2 */
        const glint_vec3 p = glint_vec3_of(&mesh->position[3 * (size_t)mesh->index[i]]);
        const double x = 15.0 * p.x + 6.5, y = 15.0 * p.y + 10.5, z = 15.0 * p.z + 15.0;
        const bool right = i == 1 || i == 4, above = i == 2 || i == 5;
        assert_float_equal(x, i < 3 ? (right ? 13.0 : 10.0) : (right ? 1.0 : 0.0), 1e-5);
        assert_float_equal(y, i < 3 ? (above ? 21.0 : 20.0) : (above ? 1.0 : 0.0), 1e-5);
        assert_float_equal(z, i < 3 ? 30.0 : 0.0, 1e-5);
    }
    assert_true(face_normal(mesh, 0).z > 0.0 && face_normal(mesh, 1).z > 0.0);
    glint_mesh_destroy(mesh);
    mesh =
        load(write_file("mirrored.dae", COLLADA(NODE("a", "-1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1"))));
    expect_sound(mesh);
    assert_true(face_normal(mesh, 0).z > 0.999);
    assert_true(agreement(mesh) == 1.0);
    glint_mesh_destroy(mesh);
    mesh =
        load(write_file("slanted.dae", COLLADA(NODE("a", "1 0 0 0  0 1 0 0  2 0 1 0  0 0 0 1"))));
    expect_sound(mesh);
    const glint_vec3 face = face_normal(mesh, 0);
    const glint_vec3 n = glint_vec3_of(mesh->normal);
    assert_true(glint_vec3_dot(face, n) > 0.9999 * glint_vec3_length(face));
    glint_mesh_destroy(mesh);
}

static void expect_refused(const char *path, glint_status expected)
{
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    const glint_status status = glint_mesh_load(path, NULL, &mesh, &err);
    print_message("%s\n", err.text);
    assert_int_equal(status, expected);
    assert_null(mesh);
    assert_non_null(strstr(err.text, path));
    assert_null(strchr(err.text, '\n'));
}

#define PLY(last, face)                                                                            \
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"                \
    "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"         \
    "0 0 0\n1 0 0\n" last "\n" face "\n"

static void bad_files_are_refused(void **state)
{
    (void)state;
    const struct {
        const char *name, *text;
    } files[] = {
        {"empty.obj", ""},
        {"text.obj", "good morning\n"},
        {"text.txt", "good morning\n"},
        {"noise.3ds", "good morning\n"},
        {"nan.obj", "v 0 0 0\nv 1 0 0\nv nan 1 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n"},
        {"infinite.obj", "v 0 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n"},
        {"beyond.obj", "v 0 0 0\nv 1 0 0\nv 0 1e39 0\nf 1 2 3\n"},
        {"huge.obj", "v 0 0 0\nv 1 0 0\nv 0 1e30 0\nf 1 2 3\n"},
        {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"},
        {"negative.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9\n"},
        {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\np 1 2 3\n"},
        {"line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"},
        {"flat.obj", "v 0 0 0\nv 1 0 0\nf 1 2 2\nf 1 1 1\n"},
        {"nan.ply", PLY("0 1 nan", "3 0 1 2")},
        {"index.ply", PLY("0 1 0", "3 0 1 7")},
        {"negative.ply", PLY("0 1 0", "3 0 1 -2")},
        {"nan.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                    "vertex 0 1 nan\nendloop\nendfacet\nendsolid a\n"},
        {"far.dae", COLLADA(NODE("a", "1e30 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1"))},
    };
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++)
        expect_refused(write_file(files[i].name, files[i].text), GLINT_BAD_INPUT);
    expect_refused(ASSIMP "OBJ/point_cloud.obj", GLINT_BAD_INPUT);
    expect_refused(scratch_directory, GLINT_BAD_INPUT);
    expect_refused(scratch_path("missing.obj"), GLINT_IO_ERROR);
    expect_refused("", GLINT_IO_ERROR);
}

/* assimp itself fails on these: an index it does not check, a header that it never finds the end
 * of. Only the reading process is lost, not its parent. */
static void assimps_own_failures_are_messages(void **state)
{
    (void)state;
    const struct {
        const char *name, *text, *said;
        glint_status status;
    } files[] = {
        {"index.ase",
         "*3DSMAX_ASCIIEXPORT 200\n*GEOMOBJECT {\n*NODE_NAME \"a\"\n*MESH {\n*MESH_NUMVERTEX 3\n"
         "*MESH_NUMFACES 1\n*MESH_VERTEX_LIST {\n*MESH_VERTEX 0 0 0 0\n*MESH_VERTEX 1 1 0 0\n"
         "*MESH_VERTEX 2 0 1 0\n}\n*MESH_FACE_LIST {\n"
         "*MESH_FACE 0: A: 0 B: 1 C: 999999999 AB: 1 BC: 1 CA: 1\n}\n}\n}\n",
         "assimp crashed", GLINT_BAD_INPUT},
        {"cut.smd", "version 1\nnodes\n", "assimp was stopped after 5 s", GLINT_BAD_INPUT},
    };
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        glint_mesh *mesh = NULL;
        glint_error err = {""};
        const char *path = write_file(files[i].name, files[i].text);
        assert_int_equal(glint_mesh_load(path, NULL, &mesh, &err), files[i].status);
        assert_null(mesh);
        assert_non_null(strstr(err.text, path));
        assert_non_null(strstr(err.text, files[i].said));
    }
}

/* The address space left is too small for what the file needs. */
static void too_little_memory_is_a_message(void **state)
{
    (void)state;
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    const glint_load_limits limits = {.seconds = 20, .bytes = 1 << 20};
#ifdef __SANITIZE_ADDRESS__
    skip(); /* its allocator ends the process instead of throwing */
#endif
    assert_int_equal(glint_mesh_load_within(GLMARK "bunny.obj", &limits, NULL, &mesh, &err),
                     GLINT_NO_MEMORY);
    assert_null(mesh);
    assert_non_null(strstr(err.text, "bunny.obj: not enough memory"));
}

static void a_reader_can_be_stopped(void **state)
{
    (void)state;
    static const volatile bool stop = true;
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    const char *path = write_file("endless.smd", "version 1\nnodes\n");
    assert_int_equal(glint_mesh_load(path, &stop, &mesh, &err), GLINT_INTERRUPTED);
    assert_null(mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(too_little_memory_is_a_message), /* first: others leave free memory */
        cmocka_unit_test(real_meshes_are_sound),
        cmocka_unit_test(one_mesh_in_three_formats),
        cmocka_unit_test(polygons_are_cut_points_and_lines_dropped),
        cmocka_unit_test(unusable_normals_are_mended),
        cmocka_unit_test(sharp_edges_stay_sharp),
        cmocka_unit_test(transforms_are_applied),
        cmocka_unit_test(bad_files_are_refused),
        cmocka_unit_test(assimps_own_failures_are_messages),
        cmocka_unit_test(a_reader_can_be_stopped),
    };
    return cmocka_run_group_tests_name("import", tests, scratch_make, scratch_remove);
}
