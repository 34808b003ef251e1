/* `glint info`: every setting and number format of the device, as this binary has them. */
#include <inttypes.h>
#include <stdio.h>

#include <zlib.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/version.h"
#include "glint_divider_device.h"
#include "rtl/rtl.h"

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
    {"t_int_bits", GLINT_T_INT_BITS, "multiplier 7, adder 8, t: integer bits, the sign among them"},
    {"t_frac_bits", GLINT_T_FRAC_BITS, "multiplier 7, adder 8, t: fraction bits"},
    {"w_frac_bits", GLINT_W_FRAC_BITS, "multiplier 10, key block 12, W: fraction bits of U1.f"},
    {"w_drawn_int_bits", GLINT_W_DRAWN_INT_BITS, "multiplier 10 with gate drawn: integer bits"},
    {"color_bits", GLINT_COLOR_BITS, "registers 3-5, multipliers 13-15: bits"},
    {"drawn_limit", GLINT_DRAWN_LIMIT, "ROM 9 with gate drawn: limit of W, a code"},
    {"latency", GLINT_LATENCY_PIPELINED, "clocks, pipeline pipelined"},
    {"latency_combinational", GLINT_LATENCY_COMBINATIONAL, "clocks, pipeline combinational"},
    {"lanes_max", GLINT_LANES_MAX, "cosines a clock, at most"},
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
    printf("simulator  %s\n", glint_rtl_verilator_version());
    int circuits = 0;
    while (glint_rtl_built(circuits) != NULL)
        circuits++;
    printf("circuits   %d Verilated of the device: each gate, both pipelines, 1 to 16 lanes;\n"
           "           %d of the divider: both forms, each number of shifts\n",
           circuits,
           GLINT_DIVIDER_FORM_COUNT * (GLINT_DIVIDER_SHIFTS_MAX - GLINT_DIVIDER_SHIFTS_MIN + 1));
}

static void add_names(cJSON *json, const char *key, const char *const *names)
{
    cJSON *list = cJSON_AddArrayToObject(json, key);
    for (int i = 0; names[i] != NULL; i++)
        cJSON_AddItemToArray(list, cJSON_CreateString(names[i]));
}

static void add_checksum(cJSON *json, const char *key, uint32_t checksum)
{
    char text[9];
    (void)snprintf(text, sizeof text, "%08" PRIx32, checksum);
    cJSON_AddStringToObject(json, key, text);
}

static void add_circuits(cJSON *json)
{
    cJSON *list = cJSON_AddArrayToObject(json, "circuits");
    const glint_specular_config *config;
    for (int i = 0; (config = glint_rtl_built(i)) != NULL; i++) {
        cJSON *circuit = cJSON_CreateObject();
        cJSON_AddStringToObject(circuit, "gate", glint_gate_name(config->gate));
        cJSON_AddStringToObject(circuit, "pipeline", glint_pipeline_name(config->pipeline));
        cJSON_AddNumberToObject(circuit, "lanes", config->lanes);
        cJSON_AddItemToArray(list, circuit);
    }
}

static bool print_json(void)
{
    cJSON *json = cJSON_CreateObject();
    cJSON_AddStringToObject(json, "version", GLINT_VERSION);
    add_names(json, "gates", glint_gate_names);
    add_names(json, "pipelines", glint_pipeline_names);
    add_names(json, "backends", glint_backend_names);
    for (size_t i = 0; i < FACT_COUNT; i++)
        cJSON_AddNumberToObject(json, facts[i].key, facts[i].value);
    cJSON_AddStringToObject(json, "rounding", "half up");
    add_checksum(json, "rom33_crc32", rom_checksum(glint_rom33, GLINT_N_COUNT));
    add_checksum(json, "rom9_crc32", rom_checksum(rom9_word, GLINT_N_COUNT));
    add_checksum(json, "divider_table_crc32", rom_checksum(table_word, TABLE_WORDS));
    cJSON_AddStringToObject(json, "verilator", glint_rtl_verilator_version());
    add_circuits(json);
    return glint_output_json(json);
}

int glint_cmd_info(int argc, char **argv)
{
    bool as_json = false;
    const glint_option options[] = {
        {.name = "json", .help = "as JSON", .kind = GLINT_OPTION_FLAG, .flag = &as_json},
    };
    static const glint_example examples[] = {
        {"what this build is", "glint info"},
        {"the same for a script", "glint info --json"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "info",
        .summary = "Prints the circuits' settings, number formats, latency, ROM checksums, and the "
                   "Verilator that the circuits were built with.",
        .examples = examples,
        .options = options,
        .option_count = 1,
    };
    int status = glint_options_parse(&line, argc, argv);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    status = GLINT_EXIT_OK;
    if (!as_json)
        print_text();
    else if (!print_json())
        status = glint_complain("info", GLINT_EXIT_TROUBLE, "out of memory");
    return glint_output_finish("info", status);
}
