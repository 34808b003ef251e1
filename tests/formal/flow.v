// flow: the properties of any pipeline that is moved only by the clock enable.
//
// A slot is an enabled clock, with an input or without. A history of the slots, one place on at
// every enabled clock and emptied by reset, says what the pipeline must hold: the slot in its last
// place is the one whose turn it is to be at the output. That the history is right is not taken for
// granted: it is shown by following one slot that the prover chooses freely, and by counting.
//
// in_data is what the first stage must hold after the edge. Place j of the history (1 the youngest,
// LATENCY the one at the output) is valid[j-1] and history[(j-1)*WIDTH +: WIDTH].
//
// Properties
//   uninvited  out_valid is 0 until LATENCY enabled clocks after a reset, and at the turn of a slot
//              that had no input.
//   in_order   a slot is at the output after exactly LATENCY enabled clocks, its own included: with
//              its valid bit and its data, neither earlier nor later ones.
//   once       inputs taken less outputs given, since the reset: never more than are on their way,
//              and none once LATENCY enabled clocks without input have passed.
//   frozen     a clock without enable and reset changes no output.
`default_nettype none

module flow #(
    parameter integer LATENCY = 4,
    parameter integer WIDTH   = 1,
    parameter integer OUT     = 1
) (
    input  wire                     clk,
    input  wire                     reset,
    input  wire                     en,
    input  wire                     started, // there was a reset
    input  wire                     in_valid,
    input  wire [WIDTH-1:0]         in_data,
    input  wire                     out_valid,
    input  wire [OUT-1:0]           out,
    output reg  [LATENCY-1:0]       valid,
    output reg  [LATENCY*WIDTH-1:0] history
);
    wire [LATENCY:0]             next_valid   = {valid, in_valid};
    wire [(LATENCY+1)*WIDTH-1:0] next_history = {history, in_data};
    always @(posedge clk)
        if (reset) begin
            valid   <= {LATENCY{1'b0}};
            history <= {(LATENCY * WIDTH){1'b0}};
        end else if (en) begin
            valid   <= next_valid[LATENCY-1:0];
            history <= next_history[LATENCY*WIDTH-1:0];
        end

    // Enabled clocks since the reset, and since the last with an input; LATENCY stands for more,
    // too.
    reg [4:0] since_reset, since_input;
    always @(posedge clk)
        if (reset) begin
            since_reset <= 5'd0;
            since_input <= LATENCY;
        end else if (en) begin
            if (since_reset != LATENCY) since_reset <= since_reset + 5'd1;
            if (in_valid)                    since_input <= 5'd0;
            else if (since_input != LATENCY) since_input <= since_input + 5'd1;
        end

    // The slot followed: one at a time, from any enabled clock on.
    (* anyseq *) reg follow;
    reg  [4:0]       age;       // enabled clocks since, its own included; 0: none followed
    reg              its_valid;
    reg  [WIDTH-1:0] its_data;
    reg              stalled;   // on its way there was a clock without enable
    always @(posedge clk)
        if (reset)
            age <= 5'd0;
        else if (en && (age == 5'd0 || age == LATENCY)) begin
            age       <= follow ? 5'd1 : 5'd0;
            its_valid <= in_valid;
            its_data  <= in_data;
            stalled   <= 1'b0;
        end else if (en)
            age <= age + 5'd1;
        else if (LATENCY == 1 || age != LATENCY)
            stalled <= 1'b1;

    // Inputs taken less outputs given.
    reg [4:0] in_flight;
    always @(posedge clk)
        if (reset)   in_flight <= 5'd0;
        else if (en) in_flight <= in_flight + {4'd0, in_valid} - {4'd0, out_valid};

    reg                 was_frozen;
    reg                 last_valid;
    reg [OUT-1:0]       last_out;
    always @(posedge clk) begin
        was_frozen <= started && !en && !reset;
        last_valid <= out_valid;
        last_out   <= out;
    end

    // Helpers: what the counters have to do with the history.
    integer   j;
    reg [4:0] count;
    reg       placed, cleared;
    always @* begin
        count   = 5'd0;
        // Places not reached since the reset are empty, and so are those since the input.
        cleared = 1'b1;
        placed  = age == 5'd0;
        for (j = 1; j <= LATENCY; j = j + 1) begin
            count = count + {4'd0, valid[j-1]};
            if (valid[j-1] && (j > since_reset || j <= since_input)) cleared = 1'b0;
            if (age == j && valid[j-1] == its_valid && history[(j-1)*WIDTH +: WIDTH] == its_data)
                placed = 1'b1;
        end
    end

    always @* if (started) begin
        h_out_valid: assert (out_valid == valid[LATENCY-1]);
        h_cleared:   assert (cleared && since_reset <= LATENCY && since_input <= LATENCY);
        h_placed:    assert (placed && age <= LATENCY);
        h_count:     assert (in_flight == count);

        uninvited_reset: assert (!(out_valid && since_reset < LATENCY));
        uninvited_slot:  assert (!(out_valid && age == LATENCY && !its_valid));
        in_order_valid:  assert (!(age == LATENCY && its_valid && !out_valid));
        in_order_data:   assert (!(age == LATENCY
                                   && history[(LATENCY-1)*WIDTH +: WIDTH] != its_data));
        once_at_most:    assert (in_flight <= LATENCY);
        once_at_least:   assert (!(since_input == LATENCY && in_flight != 5'd0));
        frozen_out:      assert (!(was_frozen && {last_valid, last_out} != {out_valid, out}));
    end

    // Situations that must be reached, so that nothing above holds for want of an occasion.
    reg reset_in_flight, was_full;
    initial {reset_in_flight, was_full} = 2'b00;
    always @(posedge clk) begin
        if (reset) reset_in_flight <= started && in_flight != 5'd0;
        if (reset)                                  was_full <= 1'b0;
        else if (in_flight == LATENCY && out_valid) was_full <= 1'b1;
    end

    always @* if (started) begin
        c_uninvited: cover (reset_in_flight && since_reset == LATENCY && in_flight == 5'd1);
        c_in_order:  cover (age == LATENCY && its_valid && out_valid && stalled
                            && (LATENCY == 1 || history[WIDTH-1:0] != its_data));
        c_once:      cover (was_full && in_flight == 5'd0);
        c_frozen:    cover (was_frozen && out_valid && in_valid && out != {OUT{1'b0}});
    end
endmodule

`default_nettype wire
