/* glint-gen: writes the files that are generated from the C model, so that a fact stands once.
 *
 *     glint-gen FILE KIND
 *
 * KIND: formats (rtl/glint_formats.vh), sigma-rom, limit-rom, reciprocal-rom (rtl/…_rom.v). FILE is
 * written beside, then renamed. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "glint_divider_device.h"
#include "glint_specular_device.h"

typedef void writer(FILE *out);

static void write_header(FILE *out, const char *what)
{
    fprintf(out, "// %s\n//\n// Made by glint-gen from cmodel/; `make generate` makes it anew.\n",
            what);
}

#define WRITE_CONSTANT(out, name) fprintf(out, "`define %s %ld\n", #name, (long)(name))

static void write_formats(FILE *out)
{
    write_header(out, "glint_formats: widths and binary points of the circuits.");
    fprintf(out, "`ifndef GLINT_FORMATS_VH\n`define GLINT_FORMATS_VH\n\n");
    WRITE_CONSTANT(out, GLINT_GATE_COSINE);
    WRITE_CONSTANT(out, GLINT_GATE_SIGN);
    WRITE_CONSTANT(out, GLINT_GATE_DRAWN);
    WRITE_CONSTANT(out, GLINT_COS_FRAC_BITS);
    WRITE_CONSTANT(out, GLINT_COS_BITS);
    WRITE_CONSTANT(out, GLINT_N_BITS);
    WRITE_CONSTANT(out, GLINT_SIGMA_FRAC_BITS);
    WRITE_CONSTANT(out, GLINT_SIGMA_BITS);
    WRITE_CONSTANT(out, GLINT_ADDER6_BITS);
    WRITE_CONSTANT(out, GLINT_T_INT_BITS);
    WRITE_CONSTANT(out, GLINT_T_FRAC_BITS);
    WRITE_CONSTANT(out, GLINT_T_BITS);
    WRITE_CONSTANT(out, GLINT_W_FRAC_BITS);
    WRITE_CONSTANT(out, GLINT_W_BITS);
    WRITE_CONSTANT(out, GLINT_W_DRAWN_INT_BITS);
    WRITE_CONSTANT(out, GLINT_W_DRAWN_BITS);
    WRITE_CONSTANT(out, GLINT_COLOR_BITS);
    fprintf(out, "`define GLINT_DRAWN_LIMIT %d'd%u\n", GLINT_COS_BITS, GLINT_DRAWN_LIMIT);
    WRITE_CONSTANT(out, GLINT_DIVIDER_SHIFTS_DEFAULT);
    WRITE_CONSTANT(out, GLINT_DIVIDER_K_BITS);
    WRITE_CONSTANT(out, GLINT_DIVIDER_K_MAX);
    WRITE_CONSTANT(out, GLINT_DIVIDER_DIFFERENCE_BITS);
    WRITE_CONSTANT(out, GLINT_DIVIDER_LEFT_BITS);
    fprintf(out, "\n`endif\n");
}

typedef struct rom {
    const char *module, *what, *output, *width_name;
    int width;
    uint32_t (*value)(uint32_t n);
} rom;

static uint32_t cosine_limit(uint32_t n)
{
    return glint_rom9(GLINT_GATE_COSINE, n);
}

static void write_rom(FILE *out, const rom *rom)
{
    write_header(out, rom->what);
    fprintf(out,
            "`default_nettype none\n`include \"glint_formats.vh\"\n\n"
            "module %s (\n"
            "    input  wire [`GLINT_N_BITS-1:0] n,\n"
            "    output reg  [`%s-1:0] %s\n"
            ");\n"
            "    always @*\n"
            "        case (n)\n",
            rom->module, rom->width_name, rom->output);
    for (uint32_t n = 0; n < GLINT_N_COUNT; n++)
        fprintf(out, "            %d'd%-4u: %s = %d'd%u;\n", GLINT_N_BITS, n, rom->output,
                rom->width, rom->value(n));
    fprintf(out, "        endcase\nendmodule\n\n`default_nettype wire\n");
}

static void write_sigma_rom(FILE *out)
{
    char what[320];
    (void)snprintf(what, sizeof what,
                   "sigma_rom: ROM 33 of figure 3.1, n -> sigma = (n+1)/3 as U%d.%d, rounded half "
                   "up;\n// combinational.\n//\n// Example     n = 80: sigma = %u, which is 27",
                   GLINT_SIGMA_INT_BITS, GLINT_SIGMA_FRAC_BITS, glint_rom33(80));
    write_rom(
        out, &(rom){"sigma_rom", what, "sigma", "GLINT_SIGMA_BITS", GLINT_SIGMA_BITS, glint_rom33});
}

static void write_limit_rom(FILE *out)
{
    char what[320];
    (void)snprintf(what, sizeof what,
                   "limit_rom: ROM 9 of figure 3.1 for gate cosine, n -> the smallest cosine, "
                   "U1.%d, for which\n"
                   "// t, computed from the quantised sigma, is not negative; combinational.\n//\n"
                   "// Example     n = 80: limit = %u, just above (n-2)/(n+1) = 0.96296",
                   GLINT_COS_FRAC_BITS, cosine_limit(80));
    write_rom(out,
              &(rom){"limit_rom", what, "limit", "GLINT_COS_BITS", GLINT_COS_BITS, cosine_limit});
}

/* The table for one number of shifts. */
static void write_reciprocals(FILE *out, int shifts)
{
    fprintf(out, "        %sif (SHIFTS == %d) begin : g_table\n",
            shifts == GLINT_DIVIDER_SHIFTS_MIN ? "" : "end else ", shifts);
    fprintf(out, "            always @*\n                case (k)\n");
    for (uint32_t k = 1; k <= GLINT_DIVIDER_K_MAX; k++)
        fprintf(out, "                    %d'd%-2u: bits = %d'd%u;\n", GLINT_DIVIDER_K_BITS, k,
                shifts + 1, glint_divider_bits(shifts, k));
    fprintf(out, "                    default: bits = %d'd0;\n                endcase\n",
            shifts + 1);
}

static void write_reciprocal_rom(FILE *out)
{
    char what[320];
    (void)snprintf(what, sizeof what,
                   "reciprocal_rom: the table of figure 2.13, k -> the bits i0 i1 ... in of 1/k "
                   "(i0 highest),\n// 2^n/k rounded to nearest, n = SHIFTS (%d..%d); miss: k is "
                   "0 or beyond the table;\n// combinational.\n//\n"
                   "// Example     SHIFTS = 12, k = 7: bits = %u, as 4096/7 = 585.14; miss = %d",
                   GLINT_DIVIDER_SHIFTS_MIN, GLINT_DIVIDER_SHIFTS_MAX, glint_divider_bits(12, 7),
                   !glint_divider_in_table(7));
    write_header(out, what);
    fprintf(out, "`default_nettype none\n`include \"glint_formats.vh\"\n\n"
                 "module reciprocal_rom #(\n"
                 "    parameter integer SHIFTS = `GLINT_DIVIDER_SHIFTS_DEFAULT\n"
                 ") (\n"
                 "    input  wire [`GLINT_DIVIDER_K_BITS-1:0] k,\n"
                 "    output reg  [SHIFTS:0]                  bits,\n"
                 "    output wire                             miss\n"
                 ");\n");
    fprintf(out, "    assign miss = (k == %d'd0) || (k > `GLINT_DIVIDER_K_MAX);\n\n    generate\n",
            GLINT_DIVIDER_K_BITS);
    for (int shifts = GLINT_DIVIDER_SHIFTS_MIN; shifts <= GLINT_DIVIDER_SHIFTS_MAX; shifts++)
        write_reciprocals(out, shifts);
    fprintf(out,
            "        end else begin : g_table\n"
            "            // There is no such module: elaboration stops here.\n"
            "            SHIFTS_must_be_%d_to_%d error();\n",
            GLINT_DIVIDER_SHIFTS_MIN, GLINT_DIVIDER_SHIFTS_MAX);
    fprintf(out, "        end\n    endgenerate\nendmodule\n\n`default_nettype wire\n");
}

static writer *find_writer(const char *kind)
{
    static const struct {
        const char *kind;
        writer *write;
    } writers[] = {
        {"formats", write_formats},
        {"sigma-rom", write_sigma_rom},
        {"limit-rom", write_limit_rom},
        {"reciprocal-rom", write_reciprocal_rom},
    };
    for (size_t i = 0; i < sizeof writers / sizeof writers[0]; i++)
        if (strcmp(writers[i].kind, kind) == 0)
            return writers[i].write;
    return NULL;
}

static int write_file(const char *path, writer *write)
{
    char temporary[4096];
    int length = snprintf(temporary, sizeof temporary, "%s.new", path);
    if (length < 0 || (size_t)length >= sizeof temporary)
        return -1;
    FILE *out = fopen(temporary, "w");
    if (out == NULL)
        return -1;
    write(out);
    int failed = ferror(out);
    failed |= fclose(out);
    if (failed || rename(temporary, path) != 0) {
        remove(temporary);
        return -1;
    }
    return 0;
}

int main(int argc, char **argv)
{
    writer *write = argc == 3 ? find_writer(argv[2]) : NULL;
    if (write == NULL) {
        fprintf(stderr, "usage: glint-gen FILE "
                        "formats|sigma-rom|limit-rom|reciprocal-rom\n");
        return 2;
    }
    if (write_file(argv[1], write) != 0) {
        perror(argv[1]);
        return 2;
    }
    return 0;
}
