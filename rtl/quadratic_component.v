// quadratic_component: one colour component of quadratic_span: two adders, three registers.
//
// Function    load: value, slope, curve = start, first, second
//             step: value, slope = value + slope, slope + curve; curve stays
//             clamped = value, rounded and held in 0..255
// Formats     start, first, second, value, slope, curve S10.n, n = FRACTION; sums wrap around.
//             level S11.0, clamped U8.0
// Rounding    half up, of value to level
// Latency     1 clock to value; clamped follows it. Throughput: one value per clock.
// Reset       synchronous, active high, clears everything, regardless of en. en = 0 freezes all.
// Handshake   load goes before step; neither holds everything.
// Example     FRACTION = 8, start = 25600 (100.0), first = 640 (2.5), second = -64 (-0.25): values
//             100, 102.5, 104.75, 106.75; clamped = 100, 103, 105, 107
`default_nettype none
`include "glint_formats.vh"

module quadratic_component #(
    parameter integer FRACTION = `GLINT_QUADRATIC_SPAN_FRACTION_DEFAULT,
    parameter integer I        = `GLINT_QUADRATIC_SPAN_INT_BITS // for short
) (
    input  wire                         clk,
    input  wire                         reset,
    input  wire                         en,
    input  wire                         load,
    input  wire                         step,
    input  wire signed [I+FRACTION-1:0] start,
    input  wire signed [I+FRACTION-1:0] first,
    input  wire signed [I+FRACTION-1:0] second,
    output wire [`GLINT_COLOR_BITS-1:0] clamped
);
    localparam W = I + FRACTION;
    localparam C = `GLINT_COLOR_BITS;

    wire signed [W-1:0] value;
    wire signed [W-1:0] slope;
    wire signed [W-1:0] curve;
    wire signed [W-1:0] next_value = value + slope;
    wire signed [W-1:0] next_slope = slope + curve;

    stage_register #(.WIDTH(2 * W)) u_walk (
        .clk(clk), .reset(reset), .en(en && (load || step)),
        .d(load ? {start, first} : {next_value, next_slope}), .q({value, slope}));
    stage_register #(.WIDTH(W)) u_curve (
        .clk(clk), .reset(reset), .en(en && load), .d(second), .q(curve));

    // The whole levels, and one more from half a level on.
    wire signed [I:0] level = {value[W-1], value[W-1:FRACTION]} + {{I{1'b0}}, value[FRACTION-1]};
    wire              above = |level[I-1:C]; // of a level that is not negative: 256 or more
    assign clamped = level[I] ? {C{1'b0}} : above ? {C{1'b1}} : level[C-1:0];
endmodule

`default_nettype wire
