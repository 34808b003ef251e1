// color_multiplier: multiplier 13, 14 or 15 of figure 3.1.
//
// Function    product = w times color
// Formats     w U1.W_FRAC_BITS, at most 1.0;  color, product U8.0
// Rounding    half up, at the binary point of the product
// Latency     combinational; no reset, no handshake
// Parameters  W_FRAC_BITS  fraction bits of w: those of the specular device's W (default)
// Example     w = 139714 (0.533), color = 255: product = 136
`default_nettype none
`include "glint_formats.vh"

module color_multiplier #(
    parameter integer W_FRAC_BITS = `GLINT_W_FRAC_BITS
) (
    input  wire [W_FRAC_BITS:0]         w,
    input  wire [`GLINT_COLOR_BITS-1:0] color,
    output wire [`GLINT_COLOR_BITS-1:0] product
);
    localparam SUM_BITS = 1 + W_FRAC_BITS + `GLINT_COLOR_BITS;
    localparam [SUM_BITS-1:0] HALF = {{(`GLINT_COLOR_BITS + 1){1'b0}}, 1'b1,
                                      {(W_FRAC_BITS - 1){1'b0}}};

    wire [SUM_BITS-1:0]    sum = w * color + HALF;
    wire                   high_unused; // 0, since w is at most 1.0
    wire [W_FRAC_BITS-1:0] low_unused;
    assign {high_unused, product, low_unused} = sum;
endmodule

`default_nettype wire
