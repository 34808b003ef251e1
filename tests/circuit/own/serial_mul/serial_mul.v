// serial_mul: a product bit by bit.
//
// Function    product = a * b
// Formats     a, b UWIDTH.0;  product U(2*WIDTH).0
// Rounding    none
// Latency     WIDTH + 1 clocks from the edge that takes a and b to the one after which done is 1,
//             both counted; during which it takes nothing
// Handshake   start at an enabled edge while busy is 0 takes a and b; while it is 1, start is
//             ignored. done is 1 for one clock. en = 0 freezes everything but the reset.
// Reset       asynchronous, active high
// Parameters  WIDTH 2..16
`default_nettype none

module serial_mul #(
    parameter integer WIDTH = 6
) (
    input  wire               clk,
    input  wire               arst,
    input  wire               en,
    input  wire               start,
    input  wire [WIDTH-1:0]   a,
    input  wire [WIDTH-1:0]   b,
    output reg                busy,
    output reg                done,
    output wire [2*WIDTH-1:0] product
);
    reg [2*WIDTH-1:0] acc;
    reg [2*WIDTH-1:0] addend;
    reg [WIDTH-1:0]   bits;
    reg [4:0]         left;

    wire [2*WIDTH-1:0] sum = bits[0] ? acc + addend : acc;

    always @(posedge clk or posedge arst)
        if (arst) begin
            busy   <= 1'b0;
            done   <= 1'b0;
            acc    <= {2*WIDTH{1'b0}};
            addend <= {2*WIDTH{1'b0}};
            bits   <= {WIDTH{1'b0}};
            left   <= 5'd0;
        end else if (en) begin
            done <= busy && left == 5'd1;
            if (busy) begin
                acc    <= sum;
                addend <= addend << 1;
                bits   <= bits >> 1;
                left   <= left - 5'd1;
                busy   <= left != 5'd1;
            end else if (start) begin
                acc    <= {2*WIDTH{1'b0}};
                addend <= {{WIDTH{1'b0}}, a};
                bits   <= b;
                left   <= WIDTH[4:0];
                busy   <= 1'b1;
            end
        end

    assign product = acc;
endmodule

`default_nettype wire
