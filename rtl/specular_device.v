// specular_device: the specular-colour device of figure 3.1 (thesis section 3.1).
//
// Function    out = W times (R, G, B),  W = (sigma (cos - 1) + 1)^2 inside the highlight, 0
//             outside, sigma = (n + 1) / 3, for LANES cosines per clock with one material (n, R, G,
//             B).
// Blocks      registers 2 to 5, ROM 33, ROM 9 here; the others once per lane in specular_lane.
//             Signals carry the block's number: reg2, rom33, lane[0].adder6, lane[0].keys12 ...
//             A prefix s2_, s3_ names the pipeline stage that a delayed copy belongs to.
// Formats     cos U1.18 (codes above 1.0 saturate), n U10.0, r, g, b U8.0 (already times Ks),
//             out_w U1.(18 - W_DROP), out_r, out_g, out_b U8.0; lane i in bits [i*width +: width]
// Rounding    half up, see specular_lane; each output within 0.52 of an 8-bit step of the formula
// Latency     PIPELINED = 1: 4 clocks; 0: 1 clock, registers 1-5 and then combinational.
//             Counted from the edge that accepts the cosine to the edge after which its result is
//             out, both included. Throughput: LANES cosines per clock, every clock.
// Reset       synchronous, active high; clears every register, regardless of en.
// Handshake   in_valid[i] = 1 at an enabled edge: lane i accepts its cosine; out_valid[i] marks its
//             result. There is no back pressure; en = 0 freezes the whole device instead.
//             n_we and rgb_we write the material with or without a cosine; a material written at
//             the same edge as a cosine applies to it and to later ones, never to earlier ones.
// Parameters  GATE      0 cosine (default), 1 sign, 2 drawn: see specular_lane
//             PIPELINED 1 (default) or 0
//             LANES     1 or more; 1 to 32 are tested
//             LEAN      0 (default) or 1, smaller multipliers: see specular_lane
//             W_DROP    0 (default), or places of W that are rounded off, half up
// Example     n = 80, r = 255, g = 190, b = 110, cos = 259523 (0.99): rom33 = 221184 (27),
//             rom9 = 252435 (0.963), and 4 clocks after the cosine out_w = 139714 (0.533),
//             out_r = 136, out_g = 101, out_b = 59
`default_nettype none
`include "glint_formats.vh"

module specular_device #(
    parameter integer GATE      = `GLINT_GATE_COSINE,
    parameter integer PIPELINED = 1,
    parameter integer LANES     = 1,
    parameter integer LEAN      = 0,
    parameter integer W_DROP    = 0
) (
    input  wire                               clk,
    input  wire                               reset,
    input  wire                               en,
    input  wire                               n_we,     // control input 18
    input  wire [`GLINT_N_BITS-1:0]           n,        // information input 17
    input  wire                               rgb_we,
    input  wire [`GLINT_COLOR_BITS-1:0]       r,
    input  wire [`GLINT_COLOR_BITS-1:0]       g,
    input  wire [`GLINT_COLOR_BITS-1:0]       b,
    input  wire [LANES-1:0]                   in_valid,
    input  wire [LANES*`GLINT_COS_BITS-1:0]   cos,      // information input 32
    output wire [LANES-1:0]                   out_valid,
    output wire [LANES*(`GLINT_W_BITS - W_DROP)-1:0] out_w,
    output wire [LANES*`GLINT_COLOR_BITS-1:0] out_r,
    output wire [LANES*`GLINT_COLOR_BITS-1:0] out_g,
    output wire [LANES*`GLINT_COLOR_BITS-1:0] out_b
);
    localparam RGB_BITS = 3 * `GLINT_COLOR_BITS;
    localparam W_BITS   = `GLINT_W_BITS - W_DROP;

    // Stage 1: registers 2 to 5 and the ROMs.
    wire [`GLINT_N_BITS-1:0]     reg2;
    wire [`GLINT_COLOR_BITS-1:0] reg3;
    wire [`GLINT_COLOR_BITS-1:0] reg4;
    wire [`GLINT_COLOR_BITS-1:0] reg5;

    stage_register #(.WIDTH(`GLINT_N_BITS)) u_reg2 (
        .clk(clk), .reset(reset), .en(en && n_we), .d(n), .q(reg2));
    stage_register #(.WIDTH(RGB_BITS)) u_reg345 (
        .clk(clk), .reset(reset), .en(en && rgb_we), .d({r, g, b}), .q({reg3, reg4, reg5}));

    wire [`GLINT_SIGMA_BITS-1:0] rom33;
    sigma_rom u_rom33 (.n(reg2), .sigma(rom33));

    wire [`GLINT_COS_BITS-1:0] rom9;
    generate
        if (GATE == `GLINT_GATE_COSINE) begin : g_rom9
            limit_rom u_rom9 (.n(reg2), .limit(rom9));
        end else if (GATE == `GLINT_GATE_DRAWN) begin : g_rom9
            assign rom9 = `GLINT_DRAWN_LIMIT;
        end else if (GATE == `GLINT_GATE_SIGN) begin : g_rom9
            assign rom9 = {`GLINT_COS_BITS{1'b0}};
        end else begin : g_rom9
            GATE_must_be_0_1_or_2 error(); // no such module: elaboration stops here
        end
    endgenerate

    // The valid bits and the material travel alongside the lanes, stage by stage.
    wire [LANES-1:0]             s1_valid;
    wire [LANES-1:0]             s2_valid;
    wire [LANES-1:0]             s3_valid;
    wire [`GLINT_COS_BITS-1:0]   s2_rom9;
    wire [`GLINT_COLOR_BITS-1:0] s2_reg3;
    wire [`GLINT_COLOR_BITS-1:0] s2_reg4;
    wire [`GLINT_COLOR_BITS-1:0] s2_reg5;
    wire [`GLINT_COLOR_BITS-1:0] s3_reg3;
    wire [`GLINT_COLOR_BITS-1:0] s3_reg4;
    wire [`GLINT_COLOR_BITS-1:0] s3_reg5;

    stage_register #(.WIDTH(LANES)) u_s1_valid (
        .clk(clk), .reset(reset), .en(en), .d(in_valid), .q(s1_valid));

    stage_register #(.WIDTH(LANES), .CLOCKED(PIPELINED)) u_s2_valid (
        .clk(clk), .reset(reset), .en(en), .d(s1_valid), .q(s2_valid));
    stage_register #(.WIDTH(`GLINT_COS_BITS), .CLOCKED(PIPELINED)) u_s2_rom9 (
        .clk(clk), .reset(reset), .en(en), .d(rom9), .q(s2_rom9));
    stage_register #(.WIDTH(RGB_BITS), .CLOCKED(PIPELINED)) u_s2_rgb (
        .clk(clk), .reset(reset), .en(en), .d({reg3, reg4, reg5}), .q({s2_reg3, s2_reg4, s2_reg5}));

    stage_register #(.WIDTH(LANES), .CLOCKED(PIPELINED)) u_s3_valid (
        .clk(clk), .reset(reset), .en(en), .d(s2_valid), .q(s3_valid));
    stage_register #(.WIDTH(RGB_BITS), .CLOCKED(PIPELINED)) u_s3_rgb (
        .clk(clk), .reset(reset), .en(en),
        .d({s2_reg3, s2_reg4, s2_reg5}), .q({s3_reg3, s3_reg4, s3_reg5}));

    stage_register #(.WIDTH(LANES), .CLOCKED(PIPELINED)) u_out_valid (
        .clk(clk), .reset(reset), .en(en), .d(s3_valid), .q(out_valid));

    genvar i;
    generate
        for (i = 0; i < LANES; i = i + 1) begin : lane
            specular_lane #(
                .GATE(GATE), .PIPELINED(PIPELINED), .LEAN(LEAN), .W_DROP(W_DROP)
            ) u (
                .clk(clk), .reset(reset), .en(en),
                .in_valid(in_valid[i]),
                .cos(cos[i*`GLINT_COS_BITS +: `GLINT_COS_BITS]),
                .rom33(rom33), .rom9(rom9), .s2_rom9(s2_rom9),
                .s3_reg3(s3_reg3), .s3_reg4(s3_reg4), .s3_reg5(s3_reg5),
                .out_w(out_w[i*W_BITS +: W_BITS]),
                .out_r(out_r[i*`GLINT_COLOR_BITS +: `GLINT_COLOR_BITS]),
                .out_g(out_g[i*`GLINT_COLOR_BITS +: `GLINT_COLOR_BITS]),
                .out_b(out_b[i*`GLINT_COLOR_BITS +: `GLINT_COLOR_BITS]));
        end
    endgenerate
endmodule

`default_nettype wire
