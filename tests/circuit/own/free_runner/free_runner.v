// free_runner: counts clocks from power-up on, and has no input at all but an amount.
//
// Function    count = sum of step over all clocks so far, modulo 2^33
// Formats     step S5.0;  count__33 U33.0
// Rounding    none
// Latency     1 clock
// Handshake   none
// Reset       none: registers begin with 0
// Parameters  none
`default_nettype none

module free_runner (
    input  wire              clk_i,
    input  wire signed [4:0] step,
    output reg  [32:0]       count__33
);
    initial count__33 = 33'd0;

    always @(posedge clk_i) count__33 <= count__33 + {{28{step[4]}}, step} + 33'd1;
endmodule

`default_nettype wire
