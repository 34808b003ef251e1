// material_path: registers 2 to 5 of a highlight unit, and the material and valid bits that travel
// beside its lanes, stage by stage.
//
// Function    stage 1 holds n, R, G, B as they were last written and which lanes took a cosine;
//             each later stage what the stage before it held a clock ago.
// Blocks      reg2, reg3, reg4, reg5 and valid of stage 1; stage[i].s_reg3 ... of the others
// Formats     n U10.0, r, g, b U8.0
// Latency     reg2 to reg5: 1 clock; last_n: N_STAGES; last_r, last_g, last_b: STAGES; out_valid:
//             STAGES + 1. PIPELINED = 0: 1 for all of them.
// Reset       synchronous, active high; clears every register, whatever en says. en = 0 holds them.
// Handshake   n_we and rgb_we write the material, with or without a cosine.
// Parameters  STAGES    2 or more: the stage that multiplies the colours
//             N_STAGES  1 to STAGES: the last stage that needs n
//             PIPELINED 1 (default), or 0: every stage but the first is a wire
//             LANES     1 or more
`default_nettype none
`include "glint_formats.vh"

module material_path #(
    parameter integer STAGES    = 3,
    parameter integer N_STAGES  = 1,
    parameter integer PIPELINED = 1,
    parameter integer LANES     = 1
) (
    input  wire                         clk,
    input  wire                         reset,
    input  wire                         en,
    input  wire                         n_we,
    input  wire [`GLINT_N_BITS-1:0]     n,
    input  wire                         rgb_we,
    input  wire [`GLINT_COLOR_BITS-1:0] r,
    input  wire [`GLINT_COLOR_BITS-1:0] g,
    input  wire [`GLINT_COLOR_BITS-1:0] b,
    input  wire [LANES-1:0]             in_valid,
    output wire [`GLINT_N_BITS-1:0]     last_n,
    output wire [`GLINT_COLOR_BITS-1:0] last_r,
    output wire [`GLINT_COLOR_BITS-1:0] last_g,
    output wire [`GLINT_COLOR_BITS-1:0] last_b,
    output wire [LANES-1:0]             out_valid
);
    localparam RGB_BITS = 3 * `GLINT_COLOR_BITS;

    wire [`GLINT_N_BITS-1:0]     reg2;
    wire [`GLINT_COLOR_BITS-1:0] reg3;
    wire [`GLINT_COLOR_BITS-1:0] reg4;
    wire [`GLINT_COLOR_BITS-1:0] reg5;
    wire [LANES-1:0]             valid;
    stage_register #(.WIDTH(`GLINT_N_BITS)) u_reg2 (
        .clk(clk), .reset(reset), .en(en && n_we), .d(n), .q(reg2));
    stage_register #(.WIDTH(RGB_BITS)) u_reg345 (
        .clk(clk), .reset(reset), .en(en && rgb_we), .d({r, g, b}), .q({reg3, reg4, reg5}));
    stage_register #(.WIDTH(LANES)) u_valid (
        .clk(clk), .reset(reset), .en(en), .d(in_valid), .q(valid));

    // What stage i has, at i*WIDTH.
    wire [(STAGES+1)*LANES-1:0]            valids;
    wire [(STAGES+1)*RGB_BITS-1:0]         colors;
    wire [(N_STAGES+1)*`GLINT_N_BITS-1:0]  exponents;
    assign valids[0 +: LANES]                                = {LANES{1'b0}};
    assign colors[0 +: RGB_BITS]                             = {RGB_BITS{1'b0}};
    assign exponents[0 +: `GLINT_N_BITS]                     = {`GLINT_N_BITS{1'b0}};
    assign valids[LANES +: LANES]                            = valid;
    assign colors[RGB_BITS +: RGB_BITS]                      = {reg3, reg4, reg5};
    assign exponents[`GLINT_N_BITS +: `GLINT_N_BITS]         = reg2;
    wire first_unused = &{1'b0, valids[0 +: LANES], colors[0 +: RGB_BITS],
                          exponents[0 +: `GLINT_N_BITS]};

    genvar i;
    generate
        for (i = 2; i <= STAGES; i = i + 1) begin : stage
            wire [LANES-1:0]             s_valid;
            wire [`GLINT_COLOR_BITS-1:0] s_reg3;
            wire [`GLINT_COLOR_BITS-1:0] s_reg4;
            wire [`GLINT_COLOR_BITS-1:0] s_reg5;
            stage_register #(.WIDTH(LANES), .CLOCKED(PIPELINED)) u_valid (
                .clk(clk), .reset(reset), .en(en), .d(valids[(i-1)*LANES +: LANES]), .q(s_valid));
            stage_register #(.WIDTH(RGB_BITS), .CLOCKED(PIPELINED)) u_rgb (
                .clk(clk), .reset(reset), .en(en), .d(colors[(i-1)*RGB_BITS +: RGB_BITS]),
                .q({s_reg3, s_reg4, s_reg5}));
            assign valids[i*LANES +: LANES]       = s_valid;
            assign colors[i*RGB_BITS +: RGB_BITS] = {s_reg3, s_reg4, s_reg5};

            if (i <= N_STAGES) begin : g_n
                wire [`GLINT_N_BITS-1:0] s_reg2;
                stage_register #(.WIDTH(`GLINT_N_BITS), .CLOCKED(PIPELINED)) u_n (
                    .clk(clk), .reset(reset), .en(en),
                    .d(exponents[(i-1)*`GLINT_N_BITS +: `GLINT_N_BITS]), .q(s_reg2));
                assign exponents[i*`GLINT_N_BITS +: `GLINT_N_BITS] = s_reg2;
            end
        end
    endgenerate

    assign last_n                   = exponents[N_STAGES*`GLINT_N_BITS +: `GLINT_N_BITS];
    assign {last_r, last_g, last_b} = colors[STAGES*RGB_BITS +: RGB_BITS];
    stage_register #(.WIDTH(LANES), .CLOCKED(PIPELINED)) u_out_valid (
        .clk(clk), .reset(reset), .en(en), .d(valids[STAGES*LANES +: LANES]), .q(out_valid));
endmodule

`default_nettype wire
