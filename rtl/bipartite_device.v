// bipartite_device: a highlight unit by a table of cos^n for one n: a rival of the specular device,
// behind its pins (docs/highlight-units.md).
//
// Function    out = W times (R, G, B) for LANES cosines a clock with one material (R, G, B); n is
//             8 << EXPONENT, and what the pin n says is written but not used.
// Formats     cos U1.18 (codes above 1.0 saturate), n U10.0, r, g, b U8.0, out_w U1.(12 - W_DROP),
//             out_r, out_g, out_b U8.0; lane i in bits [i*width +: width]
// Rounding    see bipartite_lane
// Latency     PIPELINED = 1: 4 clocks; 0: 1. Throughput: LANES cosines a clock.
// Reset       synchronous, active high; clears every register, whatever en says.
// Handshake   as specular_device: in_valid[i] = 1 at an enabled edge: lane i takes its cosine;
//             out_valid[i] marks its result; n_we and rgb_we write the material; en = 0 freezes
//             everything.
// Parameters  EXPONENT  0 (default): n = 8; 1: 16; 2: 32
//             W_DROP    0 (default), or places of W that are rounded off, half up
//             PIPELINED 1 (default) or 0;  LANES 1 or more
`default_nettype none
`include "glint_formats.vh"

module bipartite_device #(
    parameter integer EXPONENT  = 0,
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
    output wire [LANES*(`GLINT_BIPARTITE_FRAC_BITS + 1 - W_DROP)-1:0] out_w,
    output wire [LANES*`GLINT_COLOR_BITS-1:0]    out_r,
    output wire [LANES*`GLINT_COLOR_BITS-1:0]    out_g,
    output wire [LANES*`GLINT_COLOR_BITS-1:0]    out_b
);
    localparam W_BITS = `GLINT_BIPARTITE_FRAC_BITS + 1 - W_DROP;

    wire [`GLINT_N_BITS-1:0]     last_n;
    wire [`GLINT_COLOR_BITS-1:0] last_r;
    wire [`GLINT_COLOR_BITS-1:0] last_g;
    wire [`GLINT_COLOR_BITS-1:0] last_b;
    material_path #(.STAGES(3), .N_STAGES(1), .PIPELINED(PIPELINED), .LANES(LANES)) path (
        .clk(clk), .reset(reset), .en(en), .n_we(n_we), .n(n), .rgb_we(rgb_we), .r(r), .g(g), .b(b),
        .in_valid(in_valid), .last_n(last_n), .last_r(last_r), .last_g(last_g), .last_b(last_b),
        .out_valid(out_valid));
    wire n_unused = &{1'b0, last_n};

    genvar i;
    generate
        for (i = 0; i < LANES; i = i + 1) begin : lane
            bipartite_lane #(.EXPONENT(EXPONENT), .W_DROP(W_DROP), .PIPELINED(PIPELINED)) u (
                .clk(clk), .reset(reset), .en(en),
                .in_valid(in_valid[i]),
                .cos(cos[i*`GLINT_COS_BITS +: `GLINT_COS_BITS]),
                .last_r(last_r), .last_g(last_g), .last_b(last_b),
                .out_w(out_w[i*W_BITS +: W_BITS]),
                .out_r(out_r[i*`GLINT_COLOR_BITS +: `GLINT_COLOR_BITS]),
                .out_g(out_g[i*`GLINT_COLOR_BITS +: `GLINT_COLOR_BITS]),
                .out_b(out_b[i*`GLINT_COLOR_BITS +: `GLINT_COLOR_BITS]));
        end
    endgenerate
endmodule

`default_nettype wire
