// divider_stage: one shift and one accumulating addition of pipelined_divider.
//
// Function    acc = in_acc + (iSTAGE ? d / 2^STAGE : 0) for three components
// Formats     d S9.0;  acc S9.n, n = SHIFTS;  bits: i0 highest, in lowest
// Rounding    none: d / 2^STAGE is a code with n fraction bits
// Latency     1 clock. Throughput: one division per clock.
// Reset       synchronous, active high, clears everything, regardless of en. en = 0 freezes all.
// Handshake   valid travels with the data.
// Example     SHIFTS = 12, STAGE = 6, k = 7, in_d_r = 255: in_bits = 585 (0.001001001001),
//             in_acc_r = 130560 (255/8); i6 is 1, so acc_r = 146880 (255/8 + 255/64), d_r = 255
`default_nettype none
`include "glint_formats.vh"

module divider_stage #(
    parameter integer SHIFTS = `GLINT_DIVIDER_SHIFTS_DEFAULT,
    parameter integer STAGE  = 1,
    parameter integer D      = `GLINT_DIVIDER_DIFFERENCE_BITS // widths, for short: of a difference
) (
    input  wire                       clk,
    input  wire                       reset,
    input  wire                       en,
    input  wire                       in_valid,
    input  wire                       in_miss,
    input  wire [SHIFTS:0]            in_bits,
    input  wire signed [D-1:0]        in_d_r,
    input  wire signed [D-1:0]        in_d_g,
    input  wire signed [D-1:0]        in_d_b,
    input  wire signed [D+SHIFTS-1:0] in_acc_r,
    input  wire signed [D+SHIFTS-1:0] in_acc_g,
    input  wire signed [D+SHIFTS-1:0] in_acc_b,
    output wire                       valid,
    output wire                       miss,
    output wire [SHIFTS:0]            bits,
    output wire signed [D-1:0]        d_r,
    output wire signed [D-1:0]        d_g,
    output wire signed [D-1:0]        d_b,
    output wire signed [D+SHIFTS-1:0] acc_r,
    output wire signed [D+SHIFTS-1:0] acc_g,
    output wire signed [D+SHIFTS-1:0] acc_b
);
    // d / 2^STAGE with n fraction bits: the sign fills in from the left. (One zero is appended on
    // the right and removed again, since the last stage would need a replication count of 0.)
    localparam W = D + SHIFTS;
    wire [W:0] wide_r = {{STAGE{in_d_r[D-1]}}, in_d_r, {(SHIFTS - STAGE + 1){1'b0}}};
    wire [W:0] wide_g = {{STAGE{in_d_g[D-1]}}, in_d_g, {(SHIFTS - STAGE + 1){1'b0}}};
    wire [W:0] wide_b = {{STAGE{in_d_b[D-1]}}, in_d_b, {(SHIFTS - STAGE + 1){1'b0}}};
    wire signed [W-1:0] term_r = wide_r[W:1];
    wire signed [W-1:0] term_g = wide_g[W:1];
    wire signed [W-1:0] term_b = wide_b[W:1];
    wire                add    = in_bits[SHIFTS-STAGE];
    wire                wide_unused = &{1'b0, wide_r[0], wide_g[0], wide_b[0]};

    stage_register #(.WIDTH(SHIFTS + 3)) u_slot (
        .clk(clk), .reset(reset), .en(en),
        .d({in_valid, in_miss, in_bits}), .q({valid, miss, bits}));
    stage_register #(.WIDTH(3 * D)) u_d (
        .clk(clk), .reset(reset), .en(en), .d({in_d_r, in_d_g, in_d_b}), .q({d_r, d_g, d_b}));
    stage_register #(.WIDTH(W)) u_acc_r (
        .clk(clk), .reset(reset), .en(en), .d(add ? in_acc_r + term_r : in_acc_r), .q(acc_r));
    stage_register #(.WIDTH(W)) u_acc_g (
        .clk(clk), .reset(reset), .en(en), .d(add ? in_acc_g + term_g : in_acc_g), .q(acc_g));
    stage_register #(.WIDTH(W)) u_acc_b (
        .clk(clk), .reset(reset), .en(en), .d(add ? in_acc_b + term_b : in_acc_b), .q(acc_b));
endmodule

`default_nettype wire
