/* `glint bench`: fragments, divisions, clocks and frames per second, with ratios, in one run. */
#define _POSIX_C_SOURCE 200809L

#include <inttypes.h>
#include <stdio.h>
#include <unistd.h>

#include "bench/bench.h"
#include "circuit/circuits.h"
#include "circuit/units.h"
#include "cli/build_first.h"
#include "cli/circuit_options.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "render/render.h"

typedef struct bench_options {
    double seconds;
    int64_t threads;
    int device; /* of the highlight units */
    const char *devices[GLINT_BENCH_UNITS + 1];
    const char *verilog;
    bool json;
} bench_options;

typedef struct bench_results {
    glint_bench_rates points;
    glint_bench_formula_rates formulas;
    glint_bench_divider_rates dividers;
    glint_bench_unit_rates units;
    glint_bench_frame frames[GLINT_BENCH_FRAMES];
} bench_results;

/* What --device names: its standard setting. */
static glint_setting device_of(const bench_options *chosen)
{
    glint_setting setting = glint_bench_unit_setting(chosen->device, 0);
    setting.verilog = chosen->verilog;
    return setting;
}

static int parse(int argc, char **argv, bench_options *chosen)
{
    for (int unit = 0; unit < GLINT_BENCH_UNITS; unit++)
        chosen->devices[unit] = glint_bench_unit_setting(unit, 0).circuit->name;
    const glint_option options[] = {
        {.name = "seconds",
         .placeholder = "S",
         .help = "how long to measure each candidate",
         .kind = GLINT_OPTION_REAL,
         .real = {&chosen->seconds, 0.01, 60.0}},
        {.name = "threads",
         .usually = "one per processor",
         .help = "for the frames; the kernels run on one",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->threads, 1, GLINT_THREADS_MAX}},
        {.name = "device",
         .placeholder = "NAME",
         .help = "the highlight unit of the points and frames: specular, power, or a rival",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->device, chosen->devices}},
        GLINT_RTL_OPTION(&chosen->verilog),
        {.name = "json",
         .help = "print the figures as JSON",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    static const glint_example examples[] = {
        {"a quick look", "glint bench --seconds 0.05"},
        {"the accurate device", "glint bench --device power --seconds 0.05"},
        {"for a script, frames on one thread", "glint bench --seconds 0.05 --threads 1 --json"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "bench",
        .summary = "Measures the C model, the Verilated circuit at each lane count, powf, pow and "
                   "Schlick's formula side by side; then every formula that approximates cos^n, "
                   "scalar and vectorised; every highlight unit, in C and in Verilog; the divider, "
                   "in C and in both forms of its circuit, "
                   "against the machine's own division; and whole frames with each backend and by "
                   "OpenGL in software.",
        .examples = examples,
        .options = options,
        .option_count = sizeof options / sizeof options[0],
    };
    return glint_options_parse(&line, argc, argv);
}

/* The lane count that shades most points a second. */
static int best_rtl(const glint_bench_rates *rates)
{
    int best = GLINT_BENCH_RTL_1;
    for (int i = GLINT_BENCH_RTL_1; i < GLINT_BENCH_CANDIDATES; i++)
        if (rates->points[i] > rates->points[best])
            best = i;
    return best;
}

static void print_kernels(const glint_circuit *device, const glint_bench_rates *rates)
{
    const int only = glint_highlight_only_n(device, 0); /* --device names standard settings */
    printf("points: %s, n = %d, cosines %.1f to 1, one thread; million points per second, ratio to "
           "powf\n",
           device->name, only != 0 ? only : GLINT_BENCH_N, GLINT_BENCH_LOWEST);
    for (int i = 0; i < GLINT_BENCH_CANDIDATES; i++) {
        printf("  %-16s %9.1f %8.2f", glint_bench_name((glint_bench_candidate)i),
               rates->points[i] * 1e-6, rates->to_powf[i]);
        if (rates->lanes[i] != 0)
            printf("   %6.1f million clocks per second", rates->points[i] * 1e-6 / rates->lanes[i]);
        printf("\n");
    }
    printf("C batch to powf %.1f, best RTL (%d lanes) to powf %.2f\n",
           rates->to_powf[GLINT_BENCH_C_BATCH], rates->lanes[best_rtl(rates)],
           rates->to_powf[best_rtl(rates)]);
}

static void print_formulas(const glint_bench_formula_rates *rates)
{
    printf("formulas: the same points; %s;\nmillion points per second, scalar and vectorised, each "
           "with its ratio to Schlick's formula\n",
           glint_formula_flags());
    for (int i = 0; i < GLINT_FORMULA_COUNT; i++)
        printf("  %-16s %9.1f %8.2f %12.1f %8.2f\n", glint_formula_names[i],
               rates->scalar[i] * 1e-6, rates->scalar_to_schlick[i], rates->vectorised[i] * 1e-6,
               rates->vectorised_to_schlick[i]);
}

static void print_units(const glint_bench_unit_rates *rates)
{
    printf("highlight units: the same points, one thread; million points per second of the C "
           "batch, of the\nVerilog with 1 lane and with 4, each with its ratio to the specular "
           "device's\n");
    for (int unit = 0; unit < rates->count; unit++) {
        printf("  %-16s", rates->name[unit]);
        for (int way = 0; way < GLINT_BENCH_UNIT_WAYS; way++)
            printf(" %9.1f %6.2f", rates->points[unit][way] * 1e-6, rates->to_specular[unit][way]);
        printf("\n");
    }
}

static void print_dividers(const glint_bench_divider_rates *rates)
{
    printf("divisions: %d shifts, k 1 to %d, one thread; million components per second, ratios "
           "to the machine's integer and float division\n",
           GLINT_BENCH_SHIFTS, GLINT_DIVIDER_K_MAX);
    for (int i = 0; i < GLINT_BENCH_DIVIDERS; i++) {
        printf("  %-16s %9.1f %8.3f %8.3f", glint_bench_divider_name((glint_bench_divider)i),
               rates->divisions[i] * 1e-6, rates->to_integer[i], rates->to_float[i]);
        if (rates->clocks[i] > 0.0)
            printf("   %6.1f million clocks per second", rates->clocks[i] * 1e-6);
        printf("\n");
    }
}

/* Frames a second against the C model's, of the same model and size. */
static double ratio_to_c(const glint_bench_frame *frames, int i)
{
    int c = i;
    while (frames[c].backend != GLINT_BACKEND_C)
        c--; /* the backends of a model and size stand in their order, c first */
    return frames[i].frames / frames[c].frames;
}

static const char *backend_name(const glint_bench_frame *frame)
{
    return frame->backend == GLINT_BENCH_GL ? "gl" : glint_backend_names[frame->backend];
}

static void print_frame(const glint_bench_frame *frame, double ratio)
{
    printf("  %-7s %4dx%-5d %-5s", frame->model, frame->width, frame->height, backend_name(frame));
    if (frame->missing[0] != '\0') {
        printf(" %s\n", frame->missing);
        return;
    }
    printf(" %8.1f frames/s %6.2f, %8" PRIu64 " fragments, %6.1f million fragments/s\n",
           frame->frames, ratio, frame->fragments, frame->frames * (double)frame->fragments * 1e-6);
}

static void print_frames(const char *device, const glint_bench_frame *frames, int threads)
{
    printf("frames: %s, %d thread%s, every fragment through the backend; ratio to the C model\n"
           "  (gl: OpenGL by Mesa in software, specular's formula in a shader)\n",
           device, threads, threads == 1 ? "" : "s");
    for (int i = 0; i < GLINT_BENCH_FRAMES; i++)
        print_frame(&frames[i], ratio_to_c(frames, i));
}

static void add_kernels(json_t *json, const glint_bench_rates *rates)
{
    json_t *list = glint_json_add(json, "points", json_array());
    for (int i = 0; i < GLINT_BENCH_CANDIDATES; i++) {
        json_t *entry = json_object();
        glint_json_add_text(entry, "name", glint_bench_name((glint_bench_candidate)i));
        glint_json_add_number(entry, "million_points_per_second", rates->points[i] * 1e-6);
        glint_json_add_number(entry, "ratio_to_powf", rates->to_powf[i]);
        if (rates->lanes[i] != 0) {
            glint_json_add_number(entry, "lanes", rates->lanes[i]);
            glint_json_add_number(entry, "million_clocks_per_second",
                                  rates->points[i] * 1e-6 / rates->lanes[i]);
        }
        json_array_append_new(list, entry);
    }
    json_t *ratios = glint_json_add(json, "ratios", json_object());
    glint_json_add_number(ratios, "c_batch_to_powf", rates->to_powf[GLINT_BENCH_C_BATCH]);
    glint_json_add_number(ratios, "best_rtl_to_powf", rates->to_powf[best_rtl(rates)]);
    glint_json_add_number(ratios, "best_rtl_lanes", rates->lanes[best_rtl(rates)]);
}

static void add_formulas(json_t *json, const glint_bench_formula_rates *rates)
{
    json_t *formulas = glint_json_add(json, "formulas", json_object());
    glint_json_add_text(formulas, "compiled", glint_formula_flags());
    json_t *list = glint_json_add(formulas, "loops", json_array());
    for (int i = 0; i < GLINT_FORMULA_COUNT; i++) {
        json_t *entry = json_object();
        glint_json_add_text(entry, "name", glint_formula_names[i]);
        glint_json_add_number(entry, "million_points_per_second_scalar", rates->scalar[i] * 1e-6);
        glint_json_add_number(entry, "million_points_per_second_vectorised",
                              rates->vectorised[i] * 1e-6);
        glint_json_add_number(entry, "scalar_ratio_to_schlick", rates->scalar_to_schlick[i]);
        glint_json_add_number(entry, "vectorised_ratio_to_schlick",
                              rates->vectorised_to_schlick[i]);
        json_array_append_new(list, entry);
    }
}

static void add_units(json_t *json, const glint_bench_unit_rates *rates)
{
    static const char *const keys[GLINT_BENCH_UNIT_WAYS][2] = {
        {"million_points_per_second_c", "c_ratio_to_specular"},
        {"million_points_per_second_rtl_1", "rtl_1_ratio_to_specular"},
        {"million_points_per_second_rtl_4", "rtl_4_ratio_to_specular"}};
    json_t *list = glint_json_add(json, "units", json_array());
    for (int unit = 0; unit < rates->count; unit++) {
        json_t *entry = json_object();
        glint_json_add_text(entry, "name", rates->name[unit]);
        for (int way = 0; way < GLINT_BENCH_UNIT_WAYS; way++) {
            glint_json_add_number(entry, keys[way][0], rates->points[unit][way] * 1e-6);
            glint_json_add_number(entry, keys[way][1], rates->to_specular[unit][way]);
        }
        json_array_append_new(list, entry);
    }
}

static void add_dividers(json_t *json, const glint_bench_divider_rates *rates)
{
    json_t *list = glint_json_add(json, "divisions", json_array());
    for (int i = 0; i < GLINT_BENCH_DIVIDERS; i++) {
        json_t *entry = json_object();
        glint_json_add_text(entry, "name", glint_bench_divider_name((glint_bench_divider)i));
        glint_json_add_number(entry, "million_divisions_per_second", rates->divisions[i] * 1e-6);
        glint_json_add_number(entry, "ratio_to_integer", rates->to_integer[i]);
        glint_json_add_number(entry, "ratio_to_float", rates->to_float[i]);
        if (rates->clocks[i] > 0.0)
            glint_json_add_number(entry, "million_clocks_per_second", rates->clocks[i] * 1e-6);
        json_array_append_new(list, entry);
    }
}

static void add_frames(json_t *json, const glint_bench_frame *frames)
{
    json_t *list = glint_json_add(json, "frames", json_array());
    for (int i = 0; i < GLINT_BENCH_FRAMES; i++) {
        json_t *entry = json_object();
        glint_json_add_text(entry, "model", frames[i].model);
        glint_json_add_number(entry, "width", frames[i].width);
        glint_json_add_number(entry, "height", frames[i].height);
        glint_json_add_text(entry, "backend", backend_name(&frames[i]));
        if (frames[i].missing[0] != '\0') {
            glint_json_add_text(entry, "missing", frames[i].missing);
        } else {
            glint_json_add_number(entry, "fragments", (double)frames[i].fragments);
            glint_json_add_number(entry, "frames_per_second", frames[i].frames);
            glint_json_add_number(entry, "ratio_to_c", ratio_to_c(frames, i));
        }
        json_array_append_new(list, entry);
    }
}

static bool print_json(const char *device, const bench_results *results, int threads)
{
    json_t *json = json_object();
    glint_json_add_text(json, "device", device);
    glint_json_add_number(json, "n", GLINT_BENCH_N);
    glint_json_add_number(json, "shifts", GLINT_BENCH_SHIFTS);
    glint_json_add_number(json, "threads", threads);
    add_kernels(json, &results->points);
    add_formulas(json, &results->formulas);
    add_units(json, &results->units);
    add_dividers(json, &results->dividers);
    add_frames(json, results->frames);
    return glint_output_json(json);
}

/* Each part is printed as soon as it is measured, unless all go into one JSON text. */
static glint_status measure(const bench_options *chosen, bench_results *results, glint_error *err)
{
    const volatile bool *stop = glint_stop_flag();
    const int threads = (int)chosen->threads;
    const glint_setting device = device_of(chosen);
    glint_status status =
        glint_bench_kernels(&device, chosen->seconds, stop, &results->points, err);
    if (status == GLINT_OK && !chosen->json) {
        print_kernels(device.circuit, &results->points);
        fflush(stdout);
    }
    if (status == GLINT_OK)
        status = glint_bench_formulas(chosen->seconds, stop, &results->formulas, err);
    if (status == GLINT_OK && !chosen->json) {
        print_formulas(&results->formulas);
        fflush(stdout);
    }
    if (status == GLINT_OK)
        status = glint_bench_units(chosen->verilog, chosen->seconds, stop, &results->units, err);
    if (status == GLINT_OK && !chosen->json) {
        print_units(&results->units);
        fflush(stdout);
    }
    if (status == GLINT_OK)
        status =
            glint_bench_dividers(chosen->verilog, chosen->seconds, stop, &results->dividers, err);
    if (status == GLINT_OK && !chosen->json) {
        print_dividers(&results->dividers);
        fflush(stdout);
    }
    if (status == GLINT_OK)
        status = glint_bench_frames(&device, threads, chosen->seconds, stop, results->frames, err);
    if (status == GLINT_OK && !chosen->json)
        print_frames(device.circuit->name, results->frames, threads);
    return status;
}

/* All circuits are measured, the divider in both forms. */
static int check_verilog(const bench_options *chosen)
{
    glint_setting settings[] = {
        device_of(chosen),
        glint_setting_divider(GLINT_DIVIDER_SEQUENTIAL, GLINT_BENCH_SHIFTS),
        glint_setting_divider(GLINT_DIVIDER_PIPELINED, GLINT_BENCH_SHIFTS),
    };
    int status = GLINT_OPTIONS_RUN;
    for (size_t i = 0; i < sizeof settings / sizeof settings[0] && status == GLINT_OPTIONS_RUN;
         i++) {
        settings[i].verilog = chosen->verilog;
        status = glint_rtl_option_check("bench", &settings[i]);
    }
    for (int unit = 0; unit < GLINT_BENCH_UNITS && status == GLINT_OPTIONS_RUN; unit++) {
        glint_setting setting = glint_bench_unit_setting(unit, 0);
        setting.verilog = chosen->verilog;
        if (glint_bench_unit_is_in(unit, chosen->verilog))
            status = glint_rtl_option_check("bench", &setting);
    }
    return status;
}

/* Build first: compilation must not count as measured time. */
static glint_status build(const bench_options *chosen, glint_error *err)
{
    glint_setting settings[GLINT_BENCH_CANDIDATES + 2 + 2 * GLINT_BENCH_UNITS];
    int count = 0;
    for (int lanes = 1; lanes <= 16; lanes *= 2)
        settings[count++] = glint_bench_unit_setting(chosen->device, lanes);
    settings[count++] = glint_setting_divider(GLINT_DIVIDER_SEQUENTIAL, GLINT_BENCH_SHIFTS);
    settings[count++] = glint_setting_divider(GLINT_DIVIDER_PIPELINED, GLINT_BENCH_SHIFTS);
    for (int unit = 0; unit < GLINT_BENCH_UNITS; unit++) {
        if (unit == chosen->device || !glint_bench_unit_is_in(unit, chosen->verilog))
            continue;
        settings[count++] = glint_bench_unit_setting(unit, 1);
        settings[count++] = glint_bench_unit_setting(unit, 4);
    }
    for (int i = 0; i < count; i++)
        settings[i].verilog = chosen->verilog;
    return glint_build_first("bench", settings, count, GLINT_RTL_FAST, 0, err);
}

static int bench(const bench_options *chosen)
{
    bench_results results;
    glint_error err;
    if (build(chosen, &err) != GLINT_OK || measure(chosen, &results, &err) != GLINT_OK)
        return glint_complain_error("bench", &err);
    if (chosen->json &&
        !print_json(chosen->devices[chosen->device], &results, (int)chosen->threads))
        return glint_complain("bench", GLINT_EXIT_TROUBLE, "out of memory");
    return GLINT_EXIT_OK;
}

int glint_cmd_bench(int argc, char **argv)
{
    bench_options chosen = {.seconds = 0.5, .threads = sysconf(_SC_NPROCESSORS_ONLN)};
    if (chosen.threads < 1)
        chosen.threads = 1;
    if (chosen.threads > GLINT_THREADS_MAX)
        chosen.threads = GLINT_THREADS_MAX;
    int status = parse(argc, argv, &chosen);
    if (status == GLINT_OPTIONS_RUN)
        status = check_verilog(&chosen);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    return glint_output_finish("bench", bench(&chosen));
}
