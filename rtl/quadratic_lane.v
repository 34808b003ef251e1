// quadratic_lane: the blocks of the quadratic's unit that every cosine of a clock needs for itself.
//
// Function    W = cos (1 - a (1 - cos)) where the line is not negative, else 0
// Blocks      register 1, multiplier 7, adder 8, comparator 11, keys 12; ROM 33 (a) is the device's
// Formats     reg1, adder8 (the line), keys12 U1.18   rom33 (a) U10.13   mul7 U10.18   colours U8.0
// Rounding    half up, at multipliers 7, 12, 13, 14, 15
// Saturation  a cosine above 1.0 is 1.0.
// Latency     1 clock (PIPELINED = 0) or 4 (1). Throughput: one cosine a clock.
// Reset       synchronous, active high, all registers 0, whatever en says. en = 0 holds them all.
// Handshake   none here: quadratic_device carries the valid bits beside the lanes.
// Parameters  PIPELINED 1 (default) or 0
//             W_DROP    0 (default), or places of W that color_stage rounds off
`default_nettype none
`include "glint_formats.vh"

module quadratic_lane #(
    parameter integer PIPELINED = 1,
    parameter integer W_DROP    = 0
) (
    input  wire                         clk,
    input  wire                         reset,
    input  wire                         en,
    input  wire                         in_valid,
    input  wire [`GLINT_COS_BITS-1:0]   cos,
    input  wire [`GLINT_QUADRATIC_A_BITS-1:0] rom33,
    input  wire [`GLINT_COLOR_BITS-1:0] last_r,
    input  wire [`GLINT_COLOR_BITS-1:0] last_g,
    input  wire [`GLINT_COLOR_BITS-1:0] last_b,
    output wire [`GLINT_COS_FRAC_BITS-W_DROP:0] out_w,
    output wire [`GLINT_COLOR_BITS-1:0] out_r,
    output wire [`GLINT_COLOR_BITS-1:0] out_g,
    output wire [`GLINT_COLOR_BITS-1:0] out_b
);
    localparam FRAC  = `GLINT_COS_FRAC_BITS;
    localparam CUT7  = `GLINT_QUADRATIC_A_FRAC_BITS;
    localparam SUM7  = `GLINT_QUADRATIC_A_BITS + FRAC + 1;
    localparam P     = SUM7 - CUT7 - 1;
    localparam [SUM7-1:0] HALF7 = {{(SUM7 - CUT7){1'b0}}, 1'b1, {(CUT7 - 1){1'b0}}};
    localparam [`GLINT_COS_BITS-1:0] COS_ONE = {1'b1, {`GLINT_COS_FRAC_BITS{1'b0}}};

    // Stage 1.
    wire [`GLINT_COS_BITS-1:0] reg1;
    stage_register #(.WIDTH(`GLINT_COS_BITS)) u_reg1 (
        .clk(clk), .reset(reset), .en(en && in_valid), .d((cos > COS_ONE) ? COS_ONE : cos),
        .q(reg1));
    wire [`GLINT_COS_BITS-1:0] x           = COS_ONE - reg1;
    wire [SUM7-1:0]            sum7        = rom33 * x + HALF7;
    wire [P-1:0]               mul7        = sum7[CUT7 +: P];
    wire                       sum7_unused = &{1'b0, sum7[SUM7-1], sum7[CUT7-1:0]};
    wire                       cmp11       = mul7 <= {{(P - FRAC - 1){1'b0}}, COS_ONE};
    wire [FRAC:0]              adder8      = cmp11 ? COS_ONE - mul7[FRAC:0] : {(FRAC + 1){1'b0}};

    // Stage 2.
    wire [`GLINT_COS_BITS-1:0] s2_reg1;
    wire [(FRAC + 1)-1:0] s2_adder8;
    stage_register #(.WIDTH(`GLINT_COS_BITS), .CLOCKED(PIPELINED)) u_s2_reg1 (
        .clk(clk), .reset(reset), .en(en), .d(reg1), .q(s2_reg1));
    stage_register #(.WIDTH((FRAC + 1)), .CLOCKED(PIPELINED)) u_s2_adder8 (
        .clk(clk), .reset(reset), .en(en), .d(adder8), .q(s2_adder8));
    localparam [2*FRAC+1:0] HALF12 = {{(FRAC + 2){1'b0}}, 1'b1, {(FRAC - 1){1'b0}}};
    wire [2*FRAC+1:0] sum12 = s2_adder8 * s2_reg1 + HALF12;
    wire [FRAC:0]     keys12;
    wire              high_unused; // both at most 1.0 leave it 0
    wire [FRAC-1:0]   low_unused;
    assign {high_unused, keys12, low_unused} = sum12;

    color_stage #(.W_FRAC_BITS(FRAC), .W_DROP(W_DROP), .PIPELINED(PIPELINED)) colors (
        .clk(clk), .reset(reset), .en(en), .keys12(keys12), .r(last_r), .g(last_g), .b(last_b),
        .out_w(out_w), .out_r(out_r), .out_g(out_g), .out_b(out_b));
endmodule

`default_nettype wire
