// alu_stage: one operation and its registers; see staged_alu.
`default_nettype none

module alu_stage #(
    parameter integer OP    = 0,
    parameter integer WIDTH = 8
) (
    input  wire             clk,
    input  wire             reset,
    input  wire             en,
    input  wire             in_valid,
    input  wire [WIDTH-1:0] in_value,
    input  wire [WIDTH-1:0] in_operand,
    output reg              valid,
    output reg  [WIDTH-1:0] value,
    output reg  [WIDTH-1:0] operand
);
    wire [WIDTH-1:0] done = OP == 0 ? in_value + in_operand
                          : OP == 1 ? in_value - in_operand
                          :           in_value ^ in_operand;

    always @(posedge clk)
        if (reset) begin
            valid   <= 1'b0;
            value   <= {WIDTH{1'b0}};
            operand <= {WIDTH{1'b0}};
        end else if (en) begin
            valid   <= in_valid;
            value   <= done;
            operand <= in_operand;
        end
endmodule

`default_nettype wire
