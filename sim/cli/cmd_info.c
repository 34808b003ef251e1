/* `glint info`: every circuit, setting and number format, as this binary has them. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include <zlib.h>

#include "circuit/circuits.h"
#include "cli/circuit_options.h"
#include "cli/commands.h"
#include "cli/info_circuit.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/version.h"
#include "glint_divider_device.h"
#include "rtl/build.h"

/* A number of the device that other programs may want, under its JSON key. */
typedef struct fact {
    const char *key;
    int value;
    const char *meaning;
} fact;

static const fact facts[] = {
    {"cos_frac_bits", GLINT_COS_FRAC_BITS, "register 1, cos gamma: fraction bits of U1.f"},
    {"n_bits", GLINT_N_BITS, "register 2, n: bits"},
    {"sigma_int_bits", GLINT_SIGMA_INT_BITS, "ROM 33, sigma: integer bits"},
    {"sigma_frac_bits", GLINT_SIGMA_FRAC_BITS, "ROM 33, sigma: fraction bits"},
    {"adder6_frac_bits", GLINT_COS_FRAC_BITS, "adder 6, cos gamma - 1: fraction bits of S1.f"},
    {"t_int_bits", GLINT_T_INT_BITS, "multiplier 7, adder 8, t: integer bits, including the sign"},
    {"t_frac_bits", GLINT_T_FRAC_BITS, "multiplier 7, adder 8, t: fraction bits"},
    {"w_frac_bits", GLINT_W_FRAC_BITS, "multiplier 10, key block 12, W: fraction bits of U1.f"},
    {"w_drawn_int_bits", GLINT_W_DRAWN_INT_BITS, "multiplier 10 with gate drawn: integer bits"},
    {"color_bits", GLINT_COLOR_BITS, "registers 3-5, multipliers 13-15: bits"},
    {"drawn_limit", GLINT_DRAWN_LIMIT, "ROM 9 with gate drawn: limit of W, a code"},
    {"latency", GLINT_LATENCY_PIPELINED, "clocks, pipeline pipelined"},
    {"latency_combinational", GLINT_LATENCY_COMBINATIONAL, "clocks, pipeline combinational"},
    {"lanes_max", GLINT_LANES_MAX, "most cosines per clock"},
    {"divider_difference_bits", GLINT_DIVIDER_DIFFERENCE_BITS,
     "divider, difference: bits of S9.0, and integer bits of the quotient S9.n"},
    {"divider_shifts", GLINT_DIVIDER_SHIFTS_DEFAULT,
     "divider, number of shifts n by default: fraction bits of the quotient"},
    {"divider_shifts_min", GLINT_DIVIDER_SHIFTS_MIN, "divider, fewest shifts"},
    {"divider_shifts_max", GLINT_DIVIDER_SHIFTS_MAX, "divider, most shifts"},
    {"divider_k_max", GLINT_DIVIDER_K_MAX, "divider, longest span in the table"},
    {"divider_latency", GLINT_DIVIDER_SHIFTS_DEFAULT + 1,
     "divider, clocks with that many shifts: n + 1"},
};

#define FACT_COUNT (sizeof facts / sizeof facts[0])

/* CRC-32 (as in zlib) of a ROM's words, each as four bytes, the lowest first. */
static uint32_t rom_checksum(uint32_t (*word)(uint32_t n), uint32_t words)
{
    uLong crc = crc32(0, Z_NULL, 0);
    for (uint32_t n = 0; n < words; n++) {
        uint32_t value = word(n);
        const Bytef bytes[4] = {(Bytef)value, (Bytef)(value >> 8), (Bytef)(value >> 16),
                                (Bytef)(value >> 24)};
        crc = crc32(crc, bytes, sizeof bytes);
    }
    return (uint32_t)crc;
}

/* The divider's table from k = 0, which it does not hold, on. */
#define TABLE_WORDS (GLINT_DIVIDER_K_MAX + 1u)

static uint32_t table_word(uint32_t k)
{
    return glint_divider_bits(GLINT_DIVIDER_SHIFTS_DEFAULT, k);
}

static uint32_t rom9_word(uint32_t n)
{
    return glint_rom9(GLINT_GATE_COSINE, n);
}

/* NULL: there is none. To be freed. */
static char *simulator(void)
{
    char *version = NULL;
    return glint_rtl_verilator_version(&version, NULL) == GLINT_OK ? version : NULL;
}

static void print_simulator(void)
{
    char *version = simulator();
    printf("simulator  %s\n", version != NULL ? version : "none");
    free(version);
}

static void print_text(void)
{
    printf("glint %s, the specular-colour device and the shift-accumulate divider\n",
           GLINT_VERSION);
    printf("gates      cosine (default), sign, drawn\n");
    printf("pipelines  pipelined (default), combinational\n");
    for (size_t i = 0; i < FACT_COUNT; i++)
        printf("%-24s %5d  %s\n", facts[i].key, facts[i].value, facts[i].meaning);
    printf("rounding   half up, at multipliers 7, 10, 13, 14, 15\n");
    printf("ROM 33     %u words, CRC-32 %08" PRIx32 "\n", GLINT_N_COUNT,
           rom_checksum(glint_rom33, GLINT_N_COUNT));
    printf("ROM 9      %u words, CRC-32 %08" PRIx32 " (gate cosine)\n", GLINT_N_COUNT,
           rom_checksum(rom9_word, GLINT_N_COUNT));
    printf("table      of the divider, %u words, CRC-32 %08" PRIx32 " (%d shifts)\n", TABLE_WORDS,
           rom_checksum(table_word, TABLE_WORDS), GLINT_DIVIDER_SHIFTS_DEFAULT);
    print_simulator();
    const glint_circuit *circuit;
    for (int i = 0; (circuit = glint_circuit_number(i)) != NULL; i++)
        glint_info_print_circuit(circuit);
    printf("pins and signals: glint info --circuit NAME\n");
}

static void add_names(json_t *json, const char *key, const char *const *names)
{
    json_t *list = glint_json_add(json, key, json_array());
    for (int i = 0; names[i] != NULL; i++)
        json_array_append_new(list, glint_json_text_of(names[i]));
}

static void add_checksum(json_t *json, const char *key, uint32_t checksum)
{
    char text[9];
    (void)snprintf(text, sizeof text, "%08" PRIx32, checksum);
    glint_json_add_text(json, key, text);
}

/* The settings of the specular device that `verify` tries unasked. */
static void add_circuits(json_t *json)
{
    json_t *list = glint_json_add(json, "circuits", json_array());
    glint_setting setting;
    for (int i = 0; glint_setting_listed(&glint_circuit_specular, i, &setting); i++) {
        json_t *circuit = json_object();
        glint_info_add_values(circuit, &setting);
        json_array_append_new(list, circuit);
    }
}

static void add_descriptions(json_t *json)
{
    json_t *list = glint_json_add(json, "descriptions", json_array());
    const glint_circuit *circuit;
    for (int i = 0; (circuit = glint_circuit_number(i)) != NULL; i++) {
        const glint_setting setting = glint_setting_standard(circuit);
        json_array_append_new(list, glint_info_json(&setting));
    }
}

static bool print_json(void)
{
    json_t *json = json_object();
    glint_json_add_text(json, "version", GLINT_VERSION);
    add_names(json, "gates", glint_gate_names);
    add_names(json, "pipelines", glint_pipeline_names);
    add_names(json, "backends", glint_backend_names);
    for (size_t i = 0; i < FACT_COUNT; i++)
        glint_json_add_number(json, facts[i].key, facts[i].value);
    glint_json_add_text(json, "rounding", "half up");
    add_checksum(json, "rom33_crc32", rom_checksum(glint_rom33, GLINT_N_COUNT));
    add_checksum(json, "rom9_crc32", rom_checksum(rom9_word, GLINT_N_COUNT));
    add_checksum(json, "divider_table_crc32", rom_checksum(table_word, TABLE_WORDS));
    char *version = simulator();
    glint_json_add_text(json, "verilator", version != NULL ? version : "none");
    free(version);
    add_circuits(json);
    add_descriptions(json);
    return glint_output_json(json);
}

typedef struct info_options {
    glint_circuit_options circuits;
    bool json;
} info_options;

static const char *usual(const char *parameter)
{
    (void)parameter;
    return NULL;
}

static int parse(int argc, char **argv, info_options *chosen)
{
    const glint_circuit_use use = {
        .command = "info", .circuit = "specular", .one_circuit = true, .usual = usual};
    const int begun = glint_circuit_options_begin(&chosen->circuits, &use, argc, argv);
    if (begun != GLINT_OPTIONS_RUN)
        return begun;
    glint_option options[1 + GLINT_CIRCUIT_OPTIONS] = {
        {.name = "json", .help = "print JSON", .kind = GLINT_OPTION_FLAG, .flag = &chosen->json},
    };
    const size_t count = 1 + glint_circuit_options_add(&chosen->circuits, options + 1);
    static const glint_example examples[] = {
        {"this build", "glint info"},
        {"the same for a script", "glint info --json"},
        {"a circuit's pins and signals", "glint info --circuit divider --form sequential"},
        {NULL, NULL},
    };
    static const glint_example own[] = {
        {"its pins and signals", "glint --circuit-dir DIR info"},
        {"the same for a script", "glint --circuit-dir DIR info --json"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "info",
        .summary = "Prints the circuits with their parameters, number formats, latency and ROM "
                   "checksums, and the version of Verilator that builds them. Given a circuit, "
                   "prints its pins and signals for one setting.",
        .examples = chosen->circuits.is_own ? own : examples,
        .options = options,
        .option_count = count,
    };
    const int status = glint_options_parse(&line, argc, argv);
    return status == GLINT_OPTIONS_RUN ? glint_circuit_options_settle(&chosen->circuits) : status;
}

/* A circuit is named, or one of its settings, or where it is. */
static bool is_one_circuit(const glint_circuit_options *circuits)
{
    bool any = circuits->is_named || circuits->directory != NULL;
    for (int i = 0; i < circuits->parameter_count; i++)
        any |= circuits->parameter[i].text != NULL;
    return any;
}

static bool print(const info_options *chosen)
{
    const glint_setting setting = glint_circuit_options_first(&chosen->circuits, 0);
    if (!is_one_circuit(&chosen->circuits)) {
        if (chosen->json)
            return print_json();
        print_text();
    } else if (chosen->json) {
        return glint_output_json(glint_info_json(&setting));
    } else {
        glint_info_print_setting(&setting);
    }
    return true;
}

int glint_cmd_info(int argc, char **argv)
{
    info_options chosen = {.json = false};
    int status = parse(argc, argv, &chosen);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    status = print(&chosen) ? GLINT_EXIT_OK
                            : glint_complain("info", GLINT_EXIT_TROUBLE, "out of memory");
    return glint_output_finish("info", status);
}
