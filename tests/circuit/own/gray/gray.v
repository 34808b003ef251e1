// gray: counts in Gray code, up or down, from 3 on; pins with the names of a packet's variables.
//
// Function    clk = 1: one up, else one down; wrapped: past an end
// Formats     code UWIDTH.0
// Rounding    none
// Latency     1 clock. Throughput: a step every clock.
// Handshake   ce_n = 1 freezes everything
// Reset       none: registers begin with their initial values
// Parameters  WIDTH 2..64
`default_nettype none

module gray #(
    parameter integer WIDTH = 5
) (
    input  wire             clock,
    input  wire             ce_n,
    input  wire             clk,
    input  wire             mismatch,
    output wire [WIDTH-1:0] code,
    output reg              wrapped
);
    reg [WIDTH-1:0] count;

    initial begin
        count   = 3;
        wrapped = 1'b0;
    end

    assign code = count ^ (count >> 1) ^ {WIDTH{mismatch}};

    always @(posedge clock)
        if (!ce_n) begin
            count   <= clk ? count + 1'b1 : count - 1'b1;
            wrapped <= clk ? &count : ~|count;
        end
endmodule

`default_nettype wire
