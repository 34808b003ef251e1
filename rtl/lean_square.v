// lean_square: t^2 for t of -1 to 1, with one multiplier of 18 x 18 bits.
//
// Function    square = t^2, exact, where |t| is at most 1; elsewhere it means nothing.
//             (|t| - 1/2)^2 + |t| - 1/4: the square is of 18 bits with their sign. It takes no
//             case of its own at |t| = 1, where 1/2 wraps to -1/2, which has the same square; and
//             below 0 the low bits of t are 1 - |t|, whose distance from 1/2 is that of |t|.
// Formats     t S2.18; square U2.36
// Rounding    none
// Latency     combinational; no reset, no handshake
// Example     t = 191377 (0.73): square = 36625156129 (0.533)
`default_nettype none
`include "glint_formats.vh"

module lean_square (
    input  wire [`GLINT_W_BITS:0]     t,
    output wire [2*`GLINT_W_BITS-1:0] square
);
    localparam FRAC = `GLINT_W_FRAC_BITS;
    localparam [`GLINT_W_BITS-1:0] QUARTER = {3'b001, {(FRAC - 2){1'b0}}};

    wire [`GLINT_W_BITS-1:0]          low   = t[`GLINT_W_BITS-1:0];
    wire [`GLINT_W_BITS-1:0]          size  = t[`GLINT_W_BITS] ? {`GLINT_W_BITS{1'b0}} - low : low;
    wire [`GLINT_W_BITS-1:0]          rest  = size - QUARTER;
    wire signed [FRAC-1:0]            s     = {!t[FRAC-1], t[FRAC-2:0]};
    wire signed [2*`GLINT_W_BITS-1:0] line  = {rest[`GLINT_W_BITS-1], rest, {FRAC{1'b0}}};
    assign square = s * s + line;
endmodule

`default_nettype wire
