// wide_sum: the sum of two wide signed numbers.
//
// Function    sum = a + b
// Formats     a, b SWIDTH.0;  sum S(WIDTH+1).0
// Rounding    none
// Latency     1 clock. Throughput: a sum every clock.
// Handshake   in_valid at an enabled edge takes a and b; out_valid marks the sum; en = 0 freezes.
// Reset       synchronous, active high, clears everything, regardless of en.
// Parameters  WIDTH 33..511
`default_nettype none

module wide_sum #(
    parameter integer WIDTH = 256
) (
    input  wire                    clk,
    input  wire                    reset,
    input  wire                    en,
    input  wire                    in_valid,
    input  wire signed [WIDTH-1:0] a,
    input  wire signed [WIDTH-1:0] b,
    output reg                     out_valid,
    output reg  signed [WIDTH:0]   sum
);
    always @(posedge clk)
        if (reset) begin
            out_valid <= 1'b0;
            sum       <= {WIDTH+1{1'b0}};
        end else if (en) begin
            out_valid <= in_valid;
            if (in_valid) sum <= a + b;
        end
endmodule

`default_nettype wire
