// schlick_lane: the blocks of Schlick's unit, by division, that every cosine needs for itself.
//
// Function    W = cos / (n (1 - cos) + cos), restoring division, one bit of the quotient a stage
// Blocks      register 1, multiplier 7, adder 8 (the denominator), step[i]: the divider
// Formats     reg1 U1.18    mul7, adder8, rest U10.18    keys12 U1.12    colours U8.0
// Rounding    W is cut off; the colours half up
// Saturation  a cosine above 1.0 is 1.0; 0/0, at cos = n = 0, is 1.
// Latency     1 clock (PIPELINED = 0) or 17 (1). Throughput: one cosine a clock.
// Reset       synchronous, active high, all registers 0, whatever en says. en = 0 holds them all.
// Handshake   none here: schlick_device carries the valid bits beside the lanes.
// Parameters  PIPELINED 1 (default) or 0
//             W_DROP    0 (default), or places of W that color_stage rounds off
`default_nettype none
`include "glint_formats.vh"

module schlick_lane #(
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
    output wire [`GLINT_SCHLICK_FRAC_BITS-W_DROP:0] out_w,
    output wire [`GLINT_COLOR_BITS-1:0] out_r,
    output wire [`GLINT_COLOR_BITS-1:0] out_g,
    output wire [`GLINT_COLOR_BITS-1:0] out_b
);
    localparam FRAC  = `GLINT_SCHLICK_FRAC_BITS;
    localparam DEN   = `GLINT_SCHLICK_DEN_BITS;
    localparam STATE = 2 * DEN + FRAC + 1;
    localparam [`GLINT_COS_BITS-1:0] COS_ONE = {1'b1, {`GLINT_COS_FRAC_BITS{1'b0}}};

    // Stage 1.
    wire [`GLINT_COS_BITS-1:0] reg1;
    stage_register #(.WIDTH(`GLINT_COS_BITS)) u_reg1 (
        .clk(clk), .reset(reset), .en(en && in_valid), .d((cos > COS_ONE) ? COS_ONE : cos),
        .q(reg1));
    wire [`GLINT_COS_BITS-1:0] x          = COS_ONE - reg1;
    wire [DEN:0]               full7      = n * x; // x is at most 1.0: the highest bit stays 0
    wire                       high_unused = full7[DEN];
    wire [DEN-1:0]             mul7       = full7[DEN-1:0];

    // Stage 2.
    wire [`GLINT_COS_BITS-1:0] s2_reg1;
    wire [DEN-1:0]             s2_mul7;
    stage_register #(.WIDTH(`GLINT_COS_BITS), .CLOCKED(PIPELINED)) u_s2_reg1 (
        .clk(clk), .reset(reset), .en(en), .d(reg1), .q(s2_reg1));
    stage_register #(.WIDTH(DEN), .CLOCKED(PIPELINED)) u_s2_mul7 (
        .clk(clk), .reset(reset), .en(en), .d(mul7), .q(s2_mul7));
    wire [DEN-1:0] adder8 = s2_mul7 + {{(DEN - `GLINT_COS_BITS){1'b0}}, s2_reg1};

    // Stages 3 to 15: in states, at i*STATE, what stands in front of step i.
    wire [(FRAC+2)*STATE-1:0] states;
    assign states[0 +: STATE] = {{(DEN - `GLINT_COS_BITS){1'b0}}, s2_reg1, adder8,
                                 {(FRAC + 1){1'b0}}};
    genvar i;
    generate
        for (i = 0; i <= FRAC; i = i + 1) begin : step
            wire [DEN-1:0]  rest;
            wire [DEN-1:0]  den;
            wire [FRAC:0]   quotient;
            stage_register #(.WIDTH(STATE), .CLOCKED(PIPELINED)) u_state (
                .clk(clk), .reset(reset), .en(en), .d(states[i*STATE +: STATE]),
                .q({rest, den, quotient}));
            // The first bit is that of 1.0, where nothing is left for the others.
            wire [DEN:0]    twice = (i == 0) ? {1'b0, rest} : {rest, 1'b0};
            wire [DEN:0]    less  = twice - {1'b0, den};
            wire            q     = !less[DEN] && !quotient[FRAC];
            wire [FRAC:0]   bits  = quotient | ({{FRAC{1'b0}}, q} << (FRAC - i));
            assign states[(i+1)*STATE +: STATE] = {q ? less[DEN-1:0] : twice[DEN-1:0], den, bits};
        end
    endgenerate
    wire [FRAC:0] keys12     = states[(FRAC+1)*STATE +: FRAC + 1];
    wire          end_unused = &{1'b0, states[(FRAC+1)*STATE + FRAC + 1 +: 2 * DEN]};

    color_stage #(.W_FRAC_BITS(FRAC), .W_DROP(W_DROP), .PIPELINED(PIPELINED)) colors (
        .clk(clk), .reset(reset), .en(en), .keys12(keys12), .r(last_r), .g(last_g), .b(last_b),
        .out_w(out_w), .out_r(out_r), .out_g(out_g), .out_b(out_b));
endmodule

`default_nettype wire
