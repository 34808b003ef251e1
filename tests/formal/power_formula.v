// The power device's arithmetic as docs/highlight-units.md states it, a module for each step of
//
//   x = 1 - cos,  p = n x,  v = p g(x),  W = 2^(-v),  (R,G,B)out = W times (R,G,B)
//
// What g and the power of two are is what the ROMs hold; power_roms_proof says what of that
// matters.
`default_nettype none

// 1 - cos in U0.18: above 1.0 it is 0, and where it would be 1.0 the next below.
module power_formula_x (
    input  wire [18:0] cos,
    output wire [17:0] x
);
    wire [19:0] difference = 20'd262144 - {1'b0, cos};
    assign x = difference[19] ? 18'd0 : difference[18] ? 18'd262143 : difference[17:0];
endmodule

// p in U4.12, cut off; over: it does not fit.
module power_formula_p (
    input  wire [17:0] x,
    input  wire [9:0]  n,
    output wire [15:0] p,
    output wire        over
);
    wire [27:0] product = n * x;
    assign p    = product >> 6;
    assign over = product >= 28'd4194304;
endmodule

// v in U4.TABLE_BITS, half up; small: below 16, so that the power of two is not 0.
module power_formula_v #(
    parameter integer TABLE_BITS = 8
) (
    input  wire [15:0]           p,
    input  wire                  over,
    input  wire [TABLE_BITS+3:0] g,
    output wire [TABLE_BITS+3:0] v,
    output wire                  small
);
    wire [TABLE_BITS+19:0] product = p * g;
    wire [TABLE_BITS+19:0] rounded = (product + 2048) >> 12;
    assign v     = rounded;
    assign small = !over && rounded < (16 << TABLE_BITS);
endmodule

module power_formula_w #(
    parameter integer TABLE_BITS = 8
) (
    input  wire [TABLE_BITS+3:0]   v,
    input  wire                    small,
    input  wire [2*TABLE_BITS-4:0] power, // 2 to the power of minus the fraction of v
    output wire [2*TABLE_BITS-4:0] w
);
    wire [TABLE_BITS+3:0] whole = v >> TABLE_BITS;
    assign w = small ? power >> whole : {(2 * TABLE_BITS - 3){1'b0}};
endmodule

module power_formula_color #(
    parameter integer W_BITS = 13
) (
    input  wire [W_BITS-1:0] w,
    input  wire [7:0]        color,
    output wire [7:0]        product
);
    wire [W_BITS+7:0] exact = w * color;
    assign product = (exact + (1 << (W_BITS - 2))) >> (W_BITS - 1);
endmodule

`default_nettype wire
