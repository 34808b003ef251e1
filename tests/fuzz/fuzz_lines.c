/* Fuzz targets: the command lines and the standard input of `glint eval` and `glint divide`, whole,
 * and the command line of `glint render`. The output must be well-formed for any input. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/render_options.h"
#include "file/json.h"
#include "fuzz.h"

#define OPTIONS_SIZE 512

/* Every row a line of `columns` numbers. */
static void expect_csv(const char *text, const char *header, int columns)
{
    FUZZ_EXPECT(strncmp(text, header, strlen(header)) == 0);
    for (const char *at = text + strlen(header); *at != '\0'; at++) {
        for (int i = 0; i < columns; i++) {
            char *end;
            FUZZ_EXPECT(isdigit((unsigned char)*at) || *at == '-');
            FUZZ_EXPECT(isfinite(strtod(at, &end)));
            FUZZ_EXPECT(*end == (i + 1 < columns ? ',' : '\n'));
            at = i + 1 < columns ? end + 1 : end;
        }
    }
}

static void expect_json(const char *text, int columns)
{
    json_t *array = json_loads(text, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    FUZZ_EXPECT(json_is_array(array));
    json_t *row;
    glint_json_each(row, array)
    {
        int numbers = 0;
        const char *name;
        json_t *value;
        json_object_foreach(row, name, value)
        {
            FUZZ_EXPECT(json_is_number(value));
            numbers++;
        }
        FUZZ_EXPECT(numbers == columns);
    }
    json_decref(array);
}

static int run_lines(int (*command)(int argc, char **argv), const char *name, const char *header,
                     int columns, const uint8_t *bytes, size_t count)
{
    char options[OPTIONS_SIZE];
    const size_t taken = fuzz_first_line(bytes, count, options, sizeof options);
    fuzz_run done = fuzz_command(command, name, options, bytes + taken, count - taken);
    fuzz_expect_outcome(&done, name);
    if (done.out[0] == '[')
        expect_json(done.out, columns);
    else if (strncmp(done.out, "Usage: ", 7) != 0 && done.out[0] != '\0')
        expect_csv(done.out, header, columns);
    fuzz_forget(&done);
    return 0;
}

int fuzz_eval(const uint8_t *bytes, size_t count)
{
    return run_lines(glint_cmd_eval, "eval", "n,cos_code,w_code,r,g,b\n", 6, bytes, count);
}

int fuzz_divide(const uint8_t *bytes, size_t count)
{
    return run_lines(glint_cmd_divide, "divide",
                     "difference,k,shifts,quotient_code,quotient,exact,error\n", 7, bytes, count);
}

static void expect_render_options(const glint_render_options *chosen)
{
    FUZZ_EXPECT(chosen->what.model != NULL && chosen->out != NULL);
    FUZZ_EXPECT(chosen->what.width >= 1 && chosen->what.width <= GLINT_IMAGE_SIDE_MAX);
    FUZZ_EXPECT(chosen->what.height >= 1 && chosen->what.height <= GLINT_IMAGE_SIDE_MAX);
    FUZZ_EXPECT(chosen->what.threads >= 1 && chosen->what.threads <= GLINT_THREADS_MAX);
    FUZZ_EXPECT(chosen->scene.fov >= GLINT_FOV_MIN && chosen->scene.fov <= GLINT_FOV_MAX);
    FUZZ_EXPECT(fabsf(chosen->scene.yaw) <= GLINT_ANGLE_MAX);
    FUZZ_EXPECT(chosen->scene.n <= 1023);
    FUZZ_EXPECT(chosen->scene.shading < GLINT_SHADING_COUNT);
    FUZZ_EXPECT(chosen->scene.specular < GLINT_REFLECTANCE_COUNT);
    FUZZ_EXPECT(!chosen->scene.by_model || chosen->backend.kind == GLINT_BACKEND_REAL);
    FUZZ_EXPECT(chosen->scene.f0 >= 0.0f && chosen->scene.f0 <= 1.0f);
}

/* In the place of glint_cmd_render(): the same reading, without the frame. */
static int read_render_options(int argc, char **argv)
{
    glint_render_options chosen;
    const int status = glint_render_options_parse(argc, argv, &chosen);
    if (status == GLINT_OPTIONS_RUN) {
        expect_render_options(&chosen);
        return 0;
    }
    return status;
}

int fuzz_render(const uint8_t *bytes, size_t count)
{
    char options[OPTIONS_SIZE];
    (void)fuzz_first_line(bytes, count, options, sizeof options);
    fuzz_run done = fuzz_command(read_render_options, "render", options, NULL, 0);
    fuzz_expect_outcome(&done, "render");
    fuzz_forget(&done);
    return 0;
}
