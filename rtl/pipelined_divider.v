// pipelined_divider: the divider of figure 2.13 unrolled, one division per clock.
//
// Function    quotient_x = difference_x * (i0 + i1/2 + ... + in/2^n) for three colour components by
//             one k: bit for bit what shift_divider gives.
// Formats     difference_* S9.0, -255..255;  k U8.0;  quotient_* S9.n, n = SHIFTS
// Rounding    none here: the rounding is in the table (reciprocal_rom).
// Latency     SHIFTS + 1 clocks from the edge that loads the inputs to the one after which the
//             quotients are out, both counted. Throughput: one division of three components per
//             clock.
// Handshake   in_valid at an enabled edge loads the inputs; out_valid marks the quotients. There is
//             no back pressure; en = 0 freezes the whole pipeline instead. out_of_table comes with
//             the quotients: k was 0 or above GLINT_DIVIDER_K_MAX, and they are 0.
// Reset       synchronous, active high, clears everything, regardless of en.
// Parameters  SHIFTS 6..16
// Example     SHIFTS = 12, k = 7, difference_r = 255, difference_g = -255,
//             difference_b = 14: rom_bits = 585 (0.001001001001), and 13 clocks on
//             quotient_r = 149175 (36.42), quotient_g = -149175, quotient_b = 8190 (1.9995)
`default_nettype none
`include "glint_formats.vh"

module pipelined_divider #(
    parameter integer SHIFTS = `GLINT_DIVIDER_SHIFTS_DEFAULT,
    parameter integer D      = `GLINT_DIVIDER_DIFFERENCE_BITS // width of a difference, for short
) (
    input  wire                             clk,
    input  wire                             reset,
    input  wire                             en,
    input  wire                             in_valid,
    input  wire [`GLINT_DIVIDER_K_BITS-1:0] k,
    input  wire signed [D-1:0]              difference_r,
    input  wire signed [D-1:0]              difference_g,
    input  wire signed [D-1:0]              difference_b,
    output wire                             out_valid,
    output wire                             out_of_table,
    output wire signed [D+SHIFTS-1:0]       quotient_r,
    output wire signed [D+SHIFTS-1:0]       quotient_g,
    output wire signed [D+SHIFTS-1:0]       quotient_b
);
    localparam W = D + SHIFTS;

    // The input registers and the table.
    wire                             s0_valid;
    wire [`GLINT_DIVIDER_K_BITS-1:0] s0_k;
    wire signed [D-1:0]              s0_d_r;
    wire signed [D-1:0]              s0_d_g;
    wire signed [D-1:0]              s0_d_b;

    stage_register #(.WIDTH(1)) u_s0_valid (
        .clk(clk), .reset(reset), .en(en), .d(in_valid), .q(s0_valid));
    stage_register #(.WIDTH(`GLINT_DIVIDER_K_BITS + 3 * D)) u_s0 (
        .clk(clk), .reset(reset), .en(en && in_valid),
        .d({k, difference_r, difference_g, difference_b}), .q({s0_k, s0_d_r, s0_d_g, s0_d_b}));

    wire [SHIFTS:0] rom_bits;
    wire            rom_miss;
    reciprocal_rom #(.SHIFTS(SHIFTS)) u_rom (.k(s0_k), .bits(rom_bits), .miss(rom_miss));

    // Between the stages: element j is the output of stage j. i0, for k = 1, is added before the
    // first.
    wire            valid [0:SHIFTS];
    wire            miss  [0:SHIFTS];
    wire [SHIFTS:0] bits  [0:SHIFTS];
    wire signed [D-1:0] d_r [0:SHIFTS];
    wire signed [D-1:0] d_g [0:SHIFTS];
    wire signed [D-1:0] d_b [0:SHIFTS];
    wire signed [W-1:0] acc_r [0:SHIFTS];
    wire signed [W-1:0] acc_g [0:SHIFTS];
    wire signed [W-1:0] acc_b [0:SHIFTS];

    assign valid[0] = s0_valid;
    assign miss[0]  = rom_miss;
    assign bits[0]  = rom_bits;
    assign d_r[0]   = s0_d_r;
    assign d_g[0]   = s0_d_g;
    assign d_b[0]   = s0_d_b;
    assign acc_r[0] = rom_bits[SHIFTS] ? {s0_d_r, {SHIFTS{1'b0}}} : {W{1'b0}};
    assign acc_g[0] = rom_bits[SHIFTS] ? {s0_d_g, {SHIFTS{1'b0}}} : {W{1'b0}};
    assign acc_b[0] = rom_bits[SHIFTS] ? {s0_d_b, {SHIFTS{1'b0}}} : {W{1'b0}};

    genvar j;
    generate
        for (j = 1; j <= SHIFTS; j = j + 1) begin : stage
            divider_stage #(.SHIFTS(SHIFTS), .STAGE(j)) u (
                .clk(clk), .reset(reset), .en(en),
                .in_valid(valid[j-1]), .in_miss(miss[j-1]), .in_bits(bits[j-1]),
                .in_d_r(d_r[j-1]), .in_d_g(d_g[j-1]), .in_d_b(d_b[j-1]),
                .in_acc_r(acc_r[j-1]), .in_acc_g(acc_g[j-1]), .in_acc_b(acc_b[j-1]),
                .valid(valid[j]), .miss(miss[j]), .bits(bits[j]),
                .d_r(d_r[j]), .d_g(d_g[j]), .d_b(d_b[j]),
                .acc_r(acc_r[j]), .acc_g(acc_g[j]), .acc_b(acc_b[j]));
        end
    endgenerate

    assign out_valid    = valid[SHIFTS];
    assign out_of_table = miss[SHIFTS];
    assign quotient_r   = acc_r[SHIFTS];
    assign quotient_g   = acc_g[SHIFTS];
    assign quotient_b   = acc_b[SHIFTS];

    wire last_unused = &{1'b0, bits[SHIFTS], d_r[SHIFTS], d_g[SHIFTS], d_b[SHIFTS]};
endmodule

`default_nettype wire
