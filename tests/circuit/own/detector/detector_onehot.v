// detector_onehot: what detector_binary does, with a register for each state.
//
// Function, latency, handshake, reset: as detector_binary
// Formats     state: bit i is 1 when i bits fit so far; after reset all are 0, which is as bit 0
// Rounding    none
// Parameters  none
`default_nettype none

module detector_onehot (
    input  wire       clk,
    input  wire       reset,
    input  wire       bit_in,
    output wire       found,
    output reg  [7:0] count
);
    reg [3:0] state;

    assign found = state[3] && bit_in;

    always @(posedge clk)
        if (reset) begin
            state <= 4'd0;
            count <= 8'd0;
        end else begin
            state[0] <= !bit_in && (state[2] || state[0] || state == 4'd0);
            state[1] <= bit_in && !state[2];
            state[2] <= !bit_in && (state[1] || state[3]);
            state[3] <= bit_in && state[2];
            count    <= count + {7'd0, found};
        end
endmodule

`default_nettype wire
