// saturating_mac: multiply and accumulate, with a sum that stops at its ends instead of wrapping.
//
// Function    sum = first ? a*b : clamp(sum + a*b), clamp to the range of S2W.0, W = WIDTH
// Formats     a, b SW.0;  product S2W.0;  sum S2W.0
// Rounding    none; a sum beyond an end is that end, and out_saturated says so
// Latency     2 clocks from the edge that takes a and b to the one after which the sum has them,
//             both counted. Throughput: a product every clock.
// Handshake   in_valid at an enabled edge takes a, b and first; out_valid marks a sum that is new.
//             There is no back pressure; en = 0 freezes everything instead.
// Reset       synchronous, active high, clears everything, regardless of en.
// Parameters  WIDTH 2..16
`default_nettype none

module saturating_mac #(
    parameter integer WIDTH = 8
) (
    input  wire                      clk,
    input  wire                      reset,
    input  wire                      en,
    input  wire                      in_valid,
    input  wire                      first,
    input  wire signed [WIDTH-1:0]   a,
    input  wire signed [WIDTH-1:0]   b,
    output reg                       out_valid,
    output reg                       out_saturated,
    output wire signed [2*WIDTH-1:0] out_sum
);
    // Stage 1: the product.
    reg                      s1_valid;
    reg                      s1_first;
    reg signed [2*WIDTH-1:0] product;

    always @(posedge clk)
        if (reset) begin
            s1_valid <= 1'b0;
            s1_first <= 1'b0;
            product  <= {2*WIDTH{1'b0}};
        end else if (en) begin
            s1_valid <= in_valid;
            if (in_valid) begin
                s1_first <= first;
                product  <= a * b;
            end
        end

    // Stage 2: the sum, with one bit more than it may have, and brought back.
    localparam signed [2*WIDTH-1:0] MOST  = {1'b0, {2*WIDTH-1{1'b1}}};
    localparam signed [2*WIDTH-1:0] LEAST = {1'b1, {2*WIDTH-1{1'b0}}};

    reg signed [2*WIDTH-1:0] acc;

    wire signed [2*WIDTH:0]   added   = {product[2*WIDTH-1], product}
                                      + (s1_first ? {2*WIDTH+1{1'b0}} : {acc[2*WIDTH-1], acc});
    wire                      beyond  = added[2*WIDTH] != added[2*WIDTH-1];
    wire signed [2*WIDTH-1:0] clamped = !beyond        ? added[2*WIDTH-1:0]
                                      : added[2*WIDTH] ? LEAST : MOST;

    always @(posedge clk)
        if (reset) begin
            out_valid     <= 1'b0;
            out_saturated <= 1'b0;
            acc           <= {2*WIDTH{1'b0}};
        end else if (en) begin
            out_valid <= s1_valid;
            if (s1_valid) begin
                out_saturated <= beyond;
                acc           <= clamped;
            end
        end

    assign out_sum = acc;
endmodule

`default_nettype wire
