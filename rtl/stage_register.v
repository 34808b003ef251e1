// stage_register: the register at the front of a pipeline stage.
//
// Function    q = d of the last enabled clock; CLOCKED = 0: q = d, a wire, for forms without stages
// Latency     1 clock; CLOCKED = 0: none
// Reset       synchronous, active high; clears q, regardless of en.
// Handshake   none: en = 0 holds q.
// Parameters  WIDTH    bits of d and q
//             CLOCKED  1 (default) or 0
`default_nettype none

module stage_register #(
    parameter integer WIDTH   = 1,
    parameter integer CLOCKED = 1
) (
    input  wire             clk,
    input  wire             reset,
    input  wire             en,
    input  wire [WIDTH-1:0] d,
    output reg  [WIDTH-1:0] q
);
    generate
        if (CLOCKED != 0) begin : g_clocked
            always @(posedge clk)
                if (reset)   q <= {WIDTH{1'b0}};
                else if (en) q <= d;
        end else begin : g_wire
            always @* q = d;
            wire clocked_unused = &{1'b0, clk, reset, en};
        end
    endgenerate
endmodule

`default_nettype wire
