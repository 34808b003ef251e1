// bipartite_lane: the blocks of the unit by a bipartite table that every cosine needs for itself.
//
// Function    W = value(a, b) + offset(a, c), which is cos^n, n = 8 << EXPONENT; a, b, c are the
//             first bits of the cosine. W = 1 where the cosine is 1.
// Blocks      register 1, ROM 9 (value), ROM 33 (offset), comparator 11, adder 8, keys 12
// Formats     reg1 U1.18   rom9 U0.12   rom33 last places of that   adder8, keys12 U1.12
//             colours U8.0
// Rounding    of the tables' words; the colours half up. The cosine's last bits are not used.
// Saturation  a cosine above 1.0 is 1.0.
// Latency     1 clock (PIPELINED = 0) or 4 (1). Throughput: one cosine a clock.
// Reset       synchronous, active high, all registers 0, whatever en says. en = 0 holds them all.
// Handshake   none here: bipartite_device carries the valid bits beside the lanes.
// Parameters  EXPONENT  0 (default) to 2
//             W_DROP    0 (default), or places of W that color_stage rounds off
//             PIPELINED 1 (default) or 0
`default_nettype none
`include "glint_formats.vh"

module bipartite_lane #(
    parameter integer EXPONENT  = 0,
    parameter integer W_DROP    = 0,
    parameter integer PIPELINED = 1
) (
    input  wire                         clk,
    input  wire                         reset,
    input  wire                         en,
    input  wire                         in_valid,
    input  wire [`GLINT_COS_BITS-1:0]   cos,
    input  wire [`GLINT_COLOR_BITS-1:0] last_r,
    input  wire [`GLINT_COLOR_BITS-1:0] last_g,
    input  wire [`GLINT_COLOR_BITS-1:0] last_b,
    output wire [`GLINT_BIPARTITE_FRAC_BITS-W_DROP:0] out_w,
    output wire [`GLINT_COLOR_BITS-1:0] out_r,
    output wire [`GLINT_COLOR_BITS-1:0] out_g,
    output wire [`GLINT_COLOR_BITS-1:0] out_b
);
    localparam FRAC   = `GLINT_BIPARTITE_FRAC_BITS;
    localparam CF     = `GLINT_COS_FRAC_BITS;
    localparam A      = `GLINT_BIPARTITE_A_BITS + EXPONENT;
    localparam B      = `GLINT_BIPARTITE_B_BITS;
    localparam C      = `GLINT_BIPARTITE_C_BITS;
    localparam OFFSET = `GLINT_BIPARTITE_OFFSET_BITS;
    localparam [`GLINT_COS_BITS-1:0] COS_ONE = {1'b1, {`GLINT_COS_FRAC_BITS{1'b0}}};

    // Stage 1: the tables.
    wire [`GLINT_COS_BITS-1:0] reg1;
    stage_register #(.WIDTH(`GLINT_COS_BITS)) u_reg1 (
        .clk(clk), .reset(reset), .en(en && in_valid), .d((cos > COS_ONE) ? COS_ONE : cos),
        .q(reg1));
    wire [A-1:0]      a           = reg1[CF-1 -: A];
    wire [B-1:0]      b           = reg1[CF-1-A -: B];
    wire [C-1:0]      c           = reg1[CF-1-A-B -: C];
    wire              cmp11       = reg1[CF];
    wire              rest_unused = &{1'b0, reg1[CF-1-A-B-C:0]};
    wire [FRAC-1:0]   rom9;
    wire [OFFSET-1:0] rom33;
    bipartite_value_rom  #(.EXPONENT(EXPONENT)) u_rom9  (.address({a, b}), .value(rom9));
    bipartite_offset_rom #(.EXPONENT(EXPONENT)) u_rom33 (.address({a, c}), .offset(rom33));

    // Stage 2: the sum.
    wire [FRAC-1:0]   s2_rom9;
    wire [OFFSET-1:0] s2_rom33;
    wire              s2_cmp11;
    stage_register #(.WIDTH(FRAC), .CLOCKED(PIPELINED)) u_s2_rom9 (
        .clk(clk), .reset(reset), .en(en), .d(rom9), .q(s2_rom9));
    stage_register #(.WIDTH(OFFSET), .CLOCKED(PIPELINED)) u_s2_rom33 (
        .clk(clk), .reset(reset), .en(en), .d(rom33), .q(s2_rom33));
    stage_register #(.WIDTH(1), .CLOCKED(PIPELINED)) u_s2_cmp11 (
        .clk(clk), .reset(reset), .en(en), .d(cmp11), .q(s2_cmp11));
    wire [FRAC:0] adder8 = {1'b0, s2_rom9} + {{(FRAC + 1 - OFFSET){1'b0}}, s2_rom33};
    wire [FRAC:0] keys12 = s2_cmp11 ? {1'b1, {FRAC{1'b0}}} : adder8;

    color_stage #(.W_FRAC_BITS(FRAC), .W_DROP(W_DROP), .PIPELINED(PIPELINED)) colors (
        .clk(clk), .reset(reset), .en(en), .keys12(keys12), .r(last_r), .g(last_g), .b(last_b),
        .out_w(out_w), .out_r(out_r), .out_g(out_g), .out_b(out_b));
endmodule

`default_nettype wire
