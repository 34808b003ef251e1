// shift_divider_proof: the divider's sequential form, any number of shifts. The prover chooses all
// inputs at each clock, including reset and en.
//
// age counts the enabled clocks since the last start that was taken, its own included; 0 where
// there was none since the reset, SHIFTS + 2 for more than SHIFTS + 1.
//
// Properties
//   busy, done    busy is 1 exactly while age is 1 to SHIFTS, done exactly while it is SHIFTS + 1.
//                 A start counts where busy is 0, one in the clock of done too; while busy is 1 it
//                 changes nothing.
//   once          divisions taken less done clocks, since the reset: 1 from the start to done, else
//                 0
//   sum           from done until the next start is taken, quotient is the sum of the table's
//                 terms, difference * ij / 2^j over j = 0 to SHIFTS, added here one at each enabled
//                 clock
//   out_of_table  in the same clocks it says whether k was 0 or beyond the table, and if so,
//                 quotient is 0
//   cleared       until the first start after a reset quotient and out_of_table are 0
//   frozen        a clock without enable and reset changes no output
// What the table holds is table_proof's.
`default_nettype none

module shift_divider_proof #(
    parameter integer SHIFTS = 12
) (
    input wire              clk,
    input wire              reset,
    input wire              en,
    input wire              start,
    input wire signed [8:0] difference,
    input wire [7:0]        k
);
    localparam W = 9 + SHIFTS;

    wire                busy, done, out_of_table;
    wire signed [W-1:0] quotient;
    shift_divider #(.SHIFTS(SHIFTS)) dut (
        .clk(clk), .reset(reset), .en(en), .start(start), .difference(difference), .k(k),
        .busy(busy), .done(done), .quotient(quotient), .out_of_table(out_of_table));

    (* hierconn *) wire [W-1:0]      \dut.shift_rg ;
    (* hierconn *) wire [SHIFTS-1:0] \dut.bits_rg ;
    (* hierconn *) wire [4:0]        \dut.left ;

    reg started = 1'b0;
    always @(posedge clk) started <= started || reset;

    // The table, as the divider should ask it.
    wire [SHIFTS:0] bits;
    wire            miss;
    reciprocal_rom #(.SHIFTS(SHIFTS)) u_table (.k(k), .bits(bits), .miss(miss));

    // The division under way, or the last one.
    reg        [4:0]      age;
    reg signed [8:0]      its_difference;
    reg        [SHIFTS:0] its_bits;
    reg                   its_miss;
    wire under_way = age >= 5'd1 && age <= SHIFTS;
    wire taken     = en && start && !under_way;
    always @(posedge clk)
        if (reset)
            age <= 5'd0;
        else if (taken) begin
            age            <= 5'd1;
            its_difference <= difference;
            its_bits       <= bits;
            its_miss       <= miss;
        end else if (en && age != 5'd0 && age != SHIFTS + 2)
            age <= age + 5'd1;

    // The terms of its sum that are due.
    wire        [4:0]        steps = age > SHIFTS ? SHIFTS : age - 5'd1; // places shifted by now
    wire signed [W-1:0]      whole = {its_difference, {SHIFTS{1'b0}}};
    wire signed [W-1:0]      first = {difference, {SHIFTS{1'b0}}};
    wire signed [W-1:0]      moved = whole >>> steps;
    wire signed [W-1:0]      next  = moved >>> 1;
    wire        [SHIFTS-1:0] rest  = its_bits[SHIFTS-1:0] << steps;
    reg signed  [W-1:0]      its_sum;
    always @(posedge clk)
        if (reset)                 its_sum <= {W{1'b0}};
        else if (taken)            its_sum <= bits[SHIFTS] ? first : {W{1'b0}};
        else if (en && under_way && rest[SHIFTS-1]) its_sum <= its_sum + next;

    reg [4:0] balance;
    reg       was_frozen;
    reg [W+2:0] last;
    always @(posedge clk) begin
        if (reset)   balance <= 5'd0;
        else if (en) balance <= balance + {4'd0, start && !busy} - {4'd0, done};
        was_frozen <= started && !en && !reset;
        last       <= {busy, done, out_of_table, quotient};
    end

    always @* if (started) begin
        h_age:  assert (age <= SHIFTS + 2);
        h_left: assert (age == 5'd0 || \dut.left == SHIFTS - steps);
        h_rest: assert (age == 5'd0 || \dut.bits_rg == rest);
        h_shift: assert (age == 5'd0 || \dut.shift_rg == moved);
        h_sum:  assert (quotient == its_sum);
        h_miss: assert (age == 5'd0 || out_of_table == its_miss);
        h_bits: assert (age == 5'd0 || !its_miss ||
                       {its_bits, its_sum} == {(SHIFTS + 1 + W){1'b0}});

        busy_:          assert (busy == under_way);
        done_:          assert (done == (age == SHIFTS + 1));
        once:           assert (balance == {4'd0, age >= 5'd1 && age <= SHIFTS + 1});
        sum:            assert (age <= SHIFTS || quotient == its_sum);
        out_of_table_:  assert (age <= SHIFTS || out_of_table == its_miss);
        out_of_table_0: assert (age <= SHIFTS || !its_miss || quotient == {W{1'b0}});
        cleared:        assert (age != 5'd0 || {out_of_table, quotient} == {(W + 1){1'b0}});
        frozen:         assert (!was_frozen || last == {busy, done, out_of_table, quotient});
    end

    // What happened to the division under way, or the last one.
    reg ignored, stalled, at_done, reset_busy;
    initial reset_busy = 1'b0;
    always @(posedge clk) begin
        if (reset) reset_busy <= busy && started;
        if (taken) begin
            ignored <= 1'b0;
            stalled <= 1'b0;
            at_done <= done;
        end else begin
            if (start && en && busy && k != 8'd0 && difference != its_difference) ignored <= 1'b1;
            if (!en && busy) stalled <= 1'b1;
        end
    end

    always @* if (started) begin
        c_busy:         cover (done && ignored && its_difference != 9'd0);
        c_done:         cover (done && stalled);
        c_once:         cover (age == 5'd2 && at_done && balance == 5'd1);
        c_sum_negative: cover (done && its_difference < -9'sd100 && its_bits[1:0] == 2'd3);
        c_sum_one:      cover (done && its_bits[SHIFTS] && quotient != {W{1'b0}});
        c_sum_held:     cover (age == SHIFTS + 2 && quotient[8] && en && !start);
        c_out_of_table: cover (done && out_of_table && its_difference != 9'd0);
        c_cleared:      cover (age == 5'd0 && reset_busy);
        c_frozen:       cover (was_frozen && busy && start && quotient != {W{1'b0}});
    end
endmodule

`default_nettype wire
