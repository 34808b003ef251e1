// color_stage: the end of a highlight unit's lane: W rounded, the stage that multiplies it by the
// colours, and the output registers.
//
// Function    w = keys12, rounded; out_w = w;  out_r, out_g, out_b = w times R, G, B
// Blocks      multipliers 13, 14, 15
// Formats     keys12 U1.W_FRAC_BITS, at most 1.0;  w, out_w W_DROP bits less;  colours U8.0
// Rounding    half up, at w and at the multipliers
// Latency     2 clocks; PIPELINED = 0: none
// Reset       synchronous, active high; clears every register, whatever en says. en = 0 holds them.
// Handshake   none: material_path carries the valid bits.
// Parameters  W_FRAC_BITS  fraction bits of W as the lane makes it
//             W_DROP       0 (default), or how many of them are rounded off
//             PIPELINED    1 (default) or 0
`default_nettype none
`include "glint_formats.vh"

module color_stage #(
    parameter integer W_FRAC_BITS = `GLINT_W_FRAC_BITS,
    parameter integer W_DROP      = 0,
    parameter integer PIPELINED   = 1
) (
    input  wire                         clk,
    input  wire                         reset,
    input  wire                         en,
    input  wire [W_FRAC_BITS:0]         keys12,
    input  wire [`GLINT_COLOR_BITS-1:0] r, // of the stage that w is in
    input  wire [`GLINT_COLOR_BITS-1:0] g,
    input  wire [`GLINT_COLOR_BITS-1:0] b,
    output wire [W_FRAC_BITS-W_DROP:0]  out_w,
    output wire [`GLINT_COLOR_BITS-1:0] out_r,
    output wire [`GLINT_COLOR_BITS-1:0] out_g,
    output wire [`GLINT_COLOR_BITS-1:0] out_b
);
    localparam RGB_BITS = 3 * `GLINT_COLOR_BITS;
    localparam FRAC     = W_FRAC_BITS - W_DROP;

    wire [FRAC:0] rounded12;
    w_rounder #(.W_FRAC_BITS(W_FRAC_BITS), .W_DROP(W_DROP)) u_rounded12 (
        .w(keys12), .rounded(rounded12));

    wire [FRAC:0] w;
    stage_register #(.WIDTH(1 + FRAC), .CLOCKED(PIPELINED)) u_w (
        .clk(clk), .reset(reset), .en(en), .d(rounded12), .q(w));

    wire [`GLINT_COLOR_BITS-1:0] mul13;
    wire [`GLINT_COLOR_BITS-1:0] mul14;
    wire [`GLINT_COLOR_BITS-1:0] mul15;
    color_multiplier #(.W_FRAC_BITS(FRAC)) u_mul13 (.w(w), .color(r), .product(mul13));
    color_multiplier #(.W_FRAC_BITS(FRAC)) u_mul14 (.w(w), .color(g), .product(mul14));
    color_multiplier #(.W_FRAC_BITS(FRAC)) u_mul15 (.w(w), .color(b), .product(mul15));

    stage_register #(.WIDTH(1 + FRAC), .CLOCKED(PIPELINED)) u_out_w (
        .clk(clk), .reset(reset), .en(en), .d(w), .q(out_w));
    stage_register #(.WIDTH(RGB_BITS), .CLOCKED(PIPELINED)) u_out_rgb (
        .clk(clk), .reset(reset), .en(en), .d({mul13, mul14, mul15}), .q({out_r, out_g, out_b}));
endmodule

`default_nettype wire
