/* `glint compare`: how two pictures differ. */
#include <inttypes.h>
#include <math.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/picture.h"
#include "file/same.h"
#include "image/image.h"

typedef struct compare_options {
    const char *a, *b;
    const char *diff; /* NULL: no difference picture */
    bool json, force;
} compare_options;

static int parse(int argc, char **argv, compare_options *chosen)
{
    const glint_option options[] = {
        {.name = "diff",
         .placeholder = "FILE.png",
         .help = "write a picture of where and by how much they differ; - is standard output",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->diff},
        GLINT_FORCE_OPTION(&chosen->force),
        {.name = "json",
         .help = "print the result as JSON (psnr null: infinite)",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    const glint_positional positionals[] = {{.name = "A.png", .value = &chosen->a},
                                            {.name = "B.png", .value = &chosen->b}};
    static const glint_example examples[] = {
        {"compare two pictures", "glint compare a.png b.png"},
        {"and show where they differ", "glint compare a.png b.png --diff d.png"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "compare",
        .summary = "Compares two pictures of the same size, A being the reference: differing "
                   "pixels, the largest difference of any component, and NMSE and PSNR over the "
                   "object (where alpha is above 0 in either).",
        .details = GLINT_PICTURE_DETAILS,
        .done = "the pictures are equal",
        .different = "they differ",
        .examples = examples,
        .options = options,
        .option_count = sizeof options / sizeof options[0],
        .positionals = positionals,
        .positional_count = sizeof positionals / sizeof positionals[0],
    };
    return glint_options_parse(&line, argc, argv);
}

static bool equal(const glint_image_difference *difference)
{
    return difference->differing_pixels == 0 && difference->mask_pixels == 0;
}

static void print_text(FILE *out, const glint_image_difference *difference)
{
    glint_print_verdict(out, equal(difference), "%" PRIu64 " differing pixels",
                        difference->differing_pixels);
    fprintf(out, " of %" PRIu64 ", largest difference %d of 255\n", difference->pixels,
            difference->largest);
    if (difference->mask_pixels > 0) {
        fprintf(out, "%" PRIu64 " pixels belong to the object in one picture only\n",
                difference->mask_pixels);
    }
    if (!equal(difference))
        fprintf(out, "first at x=%d y=%d\n", difference->first_x, difference->first_y);
    fprintf(out, "over the object's %" PRIu64 " pixels: NMSE %.6g (%s), PSNR %.4g dB\n",
            difference->object_pixels, difference->nmse, glint_image_reading(difference->nmse),
            difference->psnr);
}

static bool print_json(const glint_image_difference *difference)
{
    json_t *json = json_object();
    json_object_set_new(json, "equal", json_boolean(equal(difference)));
    glint_json_add_number(json, "pixels", (double)difference->pixels);
    glint_json_add_number(json, "object_pixels", (double)difference->object_pixels);
    glint_json_add_number(json, "differing_pixels", (double)difference->differing_pixels);
    glint_json_add_number(json, "mask_pixels", (double)difference->mask_pixels);
    glint_json_add_number(json, "largest", difference->largest);
    glint_json_add_number(json, "first_x", difference->first_x);
    glint_json_add_number(json, "first_y", difference->first_y);
    glint_json_add_number(json, "nmse", difference->nmse);
    glint_json_add_number(json, "psnr", difference->psnr);
    return glint_output_json(json);
}

static glint_status write_difference(const glint_image *a, const glint_image *b, const char *path,
                                     glint_error *err)
{
    glint_image *picture;
    glint_status status = glint_image_difference_picture(a, b, &picture, err);
    if (status == GLINT_OK)
        status = glint_picture_write("compare", picture, path, err);
    glint_image_destroy(picture);
    return status;
}

/* Returns the exit status. */
static int report(const compare_options *chosen, const glint_image_difference *difference)
{
    if (!chosen->json)
        print_text(glint_picture_talk(chosen->diff), difference);
    else if (!print_json(difference))
        return glint_complain("compare", GLINT_EXIT_TROUBLE, "out of memory");
    return glint_output_finish("compare", equal(difference) ? GLINT_EXIT_OK : GLINT_EXIT_DIFFERENT);
}

int glint_cmd_compare(int argc, char **argv)
{
    compare_options chosen = {0};
    const int parsed = parse(argc, argv, &chosen);
    if (parsed != GLINT_OPTIONS_RUN)
        return parsed;
    if (chosen.diff != NULL &&
        (glint_file_same(chosen.diff, chosen.a) || glint_file_same(chosen.diff, chosen.b))) {
        return glint_complain("compare", GLINT_EXIT_TROUBLE,
                              "--diff: %s is one of the pictures being compared", chosen.diff);
    }
    glint_error err;
    if (chosen.diff != NULL && chosen.json && glint_picture_is_stdout(chosen.diff)) {
        return glint_complain("compare", GLINT_EXIT_TROUBLE,
                              "--json cannot be used with --diff -: both write to standard output");
    }
    if (chosen.diff != NULL &&
        glint_picture_check("diff", chosen.diff, chosen.force, &err) != GLINT_OK)
        return glint_complain_error("compare", &err);
    glint_image *a = NULL;
    glint_image *b = NULL;
    glint_image_difference difference;
    glint_status status = glint_image_read_png_until(chosen.a, glint_stop_flag(), &a, &err);
    if (status == GLINT_OK)
        status = glint_image_read_png_until(chosen.b, glint_stop_flag(), &b, &err);
    if (status == GLINT_OK)
        status = glint_image_compare(a, b, &difference, &err);
    if (status == GLINT_OK && chosen.diff != NULL)
        status = write_difference(a, b, chosen.diff, &err);
    glint_image_destroy(a);
    glint_image_destroy(b);
    return status == GLINT_OK ? report(&chosen, &difference)
                              : glint_complain_error("compare", &err);
}
