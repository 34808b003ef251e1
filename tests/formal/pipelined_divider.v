// pipelined_divider_proof: the divider's pipelined form, any number of shifts. The prover chooses
// all inputs at each clock, including reset and en.
//
// Properties
//   uninvited, in_order, once, frozen   those of module flow, with LATENCY = SHIFTS + 1; the data
//                                       of a slot is k and the three differences
//   sum           at the turn of a slot the quotients are the sums of the table's terms, difference
//                 * ij / 2^j over j = 0 to SHIFTS: each term of its own difference and of the bits
//                 that the table has for its k is added once, while the slot moves
//   out_of_table  at the turn of a slot it says whether its k was 0 or beyond the table
// What the table holds is table_proof's.
`default_nettype none

module pipelined_divider_proof #(
    parameter integer SHIFTS = 12
) (
    input wire              clk,
    input wire              reset,
    input wire              en,
    input wire              in_valid,
    input wire [7:0]        k,
    input wire signed [8:0] difference_r,
    input wire signed [8:0] difference_g,
    input wire signed [8:0] difference_b
);
    localparam W       = 9 + SHIFTS;
    localparam LATENCY = SHIFTS + 1;
    localparam WIDTH   = 8 + 3 * 9;

    wire                out_valid, out_of_table;
    wire signed [W-1:0] quotient_r, quotient_g, quotient_b;
    pipelined_divider #(.SHIFTS(SHIFTS)) dut (
        .clk(clk), .reset(reset), .en(en), .in_valid(in_valid), .k(k), .difference_r(difference_r),
        .difference_g(difference_g), .difference_b(difference_b), .out_valid(out_valid),
        .out_of_table(out_of_table), .quotient_r(quotient_r), .quotient_g(quotient_g),
        .quotient_b(quotient_b));

    reg started = 1'b0;
    always @(posedge clk) started <= started || reset;

    (* hierconn *) wire            \dut.s0_valid ;
    (* hierconn *) wire [7:0]      \dut.s0_k ;
    (* hierconn *) wire [8:0]      \dut.s0_d_r , \dut.s0_d_g , \dut.s0_d_b ;

    // A slot without an input has the data of the last one, as the input registers keep it.
    wire [LATENCY-1:0]       valid;
    wire [LATENCY*WIDTH-1:0] history;
    flow #(.LATENCY(LATENCY), .WIDTH(WIDTH), .OUT(3*W+1)) u_flow (
        .clk(clk), .reset(reset), .en(en), .started(started), .in_valid(in_valid),
        .in_data(in_valid ? {k, difference_r, difference_g, difference_b} : history[WIDTH-1:0]),
        .out_valid(out_valid), .out({out_of_table, quotient_r, quotient_g, quotient_b}),
        .valid(valid), .history(history));

    always @* if (started) begin
        h_valid: assert (\dut.s0_valid == valid[0]);
        h_k:     assert (\dut.s0_k == history[27 +: 8]);
        h_r:     assert (\dut.s0_d_r == history[18 +: 9]);
        h_g:     assert (\dut.s0_d_g == history[9 +: 9]);
        h_b:     assert (\dut.s0_d_b == history[0 +: 9]);
    end

    // The table, as the divider should ask it.
    wire [SHIFTS:0] its_bits;
    wire            its_miss;
    reciprocal_rom #(.SHIFTS(SHIFTS)) u_table (
        .k(history[27 +: 8]), .bits(its_bits), .miss(its_miss));

    // At place j + 1: what goes with the slot, and the sums of its terms up to the one of 2^-j.
    wire [LATENCY*LATENCY-1:0] bits; // j's in [j*LATENCY +: LATENCY]
    wire [LATENCY-1:0]         miss;
    wire [LATENCY*W-1:0]       sum_r, sum_g, sum_b;
    assign bits[SHIFTS:0] = its_bits;
    assign miss[0]        = its_miss;
    assign sum_r[W-1:0]  = its_bits[SHIFTS] ? {history[18 +: 9], {SHIFTS{1'b0}}} : {W{1'b0}};
    assign sum_g[W-1:0]  = its_bits[SHIFTS] ? {history[9 +: 9], {SHIFTS{1'b0}}} : {W{1'b0}};
    assign sum_b[W-1:0]  = its_bits[SHIFTS] ? {history[0 +: 9], {SHIFTS{1'b0}}} : {W{1'b0}};

    genvar j;
    generate
        for (j = 1; j <= SHIFTS; j = j + 1) begin : \dut.stage
            (* hierconn *) wire            \u.valid , \u.miss ;
            (* hierconn *) wire [SHIFTS:0] \u.bits ;
            (* hierconn *) wire [8:0]      \u.d_r , \u.d_g , \u.d_b ;
            (* hierconn *) wire [W-1:0]    \u.acc_r , \u.acc_g , \u.acc_b ;

            place #(.SHIFTS(SHIFTS), .J(j)) u_place (
                .clk(clk), .reset(reset), .en(en), .started(started),
                .in_bits(bits[(j-1)*LATENCY +: LATENCY]), .in_miss(miss[j-1]),
                .in_d(history[(j-1)*WIDTH +: 27]),
                .in_r(sum_r[(j-1)*W +: W]), .in_g(sum_g[(j-1)*W +: W]), .in_b(sum_b[(j-1)*W +: W]),
                .bits(bits[j*LATENCY +: LATENCY]), .miss(miss[j]),
                .r(sum_r[j*W +: W]), .g(sum_g[j*W +: W]), .b(sum_b[j*W +: W]),
                .its_valid(valid[j]), .its_d(history[j*WIDTH +: 27]),
                .dut_valid(\u.valid ), .dut_miss(\u.miss ), .dut_bits(\u.bits ),
                .dut_d_r(\u.d_r ), .dut_d_g(\u.d_g ), .dut_d_b(\u.d_b ),
                .dut_r(\u.acc_r ), .dut_g(\u.acc_g ), .dut_b(\u.acc_b ));
        end
    endgenerate

    always @* if (started && out_valid) begin
        sum_r_:       assert (quotient_r == sum_r[SHIFTS*W +: W]);
        sum_g_:       assert (quotient_g == sum_g[SHIFTS*W +: W]);
        sum_b_:       assert (quotient_b == sum_b[SHIFTS*W +: W]);
        out_of_table_: assert (out_of_table == miss[SHIFTS]);
    end

    always @* if (started) begin
        c_sum:          cover (out_valid && quotient_r < 0 && quotient_g > 0
                               && bits[SHIFTS*LATENCY +: 2] == 2'd3);
        c_sum_one:      cover (out_valid && quotient_b != 0 && bits[LATENCY*LATENCY-1]);
        c_out_of_table: cover (out_valid && out_of_table &&
                               history[(LATENCY-1)*WIDTH +: 9] != 9'd0);
    end
endmodule

// place: the step of a slot from place J to place J + 1, and what the divider's stage must hold
// there.
module place #(
    parameter integer SHIFTS = 12,
    parameter integer J      = 1
) (
    input  wire                       clk,
    input  wire                       reset,
    input  wire                       en,
    input  wire                       started,
    input  wire [SHIFTS:0]            in_bits,
    input  wire                       in_miss,
    input  wire [26:0]                in_d,
    input  wire signed [8+SHIFTS:0]   in_r,
    input  wire signed [8+SHIFTS:0]   in_g,
    input  wire signed [8+SHIFTS:0]   in_b,
    output reg  [SHIFTS:0]            bits,
    output reg                        miss,
    output reg  signed [8+SHIFTS:0]   r,
    output reg  signed [8+SHIFTS:0]   g,
    output reg  signed [8+SHIFTS:0]   b,
    input  wire                       its_valid,
    input  wire [26:0]                its_d,
    input  wire                       dut_valid,
    input  wire                       dut_miss,
    input  wire [SHIFTS:0]            dut_bits,
    input  wire [8:0]                 dut_d_r,
    input  wire [8:0]                 dut_d_g,
    input  wire [8:0]                 dut_d_b,
    input  wire [8+SHIFTS:0]          dut_r,
    input  wire [8+SHIFTS:0]          dut_g,
    input  wire [8+SHIFTS:0]          dut_b
);
    wire signed [8+SHIFTS:0] whole_r = {in_d[26:18], {SHIFTS{1'b0}}};
    wire signed [8+SHIFTS:0] whole_g = {in_d[17:9], {SHIFTS{1'b0}}};
    wire signed [8+SHIFTS:0] whole_b = {in_d[8:0], {SHIFTS{1'b0}}};
    wire                     add     = in_bits[SHIFTS-J];
    always @(posedge clk)
        if (reset) begin
            bits <= {(SHIFTS + 1){1'b0}};
            miss <= 1'b0;
            r    <= {(9 + SHIFTS){1'b0}};
            g    <= {(9 + SHIFTS){1'b0}};
            b    <= {(9 + SHIFTS){1'b0}};
        end else if (en) begin
            bits <= in_bits;
            miss <= in_miss;
            r    <= add ? in_r + (whole_r >>> J) : in_r;
            g    <= add ? in_g + (whole_g >>> J) : in_g;
            b    <= add ? in_b + (whole_b >>> J) : in_b;
        end

    always @* if (started) begin
        h_valid: assert (dut_valid == its_valid);
        h_miss:  assert (dut_miss == miss);
        h_bits:  assert (dut_bits == bits);
        h_d_r:   assert (dut_d_r == its_d[26:18]);
        h_d_g:   assert (dut_d_g == its_d[17:9]);
        h_d_b:   assert (dut_d_b == its_d[8:0]);
        h_sum_r: assert (dut_r == r);
        h_sum_g: assert (dut_g == g);
        h_sum_b: assert (dut_b == b);
    end
endmodule

`default_nettype wire
