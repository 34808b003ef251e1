// clip_lane: one lane of clip_lanes.
`default_nettype none

module clip_lane (
    input  wire               clk,
    input  wire               reset,
    input  wire               en,
    input  wire               in_valid,
    input  wire signed [11:0] x,
    output reg  signed [7:0]  y
);
    reg signed [11:0] held;

    wire signed [7:0] clipped = held > 12'sd127  ? 8'sd127
                              : held < -12'sd128 ? -8'sd128 : held[7:0];

    always @(posedge clk)
        if (reset) begin
            held <= 12'sd0;
            y    <= 8'sd0;
        end else if (en) begin
            if (in_valid) held <= x;
            y <= clipped;
        end
endmodule

`default_nettype wire
