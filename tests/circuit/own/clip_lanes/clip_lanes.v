// clip_lanes: numbers brought into a smaller range, several a clock.
//
// Function    y = clamp(x) to the range of S8.0
// Formats     x S12.0;  y S8.0;  lane i in bits [i*width +: width]
// Rounding    none; a number beyond an end is that end
// Latency     2 clocks. Throughput: LANES numbers a clock.
// Handshake   in_valid[i] at an enabled edge: lane i takes its number; out_valid[i] marks its
//             result.
// Reset       synchronous, active high, clears everything, regardless of en.
// Parameters  LANES 1..32
`default_nettype none

module clip_lanes #(
    parameter integer LANES = 1
) (
    input  wire                clk,
    input  wire                reset,
    input  wire                en,
    input  wire [LANES-1:0]    in_valid,
    input  wire [LANES*12-1:0] x,
    output reg  [LANES-1:0]    out_valid,
    output wire [LANES*8-1:0]  y
);
    reg [LANES-1:0] s1_valid;

    always @(posedge clk)
        if (reset) begin
            s1_valid  <= {LANES{1'b0}};
            out_valid <= {LANES{1'b0}};
        end else if (en) begin
            s1_valid  <= in_valid;
            out_valid <= s1_valid;
        end

    genvar i;
    generate
        for (i = 0; i < LANES; i = i + 1) begin : lane
            clip_lane u (
                .clk(clk), .reset(reset), .en(en), .in_valid(in_valid[i]),
                .x(x[i*12 +: 12]), .y(y[i*8 +: 8]));
        end
    endgenerate
endmodule

`default_nettype wire
