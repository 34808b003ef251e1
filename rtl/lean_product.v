// lean_product: sigma (cos - 1) with one multiplier of 23 x 18 bits.
//
// Function    product = sigma (cos - 1), exact.
//             cos - 1 has 19 bits with its sign; y = cos - 1/2 has 18 where cos is below 1, and
//             sigma (cos - 1) = sigma y - sigma/2. At cos = 1 sigma is taken as 0.
// Formats     sigma U9.13, cos U1.18, at most 1.0; product S10.31
// Rounding    none
// Latency     combinational; no reset, no handshake
// Example     sigma = 221184 (27), cos = 259523 (0.99): product = -579723264 (-0.26995)
`default_nettype none
`include "glint_formats.vh"

module lean_product (
    input  wire [`GLINT_SIGMA_BITS-1:0]                               sigma,
    input  wire [`GLINT_COS_BITS-1:0]                                 cos,
    output wire signed [`GLINT_T_BITS + `GLINT_SIGMA_FRAC_BITS - 1:0] product
);
    localparam Y_BITS       = `GLINT_COS_FRAC_BITS;
    localparam PRODUCT_BITS = `GLINT_T_BITS + `GLINT_SIGMA_FRAC_BITS;

    wire signed [Y_BITS-1:0]          y        = {!cos[Y_BITS-1], cos[Y_BITS-2:0]};
    wire signed [`GLINT_SIGMA_BITS:0] factor   = {1'b0, cos[Y_BITS] ? {`GLINT_SIGMA_BITS{1'b0}}
                                                                    : sigma};
    wire signed [PRODUCT_BITS-1:0]    half     = {
        {(PRODUCT_BITS - `GLINT_SIGMA_BITS - Y_BITS){1'b0}}, factor, {(Y_BITS - 1){1'b0}}};
    assign product = factor * y - half;
endmodule

`default_nettype wire
