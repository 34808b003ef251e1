// The specular device without a fault and with it, side by side (the module "both"), for prove.sh.

// A steady flow, a point and a material each clock; every register is a wire here (wires.v).
module one_point (
    input  wire [52:0] point, // n; r, g, b; the cosine's code, from bit 0 on
    output wire        seen
);
    both pair (
        .in_clk(1'b0), .in_reset(1'b0), .in_en(1'b1), .in_n_we(1'b1), .in_rgb_we(1'b1),
        .in_in_valid(1'b1), .in_n(point[9:0]), .in_r(point[17:10]), .in_g(point[25:18]),
        .in_b(point[33:26]), .in_cos(point[52:34]), .trigger(seen));
endmodule

// A reset, with or without an enable, and then nothing: whatever it leaves in the pipeline comes
// out.
module after_reset (
    input  wire clk,
    input  wire en,
    output wire seen
);
    reg  started = 1'b0;
    wire differs;

    always @(posedge clk) started <= 1'b1;

    both pair (
        .in_clk(clk), .in_reset(!started), .in_en(started || en), .in_n_we(1'b0), .in_rgb_we(1'b0),
        .in_in_valid(1'b0), .in_n(10'd0), .in_r(8'd0), .in_g(8'd0), .in_b(8'd0), .in_cos(19'd0),
        .trigger(differs));

    assign seen = differs & started;
endmodule
