// stage_register: one pipeline register, or a wire in its place.
//
// Function    q takes d at a rising edge of clk where en = 1; q = d with PRESENT = 0.
// Latency     PRESENT clocks. Throughput: one value a clock.
// Reset       synchronous, active high, q = 0, whatever en says.
// Figure 3.1  none: the figure has no registers between its blocks. With PRESENT = 0 the device is
//             exactly as drawn.
`default_nettype none

module stage_register #(
    parameter WIDTH   = 1,
    parameter PRESENT = 1
) (
    input  wire             clk,
    input  wire             reset,
    input  wire             en,
    input  wire [WIDTH-1:0] d,
    output wire [WIDTH-1:0] q
);
    generate
        if (PRESENT != 0) begin : g_register
            reg [WIDTH-1:0] held;
            always @(posedge clk)
                if (reset)   held <= {WIDTH{1'b0}};
                else if (en) held <= d;
            assign q = held;
        end else begin : g_wire
            wire unused = &{1'b0, clk, reset, en};
            assign q = d;
        end
    endgenerate
endmodule

`default_nettype wire
