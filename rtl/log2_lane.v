// log2_lane: the blocks of the power unit by logarithm that every cosine needs for itself.
//
// Function    W = 2^(n log2 cos): the cosine is normalised, its logarithm read from a table of 128
//             lines, times n, and the power of two of that read from ROM 33 and shifted
// Blocks      register 1, normaliser 6, ROM 9 (two tables), multiplier 7, adder 8, multiplier 10,
//             comparator 11, ROM 33, keys 12
// Formats     reg1 U1.18    adder8 (L) U5.22    mul10 U15.22   v U4.8   keys12 U1.12   colours U8.0
// Rounding    half up at v and at the colours; multiplier 7 and the shift cut off
// Saturation  a cosine above 1.0 is 1.0; of cosine 0 L is all ones.
// Latency     1 clock (PIPELINED = 0) or 8 (1). Throughput: one cosine a clock.
// Reset       synchronous, active high, all registers 0, whatever en says. en = 0 holds them all.
// Handshake   none here: log2_device carries the valid bits beside the lanes.
// Parameters  PIPELINED 1 (default) or 0
//             W_DROP    0 (default), or places of W that color_stage rounds off
`default_nettype none
`include "glint_formats.vh"

module log2_lane #(
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
    output wire [12-W_DROP:0] out_w,
    output wire [`GLINT_COLOR_BITS-1:0] out_r,
    output wire [`GLINT_COLOR_BITS-1:0] out_g,
    output wire [`GLINT_COLOR_BITS-1:0] out_b
);
    localparam FRAC  = 12; // that of power_exp_rom with tables of 256
    localparam EXP   = 8;
    localparam CF    = `GLINT_COS_FRAC_BITS;
    localparam M     = CF - 1;
    localparam LF    = `GLINT_LOG2_FRAC_BITS;
    localparam L     = `GLINT_LOG2_L_INT_BITS + LF;
    localparam SLOPE = `GLINT_LOG2_SLOPE_BITS;
    localparam LOW   = M - `GLINT_LOG2_TABLE_BITS;
    localparam CUT   = `GLINT_LOG2_SLOPE_FRAC + LOW - LF;
    localparam RISE  = SLOPE + LOW - CUT;
    localparam P     = `GLINT_N_BITS + L;
    localparam V     = `GLINT_POWER_L_INT_BITS + EXP;
    localparam [`GLINT_COS_BITS-1:0] COS_ONE = {1'b1, {`GLINT_COS_FRAC_BITS{1'b0}}};

    // Stage 1: normalised.
    wire [`GLINT_COS_BITS-1:0] reg1;
    stage_register #(.WIDTH(`GLINT_COS_BITS)) u_reg1 (
        .clk(clk), .reset(reset), .en(en && in_valid), .d((cos > COS_ONE) ? COS_ONE : cos),
        .q(reg1));
    wire [4:0]    lead;
    wire [CF-1:0] shifted;
    normaliser #(.WIDTH(CF), .LEAD_BITS(5)) u_normaliser (
        .value(reg1[CF-1:0]), .lead(lead), .shifted(shifted));
    wire [M-1:0]  m            = shifted[M-1:0];
    wire          first_unused = shifted[M];
    wire [1:0]    end6         = {reg1 == 0, reg1[CF]};

    // Stage 2: the tables.
    wire [5-1:0] s2_lead;
    wire [M-1:0] s2_m;
    wire [2-1:0] s2_end6;
    stage_register #(.WIDTH(5), .CLOCKED(PIPELINED)) u_s2_lead (
        .clk(clk), .reset(reset), .en(en), .d(lead), .q(s2_lead));
    stage_register #(.WIDTH(M), .CLOCKED(PIPELINED)) u_s2_m (
        .clk(clk), .reset(reset), .en(en), .d(m), .q(s2_m));
    stage_register #(.WIDTH(2), .CLOCKED(PIPELINED)) u_s2_end6 (
        .clk(clk), .reset(reset), .en(en), .d(end6), .q(s2_end6));
    wire [LF:0]      rom9;
    wire [SLOPE-1:0] slope9;
    log2_base_rom  u_rom9   (.m(s2_m[M-1:LOW]), .base(rom9));
    log2_slope_rom u_slope9 (.m(s2_m[M-1:LOW]), .slope(slope9));

    // Stage 3: the line; L.
    wire [5-1:0] s3_lead;
    wire [LOW-1:0] s3_low;
    wire [2-1:0] s3_end6;
    wire [(LF + 1)-1:0] s3_rom9;
    wire [SLOPE-1:0] s3_slope9;
    stage_register #(.WIDTH(5), .CLOCKED(PIPELINED)) u_s3_lead (
        .clk(clk), .reset(reset), .en(en), .d(s2_lead), .q(s3_lead));
    stage_register #(.WIDTH(LOW), .CLOCKED(PIPELINED)) u_s3_low (
        .clk(clk), .reset(reset), .en(en), .d(s2_m[LOW-1:0]), .q(s3_low));
    stage_register #(.WIDTH(2), .CLOCKED(PIPELINED)) u_s3_end6 (
        .clk(clk), .reset(reset), .en(en), .d(s2_end6), .q(s3_end6));
    stage_register #(.WIDTH((LF + 1)), .CLOCKED(PIPELINED)) u_s3_rom9 (
        .clk(clk), .reset(reset), .en(en), .d(rom9), .q(s3_rom9));
    stage_register #(.WIDTH(SLOPE), .CLOCKED(PIPELINED)) u_s3_slope9 (
        .clk(clk), .reset(reset), .en(en), .d(slope9), .q(s3_slope9));
    wire [SLOPE+LOW-1:0] product7        = s3_slope9 * s3_low;
    wire [RISE-1:0]      rise7           = product7[SLOPE+LOW-1:CUT];
    wire                 product7_unused = &{1'b0, product7[CUT-1:0]};
    wire [LF:0]          sum8            = s3_rom9 + {{(LF + 1 - RISE){1'b0}}, rise7};
    wire                 above8          = sum8[LF] && (|sum8[LF-1:0]);
    wire [LF:0]          logarithm8      = above8 ? {1'b1, {LF{1'b0}}} : sum8;
    wire [L-1:0]         adder8          = s3_end6[0] ? {L{1'b0}} :
                                           s3_end6[1] ? {L{1'b1}} :
                                           {s3_lead + 5'd1, {LF{1'b0}}} -
                                           {{(L - LF - 1){1'b0}}, logarithm8};

    // Stage 4: times n.
    wire [L-1:0] s4_adder8;
    stage_register #(.WIDTH(L), .CLOCKED(PIPELINED)) u_s4_adder8 (
        .clk(clk), .reset(reset), .en(en), .d(adder8), .q(s4_adder8));
    wire [P-1:0] mul10 = n * s4_adder8;

    // Stage 5: rounded.
    wire [P-1:0] s5_mul10;
    stage_register #(.WIDTH(P), .CLOCKED(PIPELINED)) u_s5_mul10 (
        .clk(clk), .reset(reset), .en(en), .d(mul10), .q(s5_mul10));
    localparam [P:0] HALF5 = {{(P + 1 - LF + EXP){1'b0}}, 1'b1, {(LF - EXP - 1){1'b0}}};
    wire [P:0]   sum5       = {1'b0, s5_mul10} + HALF5;
    wire [V-1:0] v          = sum5[LF-EXP +: V];
    wire         cmp11      = !(|sum5[P:LF-EXP+V]);
    wire         sum5_unused = &{1'b0, sum5[LF-EXP-1:0]};

    // Stage 6: the power of two.
    wire [V-1:0] s6_v;
    wire [1-1:0] s6_cmp11;
    stage_register #(.WIDTH(V), .CLOCKED(PIPELINED)) u_s6_v (
        .clk(clk), .reset(reset), .en(en), .d(v), .q(s6_v));
    stage_register #(.WIDTH(1), .CLOCKED(PIPELINED)) u_s6_cmp11 (
        .clk(clk), .reset(reset), .en(en), .d(cmp11), .q(s6_cmp11));
    wire [FRAC:0] rom33;
    power_exp_rom #(.TABLE_BITS(EXP)) u_rom33 (.address(s6_v[EXP-1:0]), .power(rom33));
    wire [FRAC:0] keys12 = s6_cmp11[0] ? rom33 >> s6_v[V-1:EXP] : {(FRAC + 1){1'b0}};

    color_stage #(.W_FRAC_BITS(FRAC), .W_DROP(W_DROP), .PIPELINED(PIPELINED)) colors (
        .clk(clk), .reset(reset), .en(en), .keys12(keys12), .r(last_r), .g(last_g), .b(last_b),
        .out_w(out_w), .out_r(out_r), .out_g(out_g), .out_b(out_b));
endmodule

`default_nettype wire
