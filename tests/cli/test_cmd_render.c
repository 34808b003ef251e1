/* `glint render`: the files it writes, its output, and what it rejects. How a frame must look is
 * tested elsewhere. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/resource.h>
#include <time.h>

#include <cmocka.h>

#include "../scratch.h"
#include "file/json.h"
#include "image/image.h"
#include "reflectance/reflectance.h"
#include "run.h"

static outcome render(const char *name, const char *options)
{
    char command_line[2048];
    snprintf(command_line, sizeof command_line, "render --out %s%s%s", scratch_path(name),
             *options != '\0' ? " " : "", options);
    return run(command_line, "");
}

static glint_image *read_picture(const char *name)
{
    glint_error err;
    glint_image *image;
    if (glint_image_read_png(scratch_path(name), &image, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    return image;
}

/* Renders and reads the picture back; the run must have ended well. */
static glint_image *rendered(const char *options)
{
    outcome done = render("picture.png", options);
    assert_outcome(&done, 0, "");
    forget(&done);
    return read_picture("picture.png");
}

static uint64_t differing_pixels(const glint_image *a, const glint_image *b)
{
    glint_error err;
    glint_image_difference difference;
    assert_int_equal(glint_image_compare(a, b, &difference, &err), GLINT_OK);
    return difference.differing_pixels + difference.mask_pixels;
}

static void a_picture_of_the_size_asked_for(void **state)
{
    (void)state;
    const int before = scratch_count();
    glint_image *image = rendered("--size 160x90");
    assert_int_equal(image->width, 160);
    assert_int_equal(image->height, 90);
    int covered = 0;
    for (int i = 0; i < 160 * 90; i++)
        covered += image->object[i];
    assert_in_range(covered, 160 * 90 / 10, 160 * 90 - 1);
    assert_true(scratch_count() <= before + 4); /* the picture and the three streams */
    glint_image_destroy(image);
}

static void both_backends_are_equal(void **state)
{
    (void)state;
    static const char *const options[] = {
        "--backend both --size 200x150",
        "--backend both --size 200x150 --model sphere --gate sign --n 1023",
        "--backend both --size 200x150 --gate drawn --n 40",
        "--backend both --size 200x150 --pipeline combinational --threads 3 --lanes 1",
        "--backend both --size 200x150 --shading flat",
        "--backend both --size 200x150 --shading gouraud",
        "--backend both --size 200x150 --shading gouraud --shifts 6 --model quad",
        "--backend both --size 200x150 --shading gouraud-perspective --model sphere",
        "--backend both --size 200x150 --shading quadratic",
        "--backend both --size 200x150 --shading quadratic --fraction 8 --model quad",
        "--backend both --size 200x150 --shading quadratic --fraction 26 --threads 3",
        "--backend both --size 200x150 --shading quadratic-listing --slips factor,sign",
    };
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        outcome done = render("both.png", options[i]);
        assert_outcome(&done, 0, "");
        assert_says(done.out, "0 differing pixels of 30000\n");
        assert_says(done.out, "triangles");
        assert_says(done.out, "million fragments/s");
        assert_says(done.out, "\nc ");
        assert_says(done.out, "\nrtl ");
        forget(&done);
        glint_image_destroy(read_picture("both.png"));
        assert_int_equal(access(scratch_path("both-c.png"), F_OK), -1);
        assert_int_equal(access(scratch_path("both-diff.png"), F_OK), -1);
    }
}

/* On standard error, and the frame is made all the same. */
static void what_is_missing_is_said(void **state)
{
    (void)state;
    static const char text[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\nl 1 4\n";
    char options[1200], said[1200];
    scratch_write(scratch_path("line.obj"), text, sizeof text - 1);
    snprintf(options, sizeof options, "--size 20x20 --model %s", scratch_path("line.obj"));
    snprintf(said, sizeof said, "glint render: %s: 1 line left out\n", scratch_path("line.obj"));
    outcome done = render("missing.png", options);
    assert_outcome(&done, 0, said);
    assert_string_equal(done.err, said);
    forget(&done);
    done = render("missing.png", "--size 4x4 --distance 1000");
    assert_outcome(&done, 0, "glint render: the frame is empty: the object is outside it\n");
    assert_says(done.out, " 0 fragments");
    forget(&done);
}

/* Third-party meshes, from Debian's assimp-testmodels. */
static void foreign_meshes_are_equal_by_both_backends(void **state)
{
    (void)state;
    static const char *const meshes[] = {
        "/usr/share/assimp/models/OBJ/spider.obj",
        "/usr/share/assimp/models/3DS/fels.3ds",
    };
    for (size_t i = 0; i < sizeof meshes / sizeof meshes[0]; i++) {
        char options[256];
        for (int gouraud = 0; gouraud < 2; gouraud++) {
            snprintf(options, sizeof options, "--backend both --size 200x150 --model %s%s",
                     meshes[i], gouraud ? " --shading gouraud" : "");
            outcome done = render("mesh.png", options);
            assert_outcome(&done, 0, "");
            assert_says(done.out, "0 differing pixels of 30000\n");
            forget(&done);
        }
    }
}

static void each_option_changes_the_picture(void **state)
{
    (void)state;
    static const char *const changes[] = {
        "--model sphere",
        "--model quad",
        "--shading flat",
        "--shading gouraud",
        "--shading gouraud-perspective",
        "--shading quadratic",
        "--shading quadratic-listing",
        "--shading mixed",
        "--shading gouraud-4",
        "--shading cosine-linear",
        "--shading phong-unnormalised",
        "--shading phong-newton",
        "--shading reflection-map",
        "--density 2",
        "--gate drawn",
        "--n 5",
        "--color 0,0,255",
        "--highlight 0,255,0",
        "--light 1,0,0",
        "--ia 0.5",
        "--ia 255,0,0",
        "--ie 238,138,32",
        "--scene figure-3.9",
        "--scene listing",
        "--rotate 0,90,0",
        "--scale 0.5",
        "--scale 1,1,-1",
        "--move 0.2,0,0",
        "--ie 0.5",
        "--ka 0.9",
        "--kd 0.1",
        "--ks 0",
        "--yaw 90",
        "--pitch -40",
        "--fov 90",
        "--distance 8",
        "--light -1,1.2,-1.6",
    };
    glint_image *usual = rendered("--size 160x120");
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        char options[128];
        snprintf(options, sizeof options, "--size 160x120 %s", changes[i]);
        glint_image *changed = rendered(options);
        if (differing_pixels(usual, changed) == 0)
            fail_msg("%s changed nothing", changes[i]);
        glint_image_destroy(changed);
    }
    glint_image_destroy(usual);
}

static void a_color_is_the_same_in_every_form(void **state)
{
    (void)state;
    static const char *const forms[] = {"rgb:51,102,153", "#336699", "hsv:210,66.6666667,60",
                                        "cmyk:66.6666667,33.3333333,0,40"};
    glint_image *usual = rendered("--size 160x120 --color 51,102,153 --highlight 51,102,153");
    for (size_t i = 0; i < sizeof forms / sizeof forms[0]; i++) {
        char options[128];
        snprintf(options, sizeof options, "--size 160x120 --color %s --highlight %s", forms[i],
                 forms[i]);
        glint_image *same = rendered(options);
        assert_int_equal(differing_pixels(usual, same), 0);
        glint_image_destroy(same);
    }
    glint_image_destroy(usual);
}

/* Options that say the same. */
static void expect_same(const char *const pairs[][2], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        char options[256];
        glint_image *pair[2];
        for (int k = 0; k < 2; k++) {
            snprintf(options, sizeof options, "--size 160x120 %s", pairs[i][k]);
            pair[k] = rendered(options);
        }
        if (differing_pixels(pair[0], pair[1]) != 0)
            fail_msg("%s differs from %s", pairs[i][0], pairs[i][1]);
        glint_image_destroy(pair[0]);
        glint_image_destroy(pair[1]);
    }
}

static void light_is_the_same_in_every_form(void **state)
{
    (void)state;
    static const char *const pairs[][2] = {
        {"--ia 0.4 --ie 0.8", "--ia 102,102,102 --ie 204,204,204"},
        {"--ia 0 --ie 1", "--ia 0,0,0 --ie 255,255,255"},
        {"--scale 0.5", "--scale 0.5,0.5,0.5"},
        {"--rotate 0,0,0 --scale 1 --move 0,0,0 --scene default", ""},
    };
    expect_same(pairs, sizeof pairs / sizeof pairs[0]);
}

static void a_scene_stands_for_its_options_and_they_override_it(void **state)
{
    (void)state;
    static const char *const pairs[][2] = {
        {"--scene figure-3.9", "--n 100 --ia 0 --ie 238,138,32 --ka 1 --kd 0.5 --ks 0.5 --color "
                               "255,255,255 --highlight 255,255,255"},
        {"--scene listing", "--n 100 --ia 0 --ka 1 --kd 1 --ks 1 --color 238,138,32"},
        {"--scene listing --n 20 --ks 0.5 --color 0,0,255",
         "--n 20 --ia 0 --ka 1 --kd 1 --ks 0.5 --color 0,0,255"},
        {"--scene figure-3.9 --ie 1 --ia 0.5 --ka 0.5 --kd 0.25 --highlight 9,9,9",
         "--n 100 --ia 0.5 --ie 1 --ka 0.5 --kd 0.25 --ks 0.5 --color 255,255,255 --highlight "
         "9,9,9"},
    };
    expect_same(pairs, sizeof pairs / sizeof pairs[0]);
}

static void threads_lanes_and_pipeline_do_not_change_the_picture(void **state)
{
    (void)state;
    static const char *const same[] = {
        "--threads 1",
        "--threads 5",
        "--backend rtl --lanes 1",
        "--backend rtl",
        "--backend rtl --lanes 16 --threads 2",
        "--gate sign",
        "--backend rtl --pipeline combinational",
        "--shading phong",
    };
    glint_image *usual = rendered("--size 160x120");
    for (size_t i = 0; i < sizeof same / sizeof same[0]; i++) {
        char options[128];
        snprintf(options, sizeof options, "--size 160x120 %s", same[i]);
        glint_image *other = rendered(options);
        if (differing_pixels(usual, other) != 0)
            fail_msg("%s changed the picture", same[i]);
        glint_image_destroy(other);
    }
    glint_image_destroy(usual);
}

static void options_of_a_shading_change_its_picture(void **state)
{
    (void)state;
    static const char *const changes[][2] = {
        {"--shading mixed", "--shading mixed --delta 100"},
        {"--shading reflection-map", "--shading reflection-map --map 20"},
    };
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        char options[256];
        glint_image *pair[2];
        for (int k = 0; k < 2; k++) {
            snprintf(options, sizeof options, "--size 160x120 --density 6 %s", changes[i][k]);
            pair[k] = rendered(options);
        }
        assert_true(differing_pixels(pair[0], pair[1]) > 0);
        glint_image_destroy(pair[0]);
        glint_image_destroy(pair[1]);
    }
}

static void isc_says_what_it_saves(void **state)
{
    (void)state;
    outcome done = render("isc.png", "--size 160x120 --isc on");
    assert_outcome(&done, 0, "");
    assert_says(done.out, " triangles drawn / with a highlight\n");
    assert_says(done.out, "ISC: shading ");
    assert_says(done.out, "0 differing pixels of 19200\n");
    forget(&done);
    done = render("isc.png", "--force --size 160x120 --isc on --json");
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, 0, NULL);
    assert_non_null(json);
    const json_t *isc = json_object_get(json, "isc");
    assert_true(json_number_value(json_object_get(isc, "shading_seconds")) > 0.0);
    assert_true(json_number_value(json_object_get(isc, "shading_seconds_without")) > 0.0);
    assert_int_equal(json_integer_value(json_object_get(isc, "differing_pixels")), 0);
    const json_t *frame = json_array_get(json_object_get(json, "frames"), 0);
    const double shading = json_number_value(json_object_get(frame, "shading_seconds"));
    assert_true(shading > 0.0);
    json_decref(json);
    forget(&done);
}

static void few_shifts_change_a_gouraud_picture(void **state)
{
    (void)state;
    glint_image *usual = rendered("--size 160x120 --shading gouraud");
    glint_image *twelve = rendered("--size 160x120 --shading gouraud --shifts 12");
    glint_image *six = rendered("--size 160x120 --shading gouraud --shifts 6");
    assert_int_equal(differing_pixels(usual, twelve), 0);
    assert_true(differing_pixels(usual, six) > 0);
    glint_image_destroy(six);
    glint_image_destroy(twelve);
    glint_image_destroy(usual);
}

/* Every name in --help is accepted and reported; no two models give the same picture. */
static void every_model_that_help_names_is_rendered(void **state)
{
    (void)state;
    outcome help = run("render --help", "");
    assert_outcome(&help, 0, "");
    const char *begin = strstr(help.out, "one of");
    const char *end = strstr(help.out, "  --n N");
    assert_true(begin != NULL && end != NULL && begin < end);
    char names[1024];
    snprintf(names, sizeof names, "%.*s", (int)(end - begin - 6), begin + 6);
    glint_image *picture[64];
    int count = 0;
    for (char *rest, *name = strtok_r(names, " \n", &rest); name != NULL;
         name = strtok_r(NULL, " \n", &rest)) {
        char options[160];
        snprintf(options, sizeof options, "--size 160x120 --n 30 --backend real --specular %s",
                 name);
        outcome done = render("model.png", options);
        assert_outcome(&done, 0, "");
        assert_says(done.out, name);
        forget(&done);
        assert_true(count < 64);
        picture[count] = read_picture("model.png");
        for (int i = 0; i < count; i++)
            if (differing_pixels(picture[i], picture[count]) == 0 &&
                strcmp(name, "device") != 0) /* rounded as finely as these pictures show */
                fail_msg("%s makes the picture of model %d", name, i);
        count++;
    }
    assert_int_equal(count, GLINT_REFLECTANCE_COUNT);
    for (int i = 0; i < count; i++)
        glint_image_destroy(picture[i]);
    forget(&help);
}

/* A PNG by the name of another kind would open in no viewer. */
static void names_of_other_pictures_are_refused(void **state)
{
    (void)state;
    static const char *const names[] = {"a.jpg", "a.png.JPEG", "a.tiff", "plain.name"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        outcome done = render(names[i], "--size 16x16");
        assert_int_equal(done.status, 2);
        assert_says(done.err, ": pictures are written as PNG: use a name ending in .png\n");
        assert_int_equal(access(scratch_path(names[i]), F_OK), -1);
        forget(&done);
    }
}

static void models_that_do_not_fit_are_refused(void **state)
{
    (void)state;
    static const char *const refused[][2] = {
        {"--specular blinn",
         "--specular needs --backend real or gl: the other backends are the device itself\n"},
        {"--specular blinn --backend rtl",
         "--specular needs --backend real or gl: the other backends are the device itself\n"},
        {"--specular blinn --backend both",
         "--specular needs --backend real or gl: the other backends are the device itself\n"},
        {"--specular Blinn --backend real", "--specular: \"Blinn\" is not a reflectance model (did "
                                            "you mean blinn?); choose from lambert, "
                                            "phong, blinn, "},
        {"--f0 0.5", "--f0 needs --specular cook-torrance or torrance-sparrow\n"},
        {"--f0 0.5 --backend real --specular blinn",
         "--f0 needs --specular cook-torrance or torrance-sparrow\n"},
        {"--n 0 --backend real --specular quadratic",
         "model quadratic takes n from 1 to 1023 here, not 0\n"},
    };
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        outcome done = render("refused.png", refused[i][0]);
        assert_int_equal(done.status, 2);
        assert_says(done.err, "glint render: ");
        assert_says(done.err, refused[i][1]);
        assert_string_equal(done.out, "");
        assert_int_equal(access(scratch_path("refused.png"), F_OK), -1);
        forget(&done);
    }
    glint_image *dull = rendered("--size 80x60 --backend real --specular cook-torrance");
    glint_image *bright = rendered("--size 80x60 --backend real --specular cook-torrance --f0 0.9");
    assert_true(differing_pixels(dull, bright) > 100);
    glint_image_destroy(dull);
    glint_image_destroy(bright);
}

static void the_divisions_are_told_of(void **state)
{
    (void)state;
    outcome done = render("told.png", "--size 160x120 --shading gouraud --shifts 9");
    assert_outcome(&done, 0, "");
    assert_says(done.out, "\ngouraud: 14112 highlights, ");
    assert_says(done.out, " divisions with 9 shifts\n");
    forget(&done);
    done = render("told.png", "--size 160x120 --shading quadratic --fraction 9");
    assert_says(done.out, "quadratic: ");
    assert_says(done.out, " spans with 9 fraction bits\n");
    forget(&done);
    done = render("told.png", "--size 160x120 --shading gouraud --backend real");
    assert_outcome(&done, 0, "");
    assert_says(done.out, "\ngouraud: 14112 highlights\n");
    forget(&done);
    done = render("told.png", "--size 100x80 --shading gouraud --shifts 7 --json --backend both");
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    assert_string_equal(json_string_value(json_object_get(json, "shading")), "gouraud");
    assert_int_equal(json_integer_value(json_object_get(json, "shifts")), 7);
    assert_int_equal(json_integer_value(json_object_get(json, "highlights")), 14112);
    assert_true(json_integer_value(json_object_get(json, "divisions")) > 1000);
    json_decref(json);
    forget(&done);
}

static void json_gives_the_figures(void **state)
{
    (void)state;
    outcome done = render("json.png", "--json --backend both --size 100x80 --threads 2");
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    assert_string_equal(json_string_value(json_object_get(json, "model")), "teapot");
    assert_int_equal(json_integer_value(json_object_get(json, "width")), 100);
    assert_int_equal(json_integer_value(json_object_get(json, "height")), 80);
    assert_int_equal(json_integer_value(json_object_get(json, "threads")), 2);
    assert_true(json_integer_value(json_object_get(json, "triangles")) > 1000);
    assert_true(json_integer_value(json_object_get(json, "fragments")) > 500);
    const json_t *frames = json_object_get(json, "frames");
    assert_int_equal(json_array_size(frames), 2);
    assert_string_equal(json_string_value(json_object_get(json_array_get(frames, 1), "backend")),
                        "rtl");
    const json_t *comparison = json_object_get(json, "comparison");
    assert_int_equal(json_integer_value(json_object_get(comparison, "pixels")), 8000);
    assert_int_equal(json_integer_value(json_object_get(comparison, "differing_pixels")), 0);
    json_decref(json);
    forget(&done);
}

static void comparing_nothing_is_a_failure(void **state)
{
    (void)state;
    /* From inside the sphere only back faces are seen. */
    outcome done = render("empty.png", "--backend both --model sphere --distance 0.1 --size 9x9");
    assert_outcome(&done, 2, "glint render: nothing to compare: the object is outside the frame\n");
    forget(&done);
    assert_int_equal(access(scratch_path("empty.png"), F_OK), -1);
}

typedef struct failure {
    const char *options;
    int status;
    const char *err;
} failure;

static void what_cannot_be_rendered_is_named(void **state)
{
    (void)state;
    static const failure failures[] = {
        {"--light 0,0,0", 2, "light 0,0,0 has no direction\n"},
        {"--density 257", 2, "257"},
        {"--model sphere --density 5", 2, "5"},
        {"--model no-such-file.obj", 2, "no-such-file.obj"},
        {"--model Makefile", 2, "Makefile"},
        {"--model no-such-file.obj --density 4", 2, "--density needs the teapot or the sphere"},
        {"--model quad --density 4", 2, "--density needs the teapot or the sphere"},
        {"--shading", 2, "flat, gouraud, gouraud-perspective, "},
        {"--shading goraud", 2, "flat, gouraud, gouraud-perspective, "},
        {"--fraction 7", 2, "an integer from 8 to 26"},
        {"--fraction 27", 2, "an integer from 8 to 26"},
        {"--fraction 8", 2, "--fraction needs the span unit: --shading quadratic, "},
        {"--shading quadratic-listing --fraction 8", 2, "--fraction needs the span unit"},
        {"--shading quadratic --backend real --fraction 8", 2, "--fraction needs the span unit"},
        {"--shifts 8", 2, "--shifts needs the divider: --shading gouraud, gouraud-4 or mixed, "},
        {"--shading quadratic --shifts 8", 2, "--shifts needs the divider"},
        {"--shading gouraud --backend real --shifts 8", 2, "--shifts needs the divider"},
        {"--method trace --shifts 8", 2, "--shifts needs the divider"},
        {"--backend real --specular phong --gate sign", 2, "--gate is of the device: leave it"},
        {"--backend real --specular phong --lanes auto", 2, "--lanes is of the device"},
        {"--backend gl --gate cosine", 2, "--gate is of the device"},
        {"--backend gl --pipeline pipelined", 2, "--pipeline is of the device"},
        {"--backend gl --lanes 2", 2, "--lanes is of the device"},
        {"--backend gl --shading gouraud --shifts 8", 2, "--shifts needs the divider"},
        {"--backend gl --shader gold --shading flat", 2, "it needs --shading phong"},
        {"--backend real --shading wires --specular phong", 2,
         "--shading wires has no highlight: leave --specular out"},
        {"--backend real --shading normals --specular device", 2,
         "--shading normals has no highlight"},
        {"--slips all", 2, "--slips needs --shading quadratic-listing"},
        {"--shading quadratic --slips none", 2, "--slips needs --shading quadratic-listing"},
        {"--shading quadratic-listing --slips", 2, "--slips"},
        {"--shading quadratic-listing --slips factr", 2, "(did you mean factor?)"},
        {"--shading quadratic-listing --slips factor,,sign", 2, "not a slip of the listing"},
        {"--shading quadratic-listing --slips all,sign", 2, "not a slip of the listing"},
        {"--shifts 5", 2, "an integer from 6 to 16"},
        {"--shifts 17", 2, "an integer from 6 to 16"},
        {"--shifts 8.5", 2, "an integer from 6 to 16"},
    };
    for (size_t i = 0; i < sizeof failures / sizeof failures[0]; i++) {
        outcome done = render("never.png", failures[i].options);
        assert_outcome(&done, failures[i].status, NULL);
        assert_says(done.err, failures[i].err);
        assert_memory_equal(done.err, "glint render: ", 14);
        assert_int_equal(strchr(done.err, '\n') - done.err, strlen(done.err) - 1);
        assert_string_equal(done.out, "");
        assert_int_equal(access(scratch_path("never.png"), F_OK), -1);
        forget(&done);
    }
}

/* Seconds of a processor that the runs until now took. */
static double children_worked(void)
{
    struct rusage usage;
    assert_int_equal(getrusage(RUSAGE_CHILDREN, &usage), 0);
    return (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/* A model that takes long shows whether the target was tried first. */
static void an_unwritable_target_is_found_before_the_work(void **state)
{
    (void)state;
    const double before = children_worked();
    outcome done = render("no/such/a.png", "--model sphere --density 4096 --size 9000x9000");
    assert_outcome(&done, 2, NULL);
    assert_says(done.err, "no/such/a.png: No such file or directory\n");
    assert_true(children_worked() - before < 1.0);
    forget(&done);
    assert_int_equal(mkdir(scratch_path("directory.png"), 0777), 0);
    done = render("directory.png", "");
    assert_outcome(&done, 2, NULL);
    assert_says(done.err, ": Is a directory\n");
    forget(&done);
    done = run("render --size 100x100 --out /dev/full", "");
    assert_outcome(&done, 2, "glint render: cannot write /dev/full: No space left on device\n");
    forget(&done);
}

static void an_interrupt_leaves_no_file(void **state)
{
    (void)state;
    char out[1024];
    snprintf(out, sizeof out, "%s", scratch_path("interrupted.png"));
    char *argv[] = {(char *)(uintptr_t)glint_under_test(),
                    "render",
                    "--size",
                    "8000x8000",
                    "--backend",
                    "both",
                    "--threads",
                    "1",
                    "--out",
                    out,
                    NULL};
    pid_t child;
    posix_spawn_file_actions_t actions;
    const plumbing none = {0};
    scratch_write(scratch_path("stdin"), "", 0);
    scratch_write(scratch_path("stdout"), "", 0);
    scratch_write(scratch_path("stderr"), "", 0);
    connect_streams(&actions, &none);
    const int before = scratch_count();
    assert_int_equal(posix_spawn(&child, argv[0], &actions, NULL, argv, environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    /* Long enough to be at work, far too short to be done. */
    nanosleep(&(struct timespec){.tv_nsec = 300000000}, NULL);
    assert_int_equal(kill(child, SIGINT), 0);
    assert_int_equal(wait_for(child), 2);
    char *err = scratch_read(scratch_path("stderr"), NULL);
    assert_says(err, "interrupted\n");
    free(err);
    assert_int_equal(scratch_count(), before);
}

static void the_model_is_not_overwritten(void **state)
{
    (void)state;
    static const char text[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    char options[2048];
    scratch_write(scratch_path("kept.obj"), text, sizeof text - 1);
    (void)snprintf(options, sizeof options, "--model %s", scratch_path("./kept.obj"));
    outcome done = render("kept.obj", options);
    assert_int_equal(done.status, 2);
    assert_says(done.err, "is the model file itself");
    char *kept = scratch_read(scratch_path("kept.obj"), NULL);
    assert_string_equal(kept, text);
    free(kept);
    forget(&done);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_picture_of_the_size_asked_for),
        cmocka_unit_test(both_backends_are_equal),
        cmocka_unit_test(what_is_missing_is_said),
        cmocka_unit_test(foreign_meshes_are_equal_by_both_backends),
        cmocka_unit_test(each_option_changes_the_picture),
        cmocka_unit_test(a_color_is_the_same_in_every_form),
        cmocka_unit_test(light_is_the_same_in_every_form),
        cmocka_unit_test(a_scene_stands_for_its_options_and_they_override_it),
        cmocka_unit_test(threads_lanes_and_pipeline_do_not_change_the_picture),
        cmocka_unit_test(few_shifts_change_a_gouraud_picture),
        cmocka_unit_test(options_of_a_shading_change_its_picture),
        cmocka_unit_test(isc_says_what_it_saves),
        cmocka_unit_test(every_model_that_help_names_is_rendered),
        cmocka_unit_test(names_of_other_pictures_are_refused),
        cmocka_unit_test(models_that_do_not_fit_are_refused),
        cmocka_unit_test(the_divisions_are_told_of),
        cmocka_unit_test(json_gives_the_figures),
        cmocka_unit_test(comparing_nothing_is_a_failure),
        cmocka_unit_test(what_cannot_be_rendered_is_named),
        cmocka_unit_test(an_unwritable_target_is_found_before_the_work),
        cmocka_unit_test(an_interrupt_leaves_no_file),
        cmocka_unit_test(the_model_is_not_overwritten),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
