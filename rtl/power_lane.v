// power_lane: the blocks of the power device that every cosine of a clock needs for itself.
//
// Function    W = 2^(-n x g(x)), x = 1 - cos: x times n, times g from ROM 9, and the power of two
//             of that from ROM 33 and a shift; out_r, out_g, out_b = W times R, G, B
// Blocks      register 1, multipliers 7, 10, 13, 14, 15, ROM 9, comparator 11, ROM 33, keys 12
// Formats     reg1 (x) U0.18    mul7 (p) U10.18, of which U4.12 goes on   colours U8.0
//             rom9 (g) U4.TABLE_BITS   mul10 (v) U8.TABLE_BITS, of which U4.TABLE_BITS goes on
//             rom33, keys12 (W) U1.(2 TABLE_BITS - 4): U1.12 with tables of 256, U1.14 with 512
// Rounding    half up at multipliers 10, 13, 14, 15 and in the tables; p and the shift cut off.
// Saturation  a cosine above 1.0 gives x = 0, the cosine 0 the x next below 1.
// Latency     1 clock (PIPELINED = 0) or 5 (PIPELINED = 1), from the edge that loads register 1 to
//             the one after which the result is out, both counted. Throughput: one cosine a clock.
// Reset       synchronous, active high, all registers 0, whatever en says. en = 0 holds them all.
// Handshake   none here: power_device carries the valid bits beside the lanes.
// Parameters  PIPELINED   1 (default) or 0
//             W_DROP      0 (default), or places of W that color_stage rounds off
//             TABLE_BITS  8 (default) or 9: address bits of both tables
`default_nettype none
`include "glint_formats.vh"

module power_lane #(
    parameter integer PIPELINED  = 1,
    parameter integer W_DROP     = 0,
    parameter integer TABLE_BITS = 8
) (
    input  wire                         clk,
    input  wire                         reset,
    input  wire                         en,
    input  wire                         in_valid, // register 1 loads
    input  wire [`GLINT_COS_BITS-1:0]   cos,

    // Material, as the stage that reads it has it: 1 and 4.
    input  wire [`GLINT_N_BITS-1:0]     n,
    input  wire [`GLINT_COLOR_BITS-1:0] last_r,
    input  wire [`GLINT_COLOR_BITS-1:0] last_g,
    input  wire [`GLINT_COLOR_BITS-1:0] last_b,

    output wire [2*TABLE_BITS-4-W_DROP:0] out_w,
    output wire [`GLINT_COLOR_BITS-1:0] out_r,
    output wire [`GLINT_COLOR_BITS-1:0] out_g,
    output wire [`GLINT_COLOR_BITS-1:0] out_b
);
    localparam W_FRAC_BITS = 2 * TABLE_BITS - 4;
    localparam W_BITS      = 1 + W_FRAC_BITS;
    localparam G_BITS      = `GLINT_POWER_L_INT_BITS + TABLE_BITS;
    localparam V_BITS      = `GLINT_POWER_V_INT_BITS + TABLE_BITS;

    // Stage 1: register 1 takes 1 - cos; multiplier 7; ROM 9.
    wire [`GLINT_COS_FRAC_BITS-1:0] fraction = cos[`GLINT_COS_FRAC_BITS-1:0];
    wire                            above1   = cos[`GLINT_COS_FRAC_BITS];
    wire [`GLINT_POWER_X_BITS-1:0]  x        = above1         ? {`GLINT_POWER_X_BITS{1'b0}} :
                                               (fraction == 0) ? {`GLINT_POWER_X_BITS{1'b1}} :
                                                                 -fraction;
    wire [`GLINT_POWER_X_BITS-1:0]  reg1;
    stage_register #(.WIDTH(`GLINT_POWER_X_BITS)) u_reg1 (
        .clk(clk), .reset(reset), .en(en && in_valid), .d(x), .q(reg1));

    wire [`GLINT_POWER_P_BITS-1:0] mul7  = n * reg1;
    wire                           over7 = |mul7[`GLINT_POWER_P_BITS-1 -: `GLINT_POWER_P_BITS -
                                                 `GLINT_POWER_L_INT_BITS - `GLINT_POWER_X_BITS];
    // Multiplier 10 takes the middle of it.
    localparam CUT7 = `GLINT_POWER_X_BITS - `GLINT_POWER_Q_FRAC_BITS;
    wire [`GLINT_POWER_Q_BITS-1:0] q           = mul7[CUT7 +: `GLINT_POWER_Q_BITS];
    wire                           mul7_unused = &{1'b0, mul7[CUT7-1:0]};

    wire [G_BITS-1:0]              rom9;
    power_log_rom #(.TABLE_BITS(TABLE_BITS)) u_rom9 (
        .address(reg1[`GLINT_POWER_X_BITS-1 -: TABLE_BITS]), .g(rom9));

    // Stage 2: multiplier 10 and comparator 11.
    wire [`GLINT_POWER_Q_BITS-1:0] s2_mul7;
    wire                           s2_over7;
    wire [G_BITS-1:0]              s2_rom9;
    stage_register #(.WIDTH(`GLINT_POWER_Q_BITS), .CLOCKED(PIPELINED)) u_s2_mul7 (
        .clk(clk), .reset(reset), .en(en), .d(q), .q(s2_mul7));
    stage_register #(.WIDTH(1), .CLOCKED(PIPELINED)) u_s2_over7 (
        .clk(clk), .reset(reset), .en(en), .d(over7), .q(s2_over7));
    stage_register #(.WIDTH(G_BITS), .CLOCKED(PIPELINED)) u_s2_rom9 (
        .clk(clk), .reset(reset), .en(en), .d(rom9), .q(s2_rom9));

    localparam SUM10_BITS = V_BITS + `GLINT_POWER_Q_FRAC_BITS;
    localparam [SUM10_BITS-1:0] HALF10 = {
        {(V_BITS){1'b0}}, 1'b1, {(`GLINT_POWER_Q_FRAC_BITS - 1){1'b0}}};

    wire [SUM10_BITS-1:0]               sum10 = s2_mul7 * s2_rom9 + HALF10;
    wire [V_BITS-1:0]                   mul10;
    wire [`GLINT_POWER_Q_FRAC_BITS-1:0] mul10_unused;
    assign {mul10, mul10_unused} = sum10;

    wire cmp11 = !s2_over7 && !(|mul10[V_BITS-1 -: V_BITS - G_BITS]);

    // Stage 3: ROM 33, and the key block that shifts it or passes zero.
    wire [G_BITS-1:0] s3_mul10;
    wire              s3_cmp11;
    stage_register #(.WIDTH(G_BITS), .CLOCKED(PIPELINED)) u_s3_mul10 (
        .clk(clk), .reset(reset), .en(en), .d(mul10[G_BITS-1:0]), .q(s3_mul10));
    stage_register #(.WIDTH(1), .CLOCKED(PIPELINED)) u_s3_cmp11 (
        .clk(clk), .reset(reset), .en(en), .d(cmp11), .q(s3_cmp11));

    wire [W_BITS-1:0] rom33;
    power_exp_rom #(.TABLE_BITS(TABLE_BITS)) u_rom33 (
        .address(s3_mul10[TABLE_BITS-1:0]), .power(rom33));
    wire [W_BITS-1:0] keys12 = s3_cmp11 ? rom33 >> s3_mul10[G_BITS-1:TABLE_BITS]
                                        : {W_BITS{1'b0}};

    // Stage 4 and the outputs.
    color_stage #(.W_FRAC_BITS(W_FRAC_BITS), .W_DROP(W_DROP), .PIPELINED(PIPELINED)) colors (
        .clk(clk), .reset(reset), .en(en), .keys12(keys12), .r(last_r), .g(last_g), .b(last_b),
        .out_w(out_w), .out_r(out_r), .out_g(out_g), .out_b(out_b));
endmodule

`default_nettype wire
