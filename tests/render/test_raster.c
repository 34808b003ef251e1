/* Coverage: the fill rule, clipping to frame and guard square, thin and huge triangles. Screen
 * coordinates are given directly, through a camera that maps x, y at depth 1 onto pixels. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "render/raster.h"
#include "render/setup.h"

#define WIDTH     64
#define HEIGHT    48
#define CORNERS   512
#define TRIANGLES 512

static const glint_extent extent = {WIDTH, HEIGHT};

static const glint_camera screen_camera = {
    .right = {1, 0, 0},
    .up = {0, 1, 0},
    .back = {0, 0, 1},
    .scale = 1,
    .distance = 1,
    .focal = 1,
    .half_width = WIDTH / 2,
    .half_height = HEIGHT / 2,
};

/* Triangles in pixels, y down, and how often each pixel of the frame was covered by them. */
typedef struct scene {
    float position[3 * CORNERS], normal[3 * CORNERS];
    uint32_t index[3 * TRIANGLES];
    size_t corners, triangles;
    int covered[HEIGHT][WIDTH];
    size_t drawn; /* triangles that came through culling and clipping */
} scene;

static uint32_t corner(scene *s, double x, double y)
{
    const size_t at = s->corners++;
    assert_true(at < CORNERS);
    s->position[3 * at] = (float)(x - WIDTH / 2);
    s->position[3 * at + 1] = (float)(HEIGHT / 2 - y);
    s->position[3 * at + 2] = 0.0f;
    s->normal[3 * at + 2] = 1.0f;
    return (uint32_t)at;
}

static double sign_of(const scene *s, uint32_t a, uint32_t b, uint32_t c)
{
    const float *p = &s->position[3 * (size_t)a];
    const float *q = &s->position[3 * (size_t)b];
    const float *r = &s->position[3 * (size_t)c];
    return (double)(q[0] - p[0]) * (double)(r[1] - p[1]) -
           (double)(q[1] - p[1]) * (double)(r[0] - p[0]);
}

/* Adds the triangle, wound to face the camera whatever the order of its corners. */
static void triangle(scene *s, uint32_t a, uint32_t b, uint32_t c)
{
    const bool front = sign_of(s, a, b, c) > 0.0;
    uint32_t *index = &s->index[3 * s->triangles++];
    assert_true(s->triangles <= TRIANGLES);
    index[0] = a;
    index[1] = front ? b : c;
    index[2] = front ? c : b;
}

static void count_band(scene *s, glint_visibility *band, const glint_triangle_list *list,
                       int32_t first_y)
{
    int32_t last_y = first_y + GLINT_BAND_ROWS - 1;
    last_y = last_y < HEIGHT ? last_y : HEIGHT - 1;
    glint_visibility_begin(band, extent, first_y, last_y);
    glint_visibility_draw(band, extent, list);
    for (int32_t y = first_y; y <= last_y; y++)
        for (int32_t x = 0; x < WIDTH; x++)
            s->covered[y][x] += band->triangle[(y - first_y) * WIDTH + x] != NULL;
}

/* Each triangle is drawn on its own, so that none hides another. */
static void count_coverage(scene *s, const glint_camera *camera)
{
    const glint_mesh mesh = {.vertex_count = s->corners,
                             .position = s->position,
                             .normal = s->normal,
                             .triangle_count = s->triangles,
                             .index = s->index};
    glint_screen_vertex *screen = calloc(s->corners, sizeof *screen);
    assert_non_null(screen);
    glint_setup_vertices(camera, &mesh, 0, s->corners, screen);
    glint_visibility band;
    glint_visibility_create(&band, WIDTH);
    glint_triangle_list list = {0};
    s->drawn = 0;
    memset(s->covered, 0, sizeof s->covered);
    for (size_t i = 0; i < s->triangles; i++) {
        assert_true(glint_setup_triangles(camera, &mesh, extent, screen, i, i + 1, &list));
        s->drawn += list.count;
        for (int32_t y = 0; y < HEIGHT; y += GLINT_BAND_ROWS)
            count_band(s, &band, &list, y);
    }
    free(list.triangle);
    glint_visibility_destroy(&band);
    free(screen);
}

static int total(const scene *s)
{
    int sum = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            sum += s->covered[y][x];
    return sum;
}

static void expect_all_once(const scene *s)
{
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            assert_int_equal(s->covered[y][x], 1);
}

static scene *new_scene(void)
{
    scene *s = calloc(1, sizeof *s);
    assert_non_null(s);
    return s;
}

static double random_unit(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) / 9007199254740992.0;
}

static void a_rectangle_takes_left_and_top(void **state)
{
    (void)state;
    /* Its border runs through samples: columns 2…9 and rows 3…6 are in, 10 and 7 are not. */
    scene *s = new_scene();
    const uint32_t a = corner(s, 2.5, 3.5);
    const uint32_t b = corner(s, 10.5, 3.5);
    const uint32_t c = corner(s, 10.5, 7.5);
    const uint32_t d = corner(s, 2.5, 7.5);
    triangle(s, a, b, c);
    triangle(s, a, c, d);
    count_coverage(s, &screen_camera);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            assert_int_equal(s->covered[y][x], x >= 2 && x < 10 && y >= 3 && y < 7);
    assert_int_equal(total(s), 32);
    free(s);
}

/* A grid over more than the frame whose inner points are shaken: each pixel has one triangle.
 * With `quantum` the points fall on samples and on lines through samples as often as may be. */
static void shaken_grid(uint64_t seed, double quantum)
{
    enum { COLUMNS = 14, ROWS = 12 };
    scene *s = new_scene();
    uint32_t at[ROWS + 1][COLUMNS + 1];
    for (int i = 0; i <= ROWS; i++) {
        for (int k = 0; k <= COLUMNS; k++) {
            double x = -6.0 + 76.0 * k / COLUMNS + 2.4 * random_unit(&seed);
            double y = -6.0 + 60.0 * i / ROWS + 2.2 * random_unit(&seed);
            if (quantum > 0.0) {
                x = floor(x / quantum) * quantum;
                y = floor(y / quantum) * quantum;
            }
            at[i][k] = corner(s, x, y);
        }
    }
    for (int i = 0; i < ROWS; i++) {
        for (int k = 0; k < COLUMNS; k++) {
            const bool falling = random_unit(&seed) < 0.5;
            triangle(s, at[i][k], at[i][k + 1], at[i + 1][falling ? k + 1 : k]);
            triangle(s, at[i + 1][k], at[i + 1][k + 1], at[i][falling ? k : k + 1]);
        }
    }
    count_coverage(s, &screen_camera);
    expect_all_once(s);
    free(s);
}

static void shared_edges_neither_gap_nor_overlap(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 40; seed++) {
        shaken_grid(seed, 0.0);
        shaken_grid(seed, 0.5);
        shaken_grid(seed, 1.0 / 16.0);
    }
}

static void fans_cover_once(void **state)
{
    (void)state;
    /* Spokes from a point within the frame to points beyond it, down to hair-thin triangles. */
    for (uint64_t seed = 1; seed <= 40; seed++) {
        scene *s = new_scene();
        uint64_t random = seed;
        const double x = floor(2.0 * WIDTH * random_unit(&random)) / 2.0;
        const double y = floor(2.0 * HEIGHT * random_unit(&random)) / 2.0;
        const uint32_t hub = corner(s, x, y);
        const int spokes = 3 + (int)(200.0 * random_unit(&random));
        for (int i = 0; i < spokes; i++) {
            const double angle = 6.283185307179586 * (i + 0.9 * random_unit(&random)) / spokes;
            corner(s, x + 400.0 * cos(angle), y + 400.0 * sin(angle));
        }
        for (int i = 0; spokes > 6 && i < spokes; i++)
            triangle(s, hub, hub + 1 + (uint32_t)i, hub + 1 + (uint32_t)((i + 1) % spokes));
        count_coverage(s, &screen_camera);
        if (spokes > 6) /* with few of them the angle between two may be beyond a half turn */
            expect_all_once(s);
        free(s);
    }
}

static void huge_triangles_are_clipped_to_the_guard(void **state)
{
    (void)state;
    /* Two triangles a hundred guard squares wide, with a diagonal through the frame. */
    const double far = 100.0 * GLINT_GUARD;
    for (int i = 0; i < 16; i++) {
        scene *s = new_scene();
        const double lean = (i - 8) * 1000.0 + 0.25;
        const uint32_t a = corner(s, -far, -far + lean);
        const uint32_t b = corner(s, far, -far);
        const uint32_t c = corner(s, far, far - lean);
        const uint32_t d = corner(s, -far, far);
        triangle(s, a, b, c);
        triangle(s, a, c, d);
        count_coverage(s, &screen_camera);
        assert_true(s->drawn >= 2);
        expect_all_once(s);
        free(s);
    }
}

/* What is left of a huge triangle after clipping has its edge where it was: a slanted line through
 * the frame, from far to the upper left to far to the lower right. */
static void a_clipped_edge_stays_in_place(void **state)
{
    (void)state;
    const double far = 40.0 * GLINT_GUARD;
    const struct {
        double x, y; /* direction of the edge */
    } edges[] = {{1.0, 0.01}, {1.0, 0.75}, {0.02, 1.0}, {-1.0, 0.5}, {-1.0, -0.3}, {0.1, -1.0}};
    for (size_t i = 0; i < sizeof edges / sizeof edges[0]; i++) {
        const double dx = edges[i].x;
        const double dy = edges[i].y;
        scene *s = new_scene();
        const uint32_t a = corner(s, 30.0 - far * dx, 20.0 - far * dy);
        const uint32_t b = corner(s, 30.0 + far * dx, 20.0 + far * dy);
        const uint32_t c = corner(s, 30.0 - far * dy, 20.0 + far * dx);
        triangle(s, a, b, c);
        count_coverage(s, &screen_camera);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                const double side = dx * (y + 0.5 - 20.0) - dy * (x + 0.5 - 30.0);
                assert_true(fabs(side) < 0.1 || s->covered[y][x] == (side > 0.0));
            }
        }
        free(s);
    }
}

static void the_back_is_culled(void **state)
{
    (void)state;
    scene *s = new_scene();
    const uint32_t a = corner(s, 4, 4);
    const uint32_t b = corner(s, 40, 4);
    const uint32_t c = corner(s, 4, 40);
    triangle(s, a, b, c);
    count_coverage(s, &screen_camera);
    assert_true(total(s) > 500);
    const uint32_t swap = s->index[1];
    s->index[1] = s->index[2];
    s->index[2] = swap;
    count_coverage(s, &screen_camera);
    assert_int_equal(s->drawn, 0);
    assert_int_equal(total(s), 0);
    free(s);
}

static void what_holds_no_sample_is_not_drawn(void **state)
{
    (void)state;
    scene *s = new_scene();
    const uint32_t a = corner(s, 10.6, 10.6);
    const uint32_t b = corner(s, 11.4, 10.6);
    const uint32_t c = corner(s, 11.0, 11.4);
    triangle(s, a, b, c); /* between the samples */
    const uint32_t d = corner(s, -30.0, 10.0);
    const uint32_t e = corner(s, -5.0, 10.0);
    const uint32_t f = corner(s, -5.0, 40.0);
    triangle(s, d, e, f); /* left of the frame */
    count_coverage(s, &screen_camera);
    assert_int_equal(s->drawn, 0);
    free(s);
}

static void a_wide_triangle_covers_its_inside(void **state)
{
    (void)state;
    scene *s = new_scene();
    const uint32_t a = corner(s, 0.0, 0.0);
    const uint32_t b = corner(s, 60.0, 11.0);
    const uint32_t c = corner(s, 7.0, 46.0);
    triangle(s, a, b, c);
    count_coverage(s, &screen_camera);
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            const double px = x + 0.5;
            const double py = y + 0.5;
            const double ab = 60.0 * py - 11.0 * px;
            const double bc = -53.0 * (py - 11.0) - 35.0 * (px - 60.0);
            const double ca = -7.0 * (py - 46.0) + 46.0 * (px - 7.0);
            assert_int_equal(s->covered[y][x], ab > 0.0 && bc > 0.0 && ca > 0.0);
        }
    }
    free(s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rectangle_takes_left_and_top),
        cmocka_unit_test(shared_edges_neither_gap_nor_overlap),
        cmocka_unit_test(fans_cover_once),
        cmocka_unit_test(huge_triangles_are_clipped_to_the_guard),
        cmocka_unit_test(a_clipped_edge_stays_in_place),
        cmocka_unit_test(the_back_is_culled),
        cmocka_unit_test(what_holds_no_sample_is_not_drawn),
        cmocka_unit_test(a_wide_triangle_covers_its_inside),
    };
    return cmocka_run_group_tests_name("raster", tests, NULL, NULL);
}
