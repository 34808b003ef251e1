// unit_square: t^2 of a t in 0..1, rounded half up to as many fraction bits; combinational.
//
// Formats     t, square U1.FRAC, at most 1.0
`default_nettype none

module unit_square #(
    parameter integer FRAC = 16
) (
    input  wire [FRAC:0] t,
    output wire [FRAC:0] square
);
    localparam [2*FRAC+1:0] HALF = {{(FRAC + 2){1'b0}}, 1'b1, {(FRAC - 1){1'b0}}};

    wire [2*FRAC+1:0] sum = t * t + HALF;
    wire              high_unused; // t at most 1.0 leaves it 0
    wire [FRAC-1:0]   low_unused;
    assign {high_unused, square, low_unused} = sum;
endmodule

`default_nettype wire
