// newton_lane: the blocks of Schlick's unit, by a reciprocal, that every cosine needs.
//
// Function    W = cos / (n (1 - cos) + cos): the denominator is normalised to m, y = 1/m read from
//             a table, made better by y (2 - m y), multiplied by cos and shifted back
// Blocks      register 1, multiplier 7, adder 8, ROM 33 (the table), multipliers of the step and of
//             cos
// Formats     reg1 U1.18   mul7, adder8 U10.18   m, 2 - m y, y U1.17   keys12 U1.12   colours U8.0
// Rounding    W and the colours half up; m and the products of the step are cut off
// Saturation  a cosine above 1.0 is 1.0; 0/0, at cos = n = 0, is 1; W is at most 1.
// Latency     1 clock (PIPELINED = 0) or 10 (1). Throughput: one cosine a clock.
// Reset       synchronous, active high, all registers 0, whatever en says. en = 0 holds them all.
// Handshake   none here: newton_device carries the valid bits beside the lanes.
// Parameters  PIPELINED 1 (default) or 0
//             W_DROP    0 (default), or places of W that color_stage rounds off
`default_nettype none
`include "glint_formats.vh"

module newton_lane #(
    parameter integer PIPELINED = 1,
    parameter integer W_DROP    = 0
) (
    input  wire                         clk,
    input  wire                         reset,
    input  wire                         en,
    input  wire                         in_valid,
    input  wire [`GLINT_COS_BITS-1:0]   cos,
    input  wire [`GLINT_N_BITS-1:0]     n,
    input  wire [`GLINT_COLOR_BITS-1:0] last_r,
    input  wire [`GLINT_COLOR_BITS-1:0] last_g,
    input  wire [`GLINT_COLOR_BITS-1:0] last_b,
    output wire [`GLINT_NEWTON_FRAC_BITS-W_DROP:0] out_w,
    output wire [`GLINT_COLOR_BITS-1:0] out_r,
    output wire [`GLINT_COLOR_BITS-1:0] out_g,
    output wire [`GLINT_COLOR_BITS-1:0] out_b
);
    localparam FRAC    = `GLINT_NEWTON_FRAC_BITS;
    localparam DEN     = `GLINT_N_BITS + `GLINT_COS_FRAC_BITS;
    localparam M       = `GLINT_NEWTON_M_BITS;
    localparam SEED    = `GLINT_NEWTON_SEED_BITS;
    localparam TABLE   = `GLINT_NEWTON_TABLE_BITS;
    localparam PRODUCT = `GLINT_COS_BITS + M + 1;
    localparam SHIFT   = `GLINT_COS_FRAC_BITS + M + `GLINT_N_BITS - 1 - FRAC;
    localparam [`GLINT_COS_BITS-1:0] COS_ONE = {1'b1, {`GLINT_COS_FRAC_BITS{1'b0}}};

    // Stage 1.
    wire [`GLINT_COS_BITS-1:0] reg1;
    stage_register #(.WIDTH(`GLINT_COS_BITS)) u_reg1 (
        .clk(clk), .reset(reset), .en(en && in_valid), .d((cos > COS_ONE) ? COS_ONE : cos),
        .q(reg1));
    wire [`GLINT_COS_BITS-1:0] x           = COS_ONE - reg1;
    wire [DEN:0]               full7       = n * x; // x is at most 1.0: the highest bit stays 0
    wire                       high_unused = full7[DEN];
    wire [DEN-1:0]             mul7        = full7[DEN-1:0];

    // Stage 2: the denominator.
    wire [`GLINT_COS_BITS-1:0] s2_reg1;
    wire [DEN-1:0] s2_mul7;
    stage_register #(.WIDTH(`GLINT_COS_BITS), .CLOCKED(PIPELINED)) u_s2_reg1 (
        .clk(clk), .reset(reset), .en(en), .d(reg1), .q(s2_reg1));
    stage_register #(.WIDTH(DEN), .CLOCKED(PIPELINED)) u_s2_mul7 (
        .clk(clk), .reset(reset), .en(en), .d(mul7), .q(s2_mul7));
    wire [DEN-1:0] adder8 = s2_mul7 + {{(DEN - `GLINT_COS_BITS){1'b0}}, s2_reg1};

    // Stage 3: normalised. 0/0 is a last place by a last place.
    wire [`GLINT_COS_BITS-1:0] s3_reg1;
    wire [DEN-1:0] s3_adder8;
    stage_register #(.WIDTH(`GLINT_COS_BITS), .CLOCKED(PIPELINED)) u_s3_reg1 (
        .clk(clk), .reset(reset), .en(en),
        .d(s2_reg1 | {{(`GLINT_COS_BITS - 1){1'b0}}, adder8 == 0}), .q(s3_reg1));
    stage_register #(.WIDTH(DEN), .CLOCKED(PIPELINED)) u_s3_adder8 (
        .clk(clk), .reset(reset), .en(en),
        .d(adder8 | {{(DEN - 1){1'b0}}, adder8 == 0}), .q(s3_adder8));
    wire [4:0]     lead;
    wire [DEN-1:0] shifted;
    normaliser #(.WIDTH(DEN), .LEAD_BITS(5)) u_normaliser (
        .value(s3_adder8), .lead(lead), .shifted(shifted));
    wire [M:0]     m        = shifted[DEN-1 -: M + 1];
    wire           m_unused = &{1'b0, shifted[DEN-M-2:0]};

    // Stage 4: the table.
    wire [`GLINT_COS_BITS-1:0] s4_reg1;
    wire [5-1:0] s4_lead;
    wire [(M + 1)-1:0] s4_m;
    stage_register #(.WIDTH(`GLINT_COS_BITS), .CLOCKED(PIPELINED)) u_s4_reg1 (
        .clk(clk), .reset(reset), .en(en), .d(s3_reg1), .q(s4_reg1));
    stage_register #(.WIDTH(5), .CLOCKED(PIPELINED)) u_s4_lead (
        .clk(clk), .reset(reset), .en(en), .d(lead), .q(s4_lead));
    stage_register #(.WIDTH((M + 1)), .CLOCKED(PIPELINED)) u_s4_m (
        .clk(clk), .reset(reset), .en(en), .d(m), .q(s4_m));
    wire [SEED-1:0] rom33;
    newton_rom u_rom33 (.m(s4_m[M-1 -: TABLE]), .seed(rom33));

    // Stage 5: 2 - m y.
    wire [`GLINT_COS_BITS-1:0] s5_reg1;
    wire [5-1:0] s5_lead;
    wire [(M + 1)-1:0] s5_m;
    wire [SEED-1:0] s5_rom33;
    stage_register #(.WIDTH(`GLINT_COS_BITS), .CLOCKED(PIPELINED)) u_s5_reg1 (
        .clk(clk), .reset(reset), .en(en), .d(s4_reg1), .q(s5_reg1));
    stage_register #(.WIDTH(5), .CLOCKED(PIPELINED)) u_s5_lead (
        .clk(clk), .reset(reset), .en(en), .d(s4_lead), .q(s5_lead));
    stage_register #(.WIDTH((M + 1)), .CLOCKED(PIPELINED)) u_s5_m (
        .clk(clk), .reset(reset), .en(en), .d(s4_m), .q(s5_m));
    stage_register #(.WIDTH(SEED), .CLOCKED(PIPELINED)) u_s5_rom33 (
        .clk(clk), .reset(reset), .en(en), .d(rom33), .q(s5_rom33));
    wire [M+SEED:0] product5        = s5_m * s5_rom33;
    wire [M:0]      error10         = -product5[M+SEED:SEED];
    wire            product5_unused = &{1'b0, product5[SEED-1:0]};

    // Stage 6: y (2 - m y).
    wire [`GLINT_COS_BITS-1:0] s6_reg1;
    wire [5-1:0] s6_lead;
    wire [SEED-1:0] s6_rom33;
    wire [(M + 1)-1:0] s6_error10;
    stage_register #(.WIDTH(`GLINT_COS_BITS), .CLOCKED(PIPELINED)) u_s6_reg1 (
        .clk(clk), .reset(reset), .en(en), .d(s5_reg1), .q(s6_reg1));
    stage_register #(.WIDTH(5), .CLOCKED(PIPELINED)) u_s6_lead (
        .clk(clk), .reset(reset), .en(en), .d(s5_lead), .q(s6_lead));
    stage_register #(.WIDTH(SEED), .CLOCKED(PIPELINED)) u_s6_rom33 (
        .clk(clk), .reset(reset), .en(en), .d(s5_rom33), .q(s6_rom33));
    stage_register #(.WIDTH((M + 1)), .CLOCKED(PIPELINED)) u_s6_error10 (
        .clk(clk), .reset(reset), .en(en), .d(error10), .q(s6_error10));
    wire [M+SEED:0] product6        = s6_error10 * s6_rom33;
    wire [M:0]      newton10        = product6[M+SEED:SEED];
    wire            product6_unused = &{1'b0, product6[SEED-1:0]};

    // Stage 7: times the cosine.
    wire [`GLINT_COS_BITS-1:0] s7_reg1;
    wire [5-1:0] s7_lead;
    wire [(M + 1)-1:0] s7_newton10;
    stage_register #(.WIDTH(`GLINT_COS_BITS), .CLOCKED(PIPELINED)) u_s7_reg1 (
        .clk(clk), .reset(reset), .en(en), .d(s6_reg1), .q(s7_reg1));
    stage_register #(.WIDTH(5), .CLOCKED(PIPELINED)) u_s7_lead (
        .clk(clk), .reset(reset), .en(en), .d(s6_lead), .q(s7_lead));
    stage_register #(.WIDTH((M + 1)), .CLOCKED(PIPELINED)) u_s7_newton10 (
        .clk(clk), .reset(reset), .en(en), .d(newton10), .q(s7_newton10));
    wire [PRODUCT-1:0] mul10 = s7_reg1 * s7_newton10;

    // Stage 8: shifted back and rounded.
    wire [5-1:0] s8_lead;
    wire [PRODUCT-1:0] s8_mul10;
    stage_register #(.WIDTH(5), .CLOCKED(PIPELINED)) u_s8_lead (
        .clk(clk), .reset(reset), .en(en), .d(s7_lead), .q(s8_lead));
    stage_register #(.WIDTH(PRODUCT), .CLOCKED(PIPELINED)) u_s8_mul10 (
        .clk(clk), .reset(reset), .en(en), .d(mul10), .q(s8_mul10));
    localparam [5:0]   SHIFT8     = SHIFT - 1;
    wire [PRODUCT-1:0] back       = s8_mul10 >> (SHIFT8 - {1'b0, s8_lead});
    wire [PRODUCT-1:0] rounded    = back + {{(PRODUCT - 1){1'b0}}, 1'b1};
    wire               low_unused = rounded[0];
    wire [FRAC:0]      keys12     = (|rounded[PRODUCT-1:FRAC+1]) ? {1'b1, {FRAC{1'b0}}}
                                                                 : rounded[FRAC+1:1];

    color_stage #(.W_FRAC_BITS(FRAC), .W_DROP(W_DROP), .PIPELINED(PIPELINED)) colors (
        .clk(clk), .reset(reset), .en(en), .keys12(keys12), .r(last_r), .g(last_g), .b(last_b),
        .out_w(out_w), .out_r(out_r), .out_g(out_g), .out_b(out_b));
endmodule

`default_nettype wire
