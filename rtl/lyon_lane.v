// lyon_lane: the blocks of Lyon's unit that every cosine of a clock needs for itself.
//
// Function    W = (1 - n x/k)^k, x = 1 - cos, k = 2^LOG2_K: LOG2_K squarings; 0 where n x >= k
// Blocks      register 1, multiplier 7, adder 8, comparator 11, multiplier 10 (LOG2_K times)
// Formats     reg1 (x) U1.18  mul7 (p) U10.18  adder8 (t), its squares, keys12 U1.16  colours U8.0
// Rounding    half up, at adder 8, the squarings and the colours
// Latency     1 clock (PIPELINED = 0) or LOG2_K + 3 (1). Throughput: one cosine a clock.
// Reset       synchronous, active high, all registers 0, whatever en says. en = 0 holds them all.
// Handshake   none here: lyon_device carries the valid bits beside the lanes.
// Parameters  PIPELINED 1 (default) or 0;  LOG2_K 2 (default) or 3
//             W_DROP    0 (default), or places of W that color_stage rounds off
`default_nettype none
`include "glint_formats.vh"

module lyon_lane #(
    parameter integer PIPELINED = 1,
    parameter integer W_DROP    = 0,
    parameter integer LOG2_K    = 2
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
    output wire [`GLINT_LYON_FRAC_BITS-W_DROP:0] out_w,
    output wire [`GLINT_COLOR_BITS-1:0] out_r,
    output wire [`GLINT_COLOR_BITS-1:0] out_g,
    output wire [`GLINT_COLOR_BITS-1:0] out_b
);
    localparam FRAC   = `GLINT_LYON_FRAC_BITS;
    localparam P_BITS = `GLINT_N_BITS + `GLINT_COS_FRAC_BITS;
    localparam DROP   = `GLINT_COS_FRAC_BITS + LOG2_K - FRAC;
    localparam [`GLINT_COS_BITS-1:0] COS_ONE = {1'b1, {`GLINT_COS_FRAC_BITS{1'b0}}};

    // Stage 1: register 1 takes 1 - cos; n x; the line.
    wire [`GLINT_COS_BITS-1:0] x = (cos > COS_ONE) ? {`GLINT_COS_BITS{1'b0}} : COS_ONE - cos;
    wire [`GLINT_COS_BITS-1:0] reg1;
    stage_register #(.WIDTH(`GLINT_COS_BITS)) u_reg1 (
        .clk(clk), .reset(reset), .en(en && in_valid), .d(x), .q(reg1));

    wire [P_BITS:0] full7 = n * reg1; // x is at most 1.0, so that the highest bit stays 0
    wire            high_unused = full7[P_BITS];
    wire [P_BITS-1:0] mul7  = full7[P_BITS-1:0];
    wire              cmp11 = !(|mul7[P_BITS-1:`GLINT_COS_FRAC_BITS + LOG2_K]);
    wire [FRAC:0]     step  = {1'b0, mul7[`GLINT_COS_FRAC_BITS + LOG2_K - 1:DROP]} +
                              {{FRAC{1'b0}}, mul7[DROP-1]};
    generate
        if (DROP > 1) begin : g_rest
            wire low_unused = &{1'b0, mul7[DROP-2:0]};
        end
    endgenerate
    wire [FRAC:0]     adder8 = cmp11 ? {1'b1, {FRAC{1'b0}}} - step : {(FRAC + 1){1'b0}};

    // Stages 2 and 3, with k = 8 also 4: the squarings.
    wire [FRAC:0] s2_adder8;
    wire [FRAC:0] mul10;
    wire [FRAC:0] s3_mul10;
    wire [FRAC:0] keys12;
    stage_register #(.WIDTH(FRAC + 1), .CLOCKED(PIPELINED)) u_s2_adder8 (
        .clk(clk), .reset(reset), .en(en), .d(adder8), .q(s2_adder8));
    unit_square #(.FRAC(FRAC)) u_mul10 (.t(s2_adder8), .square(mul10));
    stage_register #(.WIDTH(FRAC + 1), .CLOCKED(PIPELINED)) u_s3_mul10 (
        .clk(clk), .reset(reset), .en(en), .d(mul10), .q(s3_mul10));
    generate
        if (LOG2_K == 3) begin : g_k8
            wire [FRAC:0] second10;
            wire [FRAC:0] s4_second10;
            unit_square #(.FRAC(FRAC)) u_second10 (.t(s3_mul10), .square(second10));
            stage_register #(.WIDTH(FRAC + 1), .CLOCKED(PIPELINED)) u_s4_second10 (
                .clk(clk), .reset(reset), .en(en), .d(second10), .q(s4_second10));
            unit_square #(.FRAC(FRAC)) u_third10 (.t(s4_second10), .square(keys12));
        end else begin : g_k4
            unit_square #(.FRAC(FRAC)) u_second10 (.t(s3_mul10), .square(keys12));
        end
    endgenerate

    color_stage #(.W_FRAC_BITS(FRAC), .W_DROP(W_DROP), .PIPELINED(PIPELINED)) colors (
        .clk(clk), .reset(reset), .en(en), .keys12(keys12), .r(last_r), .g(last_g), .b(last_b),
        .out_w(out_w), .out_r(out_r), .out_g(out_g), .out_b(out_b));
endmodule

`default_nettype wire
