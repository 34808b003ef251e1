// divider_stage: one shift and one accumulating addition of pipelined_divider.
//
// Function    acc = in_acc + (iSTAGE ? d / 2^STAGE : 0) for three components
// Formats     d S9.0;  acc S9.n, n = SHIFTS;  bits: i0 highest, in lowest
// Rounding    none: d / 2^STAGE is a code with n fraction bits
// Latency     1 clock. Throughput: one division a clock.
// Reset       synchronous, active high, clears everything, whatever en says. en = 0 freezes all.
// Handshake   valid travels beside the data.
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
    output reg                        valid,
    output reg                        miss,
    output reg  [SHIFTS:0]            bits,
    output reg  signed [D-1:0]        d_r,
    output reg  signed [D-1:0]        d_g,
    output reg  signed [D-1:0]        d_b,
    output reg  signed [D+SHIFTS-1:0] acc_r,
    output reg  signed [D+SHIFTS-1:0] acc_g,
    output reg  signed [D+SHIFTS-1:0] acc_b
);
    // d / 2^STAGE with n fraction bits: the sign fills the places on the left. (One zero is put on
    // the right and taken off again, since the last stage would need a replication of none.)
    localparam W = D + SHIFTS;
    wire [W:0] wide_r = {{STAGE{in_d_r[D-1]}}, in_d_r, {(SHIFTS - STAGE + 1){1'b0}}};
    wire [W:0] wide_g = {{STAGE{in_d_g[D-1]}}, in_d_g, {(SHIFTS - STAGE + 1){1'b0}}};
    wire [W:0] wide_b = {{STAGE{in_d_b[D-1]}}, in_d_b, {(SHIFTS - STAGE + 1){1'b0}}};
    wire signed [W-1:0] term_r = wide_r[W:1];
    wire signed [W-1:0] term_g = wide_g[W:1];
    wire signed [W-1:0] term_b = wide_b[W:1];
    wire                add    = in_bits[SHIFTS-STAGE];
    wire                wide_unused = &{1'b0, wide_r[0], wide_g[0], wide_b[0]};

    always @(posedge clk)
        if (reset) begin
            valid <= 1'b0;
            miss  <= 1'b0;
            bits  <= {(SHIFTS + 1){1'b0}};
            d_r   <= {D{1'b0}};
            d_g   <= {D{1'b0}};
            d_b   <= {D{1'b0}};
            acc_r <= {(D + SHIFTS){1'b0}};
            acc_g <= {(D + SHIFTS){1'b0}};
            acc_b <= {(D + SHIFTS){1'b0}};
        end else if (en) begin
            valid <= in_valid;
            miss  <= in_miss;
            bits  <= in_bits;
            d_r   <= in_d_r;
            d_g   <= in_d_g;
            d_b   <= in_d_b;
            acc_r <= add ? in_acc_r + term_r : in_acc_r;
            acc_g <= add ? in_acc_g + term_g : in_acc_g;
            acc_b <= add ? in_acc_b + term_b : in_acc_b;
        end
endmodule

`default_nettype wire
