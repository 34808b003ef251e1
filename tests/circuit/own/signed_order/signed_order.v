// signed_order: two signed numbers in order, and how far apart they are. No clock.
//
// Function    lesser = min(a, b), greater = max(a, b), distance = greater - lesser
// Formats     a, b, lesser, greater S4.WIDTH-4;  distance U4.WIDTH-4
// Rounding    none
// Latency     0: the outputs are those of the inputs.
// Handshake   none
// Reset       none
// Parameters  WIDTH 5..12
`default_nettype none

module signed_order #(
    parameter integer WIDTH = 8
) (
    input  wire signed [WIDTH-1:0] a,
    input  wire signed [WIDTH-1:0] b,
    output wire signed [WIDTH-1:0] lesser,
    output wire signed [WIDTH-1:0] greater,
    output wire        [WIDTH-1:0] distance
);
    wire swap = b < a;

    assign lesser   = swap ? b : a;
    assign greater  = swap ? a : b;
    assign distance = greater - lesser;
endmodule

`default_nettype wire
