/* Meshes written and read again: corners keep their normals as far as smoothing groups can say
 * them, pictures stay the same, parts keep to the format's limits; another reader agrees; and what
 * the command refuses. */
#define _XOPEN_SOURCE 700

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../cli/run.h"
#include "../render/studio.h"
#include "convert/convert.h"
#include "convert/formats.h"
#include "render/mesh_build.h"
#include "render/smooth.h"

#define PI      3.14159265358979323846
#define DEGREES (180.0 / PI)

/* ---- Meshes ---------------------------------------------------------------------------------- */

static glint_mesh *new_mesh(size_t vertices, size_t triangles)
{
    glint_mesh *mesh = NULL;
    assert_int_equal(glint_mesh_new("test", vertices, triangles, &mesh, NULL), GLINT_OK);
    return mesh;
}

static uint32_t add(glint_mesh *mesh, double x, double y, double z, glint_vec3 normal)
{
    glint_mesh_add_vertex(mesh, (glint_vec3){x, y, z}, normal);
    return (uint32_t)mesh->vertex_count - 1;
}

/* Six sides with vertices of their own. */
static glint_mesh *cube(void)
{
    glint_mesh *mesh = new_mesh(24, 12);
    for (int side = 0; side < 6; side++) {
        const int axis = side / 2;
        const double sign = side % 2 == 0 ? 1.0 : -1.0;
        uint32_t corner[4];
        for (int i = 0; i < 4; i++) {
            const double u = i == 0 || i == 3 ? -1.0 : 1.0, v = (i < 2 ? -1.0 : 1.0) * sign;
            double p[3], n[3] = {0.0, 0.0, 0.0};
            p[axis] = n[axis] = sign;
            p[(axis + 1) % 3] = u;
            p[(axis + 2) % 3] = v;
            corner[i] = add(mesh, p[0], p[1], p[2], (glint_vec3){n[0], n[1], n[2]});
        }
        glint_mesh_add_triangle(mesh, corner[0], corner[1], corner[2]);
        glint_mesh_add_triangle(mesh, corner[0], corner[2], corner[3]);
    }
    return mesh;
}

#define SEGMENTS 64

/* A round side and two flat ends. */
static glint_mesh *cylinder(void)
{
    glint_mesh *mesh = new_mesh(4 * SEGMENTS + 2, 4 * SEGMENTS);
    const glint_vec3 up = {0, 1, 0}, down = {0, -1, 0};
    for (int i = 0; i < SEGMENTS; i++) {
        const double x = cos(2.0 * PI * i / SEGMENTS), z = -sin(2.0 * PI * i / SEGMENTS);
        (void)add(mesh, x, -1.0, z, (glint_vec3){x, 0.0, z});
        (void)add(mesh, x, 1.0, z, (glint_vec3){x, 0.0, z});
        (void)add(mesh, x, -1.0, z, down);
        (void)add(mesh, x, 1.0, z, up);
    }
    const uint32_t low = add(mesh, 0, -1, 0, down), high = add(mesh, 0, 1, 0, up);
    for (uint32_t i = 0; i < SEGMENTS; i++) {
        const uint32_t a = 4 * i, b = 4 * ((i + 1) % SEGMENTS);
        glint_mesh_add_triangle(mesh, a, b, b + 1);
        glint_mesh_add_triangle(mesh, a, b + 1, a + 1);
        glint_mesh_add_triangle(mesh, low, b + 2, a + 2);
        glint_mesh_add_triangle(mesh, high, a + 3, b + 3);
    }
    return mesh;
}

#define GRID 40

/* A sheet with a fold that is sharp at one end and ends before the other: its normals as a reader
 * of a file without normals makes them, by angle. */
static glint_mesh *fold(void)
{
    const size_t triangles = 2 * GRID * GRID;
    glint_mesh *mesh = new_mesh((GRID + 1) * (GRID + 1), triangles);
    for (int i = 0; i <= GRID; i++)
        for (int j = 0; j <= GRID; j++) {
            const double x = 2.0 * i / GRID - 1.0, z = 2.0 * j / GRID - 1.0;
            (void)add(mesh, x, fabs(x) * (z + 1.0), z, (glint_vec3){0, 0, 0});
        }
    for (uint32_t i = 0; i < GRID; i++)
        for (uint32_t j = 0; j < GRID; j++) {
            const uint32_t a = i * (GRID + 1) + j, b = a + GRID + 1;
            glint_mesh_add_triangle(mesh, a, a + 1, b + 1);
            glint_mesh_add_triangle(mesh, a, b + 1, b);
        }
    uint32_t *group = calloc(triangles, sizeof *group);
    assert_non_null(group);
    for (size_t i = 0; i < triangles; i++)
        group[i] = 1;
    const glint_smoothing smoothing = {.group = group, .creased = true};
    assert_int_equal(glint_smooth("test", &smoothing, &mesh, NULL), GLINT_OK);
    free(group);
    return mesh;
}

static glint_mesh *teapot(void)
{
    glint_mesh *mesh = NULL;
    assert_int_equal(glint_mesh_teapot(GLINT_TEAPOT_DENSITY, &mesh, NULL), GLINT_OK);
    return mesh;
}

static glint_mesh *sphere(int density)
{
    glint_mesh *mesh = NULL;
    assert_int_equal(glint_mesh_sphere(density, &mesh, NULL), GLINT_OK);
    return mesh;
}

/* ---- There and back -------------------------------------------------------------------------- */

static glint_converted convert(const glint_mesh *mesh, const char *name)
{
    glint_converted converted;
    glint_error err = {""};
    const glint_status status = glint_convert(mesh, scratch_path(name), NULL, &converted, &err);
    assert_string_equal(err.text, "");
    assert_int_equal(status, GLINT_OK);
    return converted;
}

static glint_mesh *load(const char *name)
{
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    const glint_status status = glint_mesh_load(scratch_path(name), NULL, &mesh, &err);
    assert_string_equal(err.text, "");
    assert_int_equal(status, GLINT_OK);
    assert_string_equal(mesh->remarks, "");
    return mesh;
}

static double angle_at(const glint_mesh *a, const glint_mesh *b, size_t corner)
{
    const glint_vec3 n = glint_vec3_of(&a->normal[3 * (size_t)a->index[corner]]);
    const glint_vec3 m = glint_vec3_of(&b->normal[3 * (size_t)b->index[corner]]);
    return DEGREES * atan2(glint_vec3_length(glint_vec3_cross(n, m)), glint_vec3_dot(n, m));
}

/* How many corners of the triangles, which are in the same order, have normals further apart. */
static size_t corners_beyond(const glint_mesh *a, const glint_mesh *b, double degrees)
{
    size_t count = 0;
    assert_int_equal(a->triangle_count, b->triangle_count);
    for (size_t i = 0; i < 3 * a->triangle_count; i++)
        count += angle_at(a, b, i) > degrees;
    return count;
}

static void cube_and_cylinder_keep_every_normal(void **state)
{
    (void)state;
    glint_mesh *meshes[] = {cube(), cylinder()};
    const size_t places[] = {8, 2 * SEGMENTS + 2};
    for (size_t i = 0; i < 2; i++) {
        const glint_converted converted = convert(meshes[i], "a.3ds");
        glint_mesh *read = load("a.3ds");
        assert_int_equal(converted.vertices, places[i]);
        assert_int_equal(converted.triangles, meshes[i]->triangle_count);
        assert_int_equal(converted.objects, 1);
        assert_int_equal(converted.groups, i == 0 ? 3 : 2); /* opposite sides, both ends: one */
        assert_int_equal(converted.unmarked, 0);
        assert_int_equal(corners_beyond(meshes[i], read, 0.05), 0);
        glint_mesh_destroy(read);
        glint_mesh_destroy(meshes[i]);
    }
}

/* Along the fold triangles on both sides are of one smooth sheet elsewhere, so one group for all of
 * it would not do. Where the fold ends an edge is smooth at one end and sharp at the other, which
 * no group can say: a few corners. */
static void a_fold_that_ends_stays_a_fold(void **state)
{
    (void)state;
    glint_mesh *mesh = fold();
    const glint_converted converted = convert(mesh, "fold.3ds");
    glint_mesh *read = load("fold.3ds");
    size_t sharp = 0;
    for (size_t i = 0; i < mesh->vertex_count; i++) /* of two normals at one place */
        sharp += i > 0 && memcmp(&mesh->position[3 * i], &mesh->position[3 * i - 3], 12) == 0;
    assert_true(sharp > GRID / 4);
    assert_true(converted.groups >= 2);
    assert_int_equal(converted.unmarked, 0);
    assert_true(corners_beyond(mesh, read, 5.0) <= 12);
    glint_mesh_destroy(mesh);
    glint_mesh_destroy(read);
}

static double nmse_of(const glint_mesh *a, const glint_mesh *b)
{
    glint_image_difference difference;
    studio first = open_studio(320, 240, 1, GLINT_BACKEND_REAL);
    studio second = open_studio(320, 240, 1, GLINT_BACKEND_REAL);
    glint_scene scene = {.mesh = a};
    glint_scene_defaults(&scene);
    shoot(&first, &scene);
    scene.mesh = b;
    shoot(&second, &scene);
    assert_int_equal(glint_image_compare(first.image, second.image, &difference, NULL), GLINT_OK);
    assert_true(difference.object_pixels > 10000);
    close_studio(&first);
    close_studio(&second);
    return difference.nmse;
}

/* Smooth meshes with exact normals come back with means of their triangles'. Against a mesh read
 * from a file that has normals: reading centres and scales. */
static void pictures_are_the_same(void **state)
{
    (void)state;
    static const char *const exact[] = {"b.ply", "b.obj", "b.glb"};
    glint_mesh *meshes[] = {teapot(), sphere(GLINT_SPHERE_DENSITY), cylinder()};
    static const double bounds[] = {2e-4, 1e-5, 1e-6};
    for (size_t i = 0; i < 3; i++) {
        const glint_converted converted = convert(meshes[i], "b.3ds");
        (void)convert(meshes[i], "b.ply");
        glint_mesh *with_normals = load("b.ply"), *read = load("b.3ds");
        assert_true(converted.vertices <= meshes[i]->vertex_count);
        const double nmse = nmse_of(with_normals, read);
        if (nmse > bounds[i])
            fail_msg("mesh %d: NMSE %g", (int)i, nmse);
        for (size_t k = 0; k < 3; k++) {
            (void)convert(meshes[i], exact[k]);
            glint_mesh *same = load(exact[k]);
            assert_true(nmse_of(with_normals, same) < 1e-7);
            glint_mesh_destroy(same);
        }
        glint_mesh_destroy(with_normals);
        glint_mesh_destroy(read);
        glint_mesh_destroy(meshes[i]);
    }
}

/* The comparison would notice lost edges, and lost smoothness. */
static void a_flat_file_is_noticed(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot();
    (void)convert(mesh, "f.stl");
    (void)convert(mesh, "f.ply");
    glint_mesh *flat = load("f.stl"), *with_normals = load("f.ply");
    assert_true(nmse_of(with_normals, flat) > 5e-4);
    glint_mesh_destroy(mesh);
    glint_mesh_destroy(flat);
    glint_mesh_destroy(with_normals);
}

/* ---- The file -------------------------------------------------------------------------------- */

/* What a walk over the chunks of a .3ds file finds. */
typedef struct found {
    size_t objects, vertices, triangles, groups;
    size_t most; /* vertices or triangles of one object */
} found;

static size_t number_at(const uint8_t *at, int bytes)
{
    size_t value = 0;
    for (int i = bytes; i-- > 0;)
        value = value << 8 | at[i];
    return value;
}

static size_t greater(size_t a, size_t b)
{
    return a > b ? a : b;
}

/* Every chunk ends where the one about it says. */
static void walk(const uint8_t *at, const uint8_t *end, found *f)
{
    while (at < end) {
        assert_true(end - at >= 6);
        const size_t kind = number_at(at, 2), size = number_at(at + 2, 4);
        assert_true(size >= 6 && size <= (size_t)(end - at));
        const uint8_t *inside = at + 6;
        const size_t count = size >= 8 ? number_at(inside, 2) : 0;
        at += size;
        switch (kind) {
        case 0x4000:
            f->objects++;
            inside += strlen((const char *)inside) + 1;
            walk(inside, at, f);
            break;
        case 0x4d4d:
        case 0x3d3d:
        case 0x4100:
            walk(inside, at, f);
            break;
        case 0x4110:
            assert_int_equal(size, 8 + 12 * count);
            f->vertices += count;
            f->most = greater(f->most, count);
            break;
        case 0x4120:
            f->triangles += count;
            f->most = greater(f->most, count);
            walk(inside + 2 + 8 * count, at, f);
            break;
        case 0x4150:
            f->groups += (size - 6) / 4;
            break;
        default:
            break;
        }
    }
}

static found walk_file(const char *name)
{
    size_t size;
    found f = {0};
    char *bytes = scratch_read(scratch_path(name), &size);
    walk((const uint8_t *)bytes, (const uint8_t *)bytes + size, &f);
    free(bytes);
    return f;
}

static void check_parts(const glint_mesh *mesh, size_t most)
{
    glint_error err = {""};
    glint_converted converted = {0};
    FILE *out = fopen(scratch_path("parts.3ds"), "wb");
    assert_non_null(out);
    assert_int_equal(glint_write_3ds(mesh, most, out, NULL, &converted, &err), GLINT_OK);
    assert_int_equal(fclose(out), 0);
    const found f = walk_file("parts.3ds");
    assert_true(f.most <= most && f.objects >= mesh->triangle_count / most);
    assert_int_equal(f.objects, converted.objects);
    assert_int_equal(f.vertices, converted.vertices);
    assert_int_equal(f.triangles, mesh->triangle_count);
    assert_int_equal(f.groups, mesh->triangle_count);
}

/* Between parts there is no smoothing: the seams show as little as a facet's angle. */
static void parts_keep_to_the_limit(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot();
    check_parts(mesh, 3);
    check_parts(mesh, 1000);
    (void)convert(mesh, "parts.ply");
    glint_mesh *with_normals = load("parts.ply"), *read = load("parts.3ds");
    assert_true(nmse_of(with_normals, read) < 1e-3);
    glint_mesh_destroy(with_normals);
    glint_mesh_destroy(read);
    glint_mesh_destroy(mesh);
    mesh = sphere(400); /* 159200 triangles */
    const glint_converted converted = convert(mesh, "large.3ds");
    const found f = walk_file("large.3ds");
    assert_int_equal(converted.objects, 3);
    assert_int_equal(f.objects, 3);
    assert_int_equal(f.most, GLINT_3DS_MAX);
    assert_int_equal(f.triangles, mesh->triangle_count);
    glint_mesh_destroy(mesh);
}

/* lib3ds shares nothing with assimp. It prints a line for each face, with its groups. */
static void lib3ds_reads_the_same(void **state)
{
    (void)state;
    char command[2200], line[256];
    size_t faces = 0, groups = 0;
    if (system("command -v 3dsdump >/dev/null 2>&1") != 0) {
        print_message("no 3dsdump: it is in lib3ds-dev\n");
        skip();
    }
    glint_mesh *mesh = cylinder();
    (void)convert(mesh, "c.3ds");
    (void)snprintf(command, sizeof command, "3dsdump -t '%s' >'%s'", scratch_path("c.3ds"),
                   scratch_path("dump"));
    assert_int_equal(system(command), 0);
    FILE *dump = fopen(scratch_path("dump"), "r");
    assert_non_null(dump);
    while (fgets(line, sizeof line, dump) != NULL) {
        unsigned a, b, c, smoothing;
        if (strstr(line, "vertices=") != NULL)
            assert_says(line, "object1 vertices=130 faces=256");
        if (sscanf(line, " %u %u %u smoothing:%u", &a, &b, &c, &smoothing) == 4) {
            faces++;
            groups |= smoothing;
        }
    }
    assert_int_equal(fclose(dump), 0);
    assert_int_equal(faces, mesh->triangle_count);
    assert_int_equal(groups, 3);
    glint_mesh_destroy(mesh);
}

/* ---- The command ----------------------------------------------------------------------------- */

static outcome command(const char *format, const char *in, const char *out)
{
    char line[2400], from[1024], to[1024];
    (void)snprintf(from, sizeof from, "%s", in);
    (void)snprintf(to, sizeof to, "%s", out);
    (void)snprintf(line, sizeof line, format, from, to);
    return run(line, "");
}

static void refused(const char *in, const char *out, const char *why)
{
    outcome done = command("convert %s %s", in, out);
    assert_outcome(&done, 2, NULL);
    assert_says(done.err, "glint convert: ");
    assert_says(done.err, why);
    assert_string_equal(strchr(done.err, '\n'), "\n"); /* one line */
    assert_string_equal(done.out, "");
    forget(&done);
}

static void the_command_says_what_it_wrote(void **state)
{
    (void)state;
    outcome done = command("convert %s %s --density 8", "sphere", scratch_path("s.3ds"));
    assert_outcome(&done, 0, "");
    assert_says(done.out, "sphere: 48 triangles, 26 vertices, 1 object, 1 smoothing group\nwrote ");
    forget(&done);
    done = command("convert %s %s --json", scratch_path("s.3ds"), scratch_path("t.glb"));
    assert_outcome(&done, 0, "");
    assert_says(done.out, "\"format\":\t\"glb\"");
    assert_says(done.out, "\"triangles\":\t48");
    assert_says(done.out, "\"objects\":\t1");
    forget(&done);
    done = command("render %s --size 64x48 --out %s", scratch_path("t.glb"), scratch_path("t.png"));
    assert_outcome(&done, 0, "");
    forget(&done);
}

static void what_cannot_be_written_is_refused(void **state)
{
    (void)state;
    const char *const text = "a text\n";
    scratch_write(scratch_path("text.3ds"), text, strlen(text));
    const int before = scratch_count();
    refused("teapot", scratch_path("a.xyz"),
            "meshes are written as .3ds, .obj, .ply, .stl or .glb");
    refused("teapot", scratch_path("none"), "use a name with one of these endings");
    refused("teapod", scratch_path("a.3ds"), "did you mean teapot?");
    refused("README.md", scratch_path("a.3ds"), "README.md");
    refused("teapot", scratch_path("text.3ds"), "exists and is not a 3DS mesh");
    refused("teapot", scratch_path("missing/a.3ds"), "No such file or directory");
    refused("quad", scratch_path("a.3ds --density 5"), "--density needs the teapot or the sphere");
    assert_true(scratch_count() <= before + 3); /* the three streams */
    char *kept = scratch_read(scratch_path("text.3ds"), NULL);
    assert_string_equal(kept, text);
    free(kept);
    outcome done = command("convert %s %s --force", "quad", scratch_path("text.3ds"));
    assert_outcome(&done, 0, "");
    forget(&done);
    refused(scratch_path("text.3ds"), scratch_path("text.3ds"), "is the model file itself");
    done = command("convert %s %s", "sphere", scratch_path("text.3ds")); /* a mesh by now */
    assert_outcome(&done, 0, "");
    forget(&done);
}

static void a_full_disk_leaves_nothing(void **state)
{
    (void)state;
    static const char *const names[] = {"full.3ds", "full.ply"};
    for (size_t i = 0; i < 2; i++) {
        assert_int_equal(symlink("/dev/full", scratch_path(names[i])), 0);
        refused("teapot", scratch_path(names[i]), "No space left on device");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cube_and_cylinder_keep_every_normal),
        cmocka_unit_test(a_fold_that_ends_stays_a_fold),
        cmocka_unit_test(pictures_are_the_same),
        cmocka_unit_test(a_flat_file_is_noticed),
        cmocka_unit_test(parts_keep_to_the_limit),
        cmocka_unit_test(lib3ds_reads_the_same),
        cmocka_unit_test(the_command_says_what_it_wrote),
        cmocka_unit_test(what_cannot_be_written_is_refused),
        cmocka_unit_test(a_full_disk_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
