// The specular-colour device's arithmetic as docs/device.md and docs/formats.md state it, a module
// for each step of
//
//   t = sigma (cos - 1) + 1,  W = t^2 inside the highlight, else 0,  (R,G,B)out = W times (R,G,B)
//
// with rounding half up where a number becomes shorter. Sigma is what ROM 33 holds;
// what it holds is shown by rom_proof.
`default_nettype none

// Gates cosine and sign are one here: inside is where t is not negative.
module formula_t (
    input  wire        [18:0] cos,
    input  wire        [21:0] sigma,
    output wire signed [27:0] t
);
    // cos - 1 in S1.18, written as adder 6 does it: the integer digit less 1, which modulo 2 is
    // plus 1. So Yosys finds one multiplication where the device and this module have the same.
    wire               digit   = cos[18] + 1'b1;
    wire signed [18:0] x       = {digit, cos[17:0]};
    wire signed [22:0] factor  = {1'b0, sigma};
    wire signed [40:0] product = factor * x;
    assign t = ((product + 41'sd4096) >>> 13) + 41'sd262144;
endmodule

module formula_w #(
    parameter integer GATE = 0
) (
    input  wire signed [27:0] t,
    input  wire               inside, // not for gate drawn
    output wire        [18:0] w
);
    generate
        if (GATE == 2) begin : g_w
            // t^2 in U17.18: that it fits is roms_proof's range.
            wire signed [52:0] product = t * t;
            wire        [52:0] rounded = product + 53'sd131072;
            wire        [34:0] square  = rounded[52:18];
            assign w = square < 35'd514 ? 19'd0 : square > 35'd262144 ? 19'd262144 : square[18:0];
        end else begin : g_w
            wire [37:0] product = t[18:0] * t[18:0];
            wire [37:0] square  = (product + 38'd131072) >> 18;
            assign w = inside ? square[18:0] : 19'd0;
        end
    endgenerate
endmodule

module formula_color (
    input  wire [18:0] w,
    input  wire [7:0]  color,
    output wire [7:0]  product
);
    wire [26:0] exact = w * color;
    assign product = (exact + 27'd131072) >> 18;
endmodule

`default_nettype wire
