// quadratic_span: intensities along a row of a triangle by second differences, one pixel per clock.
//
// Function    For each component, pixel i after a load has the intensity
//             start + i*first + i*(i-1)/2*second, rounded and held in 0..255: quadratic
//             interpolation of intensity (thesis, appendix A) by two additions a pixel.
// Formats     start_*, first_*, second_* S10.n, n = FRACTION;  r, g, b U8.0
// Rounding    half up, of the value of each pixel; nothing is rounded within the sums
// Range       Sums wrap around. A value of -512 up to, but not including, 512 is right whatever
//             wrapped on the way to it; on a triangle values are -85..340.
// Latency     2 clocks from the edge that loads or steps to the one after which that pixel is out,
//             both counted. Throughput: one pixel of three components per clock.
// Handshake   load at an enabled edge takes the three numbers and gives pixel 0; step, without
//             load, gives the next pixel. out_valid marks each pixel for one enabled clock; r, g
//             and b hold until the next one. A load needs no gap before it. There is no back
//             pressure; en = 0 freezes everything instead.
// Reset       synchronous, active high, clears everything, regardless of en.
// Parameters  FRACTION 8..26. Numbers rounded to n = FRACTION fraction bits put pixel i off by at
//             most (1 + i + i*(i-1)/2) / 2^(n+1): half a level after 724 pixels for n = 18.
// Example     FRACTION = 8, start_r = 25600 (100.0), first_r = 640 (2.5), second_r = -64 (-0.25); a
//             load and three steps: r = 100, 103, 105, 107
`default_nettype none
`include "glint_formats.vh"

module quadratic_span #(
    parameter integer FRACTION = `GLINT_QUADRATIC_SPAN_FRACTION_DEFAULT,
    parameter integer W        = `GLINT_QUADRATIC_SPAN_INT_BITS + FRACTION // width, for short
) (
    input  wire                         clk,
    input  wire                         reset,
    input  wire                         en,
    input  wire                         load,
    input  wire                         step,
    input  wire signed [W-1:0]          start_r,
    input  wire signed [W-1:0]          start_g,
    input  wire signed [W-1:0]          start_b,
    input  wire signed [W-1:0]          first_r,
    input  wire signed [W-1:0]          first_g,
    input  wire signed [W-1:0]          first_b,
    input  wire signed [W-1:0]          second_r,
    input  wire signed [W-1:0]          second_g,
    input  wire signed [W-1:0]          second_b,
    output wire                         out_valid,
    output wire [`GLINT_COLOR_BITS-1:0] r,
    output wire [`GLINT_COLOR_BITS-1:0] g,
    output wire [`GLINT_COLOR_BITS-1:0] b
);
    localparam C = `GLINT_COLOR_BITS;

    wire         s1_valid;
    wire [C-1:0] clamped_r;
    wire [C-1:0] clamped_g;
    wire [C-1:0] clamped_b;

    quadratic_component #(.FRACTION(FRACTION)) u_r (
        .clk(clk), .reset(reset), .en(en), .load(load), .step(step),
        .start(start_r), .first(first_r), .second(second_r), .clamped(clamped_r));
    quadratic_component #(.FRACTION(FRACTION)) u_g (
        .clk(clk), .reset(reset), .en(en), .load(load), .step(step),
        .start(start_g), .first(first_g), .second(second_g), .clamped(clamped_g));
    quadratic_component #(.FRACTION(FRACTION)) u_b (
        .clk(clk), .reset(reset), .en(en), .load(load), .step(step),
        .start(start_b), .first(first_b), .second(second_b), .clamped(clamped_b));

    stage_register #(.WIDTH(2)) u_valid (
        .clk(clk), .reset(reset), .en(en), .d({load || step, s1_valid}), .q({s1_valid, out_valid}));
    stage_register #(.WIDTH(3 * C)) u_out (
        .clk(clk), .reset(reset), .en(en && s1_valid),
        .d({clamped_r, clamped_g, clamped_b}), .q({r, g, b}));
endmodule

`default_nettype wire
