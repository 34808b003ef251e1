// rotate_xor: a 100-bit word that is rotated and mixed with the input. No enable.
//
// Function    state = rotl(state, 13) ^ word
// Formats     U100.0
// Rounding    none
// Latency     1 clock. Throughput: a word every clock.
// Handshake   in_valid takes the word; out_valid marks a state that is new.
// Reset       synchronous, active high.
// Parameters  none
`default_nettype none

module rotate_xor (
    input  wire        clk,
    input  wire        reset,
    input  wire        in_valid,
    input  wire [99:0] word,
    output reg         out_valid,
    output reg  [99:0] state,
    output wire        parity
);
    wire [99:0] turned = {state[86:0], state[99:87]};

    always @(posedge clk)
        if (reset) begin
            out_valid <= 1'b0;
            state     <= 100'd0;
        end else begin
            out_valid <= in_valid;
            if (in_valid) state <= turned ^ word;
        end

    assign parity = ^state;
endmodule

`default_nettype wire
