// power_device: a highlight unit that is accurate against Blinn's cos^n, of the specular device's
// inventory (docs/highlight-units.md).
//
// Function    out = W times (R, G, B),  W = cos^n = 2^(-n x g(x)), x = 1 - cos, g = -log2(1 - x)/x,
//             for LANES cosines a clock with one material (n, R, G, B).
// Blocks      registers 2 to 5 in material_path; the others once a lane in power_lane. Signals
//             carry the number of the block of figure 3.1 whose place they take: path.reg2,
//             lane[0].u.mul7 ... A prefix s2_, s3_ names the pipeline stage of a delayed copy.
// Formats     cos U1.18 (codes above 1.0 saturate), n U10.0, r, g, b U8.0 (already times Ks),
//             out_w U1.(12 + 2 ACCURACY - W_DROP), out_r, out_g, out_b U8.0; lane i in bits
//             [i*width +: width]
// Rounding    see power_lane; W is within 0.4981/255 (ACCURACY 0) or 0.2491/255 (1) of cos^n for
//             every cosine and n, each colour within half a step more
// Latency     PIPELINED = 1: 5 clocks; 0: 1 clock, registers 1-5 and then combinational.
//             Counted from the edge that takes the cosine to the edge after which its result is
//             out, both included. Throughput: LANES cosines a clock, every clock.
// Reset       synchronous, active high; clears every register, whatever en says.
// Handshake   in_valid[i] = 1 at an enabled edge: lane i takes its cosine; out_valid[i] marks its
//             result. There is no back pressure; en = 0 freezes the whole device instead.
//             n_we and rgb_we write the material with or without a cosine; a material written at
//             the same edge as a cosine applies to it and to later ones, never to earlier ones.
// Parameters  ACCURACY  0 (default): half an 8-bit step, tables of 256; 1: a quarter, tables of 512
//             W_DROP    0 (default), or places of W that are rounded off, half up
//             PIPELINED 1 (default) or 0
//             LANES     1 or more; tried are 1 to 32
`default_nettype none
`include "glint_formats.vh"

module power_device #(
    parameter integer ACCURACY  = 0,
    parameter integer W_DROP    = 0,
    parameter integer PIPELINED = 1,
    parameter integer LANES     = 1
) (
    input  wire                                  clk,
    input  wire                                  reset,
    input  wire                                  en,
    input  wire                                  n_we,
    input  wire [`GLINT_N_BITS-1:0]              n,
    input  wire                                  rgb_we,
    input  wire [`GLINT_COLOR_BITS-1:0]          r,
    input  wire [`GLINT_COLOR_BITS-1:0]          g,
    input  wire [`GLINT_COLOR_BITS-1:0]          b,
    input  wire [LANES-1:0]                      in_valid,
    input  wire [LANES*`GLINT_COS_BITS-1:0]      cos,
    output wire [LANES-1:0]                      out_valid,
    output wire [LANES*(13 + 2 * ACCURACY - W_DROP)-1:0] out_w,
    output wire [LANES*`GLINT_COLOR_BITS-1:0]    out_r,
    output wire [LANES*`GLINT_COLOR_BITS-1:0]    out_g,
    output wire [LANES*`GLINT_COLOR_BITS-1:0]    out_b
);
    localparam TABLE_BITS = 8 + ACCURACY;
    localparam W_BITS     = 2 * TABLE_BITS - 3 - W_DROP;

    wire [`GLINT_N_BITS-1:0]     last_n;
    wire [`GLINT_COLOR_BITS-1:0] last_r;
    wire [`GLINT_COLOR_BITS-1:0] last_g;
    wire [`GLINT_COLOR_BITS-1:0] last_b;
    material_path #(.STAGES(4), .N_STAGES(1), .PIPELINED(PIPELINED), .LANES(LANES)) path (
        .clk(clk), .reset(reset), .en(en), .n_we(n_we), .n(n), .rgb_we(rgb_we), .r(r), .g(g), .b(b),
        .in_valid(in_valid), .last_n(last_n), .last_r(last_r), .last_g(last_g), .last_b(last_b),
        .out_valid(out_valid));

    genvar i;
    generate
        for (i = 0; i < LANES; i = i + 1) begin : lane
            power_lane #(.PIPELINED(PIPELINED), .W_DROP(W_DROP), .TABLE_BITS(TABLE_BITS)) u (
                .clk(clk), .reset(reset), .en(en),
                .in_valid(in_valid[i]),
                .cos(cos[i*`GLINT_COS_BITS +: `GLINT_COS_BITS]),
                .n(last_n), .last_r(last_r), .last_g(last_g), .last_b(last_b),
                .out_w(out_w[i*W_BITS +: W_BITS]),
                .out_r(out_r[i*`GLINT_COLOR_BITS +: `GLINT_COLOR_BITS]),
                .out_g(out_g[i*`GLINT_COLOR_BITS +: `GLINT_COLOR_BITS]),
                .out_b(out_b[i*`GLINT_COLOR_BITS +: `GLINT_COLOR_BITS]));
        end
    endgenerate
endmodule

`default_nettype wire
