// staged_alu: the same operation once in each of several stages.
//
// Function    result = (((a op b) op b) ... op b), STAGES times, modulo 2^WIDTH
// Formats     a, b, result UWIDTH.0
// Rounding    none
// Latency     STAGES clocks. Throughput: one every clock.
// Handshake   in_valid at an enabled edge takes a and b; out_valid marks the result; en = 0
//             freezes.
// Reset       synchronous, active high, clears everything, regardless of en.
// Parameters  OP 0 add, 1 subtract, 2 exclusive or;  WIDTH 2..32;  STAGES 1..6
`default_nettype none

module staged_alu #(
    parameter integer OP     = 0,
    parameter integer WIDTH  = 8,
    parameter integer STAGES = 2
) (
    input  wire             clk,
    input  wire             reset,
    input  wire             en,
    input  wire             in_valid,
    input  wire [WIDTH-1:0] a,
    input  wire [WIDTH-1:0] b,
    output wire             out_valid,
    output wire [WIDTH-1:0] result
);
    // Element j is what stage j hands on.
    wire             valid   [0:STAGES];
    wire [WIDTH-1:0] value   [0:STAGES];
    wire [WIDTH-1:0] operand [0:STAGES];

    assign valid[0]   = in_valid;
    assign value[0]   = a;
    assign operand[0] = b;

    genvar j;
    generate
        for (j = 1; j <= STAGES; j = j + 1) begin : stage
            alu_stage #(.OP(OP), .WIDTH(WIDTH)) u (
                .clk(clk), .reset(reset), .en(en),
                .in_valid(valid[j-1]), .in_value(value[j-1]), .in_operand(operand[j-1]),
                .valid(valid[j]), .value(value[j]), .operand(operand[j]));
        end
    endgenerate

    assign out_valid = valid[STAGES];
    assign result    = value[STAGES];

    wire last_unused = &{1'b0, operand[STAGES]};
endmodule

`default_nettype wire
