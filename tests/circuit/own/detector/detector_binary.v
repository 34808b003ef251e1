// detector_binary: finds 1 0 1 1 in a stream of bits, its state a number.
//
// Function    found = 1 while the bit at the pin ends 1 0 1 1; found ones may share bits
// Formats     state U2.0: how many bits fit so far
// Rounding    none
// Latency     0: found is of the state and of the pin (a Mealy machine). A bit every clock.
// Handshake   none
// Reset       synchronous, active high
// Parameters  none
`default_nettype none

module detector_binary (
    input  wire       clk,
    input  wire       reset,
    input  wire       bit_in,
    output wire       found,
    output reg  [7:0] count
);
    reg [1:0] state;

    assign found = state == 2'd3 && bit_in;

    always @(posedge clk)
        if (reset) begin
            state <= 2'd0;
            count <= 8'd0;
        end else begin
            case (state)
                2'd0:    state <= bit_in ? 2'd1 : 2'd0;
                2'd1:    state <= bit_in ? 2'd1 : 2'd2;
                2'd2:    state <= bit_in ? 2'd3 : 2'd0;
                default: state <= bit_in ? 2'd1 : 2'd2;
            endcase
            count <= count + {7'd0, found};
        end
endmodule

`default_nettype wire
